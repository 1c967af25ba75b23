// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_MEASURE_T_SPLINE_DEVIATION_H
#define CGAL_T_SPLINES_SPLINE_MEASURE_T_SPLINE_DEVIATION_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/Spline/internal/area_samples.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Distances of weighted points.
class Deviation_sum {
public:
  void add(const Triangle_set::Point_3& p, const double weight, const double distance)
  {
    m_weight += weight;
    m_sum += weight * distance * distance;
    ++m_result.number_of_samples;
    if (distance > m_result.maximum || m_result.number_of_samples == 1) {
      m_result.maximum = distance;
      m_result.farthest_point = p;
    }
  }

  One_way_deviation result(const double extent) const
  {
    One_way_deviation result = m_result;
    result.extent = extent;
    result.rms = m_weight > 0 ? std::sqrt(m_sum / m_weight) : 0;
    return result;
  }

private:
  double m_weight = 0, m_sum = 0;
  One_way_deviation m_result;
};

/// Four times as many triangles as the mesh has, at least 200000, and at least 4 parts per side.
inline int deviation_resolution(const std::size_t number_of_triangles, const std::size_t number_of_faces)
{
  const double triangles = (std::max)(4 * static_cast<double>(number_of_triangles), 200000.);
  const double parts = std::sqrt(triangles / (2 * (std::max)(static_cast<double>(number_of_faces), 1.)));
  return (std::max)(static_cast<int>(std::ceil(parts)), 4);
}

/// The tessellation in doubles. \return whether its points are finite
template <typename Surface>
bool tessellate(const Surface& surface, const int resolution, Triangle_set& set)
{
  const auto tessellation = tessellate_parameter_domain(surface, resolution);
  std::vector<typename Surface::Point_3> positions;
  positions.reserve(tessellation.places.size());
  surface.positions(tessellation.places, std::back_inserter(positions));
  set.points.reserve(positions.size());
  for (const auto& p : positions)
    set.points.push_back(point_in_doubles(p));
  set.triangles = tessellation.triangles;
  return std::all_of(set.points.begin(), set.points.end(), is_within_range);
}

/// How large a triangle of the mesh may be if it is measured at its corners alone: some triangles of the tessellation.
inline double measured_size(const Triangle_set& mesh, const Triangle_set& surface)
{
  constexpr double sides_of_triangles = 4, most_parts_of_extent = 1000, samples_per_triangle = 2,
                   smallest_number_of_samples = 100000;
  double surface_area = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    surface_area += area(surface.triangle(i));
  const double side = std::sqrt(surface_area / static_cast<double>(surface.triangles.size()));
  const double size = (std::max)(
      {sides_of_triangles * side, mesh.extent() / most_parts_of_extent, (std::numeric_limits<double>::min)()});
  const double number = samples_per_triangle * static_cast<double>(mesh.triangles.size() + surface.triangles.size());
  return affordable_size(mesh, size, (std::max)(number, smallest_number_of_samples));
}

/// Measures the distances of some triangles from others.
/// \param size as for `visit_area_samples()`
/// \param visit_point called with the number of each point and its distance
template <typename VisitPoint>
Deviation_sum one_way_deviation(const Triangle_set& from, const double size, const Triangle_set& to,
                                const VisitPoint& visit_point)
{
  const Triangle_tree tree(to);
  Deviation_sum sum;
  const std::vector<double> weights = visit_area_samples(
      from, size, [&](const Triangle_set::Point_3& p, const double weight) { sum.add(p, weight, tree.distance(p)); });
  for (std::size_t i = 0; i < from.points.size(); ++i) {
    const double distance = tree.distance(from.points[i]);
    sum.add(from.points[i], weights[i], distance);
    visit_point(i, distance);
  }
  return sum;
}

} // namespace internal

/// measures the distances between a T-spline surface and a triangle mesh, both ways. They are distances in space,
/// between a point of the one and the closest point of the other: no parametrization is involved.
///
/// For this, the surface is tessellated. So the distances of the mesh from the surface have an error of second order in
/// the size of the tessellation's triangles. They are measured at all vertices of the mesh and also inside of those
/// triangles that are large compared with the tessellation's, as densely as about two samples per triangle of both
/// allow; those of the surface at the vertices of the tessellation. Means are weighted by area.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`, with which this is faster
/// \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
/// \param surface \pre it is valid
/// \param mesh it may have borders, several components and degenerate faces. Vertices without faces do not count.
/// \param np optional named parameters:
///   `CGAL::parameters::vertex_point_map`: points of the mesh, of any kernel; the distances are computed in doubles;
///   `T_splines::parameters::tessellation_resolution`: an `int` of at least 2, the number of parts into which each side
///     of a face of the T-mesh is divided (default: the number, at least 4, with which the tessellation has about four
///     times as many triangles as the mesh and 200000 at least);
///   `T_splines::parameters::vertex_distance_map`: vertex of the mesh -> `double`, writable: its distance from the
///     surface; written upon success, for the vertices of faces
/// \return the distances, or why there are none. `Mesh_distance` tells the distances of other points from the mesh.
/// Complexity: for n triangles of mesh and tessellation, n log n as a rule.
template <typename Surface, typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_deviation_report<TriangleMesh>
measure_T_spline_deviation(const Surface& surface, const TriangleMesh& mesh,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  const auto distance_map = get_parameter(np, np_tags::vertex_distance_map);

  internal::Triangle_set triangles, tessellation;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_read;
  T_spline_deviation_report<TriangleMesh> report =
      internal::read_triangle_set(mesh, point_map, triangles, &vertices_read);
  if (!report.success())
    return report;
  const int default_resolution =
      internal::deviation_resolution(triangles.triangles.size(), surface.indexing().number_of_faces());
  report.resolution = choose_parameter(get_parameter(np, np_tags::tessellation_resolution), default_resolution);
  if (!internal::tessellate(surface, report.resolution, tessellation)) {
    report.status = T_spline_deviation_status::SURFACE_NOT_FINITE;
    return report;
  }
  if (tessellation.triangles.empty()) {
    report.status = T_spline_deviation_status::SURFACE_WITHOUT_FACES;
    return report;
  }

  const double extent = triangles.extent(), size = internal::measured_size(triangles, tessellation);
  constexpr double any_size = (std::numeric_limits<double>::max)();
  report.surface_to_mesh =
      internal::one_way_deviation(tessellation, any_size, triangles, [](std::size_t, double) {}).result(extent);
  const auto put_distance = [&](const std::size_t i, const double distance) {
    if constexpr (!internal::is_missing<decltype(distance_map)>)
      put(distance_map, vertices_read[i], distance);
  };
  report.mesh_to_surface = internal::one_way_deviation(triangles, size, tessellation, put_distance).result(extent);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_MEASURE_T_SPLINE_DEVIATION_H
