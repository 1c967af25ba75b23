// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `AdaptiveFitVisitor` describes what an adaptive fit tells the caller: the levels as they come, from coarse to
fine. A model is passed to `CGAL::T_splines::fit_adaptive_T_spline()` by the named parameter `visitor`.

The functions of `ProgressVisitor` are called once per level and round: `progress()` with the share of the rounds in
which the points that are aimed at are moved, of the present level; `go_on()` before each round and before each refinement. `begin_stage()` is not
called.

A class derived from `CGAL::T_splines::Adaptive_fit_visitor` may define only the functions that it cares for.

\cgalRefines{ProgressVisitor}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Adaptive_fit_visitor}
\cgalHasModelsEnd
*/
class AdaptiveFitVisitor {
public:
  /// \name Operations
  /// @{

  /*!
  is called when a level is fitted.
  \tparam TMesh a model of `TMesh`, of the algorithm's own
  \param level numbers and errors
  \param t_mesh its spline compatible T-mesh, whose points are the control points, as
         `CGAL::T_splines::write_t_mesh()` and `CGAL::T_splines::T_spline_surface` take it; knots are floating-point
         numbers, the weights are 1

  It does not last: copy or write what is to be kept.
  */
  template <typename TMesh>
  void level_fitted(const CGAL::T_splines::T_spline_fit_level& level, const TMesh& t_mesh) const;

  /// @}
};
