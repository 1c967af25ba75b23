// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_PROGRESS_VISITOR_H
#define CGAL_T_SPLINES_PROGRESS_VISITOR_H

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesMisc
/// The visitor that does nothing, and the list of what a progress visitor offers.
///
/// The functions of this package take a visitor by the named parameter `visitor` and copy it freely: one with state
/// keeps a pointer or reference to it.
///
/// \cgalModels{ProgressVisitor}
struct Progress_visitor {
  /// is called when a stage begins; `name` is a string literal such as "cross field": see `ProgressVisitor` for all.
  void begin_stage(const char* /*name*/) const {}

  /// is called from time to time within a stage; `fraction`, in [0, 1], never decreases.
  void progress(double /*fraction*/) const {}

  /// is asked several times a second: `false` ends the computation with the status `INTERRUPTED`.
  bool go_on() const { return true; }
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_PROGRESS_VISITOR_H
