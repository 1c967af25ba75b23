// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_STARS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_STARS_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The triangles around each point of a set of triangles.
class Triangle_stars {
public:
  Triangle_stars(const std::size_t number_of_points, const std::vector<std::array<std::size_t, 3>>& triangles)
    : m_first(number_of_points + 1, 0),
      m_triangles(3 * triangles.size())
  {
    for (const auto& corners : triangles)
      for (const std::size_t p : corners)
        ++m_first[p + 1];
    for (std::size_t p = 0; p < number_of_points; ++p)
      m_first[p + 1] += m_first[p];
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const std::size_t p : triangles[t])
        m_triangles[next[p]++] = t;
  }

  /// Calls `visit(triangle)` for all triangles with a corner at a point.
  template <typename Visit>
  void for_each_around(const std::size_t point, const Visit& visit) const
  {
    for (std::size_t i = m_first[point]; i < m_first[point + 1]; ++i)
      visit(m_triangles[i]);
  }

private:
  std::vector<std::size_t> m_first, m_triangles;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_STARS_H
