// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_TRACE_MOTORCYCLE_GRAPH_H
#define CGAL_T_SPLINES_TRACING_TRACE_MOTORCYCLE_GRAPH_H

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/Tracing/Motorcycle_graph_report.h>
#include <CGAL/T_splines/Tracing/Tracing_traits.h>
#include <CGAL/T_splines/Tracing/internal/Cell_places.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_graph.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_graph_writer.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_tracer.h>
#include <CGAL/T_splines/Tracing/internal/Trace_geometry.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// Writes what the caller asked for. \param cell_places where places are asked for
template <typename TriangleMesh, typename FT, typename TracingTraits, typename FaceGraph, typename NamedParameters>
void write_motorcycle_graph_details(const Mesh_indexing<TriangleMesh>& indexing,
                                    const Trace_geometry<FT, TracingTraits>& geometry,
                                    const std::optional<Cell_places<FT, TracingTraits>>& cell_places,
                                    const Motorcycle_graph_writer<FT, TracingTraits, FaceGraph>& writer,
                                    FaceGraph& face_graph, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  writer.put_points(geometry, choose_parameter(get_parameter(np, np_tags::output_vertex_point_map),
                                               get_property_map(CGAL::vertex_point, face_graph)));
  const auto polylines = get_parameter(np, np_tags::edge_polyline_map);
  if constexpr (!is_missing<decltype(polylines)>)
    writer.put_polylines(geometry, polylines);
  const auto origins = get_parameter(np, np_tags::vertex_origin_map);
  if constexpr (!is_missing<decltype(origins)>)
    writer.put_origins(indexing, origins);
  const auto anchors = get_parameter(np, np_tags::face_anchor_map);
  if constexpr (!is_missing<decltype(anchors)>)
    writer.put_anchors(indexing, anchors);
  const auto places = get_parameter(np, np_tags::vertex_place_map);
  if constexpr (!is_missing<decltype(places)>)
    writer.put_places(indexing, *cell_places, places);
}

} // namespace internal

