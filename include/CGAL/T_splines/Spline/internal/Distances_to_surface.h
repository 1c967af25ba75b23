// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_SURFACE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_SURFACE_H

#include <CGAL/T_splines/Spline/internal/Distance_sum.h>
#include <CGAL/T_splines/Spline/internal/Largest_distance.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/area_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Measures the distances of a mesh from a surface.
///
/// Triangles that are large compared with the Bezier patches next to them are bisected; distances are measured at all
/// corners and centroids. Then the parts whose bounds exceed the largest distance are bisected. There are two bounds.
/// (1) The distance from a point of the surface is a convex function: it is largest at a corner of a polygon. (2) The
/// triangle of the corners' closest points is no farther than the farthest corner, and the surface not far from that
/// triangle.
///
/// Distances come from a local search. The largest one is checked by a global one, as are all that seem to be larger.
/// \tparam Measured a `Measured_surface` that is prepared
template <typename Measured>
class Distances_to_surface {
public:
  using Point_3 = Triangle_set::Point_3;
  using Foot = typename Measured::Foot;

  /// A point of the mesh, and what is closest to it on the surface.
  struct Sample {
    Point_3 point;
    Foot foot;
    std::size_t triangle; ///< one of those that contain the point
  };

  /// \param negligible distances that need not be told apart
  /// \param smallest_size parts need not be smaller for means
  Distances_to_surface(const Triangle_set& mesh, const Measured& surface, const double negligible,
                       const double smallest_size)
    : m_mesh(mesh),
      m_surface(surface),
      m_smallest_size(smallest_size),
      m_negligible(negligible),
      m_largest(negligible)
  {
  }

  /// Calls `visit(sample)` for all samples.
  /// \param number_of_samples how many there may be in large triangles, about
  /// \param distances receives those of the points of the mesh
  template <typename Visit>
  void measure(const double number_of_samples, Distance_sum& sum, std::vector<double>& distances, const Visit& visit)
  {
    measure_points(visit);
    const double smallest = affordable_size(m_mesh, (std::max)(smallest_cell(), m_smallest_size), number_of_samples);
    std::vector<Part> parts;
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
      const std::array<std::size_t, 3>& t = m_mesh.triangles[i];
      parts.push_back({{m_mesh.points[t[0]], m_mesh.points[t[1]], m_mesh.points[t[2]]},
                       {m_feet[t[0]], m_feet[t[1]], m_feet[t[2]]},
                       i,
                       0});
      while (!parts.empty()) {
        Part part = parts.back();
        parts.pop_back();
        if (is_small(part, smallest) || !bisect(part, visit, parts)) {
          add_to(part, visit, sum);
          part.bound = bound(part);
          m_largest.add(std::move(part));
        }
      }
    }
    distances.clear();
    for (const Foot& foot : m_feet)
      distances.push_back(foot.distance);
  }

  /// Looks for the largest distance. \param number_of_steps the most parts that are bisected
  template <typename Visit>
  void search(std::size_t number_of_steps, const Visit& visit)
  {
    std::vector<Part> halves;
    for (; number_of_steps > 0 && m_largest.has_open_part(); --number_of_steps) {
      Part part = m_largest.take();
      halves.clear();
      if (!bisect(part, visit, halves))
        m_largest.leave_out(part.bound);
      for (Part& half : halves) {
        half.bound = (std::min)(part.bound, bound(half));
        m_largest.add(std::move(half));
      }
    }
  }

  double upper_bound() const { return m_largest.upper_bound(); }
  const Sample& farthest() const { return m_farthest; }

