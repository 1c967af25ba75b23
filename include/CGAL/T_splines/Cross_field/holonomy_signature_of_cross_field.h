// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CROSS_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CROSS_FIELD_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/internal/Corner_turns.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
#include <CGAL/T_splines/Cross_field/support/cross_angles.h>
#include <CGAL/T_splines/Cross_field/support/matched_rotations.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// A cross that is further from the direction of the border might as well be turned the other way.
constexpr double largest_border_deviation = 30 * CGAL_PI / 180;

// A field and what it is measured by: the rotations across edges, and the crosses at the border.
struct Field_holonomy {
  std::vector<double> rotation;     // per edge
  std::vector<double> border_cross; // per edge on the border
};

template <typename TriangleMesh>
void set_vertices(const Signature_domain<TriangleMesh>& mesh, const Field_holonomy& field,
                  Holonomy_signature<TriangleMesh>& signature, Holonomy_signature_report<TriangleMesh>& report)
{
  const std::vector<double> turns =
      vertex_quarter_turns(mesh.m_connectivity, mesh.m_geometry.m_corner_angle, field.rotation, field.border_cross);
  std::vector<char> is_on_border(turns.size(), 0);
  for (int h = 0; h < mesh.m_connectivity.number_of_halfedges(); ++h)
    if (mesh.m_connectivity.face(h) == Triangulation_connectivity::null)
      is_on_border[mesh.m_connectivity.target(h)] = 1;
  for (int v = 0; v < mesh.m_connectivity.number_of_vertices(); ++v) {
    int k = 0;
    if (!round_turns(turns[v], k, report.deviation)) {
      report.status = Holonomy_signature_status::VERTEX_NOT_INTEGER;
      report.vertex = mesh.m_indexing.vertex(v);
      return;
    }
    if (is_on_border[v])
      signature.set_corner_quarter_turns(mesh.m_indexing.vertex(v), k);
    else
      signature.set_quarter_turns(mesh.m_indexing.vertex(v), k);
  }
}

// Measures strips and hands each of them with its number to `add(halfedges, k)`. \return whether they are integers
template <typename TriangleMesh, typename Add>
bool add_strips(const Signature_domain<TriangleMesh>& mesh, const Field_holonomy& field,
                const std::vector<std::vector<int>>& strips, Progress& progress,
                Holonomy_signature_report<TriangleMesh>& report, const Add& add)
{
  for (std::size_t i = 0; i < strips.size() && progress.go_on_after(strips[i].size()); ++i) {
    int k = 0;
    if (!round_turns(strip_quarter_turns(mesh.m_connectivity, strips[i], mesh.m_geometry.m_corner_angle, field.rotation,
                                         field.border_cross),
                     k, report.deviation)) {
      report.index = i;
      return false;
    }
    add(mesh.halfedges_of(strips[i]), k);
  }
  return true;
}

// Which vertices of a curve of the border keep a corner if as few as possible make up the sum of those of the field: where
// a direction of the cross passes the diagonals of the border there and back, there is none.
// \return the vertices, those with more than one corner several times, and the sign of 2 - k, the same for all
template <typename TriangleMesh>
std::pair<std::vector<int>, int> fewest_corners(const Signature_domain<TriangleMesh>& mesh,
                                                const std::vector<int>& curve,
                                                const Holonomy_signature<TriangleMesh>& signature)
{
  std::vector<int> corners;
  int sign = 0;
  for (const int h : curve) {
    const int v = mesh.m_connectivity.target(h);
    const int turns = Border_guide::regular - signature.corner_quarter_turns(mesh.m_indexing.vertex(v));
    for (int i = 0; i < std::abs(turns); ++i) {
      const int sign_of_turn = turns > 0 ? 1 : -1;
      if (corners.empty())
        sign = sign_of_turn;
      if (sign == sign_of_turn)
        corners.push_back(v);
      else
        corners.pop_back();
    }
  }
  return {corners, sign};
}