/// \ingroup PkgTSplinesTracing
/// traces the motorcycle graph of a seamless map: a T-mesh with admissible halfedge knots ([CZ17] sections 5, 8).
///
/// From every cone, one motorcycle leaves along each isoline; also from the reflex corners of the border. They advance in the order of the
/// way that they have made on the surface, ties by their numbers, and each one ends where it meets a cone, a border, or
/// the trace of a motorcycle that was there before, its own included. A surface with neither cones nor border gets a seed,
/// a regular vertex from which four motorcycles leave; so does an isoline on which a trace would spiral for ever.
///
/// Edges of the map that are constrained are walls: traces that are there before all others. They become constrained
/// edges of the T-mesh, if it has a map of these. Motorcycles also leave the vertices at which walls end or turn, between
/// walls that are more than two quarter turns apart; and a wall that closes up gets a seed on each side on which it would
/// have no vertex.
///
/// With an exact map and exact traits, every decision is exact, the faces are rectangles, and the knot intervals are
/// exactly admissible. The same input gives the same output, bit by bit.
///
/// \tparam TriangleMesh the model of `FaceListGraph` and `HalfedgeListGraph` of the map
/// \tparam FT the number type of the map
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph`. The T-mesh may be non-simple: two edges may
///   join the same two vertices, and a face may meet itself. The number type of its knots is `FT` for exact knots, a
///   floating point type for rounded ones
/// \param map a map made by `make_exactly_seamless()`
/// \param t_mesh the T-mesh; it is written only if the status is SUCCESS, knots and corners not on border halfedges.
///   \pre It is empty
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of the mapped mesh}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of the mapped mesh for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{tracing_traits}
///     \cgalParamDescription{the predicates}
///     \cgalParamType{a model of `TracingTraits`, copied}
///     \cgalParamDefault{`Default_tracing_traits<FT>`}
///   \cgalParamNEnd
///   \cgalParamNBegin{output_vertex_point_map}
///     \cgalParamDescription{receives the points of the vertices of the T-mesh on the surface}
///     \cgalParamType{a model of `WritablePropertyMap`, vertex of the T-mesh -> `%Point_3`}
///     \cgalParamDefault{the map of the graph for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_origin_map}
///     \cgalParamDescription{receives the vertex of the mapped mesh that lies at a vertex of the T-mesh, or
///       `null_vertex()`}
///     \cgalParamType{a model of `WritablePropertyMap`, vertex of the T-mesh ->
///       `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_place_map}
///     \cgalParamDescription{receives where each vertex of the mapped mesh lies in the T-mesh; of several faces one}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `T_mesh_place<Graph, NT>`, exact if `NT` is}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_anchor_map}
///     \cgalParamDescription{receives how each face of the T-mesh lies on the mapped mesh}
///     \cgalParamType{a model of `WritablePropertyMap`, face of the T-mesh -> `T_mesh_anchor<TriangleMesh, FT>`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_polyline_map}
///     \cgalParamDescription{receives the course of each edge on the surface, from the source to the target of
///       `halfedge(e, t_mesh.graph())`: its corners on the edges of the mesh}
///     \cgalParamType{a model of `WritablePropertyMap`, edge of the T-mesh -> a sequence of points with `push_back()`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done. With an exact map and exact traits the status is SUCCESS unless the map is empty or the
/// visitor stopped the work. Complexity: linear in the size of the mesh and, if no triangle is crossed often, in the
/// number of crossed triangles; quadratic in the number of crossings of a single triangle.
template <typename TriangleMesh, typename FT, typename TMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Motorcycle_graph_report trace_motorcycle_graph(const Seamless_map<TriangleMesh, FT>& map, TMesh&& t_mesh,
                                               const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  const auto traits = choose_parameter(get_parameter(np, np_tags::tracing_traits), Default_tracing_traits<FT>());
  using Tracing_traits = std::decay_t<decltype(traits)>;
  Motorcycle_graph_report report;
  const internal::Seamless_layout<FT>& layout = map.layout();
  const T_mesh_view_of<TMesh> view(t_mesh);
  if (layout.mesh().number_of_faces() == 0)
    report.status = Motorcycle_graph_status::EMPTY_MAP;
  else if (!internal::is_output_graph(view.graph()))
    report.status = Motorcycle_graph_status::OUTPUT_NOT_EMPTY;
  if (!report.success())
    return report;
  const std::vector<std::array<double, 3>> points = internal::points_in_doubles(
      map.indexing(), choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, map.mesh())));
  progress.begin_stage("tracing");
  internal::Motorcycle_tracer<FT, Tracing_traits> tracer(layout, points, traits);
  report.status = tracer.trace(progress);
  report.motorcycles = tracer.number_of_motorcycles();
  report.seeds = tracer.number_of_seeds();
  report.crossed_faces = tracer.number_of_crossed_faces();
  report.predicates = traits.statistics();
  if (!report.success())
    return report;
  progress.begin_stage("T-mesh");
  const internal::Motorcycle_graph<FT, Tracing_traits> motorcycle_graph(layout, tracer.take_stars(),
                                                                        tracer.take_traces(), traits, progress);
  const auto& cells = motorcycle_graph.cells();
  progress.progress(0.5);
  std::optional<internal::Cell_places<FT, Tracing_traits>> places;
  if constexpr (!internal::is_missing<decltype(get_parameter(np, np_tags::vertex_place_map))>)
    if (cells.is_t_mesh())
      places.emplace(motorcycle_graph, progress);
  progress.progress(0.8);
  if (!progress.go_on()) {
    report.status = Motorcycle_graph_status::INTERRUPTED;
    return report;
  }
  if (!cells.is_t_mesh()) {
    report.status = Motorcycle_graph_status::NO_T_MESH;
    return report;
  }
  for (int h = 0; h < cells.number_of_halfedges(); ++h)
    report.t_joints += !cells.is_border(h) && !cells.halfedge(h).is_corner ? 1 : 0;
  const internal::Motorcycle_graph_writer<FT, Tracing_traits, T_mesh_graph<TMesh>> writer(motorcycle_graph,
                                                                                          view.graph());
  writer.put_knots(view);
  const internal::Trace_geometry<FT, Tracing_traits> geometry(motorcycle_graph, points);
  internal::write_motorcycle_graph_details(map.indexing(), geometry, places, writer, view.graph(), np);
  progress.progress(1);
  report.predicates = traits.statistics();
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_TRACE_MOTORCYCLE_GRAPH_H
