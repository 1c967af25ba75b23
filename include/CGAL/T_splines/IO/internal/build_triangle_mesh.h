// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_BUILD_TRIANGLE_MESH_H
#define CGAL_T_SPLINES_IO_INTERNAL_BUILD_TRIANGLE_MESH_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/triangulate_polygon_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Appends the triangles to a mesh, vertices and faces in the order of the soup.
template <typename MutableFaceGraph, typename VertexPointMap>
void build_triangle_mesh(const Polygon_soup& soup, const Triangle_soup& triangles, MutableFaceGraph& mesh,
                         const VertexPointMap vertex_point_map)
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using vertex_descriptor = typename boost::graph_traits<MutableFaceGraph>::vertex_descriptor;
  std::vector<vertex_descriptor> vertices;
  vertices.reserve(soup.points.size());
  for (const std::array<double, 3>& p : soup.points) {
    vertices.push_back(add_vertex(mesh));
    put(vertex_point_map, vertices.back(), Point_3(p[0], p[1], p[2]));
  }
  std::array<vertex_descriptor, 3> corners;
  for (const std::array<std::size_t, 3>& triangle : triangles.triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = vertices[triangle[i]];
    CGAL::Euler::add_face(corners, mesh);
  }
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_BUILD_TRIANGLE_MESH_H
