// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_CELLS_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_CELLS_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/Trace_arcs.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/exactness.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The T-mesh of a motorcycle graph in index arrays: its edges are the chains of arcs between nodes that are more than
/// a place where one line goes straight on.
///
/// Knot intervals and frames need no composition of transitions: the frame of a face is carried along its boundary by
/// lengths, directions and scales alone.
template <typename FT, typename TracingTraits>
class Motorcycle_cells {
  using Arcs = Trace_arcs<FT, TracingTraits>;
  using Traces = Motorcycle_traces<FT>;

public:
  static constexpr int none = -1;

  struct Halfedge {
    int first_half_arc, last_half_arc;
    int source, target; ///< vertices of the T-mesh
    int next = none, face = none;
    bool is_corner = false;  ///< at its target
    FT knot = FT(0);         ///< in the face's units
    int side = 0;            ///< direction in the frame of the face
    FT u = FT(0), v = FT(0); ///< of its source in the frame of the face
  };

  /// A half-arc as a part of a halfedge.
  struct Part {
    int halfedge = none;
    FT offset = FT(0); ///< from the source of the halfedge, in the units of its face
    FT scale = FT(1);  ///< from the chart where the half-arc starts to the face
  };

  /// \param arcs all of them
  /// \param progress if it is interrupted, this is no T-mesh
  Motorcycle_cells(const Arcs& arcs, Progress& progress) : m_arcs(arcs), m_parts(2 * arcs.arcs().size())
  {
    if (!progress.go_on() || !is_graph())
      return;
    find_vertices();
    for (std::size_t v = 0; v < m_nodes.size(); ++v)
      for (int slot = 0; slot < arcs.number_of_slots(m_nodes[v]); ++slot)
        if (arcs.leaving(m_nodes[v], slot) != none)
          add_edge(arcs.leaving(m_nodes[v], slot));
    m_is_t_mesh = progress.go_on() && join_halfedges();
    for (int h = 0; h < number_of_halfedges() && m_is_t_mesh; ++h)
      if (m_halfedges[h].face == none && !m_is_border[h] && m_halfedges[h].is_corner)
        m_is_t_mesh = progress.go_on_after(200) && add_face(m_halfedges[h].next);
    for (int h = 0; h < number_of_halfedges() && m_is_t_mesh; ++h)
      m_is_t_mesh = m_is_border[h] || m_halfedges[h].face != none;
  }

  /// Whether all faces are rectangles. With exact predicates and a seamless map they are.
  bool is_t_mesh() const { return m_is_t_mesh; }

  int number_of_vertices() const { return static_cast<int>(m_nodes.size()); }
  int number_of_halfedges() const { return static_cast<int>(m_halfedges.size()); }
  int number_of_edges() const { return number_of_halfedges() / 2; }
  int number_of_faces() const { return static_cast<int>(m_face_halfedge.size()); }
  int node_of_vertex(const int v) const { return m_nodes[v]; }

  /// Halfedges 2e and 2e + 1 are opposite.
  const Halfedge& halfedge(const int h) const { return m_halfedges[h]; }
  bool is_border(const int h) const { return m_is_border[h] != 0; }
  int halfedge_of_face(const int f) const { return m_face_halfedge[f]; }
  const Part& part(const int half_arc) const { return m_parts[half_arc]; }

  /// The half-arc after one inside the same edge; none at its end.
  int next_part(const int half_arc) const
  {
    return half_arc == m_halfedges[m_parts[half_arc].halfedge].last_half_arc ? none : continuation(half_arc);
  }

