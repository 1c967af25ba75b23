// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SIMILARITY_MAP_TEST_MESHES_H
#define T_SPLINES_TEST_SIMILARITY_MAP_TEST_MESHES_H

#include "Plain_map.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// Closed meshes made in code.
namespace test_meshes {

/// Makes a face graph of a triangle mesh, its vertices in the same order.
template <typename FaceGraph>
FaceGraph face_graph(const Plain_mesh& plain)
{
  FaceGraph mesh;
  using Point_3 =
      typename boost::property_traits<typename boost::property_map<FaceGraph, CGAL::vertex_point_t>::type>::value_type;
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> vertices;
  for (const auto& p : plain.points) {
    vertices.push_back(add_vertex(mesh));
    put(get(CGAL::vertex_point, mesh), vertices.back(), Point_3(p[0], p[1], p[2]));
  }
  for (const auto& t : plain.triangles)
    CGAL::Euler::add_face(
        std::array<typename boost::graph_traits<FaceGraph>::vertex_descriptor, 3>{
            {vertices[t[0]], vertices[t[1]], vertices[t[2]]}},
        mesh);
  return mesh;
}

inline Plain_mesh tetrahedron()
{
  return {{{{1, 1, 1}}, {{1, -1, -1}}, {{-1, 1, -1}}, {{-1, -1, 1}}},
          {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 1}}, {{1, 3, 2}}}};
}

inline Plain_mesh icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  return {{{{-1, g, 0}},
           {{1, g, 0}},
           {{-1, -g, 0}},
           {{1, -g, 0}},
           {{0, -1, g}},
           {{0, 1, g}},
           {{0, -1, -g}},
           {{0, 1, -g}},
           {{g, 0, -1}},
           {{g, 0, 1}},
           {{-g, 0, -1}},
           {{-g, 0, 1}}},
          {{{0, 11, 5}},  {{0, 5, 1}},  {{0, 1, 7}},  {{0, 7, 10}}, {{0, 10, 11}}, {{1, 5, 9}}, {{5, 11, 4}},
           {{11, 10, 2}}, {{10, 7, 6}}, {{7, 1, 8}},  {{3, 9, 4}},  {{3, 4, 2}},   {{3, 2, 6}}, {{3, 6, 8}},
           {{3, 8, 9}},   {{4, 9, 5}},  {{2, 4, 11}}, {{6, 2, 10}}, {{8, 6, 7}},   {{9, 8, 1}}}};
}

/// Splits each triangle into four. The first vertices stay the first.
inline Plain_mesh subdivided(const Plain_mesh& mesh)
{
  Plain_mesh result;
  result.points = mesh.points;
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](const int a, const int b) {
    const auto inserted =
        middle.emplace(std::make_pair(std::min(a, b), std::max(a, b)), static_cast<int>(result.points.size()));
    if (inserted.second) {
      const std::array<double, 3> p = mesh.points[a], q = mesh.points[b];
      result.points.push_back({{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}});
    }
    return inserted.first->second;
  };
  for (const auto& t : mesh.triangles) {
    const int a = middle_of(t[1], t[2]), b = middle_of(t[2], t[0]), c = middle_of(t[0], t[1]);
    for (const std::array<int, 3>& triangle :
         {std::array<int, 3>{{t[0], c, b}}, {{c, t[1], a}}, {{b, a, t[2]}}, {{a, b, c}}})
      result.triangles.push_back(triangle);
  }
  return result;
}

/// A geodesic sphere of radius 1. Its first 12 vertices are those of an icosahedron.
inline Plain_mesh sphere(const int subdivisions)
{
  Plain_mesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i)
    mesh = subdivided(mesh);
  for (auto& p : mesh.points) {
    const double r = std::hypot(p[0], p[1], p[2]);
    p = {{p[0] / r, p[1] / r, p[2] / r}};
  }
  return mesh;
}

/// A torus of revolution, m vertices around the axis and n around the tube.
inline Plain_mesh torus(const int m, const int n, const double large_radius = 2, const double small_radius = 1)
{
  Plain_mesh mesh;
  const double turn = 8 * std::atan(1.);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double r = large_radius + small_radius * std::cos(turn * j / n);
      mesh.points.push_back(
          {{r * std::cos(turn * i / m), r * std::sin(turn * i / m), small_radius * std::sin(turn * j / n)}});
    }
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int i1 = (i + 1) % m, j1 = (j + 1) % n;
      mesh.triangles.push_back({{n * i + j, n * i1 + j, n * i1 + j1}});
      mesh.triangles.push_back({{n * i + j, n * i1 + j1, n * i + j1}});
    }
  return mesh;
}

/// The boundary of a union of unit cubes, each square divided into n x n pairs of triangles.
/// \pre no two cubes meet in an edge or a vertex alone
inline Plain_mesh voxel_surface(const std::set<std::array<int, 3>>& cubes, const int n)
{
  Plain_mesh mesh;
  std::map<std::array<int, 3>, int> number;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto inserted = number.emplace(p, static_cast<int>(number.size()));
    if (inserted.second)
      mesh.points.push_back({{double(p[0]) / n, double(p[1]) / n, double(p[2]) / n}});
    return inserted.first->second;
  };
  for (const auto& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        std::array<int, 3> neighbor = cube;
        neighbor[axis] += side ? 1 : -1;
        if (cubes.count(neighbor))
          continue;
        const int first = side ? (axis + 1) % 3 : (axis + 2) % 3, second = side ? (axis + 2) % 3 : (axis + 1) % 3;
        std::array<int, 3> corner = {{n * cube[0], n * cube[1], n * cube[2]}};
        corner[axis] += side ? n : 0;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const auto at = [&](const int x, const int y) {
              std::array<int, 3> p = corner;
              p[first] += i + x;
              p[second] += j + y;
              return vertex(p);
            };
            const int a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
            if ((i + j) % 2 == 0)
              mesh.triangles.insert(mesh.triangles.end(), {{{a, b, c}}, {{a, c, d}}});
            else
              mesh.triangles.insert(mesh.triangles.end(), {{{a, b, d}}, {{b, c, d}}});
          }
      }
  return mesh;
}

/// A slab of unit cubes with `genus` holes in a row.
inline Plain_mesh slab_with_holes(const int genus, const int n)
{
  std::set<std::array<int, 3>> cubes;
  for (int x = 0; x < 2 * genus + 1; ++x)
    for (int y = 0; y < 3; ++y)
      if (y != 1 || x % 2 == 0)
        cubes.insert({{x, y, 0}});
  return voxel_surface(cubes, n);
}

inline Plain_mesh cube(const int n)
{
  return voxel_surface({{{0, 0, 0}}}, n);
}

/// Two meshes as one, the second moved along x.
inline Plain_mesh both(Plain_mesh mesh, const Plain_mesh& other, const double distance)
{
  const int offset = static_cast<int>(mesh.points.size());
  for (auto p : other.points)
    mesh.points.push_back({{p[0] + distance, p[1], p[2]}});
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({{t[0] + offset, t[1] + offset, t[2] + offset}});
  return mesh;
}

} // namespace test_meshes

#endif // T_SPLINES_TEST_SIMILARITY_MAP_TEST_MESHES_H
