// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_TRACING_TRAITS_H
#define CGAL_T_SPLINES_TRACING_TRACING_TRAITS_H

#include <CGAL/T_splines/internal/Enclosed_number.h>

#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTracing
/// How often the predicates of the tracer were asked.
struct Predicate_statistics {
  std::size_t calls = 0;       ///< all questions
  std::size_t exact_calls = 0; ///< those that the floating point filter left open
};

namespace internal {

/// A point in the chart of a face.
template <typename FT>
struct Enclosed_point {
  Enclosed_number<FT> u, v;
};

} // namespace internal

/// \ingroup PkgTSplinesTracing
/// The predicates of the tracer of motorcycle graphs, exact: a floating point filter answers nearly all questions, the
/// number type `FT` the others.
///
/// A model of the concept `TracingTraits`: `Compare` and `Orientation` are the only questions that the tracer asks, the
/// first of two coordinates of one chart, the second of three points of one chart.
///
/// \cgalModels{TracingTraits}
///
/// \tparam FT_ an exact field type, the `FT` of the map
template <typename FT_>
class Exact_tracing_traits {
public:
  using FT = FT_;                                   ///< number type of the map
  using Coordinate = internal::Enclosed_number<FT>; ///< an enclosure of a coordinate
  using Point = internal::Enclosed_point<FT>;       ///< an enclosure of a point

  /// compares two coordinates.
  CGAL::Comparison_result compare(const Coordinate& a, const Coordinate& b) const
  {
    ++m_statistics.calls;
    if (const auto order = internal::filtered_comparison(a, b))
      return *order;
    ++m_statistics.exact_calls;
    return CGAL::compare(a.value(), b.value());
  }

  /// returns on which side of the line from `p` to `q` the point `r` lies.
  CGAL::Orientation orientation(const Point& p, const Point& q, const Point& r) const
  {
    ++m_statistics.calls;
    const Estimate a = difference(q.u, p.u), b = difference(q.v, p.v), c = difference(r.u, p.u),
                   d = difference(r.v, p.v);
    const Estimate ad = product(a, d), bc = product(b, c);
    const double determinant = ad.value - bc.value;
    const double error = (ad.error + bc.error) * (1 + 8 * unit) + unit * std::abs(determinant);
    if (determinant > error)
      return CGAL::POSITIVE;
    if (determinant < -error)
      return CGAL::NEGATIVE;
    ++m_statistics.exact_calls;
    const FT pu = p.u.value(), pv = p.v.value();
    return CGAL::sign((q.u.value() - pu) * (r.v.value() - pv) - (q.v.value() - pv) * (r.u.value() - pu));
  }

  /// returns how often the predicates were asked so far.
  const Predicate_statistics& statistics() const { return m_statistics; }

private:
  static constexpr double unit = std::numeric_limits<double>::epsilon(); // twice the unit round-off: for any rounding

  /// A double, and a bound of its distance from the true value.
  struct Estimate {
    double value, error;
  };

  static Estimate difference(const Coordinate& a, const Coordinate& b)
  {
    const double value = a.lower - b.lower;
    return {value, (a.upper - a.lower + (b.upper - b.lower)) * (1 + 8 * unit) + unit * std::abs(value)};
  }

  static Estimate product(const Estimate& a, const Estimate& b)
  {
    const double value = a.value * b.value;
    const double error = std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    // The last summand stands for underflow.
    return {value, error * (1 + 8 * unit) + unit * std::abs(value) + 16 * std::numeric_limits<double>::min()};
  }

  mutable Predicate_statistics m_statistics;
};

/// \ingroup PkgTSplinesTracing
/// The predicates of the tracer in plain doubles: for the study of what goes wrong without exactness.
///
/// The same code then traces a graph that need not be a T-mesh.
///
/// \cgalModels{TracingTraits}
class Inexact_tracing_traits {
public:
  using FT = double;                                    ///< number type of the map
  using Coordinate = internal::Enclosed_number<double>; ///< an enclosure of a coordinate
  using Point = internal::Enclosed_point<double>;       ///< an enclosure of a point

  /// compares two coordinates.
  CGAL::Comparison_result compare(const Coordinate& a, const Coordinate& b) const
  {
    ++m_statistics.calls;
    return CGAL::compare(a.lower, b.lower);
  }

  /// returns on which side of the line from `p` to `q` the point `r` lies, by the computed determinant.
  CGAL::Orientation orientation(const Point& p, const Point& q, const Point& r) const
  {
    ++m_statistics.calls;
    return CGAL::sign((q.u.lower - p.u.lower) * (r.v.lower - p.v.lower) -
                      (q.v.lower - p.v.lower) * (r.u.lower - p.u.lower));
  }

  /// returns how often the predicates were asked so far.
  const Predicate_statistics& statistics() const { return m_statistics; }

private:
  mutable Predicate_statistics m_statistics;
};

/// \ingroup PkgTSplinesTracing
/// The tracing traits for a map whose transitions have the number type `FT`.
template <typename FT>
using Default_tracing_traits =
    std::conditional_t<std::is_floating_point<FT>::value, Inexact_tracing_traits, Exact_tracing_traits<FT>>;

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_TRACING_TRAITS_H
