// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_T_MESH_PLACEMENT_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_T_MESH_PLACEMENT_H

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/Tracing/internal/Isoline_walker.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Walks along all edges of a T-mesh on the surface, from vertices whose place is known to the others.
///
/// A stand that looks along a halfedge has the length of the halfedge, in its chart, as its unit.
/// \tparam TMesh a `T_mesh_view` of a `const` graph
template <typename TriangleMesh, typename FT, typename TMesh, typename TracingTraits>
class T_mesh_placement {
  using Graph = typename TMesh::Graph;
  using vertex_descriptor = typename TMesh::vertex_descriptor;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using Walker = Isoline_walker<FT, TracingTraits>;
  using Stand = typename Walker::Stand;
  using Vertex_flag_map = typename boost::property_map<Graph, CGAL::dynamic_vertex_property_t<bool>>::const_type;
  using Halfedge_flag_map = typename boost::property_map<Graph, CGAL::dynamic_halfedge_property_t<bool>>::const_type;

public:
  using Point_3 = typename Walker::Point_3;

  T_mesh_placement(const Seamless_map<TriangleMesh, FT>& map, const std::vector<Point_3>& points, const TMesh& t_mesh,
                   const TracingTraits& traits)
    : m_map(map),
      m_t_mesh(t_mesh),
      m_graph(t_mesh.graph()),
      m_walker(map.layout(), points, traits),
      m_is_placed(get(CGAL::dynamic_vertex_property_t<bool>(), m_graph)),
      m_is_main(get(CGAL::dynamic_halfedge_property_t<bool>(), m_graph))
  {
    for (const auto e : CGAL::make_range(edges(m_graph))) { // an edge made of a halfedge may remember which one it was
      const halfedge_descriptor h = halfedge(e, m_graph);
      put(m_is_main, h, true);
      put(m_is_main, opposite(h, m_graph), false);
    }
    for (const vertex_descriptor v : CGAL::make_range(vertices(m_graph)))
      put(m_is_placed, v, false);
  }

  /// Places the component of a root. \param found_vertex, found_edge are called with what is placed
  /// \return false if an edge, or the way to the origin of the root's face, leads nowhere, or `progress` is interrupted
  template <typename Root, typename FoundVertex, typename FoundEdge>
  bool place(const Root& root, const FoundVertex& found_vertex, const FoundEdge& found_edge, Progress& progress)
  {
    Stand stand;
    const T_mesh_coordinates coordinates(m_t_mesh);
    const halfedge_descriptor first = coordinates.first_of_side(root.place.face, 0);
    const FT width(coordinates.side_length(first)),
        height(coordinates.side_length(coordinates.first_of_side(root.place.face, 1)));
    if (!walk_to_origin(root, width, height, stand))
      return false;
    stand.unit *= knot(first);
    m_queue.push_back({first, stand});
    reach(first, stand, found_vertex);
    while (!m_queue.empty()) {
      progress.progress(static_cast<double>(m_number_of_edges) / static_cast<double>(num_edges(m_graph)));
      if (!progress.go_on_after(work_per_triangle * (1 + m_crossed_triangles)))
        return false;
      m_crossed_triangles = 0;
      const Known_halfedge known = m_queue.front();
      m_queue.pop_front();
      if (!walk_from(known, found_vertex, found_edge))
        return false;
    }
    return true;
  }

  /// The halfedge that leads nowhere, or null, after `place()` has failed.
  halfedge_descriptor failed_halfedge() const { return m_failed_halfedge; }

private:
  static constexpr std::size_t work_per_triangle = 100; // in exact numbers

  struct Known_halfedge {
    halfedge_descriptor halfedge;
    Stand stand;
  };

  FT knot(const halfedge_descriptor h) const { return FT(m_t_mesh.knot(h)); }
  bool is_border(const halfedge_descriptor h) const
  {
    return face(h, m_graph) == boost::graph_traits<Graph>::null_face();
  }

