// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_MAP_ALIGNMENT_REPORT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_MAP_ALIGNMENT_REPORT_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/internal/graph_checks.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// Which scale factors the transitions of an aligned map have.
enum class Scale_policy {
  AS_IS,              ///< those of the map that is given
  UNIT,               ///< all are 1: knots are the same on both sides of each edge
  DYADIC,             ///< powers of two, those next to the ones of the map
  UNIT_IF_CONSTRAINED ///< 1 where edges are constrained: a closed line on the surface can be an isoline only then; as is elsewhere
};

/// \ingroup PkgTSplinesSimilarityMap
/// How the alignment of a map ended.
enum class Map_alignment_status {
  ALIGNED,                  ///< the map was changed
  CONSTRAINTS_NOT_MET,      ///< the map was changed, but not all edges can lie on isolines: see `edges_not_met`
  INVALID_MESH,             ///< see `mesh`
  INVALID_OPTION,           ///< a weight is negative or not a number
  FLIPPED_TRIANGLES,        ///< triangles of the map are not positively oriented: see `faces`
  NOT_SEAMLESS,             ///< the two sides of a seam are not similar, at `halfedge`, by `deviation`
  INVALID_FIELD,            ///< the field has no direction in the first face of `faces`
  FIELD_OF_OTHER_SIGNATURE, ///< field and map do not turn alike around a loop through `halfedge`
  FIELD_NOT_ALIGNED, ///< the field does not follow a constrained edge, `halfedge`: it is off by `deviation` radians
  TURNED_VERTEX,     ///< the angle around `vertex` would change by full turns; nothing was changed
  SCALES_NOT_MET,    ///< no map with these scale factors was found
  SOLVER_FAILED,     ///< a factorization failed
  INTERRUPTED        ///< the visitor asked to stop; nothing was changed
};

/// \ingroup PkgTSplinesSimilarityMap
/// returns one sentence that explains `status`.
inline const char* message(const Map_alignment_status status)
{
  switch (status) {
  case Map_alignment_status::ALIGNED: return "the map follows the field";
  case Map_alignment_status::CONSTRAINTS_NOT_MET:
    return "the map follows the field, but some constrained edges cannot lie on isolines unless triangles turn over";
  case Map_alignment_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Map_alignment_status::INVALID_OPTION: return "weights must be positive numbers";
  case Map_alignment_status::FLIPPED_TRIANGLES: return "triangles of the map are not positively oriented";
  case Map_alignment_status::NOT_SEAMLESS: return "the sides of a seam of the map are not similar";
  case Map_alignment_status::INVALID_FIELD: return "the cross field has no direction in a face";
  case Map_alignment_status::FIELD_OF_OTHER_SIGNATURE:
    return "the cross field turns otherwise than the map around a loop: align the map to the field that it was made "
           "from";
  case Map_alignment_status::FIELD_NOT_ALIGNED:
    return "the cross field does not follow a constrained edge: compute it with the same edges constrained";
  case Map_alignment_status::TURNED_VERTEX: return "the angle around a vertex would change by full turns";
  case Map_alignment_status::SCALES_NOT_MET:
    return "no map with the scale factors that were asked for was found; other scale factors may do";
  case Map_alignment_status::SOLVER_FAILED: return "the sparse linear solver failed";
  case Map_alignment_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSimilarityMap
/// How far the isolines of a map are from a cross field, weighted by area, in radians.
struct Field_misalignment {
  double mean = 0;        ///< of the absolute value of the angle
  double quantile_95 = 0; ///< the angle that it exceeds on 5 % of the area
};

/// \ingroup PkgTSplinesSimilarityMap
/// What `align_seamless_map()` did and how it ended.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Map_alignment_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  Map_alignment_status status = Map_alignment_status::INVALID_MESH; ///< how it ended

  Triangle_mesh_report<TriangleMesh> mesh;                                 ///< INVALID_MESH: what is wrong with it
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< the halfedge that `status` is about
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();       ///< the vertex that `status` is about
  std::vector<typename Traits::face_descriptor> faces;                     ///< the faces that `status` is about
  double deviation = 0;                                                    ///< as `status` says

  Field_misalignment before;  ///< of the map as it was
  Field_misalignment rotated; ///< of the map turned as a whole, the best that one angle does
  Field_misalignment after;   ///< of the result

  int number_of_steps = 0;             ///< of Newton's method
  double largest_log_scale_before = 0; ///< of a transition, absolute value of the natural logarithm
  double largest_log_scale_after = 0;  ///< likewise
  double mean_distortion = 0;          ///< symmetric Dirichlet energy against the reference, by area; 0 for isometries
  double largest_distortion = 0;       ///< of a triangle

  std::size_t number_of_constrained_edges = 0;                 ///< those of the border among them
  std::vector<typename Traits::edge_descriptor> edges_not_met; ///< constrained edges that are off the isolines

  /// returns whether the map was changed and is valid.
  bool success() const
  {
    return status == Map_alignment_status::ALIGNED || status == Map_alignment_status::CONSTRAINTS_NOT_MET;
  }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
  /// returns whether all constrained edges lie on isolines.
  bool meets_constraints() const { return status == Map_alignment_status::ALIGNED; }
};

/// \ingroup PkgTSplinesSimilarityMap
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the mesh.
template <typename TriangleMesh>
std::string describe(const Map_alignment_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  if (report.status == Map_alignment_status::INVALID_MESH)
    return describe(report.mesh, mesh);
  std::ostringstream text;
  text << message(report.status);
  if (!report.faces.empty())
    text << ": " << internal::face_in_words(report.faces.front(), mesh)
         << (report.faces.size() > 1 ? " and " + std::to_string(report.faces.size() - 1) + " others" : "")
         << ", counted from 0";
  if (report.halfedge != Traits::null_halfedge())
    text << ": " << internal::edge_in_words(report.halfedge, mesh) << ", counted from 0";
  if (report.vertex != Traits::null_vertex())
    text << ": " << internal::vertex_in_words(report.vertex, mesh) << ", counted from 0";
  if (report.deviation > 0)
    text << " (off by " << report.deviation << ")";
  if (!report.edges_not_met.empty())
    text << ": " << report.edges_not_met.size() << " of " << report.number_of_constrained_edges
         << " edges, the first one " << internal::edge_in_words(halfedge(report.edges_not_met.front(), mesh), mesh);
  return text.str();
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_MAP_ALIGNMENT_REPORT_H
