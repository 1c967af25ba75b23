// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/T_splines/Spline/internal/Box_tree.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>

#include <cmath>
#include <cstddef>
#include <limits>
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
  const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double squared_normal = normal.squared_length(), squared_side = (t[1] - t[0]).squared_length();
  constexpr double thin = 1e-2; // the squared sine of an angle: round-off of the normal grows with its inverse
  // A foot in the plane tells which sides are closest, if the normal is accurate.
  const bool is_thin = !(squared_normal > thin * squared_side * (t[2] - t[0]).squared_length()) ||
                       !(squared_normal > thin * squared_side * (t[2] - t[1]).squared_length());
  if (!is_thin) {
    const Triangle_set::Point_3 foot = p - (((p - t[0]) * normal) / squared_normal) * normal;
    Triangle_set::Point_3 best = foot;
    double distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      if (CGAL::cross_product(t[i + 1] - t[i], foot - t[i]) * normal > 0)
        continue;
      const Triangle_set::Point_3 q = closest_of_segment(p, t[i], t[i + 1]);
      const double d = CGAL::squared_distance(p, q);
      if (d < distance) {
        best = q;
        distance = d;
      }
    }
    return best;
  }
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
public:
  using Point_3 = Triangle_set::Point_3;
  using Triangle_3 = Triangle_set::Triangle_3;

  /// The point of the triangles that is closest to a given one.
  struct Foot {
    double squared_distance = std::numeric_limits<double>::infinity();
    std::size_t triangle = 0; ///< one of those that contain the point
    Point_3 point;

    double distance() const { return std::sqrt(squared_distance); }
  };

  explicit Triangle_tree(const Triangle_set& set)
  {
    std::vector<Axis_parallel_box<double>> boxes(set.triangles.size());
    m_triangles.reserve(set.triangles.size());
    for (std::size_t i = 0; i < set.triangles.size(); ++i) {
      m_triangles.push_back(set.triangle(i));
      for (int k = 0; k < 3; ++k)
        boxes[i].extend({m_triangles[i][k].x(), m_triangles[i][k].y(), m_triangles[i][k].z()});
    }
    m_tree = Box_tree<double>(boxes);
  }

  const Triangle_3& triangle(const std::size_t i) const { return m_triangles[i]; }

  /// \pre there are triangles
  Foot foot(const Point_3& p) const
  {
    Foot result;
    search(p, result);
    return result;
  }

  /// The same; faster, if the triangle with the number `hint` is near p.
  Foot foot(const Point_3& p, const std::size_t hint) const
  {
    Foot result;
    offer(p, hint, result);
    search(p, result);
    return result;
  }

  Point_3 closest_point(const Point_3& p) const { return foot(p).point; }

  double distance(const Point_3& p) const { return foot(p).distance(); }

  /// Calls `visit(i)` for the triangles whose bounding boxes are closer to p than a radius, until it returns `false`.
  /// \return whether it never did
  template <typename Visit>
  bool is_true_near(const Point_3& p, const double radius, const Visit& visit) const
  {
    bool result = true;
    m_tree.for_each_closer(
        {p.x(), p.y(), p.z()}, [&] { return result ? radius * radius : 0; },
        [&](const std::size_t i) { result = result && visit(i); });
    return result;
  }

private:
  void offer(const Point_3& p, const std::size_t i, Foot& best) const
  {
    const Point_3 q = closest_of_triangle(p, m_triangles[i]);
    const double squared_distance = CGAL::squared_distance(p, q);
    if (squared_distance < best.squared_distance)
      best = {squared_distance, i, q};
  }

  void search(const Point_3& p, Foot& best) const
  {
    m_tree.for_each_closer(
        {p.x(), p.y(), p.z()}, [&] { return best.squared_distance; }, [&](const std::size_t i) { offer(p, i, best); });
  }

  std::vector<Triangle_3> m_triangles;
  Box_tree<double> m_tree;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H
