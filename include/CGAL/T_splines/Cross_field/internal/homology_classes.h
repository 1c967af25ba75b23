// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_HOMOLOGY_CLASSES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_HOMOLOGY_CLASSES_H

#include <CGAL/T_splines/Cross_field/support/homology_loops.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The primal cycles that the generators of a tree-cotree decomposition close with the primal spanning tree.
///
/// The loop of generator j crosses cycle i exactly once if i = j, else never: the numbers of crossings with the cycles are
/// the coordinates of a dual loop in the homology basis of the decomposition. A cycle may jump from one vertex of a
/// curve of the border to another.
class Primal_cycles {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// \pre `decomposition` is that of the component of `faces`.
  Primal_cycles(const Triangulation_connectivity& mesh, const Tree_cotree_decomposition& decomposition,
                const std::vector<Index>& faces)
    : m_mesh(mesh),
      m_decomposition(decomposition),
      m_entry(mesh.number_of_vertices(), null),
      m_depth(mesh.number_of_vertices(), 0)
  {
    grow_tree(faces);
  }

  /// computes the halfedges of the cycle of generator `e`: edge `e` from its source to its target and back in the tree.
  std::vector<Index> cycle(const Index e) const
  {
    std::vector<Index> result(1, halfedge_of_edge(e));
    Index v = node_at(result.front()), w = node_at(opposite(result.front()));
    while (v != w) {
      if (m_depth[v] >= m_depth[w]) {
        result.push_back(opposite(m_entry[v]));
        v = node_at(result.back());
      }
      else {
        result.push_back(m_entry[w]);
        w = node_at(opposite(m_entry[w]));
      }
    }
    return result;
  }

private:
  Index node_at(const Index h) const { return m_decomposition.node(m_mesh.target(h)); }

  void grow_tree(const std::vector<Index>& faces)
  {
    std::vector<char> is_generator(m_mesh.number_of_edges(), 0);
    for (const Index e : m_decomposition.generators())
      is_generator[e] = 1;
    std::vector<std::vector<Index>> outgoing(m_mesh.number_of_vertices()); // per node, in the tree
    m_decomposition.for_each_inner_edge(faces, [&](const Index h) {
      if (is_generator[edge_of(h)] || m_decomposition.in_dual_tree(h))
        return;
      outgoing[node_at(opposite(h))].push_back(h);
      outgoing[node_at(h)].push_back(opposite(h));
    });
    const Index root = node_at(m_mesh.halfedge_of_face(faces.front()));
    std::vector<Index> queue(1, root);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const Index h : outgoing[queue[i]]) {
        const Index v = node_at(h);
        if (v == root || m_entry[v] != null)
          continue;
        m_entry[v] = h;
        m_depth[v] = m_depth[queue[i]] + 1;
        queue.push_back(v);
      }
  }

  const Triangulation_connectivity& m_mesh;
  const Tree_cotree_decomposition& m_decomposition;
  std::vector<Index> m_entry; // per node: the halfedge from its parent
  std::vector<Index> m_depth;
};

/// The determinant of a square matrix, given by rows, modulo the prime p < 2^31; any number if `progress` is
/// interrupted.
inline std::int64_t determinant_modulo(const std::vector<std::vector<int>>& matrix, const std::int64_t p,
                                       Progress& progress)
{
  const std::size_t n = matrix.size();
  std::vector<std::vector<std::int64_t>> a(n);
  for (std::size_t i = 0; i < n; ++i)
    for (const int entry : matrix[i])
      a[i].push_back((entry % p + p) % p);
  const auto inverse = [p](std::int64_t x) {
    std::int64_t result = 1; // x^(p-2), by Fermat
    for (std::int64_t exponent = p - 2; exponent > 0; exponent >>= 1, x = x * x % p)
      if (exponent & 1)
        result = result * x % p;
    return result;
  };
  std::int64_t determinant = 1;
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && a[pivot][column] == 0)
      ++pivot;
    if (pivot == n)
      return 0;
    if (pivot != column) {
      std::swap(a[pivot], a[column]);
      determinant = p - determinant;
    }
    determinant = determinant * a[column][column] % p;
    const std::int64_t reciprocal = inverse(a[column][column]);
    for (std::size_t i = column + 1; i < n; ++i) {
      if (!progress.go_on_after(1 + n / 8))
        return 0;
      const std::int64_t factor = a[i][column] * reciprocal % p;
      if (factor == 0)
        continue;
      for (std::size_t j = column; j < n; ++j)
        a[i][j] = (a[i][j] + (p - factor) * a[column][j]) % p;
    }
  }
  return determinant;
}

/// tells whether closed strips generate the integer homology of a component: whether their matrix of coordinates has
/// determinant 1 or -1. The determinant is computed modulo two primes, whose product exceeds 2^61.
/// \pre There are 2g strips.
/// \return `true` if `progress` is interrupted.
inline bool generate_homology(const Triangulation_connectivity& mesh, const std::vector<double>& dual_length,
                              const std::vector<int>& faces, const std::vector<std::vector<int>>& strips,
                              Progress& progress)
{
  if (strips.empty())
    return true;
  Tree_cotree_decomposition decomposition(mesh, dual_length);
  decomposition.decompose(faces, faces.front(), progress);
  if (progress.is_interrupted())
    return true;
  const Primal_cycles cycles(mesh, decomposition, faces);
  std::vector<std::vector<int>> coordinates(strips.size());
  std::vector<int> crossing(mesh.number_of_halfedges(), 0);
  for (const int e : decomposition.generators()) {
    const std::vector<int> cycle = cycles.cycle(e);
    for (const int h : cycle) {
      crossing[h] += 1;
      crossing[opposite(h)] -= 1;
    }
    for (std::size_t i = 0; i < strips.size(); ++i) {
      int sum = 0;
      for (const int h : strips[i])
        sum += crossing[h];
      coordinates[i].push_back(sum);
      if (!progress.go_on_after(1 + strips[i].size() / 8))
        return true;
    }
    for (const int h : cycle)
      crossing[h] = crossing[opposite(h)] = 0;
  }
  constexpr std::int64_t primes[] = {2147483647, 2147483629};
  const std::int64_t first = determinant_modulo(coordinates, primes[0], progress);
  const std::int64_t second = determinant_modulo(coordinates, primes[1], progress);
  return progress.is_interrupted() || (first == 1 && second == 1) ||
         (first == primes[0] - 1 && second == primes[1] - 1);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_HOMOLOGY_CLASSES_H
