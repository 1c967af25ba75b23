// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/T_splines/Spline/internal/Box_tree.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/closest_of_triangle.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

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
    Progress nobody;
    *this = Triangle_tree(set, nobody);
  }

  /// \param progress if it is interrupted, triangles are missing
  Triangle_tree(const Triangle_set& set, Progress& progress)
  {
    std::vector<Axis_parallel_box<double>> boxes(set.triangles.size());
    m_triangles.reserve(set.triangles.size());
    for (std::size_t i = 0; i < set.triangles.size(); ++i) {
      m_triangles.push_back(set.triangle(i));
      for (int k = 0; k < 3; ++k)
        boxes[i].extend({m_triangles[i][k].x(), m_triangles[i][k].y(), m_triangles[i][k].z()});
    }
    m_tree = Box_tree<double>(boxes, progress);
  }

  const Triangle_3& triangle(const std::size_t i) const { return m_triangles[i]; }

  /// \pre there are triangles
  Foot foot(const Point_3& p) const { return foot_from(p, {std::numeric_limits<double>::infinity(), 0}); }

  /// The same; faster, if the triangle with the number `hint` is near p.
  Foot foot(const Point_3& p, const std::size_t hint) const { return foot_from(p, {squared_distance(p, hint), hint}); }

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
  double squared_distance(const Point_3& p, const std::size_t i) const
  {
    return CGAL::squared_distance(p, closest_of_triangle(p, m_triangles[i]).point);
  }

  Foot foot_from(const Point_3& p, const std::pair<double, std::size_t>& start) const
  {
    const auto [distance, i] =
        m_tree.closest({p.x(), p.y(), p.z()}, start, [&](const std::size_t j) { return squared_distance(p, j); });
    return {distance, i, closest_of_triangle(p, m_triangles[i]).point};
  }

  std::vector<Triangle_3> m_triangles;
  Box_tree<double> m_tree;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_TREE_H