  /// Goes to the origin of the root's face, with the unit of the face, and looks along the u axis.
  template <typename Root>
  bool walk_to_origin(const Root& root, const FT& width, const FT& height, Stand& stand)
  {
    const FT &u = root.place.u, &v = root.place.v;
    // The quadrant that begins with this direction of the face lies inside it.
    const int quadrant = u < width && v < height ? 0 : FT(0) < u && v < height ? 1 : FT(0) < u ? 2 : 3;
    const Similarity_2<FT>& to_face = root.anchor.to_face;
    const std::pair<FT, FT> p = to_face.inverse()(u, v);
    stand = m_walker.stand_in_face(m_map.indexing().face_index(root.anchor.triangle), {{p.first, p.second}},
                                   turned(quadrant, -to_face.quarter_turns()), FT(1) / to_face.scale());
    std::vector<Point_3> way;
    int course = quadrant;
    const auto go = [&](const int direction, const FT& length) {
      const int turns = turned(direction, -course);
      m_walker.turn(stand, turns == 3 ? -1 : turns);
      course = turned(direction, 2);
      return m_walker.walk(stand, length, way);
    };
    if (v != FT(0) && !go(3, v))
      return false;
    if (u != FT(0) && !go(2, u))
      return false;
    m_walker.turn(stand, course == 1 ? -1 : 0); // it looks up, or to the right
    return true;
  }

  template <typename FoundVertex>
  void reach(const halfedge_descriptor h, const Stand& stand, const FoundVertex& found_vertex)
  {
    put(m_is_placed, source(h, m_graph), true);
    found_vertex(source(h, m_graph), m_walker.point(stand));
  }

  /// Walks along all halfedges that leave the source of a known one.
  template <typename FoundVertex, typename FoundEdge>
  bool walk_from(const Known_halfedge& known, const FoundVertex& found_vertex, const FoundEdge& found_edge)
  {
    halfedge_descriptor h = known.halfedge;
    Stand stand = known.stand;
    do {
      if (!walk_along(h, stand, found_vertex, found_edge))
        return false;
      if (is_border(h))
        break;
      const halfedge_descriptor before = prev(h, m_graph);
      stand.unit *= knot(before) / knot(h);
      m_walker.turn(stand, m_t_mesh.is_corner(before) ? 1 : 2);
      h = opposite(before, m_graph);
    } while (h != known.halfedge);
    if (h != known.halfedge || is_border(h)) { // the others, clockwise
      h = known.halfedge;
      stand = known.stand;
      while (!is_border(opposite(h, m_graph))) {
        const halfedge_descriptor in = opposite(h, m_graph), after = next(in, m_graph);
        stand.unit *= knot(after) / knot(in);
        m_walker.turn(stand, m_t_mesh.is_corner(in) ? -1 : -2);
        h = after;
        if (!walk_along(h, stand, found_vertex, found_edge))
          return false;
      }
    }
    return true;
  }

  template <typename FoundVertex, typename FoundEdge>
  bool walk_along(const halfedge_descriptor h, Stand stand, const FoundVertex& found_vertex,
                  const FoundEdge& found_edge)
  {
    const halfedge_descriptor back = opposite(h, m_graph);
    const bool is_new = !get(m_is_placed, target(h, m_graph));
    const bool is_main = get(m_is_main, h);
    if (!is_new && !is_main)
      return true; // the polyline comes from the other end
    std::vector<Point_3> polyline(1, m_walker.point(stand));
    if (!m_walker.walk(stand, FT(1), polyline)) {
      m_failed_halfedge = h;
      return false;
    }
    ++m_number_of_edges;
    m_crossed_triangles += polyline.size();
    if (!is_main)
      std::reverse(polyline.begin(), polyline.end());
    found_edge(edge(is_main ? h : back, m_graph), polyline);
    if (is_new) {
      reach(back, stand, found_vertex);
      m_queue.push_back({back, stand});
    }
    return true;
  }

  const Seamless_map<TriangleMesh, FT>& m_map;
  TMesh m_t_mesh;
  const Graph& m_graph;
  Walker m_walker;
  Vertex_flag_map m_is_placed;
  Halfedge_flag_map m_is_main; // the halfedge of its edge
  std::deque<Known_halfedge> m_queue;
  std::size_t m_number_of_edges = 0; // that were walked along
  std::size_t m_crossed_triangles = 0;
  halfedge_descriptor m_failed_halfedge = boost::graph_traits<Graph>::null_halfedge();
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_T_MESH_PLACEMENT_H
