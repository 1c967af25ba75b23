// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_TRANSITIONS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_TRANSITIONS_H

#include <CGAL/T_splines/Similarity_map/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_forest.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/internal/exactness.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What the transitions around a node of the cut must compose to.
enum class Cut_node_kind : char {
  IDENTITY,      ///< the rotations cancel: the identity
  ROTATION,      ///< a rotation by quarter turns about any point
  BORDER,        ///< a loop of the border that asks for nothing
  BORDER_LINE_U, ///< a loop on one line, u constant in the first chart: a translation along v
  BORDER_LINE_V  ///< a loop on one line, v constant in the first chart: a translation along u
};

/// Exact transitions of the branches of a cut, near those that fit them in doubles.
///
/// Scale factors and translations are chosen on the branches outside a spanning forest of the cut graph, and follow
/// from the equations at the nodes on those of the forest, by exact operations.
/// \tparam FT the number type
template <typename FT>
class Exact_transitions {
  using Number = Plane_vector<FT>;

public:
  using Transition = Similarity_2<FT>;

  /// \param kind per node
  /// \param uncertainty per branch, of the logarithm of its scale factor
  Exact_transitions(const Cut_graph& graph, const std::vector<Branch_fit>& fits, const std::vector<Cut_node_kind>& kind,
                    const std::vector<double>& uncertainty)
    : m_graph(graph),
      m_fits(fits),
      m_kind(kind),
      m_scale_forest(graph, nodes_of_kind(kind, {Cut_node_kind::BORDER}), uncertainty),
      m_translation_forest(graph, nodes_of_kind(kind, {Cut_node_kind::BORDER, Cut_node_kind::ROTATION}), uncertainty),
      m_free_scale(graph.number_of_branches(), 1.),
      m_scale(graph.number_of_branches(), FT(1)),
      m_inverse_scale(graph.number_of_branches(), FT(1)),
      m_translation(graph.number_of_branches())
  {
    choose_free_scales(uncertainty);
  }

  /// Whether all scale factors are 1.
  bool is_isometric() const { return m_is_isometric; }

  /// Computes the transitions with free scale factors of so many bits.
  void compute(const int bits)
  {
    compute_scales(bits);
    collect_coefficients();
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      if (!m_translation_forest.is_tree(b))
        m_translation[b] = free_translation(b);
    close_components_without_ground();
    compute_tree_translations();
    close_components_on_lines();
  }

  Transition transition(const int branch) const
  {
    return Transition(m_fits[branch].quarter_turns(), m_scale[branch], m_translation[branch].u,
                      m_translation[branch].v);
  }

private:
  struct Coefficient {
    int branch;
    Number value;
  };

  static std::vector<char> nodes_of_kind(const std::vector<Cut_node_kind>& kind,
                                         const std::initializer_list<Cut_node_kind>& wanted)
  {
    std::vector<char> result;
    for (const Cut_node_kind k : kind)
      result.push_back(std::find(wanted.begin(), wanted.end(), k) != wanted.end());
    return result;
  }

  // Scale factors within their uncertainty of 1 are 1, and those within their uncertainty of each other, or of each
  // other's inverses, are made from one value: their quotients and products then cancel exactly.
  void choose_free_scales(const std::vector<double>& uncertainty)
  {
    std::vector<std::pair<double, int>> order; // absolute value of the logarithm, branch
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      if (!m_scale_forest.is_tree(b) && std::abs(std::log(m_fits[b].scale())) > uncertainty[b])
        order.emplace_back(std::abs(std::log(m_fits[b].scale())), b);
    m_is_isometric = order.empty();
    std::sort(order.begin(), order.end());
    for (std::size_t first = 0, last; first < order.size(); first = last) {
      std::size_t best = first;
      for (last = first + 1; last < order.size(); ++last) {
        const double allowed = uncertainty[order[last].second] + uncertainty[order[last - 1].second];
        if (order[last].first - order[last - 1].first > allowed)
          break;
        if (uncertainty[order[last].second] < uncertainty[order[best].second])
          best = last;
      }
      const double scale = m_fits[order[best].second].scale(), large = scale > 1 ? scale : 1 / scale;
      for (std::size_t i = first; i < last; ++i)
        m_free_scale[order[i].second] = m_fits[order[i].second].scale() > 1 ? large : -large; // negative: the inverse
    }
  }

  // The nearest number with so many bits to a number greater than 1, but not 1.
  static double rounded(const double x, const int bits)
  {
    const auto round_to = [bits](const double y) {
      int exponent;
      const double mantissa = std::frexp(y, &exponent);
      return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
    };
    const double result = round_to(x);
    return result > 1 ? result : 1 + round_to(x - 1);
  }

