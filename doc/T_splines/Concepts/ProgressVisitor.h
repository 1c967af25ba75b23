// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `ProgressVisitor` describes what long computations tell the caller, and how the caller ends them early. A
model is passed by the named parameter `visitor`.

Visitors are passed by value and copied freely: one with state keeps a pointer or a reference to it. All functions
are called on `const` objects, from the thread that called the algorithm, and should return quickly. They should not throw.

A class derived from `CGAL::T_splines::Progress_visitor` may define only the functions that it cares for: they are
not virtual, the algorithm calls those of the type that it was given.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Progress_visitor}
\cgalHasModelsEnd
*/
class ProgressVisitor {
public:
  /// \name Operations
  /// @{

  /*!
  is called when a stage begins.
  \param name a string literal: "cross field"; "cone reduction"; "similarity metric", "layout", "subdivision", "output";
         "tracing", "T-mesh".
  */
  void begin_stage(const char* name) const;

  /*!
  is called from time to time within a stage.
  \param fraction in [0, 1]; it does not decrease within a stage. It may be 1 before the stage ends, and a stage may end
         before it is 1.
  */
  void progress(double fraction) const;

  /*!
  is asked from time to time while a cross field, a metric, a motorcycle graph or a fit is computed.
  \return `false` to end the computation with the status `INTERRUPTED`. Nothing is written then.
  */
  bool go_on() const;

  /// @}
};
