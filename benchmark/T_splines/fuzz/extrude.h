// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_FUZZ_EXTRUDE_H
#define T_SPLINES_BENCHMARK_FUZZ_EXTRUDE_H

#include "Random.h"
#include "Triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace fuzz {

using Point_2 = Kernel::Point_2;
/// A closed polygon; the outer one of a region runs counter-clockwise, holes run clockwise.
using Outline = std::vector<Point_2>;
/// The outer outline first, then the holes.
using Region = std::vector<Outline>;

/// adds corners on the sides of the outline, many of them near the ends of a side, as Boolean operations leave them.
inline Outline with_points_on_sides(const Outline& outline, const double probability, Random& random)
{
  Outline result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point_2 a = outline[i], b = outline[(i + 1) % outline.size()];
    result.push_back(a);
    if (!random.chance(probability))
      continue;
    std::set<double> places;
    for (int n = random.integer(1, 4); n > 0; --n) {
      const double t = random.chance(0.5) ? random.log_uniform(1e-3, 0.5) : random.uniform(0.1, 0.9);
      places.insert(random.chance(0.5) ? t : 1 - t);
    }
    for (const double t : places)
      result.push_back(a + t * (b - a));
  }
  return result;
}

/// adds the region at height z, triangulated without further corners (constrained Delaunay).
/// \param first index of the corner that is the first one of the first outline; the others follow it in order
inline void add_cap(Triangles& mesh, const Region& region, const std::size_t first, const bool faces_up)
{
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure> triangulation;
  std::size_t index = first;
  for (const Outline& outline : region) {
    std::vector<decltype(triangulation)::Vertex_handle> corners;
    for (const Point_2& p : outline) {
      corners.push_back(triangulation.insert(p));
      corners.back()->info() = index++;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }
  // Inside is what an odd number of constraints separates from the infinite face.
  std::set<decltype(triangulation)::Face_handle> seen{triangulation.infinite_face()};
  std::vector<std::pair<decltype(triangulation)::Face_handle, bool>> stack{{triangulation.infinite_face(), false}};
  while (!stack.empty()) {
    const auto [face, is_inside] = stack.back();
    stack.pop_back();
    if (is_inside) {
      const std::size_t a = face->vertex(0)->info(), b = face->vertex(1)->info(), c = face->vertex(2)->info();
      mesh.add_triangle(a, faces_up ? b : c, faces_up ? c : b);
    }
    for (int i = 0; i < 3; ++i)
      if (seen.insert(face->neighbor(i)).second)
        stack.emplace_back(face->neighbor(i), is_inside != face->is_constrained(i));
  }
}

/// extrudes the region from z = 0 to z = height.
/// \param points_on_sides probability of further corners on a side of the upper outline; the wall below is a fan then
inline Triangles extrude(const Region& region, const double height, const double points_on_sides, Random& random)
{
  Region upper;
  for (const Outline& outline : region)
    upper.push_back(with_points_on_sides(outline, points_on_sides, random));
  Triangles mesh;
  for (const Outline& outline : region)
    for (const Point_2& p : outline)
      mesh.add_point(p.x(), p.y(), 0);
  const std::size_t upper_first = mesh.points.size();
  for (const Outline& outline : upper)
    for (const Point_2& p : outline)
      mesh.add_point(p.x(), p.y(), height);
  add_cap(mesh, region, 0, false);
  add_cap(mesh, upper, upper_first, true);
  std::size_t low = 0, high = upper_first;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const std::size_t n = region[k].size(), m = upper[k].size();
    for (std::size_t i = 0, j = 0; i < n; ++i) {
      const std::size_t a = low + i, b = low + (i + 1) % n;
      std::size_t end = j + 1;
      while (end < m && (i + 1 == n || upper[k][end] != region[k][i + 1]))
        ++end;
      if (end == j + 1) {
        mesh.add_quadrilateral(a, b, high + end % m, high + j, random.chance(0.5));
      }
      else {
        mesh.add_triangle(a, b, high + end % m);
        for (std::size_t l = end; l > j; --l)
          mesh.add_triangle(a, high + l % m, high + l - 1);
      }
      j = end;
    }
    low += n;
    high += m;
  }
  return mesh;
}

} // namespace fuzz

#endif // T_SPLINES_BENCHMARK_FUZZ_EXTRUDE_H
