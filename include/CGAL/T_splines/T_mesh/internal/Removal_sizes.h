// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_REMOVAL_SIZES_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_REMOVAL_SIZES_H

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// At least 1.
inline double aspect_ratio(const double a, const double b)
{
  return a > b ? a / b : b / a;
}

/// Two faces of a T-mesh on both sides of a line, where a part of it is to be removed from their overlap; a unit of length
/// is one of the first face. Predicts aspect ratios.
struct Removal_sizes {
  /// An aspect ratio: longer faces are thin.
  static constexpr double thin = 32;

  /// What is left of a face is short if the overlap is more than so many times as long.
  static constexpr double times_as_long = 16;

  double length;                      ///< of the overlap
  std::array<double, 2> depth;        ///< of the two faces, across
  std::array<double, 2> before;       ///< how far the two faces reach beyond the overlap's beginning
  std::array<double, 2> after;        ///< and its end
  bool first_is_fixed, last_is_fixed; ///< the vertices at the overlap's ends
  /// Whether the other side of a face along the line may be removed, from the overlap's beginning and from its end on.
  std::array<bool, 2> opens_at_first, opens_at_last;
  double first_stub,
      last_stub; ///< how far the line goes on to a fixed vertex behind an orthogonal line; 0: it does not

  /// The worse aspect ratio of the two faces.
  double old_aspect() const
  {
    double result = 1;
    for (int i = 0; i < 2; ++i)
      result = (std::max)(result, aspect_ratio(before[i] + length + after[i], depth[i]));
    return result;
  }

  /// The worst aspect ratio after the removal of the part from x to y.
  double new_aspect(const double x, const double y) const
  {
    double result = aspect_ratio(y - x, depth[0] + depth[1]);
    for (int i = 0; i < 2; ++i) {
      for (const double rest : {before[i] + x, after[i] + length - y}) {
        if (rest > 0)
          result = (std::max)(result, aspect_ratio(rest, depth[i]));
      }
    }
    return result;
  }

  /// The same, but for what is left of a thin face where this can be removed from its other side afterwards. Infinity
  /// if what is left is short, too: a face much smaller than those beside it.
  double expected_aspect(const double x, const double y) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if ((x == 0 && is_short(first_stub)) || (y == length && is_short(last_stub)))
      return infinity;
    double result = aspect_ratio(y - x, depth[0] + depth[1]);
    for (int i = 0; i < 2; ++i) {
      const double first = before[i] + x, last = after[i] + length - y;
      if (is_short(first) || is_short(last))
        return infinity;
      const bool is_thin = before[i] + length + after[i] >= thin * depth[i];
      if (first > 0 && !(is_thin && opens_at_first[i]))
        result = (std::max)(result, aspect_ratio(first, depth[i]));
      if (last > 0 && !(is_thin && opens_at_last[i]))
        result = (std::max)(result, aspect_ratio(last, depth[i]));
    }
    return result;
  }

  /// Each orthogonal edge adds a face, the removal takes one.
  int added_faces(const double x, const double y) const
  {
    int result = -1;
    for (int i = 0; i < 2; ++i)
      result += (before[i] + x > 0) + (after[i] + y > 0);
    return result;
  }

private:
  bool is_short(const double rest) const { return rest > 0 && times_as_long * rest < length; }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_REMOVAL_SIZES_H