private:
  struct Part {
    std::array<Point_3, 3> corners;
    std::array<Foot, 3> feet;
    std::size_t number; // of the triangle
    double bound;

    Triangle_set::Triangle_3 triangle() const { return Triangle_set::Triangle_3(corners[0], corners[1], corners[2]); }
  };

  template <typename Visit>
  void measure_points(const Visit& visit)
  {
    m_feet.resize(m_mesh.points.size());
    std::vector<bool> is_measured(m_mesh.points.size(), false);
    Foot hint;
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
      for (const std::size_t p : m_mesh.triangles[i])
        if (!is_measured[p]) {
          is_measured[p] = true;
          hint = m_feet[p] = measured(m_mesh.points[p], hint, i, visit);
        }
  }

  template <typename Visit>
  Foot measured(const Point_3& p, const Foot& hint, const std::size_t triangle, const Visit& visit)
  {
    Foot foot = m_surface.close_point(p, hint);
    // Which of two sheets is closer does not matter where the point lies on one, up to round-off.
    if (foot.distance > (std::max)(m_largest.found(), m_negligible))
      foot = m_surface.closest_point(p, foot);
    const Sample sample{p, foot, triangle};
    if (m_largest.offer(foot.distance))
      m_farthest = sample;
    visit(sample);
    return foot;
  }

  // Of the patches.
  double smallest_cell() const
  {
    double result = (std::numeric_limits<double>::max)();
    for (std::size_t i = 0; i < m_surface.number_of_patches(); ++i)
      result = (std::min)(result, cell_size(i));
    return (std::max)(result, (std::numeric_limits<double>::min)());
  }

  double cell_size(const std::size_t patch) const
  {
    return 0.3 * (std::min)(m_surface.size(patch)[0], m_surface.size(patch)[1]);
  }

  bool is_small(const Part& part, const double smallest) const
  {
    const double length = length_of_longest_side(part.triangle());
    return length <= smallest || std::all_of(part.feet.begin(), part.feet.end(),
                                             [&](const Foot& foot) { return length <= cell_size(foot.patch); });
  }

  // Appends the two halves. \return whether round-off allows that
  template <typename Visit>
  bool bisect(const Part& part, const Visit& visit, std::vector<Part>& halves)
  {
    const int k = longest_side(part.triangle()), l = (k + 1) % 3;
    const Point_3 &a = part.corners[k], &b = part.corners[l], middle = CGAL::midpoint(a, b);
    const double squared_part = (std::max)(CGAL::squared_distance(a, middle), CGAL::squared_distance(middle, b));
    if (squared_part > CGAL::squared_distance(a, b) / 2)
      return false;
    const Foot foot = measured(middle, part.feet[k], part.number, visit);
    for (const int corner : {k, l}) {
      halves.push_back(part);
      halves.back().corners[corner] = middle;
      halves.back().feet[corner] = foot;
    }
    return true;
  }

  // By the corners and the centroid, a rule of order 3.
  template <typename Visit>
  void add_to(const Part& part, const Visit& visit, Distance_sum& sum)
  {
    const Triangle_set::Triangle_3 triangle = part.triangle();
    const double size = area(triangle);
    for (const Foot& foot : part.feet)
      sum.add(size / 12, foot.distance);
    sum.add(0.75 * size, measured(CGAL::centroid(triangle), part.feet[0], part.number, visit).distance);
  }

  // From the middles of the sides to the centroid, a triangle is divided into three parts, one at each corner.
  double bound(const Part& part) const
  {
    const auto& p = part.corners;
    const std::array<Point_3, 3> middles{CGAL::midpoint(p[0], p[1]), CGAL::midpoint(p[1], p[2]),
                                         CGAL::midpoint(p[2], p[0])};
    const Point_3 centroid = CGAL::centroid(p[0], p[1], p[2]);
    double of_corners = 0, squared = 0;
    for (int i = 0; i < 3; ++i) {
      const Foot& foot = part.feet[i];
      of_corners = (std::max)(of_corners, foot.distance);
      for (const Point_3& q : {p[i], middles[i], middles[(i + 2) % 3], centroid})
        squared = (std::max)(squared, CGAL::squared_distance(q, foot.point));
    }
    return (std::min)(std::sqrt(squared), of_corners + m_surface.chord_error(part.feet[0], part.feet[1], part.feet[2]));
  }

  const Triangle_set& m_mesh;
  const Measured& m_surface;
  double m_smallest_size;
  std::vector<Foot> m_feet; // of the points
  Sample m_farthest;
  double m_negligible;
  Largest_distance<Part> m_largest;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_SURFACE_H
