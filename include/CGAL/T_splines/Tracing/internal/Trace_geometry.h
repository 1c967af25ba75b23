// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_TRACE_GEOMETRY_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_TRACE_GEOMETRY_H

#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_graph.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Where nodes and edges of a motorcycle graph lie in space, in doubles.
template <typename FT, typename TracingTraits>
class Trace_geometry {
  using Graph = Motorcycle_graph<FT, TracingTraits>;
  using Stars = typename Graph::Stars;
  using Traces = typename Graph::Traces;
  using Arcs = typename Graph::Arcs;
  using Cells = typename Graph::Cells;

public:
  using Point_3 = typename Chart_points<FT>::Point_3;

  /// \param points of the vertices of the map's mesh
  Trace_geometry(const Graph& graph, const std::vector<Point_3>& points)
    : m_points(graph.layout(), points),
      m_stars(graph.stars()),
      m_traces(graph.traces()),
      m_arcs(graph.arcs()),
      m_cells(graph.cells())
  {
  }

  Point_3 point_of_node(const int node) const
  {
    if (Traces::is_star(node))
      return m_points.of_vertex(m_stars.star(Traces::star_of_node(node)).vertex);
    const typename Traces::Crossing_node& crossing = m_traces.nodes[Traces::crossing_of_node(node)];
    const typename Traces::Chord& chord = m_traces.chords[crossing.chord];
    if (crossing.is_at_end)
      return exit_point(chord);
    return axis_along(chord.direction) == 0 ? m_points.in_face(chord.face, crossing.along, chord.line)
                                            : m_points.in_face(chord.face, chord.line, crossing.along);
  }

  /// The points of an edge of the T-mesh, from the source of its halfedge to the target.
  std::vector<Point_3> polyline(const int halfedge) const
  {
    std::vector<Point_3> points;
    int part = m_cells.halfedge(halfedge).first_half_arc;
    add(points, point_of_node(m_arcs.start_node(part)));
    for (; part != Cells::none; part = m_cells.next_part(part)) {
      const typename Arcs::Arc& arc = m_arcs.arcs()[edge_of(part)];
      const std::vector<int>& chords = m_traces.traces[arc.trace].chords;
      if (is_along_edge(part))
        for (int i = arc.first_chord; i < arc.last_chord; ++i)
          add(points, exit_point(m_traces.chords[chords[i]]));
      else
        for (int i = arc.last_chord - 1; i >= arc.first_chord; --i)
          add(points, exit_point(m_traces.chords[chords[i]]));
      add(points, point_of_node(m_arcs.end_node(part)));
    }
    return points;
  }

private:
  static void add(std::vector<Point_3>& points, const Point_3& point)
  {
    if (points.empty() || points.back() != point)
      points.push_back(point);
  }

  Point_3 exit_point(const typename Traces::Chord& chord) const
  {
    return m_points.on_edge(chord.halfedge, chord.exit_parameter);
  }

  const Chart_points<FT> m_points;
  const Stars& m_stars;
  const Traces& m_traces;
  const Arcs& m_arcs;
  const Cells& m_cells;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_TRACE_GEOMETRY_H
