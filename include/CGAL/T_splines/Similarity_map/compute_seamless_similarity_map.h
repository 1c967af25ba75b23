// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SEAMLESS_SIMILARITY_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SEAMLESS_SIMILARITY_MAP_H

#include <CGAL/T_splines/Similarity_map/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_mesh_writer.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_map_computation.h>
#include <CGAL/T_splines/Similarity_map/internal/converged_metric.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// computes a seamless similarity map of a closed triangle mesh with a prescribed holonomy signature ([CZ17] sections
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
/// \param mesh a closed triangle mesh, of one or more components
/// \param signature an admissible signature of `mesh`
/// \param refined the refinement; its vertices are those of `mesh`, in their order and with their points, and then
///        those added. It is written only if the status is CONVERGED. \pre It is empty
/// \param uv_map the coordinates of the target of a halfedge in the chart of its face
/// \param np named parameters: those of `compute_similarity_metric()`, and
///   `T_splines::parameters::output_vertex_point_map`: points of `refined` (default: its internal map);
///   `T_splines::parameters::vertex_location_map`: vertex of `refined` ->
///   `Polygon_mesh_processing::Face_location<TriangleMesh, double>`, its place on `mesh`;
///   `T_splines::parameters::edge_is_cut_map`: edge of `refined` -> bool;
///   `T_splines::parameters::halfedge_transition_map`: halfedge of `refined` -> `Similarity_2<double>`, the transition
///     from the chart of its face to that of its opposite's face, the identity off the cut.
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
  const auto visitor = choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Progress_visitor());
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  Similarity_map_report<TriangleMesh> layout_report;
  Similarity_map_report<TriangleMesh> report = internal::converged_metric(
      mesh, signature, true, np, indexing, [&](const internal::Metric_input& input, const auto& metric) {
        visitor.begin_stage("layout");
        const internal::Similarity_map_computation<std::decay_t<decltype(metric)>> map(input, metric, visitor);
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
        visitor.begin_stage("output");
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
