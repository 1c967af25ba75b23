// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_HOMOLOGY_LOOPS_H
#define CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_HOMOLOGY_LOOPS_H

#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Tree-cotree decompositions of the components of a triangulation.
///
/// A closed curve of the border counts as one vertex, as if a disk that closes it had shrunk to a point: no loop crosses
/// it.
///
/// For a root face, the dual tree consists of shortest dual paths. Every edge outside of it closes a loop; the primal
/// spanning tree is the one that is largest by the lengths of these loops, so that the 2g edges in neither tree close
/// the shortest homology basis that the dual tree offers (the greedy argument of Erickson and Whittlesey, Greedy
/// optimal homotopy and homology generators, SODA 2005, here with the length of a loop without its tail to the root).
/// The loops generate the homology over the integers, not only over a field.
class Tree_cotree_decomposition {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// \param dual_length per edge: the length of a dual path across it, not negative
  Tree_cotree_decomposition(const Triangulation_connectivity& mesh, const std::vector<double>& dual_length)
    : m_mesh(mesh),
      m_dual_length(dual_length),
      m_distance(mesh.number_of_faces()),
      m_node(nodes(mesh)),
      m_depth(mesh.number_of_faces()),
      m_entry(mesh.number_of_faces(), null),
      m_degree(mesh.number_of_vertices(), 0),
      m_incident_edges(mesh.number_of_vertices(), 0),
      m_representative(mesh.number_of_vertices())
  {
    CGAL_precondition(static_cast<int>(dual_length.size()) == mesh.number_of_edges());
  }

  /// decomposes the component of `faces` with the root `root`.
  /// \return the total length of the loops. If `progress` is interrupted there is no decomposition.
  double decompose(const std::vector<Index>& faces, const Index root, Progress& progress)
  {
    m_generators.clear();
    grow_dual_tree(faces, root, progress);
    if (!progress.go_on())
      return 0;
    find_core(faces);
    m_loop_length.clear();
    for (const Index e : m_core) {
      if (!progress.go_on_after(m_depth[m_mesh.face(halfedge_of_edge(e))] / 8))
        return 0;
      m_loop_length.emplace_back(loop_length(e), e);
    }
    if (!progress.go_on())
      return 0;
    return grow_primal_tree();
  }

  /// the edges in neither tree of the last decomposition, by increasing length of their loops.
  const std::vector<Index>& generators() const { return m_generators; }

  /// the halfedges by which the loop that edge `e` closes enters its faces, no face twice.
  std::vector<Index> loop(const Index e) const
  {
    const Index h = halfedge_of_edge(e);
    const Index last = m_mesh.face(opposite(h));
    const Index top = lowest_common_ancestor(m_mesh.face(h), last);
    std::vector<Index> result(1, h);
    for (Index f = m_mesh.face(h); f != top; f = parent(f))
      result.push_back(opposite(m_entry[f]));
    const std::size_t number_up = result.size();
    for (Index f = last; f != top; f = parent(f))
      result.push_back(m_entry[f]);
    std::reverse(result.begin() + static_cast<std::ptrdiff_t>(number_up), result.end());
    return result;
  }

  /// the vertex, or the first one of the curve of the border that counts as one with it.
  Index node(const Index v) const { return m_node[v]; }

  /// calls `function(h)` for one halfedge of each edge between two of `faces`.
  template <typename Function>
  void for_each_inner_edge(const std::vector<Index>& faces, const Function& function) const
  {
    for (const Index f : faces) {
      Index h = m_mesh.halfedge_of_face(f);
      for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h))
        if (h < opposite(h) && m_mesh.face(opposite(h)) != null)
          function(h);
    }
  }

  /// tells whether the dual tree crosses the edge of `h`. \pre The edge has two faces.
  bool in_dual_tree(const Index h) const
  {
    return m_entry[m_mesh.face(h)] == h || m_entry[m_mesh.face(opposite(h))] == opposite(h);
  }

