// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_ALIGN_SEAMLESS_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_ALIGN_SEAMLESS_MAP_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/cross_angles.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/Cross_field/support/matched_rotations.h>
#include <CGAL/T_splines/Similarity_map/Map_alignment_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Map_alignment.h>
#include <CGAL/T_splines/Similarity_map/internal/Open_map.h>
#include <CGAL/T_splines/Similarity_map/internal/decimal_tolerance.h>
#include <CGAL/T_splines/Similarity_map/internal/map_arrays.h>
#include <CGAL/T_splines/Similarity_map/internal/uv_orientation.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The field relative to the halfedges, its rotations, and the edges that are to lie on isolines.
template <typename TriangleMesh, typename NamedParameters>
Alignment_target alignment_target(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& mesh,
                                  const Triangle_geometry& geometry, const std::vector<double>& angle_in_face,
                                  const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  Alignment_target result;
  result.angle = angles_to_halfedges(mesh, geometry, angle_in_face);
  result.rotation = matched_rotations(indexing, mesh, result.angle, np);
  result.is_constrained = constrained_edges(indexing, get_parameter(np, CGAL::internal_np::edge_is_constrained));
  result.is_constrained.resize(mesh.number_of_edges(), 0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) == Triangulation_connectivity::null)
      result.is_constrained[edge_of(h)] = 1;
  return result;
}

template <typename TriangleMesh>
void fill_report(const Mesh_indexing<TriangleMesh>& indexing, const Map_alignment_figures& figures,
                 Map_alignment_report<TriangleMesh>& report)
{
  report.status = figures.status;
  if (figures.halfedge != figures.none)
    report.halfedge = indexing.halfedge(figures.halfedge);
  if (figures.vertex != figures.none)
    report.vertex = indexing.vertex(figures.vertex);
  for (const int f : figures.faces)
    report.faces.push_back(indexing.face(f));
  report.deviation = figures.deviation;
  report.number_of_constrained_edges = figures.number_of_constrained_edges;
  report.before = figures.before;
  report.rotated = figures.rotated;
  report.after = figures.after;
  report.number_of_steps = figures.number_of_steps;
  report.largest_log_scale_before = figures.largest_log_scale_before;
  report.largest_log_scale_after = figures.largest_log_scale_after;
  report.mean_distortion = figures.mean_distortion;
  report.largest_distortion = figures.largest_distortion;
  for (const int e : figures.edges_not_met)
    report.edges_not_met.push_back(edge(indexing.halfedge(halfedge_of_edge(e)), indexing.graph()));
}

} // namespace internal

