// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SPLINE_SHARP_CUBE_H
#define T_SPLINES_TEST_SPLINE_SHARP_CUBE_H

#include "Spline/Spline_mesh.h"

#include <catch2/catch.hpp>

namespace spline_tests {

// Makes all edges of a T-mesh `test_t_meshes::cube()` creases, and of its control points the corners of the unit cube.
template <typename Mesh>
void make_sharp_cube(Mesh& t)
{
  using Number = typename Mesh::Number;
  using Point = typename Mesh::Point_3;
  for (const auto e : edges(t.mesh))
    put(t.creases(), e, true);
  const auto report = t.make_spline_compatible();
  INFO(message(report.status));
  REQUIRE(report);
  REQUIRE(report.vertices_after == 8);
  const int x[] = {0, 0, 1, 1}, y[] = {0, 1, 1, 0};
  for (int i = 0; i < 4; ++i) { // face 0 is the bottom, seen from below
    const auto h = t.halfedge_of(0, i), o = opposite(h, t.mesh);
    t.set_control(source(h, t.mesh), Point(x[i], y[i], 0), Number(1));
    t.set_control(target(next(o, t.mesh), t.mesh), Point(x[i], y[i], 1), Number(1)); // above it
  }
}

} // namespace spline_tests

#endif // T_SPLINES_TEST_SPLINE_SHARP_CUBE_H
