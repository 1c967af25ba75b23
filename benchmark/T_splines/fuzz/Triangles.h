// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_FUZZ_TRIANGLES_H
#define T_SPLINES_BENCHMARK_FUZZ_TRIANGLES_H

#include "Random.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace fuzz {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

/// A closed surface in the making: corners, and counter-clockwise triples of their indices.
struct Triangles {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> faces;

  std::size_t add_point(const double x, const double y, const double z)
  {
    points.emplace_back(x, y, z);
    return points.size() - 1;
  }
  void add_triangle(const std::size_t a, const std::size_t b, const std::size_t c) { faces.push_back({a, b, c}); }
  /// adds the quadrilateral abcd, divided by one of its two diagonals.
  void add_quadrilateral(const std::size_t a, const std::size_t b, const std::size_t c, const std::size_t d,
                         const bool by_ac)
  {
    add_triangle(a, b, by_ac ? c : d);
    add_triangle(by_ac ? a : b, c, d);
  }
};

inline double longest_side(const Triangles& mesh)
{
  CGAL::Bbox_3 box;
  for (const Point& p : mesh.points)
    box += p.bbox();
  return std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

/// divides every triangle into four at the midpoints of its edges.
inline void subdivide(Triangles& mesh)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  const auto midpoint = [&](const std::size_t a, const std::size_t b) {
    const auto [place, is_new] = midpoints.try_emplace(std::minmax(a, b), mesh.points.size());
    if (is_new)
      mesh.points.push_back(CGAL::midpoint(mesh.points[a], mesh.points[b]));
    return place->second;
  };
  std::vector<std::array<std::size_t, 3>> faces;
  faces.reserve(4 * mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    const std::size_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.faces = std::move(faces);
}

/// moves every corner by at most `amplitude` in each coordinate.
inline void add_noise(Triangles& mesh, const double amplitude, Random& random)
{
  for (Point& p : mesh.points) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    p = p + amplitude * Vector(x, y, z);
  }
}

/// turns the mesh about the origin by a rotation of which all are equally likely, then scales and moves it.
inline void place(Triangles& mesh, const double scale, const Vector& offset, Random& random)
{
  // a random unit quaternion, by Shoemake
  constexpr double turn = 6.283185307179586;
  const double u = random.unit(), v = turn * random.unit(), w = turn * random.unit();
  const double a = std::sqrt(1 - u) * std::sin(v), b = std::sqrt(1 - u) * std::cos(v), c = std::sqrt(u) * std::sin(w),
               d = std::sqrt(u) * std::cos(w);
  const Vector rows[3] = {{1 - 2 * (b * b + c * c), 2 * (a * b - c * d), 2 * (a * c + b * d)},
                          {2 * (a * b + c * d), 1 - 2 * (a * a + c * c), 2 * (b * c - a * d)},
                          {2 * (a * c - b * d), 2 * (b * c + a * d), 1 - 2 * (a * a + b * b)}};
  for (Point& p : mesh.points) {
    const Vector q = p - CGAL::ORIGIN;
    p = CGAL::ORIGIN + (scale * Vector(rows[0] * q, rows[1] * q, rows[2] * q) + offset);
  }
}

} // namespace fuzz

#endif // T_SPLINES_BENCHMARK_FUZZ_TRIANGLES_H
