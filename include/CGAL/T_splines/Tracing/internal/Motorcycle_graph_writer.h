// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_GRAPH_WRITER_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_GRAPH_WRITER_H

#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/Tracing/internal/Cell_places.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_graph.h>
#include <CGAL/T_splines/Tracing/internal/Trace_geometry.h>
#include <CGAL/T_splines/internal/Face_graph_writer.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Writes the T-mesh of a motorcycle graph, and what lies where, into a face graph and property maps.
/// \tparam FaceGraph a model of `MutableFaceGraph`
template <typename FT, typename TracingTraits, typename FaceGraph>
class Motorcycle_graph_writer {
  using Graph = Motorcycle_graph<FT, TracingTraits>;
  using Layout = typename Graph::Layout;
  using Cells = typename Graph::Cells;
  using Arcs = typename Graph::Arcs;
  using Places = Cell_places<FT, TracingTraits>;
  using Geometry = Trace_geometry<FT, TracingTraits>;
  using Traces = typename Graph::Traces;
  using Point = typename Geometry::Point_3;

public:
  /// \param face_graph receives the cells as faces. \pre It is empty
  Motorcycle_graph_writer(const Graph& graph, FaceGraph& face_graph)
    : m_graph(graph),
      m_cells(graph.cells()),
      m_face_graph(face_graph),
      m_writer(face_graph, m_cells.number_of_vertices(), m_cells.number_of_edges(), m_cells.number_of_faces())
  {
    for (int h = 0; h < m_cells.number_of_halfedges(); ++h)
      m_writer.join(h, m_cells.halfedge(h).next, m_cells.halfedge(h).target, m_cells.halfedge(h).face);
    for (int f = 0; f < m_cells.number_of_faces(); ++f)
      m_writer.set_halfedge_of_face(f, m_cells.halfedge_of_face(f));
  }

  /// \param t_mesh a `T_mesh_view` of the graph
  template <typename TMesh>
  void put_knots(const TMesh& t_mesh) const
  {
    using Knot = typename TMesh::FT;
    for (int e = 0; e < m_cells.number_of_edges(); ++e)
      t_mesh.set_crease(m_writer.halfedge(halfedge_of_edge(e)), is_constrained(halfedge_of_edge(e)));
    for (int h = 0; h < m_cells.number_of_halfedges(); ++h)
      if (!m_cells.is_border(h)) {
        t_mesh.set_knot(m_writer.halfedge(h), converted_number<Knot>(m_cells.halfedge(h).knot));
        t_mesh.set_corner(m_writer.halfedge(h), m_cells.halfedge(h).is_corner);
      }
  }

  template <typename VertexPointMap>
  void put_points(const Geometry& geometry, VertexPointMap map) const
  {
    using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
    for (int v = 0; v < m_cells.number_of_vertices(); ++v)
      put(map, m_writer.vertex(v), to<Point_3>(geometry.point_of_node(m_cells.node_of_vertex(v))));
  }

  template <typename EdgePolylineMap>
  void put_polylines(const Geometry& geometry, EdgePolylineMap map) const
  {
    using Polyline = typename boost::property_traits<EdgePolylineMap>::value_type;
    for (int e = 0; e < m_cells.number_of_edges(); ++e) {
      const int h = halfedge_of_edge(e);
      const auto written = edge(m_writer.halfedge(h), m_face_graph);
      const bool is_same = halfedge(written, m_face_graph) == m_writer.halfedge(h);
      Polyline polyline;
      for (const Point& p : geometry.polyline(is_same ? h : opposite(h)))
        polyline.push_back(to<typename Polyline::value_type>(p));
      put(map, written, std::move(polyline));
    }
  }

  template <typename TriangleMesh, typename VertexOriginMap>
  void put_origins(const Mesh_indexing<TriangleMesh>& indexing, VertexOriginMap map) const
  {
    for (int v = 0; v < m_cells.number_of_vertices(); ++v) {
      const int node = m_cells.node_of_vertex(v);
      put(map, m_writer.vertex(v),
          Traces::is_star(node) ? indexing.vertex(m_graph.stars().star(Traces::star_of_node(node)).vertex)
                                : boost::graph_traits<TriangleMesh>::null_vertex());
    }
  }

