// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_SPIRAL_DETECTION_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_SPIRAL_DETECTION_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Tells which traces may be without end: those that come back to an edge in the same direction on a smaller scale, as
/// a spiral does that tends to a closed isoline, or `maximal_passes` times on any scale.
///
/// Logarithms of scales are summed up in fixed point, so that a scale and its inverse cancel. They are not exact, which
/// does no harm: a trace that gets a seed without need is cut by it, and no more.
template <typename FT>
class Spiral_detection {
public:
  static constexpr int maximal_passes = 4096;

  explicit Spiral_detection(const Seamless_layout<FT>& layout) : m_layout(layout)
  {
    for (int b = 0; b < layout.number_of_branches(); ++b) {
      const double scale = CGAL::to_double(layout.transition_of_branch(b).scale());
      m_log_scale.push_back(static_cast<std::int64_t>(std::llround(std::ldexp(std::log(scale), fraction_bits))));
    }
  }

  /// The logarithm of the scale of the transition from the face of h to that of its opposite.
  std::int64_t log_scale_across(const int h) const
  {
    if (!m_layout.is_cut(edge_of(h)))
      return 0;
    const std::int64_t log_scale = m_log_scale[m_layout.branch(edge_of(h))];
    return m_layout.is_along_branch(h) ? log_scale : -log_scale;
  }

  /// Takes note of the next crossing of an edge. \param log_scale of the trace's chart before it, against that of its start
  void add_crossing(const std::int64_t log_scale) { m_scale_at_crossing.push_back(log_scale); }

  /// Whether a trace comes back to an edge too often.
  /// \param crossing the last one, leaving a face through h
  /// \param first_chord only crossings at the ends of this chord of the trace and later ones count
  bool is_endless(const Motorcycle_traces<FT>& traces, const int crossing, const int h, const int first_chord) const
  {
    const int side = side_of_edge(h), direction = traces.crossings[crossing].direction[side];
    const int trace = traces.chords[traces.crossings[crossing].chord].trace;
    int passes = 0;
    for (int r = traces.crossings[crossing].next_on_edge; r != traces.none; r = traces.crossings[r].next_on_edge) {
      const typename Motorcycle_traces<FT>::Edge_crossing& record = traces.crossings[r];
      if (traces.chords[record.chord].trace != trace || record.direction[side] != direction)
        continue;
      if (traces.chords[record.chord].ordinal < first_chord)
        break; // the crossings of an edge are listed from the last one to the first
      if (++passes >= maximal_passes || m_scale_at_crossing[crossing] < m_scale_at_crossing[r] - round_off)
        return true;
    }
    return false;
  }

private:
  static constexpr int fraction_bits = 40;
  static constexpr std::int64_t round_off = 64; // scales that differ by less count as equal

  const Seamless_layout<FT>& m_layout;
  std::vector<std::int64_t> m_log_scale;         // per branch
  std::vector<std::int64_t> m_scale_at_crossing; // per crossing
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_SPIRAL_DETECTION_H
