// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_FOREST_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_FOREST_H

#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>

#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A spanning forest of a cut graph in which all ground nodes count as one.
///
/// An equation at each node that is not ground determines the value of the branch to its parent: children first.
class Cut_forest {
public:
  static constexpr int none = -1;

  /// \param is_ground per node
  /// \param weight per branch: of two branches that could be taken the heavier one is
  Cut_forest(const Cut_graph& graph, const std::vector<char>& is_ground, const std::vector<double>& weight)
    : m_parent_branch(graph.number_of_nodes(), none),
      m_root(graph.number_of_nodes(), none),
      m_is_tree(graph.number_of_branches(), 0)
  {
    std::vector<char> is_reached = is_ground;
    Queue queue;
    for (int node = 0; node < graph.number_of_nodes(); ++node)
      if (is_ground[node])
        push_ends(graph, weight, node, queue);
    grow(graph, weight, is_reached, queue);
    for (int node = 0; node < graph.number_of_nodes(); ++node)
      if (!is_reached[node]) {
        is_reached[node] = 1;
        m_root[node] = node;
        m_order.push_back(node);
        push_ends(graph, weight, node, queue);
        grow(graph, weight, is_reached, queue);
      }
  }

  /// The nodes that are not ground, parents before their children.
  const std::vector<int>& order() const { return m_order; }

  /// The branch to the parent of a node; `none` for ground nodes and roots.
  int parent_branch(const int node) const { return m_parent_branch[node]; }

  /// The root of the tree of a node; `none` if the tree hangs on the ground.
  int root(const int node) const { return m_root[node]; }

  bool is_tree(const int branch) const { return m_is_tree[branch] != 0; }

private:
  // Weight, the branch (negative, for a definite order), the node that it leads to, and from which.
  using Queue = std::priority_queue<std::tuple<double, int, int, int>>;

  static void push_ends(const Cut_graph& graph, const std::vector<double>& weight, const int node, Queue& queue)
  {
    for (int i = 0; i < graph.number_of_ends(node); ++i) {
      const Cut_graph::End& end = graph.end(node, i);
      queue.emplace(weight[end.branch], -end.branch, graph.other_node(end), node);
    }
  }

  void grow(const Cut_graph& graph, const std::vector<double>& weight, std::vector<char>& is_reached, Queue& queue)
  {
    while (!queue.empty()) {
      const auto [w, negative_branch, node, from] = queue.top();
      queue.pop();
      if (is_reached[node])
        continue;
      is_reached[node] = 1;
      m_parent_branch[node] = -negative_branch;
      m_root[node] = m_root[from];
      m_is_tree[-negative_branch] = 1;
      m_order.push_back(node);
      push_ends(graph, weight, node, queue);
    }
  }

  std::vector<int> m_order;
  std::vector<int> m_parent_branch, m_root; // per node
  std::vector<char> m_is_tree;              // per branch
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_FOREST_H
