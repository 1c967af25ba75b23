// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_SCALES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_SCALES_H

#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_forest.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <map>
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

inline std::vector<char> nodes_of_kind(const std::vector<Cut_node_kind>& kind,
                                       const std::initializer_list<Cut_node_kind>& wanted)
{
  std::vector<char> result;
  for (const Cut_node_kind k : kind)
    result.push_back(std::find(wanted.begin(), wanted.end(), k) != wanted.end());
  return result;
}

/// A product of powers: exponents by numbers, none of them zero.
using Exponents = std::map<int, int>;

inline void add_to(Exponents& sum, const int number, const int exponent)
{
  const auto place = sum.emplace(number, 0).first;
  if ((place->second += exponent) == 0)
    sum.erase(place);
}

inline void add_to(Exponents& sum, const Exponents& other, const int factor)
{
  for (const auto& [number, exponent] : other)
    add_to(sum, number, factor * exponent);
}

/// Exact scale factors of the branches of a cut, near those that fit them in doubles.
///
/// Those of branches outside a spanning forest of the cut graph are chosen, the others follow from the nodes, around
/// which they multiply to 1. Scale factors within their uncertainty of 1 are 1, and those within their uncertainty of
/// each other, or of each other's inverses, are made from one value: their quotients and products then cancel exactly.
/// \tparam FT the number type
template <typename FT>
class Exact_scales {
public:
  /// \param uncertainty per branch, of the logarithm of its scale factor
  /// \param cycles exponents by branches, of products that are to be 1 if they are so but for their uncertainty
  Exact_scales(const Cut_graph& graph, const std::vector<Branch_fit>& fits, const std::vector<Cut_node_kind>& kind,
               const std::vector<double>& uncertainty, const std::vector<Exponents>& cycles)
    : m_graph(graph),
      m_fits(fits),
      m_forest(m_graph, nodes_of_kind(kind, {Cut_node_kind::BORDER}), uncertainty),
      m_factor(m_graph.number_of_branches()),
      m_scale(m_graph.number_of_branches(), FT(1)),
      m_inverse_scale(m_graph.number_of_branches(), FT(1))
  {
    choose_free_scales(uncertainty);
    for (const Exponents& cycle : cycles)
      if (!m_large.empty())
        close(cycle, uncertainty);
    m_are_all_1 = std::all_of(m_is_product.begin(), m_is_product.end(), [](const char is) { return is != 0; }) &&
                  std::all_of(m_product.begin(), m_product.end(), [](const Exponents& e) { return e.empty(); });
  }

  /// Whether all scale factors are 1.
  bool are_all_1() const { return m_are_all_1; }

  /// Per branch, as of the last `compute()`.
  const std::vector<FT>& values() const { return m_scale; }
  const std::vector<FT>& inverse_values() const { return m_inverse_scale; }

