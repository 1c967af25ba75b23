// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SIMILARITY_MAP_ISOLINE_EDGES_H
#define T_SPLINES_TEST_SIMILARITY_MAP_ISOLINE_EDGES_H

#include "Similarity_map/chart_maps.h"

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>

/// Edges of maps that are to lie on isolines.
namespace isoline_edges {

using Edges = std::set<std::pair<int, int>>; ///< ends, ascending

inline std::pair<int, int> edge(const int a, const int b)
{
  return std::minmax(a, b);
}

/// The edges that lie on isolines. \param is_marked which of them: called with their ends and the axis across
inline Edges of(const Plain_map& map, const std::function<bool(int, int, int)>& is_marked)
{
  Edges result, seen;
  for (std::size_t t = 0; t < map.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = map.triangles[t][i], b = map.triangles[t][(i + 1) % 3];
      if (!seen.insert(edge(a, b)).second)
        continue;
      for (int axis = 0; axis < 2; ++axis)
        if (map.uv[t][i][axis] == map.uv[t][(i + 1) % 3][axis] && is_marked(a, b, axis))
          result.insert(edge(a, b));
    }
  return result;
}

/// Part of the edges on isolines, at random; so that arcs begin, end, meet and cross in all ways.
inline Edges at_random(const Plain_map& map, const double share, CGAL::Random& random)
{
  return of(map, [&](int, int, int) { return random.get_double() < share; });
}

/// Gives triangles charts of their own: the cut then runs everywhere.
inline void scatter_charts(chart_maps::Chart_map& map, const int number, CGAL::Random& random)
{
  std::map<std::pair<int, int>, int> chart;
  for (int& c : map.chart)
    c = chart.emplace(std::make_pair(c, random.get_int(0, number)), static_cast<int>(chart.size())).first->second;
  map.number_of_charts = static_cast<int>(chart.size());
}

/// A torus of m x n squares; vertex n * i + j has the place (i, j).
inline chart_maps::Chart_map flat_torus(const int m, const int n)
{
  chart_maps::Chart_map map = chart_maps::hopf_torus(2, m, n);
  const auto place = [](const int i, const int j) { return std::array<double, 2>{{double(i), double(j)}}; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const std::size_t t = 2 * static_cast<std::size_t>(i * n + j);
      map.uv[t] = {{place(i, j), place(i + 1, j), place(i + 1, j + 1)}};
      map.uv[t + 1] = {{place(i, j), place(i + 1, j + 1), place(i, j + 1)}};
    }
  return map;
}

/// The same whose last row is glued with a shift by one column.
inline chart_maps::Chart_map twisted_torus(const int m, const int n)
{
  chart_maps::Chart_map map = flat_torus(m, n);
  for (int i = 0; i < m; ++i)
    for (const int t : {2 * (i * n + n - 1), 2 * (i * n + n - 1) + 1})
      for (int& v : map.triangles[t])
        if (v % n == 0)
          v = (v + n) % (m * n);
  return map;
}

/// Half a ring closed by a similarity: of its isolines two border lines and the one between them are closed.
inline chart_maps::Chart_map half_ring(const double scale, const int m, const int n)
{
  const double pi = 4 * std::atan(1.);
  return chart_maps::grid(
      m, n, true, [](int, int) { return false; },
      [=](const int i, const int j) {
        const double r = std::pow(scale, double(i) / m), angle = pi * j / n;
        return std::array<double, 2>{{0.3 + r * std::cos(angle), 0.7 + r * std::sin(angle)}};
      });
}

/// The column of a vertex of a periodic grid of `m` squares around.
inline int column(const Plain_mesh& cylinder, const int v, const int m)
{
  const double turns = std::atan2(cylinder.points[v][1], cylinder.points[v][0]) / (8 * std::atan(1.));
  return (static_cast<int>(std::round(m * turns)) + m) % m;
}

} // namespace isoline_edges

#endif // T_SPLINES_TEST_SIMILARITY_MAP_ISOLINE_EDGES_H
