// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_FUZZ_SHAPES_H
#define T_SPLINES_BENCHMARK_FUZZ_SHAPES_H

#include "Random.h"
#include "Triangles.h"
#include "extrude.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace fuzz {

constexpr double pi = 3.141592653589793;

/// A surface of the kind of a box: divisions of its sides, diagonals at random.
inline Triangles make_box(const std::array<double, 3>& size, const std::array<int, 3>& divisions, Random& random)
{
  Triangles mesh;
  std::map<std::array<int, 3>, std::size_t> corners;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = corners.try_emplace(at, mesh.points.size());
    if (is_new)
      mesh.add_point(size[0] * at[0] / divisions[0], size[1] * at[1] / divisions[1], size[2] * at[2] / divisions[2]);
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool is_far : {false, true})
      for (int i = 0; i < divisions[u]; ++i)
        for (int j = 0; j < divisions[v]; ++j) {
          std::array<int, 3> at{};
          at[axis] = is_far ? divisions[axis] : 0;
          const auto grid = [&](const int di, const int dj) {
            at[u] = i + di;
            at[v] = j + dj;
            return corner(at);
          };
          const std::size_t a = grid(0, 0), b = grid(1, 0), c = grid(1, 1), d = grid(0, 1);
          mesh.add_quadrilateral(a, is_far ? b : d, c, is_far ? d : b, random.chance(0.5));
        }
  }
  return mesh;
}

inline std::array<int, 3> divisions(Random& random, const int most)
{
  if (random.chance(0.4))
    return {1, 1, 1};
  const int x = random.integer(1, most), y = random.integer(1, most), z = random.integer(1, most);
  return {x, y, z};
}

inline Triangles box(Random& random)
{
  const double y = random.log_uniform(0.05, 1), z = random.log_uniform(0.05, 1);
  return make_box({1, y, z}, divisions(random, 12), random);
}

/// A box from ten to a thousand times as wide as it is thick.
inline Triangles plate(Random& random)
{
  const double y = random.log_uniform(0.2, 1), z = random.log_uniform(1e-3, 1e-1);
  std::array<int, 3> n = divisions(random, 12);
  n[2] = 1;
  return make_box({1, y, z}, n, random);
}

/// A polygon with corners on a circle, at equal distances or not, or a star.
inline Outline polygon(const int sides, const double radius, const double inner_radius, const double unevenness,
                       Random& random)
{
  Outline outline;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * (i + unevenness * random.uniform(-0.45, 0.45)) / sides;
    const double r = i % 2 == 0 ? radius : inner_radius;
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return outline;
}

inline Triangles prism(Random& random)
{
  const bool is_star = random.chance(0.3);
  const int sides = is_star ? 2 * random.integer(3, 12) : random.integer(3, 12);
  const double inner = is_star ? random.uniform(0.3, 0.9) : 1, unevenness = random.chance(0.5) ? random.unit() : 0;
  const double height = random.log_uniform(0.02, 10);
  return extrude({polygon(sides, 1, inner, unevenness, random)}, height, 0, random);
}

/// How a circle of corners is closed.
enum class Cap { FAN_AROUND_CENTRE, FAN_FROM_CORNER, STRIP };

inline void close_circle(Triangles& mesh, const std::size_t first, const std::size_t n, const Cap cap,
                         const Point& centre, const bool faces_up)
{
  const auto add = [&](const std::size_t a, const std::size_t b, const std::size_t c) {
    mesh.add_triangle(a, faces_up ? b : c, faces_up ? c : b);
  };
  if (cap == Cap::FAN_AROUND_CENTRE) {
    const std::size_t middle = mesh.add_point(centre.x(), centre.y(), centre.z());
    for (std::size_t i = 0; i < n; ++i)
      add(middle, first + i, first + (i + 1) % n);
  }
  else if (cap == Cap::FAN_FROM_CORNER) {
    for (std::size_t i = 1; i + 1 < n; ++i)
      add(first, first + i, first + i + 1);
  }
  else {
    std::size_t low = 0, high = n - 1;
    for (bool is_low = true; low + 1 < high; is_low = !is_low) {
      const std::size_t next = is_low ? low + 1 : high - 1;
      add(first + low, first + next, first + high);
      (is_low ? low : high) = next;
    }
  }
}

