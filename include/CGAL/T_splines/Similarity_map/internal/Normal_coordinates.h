// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NORMAL_COORDINATES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NORMAL_COORDINATES_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Where the edges of a *reference* triangulation run on a triangulation obtained from it by flips, in integers.
///
/// Per edge, the number of reference edges that cross it, or `shared` if it is a reference edge itself; per halfedge,
/// which reference halfedge comes first, counter-clockwise, at its source. This determines the common subdivision
/// up to isotopy (M. Gillespie, N. Sharp, K. Crane: Integer coordinates for intrinsic geometry processing, 2021). The
/// update under a flip counts the arcs in the two triangles and is exact.
class Normal_coordinates {
  using Index = Triangulation_connectivity::Index;

public:
  using Count = std::int64_t;
  static constexpr Count shared = -1;

  /// A point where a reference edge, followed from its source, leaves a triangle of the current triangulation.
  struct Crossing {
    Index halfedge; ///< by which the triangle is left
    Count position; ///< how many crossings lie before it on `halfedge`, from its source
  };

  /// A halfedge of the reference triangulation on the current one.
  struct Curve {
    Index first_corner; ///< it starts at the source of this halfedge, along it or to its left, before the next one
    Index last_corner;  ///< the same for its opposite, at its target
    std::vector<Crossing> crossings;
  };

  Normal_coordinates() = default;

  /// starts with `reference` as the current triangulation.
  explicit Normal_coordinates(const Triangulation_connectivity& reference)
    : m_count(reference.number_of_edges(), shared),
      m_first_reference(reference.number_of_halfedges()),
      m_degree(reference.number_of_vertices(), 0)
  {
    const std::vector<Index> outgoing = reference.outgoing_halfedges();
    for (Index v = 0; v < reference.number_of_vertices(); ++v) {
      const Index first = outgoing[v];
      if (first == Triangulation_connectivity::null)
        continue;
      Index h = first;
      do {
        m_first_reference[h] = m_degree[v]++;
        h = reference.next_around_source(h);
      } while (h != first);
    }
  }

  bool is_empty() const { return m_count.empty(); }

  bool is_shared(const Index edge) const { return m_count[edge] == shared; }

  /// Number of reference edges that cross `edge` in its interior.
  Count number_of_crossings(const Index edge) const { return std::max<Count>(m_count[edge], 0); }

  /// Number of all crossings.
  Count sum_of_crossings() const
  {
    Count sum = 0;
    for (const Count count : m_count)
      sum += std::max<Count>(count, 0);
    return sum;
  }

  /// Updates the coordinates for a flip of `h`. \pre `mesh` has not been flipped yet.
  class Flip {
  public:
    Flip(Normal_coordinates& coordinates, const Triangulation_connectivity& mesh, const Index h)
      : m_coordinates(coordinates),
        m_halfedge(h),
        m_count(coordinates.count_after_flip(mesh, h))
    {
    }

    /// \pre `mesh` is flipped now.
    void finish(const Triangulation_connectivity& mesh)
    {
      m_coordinates.m_count[edge_of(m_halfedge)] = m_count;
      m_coordinates.update_first_reference(mesh, m_halfedge);
      m_coordinates.update_first_reference(mesh, opposite(m_halfedge));
    }

  private:
    Normal_coordinates& m_coordinates;
    Index m_halfedge;
    Count m_count;
  };

  /// Number of reference edges that start at the source of `h` inside the triangle of `h`.
  Count number_of_starts(const Triangulation_connectivity& mesh, const Index h) const
  {
    return std::max<Count>(0, crossings(mesh.next(h)) - crossings(h) - crossings(mesh.previous(h)));
  }

  /// calls `visit(v, k, curve)` once per halfedge of the reference triangulation that is not shared, where `v` is its
  /// source and `k` its number around `v` (counter-clockwise from `reference.outgoing_halfedges()[v]`), and
  /// `shared_visit(v, k, h)` once per halfedge `h` of the current triangulation that is. \param is_wanted called with a
  /// halfedge: whether those that start in its triangle, at its source, are visited
  template <typename Visitor, typename SharedVisitor, typename IsWanted>
  void for_each_reference_halfedge(const Triangulation_connectivity& mesh, Visitor&& visit,
                                   SharedVisitor&& visit_shared, const IsWanted& is_wanted) const
  {
    Curve curve;
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      const Index v = mesh.source(h);
      if (is_shared(edge_of(h)))
        visit_shared(v, m_first_reference[h], h);
      const Count starts = is_wanted(h) ? number_of_starts(mesh, h) : 0;
      for (Count i = 0; i < starts; ++i) {
        trace(mesh, h, i, curve);
        visit(v, static_cast<int>((m_first_reference[h] + (is_shared(edge_of(h)) ? 1 : 0) + i) % m_degree[v]), curve);
      }
    }
  }

  /// does so for all of them.
  template <typename Visitor, typename SharedVisitor>
  void for_each_reference_halfedge(const Triangulation_connectivity& mesh, Visitor&& visit,
                                   SharedVisitor&& visit_shared) const
  {
    for_each_reference_halfedge(mesh, visit, visit_shared, [](Index) { return true; });
  }

