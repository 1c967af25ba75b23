// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_MESH_NORMALS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_MESH_NORMALS_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_stars.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The normals of triangles, and which triangles meet in a point.
class Mesh_normals {
public:
  using Vector_3 = Triangle_set::Kernel::Vector_3;

  explicit Mesh_normals(const Triangle_set& set) : m_set(set), m_stars(set.points.size(), set.triangles)
  {
    m_normals.reserve(set.triangles.size());
    for (std::size_t i = 0; i < set.triangles.size(); ++i) {
      const Triangle_set::Triangle_3 t = set.triangle(i);
      const Vector_3 normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
      const double length = std::sqrt(normal.squared_length());
      m_normals.push_back(length > 0 ? Vector_3(normal / length) : Vector_3(0, 0, 0));
    }
  }

  /// The unit normal of a triangle; 0 if it has no area.
  const Vector_3& normal(const std::size_t triangle) const { return m_normals[triangle]; }

  /// The cosine of the angle between a unit vector and the normal at a foot; if the foot lies on an edge or in a
  /// corner, of the smallest angle with the triangles there. Triangles without area do not count; 1 if there is no
  /// other.
  /// \param enough the result need only be right if it is less
  double cosine(const Vector_3& unit, const Triangle_tree::Foot& foot, const double enough) const
  {
    constexpr double nothing = -2;
    double result = cosine_with(unit, foot.triangle, nothing);
    if (result >= enough)
      return result;
    const std::array<std::size_t, 3>& corners = m_set.triangles[foot.triangle];
    const Triangle_set::Triangle_3 t = m_set.triangle(foot.triangle);
    const double squared_tolerance = same_point * same_point *
                                     (std::max)({CGAL::squared_distance(t[0], t[1]), CGAL::squared_distance(t[1], t[2]),
                                                 CGAL::squared_distance(t[2], t[0])});
    const auto is_at = [&](const Triangle_set::Point_3& p) {
      return CGAL::squared_distance(p, foot.point) <= squared_tolerance;
    };
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = corners[i], b = corners[(i + 1) % 3];
      if (is_at(t[i]))
        m_stars.for_each_around(
            a, [&](const std::size_t k) { result = (std::max)(result, cosine_with(unit, k, nothing)); });
      else if (is_at(closest_of_segment(foot.point, t[i], t[i + 1])))
        m_stars.for_each_around(a, [&](const std::size_t k) {
          const std::array<std::size_t, 3>& other = m_set.triangles[k];
          if (std::find(other.begin(), other.end(), b) != other.end())
            result = (std::max)(result, cosine_with(unit, k, nothing));
        });
    }
    return result == nothing ? 1 : result;
  }

private:
  double cosine_with(const Vector_3& unit, const std::size_t triangle, const double without_area) const
  {
    const Vector_3& normal = m_normals[triangle];
    return normal == CGAL::NULL_VECTOR ? without_area : unit * normal;
  }

  const Triangle_set& m_set;
  std::vector<Vector_3> m_normals;
  Triangle_stars m_stars;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_MESH_NORMALS_H
