// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_AREA_SAMPLES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_AREA_SAMPLES_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The number i of the longest side, from corner i to corner i + 1.
inline int longest_side(const Triangle_set::Triangle_3& t)
{
  const double a = CGAL::squared_distance(t[0], t[1]), b = CGAL::squared_distance(t[1], t[2]),
               c = CGAL::squared_distance(t[2], t[0]);
  return a >= b ? a >= c ? 0 : 2 : b >= c ? 1 : 2;
}

inline double length_of_longest_side(const Triangle_set::Triangle_3& t)
{
  const int i = longest_side(t);
  return std::sqrt(CGAL::squared_distance(t[i], t[i + 1]));
}

/// The size of parts that makes about so many samples at most, if all triangles with longer sides are bisected.
/// \param size the smallest size wanted, positive
inline double affordable_size(const Triangle_set& set, double size, const double number_of_samples)
{
  for (;; size *= 2) {
    double number = 0;
    for (std::size_t i = 0; i < set.triangles.size(); ++i) {
      const Triangle_set::Triangle_3 t = set.triangle(i);
      const double length = length_of_longest_side(t) / size;
      // A part has a longest side of half the size or more and, unless the triangle is a needle, half that height.
      if (length > 1)
        number += 2 * length + 8 * (area(t) / size) / size;
    }
    if (!(number > number_of_samples))
      return size;
  }
}

/// Divides triangles with sides longer than `size` by bisections of longest sides, and calls `visit(p, w)` for the
/// centroids of the parts and their areas.
/// \return weights of the points of the set: from the areas of all other triangles. With them, sums over the centroids
/// and the points are integrals, with an error of order two
template <typename Visit>
std::vector<double> visit_area_samples(const Triangle_set& set, const double size, const Visit& visit)
{
  std::vector<double> weights(set.points.size(), 0.);
  std::vector<Triangle_set::Triangle_3> parts;
  for (std::size_t i = 0; i < set.triangles.size(); ++i) {
    parts.assign(1, set.triangle(i));
    if (length_of_longest_side(parts[0]) <= size) {
      for (const std::size_t p : set.triangles[i])
        weights[p] += area(parts[0]) / 3;
      continue;
    }
    while (!parts.empty()) {
      const Triangle_set::Triangle_3 t = parts.back();
      parts.pop_back();
      const int k = longest_side(t);
      const double squared_length = CGAL::squared_distance(t[k], t[k + 1]);
      const Triangle_set::Point_3 middle = CGAL::midpoint(t[k], t[k + 1]);
      // Far from the origin, round-off may move the middle to one of the ends.
      const double squared_part =
          (std::max)(CGAL::squared_distance(t[k], middle), CGAL::squared_distance(middle, t[k + 1]));
      if (std::sqrt(squared_length) <= size || squared_part > squared_length / 2) {
        visit(CGAL::centroid(t), area(t));
        continue;
      }
      parts.emplace_back(t[k], middle, t[k + 2]);
      parts.emplace_back(middle, t[k + 1], t[k + 2]);
    }
  }
  return weights;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_AREA_SAMPLES_H
