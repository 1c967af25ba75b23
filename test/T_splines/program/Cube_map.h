// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_PROGRAM_CUBE_MAP_H
#define T_SPLINES_TEST_PROGRAM_CUBE_MAP_H

#include <array>
#include <cstddef>
#include <fstream>
#include <map>
#include <string>
#include <vector>

/// The map of the unit cube by its six sides: each is a chart, the unit square, of n times n squares of two triangles.
struct Cube_map {
  struct Corner {
    std::size_t vertex;
    double u, v;
    bool has_uv;
  };

  std::vector<std::array<double, 3>> points;
  std::vector<Corner> corners; ///< three per triangle
  bool uv_is_missing = false;

  explicit Cube_map(const int n) : m_corners_per_chart(6 * static_cast<std::size_t>(n * n))
  {
    for (int side = 0; side < 6; ++side)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          for (const auto& [di, dj] : {std::array<int, 2>{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
            corners.push_back({vertex(side, i + di, j + dj, n), double(i + di) / n, double(j + dj) / n, true});
  }

  /// Changes the coordinates of one side.
  template <typename Change>
  void change_chart(const std::size_t side, const Change& change)
  {
    for (std::size_t c = side * m_corners_per_chart; c < (side + 1) * m_corners_per_chart && c < corners.size(); ++c)
      change(corners[c].u, corners[c].v);
  }

  /// writes the map as an OBJ file.
  void write(const std::string& name) const
  {
    std::ofstream file(name);
    file.precision(17);
    for (const std::array<double, 3>& p : points)
      file << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
    for (const Corner& corner : corners)
      file << "vt " << corner.u << " " << corner.v << "\n";
    for (std::size_t c = 0; c < corners.size(); ++c) {
      file << (c % 3 == 0 ? "f " : " ") << corners[c].vertex + 1;
      if (corners[c].has_uv && !uv_is_missing)
        file << "/" << c + 1;
      file << (c % 3 == 2 ? "\n" : "");
    }
  }

private:
  /// The vertex at (i, j) on a side. Sides 0 to 2 are opposite to 3 to 5; seen from outside, u and v are counter-
  /// clockwise.
  std::size_t vertex(const int side, const int i, const int j, const int n)
  {
    const std::size_t axis = static_cast<std::size_t>(side % 3);
    std::array<int, 3> place;
    place[axis] = side < 3 ? 0 : n;
    place[(axis + 1) % 3] = side < 3 ? j : i;
    place[(axis + 2) % 3] = side < 3 ? i : j;
    const auto [position, is_new] = m_vertices.emplace(place, points.size());
    if (is_new)
      points.push_back({double(place[0]) / n, double(place[1]) / n, double(place[2]) / n});
    return position->second;
  }

  std::size_t m_corners_per_chart;
  std::map<std::array<int, 3>, std::size_t> m_vertices;
};

#endif // T_SPLINES_TEST_PROGRAM_CUBE_MAP_H
