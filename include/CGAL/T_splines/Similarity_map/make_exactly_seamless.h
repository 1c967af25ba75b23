// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_MAKE_EXACTLY_SEAMLESS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_MAKE_EXACTLY_SEAMLESS_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_map_computation.h>
#include <CGAL/T_splines/Similarity_map/internal/decimal_tolerance.h>
#include <CGAL/T_splines/Similarity_map/internal/map_arrays.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_basic.h>

#include <utility>

namespace CGAL {
namespace T_splines {

namespace internal {

template <typename TriangleMesh, typename FT>
Exact_map_report<TriangleMesh> exact_map_report(const Mesh_indexing<TriangleMesh>& indexing,
                                                const Exact_map_figures& figures, const Seamless_layout<FT>& layout)
{
  Exact_map_report<TriangleMesh> report;
  report.status = figures.status;
  if (figures.vertex != figures.none)
    report.vertex = indexing.vertex(figures.vertex);
  if (figures.halfedge != figures.none)
    report.halfedge = indexing.halfedge(figures.halfedge);
  for (const int f : figures.faces)
    report.faces.push_back(indexing.face(f));
  report.deviation = figures.deviation;
  report.is_isometric = figures.is_isometric;
  report.scale_bits = figures.scale_bits;
  report.largest_displacement = figures.largest_displacement;
  report.number_of_joined_lines = figures.number_of_joined_lines;
  report.number_of_lines_left_apart = figures.number_of_lines_left_apart;
  report.largest_gap = figures.largest_gap;
  if (!report.success())
    return report;
  const Triangulation_connectivity& mesh = layout.mesh();
  report.number_of_branches = layout.number_of_branches();
  report.number_of_determined_corners = layout.number_of_determined_corners();
  std::vector<char> is_on_border(mesh.number_of_vertices(), 0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) == mesh.null)
      is_on_border[mesh.target(h)] = 1;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    report.number_of_cut_edges += layout.is_cut(e) ? 1 : 0;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    report.number_of_cones += layout.quarter_turns(v) != (is_on_border[v] ? 2 : 4) ? 1 : 0;
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesSimilarityMap
/// makes a seamless similarity map that is so up to round-off exactly seamless, or tells which element prevents it
/// ([CZ17] section 5).
///
/// Nothing but the coordinates is needed: seams are the inner edges whose two faces disagree on the coordinates of an
/// end, and where they disagree by rounding alone they are welded. Rotations are integers. Scale factors are
/// rounded to as few bits as keep all triangles positively oriented with no more than half or double their area; those
/// that are 1 up to round-off become 1. The translations follow from equations around the nodes of the cut. The
/// coordinates on one side of each seam are kept; those on the other, and those of cones, follow from the transitions.
///
/// Where the isoline of a cone passes another cone, or a corner of the border, at a distance of no more than
/// 1e-5 (`internal::coincidence_tolerance`) times the longest side of the triangle there, or what noise explains, both are
/// moved such that it runs into it exactly. If all scale factors are 1, all coordinates become doubles and those of
/// seams and cones short ones, so that knots of the traced T-mesh are doubles.
///
/// Inner edges that are to lie on isolines, and do but for round-off, are moved there exactly: u is the same at both
/// ends, or v, in the charts of both faces. Where they close up along a line of which the scale factor is not 1, they come
/// to lie on the one isoline that the transitions map to itself.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap`, halfedge -> `Point_2`: finite coordinates of the target of
///   the halfedge in the chart of its face; read on inner halfedges only
/// \tparam FT the number type of the map: with an exact one the result is exactly seamless; with `double` the same
///   computation is carried out in round-off, for robustness studies
/// \param mesh a triangle mesh, closed or with border
/// \param uv_map the coordinates
/// \param map made on `mesh`; receives the result, and is left as it is if the status is not EXACT
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{transition_tolerance}
///     \cgalParamDescription{the largest deviation of a corner from the similarity of its branch, relative to the
///       largest coordinate on the branch; angles may deviate by as much in radians, and by what such a deviation makes
///       of them on short edges}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-6, or what rounding explains if no coordinate has more than seven (2e-6) or six (2e-5)
///       significant decimal digits}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{which edges are to lie on isolines; those of the border, which do so anyway, do not count}
///     \cgalParamType{a model of `ReadablePropertyMap`, edge of the mesh -> `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done; or the first defect found and the element that has it, all of them for triangles.
///
/// Complexity: linear in the size of the mesh, with exact numbers only on the seams.
template <typename TriangleMesh, typename HalfedgeUVMap, typename FT,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Exact_map_report<TriangleMesh> make_exactly_seamless(const TriangleMesh& mesh, const HalfedgeUVMap uv_map,
                                                     Seamless_map<TriangleMesh, FT>& map,
                                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::get_parameter;
  if (&mesh != &map.mesh() || !map.indexing().has_elements_of(mesh)) {
    Exact_map_report<TriangleMesh> report;
    report.status = Exact_map_status::MAP_OF_OTHER_MESH;
    return report;
  }
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("exact map");
  const Triangle_mesh_report<TriangleMesh> mesh_report = internal::check_mesh_connectivity(mesh, true, progress);
  if (!mesh_report.success()) {
    Exact_map_report<TriangleMesh> report;
    report.mesh = mesh_report;
    if (progress.is_interrupted())
      report.status = Exact_map_status::INTERRUPTED;
    return report;
  }
  std::vector<std::array<double, 2>> uv = internal::uv_array(map.indexing(), uv_map);
  const auto given_tolerance = get_parameter(np, np_tags::transition_tolerance);
  double tolerance = 0;
  if constexpr (internal::is_missing<decltype(given_tolerance)>)
    tolerance = internal::decimal_tolerance(uv);
  else
    tolerance = given_tolerance;
  progress.go_on();
  internal::Exact_map_computation<FT> computation(
      internal::triangulation_connectivity(map.indexing()), std::move(uv),
      internal::constrained_edges(map.indexing(), get_parameter(np, CGAL::internal_np::edge_is_constrained)), tolerance,
      progress);
  computation.run();
  const Exact_map_report<TriangleMesh> report =
      internal::exact_map_report(map.indexing(), computation.figures(), computation.layout());
  if (report.success())
    map.set_layout(std::move(computation.layout()));
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_MAKE_EXACTLY_SEAMLESS_H
