// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `TracingTraits` describes the predicates by which `CGAL::T_splines::trace_motorcycle_graph()` decides which way
an isoline takes and where two of them meet. Nothing else is asked: with exact predicates and an exact map, the graph is
right in every special position.

Coordinates are given as enclosures: a number has an interval `[lower, upper]` of doubles and, unless both are equal and the
number is this double, a pointer `exact` to its value; `value()` is the number in the type `FT`.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Exact_tracing_traits<FT>}
\cgalHasModels{CGAL::T_splines::Inexact_tracing_traits}
\cgalHasModelsEnd
*/
class TracingTraits {
public:
  /// The number type of the map.
  typedef unspecified_type FT;

  /// A coordinate in a chart, with `lower`, `upper`, `exact` and `value()`.
  typedef unspecified_type Coordinate;

  /// A point in a chart: two coordinates, `u` and `v`.
  typedef unspecified_type Point;

  /// compares two coordinates of one chart.
  CGAL::Comparison_result compare(const Coordinate& a, const Coordinate& b) const;

  /// returns on which side of the line from `p` to `q`, two points of one chart, the point `r` lies.
  CGAL::Orientation orientation(const Point& p, const Point& q, const Point& r) const;

  /// returns how often both were asked, and how often a filter did not suffice.
  CGAL::T_splines::Predicate_statistics statistics() const;
};
