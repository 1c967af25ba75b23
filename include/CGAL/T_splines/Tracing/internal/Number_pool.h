// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_NUMBER_POOL_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_NUMBER_POOL_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_basic.h>

#include <deque>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Keeps the exact values of enclosed numbers. They stay where they are.
template <typename FT>
class Number_pool {
public:
  using Number = Enclosed_number<FT>;

  /// Stores a number, unless it is a double.
  Number store(FT value)
  {
    const std::pair<double, double> interval = CGAL::to_interval(value);
    if (interval.first == interval.second)
      return {interval.first, interval.second, nullptr};
    m_values.push_back(std::move(value));
    return {interval.first, interval.second, &m_values.back()};
  }

private:
  std::deque<FT> m_values;
};

/// The constant coordinate of a line after a transition.
template <typename FT>
FT transformed_line(const Similarity_2<FT>& transition, const int direction, const FT& line)
{
  const int axis = turned(axis_across(direction), transition.quarter_turns());
  FT result = transition.scale() == FT(1) ? line : FT(transition.scale() * line);
  if (axis >= 2)
    result = -result;
  result += (axis & 1) == 0 ? transition.u() : transition.v();
  return result;
}

/// The coordinate along a line of one of its points after a transition.
template <typename FT>
FT transformed_coordinate(const Similarity_2<FT>& transition, const int direction, const FT& along)
{
  return transformed_line(transition, turned(direction, 1), along);
}

/// A line as the other side of the edge of h sees it: its constant coordinate, and its direction.
template <typename FT>
std::pair<Enclosed_number<FT>, int> line_across_edge(const Seamless_layout<FT>& layout, Number_pool<FT>& numbers,
                                                     const int h, const Enclosed_number<FT>& line, const int direction)
{
  if (!layout.is_cut(edge_of(h)))
    return {line, direction};
  const Similarity_2<FT>& transition = layout.transition(h);
  return {numbers.store(transformed_line(transition, direction, line.value())),
          turned(direction, transition.quarter_turns())};
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_NUMBER_POOL_H
