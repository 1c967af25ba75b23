// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_CHECK_T_SPLINE_SELF_INTERSECTIONS_H
#define CGAL_T_SPLINES_SPLINE_CHECK_T_SPLINE_SELF_INTERSECTIONS_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// What `check_T_spline_self_intersections()` found.
struct T_spline_self_intersection_report {
  std::size_t number_of_triangles = 0;                       ///< of the tessellation
  std::size_t number_of_intersections = 0;                   ///< pairs of triangles of the tessellation that intersect
  std::size_t number_of_mesh_intersections = 0;              ///< pairs of triangles of the mesh that intersect
  std::size_t number_of_new_intersections = 0;               ///< those of the tessellation where the mesh has none
  CGAL::Simple_cartesian<double>::Point_3 place = {0, 0, 0}; ///< next to the first new intersection, if there is any

  /// returns whether the surface passes through itself nowhere but where the mesh does.
  bool success() const { return number_of_new_intersections == 0; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

namespace internal {

/// The pairs of faces that intersect, by exact predicates on points in doubles. Faces without area do not count.
template <typename TriangleMesh, typename VertexPointMap>
auto intersecting_faces(const TriangleMesh& mesh, const VertexPointMap point_map)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto points = boost::make_function_property_map<typename Traits::vertex_descriptor, Kernel::Point_3>(
      [&](const typename Traits::vertex_descriptor v) {
        const Triangle_set::Point_3 p = point_in_doubles(get(point_map, v));
        return Kernel::Point_3(p.x(), p.y(), p.z());
      });
  std::vector<typename Traits::face_descriptor> proper;
  for (const auto f : CGAL::make_range(faces(mesh))) {
    const auto h = halfedge(f, mesh);
    if (!CGAL::collinear(get(points, source(h, mesh)), get(points, target(h, mesh)),
                         get(points, target(next(h, mesh), mesh))))
      proper.push_back(f);
  }
  std::vector<std::pair<typename Traits::face_descriptor, typename Traits::face_descriptor>> result;
  CGAL::Polygon_mesh_processing::self_intersections(proper, mesh, std::back_inserter(result),
                                                    CGAL::parameters::vertex_point_map(points).geom_traits(Kernel()));
  return result;
}

/// The points of a face of a mesh.
template <typename TriangleMesh, typename VertexPointMap>
std::array<Triangle_set::Point_3, 3> corners_of(const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                                                const TriangleMesh& mesh, const VertexPointMap point_map)
{
  const auto h = halfedge(f, mesh);
  return {point_in_doubles(get(point_map, source(h, mesh))), point_in_doubles(get(point_map, target(h, mesh))),
          point_in_doubles(get(point_map, target(next(h, mesh), mesh)))};
}

/// The places where a mesh passes through itself.
class Mesh_intersections {
public:
  template <typename TriangleMesh, typename VertexPointMap>
  Mesh_intersections(const TriangleMesh& mesh, const VertexPointMap point_map)
  {
    Triangle_set set;
    for (const auto& pair : intersecting_faces(mesh, point_map)) {
      ++m_number_of_pairs;
      for (const auto f : {pair.first, pair.second}) {
        const std::size_t first = set.points.size();
        for (const Triangle_set::Point_3& p : corners_of(f, mesh, point_map))
          set.points.push_back(p);
        set.triangles.push_back({first, first + 1, first + 2});
      }
    }
    if (!set.triangles.empty())
      m_tree = std::make_unique<const Triangle_tree>(set);
  }

  std::size_t number_of_pairs() const { return m_number_of_pairs; }

  /// Whether a corner of a triangle is next to one.
  bool is_near(const std::array<Triangle_set::Point_3, 3>& triangle, const double distance) const
  {
    return m_tree != nullptr && std::any_of(triangle.begin(), triangle.end(), [&](const Triangle_set::Point_3& p) {
             return m_tree->distance(p) <= distance;
           });
  }

private:
  std::size_t m_number_of_pairs = 0;
  std::unique_ptr<const Triangle_tree> m_tree; // of the triangles of the mesh that intersect; null if there are none
};

/// What `check_T_spline_self_intersections()` does, the number of intersections of the mesh apart.
/// \param of_mesh returns the `Mesh_intersections`; it is only called where the surface passes through itself
template <typename Surface, typename OfMesh, typename OutputIterator>
T_spline_self_intersection_report find_new_self_intersections(const Surface& surface, const int resolution,
                                                              const OfMesh& of_mesh, const double tolerance,
                                                              OutputIterator faces)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Tessellation = CGAL::Surface_mesh<Kernel::Point_3>;
  const auto domain = tessellate_parameter_domain(surface, resolution);
  Tessellation tessellation;
  add_tessellation(surface, domain, tessellation, CGAL::parameters::default_values());
  const auto pairs = intersecting_faces(tessellation, tessellation.points());

  T_spline_self_intersection_report report;
  report.number_of_triangles = tessellation.number_of_faces();
  report.number_of_intersections = pairs.size();
  std::vector<int> found;
  for (const auto& pair : pairs) {
    const auto a = corners_of(pair.first, tessellation, tessellation.points()),
               b = corners_of(pair.second, tessellation, tessellation.points());
    if (of_mesh().is_near(a, tolerance) && of_mesh().is_near(b, tolerance))
      continue;
    if (report.number_of_new_intersections++ == 0)
      report.place = CGAL::centroid(a[0], a[1], a[2]);
    for (const auto f : {pair.first, pair.second})
      found.push_back(surface.indexing().face_index(domain.faces[f]));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const int f : found)
    *faces++ = surface.indexing().face(f);
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// checks where a T-spline surface passes through itself: the triangles of its tessellation, by exact predicates; and
/// whether the mesh that it approximates does so there.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`, with which this is faster
/// \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` whose faces are triangles
/// \tparam OutputIterator takes faces of the T-mesh
/// \param surface \pre it is valid
/// \param mesh what the surface approximates
/// \param faces receives the faces of the T-mesh whose triangles intersect others where the mesh does not, each once
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///     \cgalParamExtra{Points of any kernel, rounded to doubles.}
///   \cgalParamNEnd
///   \cgalParamNBegin{tessellation_resolution}
///     \cgalParamDescription{as for `tessellate_T_spline()`, at least 2}
///     \cgalParamType{`int`}
///     \cgalParamDefault{8}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{a length: triangles of the surface that are not farther from triangles of the mesh that
///       intersect are where the mesh intersects}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: n log^3 n for n triangles and few intersections.
template <typename Surface, typename TriangleMesh, typename OutputIterator,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_self_intersection_report
check_T_spline_self_intersections(const Surface& surface, const TriangleMesh& mesh, OutputIterator faces,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  const int resolution = choose_parameter(get_parameter(np, np_tags::tessellation_resolution), 8);
  const double tolerance = choose_parameter(get_parameter(np, np_tags::tolerance), 0.);
  const internal::Mesh_intersections of_mesh(mesh, point_map);
  auto report = internal::find_new_self_intersections(
      surface, resolution, [&]() -> const internal::Mesh_intersections& { return of_mesh; }, tolerance, faces);
  report.number_of_mesh_intersections = of_mesh.number_of_pairs();
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_CHECK_T_SPLINE_SELF_INTERSECTIONS_H