// Gives the border the corners that it should have, in place of those of a field that does not follow it; where that
// would take other cones, as few as the field has at least.
// \param are_given whether the corners of the guide are to be had in any case
template <typename TriangleMesh>
void align_corners(const Signature_domain<TriangleMesh>& mesh, const Border_guide& guide, const bool are_given,
                   Holonomy_signature<TriangleMesh>& signature)
{
  const auto vertex = [&mesh](const int v) { return mesh.m_indexing.vertex(v); };
  const std::vector<std::vector<int>> curves = border_curves(mesh.m_connectivity);
  std::vector<int> excess(mesh.m_components.size(), 0); // of the quarter turns of the field
  for (const std::vector<int>& curve : curves)
    for (const int h : curve) {
      const int v = mesh.m_connectivity.target(h);
      excess[mesh.m_components.of_vertex[v]] += signature.corner_quarter_turns(vertex(v)) - guide.quarter_turns()[v];
    }
  for (const std::vector<int>& curve : curves) {
    const bool is_guided =
        are_given || excess[mesh.m_components.of_vertex[mesh.m_connectivity.target(curve.front())]] == 0;
    const auto [corners, sign] = fewest_corners(mesh, curve, signature);
    for (const int h : curve) {
      const int v = mesh.m_connectivity.target(h);
      const int number = static_cast<int>(std::count(corners.begin(), corners.end(), v));
      signature.set_corner_quarter_turns(vertex(v),
                                         is_guided ? guide.quarter_turns()[v] : Border_guide::regular - sign * number);
    }
  }
}

template <typename TriangleMesh>
void signature_of_rotations(const Signature_domain<TriangleMesh>& mesh, const Field_holonomy& field, Progress& progress,
                            Holonomy_signature<TriangleMesh>& signature,
                            Holonomy_signature_report<TriangleMesh>& report)
{
  set_vertices(mesh, field, signature, report);
  progress.progress(0.3);
  if (!report.success() || !progress.go_on())
    return;
  if (!add_strips(mesh, field, mesh.short_loops(progress), progress, report,
                  [&](auto halfedges, const int k) { signature.add_loop(std::move(halfedges), k); }))
    report.status = Holonomy_signature_status::LOOP_NOT_INTEGER;
  else if (!add_strips(mesh, field, mesh.short_arcs(progress), progress, report,
                       [&](auto halfedges, const int k) { signature.add_arc(std::move(halfedges), k); }))
    report.status = Holonomy_signature_status::ARC_NOT_INTEGER;
}

