// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_APPROXIMATION_T_SPLINE_APPROXIMATION_REPORT_H
#define CGAL_T_SPLINES_APPROXIMATION_T_SPLINE_APPROXIMATION_REPORT_H

#include <CGAL/T_splines/Cross_field/Cone_reduction_report.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/compute_feature_aligned_cross_field.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/Map_alignment_report.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/Motorcycle_graph_report.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesApproximation
/// How far the way from a mesh to a T-spline surface went.
enum class T_spline_approximation_status {
  SUCCESS,               ///< all stages that were run have their result
  MISSING_RESULT,        ///< a stage was run before the one that it needs
  INVALID_MESH,          ///< the mesh cannot be approximated: see `mesh`
  INVALID_SIGNATURE,     ///< the field, the cones or the signature given fit no map: see `signature`
  CONE_REDUCTION_FAILED, ///< the cones could not be merged as asked for: see `cone_reduction`
  MAP_FAILED,            ///< there is no seamless map: see `map`
  ALIGNMENT_FAILED,      ///< the map could not be aligned: see `alignment`
  EXACT_MAP_FAILED,      ///< the map cannot be made exactly seamless: see `exact_map`
  TRACING_FAILED,        ///< there is no T-mesh: see `motorcycle_graph`
  PLACEMENT_FAILED,      ///< the T-mesh does not lie on the surface
  FIT_FAILED,            ///< there is no surface: see `fit`
  INTERRUPTED            ///< the visitor stopped the work
};

/// \ingroup PkgTSplinesApproximation
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_approximation_status status)
{
  switch (status) {
  case T_spline_approximation_status::SUCCESS: return "all stages succeeded";
  case T_spline_approximation_status::MISSING_RESULT: return "a stage was run before the one that it needs";
  case T_spline_approximation_status::INVALID_MESH: return "the mesh cannot be approximated";
  case T_spline_approximation_status::INVALID_SIGNATURE: return "the holonomy signature is not admissible";
  case T_spline_approximation_status::CONE_REDUCTION_FAILED: return "the cones could not be merged";
  case T_spline_approximation_status::MAP_FAILED: return "there is no seamless map";
  case T_spline_approximation_status::ALIGNMENT_FAILED: return "the map could not be aligned to the cross field";
  case T_spline_approximation_status::EXACT_MAP_FAILED: return "the map cannot be made exactly seamless";
  case T_spline_approximation_status::TRACING_FAILED: return "there is no T-mesh";
  case T_spline_approximation_status::PLACEMENT_FAILED: return "the T-mesh does not lie on the surface";
  case T_spline_approximation_status::FIT_FAILED: return "there is no surface within the limits";
  case T_spline_approximation_status::INTERRUPTED: return "the work was interrupted";
  }
  return "";
}

/// \ingroup PkgTSplinesApproximation
/// What a `T_spline_approximation`, or `approximate_by_T_spline()`, did: the reports of the stages that were run.
/// Members that `status` does not mention have no meaning unless their stage was run with success.
/// \tparam TriangleMesh the mesh
template <typename TriangleMesh>
struct T_spline_approximation_report {
  /// Of the refined mesh that the map lives on, and of the T-mesh.
  using Graph = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

  T_spline_approximation_status status = T_spline_approximation_status::SUCCESS; ///< how it ended
  std::string reason; ///< of a failure: what the report of the stage says, with the elements concerned
  Triangle_mesh_report<TriangleMesh> mesh;                  ///< INVALID_MESH: what is wrong with it
  Smooth_cross_field_report<TriangleMesh> cross_field;      ///< of the computed field
  Feature_aligned_field_report<TriangleMesh> feature_field; ///< of the computed field, where there are features
  Holonomy_signature_report<TriangleMesh> signature;        ///< of the field's signature, or of that of given cones
  Cone_reduction_report<TriangleMesh> cone_reduction;       ///< of the merges of cones
  Similarity_map_report<TriangleMesh> map;                  ///< of the seamless map
  Map_alignment_report<Graph> alignment;               ///< of the map that follows the field, where there are features
  Exact_map_report<Graph> exact_map;                   ///< of the exactly seamless map
  Motorcycle_graph_report motorcycle_graph;            ///< of the T-mesh as traced
  T_mesh_regularization_report regularization;         ///< of the T-mesh with squarer faces
  Adaptive_fit_report<Graph, Graph, TriangleMesh> fit; ///< of the surface

  /// returns whether all stages have their result. The surface may be beyond the tolerance.
  bool success() const { return status == T_spline_approximation_status::SUCCESS; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }

  /// returns whether the surface is what was asked for, as `Adaptive_fit_report::within_tolerance()` says.
  bool within_tolerance() const { return success() && !fit.levels.empty() && fit.within_tolerance(); }
};

/// \ingroup PkgTSplinesApproximation
/// returns what `report` says: why there is no surface, or how good it is, in one sentence with the elements and figures
/// concerned, counted from 0.
template <typename TriangleMesh>
std::string describe(const T_spline_approximation_report<TriangleMesh>& report, const TriangleMesh& /*mesh*/)
{
  using Graph = typename T_spline_approximation_report<TriangleMesh>::Graph;
  if (report.success())
    return report.fit.levels.empty() ? message(report.status) : describe(report.fit, Graph());
  return report.reason.empty() ? message(report.status) : report.reason;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_APPROXIMATION_T_SPLINE_APPROXIMATION_REPORT_H
