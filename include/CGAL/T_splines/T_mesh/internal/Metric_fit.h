// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_METRIC_FIT_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_METRIC_FIT_H

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// How long on a surface a unit step along u and one along v are, fitted to points (u, v) with their places in space.
//
// The squared distances of pairs of nearby points are fitted by a first fundamental form with orthogonal axes, as
// conformal maps have it; chords of nearby points are hardly shorter than the surface between them, however the patch
// is bent.
class Metric_fit {
public:
  struct Point {
    double u, v;
    std::array<double, 3> p;
  };

  struct Result {
    std::array<double, 2> lengths; // of a unit step along u and along v; zero if there are not two different points
    bool is_measured;              // both; otherwise they are equal, for want of points that differ in both directions
  };

  // Points that span less than a quarter of their face in one direction say nothing about it.
  static Result fit(std::vector<Point> points, const double face_width, const double face_height)
  {
    if (points.empty())
      return {{0, 0}, false};
    const auto u =
        std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.u < b.u; });
    const auto v =
        std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.v < b.v; });
    const double u_min = u.first->u, v_min = v.first->v;
    const double u_extent = u.second->u - u_min, v_extent = v.second->v - v_min;
    const bool is_wide = u_extent > face_width / 4, is_high = v_extent > face_height / 4;
    if (!is_wide && !is_high)
      return {{0, 0}, false};
    const double width = is_wide ? u_extent : face_width, height = is_high ? v_extent : face_height;

    Metric_fit metric;
    for (Point& p : points) {
      p.u = (p.u - u_min) / width;
      p.v = (p.v - v_min) / height;
    }
    metric.add_pairs(points, &Point::u, &Point::v);
    metric.add_pairs(points, &Point::v, &Point::u);
    Result result = metric.solve(width, height);
    result.is_measured = result.is_measured && is_wide && is_high;
    return result;
  }

private:
  // Pairs along strips across the patch, about as many strips as points in each.
  void add_pairs(std::vector<Point>& points, double Point::*const across, double Point::*const along)
  {
    const double strips = std::ceil(std::sqrt(static_cast<double>(points.size())));
    const auto strip = [&](const Point& p) { return std::floor(p.*across * strips); };
    std::stable_sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
      return strip(a) != strip(b) ? strip(a) < strip(b) : a.*along < b.*along;
    });
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (strip(points[i - 1]) == strip(points[i]) || points.size() < 9)
        add_pair(points[i - 1], points[i]);
    }
  }

  // Pairs have weights as the squares of their parametric lengths: where the map is nearly degenerate, small steps are
  // long on the surface, and would count for all.
  void add_pair(const Point& a, const Point& b)
  {
    const double u = b.u - a.u, v = b.v - a.v, length = u * u + v * v;
    if (!(length > 0))
      return;
    double distance = 0;
    for (int i = 0; i < 3; ++i)
      distance += (b.p[i] - a.p[i]) * (b.p[i] - a.p[i]);
    const Eigen::Vector2d row = Eigen::Vector2d(u * u, v * v) / length;
    m_matrix += length * row * row.transpose();
    m_right += row * distance;
    m_squares += length * row;
    m_distance += distance;
    m_weight += length;
    ++m_pairs;
  }

  Result solve(const double width, const double height) const
  {
    if (m_pairs == 0)
      return {{0, 0}, false};
    const double mean = m_distance / m_weight;
    // Two sizes are told apart if there are pairs enough, in directions that differ; and if neither is next to nothing,
    // which noise would have made of it.
    constexpr int enough_pairs = 12;
    constexpr double spread = 0.02, least_size = 0.01;
    if (m_pairs >= enough_pairs && m_matrix.determinant() > spread * m_weight * m_weight) {
      const Eigen::Vector2d form = m_matrix.inverse() * m_right;
      if (form[0] > least_size * mean && form[1] > least_size * mean)
        return {{std::sqrt(form[0]) / width, std::sqrt(form[1]) / height}, true};
    }
    // distance^2 = s^2 (w^2 u^2 + h^2 v^2), summed up.
    const double unit = std::sqrt(m_distance / (width * width * m_squares[0] + height * height * m_squares[1]));
    return {{unit, unit}, false};
  }

  Eigen::Matrix2d m_matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d m_right = Eigen::Vector2d::Zero();
  Eigen::Vector2d m_squares = Eigen::Vector2d::Zero();
  double m_distance = 0, m_weight = 0;
  int m_pairs = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_METRIC_FIT_H
