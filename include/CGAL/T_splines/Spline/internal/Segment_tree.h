// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_SEGMENT_TREE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_SEGMENT_TREE_H

#include <CGAL/T_splines/Spline/internal/Box_tree.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/closest_of_triangle.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A tree of segments that finds closest points. Queries may run in any number of threads.
class Segment_tree {
public:
  using Point_3 = Triangle_set::Point_3;
  using Segment = std::array<Point_3, 2>;

  /// The point of the segments that is closest to a given one.
  struct Foot {
    double squared_distance = 0;
    std::size_t segment = 0; ///< one of those that contain the point

    double distance() const { return std::sqrt(squared_distance); }
  };

  /// \param progress if it is interrupted, segments are missing
  Segment_tree(std::vector<Segment> segments, Progress& progress) : m_segments(std::move(segments))
  {
    std::vector<Axis_parallel_box<double>> boxes(m_segments.size());
    for (std::size_t i = 0; i < m_segments.size(); ++i)
      for (const Point_3& p : m_segments[i])
        boxes[i].extend(p);
    m_tree = Box_tree<double>(boxes, progress);
  }

  /// \param hint the number of a segment: the closer it is to p, the faster
  /// \pre there are segments
  Foot foot(const Point_3& p, const std::size_t hint = 0) const
  {
    const auto [distance, i] = m_tree.closest({p.x(), p.y(), p.z()}, {squared_distance(p, hint), hint},
                                              [&](const std::size_t j) { return squared_distance(p, j); });
    return {distance, i};
  }

  /// The point of a segment that is closest to p.
  Point_3 closest_point(const Point_3& p, const std::size_t i) const
  {
    return closest_of_segment(p, m_segments[i][0], m_segments[i][1]);
  }

  double squared_distance(const Point_3& p, const std::size_t i) const
  {
    return CGAL::squared_distance(p, closest_point(p, i));
  }

private:
  std::vector<Segment> m_segments;
  Box_tree<double> m_tree;
};

/// The chords of arcs, which have a source and a target.
template <typename Arc>
std::vector<Segment_tree::Segment> chords(const std::vector<Arc>& arcs)
{
  std::vector<Segment_tree::Segment> result;
  result.reserve(arcs.size());
  for (const Arc& arc : arcs)
    result.push_back({arc.source(), arc.target()});
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_SEGMENT_TREE_H