// Whether the signature of a field has the corners of the guide.
template <typename TriangleMesh>
void check_corners_are_met(const Signature_domain<TriangleMesh>& domain, const Border_guide& guide,
                           const Holonomy_signature<TriangleMesh>& signature,
                           Holonomy_signature_report<TriangleMesh>& report)
{
  for (int h = 0; h < domain.m_connectivity.number_of_halfedges() && report.success(); ++h) {
    if (domain.m_connectivity.face(h) != Triangulation_connectivity::null)
      continue;
    const int v = domain.m_connectivity.target(h);
    report.vertex = domain.m_indexing.vertex(v);
    report.expected = guide.quarter_turns()[v];
    report.actual = signature.corner_quarter_turns(report.vertex);
    if (report.actual != report.expected)
      report.status = Holonomy_signature_status::CORNERS_NOT_MET;
  }
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// computes the holonomy signature of a cross field: how often the crosses turn around each vertex, along 2g short loops that
/// generate the homology of each connected component, and along short arcs that join the closed curves of its border.
///
/// On a border the crosses must follow its direction: that of its edges but for their noise, see the parameter
/// `corner_angle`.
/// Crosses in neighboring faces are matched by the closest rotation, at most pi/4, unless matchings are given. The number
/// of a loop is the turning of its strip in the metric of the mesh minus the rotations of the field across its edges ([CZ17]
/// section 2.1), the same for a vertex and the counter-clockwise loop around it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `ReadablePropertyMap` from faces to three-dimensional vectors
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands; it may have a border
/// \param cross_field one of the four directions of the cross in each face; its length and its component normal to the
///        face do not matter
/// \param signature is cleared and filled; its contents are meaningful only upon success. It stays what it was if the
///        status is INTERRUPTED
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
///     \cgalParamDescription{for the halfedge `h = halfedge(e, mesh)` of each edge `e`, the number m of quarter turns
///       such that the direction in the face of `opposite(h)` corresponds to the one in the face of `h` turned
///       counter-clockwise by m pi/2; it decides where the closest rotation would be another}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` -> an
///       integer}
///     \cgalParamDefault{none: the closest rotation decides}
///   \cgalParamNEnd
///   \cgalParamNBegin{corners}
///     \cgalParamDescription{the vertices on the border with other than two quarter turns, and their numbers. Where the
///       crosses turn otherwise, the difference is carried to inner vertices nearby}
///     \cgalParamType{`std::optional<std::vector<Holonomy_signature<TriangleMesh>::Corner>>`}
///     \cgalParamDefault{`std::nullopt`: where the border turns by more than the corner angle}
///   \cgalParamNEnd
///   \cgalParamNBegin{corner_angle}
///     \cgalParamDescription{by how much the border turns at a corner, in degrees: within the surface, over one part in 64
///       of its length to either side}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_corner_angle`, 50}
///   \cgalParamNEnd
///   \cgalParamNBegin{align_border}
///     \cgalParamDescription{whether a field that does not follow the border stands for one that does, with the same cones
///       and turning numbers: it has the corners that it should have, or, on components where other cones would belong to
///       these, as few as belong to its own}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`: it is refused}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status INVALID_MESH, INVALID_FIELD, FIELD_NOT_ALIGNED (it is off the direction of the border by more than 30
///         degrees), VERTEX_NOT_INTEGER, LOOP_NOT_INTEGER, ARC_NOT_INTEGER, SINGLE_TRIANGLE, NON_POSITIVE_CONE (a field that turns
///         by a full turn or more at a vertex), GAUSS_BONNET_VIOLATED (impossible without given matchings, unless the field was aligned), INTERRUPTED
///         or VALID.
/// Complexity: O(n log n) in the number of faces.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Holonomy_signature_report<TriangleMesh>
holonomy_signature_of_cross_field(const TriangleMesh& mesh, const CrossFieldMap& cross_field,
                                  Holonomy_signature<TriangleMesh>& signature,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("holonomy signature");
  Holonomy_signature_report<TriangleMesh> report;
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (progress.is_interrupted()) {
    report.status = Holonomy_signature_status::INTERRUPTED;
    return report;
  }
  if (!report.mesh.success()) {
    signature.clear();
    report.status = Holonomy_signature_status::INVALID_MESH;
    return report;
  }
  internal::check_given_corners(mesh, np, report);
  if (!report.success()) {
    signature.clear();
    return report;
  }
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  std::vector<double> angle;
  const int face_without_direction =
      internal::cross_angles(domain.m_indexing, domain.m_connectivity, domain.m_geometry, cross_field, angle);
  if (face_without_direction != internal::Triangulation_connectivity::null) {
    signature.clear();
    report.status = Holonomy_signature_status::INVALID_FIELD;
    report.face = domain.m_indexing.face(face_without_direction);
    return report;
  }
  internal::Field_holonomy field;
  int worst = internal::Triangulation_connectivity::null;
  double deviation = 0;
  const internal::Border_guide guide = domain.guide(np);
  field.border_cross = internal::border_crosses(
      domain.m_connectivity, domain.m_geometry, guide,
      internal::angles_to_halfedges(domain.m_connectivity, domain.m_geometry, angle), worst, deviation);
  report.is_aligned = deviation > internal::largest_border_deviation &&
                      choose_parameter(get_parameter(np, np_tags::align_border), false);
  if (deviation > internal::largest_border_deviation && !report.is_aligned) {
    signature.clear();
    report.status = Holonomy_signature_status::FIELD_NOT_ALIGNED;
    report.halfedge = domain.m_indexing.halfedge(worst);
    report.deviation = deviation / internal::quarter_turn;
    return report;
  }
  field.rotation =
      internal::matched_rotations(domain.m_indexing, domain.m_connectivity,
                                  internal::angles_to_halfedges(domain.m_connectivity, domain.m_geometry, angle), np);
  const bool has_given_corners = internal::given_corners<TriangleMesh>(np).has_value();
  if (has_given_corners && !report.is_aligned) {
    const std::vector<double> turns = internal::vertex_quarter_turns(
        domain.m_connectivity, domain.m_geometry.m_corner_angle, field.rotation, field.border_cross);
    internal::Corner_turns(domain.m_connectivity, turns, field.rotation).carry(guide.quarter_turns(), progress);
  }
  Holonomy_signature<TriangleMesh> result;
  if (progress.go_on())
    internal::signature_of_rotations(domain, field, progress, result, report);
  if (report.success() && report.is_aligned)
    internal::align_corners(domain, guide, has_given_corners, result);
  if (report.success() && !progress.is_interrupted())
    domain.check_cones(result, report);
  if (report.success() && !progress.is_interrupted() && has_given_corners)
    internal::check_corners_are_met(domain, guide, result, report);
  if (progress.is_interrupted())
    report.status = Holonomy_signature_status::INTERRUPTED;
  else
    signature = std::move(result);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CROSS_FIELD_H