private:
  static std::vector<Index> nodes(const Triangulation_connectivity& mesh)
  {
    std::vector<Index> result(mesh.number_of_vertices());
    std::iota(result.begin(), result.end(), 0);
    for (const std::vector<Index>& curve : border_curves(mesh))
      for (const Index h : curve)
        result[mesh.target(h)] = mesh.target(curve.front());
    return result;
  }

  Index node_at(const Index h) const { return m_node[m_mesh.target(h)]; }

  Index parent(const Index f) const { return m_mesh.face(opposite(m_entry[f])); }

  void grow_dual_tree(const std::vector<Index>& faces, const Index root, Progress& progress)
  {
    for (const Index f : faces)
      m_distance[f] = std::numeric_limits<double>::infinity();
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    m_distance[root] = 0;
    m_depth[root] = 0;
    m_entry[root] = null;
    queue.emplace(0., root);
    while (!queue.empty() && progress.go_on_after(10)) {
      const auto [distance, f] = queue.top();
      queue.pop();
      if (distance > m_distance[f])
        continue;
      Index h = m_mesh.halfedge_of_face(f);
      for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h)) {
        const Index g = m_mesh.face(opposite(h));
        if (g == null)
          continue;
        const double via_f = distance + m_dual_length[edge_of(h)];
        if (via_f < m_distance[g]) {
          m_distance[g] = via_f;
          m_depth[g] = m_depth[f] + 1;
          m_entry[g] = opposite(h);
          queue.emplace(via_f, g);
        }
      }
    }
  }

  // The primal edges that the dual tree does not cross form a connected graph. Its vertices of degree one are taken away until
  // none is left: their edges belong to every spanning tree. What remains, the core, is empty on a sphere.
  void find_core(const std::vector<Index>& faces)
  {
    m_core.clear();
    for_each_inner_edge(faces, [this](const Index h) {
      if (!in_dual_tree(h))
        m_core.push_back(edge_of(h));
    });
    std::vector<Index> leaves;
    for (const Index e : m_core) {
      for (const Index h : halfedges_of_edge(e)) {
        ++m_degree[node_at(h)];
        m_incident_edges[node_at(h)] ^= e; // with one edge left, this is the edge
      }
    }
    for (const Index e : m_core)
      for (const Index h : halfedges_of_edge(e))
        if (m_degree[node_at(h)] == 1)
          strip_leaves(node_at(h));
    const auto is_stripped = [this](const Index e) {
      const auto [h, g] = halfedges_of_edge(e);
      return m_degree[node_at(h)] == 0 || m_degree[node_at(g)] == 0;
    };
    m_core.erase(std::remove_if(m_core.begin(), m_core.end(), is_stripped), m_core.end());
    reset_vertices(faces);
  }

  void strip_leaves(Index v)
  {
    while (m_degree[v] == 1) {
      const Index e = m_incident_edges[v];
      const auto [h, g] = halfedges_of_edge(e);
      const Index w = node_at(h) == v ? node_at(g) : node_at(h);
      m_degree[v] = 0;
      --m_degree[w];
      m_incident_edges[w] ^= e;
      v = w;
    }
  }

  void reset_vertices(const std::vector<Index>& faces)
  {
    for_each_inner_edge(faces, [this](const Index h) {
      for (const Index v : {node_at(h), node_at(opposite(h))}) {
        m_degree[v] = 0;
        m_incident_edges[v] = 0;
      }
    });
  }

  // Kruskal's algorithm for the largest spanning tree of the core.
  double grow_primal_tree()
  {
    std::sort(m_loop_length.begin(), m_loop_length.end());
    for (const Index e : m_core)
      for (const Index h : halfedges_of_edge(e))
        m_representative[node_at(h)] = node_at(h);
    m_generators.clear();
    double total = 0;
    for (auto entry = m_loop_length.rbegin(); entry != m_loop_length.rend(); ++entry) {
      const Index v = representative(node_at(halfedge_of_edge(entry->second)));
      const Index w = representative(node_at(opposite(halfedge_of_edge(entry->second))));
      if (v == w) {
        m_generators.push_back(entry->second);
        total += entry->first;
      }
      m_representative[v] = w;
    }
    std::reverse(m_generators.begin(), m_generators.end());
    return total;
  }

  Index representative(Index v)
  {
    while (m_representative[v] != v)
      v = m_representative[v] = m_representative[m_representative[v]];
    return v;
  }

  Index lowest_common_ancestor(Index f, Index g) const
  {
    while (f != g) {
      if (m_depth[f] < m_depth[g])
        std::swap(f, g);
      f = parent(f);
    }
    return f;
  }

  double loop_length(const Index e) const
  {
    const Index h = halfedge_of_edge(e), f = m_mesh.face(h), g = m_mesh.face(opposite(h));
    return m_distance[f] + m_distance[g] - 2 * m_distance[lowest_common_ancestor(f, g)] + m_dual_length[e];
  }

  const Triangulation_connectivity& m_mesh;
  const std::vector<double>& m_dual_length;
  std::vector<double> m_distance;                      // per face: to the root
  std::vector<Index> m_node;                           // per vertex
  std::vector<Index> m_depth;                          // per face: number of edges to the root
  std::vector<Index> m_entry;                          // per face: its halfedge towards its parent
  std::vector<Index> m_degree, m_incident_edges;       // per vertex, while the core is found
  std::vector<Index> m_representative;                 // per vertex of the core: union-find
  std::vector<Index> m_core, m_generators;             // edges
  std::vector<std::pair<double, Index>> m_loop_length; // per edge of the core
};

