// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_BUILD_T_MESH_H
#define CGAL_T_SPLINES_IO_INTERNAL_BUILD_T_MESH_H

#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Builds the connectivity of a soup in a graph: vertices and faces in the order of the file, and `halfedge(f)` is
/// the first halfedge of the face's list.
///
/// A T-mesh may have two edges between the same vertices, or an edge that its face has on both sides: nothing is
/// looked up by its vertices.
/// \pre `check_t_mesh_soup()` found nothing; `graph` is empty.
template <typename MutableFaceGraph>
class T_mesh_builder {
  using Traits = boost::graph_traits<MutableFaceGraph>;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  T_mesh_builder(const T_mesh_soup& soup, MutableFaceGraph& graph) : m_soup(soup), m_links(soup), m_graph(graph)
  {
    for (std::size_t v = 0; v < soup.number_of_vertices(); ++v)
      m_vertices.push_back(add_vertex(graph));
    add_edges();
    add_faces();
    link_border();
  }

  vertex_descriptor vertex_of(const std::size_t v) const { return m_vertices[v]; }
  halfedge_descriptor halfedge_of(const std::size_t h) const { return m_halfedges[h]; }

  /// The halfedge before `h` (number) on its face: corners of the file stand at sources, those of the map at targets.
  halfedge_descriptor halfedge_before(const std::size_t h) const { return m_halfedges[m_links.prev(h)]; }

private:
  void add_edges()
  {
    m_halfedges.resize(m_soup.number_of_halfedges());
    for (std::size_t h = 0; h < m_halfedges.size(); ++h) {
      const std::size_t g = m_soup.opposites[h];
      if (g != T_mesh_soup::border && g < h)
        continue;
      m_halfedges[h] = halfedge(add_edge(m_graph), m_graph);
      const halfedge_descriptor other = opposite(m_halfedges[h], m_graph);
      set_target(m_halfedges[h], m_vertices[m_links.target(h)], m_graph);
      set_target(other, m_vertices[m_links.source(h)], m_graph);
      if (g != T_mesh_soup::border)
        m_halfedges[g] = other;
    }
  }

  void add_faces()
  {
    for (std::size_t f = 0; f < m_soup.number_of_faces(); ++f) {
      const auto face = add_face(m_graph);
      for (std::size_t h = m_soup.first_halfedge[f]; h < m_soup.first_halfedge[f + 1]; ++h) {
        set_face(m_halfedges[h], face, m_graph);
        set_next(m_halfedges[h], m_halfedges[m_links.next(h)], m_graph);
        set_halfedge(m_vertices[m_links.target(h)], m_halfedges[h], m_graph);
      }
      set_halfedge(face, m_halfedges[m_soup.first_halfedge[f]], m_graph);
    }
  }

  void link_border()
  {
    for (std::size_t h = 0; h < m_halfedges.size(); ++h) {
      if (!m_links.is_border_edge(h))
        continue;
      const halfedge_descriptor border = opposite(m_halfedges[h], m_graph);
      // The border goes on at the other end of the fan at the source of `h`.
      std::size_t last = h;
      while (!m_links.is_border_edge(m_links.prev(last)))
        last = m_links.counter_clockwise(last);
      set_face(border, Traits::null_face(), m_graph);
      set_next(border, opposite(m_halfedges[m_links.prev(last)], m_graph), m_graph);
      set_halfedge(m_vertices[m_links.source(h)], border, m_graph);
    }
  }

  const T_mesh_soup& m_soup;
  const T_mesh_links m_links;
  MutableFaceGraph& m_graph;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_BUILD_T_MESH_H
