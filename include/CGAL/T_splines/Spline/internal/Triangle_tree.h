// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

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
inline Triangle_set::Point_3 closest_of_triangle(const Triangle_set::Point_3& p, const Triangle_set::Triangle_3& t)
{
  Triangle_set::Point_3 best = closest_of_segment(p, t[0], t[1]);
  double distance = CGAL::squared_distance(p, best);
  for (int i = 1; i < 3; ++i) {
    const Triangle_set::Point_3 q = closest_of_segment(p, t[i], t[i + 1]);
    const double d = CGAL::squared_distance(p, q);
    if (d < distance) {
      best = q;
      distance = d;
    }
  }
  const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double squared_normal = normal.squared_length();
  if (!(squared_normal > 0))
    return best;
  // The normal of a thin triangle is not accurate, and the less it matters the shorter the vector that is projected.
  const Triangle_set::Point_3 foot = p - (((p - best) * normal) / squared_normal) * normal;
  for (int i = 0; i < 3; ++i)
    if (!(CGAL::cross_product(t[i + 1] - t[i], foot - t[i]) * normal > 0))
      return best;
  return CGAL::squared_distance(p, foot) < distance ? foot : best;
}

/// A tree of triangles that finds closest points. Queries may run in any number of threads.
class Triangle_tree {
  using Base_kernel = Triangle_set::Kernel;

public:
  using Point_3 = Triangle_set::Point_3;
  using Triangle_3 = Triangle_set::Triangle_3;

  explicit Triangle_tree(const Triangle_set& set)
  {
    m_triangles.reserve(set.triangles.size());
    for (std::size_t i = 0; i < set.triangles.size(); ++i)
      m_triangles.push_back(set.triangle(i));
    for (const Triangle_3& t : m_triangles)
      m_tree.insert(Primitive(t));
    m_tree.build();
    const auto starts = distinct_points(set);
    m_tree.accelerate_distance_queries(starts.begin(), starts.end());
  }

  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  /// \pre there are triangles
  Point_3 closest_point(const Point_3& p) const { return m_tree.closest_point(p); }

  double distance(const Point_3& p) const { return std::sqrt(CGAL::squared_distance(p, closest_point(p))); }

private:
  // A kernel with another projection.
  struct Kernel : Base_kernel {
    struct Construct_projected_point_3 {
      Point_3 operator()(const Triangle_3& t, const Point_3& p) const { return closest_of_triangle(p, t); }
    };
    Construct_projected_point_3 construct_projected_point_3_object() const { return {}; }
  };

  class Primitive {
  public:
    using Id = const Triangle_3*;
    using Point = Point_3;
    using Datum = Triangle_3;

    explicit Primitive(const Triangle_3& t) : m_triangle(&t) {}
    Id id() const { return m_triangle; }
    const Datum& datum() const { return *m_triangle; }
    const Point& reference_point() const { return m_triangle->vertex(0); }

  private:
    Id m_triangle;
  };

  using Tree = CGAL::AABB_tree<AABB_traits_for_3<Kernel, Primitive>>;
  using Start = typename Tree::Point_and_primitive_id;

  // Where searches may begin: CGAL's tree of points needs quadratic time for points that coincide, as in a fan.
  std::vector<Start> distinct_points(const Triangle_set& set) const
  {
    std::vector<Start> starts;
    starts.reserve(set.points.size());
    std::vector<bool> is_added(set.points.size(), false);
    for (std::size_t i = 0; i < set.triangles.size(); ++i)
      for (const std::size_t p : set.triangles[i])
        if (!is_added[p]) {
          is_added[p] = true;
          starts.emplace_back(set.points[p], &m_triangles[i]);
        }
    std::sort(starts.begin(), starts.end());
    const auto is_same_point = [](const Start& a, const Start& b) { return a.first == b.first; };
    starts.erase(std::unique(starts.begin(), starts.end(), is_same_point), starts.end());
    return starts;
  }

  std::vector<Triangle_3> m_triangles;
  Tree m_tree;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H
