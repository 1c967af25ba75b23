// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_CELL_PLACES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_CELL_PLACES_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/Tracing_traits.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_graph.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Finds the cell of each vertex of the map, and the similarity from the vertex's chart to the frame of the cell.
///
/// The crossings of traces with edges tell in which cells the ends of these edges lie; along edges that no trace
/// crosses the cell does not change. Linear time; a similarity is composed once per cell and piece of a chart.
template <typename FT, typename TracingTraits>
class Cell_places {
  using Graph = Motorcycle_graph<FT, TracingTraits>;
  using Layout = typename Graph::Layout;
  using Stars = typename Graph::Stars;
  using Traces = typename Graph::Traces;
  using Arcs = typename Graph::Arcs;
  using Cells = typename Graph::Cells;
  using Chord = typename Traces::Chord;

public:
  static constexpr int none = -1;

  /// A piece of a chart in a cell.
  struct Frame {
    int face;
    Similarity_2<FT> to_face;
  };

  /// The place of a vertex: its corner `halfedge`, seen in a frame.
  struct Place {
    int frame = none;
    int halfedge = none; ///< with the vertex as target; its face has the chart of the frame
  };

  /// \param progress if it is interrupted, places are missing
  Cell_places(const Graph& graph, Progress& progress)
    : m_layout(graph.layout()),
      m_mesh(graph.layout().mesh()),
      m_stars(graph.stars()),
      m_traces(graph.traces()),
      m_arcs(graph.arcs()),
      m_cells(graph.cells()),
      m_traits(graph.traits()),
      m_places(m_mesh.number_of_vertices()),
      m_frames_beside(2 * m_arcs.number_of_segments(), none)
  {
    place_vertices_of_traces(progress);
    for (int e = 0; e < m_mesh.number_of_edges() && progress.go_on_after(2); ++e)
      if (m_traces.first_crossing_of_edge[e] != none)
        place_ends_of_crossed_edge(e);
    for (std::size_t i = 0; i < m_queue.size() && progress.go_on_after(10); ++i)
      place_neighbors(m_queue[i]);
  }

  const Place& place(const int vertex) const { return m_places[vertex]; }
  const Frame& frame(const int f) const { return m_frames[f]; }
  int number_of_frames() const { return static_cast<int>(m_frames.size()); }

private:
  int add_frame(const int face, Similarity_2<FT> to_face)
  {
    m_frames.push_back({face, std::move(to_face)});
    return number_of_frames() - 1;
  }

  /// The frame on the left of the half-arc that leaves a slot, for the chart of the slot.
  int frame_at_slot(const int node, const int slot)
  {
    const int half_arc = m_arcs.leaving(node, slot);
    const int face = m_cells.halfedge(m_cells.part(half_arc).halfedge).face;
    return add_frame(face, m_cells.frame(half_arc, m_arcs.direction_of_slot(node, slot),
                                         m_arcs.coordinates_at_slot(node, slot), FT(1)));
  }

  int frame_across(const int frame, const int h) // from the chart of the face of h to that of its opposite
  {
    if (!m_layout.is_cut(edge_of(h)))
      return frame;
    const bool is_along = m_layout.is_along_branch(h);
    const std::uint64_t key = static_cast<std::uint64_t>(frame) * (2 * m_layout.number_of_branches()) +
                              2 * m_layout.branch(edge_of(h)) + (is_along ? 0 : 1);
    const auto found = m_neighbor_frames.find(key);
    if (found != m_neighbor_frames.end())
      return found->second;
    const int neighbor =
        add_frame(m_frames[frame].face, compose(m_frames[frame].to_face, m_layout.transition(opposite(h))));
    m_neighbor_frames.emplace(key, neighbor);
    return neighbor;
  }

  bool is_on_trace(const int v) const
  {
    return m_stars.has_star(v) && has_arc(Traces::star_node(m_stars.existing_star(v)));
  }
  bool has_arc(const int node) const
  {
    for (int slot = 0; slot < m_arcs.number_of_slots(node); ++slot)
      if (m_arcs.leaving(node, slot) != none)
        return true;
    return false;
  }

