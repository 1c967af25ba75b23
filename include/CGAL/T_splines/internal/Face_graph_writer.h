// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_FACE_GRAPH_WRITER_H
#define CGAL_T_SPLINES_INTERNAL_FACE_GRAPH_WRITER_H

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The members of Face_graph_writer hide the graph's free function `halfedge()`.
template <typename FaceGraph>
typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_of_new_edge(FaceGraph& graph)
{
  return halfedge(add_edge(graph), graph);
}

/// Makes a face graph of index arrays, without look-ups by vertices: loops, multiple edges and faces that meet
/// themselves are welcome.
///
/// Halfedges 2e and 2e + 1 are opposite; the face of a border halfedge is negative.
/// \tparam FaceGraph a model of `MutableFaceGraph`
template <typename FaceGraph>
class Face_graph_writer {
  using Traits = boost::graph_traits<FaceGraph>;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

  /// \pre `graph` is empty
  Face_graph_writer(FaceGraph& graph, const int number_of_vertices, const int number_of_edges,
                    const int number_of_faces)
    : m_graph(graph)
  {
    CGAL_precondition_msg(CGAL::is_empty(graph),
                          "the graph to write must be empty: clear() would take its property maps away");
    reserve(graph, number_of_vertices, number_of_edges, number_of_faces);
    for (int v = 0; v < number_of_vertices; ++v)
      m_vertices.push_back(add_vertex(graph));
    for (int e = 0; e < number_of_edges; ++e) {
      m_halfedges.push_back(halfedge_of_new_edge(graph));
      m_halfedges.push_back(opposite(m_halfedges.back(), graph));
    }
    for (int f = 0; f < number_of_faces; ++f)
      m_faces.push_back(add_face(graph));
  }

  vertex_descriptor vertex(const int v) const { return m_vertices[v]; }
  halfedge_descriptor halfedge(const int h) const { return m_halfedges[h]; }
  face_descriptor face(const int f) const { return m_faces[f]; }

  /// \param f negative at a border
  void join(const int h, const int next, const int target, const int f)
  {
    set_next(m_halfedges[h], m_halfedges[next], m_graph);
    set_target(m_halfedges[h], m_vertices[target], m_graph);
    set_halfedge(m_vertices[target], m_halfedges[h], m_graph);
    set_face(m_halfedges[h], f < 0 ? Traits::null_face() : m_faces[f], m_graph);
  }

  void set_halfedge_of_face(const int f, const int h) { set_halfedge(m_faces[f], m_halfedges[h], m_graph); }

private:
  FaceGraph& m_graph;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<face_descriptor> m_faces;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_FACE_GRAPH_WRITER_H
