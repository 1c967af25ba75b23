// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_AREA_SAMPLES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_AREA_SAMPLES_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/Progress.h>

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
/// \param progress if it is interrupted, there are more
inline double affordable_size(const Triangle_set& set, double size, const double number_of_samples, Progress& progress)
{
  for (;; size *= 1.25) {
    double number = 0;
    for (std::size_t i = 0; i < set.number_of_data() && progress.go_on_after(2); ++i) {
      const Triangle_set::Triangle_3 t = set.triangle(i);
      const double length = length_of_longest_side(t) / size;
      // A part has a longest side of half the size or more and, unless the triangle is a needle, half that height. A
      // needle falls into three needles that are half as long.
      if (length > 1)
        number += 2 * std::pow(length, std::log2(3.)) + 8 * (area(t) / size) / size;
    }
    if (!(number > number_of_samples))
      return size;
  }
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_AREA_SAMPLES_H
