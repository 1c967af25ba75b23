// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_CARRY_SURFACE_H
#define CGAL_T_SPLINES_TRACING_CARRY_SURFACE_H

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/Tracing/internal/Chart_points.h>
#include <CGAL/T_splines/Tracing/internal/Face_triangles.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/face_is_data.h>
#include <CGAL/T_splines/internal/graph_checks.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTracing
/// finds the triangles that the faces of a motorcycle graph cover, and where they lie in the frames of the faces.
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph`
/// \tparam FaceAnchorMap a readable map, face of the T-mesh -> `T_mesh_anchor<TriangleMesh, FT>`
/// \param map the map on which the T-mesh was traced
/// \param t_mesh, anchors what `trace_motorcycle_graph()` made of it
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of the mapped mesh}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of the mapped mesh for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_is_data_map}
///     \cgalParamDescription{which faces count for a fit: the others only close holes}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` -> `bool`}
///     \cgalParamDefault{all}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the surface; its points and triangles are the vertices and faces of the mapped mesh, in their order. If the
/// visitor stopped the work, a surface without points and triangles.
/// \pre neither the T-mesh nor its anchors have changed since it was traced
///
/// Complexity: linear in the size of the mesh and in the number of times that faces meet triangles; quadratic in how
/// often one face meets one triangle.
template <typename TriangleMesh, typename FT, typename TMesh, typename FaceAnchorMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Carried_surface<T_mesh_graph<TMesh>> carry_surface(const Seamless_map<TriangleMesh, FT>& map, const TMesh& t_mesh,
                                                   const FaceAnchorMap anchors,
                                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Surface = Carried_surface<T_mesh_graph<TMesh>>;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, map.mesh()));
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("carried surface");
  const auto& mesh = map.layout().mesh();
  Surface surface;
  if (!internal::are_anchored(map, t_mesh.graph(), anchors))
    return surface;
  for (const std::array<double, 3>& p : internal::points_in_doubles(map.indexing(), point_map))
    surface.add_point({p[0], p[1], p[2]});
  const auto is_data = internal::face_is_data_map<TriangleMesh>(np);
  for (int t = 0; t < mesh.number_of_faces(); ++t) {
    const int h = mesh.halfedge_of_face(t), g = mesh.next(h);
    surface.add_triangle({static_cast<std::size_t>(mesh.target(h)), static_cast<std::size_t>(mesh.target(g)),
                          static_cast<std::size_t>(mesh.target(mesh.next(g)))},
                         get(is_data, map.indexing().face(t)));
  }
  const T_mesh_coordinates coordinates(t_mesh);
  if (!progress.go_on())
    return Surface();
  internal::Face_triangles<FT> triangles(map.layout());
  std::vector<typename Surface::face_descriptor> faces_in_order;
  for (const auto f : CGAL::make_range(faces(t_mesh.graph()))) {
    faces_in_order.push_back(f);
    const auto& anchor = get(anchors, f);
    triangles.add_face(map.indexing().face_index(anchor.triangle), anchor.to_face,
                       CGAL::to_double(coordinates.width(f)), CGAL::to_double(coordinates.height(f)), progress);
    progress.progress(0.7 * static_cast<double>(faces_in_order.size()) /
                      static_cast<double>(num_faces(t_mesh.graph())));
    if (progress.is_interrupted())
      return Surface();
  }
  triangles.complete();
  progress.progress(0.8);
  if (!progress.go_on())
    return Surface();
  triangles.for_each_image(
      [&](const int face, const int triangle, const std::array<typename Surface::Parameters, 3>& image) {
        if (progress.go_on_after(2))
          surface.add_image(faces_in_order[face], {static_cast<std::size_t>(triangle), image});
      });
  return progress.is_interrupted() ? Surface() : surface;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_CARRY_SURFACE_H
