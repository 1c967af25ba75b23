// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_DETECT_FEATURES_H
#define CGAL_T_SPLINES_CROSS_FIELD_DETECT_FEATURES_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/feature_figures.h>
#include <CGAL/T_splines/Cross_field/internal/Feature_detection.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_config.h>

#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// How the detection of features ended.
enum class Feature_detection_status {
  DETECTED,      ///< the features were marked; there may be none
  INVALID_MESH,  ///< the mesh is refused: see `mesh`
  INVALID_ANGLE, ///< an angle is not a number between 0 and 180, or the weak angle is larger than the other one
  INTERRUPTED    ///< the visitor asked to stop; nothing was written
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Feature_detection_status status)
{
  switch (status) {
  case Feature_detection_status::DETECTED: return "the features were marked";
  case Feature_detection_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Feature_detection_status::INVALID_ANGLE:
    return "a feature angle is not between 0 and 180 degrees, or the weak one is larger than the other one";
  case Feature_detection_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// What was detected, or why nothing was.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Feature_detection_report {
  Feature_detection_status status = Feature_detection_status::DETECTED; ///< how it ended
  Triangle_mesh_report<TriangleMesh> mesh;                              ///< the check of the mesh
  Feature_figures features;                                             ///< the features that were marked

  /// returns whether `status` tells of success.
  bool success() const { return status == Feature_detection_status::DETECTED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says: the figures of the features, or what was wrong. Complexity: linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Feature_detection_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  switch (report.status) {
  case Feature_detection_status::DETECTED: return describe(report.features);
  case Feature_detection_status::INVALID_MESH: return describe(report.mesh, mesh);
  default: return message(report.status);
  }
}

/// \ingroup PkgTSplinesCrossField
/// marks the edges where a surface is sharp.
///
/// An edge is sharp if its faces differ in direction by the feature angle. Chains of such edges are extended from their loose
/// ends along edges that turn by the weak feature angle. The noise of a scan, or the triangles of a coarse model of an
/// animal, are sharp in this sense at many places. So some things more are asked of an arc, a chain between vertices with
/// other than two marked edges:
/// - it is prominent: it turns, in the mean, by at least 8 times more than half of the other edges at its vertices, by
///   their lengths;
/// - it is not a short spur: if it ends inside the surface it is at least as long as 5 % of the longest side of the
///   bounding box of its component, if both of its ends do, 10 %, and if it is closed, 2 %;
/// - it is not the rim of a single triangle.
///
/// What is dropped counts among the others for what is left, until nothing is dropped any more. Neither depends on the
/// size of the triangles by itself: where a mesh of the same surface is finer, its creases are as sharp, and the edges
/// around them turn less. A mesh whose triangles were divided into flat parts is taken for what it is, a solid of flat faces.
///
/// The border is not marked; fields follow it anyway.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `WritablePropertyMap` from edges to `bool`
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands; it may have a border
/// \param edge_is_feature receives for each edge whether it is a feature; it stays what it was if the status is not
///        DETECTED
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a geometric traits class}
///     \cgalParamType{a model of `Kernel`}
///     \cgalParamDefault{the kernel of the points, a new object}
///   \cgalParamNEnd
///   \cgalParamNBegin{feature_angle}
///     \cgalParamDescription{by how much the normals of the faces at a feature differ, in degrees}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_feature_angle`, 40}
///   \cgalParamNEnd
///   \cgalParamNBegin{weak_feature_angle}
///     \cgalParamDescription{by how much they differ where a feature goes on beyond its end, in degrees}
///     \cgalParamType{`double`}
///     \cgalParamDefault{half of the feature angle}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status and the figures of the features.
/// Complexity: linear in the size of the mesh, times the number of rounds in which arcs are dropped: few.
template <typename TriangleMesh, typename EdgeIsFeatureMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Feature_detection_report<TriangleMesh> detect_features(const TriangleMesh& mesh, EdgeIsFeatureMap edge_is_feature,
                                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  constexpr double degree = CGAL_PI / 180;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("features");
  Feature_detection_report<TriangleMesh> report;
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success()) {
    report.status =
        progress.is_interrupted() ? Feature_detection_status::INTERRUPTED : Feature_detection_status::INVALID_MESH;
    return report;
  }
  const double angle = choose_parameter(get_parameter(np, np_tags::feature_angle), default_feature_angle);
  const double weak_angle = choose_parameter(get_parameter(np, np_tags::weak_feature_angle), angle / 2);
  if (!(weak_angle > 0 && weak_angle <= angle && angle < 180)) {
    report.status = Feature_detection_status::INVALID_ANGLE;
    return report;
  }
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  const std::vector<double> sizes = internal::component_sizes(
      domain.m_indexing, domain.m_components, domain.m_geometry,
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(vertex_point, mesh)));
  internal::Feature_detection detection(domain.m_connectivity, domain.m_geometry, domain.m_components, sizes);
  const std::vector<char>& is_feature = detection.detect(angle * degree, weak_angle * degree, progress);
  if (!progress.go_on()) {
    report.status = Feature_detection_status::INTERRUPTED;
    return report;
  }
  report.features = internal::figures_of_features(domain.m_connectivity, domain.m_geometry, is_feature);
  for (int e = 0; e < domain.m_connectivity.number_of_edges(); ++e)
    put(edge_is_feature, edge(domain.m_indexing.halfedge(internal::halfedge_of_edge(e)), mesh), is_feature[e] != 0);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_DETECT_FEATURES_H
