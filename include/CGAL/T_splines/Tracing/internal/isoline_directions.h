// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_ISOLINE_DIRECTIONS_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_ISOLINE_DIRECTIONS_H

#include <CGAL/enum.h>

namespace CGAL {
namespace T_splines {
namespace internal {

// A direction of an isoline in a chart is a number of quarter turns: 0 is +u, 1 is +v, 2 is -u, 3 is -v. The line runs
// along one axis (0 for u, 1 for v) and has a constant coordinate on the other.

inline int turned(const int direction, const int quarter_turns)
{
  return (direction + quarter_turns) & 3;
}

/// The axis along which a line of this direction runs.
inline int axis_along(const int direction)
{
  return direction & 1;
}

/// The axis on which a line of this direction has a constant coordinate.
inline int axis_across(const int direction)
{
  return 1 - (direction & 1);
}

/// Whether the coordinate along the line grows.
inline bool is_forward(const int direction)
{
  return direction < 2;
}

/// On which side of a line a point lies, from the comparison of the point's coordinate across with the line's: positive
/// to the left.
inline CGAL::Sign side_of_line(const int direction, const CGAL::Comparison_result point_to_line)
{
  return direction == 0 || direction == 3 ? point_to_line : -point_to_line;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_ISOLINE_DIRECTIONS_H
