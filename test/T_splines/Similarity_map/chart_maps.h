// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SIMILARITY_MAP_CHART_MAPS_H
#define T_SPLINES_TEST_SIMILARITY_MAP_CHART_MAPS_H

#include "Plain_map.h"
#include "test_meshes.h"

#include <CGAL/Random.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// Seamless maps made of charts, in code.
namespace chart_maps {

/// A map with the number of the chart of each triangle.
struct Chart_map : Plain_map {
  std::vector<int> chart;
  int number_of_charts = 0;

  /// Changes the corners of the triangles of one chart.
  void transform(const int c, const std::function<std::array<double, 2>(double, double)>& f)
  {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (chart[t] == c)
        for (auto& p : uv[t])
          p = f(p[0], p[1]);
  }

  void transform_all(const std::function<std::array<double, 2>(double, double)>& f)
  {
    for (int c = 0; c < number_of_charts; ++c)
      transform(c, f);
  }
};

/// A surface of axis-parallel squares whose charts are its planes: rotations, scale factors 1.
/// \pre adjacent triangles in one plane look the same way
inline Chart_map planes_as_charts(const Plain_mesh& mesh, const int n)
{
  Chart_map map;
  static_cast<Plain_mesh&>(map) = mesh;
  std::map<std::array<int, 3>, int> number; // by axis, side and position
  for (const auto& t : mesh.triangles) {
    std::array<std::array<double, 3>, 3> p;
    for (int i = 0; i < 3; ++i)
      p[i] = mesh.points[t[i]];
    int axis = 0;
    while (p[0][axis] != p[1][axis] || p[0][axis] != p[2][axis])
      ++axis;
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    const double area = (p[1][first] - p[0][first]) * (p[2][second] - p[0][second]) -
                        (p[1][second] - p[0][second]) * (p[2][first] - p[0][first]);
    const int u = area > 0 ? first : second, v = area > 0 ? second : first;
    map.uv.emplace_back();
    for (int i = 0; i < 3; ++i)
      map.uv.back()[i] = {{std::round(p[i][u] * n), std::round(p[i][v] * n)}};
    const std::array<int, 3> key = {{axis, area > 0 ? 1 : 0, static_cast<int>(std::round(p[0][axis] * n))}};
    map.chart.push_back(number.emplace(key, static_cast<int>(number.size())).first->second);
  }
  map.number_of_charts = static_cast<int>(number.size());
  return map;
}

/// Gives each chart a frame of its own: turned by quarter turns and moved; and scaled, if `is_scaled`. With corners in
/// doubles the map is then seamless up to round-off only.
inline void change_frames(Chart_map& map, const bool is_scaled, CGAL::Random& random)
{
  for (int c = 0; c < map.number_of_charts; ++c) {
    const double scale = is_scaled ? std::exp(random.get_double(-2, 2)) : 1;
    const double cosine[] = {1, 0, -1, 0}, u = random.get_double(-9, 9), v = random.get_double(-9, 9);
    const int r = random.get_int(0, 4);
    const double a = scale * cosine[r], b = scale * cosine[(r + 3) % 4];
    map.transform(c, [&](const double x, const double y) {
      return std::array<double, 2>{{a * x - b * y + u, b * x + a * y + v}};
    });
  }
}

/// A grid of m x n squares, two triangles each, without those that `is_hole` names; the vertex (i, j) has the place
/// `uv(i, j)`. If `is_periodic`, the right side is glued to the left side.
inline Chart_map grid(const int m, const int n, const bool is_periodic, const std::function<bool(int, int)>& is_hole,
                      const std::function<std::array<double, 2>(int, int)>& uv)
{
  Chart_map map;
  std::map<std::pair<int, int>, int> number;
  const auto vertex = [&](const int i, const int j) {
    const int column = is_periodic ? i % m : i;
    const auto inserted = number.emplace(std::make_pair(column, j), static_cast<int>(number.size()));
    if (inserted.second) {
      const double angle = is_periodic ? 8 * std::atan(1.) * column / m : 0;
      if (is_periodic)
        map.points.push_back({{std::cos(angle), std::sin(angle), double(j)}});
      else
        map.points.push_back({{double(i), double(j), 0}});
    }
    return inserted.first->second;
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      if (is_hole(i, j))
        continue;
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      map.triangles.push_back({{a, b, c}});
      map.uv.push_back({{uv(i, j), uv(i + 1, j), uv(i + 1, j + 1)}});
      map.triangles.push_back({{a, c, d}});
      map.uv.push_back({{uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)}});
    }
  map.chart.assign(map.triangles.size(), 0);
  map.number_of_charts = 1;
  return map;
}