/// The surface that a polyline turns about the z axis makes, from its lower to its upper end; fans close the ends.
inline Triangles turn_about_axis(const std::vector<std::pair<double, double>>& radius_and_height, const std::size_t n,
                                 const Cap lower, const Cap upper, Random& random)
{
  Triangles mesh;
  for (const auto& [r, z] : radius_and_height)
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
      mesh.add_point(r * std::cos(angle), r * std::sin(angle), z);
    }
  const bool is_regular = random.chance(0.5);
  const std::size_t rings = radius_and_height.size();
  for (std::size_t k = 0; k + 1 < rings; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = k * n + i, b = k * n + (i + 1) % n;
      mesh.add_quadrilateral(a, b, b + n, a + n, is_regular || random.chance(0.5));
    }
  close_circle(mesh, 0, n, lower, Point(0, 0, radius_and_height.front().second), false);
  close_circle(mesh, (rings - 1) * n, n, upper, Point(0, 0, radius_and_height.back().second), true);
  return mesh;
}

inline Cap random_cap(Random& random)
{
  return static_cast<Cap>(random.integer(0, 2));
}

/// A disc, a cylinder, a frustum, or a stepped shaft.
inline Triangles cylinder(Random& random)
{
  const auto n = static_cast<std::size_t>(random.log_uniform(6, 200));
  std::vector<std::pair<double, double>> profile;
  if (random.chance(0.3)) {
    double z = 0, r = random.uniform(0.3, 1);
    for (int steps = random.integer(2, 4); steps > 0; --steps) {
      profile.emplace_back(r, z);
      z += random.uniform(0.1, 1);
      profile.emplace_back(r, z);
      r *= random.chance(0.5) ? random.uniform(0.3, 0.8) : random.uniform(1.2, 2);
    }
  }
  else {
    const double height = random.log_uniform(0.01, 20), top = random.chance(0.3) ? random.uniform(0.2, 1) : 1;
    const int rings = random.chance(0.5) ? 1 : random.integer(2, 10);
    for (int i = 0; i <= rings; ++i)
      profile.emplace_back(1 + (top - 1) * i / rings, height * i / rings);
  }
  const Cap lower = random_cap(random), upper = random_cap(random);
  return turn_about_axis(profile, n, lower, upper, random);
}

inline Triangles torus(Random& random)
{
  const auto n = static_cast<std::size_t>(random.log_uniform(5, 80)),
             m = static_cast<std::size_t>(random.log_uniform(4, 40));
  const double minor = random.log_uniform(0.05, 0.8), flatness = random.chance(0.5) ? 1 : random.log_uniform(0.2, 3);
  const double twist = random.chance(0.3) ? random.integer(1, 3) : 0;
  Triangles mesh;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
      const double b = 2 * pi * static_cast<double>(j) / static_cast<double>(m) + twist * a;
      const double r = 1 + minor * std::cos(b);
      mesh.add_point(r * std::cos(a), r * std::sin(a), flatness * minor * std::sin(b));
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const std::size_t k = (i + 1) % n, l = (j + 1) % m;
      mesh.add_quadrilateral(i * m + j, k * m + j, k * m + l, i * m + l, random.chance(0.5));
    }
  return mesh;
}

/// An L, T, U or plus profile, extruded, with corners on the sides of one end that make needles.
inline Triangles profile(Random& random)
{
  const double w = random.uniform(0.05, 0.35), h = random.uniform(0.4, 1), c = random.uniform(w, 0.9 - w);
  Outline outline;
  switch (random.integer(0, 3)) {
  case 0: outline = {{0, 0}, {1, 0}, {1, w}, {w, w}, {w, h}, {0, h}}; break;
  case 1: outline = {{c, 0}, {c + w, 0}, {c + w, h}, {1, h}, {1, h + w}, {0, h + w}, {0, h}, {c, h}}; break;
  case 2: outline = {{0, 0}, {1, 0}, {1, h}, {1 - w, h}, {1 - w, w}, {w, w}, {w, h}, {0, h}}; break;
  default:
    outline = {{c, 0},         {c + w, 0}, {c + w, 0.3}, {1, 0.3},     {1, 0.3 + w}, {c + w, 0.3 + w},
               {c + w, h + w}, {c, h + w}, {c, 0.3 + w}, {0, 0.3 + w}, {0, 0.3},     {c, 0.3}};
  }
  const double height = random.log_uniform(0.05, 5), points_on_sides = random.chance(0.7) ? random.unit() : 0;
  return extrude({outline}, height, points_on_sides, random);
}

