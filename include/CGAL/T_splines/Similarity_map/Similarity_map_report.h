// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_MAP_REPORT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_MAP_REPORT_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
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
  OUTPUT_NOT_EMPTY,      ///< the mesh that receives the refinement has elements, or removed ones; nothing was computed
  INTERRUPTED            ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSimilarityMap
/// returns one sentence that explains `status`.
inline const char* message(const Similarity_map_status status)
{
  switch (status) {
  case Similarity_map_status::CONVERGED: return "converged";
  case Similarity_map_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Similarity_map_status::INVALID_SIGNATURE: return "the holonomy signature is not admissible on this mesh";
  case Similarity_map_status::STALLED: return "the iteration stalled: no step reduces the residual any more";
  case Similarity_map_status::ITERATION_LIMIT: return "the iteration limit was reached";
  case Similarity_map_status::SIGNATURE_OUT_OF_REACH:
    return "this signature is at the limit of what this mesh can carry; refine the mesh";
  case Similarity_map_status::SOLVER_FAILED: return "the linear solver failed";
  case Similarity_map_status::LAYOUT_FAILED: return "the map could not be laid out with positively oriented triangles";
  case Similarity_map_status::SUBDIVISION_TOO_LARGE:
    return "the long and thin triangles of the mesh are cut into too many pieces; remesh it with better triangles";
  case Similarity_map_status::OUTPUT_NOT_EMPTY:
    return "the mesh that receives the refinement is not empty; give a new one, not the input";
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

  /// `loop` or `arc` when none is meant.
  static constexpr std::size_t no_loop = static_cast<std::size_t>(-1);

  Similarity_map_status status = Similarity_map_status::STALLED; ///< how it ended

  Holonomy_signature_report<TriangleMesh> signature; ///< the check of the input

  double residual = 0; ///< largest deviation (radians) from the signature over all vertices, loops and arcs
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
  std::size_t arc = no_loop;                            ///< where the residual is largest, if at an arc
  face_descriptor face = boost::graph_traits<TriangleMesh>::
      null_face(); ///< LAYOUT_FAILED: the input face that contains a triangle which is not positively oriented
  /// If the residual stayed large: the logarithm of the scale factor along that one of the scanned short loops that is
  /// closest to its limit.
  double scale_period = 0,
         hyperbolic_length = 0; ///< of the same loop; it must stay larger than the absolute value of `scale_period`

  /// returns whether `status` tells of success.
  bool success() const { return status == Similarity_map_status::CONVERGED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

namespace internal {

/// The height of a triangle by its longest side.
template <typename TriangleMesh, typename VertexPointMap>
double flatness(const typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& mesh,
                const VertexPointMap& points)
{
  using Vector = std::array<double, 3>;
  const auto h = halfedge(f, mesh);
  const auto side = [&](const auto g) {
    const auto &p = get(points, source(g, mesh)), &q = get(points, target(g, mesh));
    return Vector{{CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()), CGAL::to_double(q.z() - p.z())}};
  };
  const auto squared_length = [](const Vector& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
  const Vector a = side(h), b = side(next(h, mesh)), c = side(next(next(h, mesh), mesh));
  const Vector normal = {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  return std::sqrt(squared_length(normal)) / (std::max)({squared_length(a), squared_length(b), squared_length(c)});
}

/// Says which triangle is the flattest, if it is so flat that it may be the cause of a failure.
template <typename TriangleMesh, typename VertexPointMap>
std::string flattest_triangle_in_words(const TriangleMesh& mesh, const VertexPointMap& points)
{
  constexpr double suspicious = 1e-6; // field meshes have 1e-3; needles of 1e-6 have made iterations stall
  std::size_t number = 0, flattest = 0;
  double smallest = suspicious;
  for (const auto f : CGAL::make_range(faces(mesh))) {
    const double value = flatness(f, mesh, points);
    if (value < smallest) {
      smallest = value;
      flattest = number;
    }
    ++number;
  }
  if (!(smallest < suspicious))
    return "";
  std::ostringstream text;
  text << "; triangle " << flattest << " is nearly flat, its height is " << smallest
       << " of its longest side: remove it by collapsing or flipping an edge of it";
  return text.str();
}

/// Where the computation of a map failed, and how close the loops came to their limit.
template <typename TriangleMesh>
std::string failed_iteration_in_words(const Similarity_map_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  const bool has_vertex = report.vertex != Traits::null_vertex(), has_face = report.face != Traits::null_face(),
             has_loop = report.loop != Similarity_map_report<TriangleMesh>::no_loop,
             has_arc = report.arc != Similarity_map_report<TriangleMesh>::no_loop;
  std::ostringstream text;
  text << message(report.status) << " (residual " << report.residual << " after " << report.iterations << " iterations";
  if (has_vertex)
    text << ", " << vertex_in_words(report.vertex, mesh);
  if (has_loop)
    text << ", loop " << report.loop;
  if (has_arc)
    text << ", arc " << report.arc;
  if (has_face)
    text << ", " << face_in_words(report.face, mesh);
  text << (has_vertex || has_loop || has_arc || has_face ? ", counted from 0)" : ")");
  if (report.hyperbolic_length > 0)
    text << "; the short loop closest to its limit has a scale factor of exp(" << report.scale_period
         << "), and the absolute value of the exponent must stay below " << report.hyperbolic_length;
  return text.str();
}

} // namespace internal

/// \ingroup PkgTSplinesSimilarityMap
/// returns what `report` says: of an input that is refused, why; of a computation that failed, how far it came, where,
/// and whether a triangle is so flat that it may be the cause. Elements are counted from 0.
/// \param report what is described
/// \param mesh the mesh that it is about
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the size of the mesh.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::string describe(const Similarity_map_report<TriangleMesh>& report, const TriangleMesh& mesh,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  switch (report.status) {
  case Similarity_map_status::CONVERGED:
  case Similarity_map_status::OUTPUT_NOT_EMPTY:
  case Similarity_map_status::INTERRUPTED: return message(report.status);
  case Similarity_map_status::INVALID_MESH:
  case Similarity_map_status::INVALID_SIGNATURE: return describe(report.signature, mesh);
  default: break;
  }
  const auto points =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_const_property_map(CGAL::vertex_point, mesh));
  return internal::failed_iteration_in_words(report, mesh) + internal::flattest_triangle_in_words(mesh, points);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_MAP_REPORT_H
