// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_H

#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/internal/Face_graph_writer.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/graph_checks.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace T_splines {

namespace internal {

/// Does what `copy_T_mesh()` does. \pre The graph of `to` is empty
/// \tparam FromTMesh, ToTMesh models of `T_mesh_view`
template <typename FromTMesh, typename ToTMesh>
void copy_elements(const Mesh_indexing<typename FromTMesh::Graph>& indexing, const FromTMesh& from, const ToTMesh& to)
{
  using Knot = typename ToTMesh::FT;
  using Graph = typename FromTMesh::Graph;
  const Graph& graph = indexing.graph();
  Face_graph_writer<typename ToTMesh::Graph> writer(to.graph(), indexing.number_of_vertices(),
                                                    indexing.number_of_halfedges() / 2, indexing.number_of_faces());
  for (int i = 0; i < indexing.number_of_halfedges(); ++i) {
    const auto h = indexing.halfedge(i);
    const bool is_border = face(h, graph) == boost::graph_traits<Graph>::null_face();
    writer.join(i, indexing.halfedge_index(next(h, graph)), indexing.vertex_index(target(h, graph)),
                is_border ? -1 : indexing.face_index(face(h, graph)));
    if (is_border)
      continue;
    to.set_knot(writer.halfedge(i), converted_number<Knot>(from.knot(h)));
    to.set_corner(writer.halfedge(i), from.is_corner(h));
    to.set_crease(writer.halfedge(i), from.is_crease(h));
  }
  for (int f = 0; f < indexing.number_of_faces(); ++f)
    writer.set_halfedge_of_face(f, indexing.halfedge_index(halfedge(indexing.face(f), graph)));
}

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// copies the connectivity of a T-mesh, its knots, corners and creases. The elements keep their order; points are not copied.
/// \tparam FromTMesh, ToTMesh models of `TMesh`, the graphs of `FaceListGraph` and `VertexListGraph`, that of `to` of
///         `MutableFaceGraph`; knots are converted, exact ones to doubles rounded
/// \param from what is copied
/// \param to empty, without removed elements, too; otherwise it is left as it is
/// \return whether `to` was empty. Complexity: linear.
template <typename FromTMesh, typename ToTMesh>
bool copy_T_mesh(const FromTMesh& from, ToTMesh&& to)
{
  const Const_T_mesh_view_of<FromTMesh> source(from);
  const T_mesh_view_of<ToTMesh> result(to);
  if (!internal::is_output_graph(result.graph()))
    return false;
  internal::copy_elements(internal::Mesh_indexing<T_mesh_graph<FromTMesh>>(source.graph()), source, result);
  return true;
}

/// \ingroup PkgTSplinesTMesh
/// A T-mesh with halfedge knots, as one value: a model of `TMesh`. Copies have their own graph, knots and corners.
///
/// The graph is a `Surface_mesh`; whatever else belongs to the T-mesh, control points and anchors for instance, is in
/// its points and property maps, which are copied, too.
///
/// \cgalModels{TMesh}
///
/// \tparam Point_3_ the points of the vertices
/// \tparam FT_ the number type of the knots
template <typename Point_3_, typename FT_ = double>
class T_mesh {
public:
  using Point_3 = Point_3_;                                                        ///< a point in space
  using FT = FT_;                                                                  ///< number type of the knots
  using Graph = CGAL::Surface_mesh<Point_3>;                                       ///< the T-mesh's graph
  using vertex_descriptor = typename Graph::Vertex_index;                          ///< a vertex of the graph
  using halfedge_descriptor = typename Graph::Halfedge_index;                      ///< a halfedge of the graph
  using face_descriptor = typename Graph::Face_index;                              ///< a face of the graph
  using Knot_map = typename Graph::template Property_map<halfedge_descriptor, FT>; ///< halfedge -> knot interval
  /// halfedge -> whether the face turns at its target.
  using Corner_map = typename Graph::template Property_map<halfedge_descriptor, bool>;
  /// edge -> whether it is a crease.
  using Crease_map = typename Graph::template Property_map<typename Graph::Edge_index, bool>;

  /// is empty.
  T_mesh() { find_maps(); }
  /// copies graph, knots, corners, and all property maps.
  T_mesh(const T_mesh& other) : m_graph(other.m_graph) { find_maps(); }
  /// copies graph, knots, corners, and all property maps.
  T_mesh& operator=(const T_mesh& other)
  {
    m_graph = other.m_graph;
    find_maps();
    return *this;
  }

  /// returns the graph of the T-mesh.
  Graph& graph() { return m_graph; }
  /// returns the graph of the T-mesh.
  const Graph& graph() const { return m_graph; }
  const Knot_map& knots() const { return m_knots; }       ///< of new halfedges 0
  const Corner_map& corners() const { return m_corners; } ///< of new halfedges `false`
  /// returns which edges are creases; new ones are not.
  const Crease_map& creases() const { return m_creases; }

private:
  // Of this graph, not of the one that was copied.
  void find_maps()
  {
    m_knots = m_graph.template add_property_map<halfedge_descriptor, FT>("h:knot", FT(0)).first;
    m_corners = m_graph.template add_property_map<halfedge_descriptor, bool>("h:is_corner", false).first;
    m_creases = m_graph.template add_property_map<typename Graph::Edge_index, bool>("e:is_crease", false).first;
  }

  Graph m_graph;
  Knot_map m_knots;
  Corner_map m_corners;
  Crease_map m_creases;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_H