  /// The similarity from a chart to the frame of the face on the left of a half-arc.
  /// \param direction, coordinates of the half-arc's start in the chart
  /// \param scale of the way from the chart where the half-arc starts to this one
  Similarity_2<FT> frame(const int half_arc, const int direction, const std::pair<FT, FT>& start, const FT& scale) const
  {
    const Part& part = m_parts[half_arc];
    const Halfedge& h = m_halfedges[part.halfedge];
    const Similarity_2<FT> linear(h.side - direction, part.scale / scale, FT(0), FT(0));
    const std::pair<FT, FT> image = linear(start.first, start.second);
    const std::array<FT, 2> position = start_of_part(half_arc);
    return Similarity_2<FT>(h.side - direction, part.scale / scale, position[0] - image.first,
                            position[1] - image.second);
  }

  /// The similarity from the chart of a chord to the frame of the face on one side of it.
  /// \param s the segment of an arc that the chord belongs to
  Similarity_2<FT> frame_beside(const int s, const typename Traces::Chord& chord, const bool is_left) const
  {
    const typename Arcs::Segment& segment = m_arcs.segment(s);
    std::pair<FT, FT> start(segment.start, chord.line.value());
    FT scale = segment.scale;
    if (!is_left) { // the half-arc starts where the arc ends
      const typename Arcs::Arc& arc = m_arcs.arcs()[segment.arc];
      const FT length = arc.length * segment.scale;
      if (is_forward(chord.direction))
        start.first += length;
      else
        start.first -= length;
      scale /= arc.scale;
    }
    if (axis_along(chord.direction) == 1)
      std::swap(start.first, start.second);
    return frame(m_arcs.half_arc_beside(s, is_left), is_left ? chord.direction : turned(chord.direction, 2), start,
                 scale);
  }

  /// The place of the start of a half-arc in the frame of its face.
  std::array<FT, 2> start_of_part(const int half_arc) const
  {
    const Part& part = m_parts[half_arc];
    const Halfedge& h = m_halfedges[part.halfedge];
    return moved({{h.u, h.v}}, h.side, part.offset);
  }

private:
  static std::array<FT, 2> moved(std::array<FT, 2> point, const int direction, const FT& length)
  {
    if (is_forward(direction))
      point[axis_along(direction)] += length;
    else
      point[axis_along(direction)] -= length;
    return point;
  }

  /// Whether each end of an arc has its slot for itself. Where predicates are not exact, several may be there.
  bool is_graph() const
  {
    for (int half_arc = 0; half_arc < static_cast<int>(m_parts.size()); ++half_arc)
      if (m_arcs.end_slot(half_arc) == none ||
          m_arcs.leaving(m_arcs.end_node(half_arc), m_arcs.end_slot(half_arc)) != opposite(half_arc))
        return false;
    return true;
  }

  void find_vertices()
  {
    for (const typename Arcs::Arc& arc : m_arcs.arcs())
      for (const int node : {arc.start_node, arc.end_node}) {
        if (m_vertex_of_node.size() <= static_cast<std::size_t>(node))
          m_vertex_of_node.resize(node + 1, none);
        if (m_vertex_of_node[node] == none && !m_arcs.is_straight(node)) {
          m_vertex_of_node[node] = static_cast<int>(m_nodes.size());
          m_nodes.push_back(node);
        }
      }
  }

  int continuation(const int half_arc) const
  {
    const int node = m_arcs.end_node(half_arc), n = m_arcs.number_of_slots(node), slot = m_arcs.end_slot(half_arc);
    return m_arcs.leaving(node, slot + 2 < n ? slot + 2 : slot - 2);
  }

  void add_edge(const int first)
  {
    if (m_parts[first].halfedge != none)
      return;
    const int h = number_of_halfedges();
    int last = first;
    while (true) {
      m_parts[last].halfedge = h;
      m_parts[opposite(last)].halfedge = opposite(h);
      if (m_vertex_of_node[m_arcs.end_node(last)] != none)
        break;
      last = continuation(last);
    }
    const int source = m_vertex_of_node[m_arcs.start_node(first)], target = m_vertex_of_node[m_arcs.end_node(last)];
    m_halfedges.push_back({first, last, source, target});
    m_halfedges.push_back({opposite(last), opposite(first), target, source});
  }

