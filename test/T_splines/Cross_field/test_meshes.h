// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TEST_CROSS_FIELD_TEST_MESHES_H
#define CGAL_T_SPLINES_TEST_CROSS_FIELD_TEST_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron_3 = CGAL::Polyhedron_3<Kernel>;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

struct Soup {
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
};

template <typename Mesh>
Mesh to_mesh(const Soup& soup)
{
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  return mesh;
}

// A torus of m x n quadrilaterals, each cut in two.
inline Soup torus(const int m, const int n, const double radius = 3, const double tube = 1)
{
  Soup soup;
  const double pi = 3.14159265358979323846;
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double a = 2 * pi * i / m, b = 2 * pi * j / n, r = radius + tube * std::cos(b);
      soup.points.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
      const auto index = [m, n](const int k, const int l) { return static_cast<std::size_t>((k % m) * n + l % n); };
      soup.faces.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      soup.faces.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return soup;
}

// The surface of unit cubes, each of its squares cut into 2 n^2 triangles.
inline Soup cubes(const std::function<bool(int, int, int)>& is_filled, const int size, const int n = 2)
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto inserted = index.emplace(p, soup.points.size());
    if (inserted.second)
      soup.points.emplace_back(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n);
    return inserted.first->second;
  };
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      for (int z = 0; z < size; ++z)
        for (int axis = 0; axis < 3 && is_filled(x, y, z); ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> neighbor = {x, y, z};
            neighbor[axis] += 2 * side - 1;
            if (is_filled(neighbor[0], neighbor[1], neighbor[2]))
              continue;
            const int first = side == 1 ? (axis + 1) % 3 : (axis + 2) % 3, second = 3 - axis - first;
            std::array<int, 3> corner = {n * x, n * y, n * z};
            corner[axis] += n * side;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const auto at = [&](const int k, const int l) {
                  std::array<int, 3> p = corner;
                  p[first] += i + k;
                  p[second] += j + l;
                  return vertex(p);
                };
                soup.faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
                soup.faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
              }
          }
  return soup;
}

// A plate of cubes with `genus` holes.
inline Soup plate(const int genus, const int n = 2)
{
  const int length = 2 * genus + 1;
  return cubes(
      [length](const int x, const int y, const int z) {
        return x >= 0 && x < length && y >= 0 && y < 3 && z == 0 && !(y == 1 && x % 2 == 1);
      },
      length < 3 ? 3 : length, n);
}

// Both surfaces, the second one moved away from the first.
inline Soup disjoint_union(const Soup& a, const Soup& b)
{
  Soup soup = a;
  for (const Point_3& p : b.points)
    soup.points.push_back(p + Vector_3(100, 0, 0));
  for (std::vector<std::size_t> face : b.faces) {
    for (std::size_t& v : face)
      v += a.points.size();
    soup.faces.push_back(face);
  }
  return soup;
}

inline Soup transformed(Soup soup, const double scale, const Vector_3& translation)
{
  for (Point_3& p : soup.points)
    p = Point_3(scale * p.x(), scale * p.y(), scale * p.z()) + translation;
  return soup;
}

// A torus without its first face.
inline Soup punctured_torus()
{
  Soup soup = torus(12, 8);
  soup.faces.erase(soup.faces.begin());
  return soup;
}

template <typename Mesh>
using Face_vector_map = typename boost::property_map<Mesh, CGAL::dynamic_face_property_t<Vector_3>>::type;

// The field of the directions around the axis of a surface of revolution about the z-axis.
template <typename Mesh>
Face_vector_map<Mesh> field_around_axis(Mesh& mesh)
{
  Face_vector_map<Mesh> field = get(CGAL::dynamic_face_property_t<Vector_3>(), mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const Point_3 center = CGAL::centroid(get(points, source(h, mesh)), get(points, target(h, mesh)),
                                          get(points, target(next(h, mesh), mesh)));
    const Vector_3 normal = CGAL::normal(get(points, source(h, mesh)), get(points, target(h, mesh)),
                                         get(points, target(next(h, mesh), mesh)));
    const Vector_3 around(-center.y(), center.x(), 0);
    put(field, f, around - (around * normal) / normal.squared_length() * normal);
  }
  return field;
}

// A cylinder of radius 1 whose bottom and top are fans: around their middles, or around one vertex of the rim.
inline Soup cylinder(const std::size_t sides, const double height, const bool has_middles)
{
  Soup soup;
  const double pi = 3.14159265358979323846;
  for (std::size_t i = 0; i < sides; ++i) {
    const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(sides);
    for (const double z : {0., height})
      soup.points.emplace_back(std::cos(a), std::sin(a), z);
    const std::size_t j = (i + 1) % sides;
    soup.faces.push_back({2 * i, 2 * j, 2 * j + 1});
    soup.faces.push_back({2 * i, 2 * j + 1, 2 * i + 1});
    const std::size_t bottom = has_middles ? 2 * sides : 0, top = bottom + 1;
    if (has_middles || (i > 0 && j > 0)) {
      soup.faces.push_back({bottom, 2 * j, 2 * i});
      soup.faces.push_back({top, 2 * i + 1, 2 * j + 1});
    }
  }
  if (has_middles)
    for (const double z : {0., height})
      soup.points.emplace_back(0, 0, z);
  return soup;
}

// Two cones on one circle of radius 1, with their tips at the given heights.
inline Soup double_cone(const std::size_t sides, const double bottom, const double top)
{
  Soup soup;
  const double pi = 3.14159265358979323846;
  for (std::size_t i = 0; i < sides; ++i) {
    const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(sides);
    soup.points.emplace_back(std::cos(a), std::sin(a), 0);
    soup.faces.push_back({sides, (i + 1) % sides, i});
    soup.faces.push_back({sides + 1, i, (i + 1) % sides});
  }
  soup.points.emplace_back(0, 0, bottom);
  soup.points.emplace_back(0, 0, top);
  return soup;
}

} // namespace test

#endif // CGAL_T_SPLINES_TEST_CROSS_FIELD_TEST_MESHES_H