  void set_scale(const int branch, FT scale, FT inverse)
  {
    m_scale[branch] = std::move(scale);
    m_inverse_scale[branch] = std::move(inverse);
  }

  void compute_scales(const int bits)
  {
    for (int b = 0; b < m_graph.number_of_branches(); ++b) {
      const double large = std::abs(m_free_scale[b]);
      if (large == 1) {
        set_scale(b, FT(1), FT(1));
        continue;
      }
      const FT s(bits < 53 ? rounded(large, bits) : large);
      const FT inverse = FT(1) / s;
      m_free_scale[b] > 0 ? set_scale(b, s, inverse) : set_scale(b, inverse, s);
    }
    if (m_is_isometric)
      return;
    const std::vector<int>& order = m_scale_forest.order();
    for (auto node = order.rbegin(); node != order.rend(); ++node)
      compute_parent_scale(*node);
  }

  // The scale factors around a node multiply to 1.
  void compute_parent_scale(const int node)
  {
    const int parent = m_scale_forest.parent_branch(node);
    FT product(1), inverse(1);
    bool is_outgoing = true;
    if (parent == Cut_forest::none)
      return;
    for (int i = 0; i < m_graph.number_of_ends(node); ++i) {
      const Cut_graph::End& end = m_graph.end(node, i);
      if (end.branch == parent) {
        is_outgoing = end.is_outgoing;
        continue;
      }
      if (m_scale[end.branch] == FT(1))
        continue;
      product = FT(product * (end.is_outgoing ? m_inverse_scale : m_scale)[end.branch]);
      inverse = FT(inverse * (end.is_outgoing ? m_scale : m_inverse_scale)[end.branch]);
    }
    is_outgoing ? set_scale(parent, product, inverse) : set_scale(parent, inverse, product);
  }

  // The linear part of the transition by which one passes an end counter-clockwise.
  Number linear_part(const Cut_graph::End& end) const
  {
    const int r = m_fits[end.branch].quarter_turns();
    if (end.is_outgoing)
      return Number{m_inverse_scale[end.branch], FT(0)}.turned((4 - r) % 4);
    return Number{m_scale[end.branch], FT(0)}.turned(r);
  }

  // The equation of a node is that the translation of the composition around it, sum of coefficients times
  // translations of branches, vanishes.
  void collect_coefficients()
  {
    m_coefficients.assign(m_graph.number_of_nodes(), {});
    for (const int node : m_translation_forest.order()) {
      Number behind{FT(1), FT(0)};
      for (int i = m_graph.number_of_ends(node) - 1; i >= 0; --i) {
        const Cut_graph::End& end = m_graph.end(node, i);
        const Number here = linear_part(end);
        m_coefficients[node].push_back({end.branch, end.is_outgoing ? -(behind * here) : behind});
        behind = behind * here;
      }
    }
  }

  Number coefficient(const int node, const int branch) const
  {
    Number sum;
    for (const Coefficient& c : m_coefficients[node])
      if (c.branch == branch)
        sum = sum + c.value;
    return sum;
  }

  // A multiple of a power of two that is small against the edges of the branch, where a double can hold that.
  Number free_translation(const int branch) const
  {
    const Plane_vector<double> t = m_fits[branch].translation(CGAL::to_double(m_scale[branch]));
    int exponent;
    std::frexp(m_fits[branch].shortest_edge(), &exponent);
    const double unit = std::ldexp(1., exponent - 32);
    const auto round = [unit](const double x) {
      const double n = x / unit;
      return std::abs(n) < 4503599627370496. ? std::nearbyint(n) * unit : x;
    };
    return {FT(round(t.u)), FT(round(t.v))};
  }

  bool is_line(const int node) const
  {
    return m_kind[node] == Cut_node_kind::BORDER_LINE_U || m_kind[node] == Cut_node_kind::BORDER_LINE_V;
  }

  // What the translation around a node still lacks; along the border's own line nothing is asked for.
  Number left_over(const int node) const
  {
    Number sum;
    for (const Coefficient& c : m_coefficients[node])
      sum = sum + c.value * m_translation[c.branch];
    if (m_kind[node] == Cut_node_kind::BORDER_LINE_U)
      sum.v = FT(0);
    if (m_kind[node] == Cut_node_kind::BORDER_LINE_V)
      sum.u = FT(0);
    return sum;
  }

