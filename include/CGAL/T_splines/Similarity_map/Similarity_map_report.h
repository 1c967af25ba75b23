// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_MAP_REPORT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_MAP_REPORT_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// How the computation of a similarity map ended.
enum class Similarity_map_status {
  CONVERGED,    ///< the residual is within the tolerance at every vertex and loop; everything asked for was written
  INVALID_MESH, ///< the mesh is refused: `signature.mesh` names the element
  INVALID_SIGNATURE,      ///< the signature is refused: `signature` names the vertex, loop or component
  STALLED,                ///< no step reduces the residual any more, at `vertex` or `loop`
  ITERATION_LIMIT,        ///< the allowed number of iterations was not enough
  SIGNATURE_OUT_OF_REACH, ///< scale periods come close to hyperbolic lengths of loops: the mesh is too coarse
  SOLVER_FAILED,          ///< the linear solver refused the system
  LAYOUT_FAILED, ///< the flat metric could not be laid out with positively oriented triangles in this number type
  SUBDIVISION_TOO_LARGE, ///< the refinement of the mesh would be too large: its triangles are too long and thin
  INTERRUPTED            ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSimilarityMap
/// returns one sentence that explains `status`.
inline const char* message(const Similarity_map_status status)
{
  switch (status) {
  case Similarity_map_status::CONVERGED: return "converged";
  case Similarity_map_status::INVALID_MESH: return "the mesh is not a closed triangle mesh with positive areas";
  case Similarity_map_status::INVALID_SIGNATURE: return "the holonomy signature is not admissible on this mesh";
  case Similarity_map_status::STALLED: return "the iteration stalled: no step reduces the residual any more";
  case Similarity_map_status::ITERATION_LIMIT: return "the iteration limit was reached";
  case Similarity_map_status::SIGNATURE_OUT_OF_REACH:
    return "this signature is at the limit of what this mesh can carry; refine the mesh";
  case Similarity_map_status::SOLVER_FAILED: return "the linear solver failed";
  case Similarity_map_status::LAYOUT_FAILED: return "the map could not be laid out with positively oriented triangles";
  case Similarity_map_status::SUBDIVISION_TOO_LARGE:
    return "the long and thin triangles of the mesh are cut into too many pieces; remesh it with better triangles";
  case Similarity_map_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSimilarityMap
/// What the computation of a similarity map did and how it ended.
/// \tparam TriangleMesh a model of `HalfedgeGraph`.
template <typename TriangleMesh>
struct Similarity_map_report {
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor; ///< a vertex of the mesh
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;     ///< a face of the mesh

  /// `loop` when no loop is meant.
  static constexpr std::size_t no_loop = static_cast<std::size_t>(-1);

  Similarity_map_status status = Similarity_map_status::STALLED; ///< how it ended

  Holonomy_signature_report<TriangleMesh> signature; ///< the check of the input

  double residual = 0;                  ///< largest deviation (radians) from the signature over all vertices and loops
  std::vector<double> residual_history; ///< the residual before the first iteration and after each
  int iterations = 0;                   ///< accepted Newton steps
  int halvings = 0;                     ///< rejected trial steps
  int factorizations = 0;               ///< numeric factorizations of the linear system
  int linear_iterations = 0;            ///< solves with a factorization, those inside conjugate gradients included
  std::size_t delaunay_flips = 0;       ///< Euclidean flips that made the input intrinsically Delaunay
  std::size_t flips = 0;                ///< flips of the accepted steps
  int mantissa_bits = 53;               ///< precision of the number type in which the residual was evaluated at the end

  vertex_descriptor vertex =
      boost::graph_traits<TriangleMesh>::null_vertex(); ///< where the residual is largest, if at a vertex
  std::size_t loop = no_loop;                           ///< where the residual is largest, if at a loop
  face_descriptor face = boost::graph_traits<TriangleMesh>::
      null_face(); ///< LAYOUT_FAILED: the input face that contains a triangle which is not positively oriented
  /// If the residual stayed large: the logarithm of the scale factor along that one of the scanned short loops that is
  /// closest to its limit.
  double scale_period = 0,
         hyperbolic_length = 0; ///< of the same loop; it must stay larger than the absolute value of `scale_period`

  /// returns whether `status` tells of success.
  bool success() const { return status == Similarity_map_status::CONVERGED; }
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_MAP_REPORT_H
