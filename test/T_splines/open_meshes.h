// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_OPEN_MESHES_H
#define T_SPLINES_TEST_OPEN_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

/// Meshes with border, made in code.
namespace open_meshes {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

/// The cells (i, j) of an n x m grid for which `is_in(i, j)` says so, each as two triangles of alternating diagonals; the
/// vertex (i, j) is at `point(i, j)`.
template <typename IsIn, typename PointOf>
Mesh grid(const int n, const int m, const IsIn& is_in, const PointOf& point)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex> vertices;
  const auto vertex = [&](const int i, const int j) {
    const auto inserted = vertices.emplace(std::make_pair(i, j), Vertex());
    if (inserted.second)
      inserted.first->second = mesh.add_vertex(point(i, j));
    return inserted.first->second;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      if (!is_in(i, j))
        continue;
      const Vertex a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      if ((i + j) % 2 == 0) {
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
      else {
        mesh.add_face(a, b, d);
        mesh.add_face(b, c, d);
      }
    }
  return mesh;
}

/// A rectangle with n x m cells.
inline Mesh plate(const int n, const int m)
{
  return grid(
      n, m, [](int, int) { return true; }, [](const int i, const int j) { return Point_3(i, j, 0); });
}

/// An L: of a square with n x n cells, n even, the upper right quarter is missing.
inline Mesh l_shape(const int n)
{
  return grid(
      n, n, [n](const int i, const int j) { return i < n / 2 || j < n / 2; },
      [](const int i, const int j) { return Point_3(i, j, 0); });
}

/// A rectangle with n x n cells, n even, that is cut from the middle of the right side to the centre: the two sides of the cut
/// are `opening` apart at its end.
inline Mesh slit_plate(const int n, const double opening)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex> vertices;
  const auto vertex = [&](const int i, const int j, const int cell) {
    const bool is_above = i > n / 2 && j == n / 2 && cell >= n / 2;
    const auto inserted = vertices.emplace(std::make_pair(i, is_above ? -1 : j), Vertex());
    if (inserted.second) {
      const double share = i > n / 2 ? 1 - std::abs(2. * j / n - 1) : 0, side = is_above || j > n / 2 ? 1 : -1;
      inserted.first->second = mesh.add_vertex(Point_3(i, j + side * share * opening * (i - n / 2.) / n, 0));
    }
    return inserted.first->second;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vertex a = vertex(i, j, j), b = vertex(i + 1, j, j), c = vertex(i + 1, j + 1, j), d = vertex(i, j + 1, j);
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
    }
  return mesh;
}

/// A square with holes of h x h cells, `holes` x `holes` of them, h cells apart.
inline Mesh perforated_plate(const int holes, const int h)
{
  const int n = (2 * holes + 1) * h;
  return grid(
      n, n, [h](const int i, const int j) { return (i / h) % 2 == 0 || (j / h) % 2 == 0; },
      [](const int i, const int j) { return Point_3(i, j, 0); });
}

/// The disk of radius 1: six sectors, as many rings. Vertex k * rings of the border is at the angle k pi / 3.
inline Mesh disk(const int rings)
{
  Mesh mesh;
  std::vector<std::vector<Vertex>> ring(1, std::vector<Vertex>(1, mesh.add_vertex(Point_3(0, 0, 0))));
  for (int r = 1; r <= rings; ++r) {
    ring.emplace_back();
    for (int i = 0; i < 6 * r; ++i) {
      const double angle = 2 * CGAL_PI * i / (6 * r);
      ring[r].push_back(mesh.add_vertex(Point_3(r * std::cos(angle) / rings, r * std::sin(angle) / rings, 0)));
    }
    for (int sector = 0; sector < 6; ++sector)
      for (int i = 0; i < r; ++i) {
        const auto outer = [&](const int k) { return ring[r][(sector * r + k) % (6 * r)]; };
        const auto inner = [&](const int k) {
          return ring[r - 1][r == 1 ? 0 : (sector * (r - 1) + k) % (6 * (r - 1))];
        };
        mesh.add_face(outer(i), outer(i + 1), inner(i));
        if (i + 1 < r)
          mesh.add_face(inner(i), outer(i + 1), inner(i + 1));
      }
  }
  return mesh;
}

/// The annulus between the radii 1 and `outer`, with n x m cells around and across, evenly in the logarithm of the radius.
inline Mesh annulus(const double outer, const int n, const int m)
{
  Mesh mesh;
  std::vector<std::vector<Vertex>> ring(m + 1);
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i < n; ++i) {
      const double radius = std::pow(outer, double(j) / m), angle = 2 * CGAL_PI * (i + 0.5 * (j % 2)) / n;
      ring[j].push_back(mesh.add_vertex(Point_3(radius * std::cos(angle), radius * std::sin(angle), 0)));
    }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const Vertex a = ring[j][i], b = ring[j][(i + 1) % n], c = ring[j + 1][(i + 1) % n], d = ring[j + 1][i];
      if (j % 2 == 0) {
        mesh.add_face(a, d, b);
        mesh.add_face(b, d, c);
      }
      else {
        mesh.add_face(a, d, c);
        mesh.add_face(a, c, b);
      }
    }
  return mesh;
}

/// Opens an edge: it becomes two edges with the same ends, and a curve of the border between them.
inline void open_edge(const Mesh::Halfedge_index h, Mesh& mesh)
{
  const Mesh::Halfedge_index inner = mesh.opposite(h), added = mesh.add_edge(mesh.source(h), mesh.target(h));
  const Mesh::Halfedge_index of_face = mesh.opposite(added);
  mesh.set_face(of_face, mesh.face(inner));
  mesh.set_halfedge(mesh.face(inner), of_face);
  mesh.set_next(mesh.prev(inner), of_face);
  mesh.set_next(of_face, mesh.next(inner));
  for (const Mesh::Halfedge_index border : {inner, added}) {
    mesh.set_face(border, Mesh::null_face());
    mesh.set_halfedge(mesh.target(border), border);
    mesh.set_next(border, border == inner ? added : inner);
  }
}

} // namespace open_meshes

#endif // T_SPLINES_TEST_OPEN_MESHES_H