  void compute_tree_translations()
  {
    const std::vector<int>& order = m_translation_forest.order();
    for (auto node = order.rbegin(); node != order.rend(); ++node) {
      const int parent = m_translation_forest.parent_branch(*node);
      if (parent == Cut_forest::none)
        continue;
      m_translation[parent] = is_line(*node) ? free_translation(parent) : Number();
      m_translation[parent] = m_translation[parent] - left_over(*node) * coefficient(*node, parent).inverse();
    }
  }

  // A component without ground whose root is a loop on a line: mostly its equation holds by itself. If not, it is
  // solved for the coordinate of a free translation that it depends on most.
  void close_components_on_lines()
  {
    for (int root = 0; root < m_graph.number_of_nodes(); ++root) {
      if (m_translation_forest.root(root) != root || !is_line(root))
        continue;
      const auto value = [&] {
        compute_tree_translations();
        const Number left = left_over(root);
        return FT(left.u + left.v);
      };
      const FT left = value();
      if (left == FT(0) || !is_exact_number_type<FT>)
        continue;
      FT* best = nullptr;
      FT best_slope(0);
      for (int b = 0; b < m_graph.number_of_branches(); ++b) {
        if (m_translation_forest.is_tree(b) || m_translation_forest.root(m_graph.nodes_of_branch(b)[0]) != root)
          continue;
        for (FT* const x : {&m_translation[b].u, &m_translation[b].v}) {
          const FT before = *x;
          *x = FT(before + FT(1));
          const FT slope = value() - left;
          *x = before;
          if (CGAL::abs(slope) > CGAL::abs(best_slope)) {
            best_slope = slope;
            best = x;
          }
        }
      }
      if (best != nullptr)
        *best = FT(*best - left / best_slope);
      compute_tree_translations();
    }
  }

  // Where no ground takes up what is left over, the equation of the root remains. Multiples of the other equations
  // eliminate the branches of the tree from it; one of the free translations is solved for.
  void close_components_without_ground()
  {
    std::vector<Number> multiple(m_graph.number_of_nodes());
    std::vector<Number> left(m_graph.number_of_branches());
    std::vector<int> root_of_branch(m_graph.number_of_branches(), Cut_forest::none);
    bool has_root = false;
    for (const int node : m_translation_forest.order()) {
      const int root = m_translation_forest.root(node);
      if (root == Cut_forest::none || is_line(root))
        continue;
      has_root = true;
      const int parent = m_translation_forest.parent_branch(node);
      if (parent == Cut_forest::none)
        multiple[node] = {FT(1), FT(0)};
      else {
        const std::array<int, 2>& nodes = m_graph.nodes_of_branch(parent);
        const int above = nodes[0] == node ? nodes[1] : nodes[0];
        multiple[node] = -(multiple[above] * coefficient(above, parent) * coefficient(node, parent).inverse());
      }
      for (const Coefficient& c : m_coefficients[node])
        if (!m_translation_forest.is_tree(c.branch)) {
          left[c.branch] = left[c.branch] + multiple[node] * c.value;
          root_of_branch[c.branch] = root;
        }
    }
    if (has_root)
      solve_roots(left, root_of_branch);
  }

  void solve_roots(const std::vector<Number>& left, const std::vector<int>& root_of_branch)
  {
    std::vector<int> best(m_graph.number_of_nodes(), Cut_forest::none); // per root, the largest coefficient
    std::vector<Number> sum(m_graph.number_of_nodes());
    for (int b = 0; b < m_graph.number_of_branches(); ++b) {
      const int root = root_of_branch[b];
      if (root == Cut_forest::none || left[b].is_zero())
        continue;
      sum[root] = sum[root] + left[b] * m_translation[b];
      if (best[root] == Cut_forest::none || left[best[root]].squared_norm() < left[b].squared_norm())
        best[root] = b;
    }
    for (int root = 0; root < m_graph.number_of_nodes(); ++root)
      if (best[root] != Cut_forest::none)
        m_translation[best[root]] = m_translation[best[root]] - sum[root] * left[best[root]].inverse();
  }

  const Cut_graph& m_graph;
  const std::vector<Branch_fit>& m_fits;
  const std::vector<Cut_node_kind>& m_kind;
  Cut_forest m_scale_forest, m_translation_forest;
  std::vector<double> m_free_scale; // per branch: 1, or the factor greater than 1, negative if the inverse is meant
  std::vector<FT> m_scale, m_inverse_scale;             // per branch
  std::vector<Number> m_translation;                    // per branch
  std::vector<std::vector<Coefficient>> m_coefficients; // per node
  bool m_is_isometric = true;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_TRANSITIONS_H
