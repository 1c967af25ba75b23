// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SPLINE_TORUS_H
#define T_SPLINES_TEST_SPLINE_TORUS_H

#include "Spline/Spline_mesh.h"

#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace spline_tests {

// A round torus, nearly, with radii of about 3 and 1.
class Torus : public Spline_mesh<double> {
public:
  Torus() : Spline_mesh<double>(test_t_meshes::squares<double>(edges()))
  {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j) {
        const double a = 2 * CGAL_PI * i / m, b = 2 * CGAL_PI * j / n, r = 3 + std::cos(b);
        set_control(source(halfedge_of(n * i + j, 0), mesh), Point_3(r * std::cos(a), r * std::sin(a), std::sin(b)), 1);
      }
  }

private:
  static constexpr int m = 12, n = 8;

  static std::vector<std::vector<int>> edges()
  {
    const auto along = [](const int i, const int j) { return 2 * (n * (i % m) + j % n); };
    std::vector<std::vector<int>> result;
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j)
        result.push_back({along(i, j), along(i + 1, j) + 1, along(i, j + 1), along(i, j) + 1});
    return result;
  }
};

} // namespace spline_tests

#endif // T_SPLINES_TEST_SPLINE_TORUS_H
