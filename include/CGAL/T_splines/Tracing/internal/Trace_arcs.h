// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_TRACE_ARCS_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_TRACE_ARCS_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/Vertex_stars.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The pieces of traces between nodes, and what leaves each node.
///
/// Every node has slots, counter-clockwise, one per isoline through it: four on a crossing of traces, as many as the
/// star has at a vertex. The slots of a crossing node refer to the chart of its chord, those of a star to the chart of
/// the corner in which the ray lies. An arc leaves the chart of a slot and arrives in the chart of a slot.
///
/// An arc has two half-arcs, numbered as the halfedges of an edge are: the first runs along it and has its left side on
/// its left, the second runs against it.
template <typename FT, typename TracingTraits>
class Trace_arcs {
  using Layout = Seamless_layout<FT>;
  using Traces = Motorcycle_traces<FT>;
  using Stars = Vertex_stars<FT, TracingTraits>;
  using Chord = typename Traces::Chord;
  using Visit = typename Traces::Visit;

public:
  using Number = Enclosed_number<FT>;
  static constexpr int none = -1;

  struct Arc {
    int start_node, start_slot, end_node, end_slot;
    int first_chord, last_chord; ///< positions in the chords of its trace
    int trace;
    FT length; ///< in units of the chart where it starts
    FT scale;  ///< of the way from the chart where it starts to the chart where it ends
    int first_segment, last_segment;
  };

  /// A part of an arc in which the chart does not change.
  struct Segment {
    int arc;
    FT start; ///< the coordinate along the line of the start of the arc, as this chart sees it
    FT scale; ///< of the way from the chart where the arc starts to this one
  };

  /// \param progress if it is interrupted, arcs are missing
  Trace_arcs(const Layout& layout, const Stars& stars, const Traces& traces, const TracingTraits& traits,
             Progress& progress)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_stars(stars),
      m_traces(traces),
      m_traits(traits),
      m_segment_of_chord(traces.chords.size(), none)
  {
    for (int s = 0; s < stars.number_of_stars(); ++s)
      m_half_arc_of_ray.resize(m_half_arc_of_ray.size() + stars.star(s).number_of_rays, none);
    m_half_arc_of_crossing.assign(4 * traces.nodes.size(), none);
    for (std::size_t t = 0; t < traces.traces.size(); ++t) {
      if (!progress.go_on_after(5 * (traces.traces[t].chords.size() + traces.traces[t].visits.size())))
        return;
      add_arcs(static_cast<int>(t));
    }
  }

  const std::vector<Arc>& arcs() const { return m_arcs; }
  const Segment& segment(const int s) const { return m_segments[s]; }
  int number_of_segments() const { return static_cast<int>(m_segments.size()); }

  /// The half-arc of a segment that has the left or the right side of its arc on its left.
  int half_arc_beside(const int s, const bool is_left) const
  {
    return halfedges_of_edge(m_segments[s].arc)[is_left ? 0 : 1];
  }

  /// The segment in which a chord leaves its face.
  int segment_of_chord(const int c) const { return m_segment_of_chord[c]; }

  int number_of_slots(const int node) const { return Traces::is_star(node) ? star_at(node).number_of_rays : 4; }

  /// The half-arc that leaves a node by a slot, or none.
  int leaving(const int node, const int slot) const
  {
    return Traces::is_star(node) ? m_half_arc_of_ray[star_at(node).first_ray + slot]
                                 : m_half_arc_of_crossing[4 * Traces::crossing_of_node(node) + slot];
  }

  int start_node(const int half_arc) const
  {
    return is_along_edge(half_arc) ? arc(half_arc).start_node : arc(half_arc).end_node;
  }
  int start_slot(const int half_arc) const
  {
    return is_along_edge(half_arc) ? arc(half_arc).start_slot : arc(half_arc).end_slot;
  }
  int end_node(const int half_arc) const { return start_node(opposite(half_arc)); }
  int end_slot(const int half_arc) const { return start_slot(opposite(half_arc)); }

  /// The length of a half-arc in units of the chart where it starts.
  FT length(const int half_arc) const
  {
    const Arc& a = arc(half_arc);
    return is_along_edge(half_arc) || a.scale == 1 ? a.length : FT(a.length * a.scale);
  }

  // A unit is the scale from a chart to something that stays: it changes with the chart.

  /// From the unit of the chart where a half-arc starts to that of the chart where it ends.
  void carry_unit_along(const int half_arc, FT& unit) const
  {
    if (arc(half_arc).scale == 1)
      return;
    if (is_along_edge(half_arc))
      unit /= arc(half_arc).scale;
    else
      unit *= arc(half_arc).scale;
  }

