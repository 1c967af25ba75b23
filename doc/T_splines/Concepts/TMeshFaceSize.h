// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `TMeshFaceSize` describes how `CGAL::T_splines::refine_T_mesh()` measures the faces of a T-mesh.

The refinement ends only if the size of a face tends to zero together with its extent in the parameter domain.

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Parametric_face_size}
\cgalHasModels{CGAL::T_splines::Surface_face_size}
\cgalHasModelsEnd
*/
class TMeshFaceSize {
public:
  /// \name Operations
  /// @{

  /*!
  returns the lengths of the face `f` along the u axis and along the v axis of its frame, in any unit, finite and not
  negative.
  */
  std::pair<double, double> operator()(face_descriptor f) const;

  /// @}
};