  /// Computes the scale factors, those that are free with so many bits.
  void compute(const int bits)
  {
    std::vector<std::pair<FT, FT>> value(m_large.size()); // and inverse
    for (std::size_t i = 0; i < m_large.size(); ++i)
      if (m_is_product[i] == 0) {
        value[i].first = FT(bits < 53 ? rounded(m_large[i], bits) : m_large[i]);
        value[i].second = FT(FT(1) / value[i].first);
      }
    for (std::size_t i = 0; i < m_large.size(); ++i)
      if (m_is_product[i] != 0) {
        value[i] = {FT(1), FT(1)};
        for (const auto& [j, exponent] : m_product[i])
          for (int n = 0; n < std::abs(exponent); ++n) {
            value[i].first = FT(value[i].first * (exponent > 0 ? value[j].first : value[j].second));
            value[i].second = FT(value[i].second * (exponent > 0 ? value[j].second : value[j].first));
          }
      }
    for (int b = 0; b < m_graph.number_of_branches(); ++b) {
      const auto [i, exponent] = m_factor[b];
      if (exponent == 0)
        set(b, FT(1), FT(1));
      else
        exponent > 0 ? set(b, value[i].first, value[i].second) : set(b, value[i].second, value[i].first);
    }
    if (m_are_all_1)
      return;
    const std::vector<int>& order = m_forest.order();
    for (auto node = order.rbegin(); node != order.rend(); ++node)
      compute_parent_scale(*node);
  }

private:
  void choose_free_scales(const std::vector<double>& uncertainty)
  {
    std::vector<std::pair<double, int>> order; // absolute value of the logarithm, branch
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      if (!m_forest.is_tree(b) && std::abs(std::log(m_fits[b].scale())) > uncertainty[b])
        order.emplace_back(std::abs(std::log(m_fits[b].scale())), b);
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
      const double scale = m_fits[order[best].second].scale();
      for (std::size_t i = first; i < last; ++i)
        m_factor[order[i].second] = {static_cast<int>(m_large.size()), m_fits[order[i].second].scale() > 1 ? 1 : -1};
      m_large.push_back(scale > 1 ? scale : 1 / scale);
    }
    m_is_product.assign(m_large.size(), 0);
    m_product.resize(m_large.size());
  }

  // Makes the product along a cycle 1, if it is so but for the uncertainty: one of its factors follows from the others.
  // Without a factor of which the product is linear, nothing is done.
  void close(const Exponents& cycle, const std::vector<double>& uncertainty)
  {
    double logarithm = 0, allowed = 0;
    for (const auto& [b, exponent] : cycle) {
      logarithm += exponent * std::log(m_fits[b].scale());
      allowed += std::abs(exponent) * uncertainty[b];
    }
    if (std::abs(logarithm) > allowed)
      return;
    const Exponents product = free_factors(cycle);
    const auto pivot =
        std::find_if(product.rbegin(), product.rend(), [](const auto& factor) { return std::abs(factor.second) == 1; });
    if (pivot == product.rend())
      return;
    const auto [i, sign] = *pivot;
    add_to(m_product[i], product, -sign);
    m_product[i].erase(i);
    m_is_product[i] = 1;
    for (std::size_t j = 0; j < m_product.size(); ++j)
      if (const auto place = m_product[j].find(i); m_is_product[j] != 0 && place != m_product[j].end()) {
        const int exponent = place->second;
        m_product[j].erase(place);
        add_to(m_product[j], m_product[i], exponent);
      }
  }

  // The product by the values that are chosen, which must not be products of others.
  Exponents free_factors(Exponents cycle) const
  {
    for (const int node : m_forest.order()) {
      const int parent = m_forest.parent_branch(node);
      const auto place = parent == Cut_forest::none ? cycle.end() : cycle.find(parent);
      if (place == cycle.end())
        continue;
      const int exponent = place->second;
      cycle.erase(place);
      int sign = 1;
      for (int i = 0; i < m_graph.number_of_ends(node); ++i)
        if (m_graph.end(node, i).branch == parent)
          sign = m_graph.end(node, i).is_outgoing ? 1 : -1;
      for (int i = 0; i < m_graph.number_of_ends(node); ++i)
        if (m_graph.end(node, i).branch != parent)
          add_to(cycle, m_graph.end(node, i).branch, (m_graph.end(node, i).is_outgoing ? -1 : 1) * sign * exponent);
    }
    Exponents result;
    for (const auto& [b, exponent] : cycle)
      if (m_factor[b].second != 0) {
        const int i = m_factor[b].first, n = m_factor[b].second * exponent;
        if (m_is_product[i] != 0)
          add_to(result, m_product[i], n);
        else
          add_to(result, i, n);
      }
    return result;
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

  void set(const int branch, FT scale, FT inverse)
  {
    m_scale[branch] = std::move(scale);
    m_inverse_scale[branch] = std::move(inverse);
  }

  // The scale factors around a node multiply to 1.
  void compute_parent_scale(const int node)
  {
    const int parent = m_forest.parent_branch(node);
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
    is_outgoing ? set(parent, product, inverse) : set(parent, inverse, product);
  }

  const Cut_graph& m_graph;
  const std::vector<Branch_fit>& m_fits;
  Cut_forest m_forest;
  std::vector<double> m_large;               // the values that are chosen, greater than 1
  std::vector<std::pair<int, int>> m_factor; // per branch: of which value it is the power 1, -1, or 0
  std::vector<char> m_is_product;            // per value: it is a product of the others
  std::vector<Exponents> m_product;          // per value
  std::vector<FT> m_scale, m_inverse_scale;  // per branch
  bool m_are_all_1 = true;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_SCALES_H
