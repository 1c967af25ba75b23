// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_REMOVE_DEGENERATE_TRIANGLES_H
#define CGAL_T_SPLINES_IO_INTERNAL_REMOVE_DEGENERATE_TRIANGLES_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/build_triangle_mesh.h>
#include <CGAL/T_splines/IO/internal/triangulate_polygon_soup.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

using Repair_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Repair_mesh = CGAL::Surface_mesh<Repair_point>;

/// A mesh whose elements know their numbers in the file, until they are replaced by new ones.
struct Numbered_mesh {
  Repair_mesh mesh;
  Repair_mesh::Property_map<Repair_mesh::Vertex_index, std::size_t> point, point_line;
  Repair_mesh::Property_map<Repair_mesh::Face_index, std::size_t> polygon, polygon_line;

  Numbered_mesh(const Polygon_soup& soup, const Triangle_soup& triangles)
  {
    constexpr std::size_t none = Mesh_reading_report::none;
    point = mesh.add_property_map<Repair_mesh::Vertex_index, std::size_t>("v:number", none).first;
    point_line = mesh.add_property_map<Repair_mesh::Vertex_index, std::size_t>("v:line", none).first;
    polygon = mesh.add_property_map<Repair_mesh::Face_index, std::size_t>("f:number", none).first;
    polygon_line = mesh.add_property_map<Repair_mesh::Face_index, std::size_t>("f:line", none).first;
    build_triangle_mesh(soup, triangles, mesh, mesh.points());
    for (const Repair_mesh::Vertex_index v : mesh.vertices()) {
      point[v] = soup.number_of_point(v);
      point_line[v] = soup.line_of_point(v);
    }
    for (const Repair_mesh::Face_index f : mesh.faces()) {
      polygon[f] = soup.number_of_polygon(triangles.polygon_of_triangle[f]);
      polygon_line[f] = soup.line_of_polygon(triangles.polygon_of_triangle[f]);
    }
  }
  Numbered_mesh(const Numbered_mesh&) = delete;
  Numbered_mesh& operator=(const Numbered_mesh&) = delete;

  Polygon_soup soup() const
  {
    Polygon_soup result;
    std::vector<std::size_t> index_of_vertex(mesh.num_vertices(), 0); // with those that were removed
    for (const Repair_mesh::Vertex_index v : mesh.vertices()) {
      index_of_vertex[v] = result.points.size();
      const Repair_point& p = mesh.point(v);
      result.points.push_back({p.x(), p.y(), p.z()});
      result.point_numbers.push_back(point[v]);
      result.point_lines.push_back(point_line[v]);
    }
    for (const Repair_mesh::Face_index f : mesh.faces()) {
      for (const Repair_mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        result.corners.push_back(index_of_vertex[v]);
      result.end_polygon();
      result.polygon_numbers.push_back(polygon[f]);
      result.polygon_lines.push_back(polygon_line[f]);
    }
    return result;
  }
};

/// Removes triangles whose area is exactly zero, by flips and collapses of edges. \pre The triangles are a manifold.
/// \return whether none is left; if one is, nothing has changed.
inline bool remove_degenerate_triangles(Polygon_soup& soup, Triangle_soup& triangles, Mesh_repairs& repairs)
{
  Numbered_mesh numbered(soup, triangles);
  Repair_mesh& mesh = numbered.mesh;
  std::size_t number_of_degenerate = 0;
  for (const Repair_mesh::Face_index f : mesh.faces())
    number_of_degenerate += CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, mesh);
  if (number_of_degenerate == 0)
    return true;
  if (!CGAL::Polygon_mesh_processing::remove_degenerate_faces(mesh))
    return false;
  repairs.flat_triangles += number_of_degenerate;
  soup = numbered.soup();
  triangles = triangulate_polygon_soup(soup);
  return true;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_REMOVE_DEGENERATE_TRIANGLES_H
