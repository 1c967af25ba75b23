// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_EDIT_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_EDIT_H

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// How an operation on a T-mesh ended. Only after DONE has anything changed.
enum class T_mesh_edit_status {
  DONE,             ///< the operation was executed
  OUTSIDE,          ///< a line would lie outside of its face, on its border, or pass another one
  NO_FACE,          ///< the halfedge, or its opposite, is on the border
  SAME_FACE,        ///< the face is on both sides of the edge
  NO_T_JOINT,       ///< the face has a corner at the vertex
  NOT_A_FULL_SIDE,  ///< the edges between the two faces are not a full side of both
  NOT_REMOVABLE,    ///< the vertex has not exactly two edges
  FIXED_VERTEX,     ///< an extraordinary or constrained vertex would lose an edge or move
  CREASE,           ///< a crease would be removed or moved
  NO_FREE_LINE,     ///< the line ends at a border or where no orthogonal line passes, so that it cannot be shifted
  LINE_MEETS_ITSELF ///< the line crosses itself, or faces touch it along both axes
};

/// \ingroup PkgTSplinesTMesh
/// returns one sentence that explains `status`.
inline const char* message(const T_mesh_edit_status status)
{
  switch (status) {
  case T_mesh_edit_status::DONE: return "done";
  case T_mesh_edit_status::OUTSIDE: return "a line would leave its face or pass another one";
  case T_mesh_edit_status::NO_FACE: return "the edge is on the border";
  case T_mesh_edit_status::SAME_FACE: return "the face is on both sides of the edge";
  case T_mesh_edit_status::NO_T_JOINT: return "the face has a corner at the vertex";
  case T_mesh_edit_status::NOT_A_FULL_SIDE: return "the edges between the two faces are not a full side of both";
  case T_mesh_edit_status::NOT_REMOVABLE: return "the vertex has not exactly two edges";
  case T_mesh_edit_status::FIXED_VERTEX: return "an extraordinary or constrained vertex would lose an edge or move";
  case T_mesh_edit_status::CREASE: return "a crease would be removed or moved";
  case T_mesh_edit_status::NO_FREE_LINE: return "the line does not end at orthogonal lines";
  case T_mesh_edit_status::LINE_MEETS_ITSELF: return "the line crosses itself";
  }
  return "";
}

/// \ingroup PkgTSplinesTMesh
/// The result of an operation on a T-mesh: how it ended, and if it was executed, a halfedge; each operation says which.
/// It converts to `true` if the operation was executed.
/// \tparam Graph a model of `HalfedgeGraph`
template <typename Graph>
struct T_mesh_edit {
  using halfedge_descriptor = typename boost::graph_traits<Graph>::halfedge_descriptor; ///< a halfedge of the graph

  /// is made by the operations.
  T_mesh_edit(const T_mesh_edit_status s, const halfedge_descriptor h = boost::graph_traits<Graph>::null_halfedge())
    : status(s),
      halfedge(h)
  {
  }

  /// converts to `true` upon success.
  explicit operator bool() const { return status == T_mesh_edit_status::DONE; }

  T_mesh_edit_status status;    ///< whether it was executed, and if not, why
  halfedge_descriptor halfedge; ///< the halfedge that the operation names
};

/// \ingroup PkgTSplinesTMesh
/// The chain of edges along which two faces of a T-mesh touch. Lengths are in the units of the face of `first`, except
/// those called opposite.
/// \tparam Graph a model of `HalfedgeGraph`
/// \tparam FT the number type of the knots
template <typename Graph, typename FT>
struct T_mesh_overlap {
  using halfedge_descriptor = typename boost::graph_traits<Graph>::halfedge_descriptor; ///< a halfedge of the graph

  halfedge_descriptor first, ///< the first halfedge of the chain
      last;                  ///< the last halfedge of the chain
  FT begin,                  ///< distance of its beginning from that of the side
      end;                   ///< distance of its end from the beginning of the side
  FT side_length;            ///< of the side that contains the chain
  FT scale;                  ///< length of the opposite face's unit
  FT opposite_begin;         ///< distance of the chain's end from the beginning of the opposite face's side
  FT opposite_side_length;   ///< of the opposite face's side that contains the chain
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_EDIT_H
