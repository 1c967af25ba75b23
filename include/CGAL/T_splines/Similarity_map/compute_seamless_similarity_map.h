// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SEAMLESS_SIMILARITY_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SEAMLESS_SIMILARITY_MAP_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_mesh_writer.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_map_computation.h>
#include <CGAL/T_splines/Similarity_map/internal/converged_metric.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// computes a seamless similarity map of a triangle mesh with a prescribed holonomy signature ([CZ17] sections
/// 2.1, 6, 7).
///
/// The map is discretely conformal, piecewise linear on a refinement of the mesh, and locally injective: each triangle
/// of the refinement has positive area on the surface and, positively oriented, in the plane; the first is decided
/// exactly with respect to its input face, the second exactly. Charts are separated by a cut; across it, coordinates
/// change by a rotation by quarter turns, a scaling and a translation, constant along each branch.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam RefinedMesh a model of `MutableFaceGraph`
/// \tparam HalfedgeUVMap a model of `WritablePropertyMap` with halfedges of `RefinedMesh` as keys and a `Point_2` as
///   value
/// \param mesh a triangle mesh, of one or more components
/// \param signature an admissible signature of `mesh`
/// \param refined the refinement; its vertices are those of `mesh`, in their order and with their points, and then
///        those added. It must be empty, which is checked, and is written only if the status is CONVERGED
/// \param uv_map the coordinates of the target of a halfedge in the chart of its face
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
///   \cgalParamNBegin{residual_tolerance}
///     \cgalParamDescription{the largest deviation from the signature that is allowed, in radians, over all vertices
///       and loops}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-12}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the largest number of steps of Newton's method}
///     \cgalParamType{`int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{flip_policy}
///     \cgalParamDescription{how the triangulation follows the metric}
///     \cgalParamType{a model of `FlipPolicy`: `Ideal_delaunay_flips` or `Degeneracy_flips`}
///     \cgalParamDefault{`Ideal_delaunay_flips()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_type}
///     \cgalParamDescription{the number type to compute in; the value does not matter}
///     \cgalParamType{a floating-point type, built in or of Boost.Multiprecision}
///     \cgalParamDefault{`double`}
///     \cgalParamExtra{Wider types follow where `double` comes to a floor above the tolerance or stalls: the status is
///       not CONVERGED before the tolerance is met.}
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
///   \cgalParamNBegin{output_vertex_point_map}
///     \cgalParamDescription{receives the points of `refined`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<RefinedMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `refined` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_location_map}
///     \cgalParamDescription{receives where each vertex of `refined` lies on `mesh`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<RefinedMesh>::%vertex_descriptor` ->
///       `Polygon_mesh_processing::Face_location<TriangleMesh, double>`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_cut_map}
///     \cgalParamDescription{receives whether the charts of the two faces of an edge differ}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<RefinedMesh>::%edge_descriptor` -> `bool`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_transition_map}
///     \cgalParamDescription{receives the transition from the chart of the face of a halfedge to that of its opposite's
///       face, the identity off the cut}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<RefinedMesh>::%halfedge_descriptor` ->
///       `Similarity_2<double>`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done; the status LAYOUT_FAILED tells that the metric converged, but could not be laid out in any number
/// type: its sizes are too far apart for one plane in `double`; SUBDIVISION_TOO_LARGE, that the refinement would have more
/// than 250000 vertices plus twenty times those of `mesh`, which has long thin triangles. Complexity: that of the metric, and linear in the size of the refinement.
template <typename TriangleMesh, typename RefinedMesh, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Similarity_map_report<TriangleMesh>
compute_seamless_similarity_map(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                                RefinedMesh& refined, HalfedgeUVMap uv_map,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  Similarity_map_report<TriangleMesh> layout_report;
  if (!internal::is_output_graph(refined)) {
    layout_report.status = Similarity_map_status::OUTPUT_NOT_EMPTY;
    return layout_report;
  }
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  Similarity_map_report<TriangleMesh> report = internal::converged_metric(
      mesh, signature, true, np, indexing, progress, [&](const internal::Metric_input& input, const auto& metric) {
        progress.begin_stage("layout");
        const internal::Similarity_map_computation<std::decay_t<decltype(metric)>> map(input, metric, progress);
        if (!progress.go_on())
          return false;
        if (map.is_too_large()) {
          layout_report.status = Similarity_map_status::SUBDIVISION_TOO_LARGE;
          return true;
        }
        const int bad_face = map.first_bad_input_face();
        if (bad_face != map.none) {
          layout_report.status = Similarity_map_status::LAYOUT_FAILED;
          layout_report.face = indexing.face(bad_face);
          return false;
        }
        layout_report.status = Similarity_map_status::CONVERGED;
        progress.begin_stage("output");
        const internal::Refined_mesh_writer<RefinedMesh> writer(map.refined(), refined);
        writer.put_points(indexing,
                          choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                           get_const_property_map(CGAL::vertex_point, mesh)),
                          choose_parameter(get_parameter(np, np_tags::output_vertex_point_map),
                                           get_property_map(CGAL::vertex_point, refined)));
        writer.put_uv(uv_map);
        const auto locations = get_parameter(np, np_tags::vertex_location_map);
        if constexpr (!internal::is_missing<decltype(locations)>)
          writer.put_locations(indexing, input.mesh, locations);
        const auto is_cut = get_parameter(np, np_tags::edge_is_cut_map);
        if constexpr (!internal::is_missing<decltype(is_cut)>)
          writer.put_cut(map.cut_edges(), is_cut);
        const auto transitions = get_parameter(np, np_tags::halfedge_transition_map);
        if constexpr (!internal::is_missing<decltype(transitions)>)
          for (int h = 0; h < map.refined().mesh.number_of_halfedges(); ++h)
            put(transitions, writer.halfedge_of(h), map.transition(h));
        return true;
      });
  if (report.success() && !layout_report.success()) {
    report.status = layout_report.status;
    report.face = layout_report.face;
  }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SEAMLESS_SIMILARITY_MAP_H