  /// From the unit of the chart of a slot to that of the next one, clockwise, around the node. \pre no border
  void carry_unit_clockwise(const int node, const int slot, FT& unit) const
  {
    if (Traces::is_star(node))
      m_stars.for_each_scale_clockwise(Traces::star_of_node(node), slot, [&](const FT& scale) { unit /= scale; });
  }

  /// Whether the next slot, clockwise, lies beyond a border.
  bool is_border_next(const int node, const int slot) const
  {
    if (Traces::is_star(node))
      return slot == 0 && star_at(node).is_on_border;
    const Chord& chord = m_traces.chords[crossing_at(node).chord]; // a border chord has the surface on its left
    return chord.is_along && slot == chord.direction && m_mesh.face(opposite(chord.halfedge)) == none;
  }
  int next_slot_clockwise(const int node, const int slot) const
  {
    return slot == 0 ? number_of_slots(node) - 1 : slot - 1;
  }

  /// Whether a node has only two arcs, which go straight through it.
  bool is_straight(const int node) const
  {
    const int n = number_of_slots(node);
    const bool is_border = Traces::is_star(node) && star_at(node).is_on_border;
    if (n != (is_border ? 3 : 4))
      return false;
    int first = none, count = 0;
    for (int slot = n - 1; slot >= 0; --slot)
      if (leaving(node, slot) != none) {
        first = slot;
        ++count;
      }
    return count == 2 && first + 2 < n && leaving(node, first + 2) != none;
  }

  // Along-coordinate and across-coordinate of the node of a slot, in the chart of the slot.
  std::pair<FT, FT> coordinates_at_slot(const int node, const int slot) const
  {
    if (Traces::is_star(node)) {
      const int corner = m_stars.corner_of_ray(Traces::star_of_node(node), slot);
      return {m_layout.coordinate(corner, 0).value(), m_layout.coordinate(corner, 1).value()};
    }
    const typename Traces::Crossing_node& crossing = crossing_at(node);
    const Chord& chord = m_traces.chords[crossing.chord];
    std::pair<FT, FT> result(crossing.along.value(), chord.line.value());
    if (axis_along(chord.direction) == 1)
      std::swap(result.first, result.second);
    return result;
  }

  /// The direction of a slot in its chart.
  int direction_of_slot(const int node, const int slot) const
  {
    return Traces::is_star(node) ? m_stars.ray(Traces::star_of_node(node), slot).direction : slot;
  }

private:
  const Arc& arc(const int half_arc) const { return m_arcs[edge_of(half_arc)]; }
  const typename Stars::Star& star_at(const int node) const { return m_stars.star(Traces::star_of_node(node)); }
  const typename Traces::Crossing_node& crossing_at(const int node) const
  {
    return m_traces.nodes[Traces::crossing_of_node(node)];
  }

  std::vector<Visit> sorted_visits(const int trace) const
  {
    std::vector<Visit> visits = m_traces.traces[trace].visits;
    const auto precedes = [&](const Visit& a, const Visit& b) {
      if (a.chord == none || b.chord == none)
        return a.chord == none && b.chord != none;
      if (a.chord != b.chord)
        return m_traces.chords[a.chord].ordinal < m_traces.chords[b.chord].ordinal;
      if (a.is_at_end || b.is_at_end)
        return !a.is_at_end && b.is_at_end;
      const CGAL::Comparison_result order = m_traits.compare(crossing_at(a.node).along, crossing_at(b.node).along);
      return order == (is_forward(m_traces.chords[a.chord].direction) ? CGAL::SMALLER : CGAL::LARGER);
    };
    std::stable_sort(visits.begin(), visits.end(), precedes);
    return visits;
  }

  void add_arcs(const int trace)
  {
    const std::vector<Visit> visits = sorted_visits(trace);
    for (std::size_t i = 0; i + 1 < visits.size(); ++i)
      add_arc(trace, visits[i], visits[i + 1], i + 2 == visits.size());
  }

  const Chord& chord_of(const int trace, const int position) const
  {
    return m_traces.chords[m_traces.traces[trace].chords[position]];
  }

