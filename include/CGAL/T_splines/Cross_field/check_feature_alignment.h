// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_CHECK_FEATURE_ALIGNMENT_H
#define CGAL_T_SPLINES_CROSS_FIELD_CHECK_FEATURE_ALIGNMENT_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/feature_figures.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/Vertex_sectors.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
#include <CGAL/T_splines/Cross_field/internal/sector_turns.h>
#include <CGAL/T_splines/Cross_field/support/cross_angles.h>
#include <CGAL/T_splines/Cross_field/support/matched_rotations.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// Whether a cross field follows features.
enum class Feature_alignment_status {
  ALIGNED,             ///< the field follows all features, and each sector has a quarter turn
  INVALID_MESH,        ///< the mesh is refused: see `mesh`
  INVALID_CORNERS,     ///< the corners that are given are refused: see `corners`
  INVALID_FIELD,       ///< the field has no direction at `face`
  NOT_ALIGNED,         ///< the cross in the face of `halfedge` is off the direction of this feature by `deviation`
  SECTOR_WITHOUT_TURN, ///< the sector that begins with `halfedge`, at its source, has `actual` < 1 quarter turns
  INTERRUPTED          ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Feature_alignment_status status)
{
  switch (status) {
  case Feature_alignment_status::ALIGNED: return "the field follows the features";
  case Feature_alignment_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Feature_alignment_status::INVALID_CORNERS: return "the corners are not those of a border";
  case Feature_alignment_status::INVALID_FIELD: return "the field has no direction in a face";
  case Feature_alignment_status::NOT_ALIGNED: return "the field does not follow a feature";
  case Feature_alignment_status::SECTOR_WITHOUT_TURN:
    return "between two features at a vertex the field makes no quarter turn";
  case Feature_alignment_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// Whether a cross field follows features, by how much it does not, and where. Members that `status` does not mention have
/// no meaning, but `deviation`.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Feature_alignment_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  Feature_alignment_status status = Feature_alignment_status::ALIGNED; ///< what is wrong
  Triangle_mesh_report<TriangleMesh> mesh;                             ///< the check of the mesh
  Holonomy_signature_report<TriangleMesh> corners;                     ///< the check of the named parameter `corners`
  typename Traits::face_descriptor face = Traits::null_face();         ///< a face without direction
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< of a feature
  int actual = 0;                                                          ///< quarter turns of a sector
  double deviation = 0; ///< the largest angle between a feature and the cross beside it, in degrees

  /// returns whether `status` tells of success.
  bool success() const { return status == Feature_alignment_status::ALIGNED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says, and where, elements counted from 0. Complexity: linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Feature_alignment_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  std::ostringstream text;
  text << message(report.status);
  switch (report.status) {
  case Feature_alignment_status::INVALID_MESH: return describe(report.mesh, mesh);
  case Feature_alignment_status::INVALID_CORNERS: return describe(report.corners, mesh);
  case Feature_alignment_status::INVALID_FIELD:
    text << ": " << internal::face_in_words(report.face, mesh) << ", counted from 0";
    break;
  case Feature_alignment_status::NOT_ALIGNED:
    text << ": it is off by " << report.deviation << " degrees at the "
         << internal::edge_in_words(report.halfedge, mesh) << ", counted from 0";
    break;
  case Feature_alignment_status::SECTOR_WITHOUT_TURN:
    text << ": at the source of the " << internal::edge_in_words(report.halfedge, mesh) << ", counted from 0, but "
         << report.actual;
    break;
  case Feature_alignment_status::ALIGNED:
  case Feature_alignment_status::INTERRUPTED: break;
  }
  return text.str();
}

namespace internal {

// The halfedge of a feature where the cross deviates most, or null, and the angle.
inline int worst_feature(const Triangulation_connectivity& mesh, const std::vector<char>& is_feature,
                         const std::vector<double>& angle, double& deviation)
{
  int worst = Triangulation_connectivity::null;
  deviation = 0;
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    const double off = is_feature[edge_of(h)] ? std::abs(std::remainder(angle[h], quarter_turn)) : 0.;
    if (off > deviation) {
      deviation = off;
      worst = h;
    }
  }
  return worst;
}

// The quarter turns that a field makes in each sector, by its matchings if there are any.
template <typename TriangleMesh, typename NamedParameters>
std::vector<int> turns_of_sectors(const Signature_domain<TriangleMesh>& domain, const Vertex_sectors& sectors,
                                  const std::vector<double>& angle_in_face, const NamedParameters& np)
{
  const Triangulation_connectivity& mesh = domain.m_connectivity;
  int worst_on_border = 0;
  double deviation_of_border = 0;
  const std::vector<double> border_cross =
      border_crosses(mesh, domain.m_geometry, domain.guide(np),
                     angles_to_halfedges(mesh, domain.m_geometry, angle_in_face), worst_on_border, deviation_of_border);
  std::vector<int> result;
  for (const double turns : sectors.quarter_turns(
           domain.m_geometry.m_corner_angle,
           matched_rotations(domain.m_indexing, mesh, angles_to_halfedges(mesh, domain.m_geometry, angle_in_face), np),
           border_cross))
    result.push_back(static_cast<int>(std::lround(turns)));
  return result;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// checks whether a cross field follows features, and whether it makes at least one quarter turn in each sector between
/// two of them, or between one and the border: what a map along features needs.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadablePropertyMap` from edges to `bool`
/// \tparam CrossFieldMap a model of `ReadablePropertyMap` from faces to three-dimensional vectors
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands; it may have a border
/// \param edge_is_feature the features; marks on the border do not matter
/// \param cross_field one of the four directions of the cross in each face
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
///   \cgalParamNBegin{halfedge_matching_map}
///     \cgalParamDescription{the matchings of the field, as `holonomy_signature_of_cross_field()` takes them}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` -> an
///       integer}
///     \cgalParamDefault{none: the closest rotation decides}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_sector_turns_map}
///     \cgalParamDescription{receives the quarter turns of the sectors, as `compute_feature_aligned_cross_field()` writes
///       them, if the field follows the features}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       an integer}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{largest_feature_deviation}
///     \cgalParamDescription{the largest angle between a feature and the cross beside it, in degrees}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_feature_deviation`, 0.001: fields in files have six digits}
///   \cgalParamNEnd
///   \cgalParamNBegin{corners}
///     \cgalParamDescription{the vertices on the border with other than two quarter turns, and their numbers}
///     \cgalParamType{`std::optional<std::vector<Holonomy_signature<TriangleMesh>::Corner>>`}
///     \cgalParamDefault{`std::nullopt`: where the border turns by more than the corner angle}
///   \cgalParamNEnd
///   \cgalParamNBegin{corner_angle}
///     \cgalParamDescription{by how much the border turns at a corner, in degrees}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_corner_angle`, 50}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the first thing found wrong; of alignment, the worst. Complexity: linear in the size of the mesh.
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Feature_alignment_report<TriangleMesh>
check_feature_alignment(const TriangleMesh& mesh, const EdgeIsFeatureMap& edge_is_feature,
                        const CrossFieldMap& cross_field,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Status = Feature_alignment_status;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("feature check");
  Feature_alignment_report<TriangleMesh> report;
  const auto fail = [&report](const Status status) {
    report.status = status;
    return report;
  };
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success())
    return fail(progress.is_interrupted() ? Status::INTERRUPTED : Status::INVALID_MESH);
  internal::check_given_corners(mesh, np, report.corners);
  if (!report.corners.success())
    return fail(Status::INVALID_CORNERS);
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  const internal::Triangulation_connectivity& connectivity = domain.m_connectivity;
  std::vector<double> angle_in_face;
  const int face =
      internal::cross_angles(domain.m_indexing, connectivity, domain.m_geometry, cross_field, angle_in_face);
  if (face != internal::Triangulation_connectivity::null) {
    report.face = domain.m_indexing.face(face);
    return fail(Status::INVALID_FIELD);
  }
  const std::vector<char> is_feature = internal::inner_features(domain.m_indexing, connectivity, edge_is_feature);
  const int worst = internal::worst_feature(
      connectivity, is_feature, internal::angles_to_halfedges(connectivity, domain.m_geometry, angle_in_face),
      report.deviation);
  report.deviation *= 180 / CGAL_PI;
  if (report.deviation >
      choose_parameter(get_parameter(np, np_tags::largest_feature_deviation), default_feature_deviation)) {
    report.halfedge = domain.m_indexing.halfedge(worst);
    return fail(Status::NOT_ALIGNED);
  }
  if (!progress.go_on())
    return fail(Status::INTERRUPTED);
  const internal::Vertex_sectors sectors(connectivity, is_feature);
  const std::vector<int> turns = internal::turns_of_sectors(domain, sectors, angle_in_face, np);
  const auto sector_turns = get_parameter(np, np_tags::halfedge_sector_turns_map);
  if constexpr (!internal::is_missing<decltype(sector_turns)>)
    internal::put_sector_turns(domain.m_indexing, connectivity, sectors, turns, sector_turns);
  for (int s = 0; s < sectors.size() && report.success(); ++s)
    if (sectors.has_bounds(s) && !sectors.is_between_borders(s) && turns[s] < 1) {
      report.halfedge = domain.m_indexing.halfedge(sectors.first(s));
      report.actual = turns[s];
      report.status = Status::SECTOR_WITHOUT_TURN;
    }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_CHECK_FEATURE_ALIGNMENT_H
