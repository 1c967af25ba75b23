// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_IS_NODE_OF_CREASES_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_IS_NODE_OF_CREASES_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace T_splines {
namespace internal {

// Whether the edge of h goes straight on at the target of h, as a crease: at a regular vertex.
template <typename TMesh>
bool crease_goes_straight_on(const typename TMesh::halfedge_descriptor h, const TMesh& t_mesh)
{
  const auto& graph = t_mesh.graph();
  const auto null_face = boost::graph_traits<typename TMesh::Graph>::null_face();
  const auto n = next(h, graph), across = opposite(n, graph);
  if (face(h, graph) == null_face || !t_mesh.is_corner(h))
    return t_mesh.is_crease(n);
  return face(across, graph) != null_face && t_mesh.is_corner(across) && t_mesh.is_crease(next(across, graph));
}

// Whether there are creases at a vertex, but not two that go straight through it.
// \tparam TMesh a `T_mesh_view`
template <typename TMesh>
bool is_node_of_creases(const typename TMesh::vertex_descriptor v, const TMesh& t_mesh)
{
  if constexpr (!TMesh::has_creases)
    return false;
  else {
    int number = 0;
    bool is_straight = true;
    for (const auto h : CGAL::halfedges_around_target(halfedge(v, t_mesh.graph()), t_mesh.graph()))
      if (t_mesh.is_crease(h)) {
        ++number;
        is_straight = is_straight && crease_goes_straight_on(h, t_mesh);
      }
    return number != 0 && (number != 2 || !is_straight);
  }
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_IS_NODE_OF_CREASES_H