/// A plate with square and round holes.
inline Triangles holed_plate(Random& random)
{
  const int columns = random.integer(1, 3), rows = random.integer(1, 2);
  const double x = columns, y = rows, height = random.log_uniform(0.02, 1) * columns;
  Region region{{{0, 0}, {x, 0}, {x, y}, {0, y}}};
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      if (region.size() > 1 && random.chance(0.25))
        continue;
      const bool is_square = random.chance(0.4);
      const double r = random.uniform(0.1, 0.4);
      const int sides = is_square ? 4 : static_cast<int>(random.log_uniform(8, 64));
      const double turned = is_square ? pi / 4 : 0;
      Outline hole;
      for (int k = 0; k < sides; ++k)
        hole.emplace_back(i + 0.5 + r * std::cos(turned - 2 * pi * k / sides),
                          j + 0.5 + r * std::sin(turned - 2 * pi * k / sides));
      region.push_back(hole);
    }
  const double points_on_sides = random.chance(0.3) ? random.unit() : 0;
  return extrude(region, height, points_on_sides, random);
}

/// A sphere of meridians and parallels, or an ellipsoid.
inline Triangles sphere(Random& random)
{
  const auto n = static_cast<std::size_t>(random.log_uniform(4, 80));
  const int rings = static_cast<int>(random.log_uniform(2, 50));
  const double y = random.chance(0.5) ? 1 : random.log_uniform(0.1, 1), z = random.log_uniform(0.1, 2);
  std::vector<std::pair<double, double>> meridian;
  for (int i = 1; i <= rings; ++i)
    meridian.emplace_back(std::sin(pi * i / (rings + 1)), -std::cos(pi * i / (rings + 1)));
  Triangles mesh = turn_about_axis(meridian, n, Cap::FAN_AROUND_CENTRE, Cap::FAN_AROUND_CENTRE, random);
  mesh.points[mesh.points.size() - 2] = Point(0, 0, -1);
  mesh.points.back() = Point(0, 0, 1);
  for (Point& p : mesh.points)
    p = Point(p.x(), y * p.y(), z * p.z());
  return mesh;
}

/// A sphere made of an octahedron, with a few bumps and dents.
inline Triangles blob(Random& random)
{
  Triangles mesh;
  for (const double s : {1., -1.}) {
    mesh.add_point(s, 0, 0);
    mesh.add_point(0, s, 0);
    mesh.add_point(0, 0, s);
  }
  mesh.faces = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int n = random.integer(2, 5); n > 0; --n)
    subdivide(mesh);
  struct Bump {
    Vector direction;
    double height, width;
  };
  std::vector<Bump> bumps(static_cast<std::size_t>(random.integer(1, 8)));
  for (Bump& bump : bumps) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    bump = {Vector(r * std::cos(angle), r * std::sin(angle), z), random.uniform(-0.5, 1), random.uniform(0.2, 0.8)};
  }
  for (Point& p : mesh.points) {
    Vector v = p - CGAL::ORIGIN;
    v = v / std::sqrt(v.squared_length());
    double r = 1;
    for (const Bump& bump : bumps)
      r += bump.height * std::exp(-(v - bump.direction).squared_length() / (bump.width * bump.width));
    p = CGAL::ORIGIN + std::max(r, 0.2) * v;
  }
  return mesh;
}

/// Cubes side by side, grown at random; the surface need not be a manifold.
inline Triangles blocks(Random& random)
{
  using Cell = std::array<int, 3>;
  std::vector<Cell> cells{{0, 0, 0}};
  std::set<Cell> all{cells[0]};
  const auto neighbour = [](Cell cell, const std::size_t axis, const int step) {
    cell[axis] += step;
    return cell;
  };
  for (const int size = random.integer(2, 12); static_cast<int>(cells.size()) < size;) {
    const Cell from = cells[static_cast<std::size_t>(random.integer(0, static_cast<int>(cells.size()) - 1))];
    const auto axis = static_cast<std::size_t>(random.integer(0, 2));
    const Cell cell = neighbour(from, axis, random.chance(0.5) ? 1 : -1);
    if (all.insert(cell).second)
      cells.push_back(cell);
  }
  const double y = random.log_uniform(0.2, 1), z = random.log_uniform(0.2, 1);
  Triangles mesh;
  std::map<Cell, std::size_t> corners;
  const auto corner = [&](const Cell& at) {
    const auto [place, is_new] = corners.try_emplace(at, mesh.points.size());
    if (is_new)
      mesh.add_point(at[0], y * at[1], z * at[2]);
    return place->second;
  };
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        if (all.count(neighbour(cell, axis, 2 * side - 1)) != 0)
          continue;
        const Cell a = neighbour(cell, axis, side), b = neighbour(a, (axis + 1) % 3, 1);
        const Cell c = neighbour(b, (axis + 2) % 3, 1), d = neighbour(a, (axis + 2) % 3, 1);
        mesh.add_quadrilateral(corner(a), corner(side == 1 ? b : d), corner(c), corner(side == 1 ? d : b),
                               random.chance(0.5));
      }
  return mesh;
}

} // namespace fuzz

#endif // T_SPLINES_BENCHMARK_FUZZ_SHAPES_H
