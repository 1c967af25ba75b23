// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CLOSEST_OF_TRIANGLE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CLOSEST_OF_TRIANGLE_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>

#include <CGAL/Simple_cartesian.h>

#include <limits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A point of a triangle, and where it lies.
struct Triangle_point {
  Triangle_set::Point_3 point;
  int side = -1;             ///< on that from corner `side` to the next; -1: inside
  bool is_at_corner = false; ///< at an end of the side
};

/// The point of a segment that is closest to p. The segment may be a point.
inline Triangle_set::Point_3 closest_of_segment(const Triangle_set::Point_3& p, const Triangle_set::Point_3& a,
                                                const Triangle_set::Point_3& b)
{
  const auto d = b - a;
  const double s = (p - a) * d, length = d.squared_length();
  return s > 0 ? s < length ? a + (s / length) * d : b : a;
}

/// The point of a triangle that is closest to p. It lies in the triangle up to round-off, however thin this is; CGAL's
/// own projection divides by zero if the triangle has no area.
inline Triangle_point closest_of_triangle(const Triangle_set::Point_3& p, const Triangle_set::Triangle_3& t)
{
  const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double squared_normal = normal.squared_length(), squared_side = (t[1] - t[0]).squared_length();
  constexpr double thin = 1e-2; // the squared sine of an angle: round-off of the normal grows with its inverse
  const bool is_thin = !(squared_normal > thin * squared_side * (t[2] - t[0]).squared_length()) ||
                       !(squared_normal > thin * squared_side * (t[2] - t[1]).squared_length());
  const auto is_beyond = [&](const int side, const Triangle_set::Point_3& foot) {
    return !(CGAL::cross_product(t[side + 1] - t[side], foot - t[side]) * normal > 0);
  };
  Triangle_point best;
  double distance = std::numeric_limits<double>::infinity();
  const auto offer_side = [&](const int side) {
    const Triangle_set::Point_3 q = closest_of_segment(p, t[side], t[side + 1]);
    const double d = CGAL::squared_distance(p, q);
    if (d < distance) {
      best = {q, side, q == t[side] || q == t[side + 1]};
      distance = d;
    }
  };
  if (!is_thin) {
    // A foot in the plane tells which sides are closest, if the normal is accurate.
    const Triangle_set::Point_3 foot = p - (((p - t[0]) * normal) / squared_normal) * normal;
    best.point = foot;
    for (int side = 0; side < 3; ++side)
      if (is_beyond(side, foot))
        offer_side(side);
    return best;
  }
  for (int side = 0; side < 3; ++side)
    offer_side(side);
  if (!(squared_normal > 0))
    return best;
  // The normal of a thin triangle is not accurate, and the less it matters the shorter the vector that is projected.
  const Triangle_set::Point_3 foot = p - (((p - best.point) * normal) / squared_normal) * normal;
  for (int side = 0; side < 3; ++side)
    if (is_beyond(side, foot))
      return best;
  return CGAL::squared_distance(p, foot) < distance ? Triangle_point{foot, -1, false} : best;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CLOSEST_OF_TRIANGLE_H