/// A cylinder of twice `m` squares around and two rows whose lower border is pinched into two cylinders of `m` squares
/// around: three straight borders and one cone of angle 4 pi, each edge of the map 1/7 long. \pre m > 2
inline Chart_map trousers(const int m)
{
  Chart_map map;
  std::map<std::array<int, 3>, int> number; // part, column, row
  const auto vertex = [&](const int part, const int i, const int j) {
    const int around = part == 0 ? i % (2 * m) : i % m;
    std::array<int, 3> key = {{part, around, j}};
    if (j == 0) // the waist belongs to the upper part; its two points 0 and m are one
      key = {{0, i % m == 0 ? 0 : i, 0}};
    const auto inserted = number.emplace(key, static_cast<int>(number.size()));
    if (inserted.second)
      map.points.push_back({{double(key[0]), double(key[1]), double(key[2])}});
    return inserted.first->second;
  };
  const auto uv = [](const int i, const int j) { return std::array<double, 2>{{i / 7., j / 7.}}; };
  for (int i = 0; i < 2 * m; ++i)
    for (int j = -2; j < 2; ++j) {
      const int part = j >= 0 ? 0 : 1 + i / m;
      const int a = vertex(part, i, j), b = vertex(part, i + 1, j), c = vertex(part, i + 1, j + 1),
                d = vertex(part, i, j + 1);
      map.triangles.push_back({{a, b, c}});
      map.uv.push_back({{uv(i, j), uv(i + 1, j), uv(i + 1, j + 1)}});
      map.triangles.push_back({{a, c, d}});
      map.uv.push_back({{uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)}});
      map.chart.insert(map.chart.end(), 2, part);
    }
  map.number_of_charts = 3;
  return map;
}

/// Two half rings, each closed by a similarity with its own factor and between the halves of the first axis through
/// its center, glued along one edge: borders with the factors a, b, and one with their quotient.
inline Chart_map two_half_rings(const double a, const double b)
{
  const double pi = 4 * std::atan(1.);
  const int m = 6, n = 9;
  const auto half_ring = [=](const double scale, const double from, const double u, const double v) {
    return grid(
        m, n, true, [](int, int) { return false; },
        [=](const int i, const int j) {
          const double r = std::pow(scale, double(i) / m), angle = from + pi * j / n;
          return std::array<double, 2>{{u + r * std::cos(angle), v + r * std::sin(angle)}};
        });
  };
  Chart_map map = half_ring(a, 0, 0.3, 0.7);
  const Chart_map other = half_ring(b, pi, -0.1, 0.37);
  const std::size_t square = 2 * ((n - 1) * m + 2); // the third of the last row, and of the first row of the other
  std::map<int, int> number = {{other.triangles[4][0], map.triangles[square + 1][2]},
                               {other.triangles[4][1], map.triangles[square][2]}};
  for (int v = 0; v < static_cast<int>(other.points.size()); ++v)
    if (number.emplace(v, static_cast<int>(map.points.size())).second)
      map.points.push_back({{other.points[v][0], other.points[v][1], other.points[v][2] + n}});
  for (const auto& t : other.triangles)
    map.triangles.push_back({{number[t[0]], number[t[1]], number[t[2]]}});
  map.uv.insert(map.uv.end(), other.uv.begin(), other.uv.end());
  map.chart.resize(map.triangles.size(), 1);
  map.number_of_charts = 2;
  return map;
}

/// The plane without the origin modulo z -> s z: m vertices around the origin, n rings. Its only seam is a circle.
inline Chart_map hopf_torus(const double s, const int m, const int n)
{
  Chart_map map;
  const double turn = 8 * std::atan(1.);
  static_cast<Plain_mesh&>(map) = test_meshes::torus(m, n); // vertex n * i + j: i around the origin, j outwards
  const auto place = [&](const int i, const int j) {
    const std::complex<double> z = std::polar(std::pow(s, double(j % n) / n), turn * (i % m) / m) * (j == n ? s : 1.);
    return std::array<double, 2>{{z.real(), -z.imag()}};
  };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      map.uv.push_back({{place(i, j), place(i + 1, j), place(i + 1, j + 1)}});
      map.uv.push_back({{place(i, j), place(i + 1, j + 1), place(i, j + 1)}});
    }
  map.chart.assign(map.triangles.size(), 0);
  map.number_of_charts = 1;
  return map;
}

/// Adds to each coordinate of each vertex in each chart its own random number in [-size, size].
inline void add_noise(Chart_map& map, const double size, CGAL::Random& random)
{
  if (size == 0)
    return;
  std::map<std::pair<std::array<double, 2>, std::pair<int, int>>, std::array<double, 2>> moved;
  for (std::size_t t = 0; t < map.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto key = std::make_pair(map.uv[t][i], std::make_pair(map.triangles[t][i], map.chart[t]));
      auto found = moved.find(key);
      if (found == moved.end()) {
        const double du = random.get_double(-size, size), dv = random.get_double(-size, size);
        found = moved.emplace(key, std::array<double, 2>{{key.first[0] + du, key.first[1] + dv}}).first;
      }
      map.uv[t][i] = found->second;
    }
}

} // namespace chart_maps

#endif // T_SPLINES_TEST_SIMILARITY_MAP_CHART_MAPS_H