/// computes, for each component of a triangulation, 2g short loops that generate its homology, that of the surface without
/// border which disks would make of it.
///
/// \param dual_length per edge: the length of a dual path across it, not negative
/// \param progress if it is interrupted, what is returned is incomplete
/// \param number_of_roots how many decompositions are tried per component; the one with the shortest loops is kept
/// \return the loops, component by component, each as the cyclic sequence of the halfedges by which it enters its faces,
///         as in `Holonomy_signature::Loop`; no loop enters a face twice.
/// Complexity: O(n log n) with n faces, and the total length of the loops.
inline std::vector<std::vector<int>> homology_loops(const Triangulation_connectivity& mesh,
                                                    const std::vector<double>& dual_length,
                                                    const Mesh_components& components, Progress& progress,
                                                    const int number_of_roots = 2)
{
  std::vector<std::vector<int>> loops;
  std::vector<std::vector<int>> faces(components.size());
  for (int f = 0; f < mesh.number_of_faces(); ++f)
    if (components.genus(components.of_face[f]) > 0)
      faces[components.of_face[f]].push_back(f);
  Tree_cotree_decomposition decomposition(mesh, dual_length);
  for (int c = 0; c < components.size(); ++c) {
    if (components.genus(c) == 0)
      continue;
    int root = components.first_face[c];
    double shortest = std::numeric_limits<double>::infinity();
    std::vector<std::vector<int>> best;
    for (int trial = 0; trial < number_of_roots; ++trial) {
      const double length = decomposition.decompose(faces[c], root, progress);
      std::vector<std::vector<int>> trial_loops;
      for (const int e : decomposition.generators()) {
        trial_loops.push_back(decomposition.loop(e));
        progress.go_on_after(trial_loops.back().size());
      }
      if (progress.is_interrupted())
        return loops;
      CGAL_postcondition(static_cast<int>(trial_loops.size()) == 2 * components.genus(c));
      const std::vector<int>& shortest_loop = trial_loops.front();
      root = mesh.face(shortest_loop[shortest_loop.size() / 2]);
      if (length < shortest) {
        shortest = length;
        best.swap(trial_loops);
      }
    }
    loops.insert(loops.end(), std::make_move_iterator(best.begin()), std::make_move_iterator(best.end()));
  }
  return loops;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_HOMOLOGY_LOOPS_H