  // The coordinate along the first chord of an arc where it starts; `position` becomes that of the chord.
  FT start_of_arc(const int trace, const Visit& visit, int& position, FT& scale) const
  {
    const bool is_new_chord = visit.chord == none || visit.is_at_end;
    position = visit.chord == none ? 0 : m_traces.chords[visit.chord].ordinal + (visit.is_at_end ? 1 : 0);
    const Chord& chord = chord_of(trace, position);
    if (Traces::is_star(visit.node)) {
      const int corner = m_stars.corner_of_ray(Traces::star_of_node(visit.node), visit.departure);
      return m_layout.coordinate(corner, axis_along(chord.direction)).value();
    }
    if (visit.chord == none)
      return m_traces.coordinates[chord.start].value();
    const FT along = crossing_at(visit.node).along.value();
    return is_new_chord ? across(m_traces.chords[visit.chord], along, scale) : along;
  }

  // What happens to a coordinate along a chord, and to the scale, where the trace leaves the face of the chord.
  FT across(const Chord& chord, const FT& along, FT& scale) const
  {
    if (!m_layout.is_cut(edge_of(chord.halfedge)))
      return along;
    const Similarity_2<FT>& transition = m_layout.transition(chord.halfedge);
    if (transition.scale() != 1)
      scale *= transition.scale();
    return transformed_coordinate(transition, chord.direction, along);
  }

  // The coordinate along a chord where its trace visits a node, and the scale from there to the chart of the slot.
  FT end_of_arc(const Chord& chord, const Visit& visit, const bool is_last, FT& scale) const
  {
    const int axis = axis_along(chord.direction);
    if (Traces::is_star(visit.node)) {
      if (chord.is_along && m_layout.is_cut(edge_of(chord.halfedge)) && m_mesh.face(opposite(chord.halfedge)) != none)
        scale *= m_layout.transition(chord.halfedge).scale(); // the ray at the end is seen from the other side
      return m_layout.coordinate(chord.halfedge, axis).value();
    }
    const typename Traces::Crossing_node& node = crossing_at(visit.node);
    const Chord& other = m_traces.chords[node.chord];
    if (!is_last || &other == &chord)
      return node.along.value();
    if (chord.halfedge == none || chord.halfedge == other.halfedge || !m_layout.is_cut(edge_of(chord.halfedge)))
      return chord.stop != none ? m_traces.coordinates[chord.stop].value() : node.along.value();
    if (chord.stop == none) { // they met head-on: the coordinate is given on the other side
      const FT along =
          transformed_coordinate(m_layout.transition(opposite(chord.halfedge)), other.direction, node.along.value());
      scale *= m_layout.transition(chord.halfedge).scale();
      return along;
    }
    scale *= m_layout.transition(chord.halfedge).scale();
    return m_traces.coordinates[chord.stop].value();
  }

  void add_arc(const int trace, const Visit& start, const Visit& end, const bool is_last)
  {
    const int a = static_cast<int>(m_arcs.size()), last = m_traces.chords[end.chord].ordinal;
    FT scale(1), along;
    int position = 0;
    along = start_of_arc(trace, start, position, scale);
    Arc arc = {start.node, start.departure, end.node, end.arrival, position, last, trace, FT(0), FT(1), 0, 0};
    arc.first_segment = static_cast<int>(m_segments.size());
    m_segments.push_back({a, along, scale});
    for (; position < last; ++position) {
      const Chord& chord = chord_of(trace, position);
      m_segment_of_chord[m_traces.traces[trace].chords[position]] = static_cast<int>(m_segments.size()) - 1;
      if (m_layout.is_cut(edge_of(chord.halfedge))) {
        along = across(chord, along, scale);
        m_segments.push_back({a, along, scale});
      }
    }
    m_segment_of_chord[end.chord] = arc.last_segment = static_cast<int>(m_segments.size()) - 1;
    const Chord& chord = m_traces.chords[end.chord];
    FT end_scale = scale;
    const FT at_end = end_of_arc(chord, end, is_last, end_scale);
    arc.length = (is_forward(chord.direction) ? FT(at_end - along) : FT(along - at_end));
    if (scale != 1)
      arc.length /= scale;
    arc.scale = end_scale;
    m_arcs.push_back(arc);
    occupy(start.node, start.departure, halfedge_of_edge(a));
    occupy(end.node, end.arrival, opposite(halfedge_of_edge(a)));
  }

  void occupy(const int node, const int slot, const int half_arc)
  {
    (Traces::is_star(node) ? m_half_arc_of_ray[star_at(node).first_ray + slot]
                           : m_half_arc_of_crossing[4 * Traces::crossing_of_node(node) + slot]) = half_arc;
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  const Stars& m_stars;
  const Traces& m_traces;
  const TracingTraits& m_traits;
  std::vector<Arc> m_arcs;
  std::vector<Segment> m_segments;
  std::vector<int> m_segment_of_chord;
  std::vector<int> m_half_arc_of_ray, m_half_arc_of_crossing;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_TRACE_ARCS_H
