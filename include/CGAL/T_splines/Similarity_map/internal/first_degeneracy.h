// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIRST_DEGENERACY_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIRST_DEGENERACY_H

#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The indicator (9) of [CZ17] for one edge of a triangle while the metric moves: side `a` of a triangle with the
/// log-lengths `l`, which change at the rates `rate`. It has the sign of b + c - a, and at most two roots.
struct Degeneracy_indicator {
  std::array<double, 3> l, rate; // side a first

  double operator()(const double time) const
  {
    const double a = l[0] + time * rate[0], b = l[1] + time * rate[1], c = l[2] + time * rate[2];
    return std::exp(b - a) + std::exp(c - a) - 1.;
  }

  /// The root in (0, end). \pre positive at 0 and negative at `end`: there is exactly one.
  double root(const double end) const
  {
    double low = 0., high = end;
    for (int i = 0; i < 200 && low < high; ++i) {
      const double middle = low + (high - low) / 2;
      if (middle <= low || middle >= high)
        break;
      ((*this)(middle) > 0 ? low : high) = middle;
    }
    return low;
  }
};

/// The time at which the first triangle degenerates while the form moves to `form + time * step`.
template <typename FT>
struct First_degeneracy {
  using Index = Triangulation_connectivity::Index;

  double time = 1.; ///< in [0, 1]
  std::vector<Index>
      triangles; ///< halfedges of the faces that degenerate then, opposite to their vanishing height: the longest sides

  /// \param step change of xi at the halfedge 2e, per edge e
  First_degeneracy(const Similarity_structure<FT>& structure, const std::vector<double>& step)
  {
    const Triangulation_connectivity& mesh = structure.mesh;
    const auto step_of = [&](const Index h) { return is_along_edge(h) ? step[edge_of(h)] : -step[edge_of(h)]; };
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      const Index h = mesh.halfedge_of_face(f), j = mesh.next(h), k = mesh.next(j);
      const std::array<FT, 3> log_length = structure.triangle_log_lengths(h);
      const std::array<double, 3> l = {double(log_length[0]), double(log_length[1]), double(log_length[2])};
      const double xi_h = step_of(h), xi_j = step_of(j), xi_k = step_of(k);
      const std::array<double, 3> rate = {(xi_k - xi_j) / 6, (xi_h - xi_k) / 6, (xi_j - xi_h) / 6};
      const std::array<Index, 3> sides = {h, j, k};
      for (int i = 0; i < 3; ++i) {
        const int b = (i + 1) % 3, c = (i + 2) % 3;
        consider({{l[i], l[b], l[c]}, {rate[i], rate[b], rate[c]}}, sides[i]);
      }
    }
  }

private:
  void consider(const Degeneracy_indicator& indicator, const Index side)
  {
    if (indicator(time) > 0)
      return;
    const double root = indicator(0.) > 0 ? indicator.root(time) : 0.;
    if (root < time)
      triangles.clear();
    time = std::min(time, root);
    triangles.push_back(side);
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIRST_DEGENERACY_H
