// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_TRACE_GEOMETRY_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_TRACE_GEOMETRY_H

#include <CGAL/T_splines/Similarity_map/internal/Seamless_layout.h>
#include <CGAL/T_splines/T_mesh/internal/Motorcycle_cells.h>
#include <CGAL/T_splines/T_mesh/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/T_mesh/internal/Trace_arcs.h>
#include <CGAL/T_splines/T_mesh/internal/Vertex_stars.h>
#include <CGAL/T_splines/T_mesh/internal/isoline_directions.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Where nodes and edges of a motorcycle graph lie in space, in doubles.
template <typename FT, typename TracingTraits>
class Trace_geometry {
  using Layout = Seamless_layout<FT>;
  using Traces = Motorcycle_traces<FT>;
  using Arcs = Trace_arcs<FT, TracingTraits>;
  using Cells = Motorcycle_cells<FT, TracingTraits>;

public:
  using Point_3 = std::array<double, 3>;

  /// \param points of the vertices of the map's mesh
  Trace_geometry(const Layout& layout, const std::vector<Point_3>& points,
                 const Vertex_stars<FT, TracingTraits>& stars, const Traces& traces, const Arcs& arcs, const Cells& cells)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_points(points),
      m_stars(stars),
      m_traces(traces),
      m_arcs(arcs),
      m_cells(cells)
  {
  }

  Point_3 point_of_node(const int node) const
  {
    if (Traces::is_star(node))
      return m_points[m_stars.star(node / 2).vertex];
    const typename Traces::Crossing_node& crossing = m_traces.nodes[node / 2];
    const typename Traces::Chord& chord = m_traces.chords[crossing.chord];
    if (crossing.is_at_end)
      return exit_point(chord);
    const double along = crossing.along.lower, line = chord.line.lower;
    return axis_along(chord.direction) == 0 ? point_in_face(chord.face, along, line) : point_in_face(chord.face, line, along);
  }

  /// The points of an edge of the T-mesh, from the source of its halfedge to the target.
  std::vector<Point_3> polyline(const int halfedge) const
  {
    std::vector<Point_3> points;
    int part = m_cells.halfedge(halfedge).first_half_arc;
    add(points, point_of_node(m_arcs.start_node(part)));
    for (; part != Cells::none; part = m_cells.next_part(part)) {
      const typename Arcs::Arc& arc = m_arcs.arcs()[part / 2];
      const std::vector<int>& chords = m_traces.traces[arc.trace].chords;
      if ((part & 1) == 0)
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
    const double t = chord.exit_parameter;
    return combination(m_mesh.source(chord.halfedge), 1 - t, m_mesh.target(chord.halfedge), t, 0, 0);
  }

  Point_3 combination(const int a, const double x, const int b, const double y, const int c, const double z) const
  {
    Point_3 point;
    for (int i = 0; i < 3; ++i)
      point[i] = x * m_points[a][i] + y * m_points[b][i] + z * m_points[c][i];
    return point;
  }

  Point_3 point_in_face(const int face, const double u, const double v) const
  {
    const int h = m_mesh.halfedge_of_face(face), g = m_mesh.next(h), k = m_mesh.next(g);
    const std::array<double, 2> &p = m_layout.uv(h), &q = m_layout.uv(g), &r = m_layout.uv(k);
    const double area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    double b = ((u - p[0]) * (r[1] - p[1]) - (v - p[1]) * (r[0] - p[0])) / area;
    double c = ((q[0] - p[0]) * (v - p[1]) - (q[1] - p[1]) * (u - p[0])) / area;
    b = std::clamp(b, 0., 1.);
    c = std::clamp(c, 0., 1 - b);
    return combination(m_mesh.target(h), 1 - b - c, m_mesh.target(g), b, m_mesh.target(k), c);
  }

  const Layout& m_layout;
  const Triangulation_connectivity& m_mesh;
  const std::vector<Point_3>& m_points;
  const Vertex_stars<FT, TracingTraits>& m_stars;
  const Traces& m_traces;
  const Arcs& m_arcs;
  const Cells& m_cells;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_TRACE_GEOMETRY_H
