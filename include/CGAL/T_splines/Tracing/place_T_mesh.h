// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_PLACE_T_MESH_H
#define CGAL_T_SPLINES_TRACING_PLACE_T_MESH_H

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/T_mesh/Carried_anchors.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/Tracing/Tracing_traits.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/T_mesh_placement.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTracing
/// How the placement of a T-mesh ended.
enum class T_mesh_placement_status {
  PLACED,       ///< points, and polylines if they were asked for, are written
  FOREIGN_ROOT, ///< a root names a face that the T-mesh or the mapped mesh does not have; nothing is written
  DOES_NOT_FIT, ///< the way along `halfedge`, or to the origin of the root's `face`, leads over a cone or beyond a
                ///< border; not all is written
  INTERRUPTED   ///< the visitor asked to stop; not all is written
};

/// \ingroup PkgTSplinesTracing
/// returns one sentence that explains `status`.
inline const char* message(const T_mesh_placement_status status)
{
  switch (status) {
  case T_mesh_placement_status::PLACED: return "the T-mesh was placed on the surface";
  case T_mesh_placement_status::FOREIGN_ROOT:
    return "a root names a face that the T-mesh or the mapped mesh does not have";
  case T_mesh_placement_status::DOES_NOT_FIT:
    return "the T-mesh does not fit the map: an edge leads over a cone or beyond a border";
  case T_mesh_placement_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesTracing
/// What `place_T_mesh()` did. Members that `status` does not mention have no meaning.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph>
struct T_mesh_placement_report {
  using Traits = boost::graph_traits<Graph>;

  T_mesh_placement_status status = T_mesh_placement_status::PLACED;        ///< how it ended
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< the halfedge that `status` is about
  typename Traits::face_descriptor face = Traits::null_face(); ///< the face that `status` is about, if not a halfedge

  /// returns whether `status` tells of success.
  bool success() const { return status == T_mesh_placement_status::PLACED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTracing
/// returns what `report` says, with the numbers of the elements of the T-mesh concerned, counted from 0. Complexity:
/// linear in the size of the T-mesh.
template <typename Graph>
std::string describe(const T_mesh_placement_report<Graph>& report, const Graph& graph)
{
  std::string text = message(report.status);
  if (report.status == T_mesh_placement_status::FOREIGN_ROOT)
    text += ": the roots are those of another T-mesh or map";
  else if (report.halfedge != boost::graph_traits<Graph>::null_halfedge())
    text += ": " + internal::edge_in_words(report.halfedge, graph) + ", counted from 0";
  else if (report.face != boost::graph_traits<Graph>::null_face())
    text += ": at " + internal::face_in_words(report.face, graph) + ", counted from 0";
  return text;
}

/// \ingroup PkgTSplinesTracing
/// finds where a T-mesh that was changed by operations lies on the surface: the points of its vertices and the course
/// of its edges, which are isolines of the map.
///
/// From the roots, it walks along all edges, by their lengths, in exact arithmetic if `FT` is exact.
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph` and `VertexListGraph`; its knots are convertible
///         to `FT`
/// \param map the map on which the T-mesh was traced
/// \param t_mesh what `trace_motorcycle_graph()` made of it and operations changed
/// \param roots the observer of these operations
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of the mapped mesh}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of the mapped mesh for `CGAL::vertex_point`}
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
///   \cgalParamNBegin{edge_polyline_map}
///     \cgalParamDescription{receives the course of each edge on the surface, from the source to the target of
///       `halfedge(e, t_mesh.graph())`: its corners on the edges of the mesh}
///     \cgalParamType{a model of `WritablePropertyMap`, edge of the T-mesh -> a sequence of points with `push_back()`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended. The T-mesh itself is not changed; what is written of points and polylines is right.
/// Complexity: linear in the number of triangles that the edges cross, and in the size of the mapped mesh.
template <typename TriangleMesh, typename FT, typename TMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_mesh_placement_report<T_mesh_graph<TMesh>>
place_T_mesh(const Seamless_map<TriangleMesh, FT>& map, TMesh&& t_mesh,
             const Carried_anchors<TriangleMesh, T_mesh_graph<TMesh>, FT>& roots,
             const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  T_mesh_placement_report<T_mesh_graph<TMesh>> report;
  const auto face_of = [](const auto& root) { return root.place.face; };
  const auto triangle_of = [](const auto& root) { return root.anchor.triangle; };
  if (map.layout().mesh().number_of_faces() == 0 ||
      internal::first_foreign_face(t_mesh.graph(), roots.roots(), face_of) < roots.roots().size() ||
      internal::first_foreign_face(map.mesh(), roots.roots(), triangle_of) < roots.roots().size()) {
    report.status = T_mesh_placement_status::FOREIGN_ROOT;
    return report;
  }
  const auto traits = choose_parameter(get_parameter(np, np_tags::tracing_traits), Default_tracing_traits<FT>());
  const auto point_map = choose_parameter(get_parameter(np, np_tags::output_vertex_point_map),
                                          get_property_map(CGAL::vertex_point, t_mesh.graph()));
  const auto polyline_map = get_parameter(np, np_tags::edge_polyline_map);
  using Point_map = std::decay_t<decltype(point_map)>;
  using Point_3 = typename boost::property_traits<Point_map>::value_type;
  using Point = std::array<double, 3>;
  const auto found_vertex = [&](const auto v, const Point& p) { put(point_map, v, Point_3(p[0], p[1], p[2])); };
  const auto found_edge = [&]([[maybe_unused]] const auto e, [[maybe_unused]] const std::vector<Point>& points) {
    if constexpr (!internal::is_missing<decltype(polyline_map)>) {
      using Polyline = typename boost::property_traits<std::decay_t<decltype(polyline_map)>>::value_type;
      Polyline polyline;
      for (const Point& p : points)
        polyline.push_back(typename Polyline::value_type(p[0], p[1], p[2]));
      put(polyline_map, e, polyline);
    }
  };
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("placement");
  const std::vector<Point> points = internal::points_in_doubles(
      map.indexing(), choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, map.mesh())));
  internal::T_mesh_placement<TriangleMesh, FT, Const_T_mesh_view_of<TMesh>, std::decay_t<decltype(traits)>> placement(
      map, points, t_mesh, traits);
  progress.go_on();
  for (const auto& root : roots.roots())
    if (!placement.place(root, found_vertex, found_edge, progress)) {
      if (progress.is_interrupted()) {
        report.status = T_mesh_placement_status::INTERRUPTED;
        return report;
      }
      report.status = T_mesh_placement_status::DOES_NOT_FIT;
      report.halfedge = placement.failed_halfedge();
      report.face = root.place.face;
      return report;
    }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_PLACE_T_MESH_H