  void set_place(const int vertex, const int frame, const int halfedge)
  {
    if (m_places[vertex].frame != none || is_on_trace(vertex))
      return;
    m_places[vertex] = {frame, halfedge};
    m_queue.push_back(vertex);
  }

  bool is_free(const int h) const
  {
    return m_traces.first_crossing_of_edge[edge_of(h)] == none && m_traces.first_chord_along_edge[edge_of(h)] == none;
  }

  // --- vertices on traces, and their neighbors

  void place_vertices_of_traces(Progress& progress)
  {
    for (int s = 0; s < m_stars.number_of_stars() && progress.go_on_after(100); ++s) {
      const int v = m_stars.star(s).vertex, node = Traces::star_node(s), n = m_arcs.number_of_slots(node);
      std::vector<int> frames(n, none);
      for (int slot = 0; slot < n; ++slot)
        if (m_arcs.leaving(node, slot) != none && !(m_stars.star(s).is_on_border && slot == n - 1)) {
          frames[slot] = frame_at_slot(node, slot);
          const int corner = m_mesh.previous(m_stars.ray(s, slot).halfedge);
          if (m_places[v].frame == none)
            m_places[v] = {frames[slot], corner};
        }
      if (m_places[v].frame != none)
        place_neighbors_of_star(s, frames);
    }
  }

  // Goes once around the vertex, counter-clockwise, with the frame of the cell that each halfedge enters.
  void place_neighbors_of_star(const int s, const std::vector<int>& frames)
  {
    const auto first = std::find_if(frames.begin(), frames.end(), [](const int frame) { return frame != none; });
    const int begin = m_stars.ray(s, static_cast<int>(first - frames.begin())).halfedge;
    int frame = none, h = begin;
    const auto pass_rays = [&](const bool is_along) {
      for (int slot = 0; slot < static_cast<int>(frames.size()); ++slot)
        if (frames[slot] != none && m_stars.ray(s, slot).halfedge == h && m_stars.ray(s, slot).is_along == is_along)
          frame = frames[slot];
    };
    const auto place_target = [&]() {
      if (frame != none && is_free(h))
        set_place(m_mesh.target(h), frame, h);
    };
    do {
      pass_rays(true);
      place_target();
      pass_rays(false);
      const int last = m_mesh.previous(h);
      if (m_mesh.face(opposite(last)) == none)
        return; // on the border all vertices lie on traces
      if (frame != none)
        frame = frame_across(frame, last);
      h = opposite(last);
    } while (h != begin);
    place_target(); // before the first ray, which lies behind its halfedge
  }

  // --- edges that are crossed

  /// Whether crossing a comes before crossing b on the even halfedge of their edge.
  bool precedes(const int a, const int b, const int e) const
  {
    const int h = halfedge_of_edge(e), last = m_mesh.face(h) == none ? none : m_mesh.previous(h);
    const typename Traces::Edge_crossing &x = m_traces.crossings[a], &y = m_traces.crossings[b];
    const int axis = axis_across(x.direction[0]);
    const CGAL::Comparison_result course =
        m_traits.compare(m_layout.coordinate(last, axis), m_layout.coordinate(h, axis));
    if (axis == axis_across(y.direction[0]))
      return m_traits.compare(x.line[0], y.line[0]) == course;
    // the crossing of the two lines lies beyond the edge on the side that tells the order
    const Enclosed_point<FT> p = corner(last), q = corner(h);
    const Enclosed_point<FT> meeting =
        axis == 0 ? Enclosed_point<FT>{x.line[0], y.line[0]} : Enclosed_point<FT>{y.line[0], x.line[0]};
    const CGAL::Sign side = m_traits.orientation(p, q, meeting);
    const CGAL::Sign other_course =
        m_traits.compare(m_layout.coordinate(last, 1 - axis), m_layout.coordinate(h, 1 - axis));
    // On a halfedge towards +u and +v, the corner (u of x, v of y) lies on its left if x comes first and x is a u-line.
    const CGAL::Sign turn = course * other_course * (axis == 0 ? 1 : -1) > 0 ? side : -side;
    return turn == CGAL::POSITIVE;
  }

