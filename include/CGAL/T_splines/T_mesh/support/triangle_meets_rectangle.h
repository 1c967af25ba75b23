// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_TRIANGLE_MEETS_RECTANGLE_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_TRIANGLE_MEETS_RECTANGLE_H

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether a triangle meets the rectangle [0, size[0]] x [0, size[1]], by separating axes: those of the rectangle and
/// the normals of the sides. Where they only touch up to round-off, the answer may be either.
/// \param corners counter-clockwise
inline bool triangle_meets_rectangle(const std::array<std::array<double, 2>, 3>& corners,
                                     const std::array<double, 2>& size)
{
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    if (high <= 0 || low >= size[axis])
      return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 2>&p = corners[i], &q = corners[(i + 1) % 3];
    // The corner of the rectangle that lies farthest to the left of the side.
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    const double x = dy < 0 ? size[0] : 0, y = dx > 0 ? size[1] : 0;
    if (dx * (y - p[1]) - dy * (x - p[0]) <= 0)
      return false;
  }
  return true;
}

/// Whether a triangle covers a part of the rectangle [0, size[0]] x [0, size[1]] by more than round-off, a fraction of its
/// size; and not only touches it from outside.
inline bool triangle_covers_part_of_rectangle(std::array<std::array<double, 2>, 3> corners,
                                              const std::array<double, 2>& size, const double round_off)
{
  for (std::array<double, 2>& corner : corners)
    for (std::size_t axis = 0; axis < 2; ++axis)
      corner[axis] -= round_off * size[axis];
  return triangle_meets_rectangle(corners, {size[0] * (1 - 2 * round_off), size[1] * (1 - 2 * round_off)});
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_TRIANGLE_MEETS_RECTANGLE_H
