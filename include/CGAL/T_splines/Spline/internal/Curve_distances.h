// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CURVE_DISTANCES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CURVE_DISTANCES_H

#include <CGAL/T_splines/Spline/internal/Distance_sum.h>
#include <CGAL/T_splines/Spline/internal/Largest_distance.h>
#include <CGAL/T_splines/Spline/internal/Segment_tree.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A straight arc: an edge of a mesh, or a part of one.
struct Straight_arc {
  using Point_3 = Triangle_set::Point_3;

  Point_3 from, to;
  std::size_t curve; ///< the number of the edge

  const Point_3& source() const { return from; }
  const Point_3& target() const { return to; }
  double length() const { return std::sqrt(CGAL::squared_distance(from, to)); }
  static double sagitta() { return 0; }
  std::array<Straight_arc, 2> halves() const
  {
    const Point_3 middle = CGAL::midpoint(from, to);
    return {Straight_arc{from, middle, curve}, Straight_arc{middle, to, curve}};
  }
};

/// Measures the distances of curves from segments.
///
/// The curves are divided into short arcs; distances are measured at their ends and middles. Then the arcs whose bounds
/// exceed the largest distance are halved. There are two bounds for the chord, which the arc is near to. (1) Distances
/// change by no more than the point moves. (2) The distance from a segment is a convex function: it is largest at an end
/// of the chord.
/// \tparam Arc has `source()`, `target()`, `sagitta()` and `halves()`: a `Straight_arc` or `Cubic_arc`
template <typename Arc>
class Curve_distances {
public:
  using Point_3 = Triangle_set::Point_3;

  /// A point of a curve and the segment that is closest.
  struct Sample {
    Point_3 point;
    Arc arc; ///< the point is one of its ends, or the middle
    Segment_tree::Foot foot;
  };

  /// \param negligible distances that need not be told apart
  /// \param progress it must outlive this; if it is interrupted, what was measured means nothing
  Curve_distances(const Segment_tree& segments, const double negligible, Progress& progress)
    : m_segments(segments),
      m_progress(progress),
      m_largest(negligible)
  {
  }

  /// Calls `visit(sample)` for all samples.
  /// \param size arcs that are longer, or more curved, are halved
  template <typename Visit>
  void measure(const std::vector<Arc>& arcs, const double size, Distance_sum& sum, const Visit& visit)
  {
    std::vector<Part> stack;
    std::size_t hint = 0;
    for (const Arc& arc : arcs) {
      const Segment_tree::Foot first = measured(arc.source(), arc, hint, visit);
      stack.push_back({arc, {first, measured(arc.target(), arc, first.segment, visit)}, 0});
      hint = stack.back().feet[1].segment;
      while (!stack.empty() && m_progress.go_on_after(work_per_arc)) {
        const Part part = std::move(stack.back());
        stack.pop_back();
        std::array<Part, 2> halves = bisected(part, visit);
        if (is_longer(part.arc, size) && can_be_halved(part, halves)) {
          stack.push_back(std::move(halves[1])); // the first one is next
          stack.push_back(std::move(halves[0]));
          continue;
        }
        // Simpson's rule is exact as long as the same segment is closest.
        const double length = length_of_chord(halves[0].arc) + length_of_chord(halves[1].arc);
        sum.add(length / 6, part.feet[0].distance());
        sum.add(length * 2 / 3, halves[0].feet[1].distance());
        sum.add(length / 6, part.feet[1].distance());
        for (Part& half : halves)
          m_largest.add(std::move(half));
      }
      if (m_progress.is_interrupted())
        return;
    }
  }

  /// Looks for the largest distance. \param number_of_steps the most arcs that are halved
  template <typename Visit>
  void search(std::size_t number_of_steps, const Visit& visit)
  {
    for (; number_of_steps > 0 && m_largest.has_open_part() && m_progress.go_on_after(work_per_arc);
         --number_of_steps) {
      const Part part = m_largest.take();
      std::array<Part, 2> halves = bisected(part, visit);
      if (!can_be_halved(part, halves)) {
        m_largest.leave_out(part.bound);
        continue;
      }
      for (Part& half : halves) {
        half.bound = (std::min)(half.bound, part.bound);
        m_largest.add(std::move(half));
      }
    }
  }

  double upper_bound() const { return m_largest.upper_bound(); }
  const Sample& farthest() const { return m_farthest; }

private:
  static constexpr std::size_t work_per_arc = 20;

  struct Part {
    Arc arc;
    std::array<Segment_tree::Foot, 2> feet; // of the ends
    double bound;
  };

  template <typename Visit>
  Segment_tree::Foot measured(const Point_3& p, const Arc& arc, const std::size_t hint, const Visit& visit)
  {
    const Sample sample{p, arc, m_segments.foot(p, hint)};
    if (m_largest.offer(sample.foot.distance()))
      m_farthest = sample;
    visit(sample);
    return sample.foot;
  }

  template <typename Visit>
  std::array<Part, 2> bisected(const Part& part, const Visit& visit)
  {
    const auto arcs = part.arc.halves();
    const Segment_tree::Foot middle = measured(arcs[0].target(), part.arc, part.feet[0].segment, visit);
    std::array<Part, 2> halves{Part{arcs[0], {part.feet[0], middle}, 0}, Part{arcs[1], {middle, part.feet[1]}, 0}};
    for (Part& half : halves)
      half.bound = bound(half);
    return halves;
  }

  static double length_of_chord(const Arc& arc)
  {
    return std::sqrt(CGAL::squared_distance(arc.source(), arc.target()));
  }

  static bool is_longer(const Arc& arc, const double size)
  {
    const double sagitta = arc.sagitta();
    return length_of_chord(arc) > size || (sagitta > size && std::isfinite(sagitta));
  }

  // Unless round-off does not allow it.
  static bool can_be_halved(const Part& part, const std::array<Part, 2>& halves)
  {
    const Point_3 middle = halves[0].arc.target();
    return middle != part.arc.source() && middle != part.arc.target();
  }

  double bound(const Part& part) const
  {
    const Point_3 a = part.arc.source(), b = part.arc.target();
    double result = (part.feet[0].distance() + part.feet[1].distance() + length_of_chord(part.arc)) / 2;
    for (const Segment_tree::Foot& foot : part.feet)
      result = (std::min)(result, std::sqrt((std::max)(m_segments.squared_distance(a, foot.segment),
                                                       m_segments.squared_distance(b, foot.segment))));
    return result + part.arc.sagitta();
  }

  const Segment_tree& m_segments;
  Progress& m_progress;
  Sample m_farthest;
  Largest_distance<Part> m_largest;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CURVE_DISTANCES_H