private:
  Count crossings(const Index h) const { return std::max<Count>(m_count[edge_of(h)], 0); }

  // Number of arcs that cut off the corner at the source of `h` in the triangle of `h`.
  Count number_of_corner_arcs(const Triangulation_connectivity& mesh, const Index h) const
  {
    const Index previous = mesh.previous(h);
    const Count starts_elsewhere = number_of_starts(mesh, mesh.next(h)) + number_of_starts(mesh, previous);
    const Count twice = crossings(h) + crossings(previous) - crossings(mesh.next(h)) - starts_elsewhere;
    return std::max<Count>(0, twice) / 2;
  }

  // The edge i-j of h becomes k-l, with the triangles (i, j, k) of h and (j, i, l) of its opposite. An arc crosses k-l
  // if it runs from the side of i to the side of j; those that cross i-j are told apart by their positions on it.
  Count count_after_flip(const Triangulation_connectivity& mesh, const Index h) const
  {
    const Index g = opposite(h);
    const Index jk = mesh.next(h), ki = mesh.previous(h), il = mesh.next(g), lj = mesh.previous(g);
    const Count around_i_above = number_of_corner_arcs(mesh, h), to_k = number_of_starts(mesh, ki);
    const Count around_i_below = number_of_corner_arcs(mesh, il), to_l = number_of_starts(mesh, lj);
    const Count from_k_to_l =
        std::min(around_i_above + to_k, around_i_below + to_l) - std::max(around_i_above, around_i_below);
    if (to_k > 0 && to_l > 0 && from_k_to_l > 0)
      return shared;
    return number_of_corner_arcs(mesh, ki) + number_of_corner_arcs(mesh, lj) // around k and around l
           + number_of_starts(mesh, h) + number_of_starts(mesh, il)          // from i
           + number_of_starts(mesh, jk) + number_of_starts(mesh, g)          // from j
           + std::max<Count>(0, around_i_above - around_i_below - to_l) +
           std::max<Count>(0, around_i_below - around_i_above - to_k) + (is_shared(edge_of(h)) ? 1 : 0);
  }

  void update_first_reference(const Triangulation_connectivity& mesh, const Index h)
  {
    const Index clockwise = mesh.next(opposite(h)); // same source
    m_first_reference[h] = static_cast<int>(
        (m_first_reference[clockwise] + (is_shared(edge_of(clockwise)) ? 1 : 0) + number_of_starts(mesh, clockwise)) %
        m_degree[mesh.source(h)]);
  }

  // Follows the i-th (counter-clockwise) of the reference edges that start at the source of `corner` in its triangle.
  void trace(const Triangulation_connectivity& mesh, const Index corner, const Count i, Curve& curve) const
  {
    curve.first_corner = corner;
    curve.crossings.clear();
    Index exit = mesh.next(corner);
    Count position = number_of_corner_arcs(mesh, exit) + i;
    while (true) {
      curve.crossings.push_back({exit, position});
      const Index entry = opposite(exit);
      const Count count = crossings(entry);
      position = count - 1 - position; // now from the source of entry
      const Index to_apex = mesh.next(entry), from_apex = mesh.previous(entry);
      if (position < number_of_corner_arcs(mesh, entry)) {
        exit = from_apex;
        position = crossings(exit) - 1 - position;
      }
      else if (count - 1 - position < number_of_corner_arcs(mesh, to_apex)) {
        exit = to_apex;
        position = count - 1 - position;
      }
      else {
        CGAL_assertion(number_of_starts(mesh, from_apex) > 0);
        curve.last_corner = from_apex;
        return;
      }
    }
  }

  std::vector<Count> m_count;         // per edge
  std::vector<int> m_first_reference; // per halfedge, modulo the degree of its source
  std::vector<int> m_degree;          // per vertex, in the reference triangulation
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NORMAL_COORDINATES_H
