// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_WALK_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_WALK_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_stars.h>
#include <CGAL/T_splines/Spline/internal/closest_of_triangle.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Closest points of a surface of triangles, found by walking over the surface: so they stay on the sheet on which the
/// walk begins, however close another one is.
class Surface_walk {
public:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  using Triangle = std::array<std::size_t, 3>;

  /// A point of the surface.
  struct Foot {
    std::size_t triangle;
    Point_3 point;
    double squared_distance; ///< from the point that was asked for
    int side;                ///< of the triangle, see `Triangle_point`
    bool is_at_corner;       ///< of the triangle

    bool is_inside() const { return side < 0; }
  };

  /// \param points, triangles must outlive this
  /// \param is_barred the triangles that no walk leads to
  /// \param progress if it is interrupted, this must not be used
  Surface_walk(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles, std::vector<bool> is_barred,
               Progress& progress)
    : m_points(points),
      m_triangles(triangles),
      m_is_barred(std::move(is_barred)),
      m_stars(points.size(), triangles)
  {
    for (std::size_t i = 0; i < triangles.size() && progress.go_on_after(2); ++i) {
      const Triangle& t = triangles[i];
      m_corners.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
      const Vector_3 n = normal(i);
      const double length = std::sqrt(n.squared_length());
      m_unit_normals.push_back(length > 0 ? n / length : Vector_3(0, 0, 0));
    }
    for (std::size_t i = 0; i < triangles.size() && progress.go_on_after(4); ++i)
      m_across.push_back({find_across(i, 0), find_across(i, 1), find_across(i, 2)});
  }

  /// Calls `f(triangle)` for all triangles that have a corner in common with a triangle, possibly more than once.
  template <typename Function>
  void for_each_neighbor(const std::size_t triangle, const Function& f) const
  {
    for (const std::size_t p : m_triangles[triangle])
      m_stars.for_each_around(p, f);
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  const Vector_3& unit_normal(const std::size_t triangle) const { return m_unit_normals[triangle]; }

  /// The triangle on the other side of the edge from corner i to corner i + 1 of a triangle; the same if there is none.
  std::size_t across(const std::size_t triangle, const std::size_t i) const { return m_across[triangle][i]; }

  /// The point closest to `q`, as far as one gets from triangle to neighbouring triangle always coming closer.
  Foot closest(const Point_3& q, const std::size_t start) const
  {
    constexpr double closer = 1 - 1e-12; // less is round-off, by which the walk might go in a circle
    Foot foot = closest_of(q, start);
    while (!foot.is_inside()) {
      const Foot before = foot;
      // Mostly the way goes across the edge. Only at its end the whole neighbourhood is looked at.
      if (!foot.is_at_corner)
        take_if_closer(q, m_across[foot.triangle][foot.side], foot);
      if (!(foot.squared_distance < before.squared_distance * closer))
        for_each_neighbor(before.triangle, [&](const std::size_t t) { take_if_closer(q, t, foot); });
      if (!(foot.squared_distance < before.squared_distance * closer))
        break;
    }
    return foot;
  }

  /// The point of the border closest to `q`, as far as one gets from edge to neighbouring edge always coming closer, and
  /// not past a corner: on the two sides of a slit, one would come to the other side around its end.
  /// \param triangle, side where to begin: an edge of the border, from corner `side` on
  /// \param is_border_corner per point
  Foot closest_on_border(const Point_3& q, const std::size_t triangle, const int side,
                         const std::vector<char>& is_border_corner) const
  {
    constexpr double closer = 1 - 1e-12;
    for (Foot foot = closest_of_side(q, triangle, side);;) {
      const Foot before = foot;
      for (const int end : {0, 1}) {
        if (is_border_corner[m_triangles[before.triangle][(before.side + end) % 3]] != 0)
          continue;
        const Foot other = closest_of_neighbor(q, before, end);
        if (other.squared_distance < foot.squared_distance)
          foot = other;
      }
      if (!(foot.squared_distance < before.squared_distance * closer))
        return foot;
    }
  }

  /// Whether a normal points against the surface at a foot: at an edge or a corner, against all triangles around.
  bool is_against(const Vector_3& n, const Foot& foot) const
  {
    if (n * m_unit_normals[foot.triangle] > 0)
      return false;
    if (foot.is_inside())
      return true;
    bool result = true;
    for_each_neighbor(foot.triangle, [&](const std::size_t t) {
      if (result && n * m_unit_normals[t] > 0)
        result =
            CGAL::squared_distance(closest_of(foot.point, t).point, foot.point) >
            same_point * same_point * CGAL::squared_distance(m_points[m_triangles[t][0]], m_points[m_triangles[t][1]]);
    });
    return result;
  }

  /// Whether a normal points along that of any triangle, among those around a foot that are not farther than a distance
  /// from a point and hang together.
  bool agrees_within(const double distance, const Vector_3& n, const Point_3& q, const Foot& foot) const
  {
    std::vector<std::size_t> seen = {foot.triangle};
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (n * m_unit_normals[seen[i]] > 0)
        return true;
      for_each_neighbor(seen[i], [&](const std::size_t t) {
        if (std::find(seen.begin(), seen.end(), t) == seen.end() &&
            closest_of(q, t).squared_distance <= distance * distance)
          seen.push_back(t);
      });
    }
    return false;
  }

private:
  Vector_3 normal(const std::size_t t) const
  {
    const Point_3& p = m_points[m_triangles[t][0]];
    return CGAL::cross_product(m_points[m_triangles[t][1]] - p, m_points[m_triangles[t][2]] - p);
  }

