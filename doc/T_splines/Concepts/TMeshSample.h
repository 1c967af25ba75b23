// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `TMeshSample` describes a sample, an element of the ranges to which `CGAL::T_splines::fit_T_spline()` fits
surfaces.

Values are checked in every build, and the number of the first sample that is refused is reported: coordinates and
weight are finite, the weight is not negative, and the place is in the closed rectangle of its face, up to round-off.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::T_mesh_sample<Graph, Kernel>}
\cgalHasModelsEnd

\sa `CGAL::T_splines::sample_T_mesh()`
\sa `CGAL::T_splines::Carried_samples`
*/
class TMeshSample {
public:
  /// \name Members
  /// @{

  /*!
  has the members `face`, a face of the T-mesh, and `u` and `v`, numbers in the frame of the face: a
  `CGAL::T_splines::T_mesh_place<Graph, FT>`. `fit_T_spline()` changes it, and so does `Carried_samples` when the T-mesh
  changes.
  */
  T_mesh_place place;

  /*!
  a point of a CGAL kernel, which `CGAL::Kernel_traits` tells, whose `FT` is a floating-point type: the fit is computed in
  it.
  */
  Point_3 point;

  /*!
  the weight of its squared distance: the area that it stands for. The areas of faces, and so the thin-plate energy, are
  taken from the weights; any other meaning changes the meaning of `fairness`, too.
  */
  FT weight;

  /// @}
};
