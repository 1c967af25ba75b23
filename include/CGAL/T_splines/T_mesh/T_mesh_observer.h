// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_OBSERVER_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_OBSERVER_H

#include <CGAL/T_splines/Similarity_2.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// Where a part of an old face of a T-mesh went: the frame of `from` goes by `transition` to that of `to`, whose
/// rectangle is now [0, `width`] x [0, `height`].
///
/// `from` may be a face that is about to be removed. A point of `from` belongs to the first piece with that `from`
/// whose image lies in the rectangle of `to`.
/// \tparam Graph a model of `FaceGraph`
/// \tparam FT_ the number type of the knots
template <typename Graph, typename FT_>
struct T_mesh_piece {
  using FT = FT_;                                                               ///< number type of the knots
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor; ///< a face of the graph

  face_descriptor from,        ///< the old face
      to;                      ///< the new face
  Similarity_2<FT> transition; ///< from the old frame to the new one
  FT width,                    ///< of the new face
      height;                  ///< of the new face
};

/// \ingroup PkgTSplinesTMesh
/// The observer of T-mesh operations that does nothing, and the list of what such an observer offers: a model of
/// `TMeshObserver`.
///
/// \cgalModels{TMeshObserver}
struct T_mesh_observer {
  /// is called after the vertex `v` was inserted into an edge; `h` ends at `v`, and `next(h)` is the other part.
  template <typename Vertex, typename Halfedge>
  void vertex_inserted(Vertex /*v*/, Halfedge /*h*/) const
  {
  }

  /// is called before the vertex `v` is removed, at which `h` ends; only `next(h)` leaves it, and `h` takes its place.
  template <typename Vertex, typename Halfedge>
  void vertex_removed(Vertex /*v*/, Halfedge /*h*/) const
  {
  }

  /// is called after the vertex `v`, at which `h` ends, moved with a line that was shifted.
  template <typename Vertex, typename Halfedge>
  void vertex_moved(Vertex /*v*/, Halfedge /*h*/) const
  {
  }

  /// is called after the edge of `h` was inserted across a face.
  template <typename Halfedge>
  void edge_inserted(Halfedge /*h*/) const
  {
  }

  /// is called before the edge of `h` is removed between two faces.
  template <typename Halfedge>
  void edge_removed(Halfedge /*h*/) const
  {
  }

  /// is called after the lines of the T-mesh changed, with all old faces whose frame or extent is another.
  template <typename Graph, typename FT>
  void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& /*pieces*/) const
  {
  }
};

/// \ingroup PkgTSplinesTMesh
/// Two observers of T-mesh operations, called one after the other; a model of `TMeshObserver`.
///
/// \cgalModels{TMeshObserver}
template <typename First, typename Second>
class T_mesh_observer_pair {
public:
  /// copies both observers.
  T_mesh_observer_pair(const First& first, const Second& second) : m_first(first), m_second(second) {}

  /// calls both.
  template <typename Vertex, typename Halfedge>
  void vertex_inserted(const Vertex v, const Halfedge h) const
  {
    m_first.vertex_inserted(v, h);
    m_second.vertex_inserted(v, h);
  }

  /// calls both.
  template <typename Vertex, typename Halfedge>
  void vertex_removed(const Vertex v, const Halfedge h) const
  {
    m_first.vertex_removed(v, h);
    m_second.vertex_removed(v, h);
  }

  /// calls both.
  template <typename Vertex, typename Halfedge>
  void vertex_moved(const Vertex v, const Halfedge h) const
  {
    m_first.vertex_moved(v, h);
    m_second.vertex_moved(v, h);
  }

  /// calls both.
  template <typename Halfedge>
  void edge_inserted(const Halfedge h) const
  {
    m_first.edge_inserted(h);
    m_second.edge_inserted(h);
  }

  /// calls both.
  template <typename Halfedge>
  void edge_removed(const Halfedge h) const
  {
    m_first.edge_removed(h);
    m_second.edge_removed(h);
  }

  /// calls both.
  template <typename Graph, typename FT>
  void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
  {
    m_first.faces_replaced(pieces);
    m_second.faces_replaced(pieces);
  }

private:
  First m_first;
  Second m_second;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_OBSERVER_H
