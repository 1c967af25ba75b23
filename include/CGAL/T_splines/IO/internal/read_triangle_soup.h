// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_READ_TRIANGLE_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_READ_TRIANGLE_SOUP_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/check_polygon_soup.h>
#include <CGAL/T_splines/IO/internal/parse_obj.h>
#include <CGAL/T_splines/IO/internal/parse_off.h>
#include <CGAL/T_splines/IO/internal/parse_ply.h>
#include <CGAL/T_splines/IO/internal/parse_stl.h>
#include <CGAL/T_splines/IO/internal/read_whole_file.h>
#include <CGAL/T_splines/IO/internal/triangulate_polygon_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

inline std::string lowercase_extension(const std::string& filename)
{
  std::string extension = std::filesystem::path(filename).extension().string();
  for (char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// Reads what stands in a file, by the parser of its extension.
inline Mesh_reading_report parse_mesh_file(const std::string& filename, Polygon_soup& soup)
{
  using Parser = Mesh_reading_report (*)(std::string_view, Polygon_soup&);
  const std::string extension = lowercase_extension(filename);
  const Parser parser = extension == ".off"   ? Parser(parse_off)
                        : extension == ".obj" ? Parser(parse_obj)
                        : extension == ".ply" ? Parser(parse_ply)
                        : extension == ".stl" ? Parser(parse_stl)
                                              : Parser(nullptr);
  Mesh_reading_report report;
  std::string content;
  if (parser == nullptr)
    report.status = Mesh_reading_status::UNKNOWN_FORMAT;
  else if (!read_whole_file(filename, content))
    report.status = Mesh_reading_status::CANNOT_OPEN;
  else if (content.find_first_not_of(" \t\r\n") == std::string::npos)
    report.status = Mesh_reading_status::EMPTY;
  else if (extension == ".stl") // binary or text
    report = parse_stl(content, soup);
  else if (has_mark_of_utf_16(content)) {
    report.status = Mesh_reading_status::UNSUPPORTED_VARIANT;
    report.text = "UTF-16";
  }
  else
    report = parser(without_byte_order_mark(content), soup);
  return report;
}

/// Completes the report of a soup that was accepted.
inline void count_elements(const Polygon_soup& soup, Mesh_reading_report& report)
{
  report.number_of_vertices = soup.points.size();
  report.number_of_faces = soup.number_of_polygons();
  report.number_of_merged_points = soup.number_of_merged_points;
  report.number_of_trailing_bytes = soup.number_of_trailing_bytes;
  for (std::size_t f = soup.number_of_polygons(); f-- > 0;)
    if (soup.size_of_polygon(f) != 3) {
      ++report.number_of_triangulated_faces;
      report.first_triangulated_face = f;
    }
}

/// Reads a file, checks everything and triangulates: what the public readers have in common.
inline Mesh_reading_report read_triangle_soup(const std::string& filename, const bool is_boundary_admitted,
                                              Polygon_soup& soup, Triangle_soup& triangles)
{
  Mesh_reading_report report = parse_mesh_file(filename, soup);
  if (report.success())
    report = Polygon_soup_checker(soup, is_boundary_admitted).check();
  if (!report.success())
    return report;
  triangles = triangulate_polygon_soup(soup);
  report = check_triangle_geometry(soup, triangles);
  if (report.success())
    count_elements(soup, report);
  return report;
}

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

#endif // CGAL_T_SPLINES_IO_INTERNAL_READ_TRIANGLE_SOUP_H