  template <typename TriangleMesh, typename VertexPlaceMap>
  void put_places(const Mesh_indexing<TriangleMesh>& indexing, const Places& places, VertexPlaceMap map) const
  {
    const Layout& layout = m_graph.layout();
    using Place = typename boost::property_traits<VertexPlaceMap>::value_type;
    using Number = std::decay_t<decltype(Place().u)>;
    std::vector<int> base(places.number_of_frames(), Places::none);
    std::vector<std::array<double, 3>> image(places.number_of_frames()); // of the base; and the scale
    for (int v = 0; v < indexing.number_of_vertices(); ++v) {
      const typename Places::Place& place = places.place(v);
      if (place.frame == Places::none)
        continue; // an isolated vertex
      const typename Places::Frame& frame = places.frame(place.frame);
      const int h = place.halfedge;
      Place result;
      result.face = m_writer.face(frame.face);
      if (!std::is_floating_point<Number>::value || base[place.frame] == Places::none) {
        const auto [x, y] = frame.to_face(layout.coordinate(h, 0).value(), layout.coordinate(h, 1).value());
        result.u = converted_number<Number>(x);
        result.v = converted_number<Number>(y);
        base[place.frame] = h;
        image[place.frame] = {{CGAL::to_double(x), CGAL::to_double(y), CGAL::to_double(frame.to_face.scale())}};
      }
      else { // the coordinates in the chart may be large against the face: differences are not
        const std::array<double, 3>& origin = image[place.frame];
        const std::array<double, 2>&p = layout.uv(h), &q = layout.uv(base[place.frame]);
        const auto [x, y] = Similarity_2<double>(frame.to_face.quarter_turns(), origin[2], origin[0],
                                                 origin[1])(p[0] - q[0], p[1] - q[1]);
        result.u = Number(x);
        result.v = Number(y);
      }
      put(map, indexing.vertex(v), result);
    }
  }

  template <typename TriangleMesh, typename FaceAnchorMap>
  void put_anchors(const Mesh_indexing<TriangleMesh>& indexing, FaceAnchorMap map) const
  {
    using Anchor = typename boost::property_traits<FaceAnchorMap>::value_type;
    for (int f = 0; f < m_cells.number_of_faces(); ++f) {
      const auto [triangle, to_face] = anchor(m_cells.halfedge(m_cells.halfedge_of_face(f)).first_half_arc);
      Anchor result;
      result.triangle = indexing.face(triangle);
      result.to_face = to_face;
      put(map, m_writer.face(f), result);
    }
  }

private:
  // All of an edge lies on constrained edges of the mesh, or nothing.
  bool is_constrained(const int h) const
  {
    const typename Arcs::Arc& arc = m_graph.arcs().arcs()[edge_of(m_cells.halfedge(h).first_half_arc)];
    const Traces& traces = m_graph.traces();
    const typename Traces::Chord& chord = traces.chords[traces.traces[arc.trace].chords[arc.first_chord]];
    return chord.is_along && m_graph.layout().is_constrained(edge_of(chord.halfedge));
  }

  template <typename To>
  static To to(const Point& p)
  {
    return To(p[0], p[1], p[2]);
  }

  /// The triangle on the left of the first chord of a half-arc.
  std::pair<int, Similarity_2<FT>> anchor(const int half_arc) const
  {
    const Layout& layout = m_graph.layout();
    const Traces& traces = m_graph.traces();
    const typename Arcs::Arc& arc = m_graph.arcs().arcs()[edge_of(half_arc)];
    const bool is_forward_arc = is_along_edge(half_arc);
    const typename Traces::Chord& chord =
        traces.chords[traces.traces[arc.trace].chords[is_forward_arc ? arc.first_chord : arc.last_chord]];
    const Similarity_2<FT> frame =
        m_cells.frame_beside(is_forward_arc ? arc.first_segment : arc.last_segment, chord, is_forward_arc);
    if (is_forward_arc || !chord.is_along)
      return {chord.face, frame};
    const int h = chord.halfedge; // the left of the half-arc is the other face of the edge
    return {layout.mesh().face(opposite(h)),
            layout.is_cut(edge_of(h)) ? compose(frame, layout.transition(opposite(h))) : frame};
  }

  const Graph& m_graph;
  const Cells& m_cells;
  const FaceGraph& m_face_graph;
  Face_graph_writer<FaceGraph> m_writer;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_MOTORCYCLE_GRAPH_WRITER_H
