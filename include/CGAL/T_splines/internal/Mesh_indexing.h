// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_MESH_INDEXING_H
#define CGAL_T_SPLINES_INTERNAL_MESH_INDEXING_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The members of Mesh_indexing hide the graph's free function `halfedge()`.
template <typename FaceGraph>
typename boost::graph_traits<FaceGraph>::halfedge_descriptor
first_halfedge(const typename boost::graph_traits<FaceGraph>::edge_descriptor e, const FaceGraph& graph)
{
  return halfedge(e, graph);
}

/// The bijection between the descriptors of a face graph and consecutive indices, in the order in which the graph
/// lists its elements.
///
/// It does not use the graph's own index maps: those of a `Surface_mesh` with removed elements have gaps.
/// Halfedges are numbered in pairs: `h` and `opposite(h)` have the indices `2e` and `2e + 1`.
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`.
template <typename FaceGraph>
class Mesh_indexing {
  using Traits = boost::graph_traits<FaceGraph>;
  using Vertex_index_map = typename boost::property_map<FaceGraph, CGAL::dynamic_vertex_property_t<int>>::const_type;
  using Halfedge_index_map =
      typename boost::property_map<FaceGraph, CGAL::dynamic_halfedge_property_t<int>>::const_type;
  using Face_index_map = typename boost::property_map<FaceGraph, CGAL::dynamic_face_property_t<int>>::const_type;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

  explicit Mesh_indexing(const FaceGraph& graph)
    : m_graph(&graph),
      m_vertex_index(get(CGAL::dynamic_vertex_property_t<int>(), graph)),
      m_halfedge_index(get(CGAL::dynamic_halfedge_property_t<int>(), graph)),
      m_face_index(get(CGAL::dynamic_face_property_t<int>(), graph))
  {
    for (const vertex_descriptor v : CGAL::make_range(vertices(graph))) {
      put(m_vertex_index, v, static_cast<int>(m_vertices.size()));
      m_vertices.push_back(v);
    }
    for (const edge_descriptor e : CGAL::make_range(edges(graph))) {
      const halfedge_descriptor h = first_halfedge<FaceGraph>(e, graph);
      for (const halfedge_descriptor g : {h, opposite(h, graph)}) {
        put(m_halfedge_index, g, static_cast<int>(m_halfedges.size()));
        m_halfedges.push_back(g);
      }
    }
    for (const face_descriptor f : CGAL::make_range(faces(graph))) {
      put(m_face_index, f, static_cast<int>(m_faces.size()));
      m_faces.push_back(f);
    }
  }

  int vertex_index(const vertex_descriptor v) const { return get(m_vertex_index, v); }
  int halfedge_index(const halfedge_descriptor h) const { return get(m_halfedge_index, h); }
  int face_index(const face_descriptor f) const { return get(m_face_index, f); }

  vertex_descriptor vertex(const int i) const { return m_vertices[i]; }
  halfedge_descriptor halfedge(const int i) const { return m_halfedges[i]; }
  face_descriptor face(const int i) const { return m_faces[i]; }

  int number_of_vertices() const { return static_cast<int>(m_vertices.size()); }
  int number_of_halfedges() const { return static_cast<int>(m_halfedges.size()); }
  int number_of_faces() const { return static_cast<int>(m_faces.size()); }

  const FaceGraph& graph() const { return *m_graph; }

  /// Whether the elements of a graph are those that have indices, in this order. Complexity: linear.
  bool has_elements_of(const FaceGraph& graph) const
  {
    const auto is_listed = [](const auto& range, const auto& list) {
      return std::equal(range.begin(), range.end(), list.begin(), list.end());
    };
    std::size_t h = 0;
    for (const edge_descriptor e : CGAL::make_range(edges(graph))) {
      if (h >= m_halfedges.size() || m_halfedges[h] != first_halfedge<FaceGraph>(e, graph))
        return false;
      h += 2;
    }
    return h == m_halfedges.size() && is_listed(CGAL::make_range(vertices(graph)), m_vertices) &&
           is_listed(CGAL::make_range(faces(graph)), m_faces);
  }

private:
  const FaceGraph* m_graph;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<face_descriptor> m_faces;
  Vertex_index_map m_vertex_index;
  Halfedge_index_map m_halfedge_index;
  Face_index_map m_face_index;
};

/// The connectivity of a triangle mesh. A border halfedge has the face `Triangulation_connectivity::null`; its `next`
/// runs along the border.
template <typename FaceGraph>
Triangulation_connectivity triangulation_connectivity(const Mesh_indexing<FaceGraph>& indexing)
{
  const FaceGraph& graph = indexing.graph();
  Triangulation_connectivity result;
  const int number_of_halfedges = indexing.number_of_halfedges();
  result.m_number_of_vertices = indexing.number_of_vertices();
  result.m_next.resize(number_of_halfedges);
  result.m_target.resize(number_of_halfedges);
  result.m_face.resize(number_of_halfedges);
  result.m_face_halfedge.resize(indexing.number_of_faces());
  for (int i = 0; i < number_of_halfedges; ++i) {
    const auto h = indexing.halfedge(i);
    result.m_next[i] = indexing.halfedge_index(next(h, graph));
    result.m_target[i] = indexing.vertex_index(target(h, graph));
    result.m_face[i] = is_border(h, graph) ? Triangulation_connectivity::null : indexing.face_index(face(h, graph));
  }
  for (int f = 0; f < indexing.number_of_faces(); ++f)
    result.m_face_halfedge[f] = indexing.halfedge_index(halfedge(indexing.face(f), graph));
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_MESH_INDEXING_H