  std::size_t find_across(const std::size_t triangle, const std::size_t i) const
  {
    const std::size_t a = m_triangles[triangle][i], b = m_triangles[triangle][(i + 1) % 3];
    std::size_t result = triangle;
    m_stars.for_each_around(a, [&](const std::size_t k) {
      const Triangle& t = m_triangles[k];
      for (std::size_t j = 0; j < 3; ++j)
        if (t[j] == b && t[(j + 1) % 3] == a)
          result = k;
    });
    return result;
  }

  void take_if_closer(const Point_3& q, const std::size_t t, Foot& foot) const
  {
    if (t == foot.triangle || m_is_barred[t])
      return;
    const Foot other = closest_of(q, t);
    if (other.squared_distance < foot.squared_distance)
      foot = other;
  }

  Foot closest_of(const Point_3& q, const std::size_t t) const
  {
    const Triangle_point p = closest_of_triangle(q, m_corners[t]);
    return {t, p.point, CGAL::squared_distance(q, p.point), p.side, p.is_at_corner};
  }

  Foot closest_of_side(const Point_3& q, const std::size_t t, const int side) const
  {
    const Point_3 &a = m_points[m_triangles[t][side]], &b = m_points[m_triangles[t][(side + 1) % 3]];
    const Vector_3 way = b - a;
    const double length = way.squared_length(), x = length > 0 ? std::clamp((q - a) * way / length, 0., 1.) : 0;
    const Point_3 p = a + x * way;
    return {t, p, CGAL::squared_distance(q, p), side, x == 0 || x == 1};
  }

  // Of the edge of the border that meets that of a foot at its begin (0) or its end (1).
  Foot closest_of_neighbor(const Point_3& q, const Foot& foot, const int end) const
  {
    const std::size_t common = m_triangles[foot.triangle][(foot.side + end) % 3];
    Foot result = foot;
    m_stars.for_each_around(common, [&](const std::size_t t) {
      for (int i = 0; i < 3; ++i)
        if (m_triangles[t][(i + 1 - end) % 3] == common && m_across[t][i] == t &&
            !(t == foot.triangle && i == foot.side))
          result = closest_of_side(q, t, i);
    });
    return result;
  }

  const std::vector<Point_3>& m_points;
  const std::vector<Triangle>& m_triangles;
  const std::vector<bool> m_is_barred;
  Triangle_stars m_stars;
  std::vector<Triangle_set::Triangle_3> m_corners;
  std::vector<std::array<std::size_t, 3>> m_across;
  std::vector<Vector_3> m_unit_normals;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_SURFACE_WALK_H
