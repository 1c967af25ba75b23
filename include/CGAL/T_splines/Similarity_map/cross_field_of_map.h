// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_CROSS_FIELD_OF_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_CROSS_FIELD_OF_MAP_H

#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The quarter turns, from 0 to 3, from the direction of u in the face of `h` to that in the face of its opposite; 0 on the
/// border.
template <typename TriangleMesh, typename HalfedgeUVMap>
int matching_of_map(const TriangleMesh& mesh, const HalfedgeUVMap& uv_map,
                    const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h)
{
  const auto g = opposite(h, mesh);
  if (is_border(h, mesh) || is_border(g, mesh))
    return 0;
  const auto direction = [&](const auto& from, const auto& to) {
    return std::atan2(CGAL::to_double(to.y() - from.y()), CGAL::to_double(to.x() - from.x()));
  };
  const double here = direction(get(uv_map, prev(h, mesh)), get(uv_map, h)),
               there = direction(get(uv_map, g), get(uv_map, prev(g, mesh))), quarter = 2 * std::atan(1.);
  return (static_cast<int>(std::lround((here - there) / quarter)) + 8) % 4;
}

} // namespace internal

/// \ingroup PkgTSplinesSimilarityMap
/// computes the cross field that a map follows: its isolines.
///
/// With it `align_seamless_map()` changes nothing but the scale factors.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap`, halfedge -> `Point_2`: the coordinates of the target of the
///   halfedge in the chart of its face
/// \tparam CrossFieldMap a model of `WritablePropertyMap` from faces to three-dimensional vectors, which are
///   constructible from three `double`s
/// \param mesh a triangle mesh
/// \param uv_map a map without degenerate triangles
/// \param cross_field receives the direction in which u grows and v is constant, of length 1
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
///     \cgalParamDescription{receives the matchings, as `holonomy_signature_of_cross_field()` takes them: the rotations of
///       the map's transitions, where the angle between two crosses may be more than an eighth of a turn}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       an integer}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the size of the mesh.
template <typename TriangleMesh, typename HalfedgeUVMap, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void cross_field_of_map(const TriangleMesh& mesh, const HalfedgeUVMap uv_map, CrossFieldMap cross_field,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using Vector_3 = typename boost::property_traits<CrossFieldMap>::value_type;
  const auto points =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_const_property_map(CGAL::vertex_point, mesh));
  for (const auto f : CGAL::make_range(faces(mesh))) {
    const auto h = halfedge(f, mesh), j = next(h, mesh), k = next(j, mesh);
    const auto &p = get(points, target(h, mesh)), &q = get(points, target(j, mesh)), &r = get(points, target(k, mesh));
    const auto &a = get(uv_map, h), &b = get(uv_map, j), &c = get(uv_map, k);
    // The direction d with d = s (q - p) + t (r - p) and s (b - a) + t (c - a) a multiple of (1, 0).
    const double s = CGAL::to_double(c.y() - a.y()), t = CGAL::to_double(a.y() - b.y());
    const double x = s * CGAL::to_double(q.x() - p.x()) + t * CGAL::to_double(r.x() - p.x()),
                 y = s * CGAL::to_double(q.y() - p.y()) + t * CGAL::to_double(r.y() - p.y()),
                 z = s * CGAL::to_double(q.z() - p.z()) + t * CGAL::to_double(r.z() - p.z());
    const double length = std::hypot(x, y, z);
    put(cross_field, f, Vector_3(x / length, y / length, z / length));
  }
  const auto matchings = CGAL::parameters::get_parameter(np, np_tags::halfedge_matching_map);
  if constexpr (!internal::is_missing<decltype(matchings)>)
    for (const auto h : CGAL::make_range(halfedges(mesh)))
      put(matchings, h, internal::matching_of_map(mesh, uv_map, h));
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_CROSS_FIELD_OF_MAP_H
