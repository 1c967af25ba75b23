// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_TESSELLATE_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_TESSELLATE_T_SPLINE_H

#include <CGAL/T_splines/Spline/internal/Face_tessellation.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// A triangulation of the parameter domain of a T-spline surface: places, and triangles of three numbers of places,
/// seen counter-clockwise, with the faces in which they lie.
/// \tparam Graph the T-mesh
template <typename Graph, typename FT>
struct T_spline_tessellation {
  std::vector<T_mesh_place<Graph, FT>> places;                             ///< the corners of the triangles
  std::vector<std::array<std::size_t, 3>> triangles;                       ///< numbers of three places each
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> faces; ///< of the T-mesh, per triangle
};

/// \ingroup PkgTSplinesSpline
/// triangulates the parameter domain of a T-spline surface without cracks: triangles on both sides of an edge share its
/// points, T-joints included.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \param surface \pre it is valid
/// \param resolution n >= 2: each side of a face is divided into at least n parts, its inside into n x n cells
/// \return places and triangles; evaluate the surface there: `surface.positions(tessellation.places, ...)`.
///
/// Complexity: linear in the size of the result.
template <typename Surface>
T_spline_tessellation<typename Surface::Graph, typename Surface::FT> tessellate_parameter_domain(const Surface& surface,
                                                                                                 const int resolution)
{
  CGAL_precondition_msg(resolution >= 2, "the resolution must be at least 2");
  const internal::Face_tessellation<typename Surface::FT> faces(surface.t_mesh_arrays(), resolution);
  T_spline_tessellation<typename Surface::Graph, typename Surface::FT> result;
  result.places.reserve(faces.places().size());
  for (const auto& place : faces.places())
    result.places.push_back({surface.indexing().face(place.face), place.u, place.v});
  result.triangles = faces.triangles();
  result.faces.reserve(faces.faces().size());
  for (const int f : faces.faces())
    result.faces.push_back(surface.indexing().face(f));
  return result;
}

namespace internal {

/// What `tessellate_T_spline()` does with the parameter domain tessellated. Vertices and faces are added in the order of
/// the places and the triangles.
template <typename Surface, typename TriangleMesh, typename NamedParameters>
void add_tessellation(const Surface& surface,
                      const T_spline_tessellation<typename Surface::Graph, typename Surface::FT>& tessellation,
                      TriangleMesh& mesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map =
      choose_parameter(get_parameter(np, np_tags::output_vertex_point_map), get_property_map(CGAL::vertex_point, mesh));
  const auto normal_map = get_parameter(np, CGAL::internal_np::vertex_normal_map);
  const auto place_map = get_parameter(np, np_tags::vertex_place_map);
  using Point_3 = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;

  std::vector<typename Surface::Point_3> positions;
  positions.reserve(tessellation.places.size());
  surface.positions(tessellation.places, std::back_inserter(positions));
  std::vector<Point_3> points;
  points.reserve(positions.size());
  for (const auto& p : positions)
    points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, tessellation.triangles, mesh,
                                                              CGAL::parameters::default_values(),
                                                              CGAL::parameters::vertex_point_map(point_map));
  std::size_t i = 0; // vertices are added in the order of the points
  for ([[maybe_unused]] const auto v : CGAL::make_range(vertices(mesh))) {
    CGAL_assertion(get(point_map, v) == points[i]);
    [[maybe_unused]] const auto& place = tessellation.places[i++];
    if constexpr (!is_missing<decltype(normal_map)>)
      put(normal_map, v, surface.unit_normal(place.face, place.u, place.v));
    if constexpr (!is_missing<decltype(place_map)>)
      put(place_map, v, place);
  }
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// tessellates a T-spline surface into a triangle mesh without cracks, as `tessellate_parameter_domain()` divides it.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \param surface \pre it is valid
/// \param resolution n >= 2: each side of a face is divided into at least n parts, its inside into n x n cells
/// \param mesh receives the triangles. \pre it is empty
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{output_vertex_point_map}
///     \cgalParamDescription{receives the points of `mesh`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_normal_map}
///     \cgalParamDescription{receives the unit normals of the surface}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Vector_3`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_place_map}
///     \cgalParamDescription{receives where the vertices lie on the surface}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `T_mesh_place<Graph, FT>`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the size of the result, for a `T_spline_surface` times the number of basis functions of a
/// face.
template <typename Surface, typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void tessellate_T_spline(const Surface& surface, const int resolution, TriangleMesh& mesh,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::add_tessellation(surface, tessellate_parameter_domain(surface, resolution), mesh, np);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_TESSELLATE_T_SPLINE_H
