// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SIMILARITY_MAP_FLAT_TORUS_H
#define T_SPLINES_TEST_SIMILARITY_MAP_FLAT_TORUS_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/Random.h>

#include <array>
#include <cstdint>
#include <vector>

/// A flat square torus with a triangulation of straight edges and integer coordinates, so that everything about it can be decided exactly.
struct Flat_torus {
  using Number = std::int64_t;
  using Vector = std::array<Number, 2>;
  static constexpr Number cell = 1000;

  CGAL::T_splines::internal::Triangulation_connectivity mesh;
  Number period;
  std::vector<Vector> position; ///< per vertex
  std::vector<Vector> vector;   ///< per halfedge, from source to target

  /// A grid of n x n squares with a diagonal, its vertices moved at random.
  Flat_torus(const int n, CGAL::Random& random) : period(n * cell), vector(6 * n * n)
  {
    const auto vertex = [n](const int i, const int j) { return (i % n) + n * (j % n); };
    const auto halfedge = [&](const int i, const int j, const int kind) { return 2 * (3 * vertex(i, j) + kind); };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        position.push_back({{i * cell + random.get_int(-240, 241), j * cell + random.get_int(-240, 241)}});
    const auto lifted = [&](const int i, const int j) {
      return Vector{{position[vertex(i, j)][0] + (i / n) * period, position[vertex(i, j)][1] + (j / n) * period}};
    };
    mesh.m_number_of_vertices = n * n;
    mesh.m_next.resize(vector.size());
    mesh.m_target.resize(vector.size());
    mesh.m_face.resize(vector.size());
    mesh.m_face_halfedge.resize(2 * n * n);
    const std::array<std::array<int, 2>, 3> step = {{{{1, 0}}, {{0, 1}}, {{1, 1}}}};
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        for (int kind = 0; kind < 3; ++kind) {
          const int h = halfedge(i, j, kind);
          vector[h] = minus(lifted(i + step[kind][0], j + step[kind][1]), lifted(i, j));
          vector[h + 1] = minus({{0, 0}}, vector[h]);
          mesh.m_target[h] = vertex(i + step[kind][0], j + step[kind][1]);
          mesh.m_target[h + 1] = vertex(i, j);
        }
        add_face(2 * vertex(i, j), {{halfedge(i, j, 0), halfedge(i + 1, j, 1), halfedge(i, j, 2) + 1}});
        add_face(2 * vertex(i, j) + 1, {{halfedge(i, j, 2), halfedge(i, j + 1, 0) + 1, halfedge(i, j, 1) + 1}});
      }
  }

  static Vector plus(const Vector& a, const Vector& b) { return {{a[0] + b[0], a[1] + b[1]}}; }
  static Vector minus(const Vector& a, const Vector& b) { return {{a[0] - b[0], a[1] - b[1]}}; }
  static Number cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }

  /// The other diagonal of the quadrilateral around h: from the apex on the right to the apex on the left.
  Vector diagonal(const int h) const
  {
    const Vector left = plus(vector[h], vector[mesh.next(h)]); // from the source of h
    return minus(left, vector[mesh.next(h ^ 1)]);
  }

  /// Whether the two triangles at h form a strictly convex quadrilateral.
  bool is_flippable(const int h) const
  {
    const Vector d = diagonal(h), right = vector[mesh.next(h ^ 1)];
    return cross(d, minus({{0, 0}}, right)) > 0 && cross(d, minus(vector[h], right)) < 0;
  }

  /// Gives h and its opposite the vectors that they have after a flip. \pre not flipped yet
  void flip_vectors(const int h)
  {
    vector[h] = diagonal(h);
    vector[h ^ 1] = minus({{0, 0}}, vector[h]);
  }

private:
  void add_face(const int f, const std::array<int, 3>& halfedges)
  {
    mesh.m_face_halfedge[f] = halfedges[0];
    for (int k = 0; k < 3; ++k) {
      mesh.m_next[halfedges[k]] = halfedges[(k + 1) % 3];
      mesh.m_face[halfedges[k]] = f;
    }
  }
};

#endif // T_SPLINES_TEST_SIMILARITY_MAP_FLAT_TORUS_H
