// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_RANDOM_TORUS_H
#define T_SPLINES_TEST_RANDOM_TORUS_H

#include <CGAL/T_splines/Spline/T_spline.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

using Random_torus = CGAL::T_splines::T_spline<CGAL::Exact_predicates_inexact_constructions_kernel>;

/// A torus of n x n squares with random control points and weights.
inline Random_torus random_torus(const int n)
{
  using Graph = Random_torus::Graph;
  CGAL::Random random(1);
  Random_torus spline;
  Graph& graph = spline.graph();
  for (int i = 0; i < n * n; ++i) {
    const auto v = graph.add_vertex({random.get_double(), random.get_double(), random.get_double()});
    spline.weights()[v] = random.get_double(0.5, 2);
  }
  const auto at = [n](const int i, const int j) {
    return Graph::Vertex_index(static_cast<Graph::size_type>(n * (i % n) + j % n));
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      graph.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  for (const auto h : graph.halfedges()) {
    put(spline.knots(), h, 1);
    put(spline.corners(), h, true);
  }
  return spline;
}

#endif // T_SPLINES_TEST_RANDOM_TORUS_H