  Enclosed_point<FT> corner(const int h) const { return {m_layout.coordinate(h, 0), m_layout.coordinate(h, 1)}; }

  void place_ends_of_crossed_edge(const int e)
  {
    int first = m_traces.first_crossing_of_edge[e], last = first;
    for (int r = m_traces.crossings[first].next_on_edge; r != none; r = m_traces.crossings[r].next_on_edge) {
      if (precedes(r, first, e))
        first = r;
      if (precedes(last, r, e))
        last = r;
    }
    place_end_beyond(first, opposite(halfedge_of_edge(e)));
    place_end_beyond(last, halfedge_of_edge(e));
  }

  /// Places the target of h, which no trace separates from the crossing.
  void place_end_beyond(const int crossing, const int h)
  {
    const int v = m_mesh.target(h);
    if (m_places[v].frame != none || is_on_trace(v))
      return;
    const typename Traces::Edge_crossing& record = m_traces.crossings[crossing];
    const Chord& chord = m_traces.chords[record.chord];
    const int g = chord.halfedge; // in whose face the chord lies
    int frame = none;
    if (record.node == none) {
      frame = frame_beside(m_arcs.segment_of_chord(record.chord), chord, h == g);
    }
    else
      frame = frame_at_crossing(Traces::crossing_node(record.node), g, h == g);
    if (frame == none)
      return;
    if (h == g)
      set_place(v, frame, g);
    else
      set_place(v, frame, m_mesh.previous(g));
  }

  /// The frame of the cell on the left or on the right of a chord, for its chart.
  int frame_beside(const int s, const Chord& chord, const bool is_left)
  {
    int& frame = m_frames_beside[2 * s + (is_left ? 0 : 1)];
    if (frame != none)
      return frame;
    const int half_arc = m_arcs.half_arc_beside(s, is_left),
              face = m_cells.halfedge(m_cells.part(half_arc).halfedge).face;
    return frame = add_frame(face, m_cells.frame_beside(s, chord, is_left));
  }

  /// The frame of the cell that the edge of g, where the node is, enters; none if an arc goes along it.
  int frame_at_crossing(const int node, const int g, const bool is_to_target)
  {
    const int from = is_to_target ? m_mesh.previous(g) : g, to = is_to_target ? g : m_mesh.previous(g);
    const int u = m_traits.compare(m_layout.coordinate(to, 0), m_layout.coordinate(from, 0));
    const int v = m_traits.compare(m_layout.coordinate(to, 1), m_layout.coordinate(from, 1));
    int slot = 0; // the direction at or before that of the edge
    if (u > 0 && v >= 0)
      slot = 0;
    else if (u <= 0 && v > 0)
      slot = 1;
    else if (u < 0 && v <= 0)
      slot = 2;
    else
      slot = 3;
    if ((u == 0 || v == 0) && m_arcs.leaving(node, slot) != none)
      return none;
    while (m_arcs.leaving(node, slot) == none)
      slot = turned(slot, -1);
    return frame_at_slot(node, slot);
  }

  // --- edges that are not crossed

  void place_neighbors(const int v)
  {
    int frame = m_places[v].frame;
    const int first = m_mesh.next(m_places[v].halfedge);
    int h = first;
    do {
      if (is_free(h))
        set_place(m_mesh.target(h), frame, h);
      const int last = m_mesh.previous(h);
      frame = frame_across(frame, last);
      h = opposite(last);
    } while (h != first);
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  const Stars& m_stars;
  const Traces& m_traces;
  const Arcs& m_arcs;
  const Cells& m_cells;
  const TracingTraits& m_traits;
  std::vector<Place> m_places; // per vertex
  std::vector<Frame> m_frames;
  std::vector<int> m_queue;
  std::unordered_map<std::uint64_t, int> m_neighbor_frames;
  std::vector<int> m_frames_beside; // per segment and side
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_CELL_PLACES_H