  /// Finds the successors: at its target, a halfedge turns to the left, or goes straight on.
  bool join_halfedges()
  {
    m_is_border.assign(m_halfedges.size(), 0);
    for (Halfedge& h : m_halfedges) {
      const int node = m_arcs.end_node(h.last_half_arc);
      int slot = m_arcs.end_slot(h.last_half_arc), quarters = 0, leaving = none;
      bool is_border = false;
      while (leaving == none) {
        is_border = is_border || m_arcs.is_border_next(node, slot);
        slot = m_arcs.next_slot_clockwise(node, slot);
        leaving = m_arcs.leaving(node, slot);
        ++quarters;
      }
      h.next = m_parts[leaving].halfedge;
      h.is_corner = quarters == 1 && !is_border;
      m_is_border[&h - m_halfedges.data()] = is_border;
      if (quarters > 2 && !is_border)
        return false;
    }
    return true;
  }

  /// From the unit of the chart where a halfedge ends to that of the chart where the next one starts.
  void carry_unit_around_corner(const Halfedge& h, FT& unit) const
  {
    const int node = m_arcs.end_node(h.last_half_arc);
    int slot = m_arcs.end_slot(h.last_half_arc);
    do {
      m_arcs.carry_unit_clockwise(node, slot, unit);
      slot = m_arcs.next_slot_clockwise(node, slot);
    } while (m_arcs.leaving(node, slot) == none);
  }

  // The same where an edge goes straight on.
  void carry_unit_through_node(const int half_arc, FT& unit) const
  {
    const int node = m_arcs.end_node(half_arc), slot = m_arcs.end_slot(half_arc);
    m_arcs.carry_unit_clockwise(node, slot, unit);
    m_arcs.carry_unit_clockwise(node, m_arcs.next_slot_clockwise(node, slot), unit);
  }

  /// Gives numbers to the halfedges of a face. \param first the one that starts at the origin
  bool add_face(const int first)
  {
    const int f = number_of_faces();
    m_face_halfedge.push_back(first);
    std::array<FT, 2> position = {{FT(0), FT(0)}};
    FT scale(1); // from the chart where the halfedge starts to the face
    int side = 0, h = first;
    do {
      if (h == none || m_halfedges[h].face != none)
        return false;
      Halfedge& halfedge = m_halfedges[h];
      halfedge.face = f;
      halfedge.side = side;
      halfedge.u = position[0];
      halfedge.v = position[1];
      halfedge.knot = FT(0);
      for (int part = halfedge.first_half_arc;; part = continuation(part)) {
        m_parts[part].scale = scale;
        m_parts[part].offset = halfedge.knot;
        if (scale == 1)
          halfedge.knot += m_arcs.length(part);
        else
          halfedge.knot += m_arcs.length(part) * scale;
        m_arcs.carry_unit_along(part, scale);
        if (part == halfedge.last_half_arc)
          break;
        carry_unit_through_node(part, scale);
      }
      if (!(FT(0) < halfedge.knot))
        return false;
      position = moved(position, side, halfedge.knot);
      carry_unit_around_corner(halfedge, scale);
      if (halfedge.is_corner && ++side > 4)
        return false;
      h = halfedge.next;
    } while (h != first);
    return side == 4 && is_closed(position, scale);
  }

  static bool is_closed(const std::array<FT, 2>& position, const FT& scale)
  {
    if constexpr (is_exact_number_type<FT>)
      return position[0] == FT(0) && position[1] == FT(0) && scale == FT(1);
    else
      return true;
  }

  const Arcs& m_arcs;
  std::vector<int> m_nodes;          // per vertex
  std::vector<int> m_vertex_of_node; // none: nothing but a straight line goes there
  std::vector<Halfedge> m_halfedges;
  std::vector<char> m_is_border;
  std::vector<Part> m_parts; // per half-arc
  std::vector<int> m_face_halfedge;
  bool m_is_t_mesh = false;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_CELLS_H
