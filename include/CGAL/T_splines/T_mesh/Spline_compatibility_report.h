// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SPLINE_COMPATIBILITY_REPORT_H
#define CGAL_T_SPLINES_T_MESH_SPLINE_COMPATIBILITY_REPORT_H

#include <CGAL/T_splines/T_mesh/Admissibility_report.h>
#include <CGAL/T_splines/internal/element_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// Whether a T-mesh carries a T-spline surface, and if not, why ([CZ17] section 4.1.3). The first two values after
/// SPLINE_COMPATIBLE cannot be helped by refinement.
enum class Spline_compatibility_status {
  SPLINE_COMPATIBLE,        ///< all conditions hold
  INADMISSIBLE,             ///< the knots are not admissible: see `admissibility`
  TOUCHING_BORDERS,         ///< the border meets itself at `vertex`
  TOO_FEW_BORDER_INTERVALS, ///< fewer than three knot intervals lie between the two borders that `vertex` sees
  IRREGULAR_RINGS,          ///< A: the three rings around `vertex`, extraordinary, are not regular at `face`
  BORDER_IN_RINGS,      ///< A: the border is so close to `extraordinary_vertex` that knots of `vertex` are not uniform
  SUPPORT_REACHES_CONE, ///< B: the support of `vertex` reaches `face`, incident to `extraordinary_vertex`
  ENDLESS_SUPPORT,      ///< B: the support of `vertex` winds around a point that is not on the surface, over `face`
  INTERRUPTED           ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesTMesh
/// returns one sentence that explains `status`.
inline const char* message(const Spline_compatibility_status status)
{
  switch (status) {
  case Spline_compatibility_status::SPLINE_COMPATIBLE: return "the T-mesh is spline compatible";
  case Spline_compatibility_status::INADMISSIBLE: return "the halfedge knots are not admissible";
  case Spline_compatibility_status::TOUCHING_BORDERS: return "the border meets itself at a vertex";
  case Spline_compatibility_status::TOO_FEW_BORDER_INTERVALS:
    return "less than three knot intervals lie between two borders";
  case Spline_compatibility_status::IRREGULAR_RINGS:
    return "condition A: an extraordinary vertex is not surrounded by three conforming, uniform rings of faces";
  case Spline_compatibility_status::BORDER_IN_RINGS:
    return "condition A: the border is too close to the rings around an extraordinary vertex";
  case Spline_compatibility_status::SUPPORT_REACHES_CONE:
    return "condition B: the support of a vertex outside of the second ring reaches a face at an extraordinary vertex";
  case Spline_compatibility_status::ENDLESS_SUPPORT:
    return "condition B: the support of a vertex winds without an end around a point that is not on the surface";
  case Spline_compatibility_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesTMesh
/// The result of `check_spline_compatibility()` and `make_spline_compatible()`: which condition fails, and where. Members
/// that `status` does not mention have no meaning.
/// \tparam Graph a model of `FaceGraph`.
template <typename Graph>
struct Spline_compatibility_report {
  using Traits = boost::graph_traits<Graph>;

  Spline_compatibility_status status = Spline_compatibility_status::SPLINE_COMPATIBLE; ///< which condition fails
  Admissibility_report<Graph> admissibility;                                           ///< INADMISSIBLE: why
  typename Traits::vertex_descriptor vertex = Traits::null_vertex(); ///< the vertex that `status` is about
  /// the extraordinary vertex that is concerned.
  typename Traits::vertex_descriptor extraordinary_vertex = Traits::null_vertex();
  typename Traits::face_descriptor face = Traits::null_face(); ///< the face that `status` is about
  /// Of a spline compatible T-mesh: how many supports cover some face on two ways around the surface, condition C of
  /// [CZ17] 4.1.3. That is allowed.
  std::size_t self_overlapping_supports = 0;

  /// returns whether all conditions hold.
  bool success() const { return status == Spline_compatibility_status::SPLINE_COMPATIBLE; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTMesh
/// returns what `report` says and the numbers of the elements concerned. Complexity: linear in the size of the T-mesh.
template <typename Graph>
std::string describe(const Spline_compatibility_report<Graph>& report, const Graph& graph)
{
  if (report.status == Spline_compatibility_status::INADMISSIBLE)
    return describe(report.admissibility, graph);
  return message(report.status) + internal::numbered_elements(graph, report.vertex, report.face);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SPLINE_COMPATIBILITY_REPORT_H
