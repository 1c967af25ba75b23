// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_SURFACE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_SURFACE_H

#include <CGAL/T_splines/Spline/internal/Distance_sum.h>
#include <CGAL/T_splines/Spline/internal/Largest_distance.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/Spline/internal/area_samples.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/number_utils.h>

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

/// Measures the distances of a mesh from a surface: of its triangles that are data.
///
/// Edges and triangles that are large compared with the Bezier patches next to them are bisected; distances are measured
/// at all corners and centroids. From the largest ones, steps lead to even larger ones. Then the parts whose bounds
/// exceed the largest distance are bisected. There are two bounds.
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
  /// \param progress it must outlive this; if it is interrupted, what was measured means nothing
  Distances_to_surface(const Triangle_set& mesh, const Measured& surface, const double negligible,
                       const double smallest_size, Progress& progress)
    : m_mesh(mesh),
      m_surface(surface),
      m_smallest_size(smallest_size),
      m_progress(progress),
      m_negligible(negligible),
      m_largest(negligible)
  {
  }

  /// Calls `visit(sample)` for all samples.
  /// \param number_of_samples how many there may be in large triangles, about
  /// \param distances receives those of the points of the mesh that are data
  template <typename Visit>
  void measure(const double number_of_samples, Distance_sum& sum, std::vector<double>& distances, const Visit& visit)
  {
    measure_points(visit);
    measure_edges(number_of_samples, visit);
    const double smallest =
        affordable_size(m_mesh, (std::max)(smallest_cell(), m_smallest_size), number_of_samples, m_progress);
    std::vector<Part> parts;
    const std::size_t n = m_mesh.number_of_data();
    for (std::size_t i = 0; i < n && m_progress.go_on_after(10); ++i) {
      if (i % 64 == 0)
        m_progress.progress(0.6 + 0.4 * static_cast<double>(i) / static_cast<double>(n));
      const std::array<std::size_t, 3>& t = m_mesh.triangles[i];
      parts.push_back({{m_mesh.points[t[0]], m_mesh.points[t[1]], m_mesh.points[t[2]]},
                       {m_feet[t[0]], m_feet[t[1]], m_feet[t[2]]},
                       i,
                       0});
      while (!parts.empty() && !m_progress.is_interrupted()) {
        Part part = parts.back();
        parts.pop_back();
        if (is_small(part, smallest) || !bisect(part, visit, parts)) {
          add_to(part, visit, sum);
          part.bound = bound(part);
          m_largest.add(std::move(part));
        }
      }
    }
    climb(visit);
    distances.clear();
    for (const Foot& foot : m_feet)
      distances.push_back(foot.distance);
  }

  /// Looks for the largest distance. \param number_of_steps the most parts that are bisected
  template <typename Visit>
  void search(std::size_t number_of_steps, const Visit& visit)
  {
    std::vector<Part> halves;
    for (; number_of_steps > 0 && m_largest.has_open_part() && m_progress.go_on_after(10); --number_of_steps) {
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

  // Means need no more samples than the area has, but the largest distances are next to sharp edges.
  template <typename Visit>
  void measure_edges(const double number_of_samples, const Visit& visit)
  {
    std::vector<std::array<std::size_t, 3>> edges; // two points and a triangle
    double length = 0;
    for (std::size_t i = 0; i < m_mesh.number_of_data(); ++i)
      for (int k = 0; k < 3; ++k) {
        const std::size_t p = m_mesh.triangles[i][k], q = m_mesh.triangles[i][(k + 1) % 3];
        edges.push_back({(std::min)(p, q), (std::max)(p, q), i});
      }
    m_progress.progress(0.4);
    if (!m_progress.go_on())
      return;
    std::sort(edges.begin(), edges.end());
    const auto is_same = [](const auto& a, const auto& b) { return a[0] == b[0] && a[1] == b[1]; };
    edges.erase(std::unique(edges.begin(), edges.end(), is_same), edges.end());
    for (const auto& edge : edges)
      length += std::sqrt(CGAL::squared_distance(m_mesh.points[edge[0]], m_mesh.points[edge[1]]));
    const double smallest = (std::max)(length / number_of_samples, m_smallest_size);
    std::vector<Segment> segments;
    for (const auto& edge : edges) {
      segments.push_back({m_mesh.points[edge[0]], m_mesh.points[edge[1]], m_feet[edge[0]], m_feet[edge[1]]});
      while (!segments.empty() && m_progress.go_on_after(1)) {
        const Segment segment = segments.back();
        segments.pop_back();
        const double size =
            (std::max)(smallest, (std::min)(cell_size(segment.foot.patch), cell_size(segment.other_foot.patch)));
        if (CGAL::squared_distance(segment.point, segment.other) <= size * size)
          continue;
        const Point_3 middle = CGAL::midpoint(segment.point, segment.other);
        if (middle == segment.point || middle == segment.other)
          continue; // by round-off
        const Foot foot = measured(middle, segment.foot, edge[2], visit);
        segments.push_back({segment.point, middle, segment.foot, foot});
        segments.push_back({middle, segment.other, foot, segment.other_foot});
      }
    }
  }

  static bool is_farther(const Sample& a, const Sample& b) { return a.foot.distance > b.foot.distance; }

  // Keeps the farthest samples.
  void keep(const Sample& sample)
  {
    constexpr std::size_t number_of_samples = 2000;
    if (m_far_samples.size() == number_of_samples) {
      if (!is_farther(sample, m_far_samples.front()))
        return;
      std::pop_heap(m_far_samples.begin(), m_far_samples.end(), is_farther);
      m_far_samples.pop_back();
    }
    m_far_samples.push_back(sample);
    std::push_heap(m_far_samples.begin(), m_far_samples.end(), is_farther);
  }

  // Along a sharp edge, distances are about the same everywhere, bounds are not tight, and branch and bound would not
  // get to the largest distance soon. From where distances are large, this goes on to where they are larger.
  template <typename Visit>
  void climb(const Visit& visit)
  {
    constexpr std::size_t number_of_climbs = 300;
    std::vector<Sample> samples, starts;
    samples.swap(m_far_samples);
    std::sort(samples.begin(), samples.end(), is_farther);
    for (const Sample& sample : samples) {
      if (m_progress.is_interrupted())
        break;
      const double size = (std::max)(cell_size(sample.foot.patch), m_smallest_size);
      if (std::any_of(starts.begin(), starts.end(), [&](const Sample& start) {
            return start.triangle == sample.triangle && CGAL::squared_distance(start.point, sample.point) < size * size;
          }))
        continue;
      starts.push_back(sample);
      climb(sample, size, visit);
      if (starts.size() == number_of_climbs)
        break;
    }
    m_far_samples.clear();
  }

  // By steps in six directions on the triangle that get shorter where none leads farther away from the surface.
  template <typename Visit>
  void climb(Sample sample, const double longest_step, const Visit& visit)
  {
    constexpr double shorter = 0.6, shortest = 0.02; // by the step before, and by the longest step
    int number_of_trials = 50;
    const Triangle_set::Triangle_3 t = m_mesh.triangle(sample.triangle);
    const auto side = t[1] - t[0];
    const auto normal = CGAL::cross_product(side, t[2] - t[0]);
    if (!(normal.squared_length() > 0))
      return;
    const auto x = side / std::sqrt(side.squared_length());
    const auto y = CGAL::cross_product(normal, x) / std::sqrt(normal.squared_length());
    for (double step = longest_step;
         step > shortest * longest_step && number_of_trials > 0 && !m_progress.is_interrupted();) {
      bool is_higher = false;
      for (int i = 0; i < 6 && !is_higher; ++i, --number_of_trials) {
        const double angle = CGAL_PI / 3 * i;
        const Point_3 q =
            closest_of_triangle(sample.point + step * (std::cos(angle) * x + std::sin(angle) * y), t).point;
        const Foot foot = measured(q, sample.foot, sample.triangle, visit);
        is_higher = foot.distance > sample.foot.distance;
        if (is_higher) {
          sample.point = q;
          sample.foot = foot;
        }
      }
      if (!is_higher)
        step *= shorter;
    }
  }

  // Of an edge.
  struct Segment {
    Point_3 point, other;
    Foot foot, other_foot;
  };

  template <typename Visit>
  void measure_points(const Visit& visit)
  {
    m_feet.resize(m_mesh.number_of_data_points());
    std::vector<bool> is_measured(m_feet.size(), false);
    Foot hint;
    const std::size_t n = m_mesh.number_of_data();
    for (std::size_t i = 0; i < n && m_progress.go_on_after(1); ++i) {
      if (i % 64 == 0)
        m_progress.progress(0.3 * static_cast<double>(i) / static_cast<double>(n));
      for (const std::size_t p : m_mesh.triangles[i])
        if (!is_measured[p]) {
          is_measured[p] = true;
          hint = m_feet[p] = measured(m_mesh.points[p], hint, i, visit);
        }
    }
  }

  template <typename Visit>
  Foot measured(const Point_3& p, const Foot& hint, const std::size_t triangle, const Visit& visit)
  {
    constexpr std::size_t work = 100, work_of_global_search = 1000;
    m_progress.go_on_after(work);
    Foot foot = m_surface.close_point(p, hint);
    // Which of two sheets is closer does not matter where the point lies on one, up to round-off.
    if (foot.distance > (std::max)(m_largest.found(), m_negligible)) {
      m_progress.go_on_after(work_of_global_search);
      foot = m_surface.closest_point(p, foot);
    }
    const Sample sample{p, foot, triangle};
    if (m_largest.offer(foot.distance))
      m_farthest = sample;
    keep(sample);
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

  // By the corners and the centroid, a rule of order 3; of a part that is small against the patches, by the corners.
  template <typename Visit>
  void add_to(const Part& part, const Visit& visit, Distance_sum& sum)
  {
    const Triangle_set::Triangle_3 triangle = part.triangle();
    const double size = area(triangle), length = length_of_longest_side(triangle);
    constexpr double small = 0.5; // by the cells of the surface: distance is nearly linear there
    if (std::all_of(part.feet.begin(), part.feet.end(),
                    [&](const Foot& foot) { return length <= small * cell_size(foot.patch); })) {
      for (const Foot& foot : part.feet)
        sum.add(size / 3, foot.distance);
      return;
    }
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
  Progress& m_progress;
  std::vector<Foot> m_feet; // of the points
  Sample m_farthest;
  std::vector<Sample> m_far_samples;
  double m_negligible;
  Largest_distance<Part> m_largest;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCES_TO_SURFACE_H
