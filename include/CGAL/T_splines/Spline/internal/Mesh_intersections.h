// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_MESH_INTERSECTIONS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_MESH_INTERSECTIONS_H

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/iterator.h>

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
namespace internal {

/// The pairs of faces that intersect, by exact predicates on points in doubles. Faces without area do not count.
/// \param progress if it is interrupted, there are no pairs
template <typename TriangleMesh, typename VertexPointMap>
auto intersecting_faces(const TriangleMesh& mesh, const VertexPointMap point_map, Progress& progress)
{
  // CGAL's search does not ask whether to go on: it is left by an exception, from its next look at a point.
  struct Interruption {};
  using Traits = boost::graph_traits<TriangleMesh>;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto points = boost::make_function_property_map<typename Traits::vertex_descriptor, Kernel::Point_3>(
      [&](const typename Traits::vertex_descriptor v) {
        if (!progress.go_on_after(1))
          throw Interruption();
        const Triangle_set::Point_3 p = point_in_doubles(get(point_map, v));
        return Kernel::Point_3(p.x(), p.y(), p.z());
      });
  std::vector<std::pair<typename Traits::face_descriptor, typename Traits::face_descriptor>> result;
  try {
    std::vector<typename Traits::face_descriptor> proper;
    for (const auto f : CGAL::make_range(faces(mesh))) {
      const auto h = halfedge(f, mesh);
      if (!CGAL::collinear(get(points, source(h, mesh)), get(points, target(h, mesh)),
                           get(points, target(next(h, mesh), mesh))))
        proper.push_back(f);
    }
    CGAL::Polygon_mesh_processing::self_intersections(proper, mesh, std::back_inserter(result),
                                                      CGAL::parameters::vertex_point_map(points).geom_traits(Kernel()));
  }
  catch (const Interruption&) {
    result.clear();
  }
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
  /// \param progress if it is interrupted, there are none
  template <typename TriangleMesh, typename VertexPointMap>
  Mesh_intersections(const TriangleMesh& mesh, const VertexPointMap point_map, Progress& progress)
  {
    Triangle_set set;
    for (const auto& pair : intersecting_faces(mesh, point_map, progress)) {
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

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_MESH_INTERSECTIONS_H
