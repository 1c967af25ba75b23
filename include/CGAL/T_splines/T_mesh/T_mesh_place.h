// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_PLACE_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_PLACE_H

#include <CGAL/T_splines/Similarity_2.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// A point of a T-mesh: a face, and coordinates in its frame.
///
/// The frame of a face has its origin where the side of its `halfedge()` begins; u runs along that side, v to its left;
/// the face is [0, width] x [0, height] in units of its knot intervals.
template <typename Graph, typename FT>
struct T_mesh_place {
  typename boost::graph_traits<Graph>::face_descriptor face = boost::graph_traits<Graph>::null_face(); ///< the face
  FT u = FT(0),  ///< coordinate along the first side
      v = FT(0); ///< coordinate to the left of it
};

/// \ingroup PkgTSplinesTMesh
/// How a face of a T-mesh lies on the surface: a triangle of the mapped mesh whose interior it meets, and the
/// similarity from the chart of that triangle to the frame of the face.
///
/// The part of the surface that the face covers follows by crossing edges inside the face.
template <typename TriangleMesh, typename FT>
struct T_mesh_anchor {
  /// a face of the mapped mesh.
  typename boost::graph_traits<TriangleMesh>::face_descriptor triangle = boost::graph_traits<TriangleMesh>::null_face();
  Similarity_2<FT> to_face; ///< from the chart of the triangle to the frame of the face
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_PLACE_H
