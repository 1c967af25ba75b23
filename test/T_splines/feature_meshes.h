// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_FEATURE_MESHES_H
#define T_SPLINES_TEST_FEATURE_MESHES_H

#include "Cross_field/test_meshes.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// Meshes with sharp edges, made in code.
namespace feature_meshes {

using Mesh = test::Surface_mesh;
using Point_3 = test::Point_3;

/// A cube with edges of length 1, each in n parts.
inline Mesh cube(const int n)
{
  return test::to_mesh<Mesh>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, n));
}

/// An L of a plate of 5 x 3 unit cubes and a wall of three more layers, with a hole through the plate: genus 1.
inline Mesh bracket_with_hole(const int n)
{
  return test::to_mesh<Mesh>(test::cubes(
      [](const int x, const int y, const int z) {
        if (x < 0 || x > 4 || y < 0 || y > 2 || z < 0 || z > 3)
          return false;
        return z == 0 ? !(x == 3 && y == 1) : x == 0;
      },
      5, n));
}

/// A point of a profile in a plane through the z-axis.
struct Profile_point {
  double radius, height;
};

/// A profile from the axis to the axis, turned around it in `sides` steps. `radius_factor(i)` is that of step i.
template <typename RadiusFactor>
Mesh revolved(const int sides, const std::vector<Profile_point>& profile, const RadiusFactor& radius_factor)
{
  test::Soup soup;
  const std::size_t n = profile.size() - 2, m = static_cast<std::size_t>(sides);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 1; j <= n; ++j) {
      const double angle = 2 * CGAL_PI * static_cast<double>(i) / sides;
      const double r = profile[j].radius * radius_factor(i, profile[j].radius);
      soup.points.emplace_back(r * std::cos(angle), r * std::sin(angle), profile[j].height);
    }
  soup.points.emplace_back(0, 0, profile.front().height);
  soup.points.emplace_back(0, 0, profile.back().height);
  const std::size_t bottom = m * n, top = bottom + 1;
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t next = (i + 1) % m;
    soup.faces.push_back({bottom, next * n, i * n});
    soup.faces.push_back({top, i * n + n - 1, next * n + n - 1});
    for (std::size_t j = 0; j + 1 < n; ++j) {
      soup.faces.push_back({i * n + j, next * n + j, next * n + j + 1});
      soup.faces.push_back({i * n + j, next * n + j + 1, i * n + j + 1});
    }
  }
  return test::to_mesh<Mesh>(soup);
}

inline Mesh revolved(const int sides, const std::vector<Profile_point>& profile)
{
  return revolved(sides, profile, [](std::size_t, double) { return 1.; });
}

/// The corners of a profile, with `n` steps on each of its sides.
inline std::vector<Profile_point> divided(const std::vector<Profile_point>& corners, const int n)
{
  std::vector<Profile_point> result(1, corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (int k = 1; k <= n; ++k) {
      const double t = static_cast<double>(k) / n;
      result.push_back({corners[i - 1].radius + t * (corners[i].radius - corners[i - 1].radius),
                        corners[i - 1].height + t * (corners[i].height - corners[i - 1].height)});
    }
  return result;
}

inline Mesh cylinder(const int sides, const int n)
{
  return revolved(sides, divided({{0, 0}, {1, 0}, {1, 2}, {0, 2}}, n));
}

inline Mesh truncated_cone(const int sides, const int n)
{
  return revolved(sides, divided({{0, 0}, {2, 0}, {1, 2}, {0, 2}}, n));
}

/// A gear with `teeth` teeth: its rim goes in and out, its sides are flat.
inline Mesh gear(const int teeth, const int n)
{
  return revolved(8 * teeth, divided({{0, 0}, {1, 0}, {1.5, 0}, {1.5, 1}, {1, 1}, {0, 1}}, n),
                  [](const std::size_t i, const double radius) {
                    const bool is_out = i % 8 < 4;
                    return radius > 1.4 && is_out ? 4. / 3 : 1.;
                  });
}

/// Whether an edge of a cube of side 1 lies on the line y = 1/2 of its top, beyond the middle: a feature that ends inside a
/// flat face.
inline bool is_dart_of_cube(const Mesh& mesh, const Mesh::Edge_index e)
{
  const Point_3 p = mesh.point(source(e, mesh)), q = mesh.point(target(e, mesh));
  return p.z() == 1 && q.z() == 1 && p.y() == 0.5 && q.y() == 0.5 && p.x() >= 0.5 && q.x() >= 0.5;
}

/// A mesh with the name that a message can have.
struct Named_mesh {
  std::string name;
  Mesh mesh;
};

/// All of them, of few and of many triangles.
inline std::vector<Named_mesh> all()
{
  std::vector<Named_mesh> result;
  for (const int n : {1, 4}) {
    const std::string suffix = " " + std::to_string(n);
    result.push_back({"cube" + suffix, cube(n)});
    result.push_back({"bracket" + suffix, bracket_with_hole(n)});
    result.push_back({"cylinder" + suffix, cylinder(16 * n, n)});
    result.push_back({"truncated cone" + suffix, truncated_cone(16 * n, n)});
    result.push_back({"gear" + suffix, gear(9, n)});
  }
  return result;
}

} // namespace feature_meshes

#endif // T_SPLINES_TEST_FEATURE_MESHES_H
