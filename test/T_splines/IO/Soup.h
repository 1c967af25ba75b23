// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_IO_SOUP_H
#define T_SPLINES_TEST_IO_SOUP_H

#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

/// Points and polygons of a mesh that a test makes and writes.
struct Soup {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> faces;

  /// Adds a box of quadrilaterals that share their corners.
  void add_box(const std::array<double, 3>& low, const std::array<double, 3>& size)
  {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < 8; ++i)
      points.push_back(
          {low[0] + (i % 2 ? size[0] : 0), low[1] + (i / 2 % 2 ? size[1] : 0), low[2] + (i / 4 ? size[2] : 0)});
    for (const std::array<std::size_t, 4>& f :
         {std::array<std::size_t, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
      faces.push_back({n + f[0], n + f[1], n + f[2], n + f[3]});
  }

  /// Adds a torus of 2n times n quadrilaterals with two triangles each.
  void add_torus(const std::size_t n)
  {
    const std::size_t first = points.size();
    const double tau = 8 * std::atan(1.);
    for (std::size_t i = 0; i < 2 * n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double a = tau * static_cast<double>(i) / static_cast<double>(2 * n);
        const double b = tau * static_cast<double>(j) / static_cast<double>(n);
        points.push_back({(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)});
      }
    for (std::size_t i = 0; i < 2 * n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t k = (i + 1) % (2 * n), l = (j + 1) % n;
        faces.push_back({first + i * n + j, first + k * n + j, first + k * n + l});
        faces.push_back({first + i * n + j, first + k * n + l, first + i * n + l});
      }
  }

  /// Gives each face corners of its own, as files with normals per face have.
  Soup split() const
  {
    Soup result;
    for (const std::vector<std::size_t>& face : faces) {
      result.faces.emplace_back();
      for (const std::size_t v : face) {
        result.faces.back().push_back(result.points.size());
        result.points.push_back(points[v]);
      }
    }
    return result;
  }

  void write(const std::string& name) const
  {
    std::ofstream file(name);
    file.precision(17);
    const std::string extension = name.substr(name.size() - 4);
    if (extension == ".off")
      file << "OFF\n" << points.size() << " " << faces.size() << " 0\n";
    else if (extension == ".ply")
      file << "ply\nformat ascii 1.0\nelement vertex " << points.size()
           << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << faces.size()
           << "\nproperty list uchar int vertex_indices\nend_header\n";
    else if (extension == ".stl") {
      write_facets(file);
      return;
    }
    for (const std::array<double, 3>& p : points)
      file << (extension == ".obj" ? "v " : "") << p[0] << " " << p[1] << " " << p[2] << "\n";
    for (const std::vector<std::size_t>& face : faces) {
      if (extension == ".obj")
        file << "f";
      else
        file << face.size();
      for (const std::size_t v : face)
        file << " " << v + (extension == ".obj" ? 1 : 0);
      file << "\n";
    }
  }

private:
  void write_facets(std::ofstream& file) const
  {
    file << "solid\n";
    for (const std::vector<std::size_t>& face : faces)
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        file << "facet normal 0 0 0\nouter loop\n";
        for (const std::size_t v : {face[0], face[i], face[i + 1]})
          file << "vertex " << points[v][0] << " " << points[v][1] << " " << points[v][2] << "\n";
        file << "endloop\nendfacet\n";
      }
    file << "endsolid\n";
  }
};

/// A soup that was written and read.
struct Read_soup {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

  Mesh mesh;
  CGAL::T_splines::Mesh_reading_report report;
  double volume = 0; ///< of a closed surface
  std::size_t components = 0;
  long euler_characteristic = 0;

  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Read_soup(const Soup& soup, const std::string& extension = ".off",
                     const NamedParameters& np = CGAL::parameters::default_values())
  {
    const Temporary_directory directory;
    const std::string name = directory.file("soup" + extension);
    soup.write(name);
    report = CGAL::T_splines::read_triangle_mesh(name, mesh, np);
    if (!report.success())
      return;
    if (CGAL::is_closed(mesh))
      volume = CGAL::Polygon_mesh_processing::volume(mesh);
    auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
    components = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
    euler_characteristic = static_cast<long>(mesh.number_of_vertices()) - static_cast<long>(mesh.number_of_edges()) +
                           static_cast<long>(mesh.number_of_faces());
  }
};

#endif // T_SPLINES_TEST_IO_SOUP_H