/// \ingroup PkgTSplinesSimilarityMap
/// changes a seamless map such that its isolines follow a cross field ([CZ17] section 7.4), such that constrained edges lie
/// on isolines, and, if asked for, such that its scale factors are 1 or powers of two.
///
/// The map that comes in is conformal, say, and turns around cones and loops as the field does: it has the field's holonomy
/// signature. The map that comes out has the same cones, and its transitions the same rotations. It minimizes the integral
/// over the surface of
///
///   |F - I|^2 + w (|F|^2 + |F^-1|^2 - 4),
///
/// where F takes the triangle of the old map, turned such that the cross of the field lies along the axes, to the triangle
/// of the new one, both in their charts. The first part is the alignment, the second one, the symmetric Dirichlet energy, keeps triangles
/// from being distorted and from turning over. F does not depend on the charts, whatever the transitions are: that of one side of a seam is
/// that of the other side, turned. If scale factors change, triangles are compared with those of the size that they have in
/// space; otherwise with those of the old map.
///
/// Transitions and constrained edges are linear equations with integer coefficients, times scale factors, and what is left free is the unknown of Newton's method, with the
/// Hessian's negative part left out. Where the old map does not satisfy the equations they are penalties first, and are
/// eliminated when they are nearly met. No step turns a triangle over, and none makes the angle around a vertex another
/// one.
///
/// Not all sets of constrained edges can lie on isolines: opposite sides of a patch may force an arc between them to
/// have length 0. If the penalties tell so, the weakest arc of those that stay off is given up, that with the least angle between the
/// faces on both sides, integrated along it; and so on, from the third time on twice as many each time. The report lists their edges.
///
/// The result is seamless up to round-off: `make_exactly_seamless()`, with the same constrained edges but those that were given up, makes it
/// exact.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `ReadablePropertyMap` from faces to three-dimensional vectors
/// \tparam HalfedgeUVMap a model of `ReadWritePropertyMap`, halfedge -> `Point_2`: finite coordinates of the target of
///   the halfedge in the chart of its face; constructible from two `double`s. Used on inner halfedges only
/// \param mesh a triangle mesh, closed or with border: that on which the map lives
/// \param cross_field one of the four directions of the cross in each face
/// \param uv_map a seamless map, up to round-off; receives the aligned one upon success, and stays as it is otherwise
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_matching_map}
///     \cgalParamDescription{the matchings of the field, as for `holonomy_signature_of_cross_field()`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` -> an
///       integer}
///     \cgalParamDefault{none: the closest rotation decides}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that are to lie on isolines; the field has to follow them, up to 30 degrees. Edges on the border
///       are always constrained}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%edge_descriptor` ->
///       `bool`}
///     \cgalParamDefault{no inner edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{scale_policy}
///     \cgalParamDescription{which scale factors the transitions get}
///     \cgalParamType{`Scale_policy`}
///     \cgalParamDefault{`Scale_policy::UNIT_IF_CONSTRAINED`}
///   \cgalParamNEnd
///   \cgalParamNBegin{distortion_weight}
///     \cgalParamDescription{w, a positive number: with less of it the map follows the field more, and has more triangles that are distorted
///       much}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_distortion_weight`, 0.1}
///   \cgalParamNEnd
///   \cgalParamNBegin{transition_tolerance}
///     \cgalParamDescription{see `make_exactly_seamless()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{see there}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits` with `FT = double`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done, or why nothing was.
///
/// Complexity: two to ten sparse factorizations with two rows per vertex, and some products with each.
template <typename TriangleMesh, typename CrossFieldMap, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Map_alignment_report<TriangleMesh> align_seamless_map(const TriangleMesh& mesh, const CrossFieldMap cross_field,
                                                      HalfedgeUVMap uv_map,
                                                      const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("alignment");
  Map_alignment_report<TriangleMesh> report;
  internal::Alignment_options options;
  options.scale_policy = choose_parameter(get_parameter(np, np_tags::scale_policy), options.scale_policy);
  options.distortion_weight =
      choose_parameter(get_parameter(np, np_tags::distortion_weight), default_distortion_weight);
  if (!(options.distortion_weight > 0 && std::isfinite(options.distortion_weight))) {
    report.status = Map_alignment_status::INVALID_OPTION;
    return report;
  }
  report.mesh = internal::check_mesh_connectivity(mesh, true, progress);
  if (!report.mesh.success() || progress.is_interrupted()) {
    report.status = progress.is_interrupted() ? Map_alignment_status::INTERRUPTED : Map_alignment_status::INVALID_MESH;
    return report;
  }
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  const internal::Triangulation_connectivity connectivity = internal::triangulation_connectivity(indexing);
  internal::Uv_array uv = internal::uv_array(indexing, uv_map);
  for (const int f : internal::faces_not_positive(connectivity, uv))
    report.faces.push_back(indexing.face(f));
  if (!report.faces.empty()) {
    report.status = Map_alignment_status::FLIPPED_TRIANGLES;
    return report;
  }
  const double tolerance =
      choose_parameter(get_parameter(np, np_tags::transition_tolerance), internal::decimal_tolerance(uv));
  const internal::Open_map map(connectivity, std::move(uv), tolerance);
  const auto [worst, deviation] = map.worst_fit();
  if (!(deviation <= tolerance)) {
    report.status = Map_alignment_status::NOT_SEAMLESS;
    report.halfedge = indexing.halfedge(worst);
    report.deviation = deviation;
    return report;
  }
  const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  const internal::Triangle_geometry geometry = internal::triangle_geometry(indexing, map.mesh(), points);
  std::vector<double> angle;
  const int bad = internal::cross_angles(indexing, map.mesh(), geometry, cross_field, angle);
  if (bad != internal::Triangulation_connectivity::null) {
    report.status = Map_alignment_status::INVALID_FIELD;
    report.faces.push_back(indexing.face(bad));
    return report;
  }
  const internal::Alignment_target target = internal::alignment_target(indexing, map.mesh(), geometry, angle, np);
  auto&& solver = internal::sparse_linear_solver(np);
  internal::Map_alignment<Solver_traits_from<NamedParameters>> alignment(map, geometry, target, options, solver,
                                                                         progress);
  const bool is_aligned = alignment.run();
  internal::fill_report(indexing, alignment.figures(), report);
  if (!is_aligned)
    return report;
  using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
  for (int h = 0; h < indexing.number_of_halfedges(); ++h)
    if (map.mesh().face(h) != internal::Triangulation_connectivity::null)
      put(uv_map, indexing.halfedge(h), Point_2(alignment.uv()[h][0], alignment.uv()[h][1]));
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_ALIGN_SEAMLESS_MAP_H
