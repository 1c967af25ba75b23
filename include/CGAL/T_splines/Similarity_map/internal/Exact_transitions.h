// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_TRANSITIONS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_TRANSITIONS_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_forest.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_scales.h>
#include <CGAL/T_splines/Similarity_map/internal/Free_points.h>
#include <CGAL/T_splines/Similarity_map/internal/Homogeneous_equations.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_equation.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_search.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/exactness.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Exact transitions of the branches of a cut, near those that fit them in doubles.
///
/// Scale factors and translations are chosen on the branches outside a spanning forest of the cut graph, and follow
/// from the equations at the nodes on those of the forest, by exact operations.
/// \tparam FT the number type
template <typename FT>
class Exact_transitions {
  using Number = Plane_vector<FT>;
  using Equations = Homogeneous_equations<FT>;

public:
  using Transition = Similarity_2<FT>;

  /// \param kind per node
  /// \param uncertainty per branch, of the logarithm of its scale factor
  /// \param cycles along which the scale factors are to multiply to 1, if they do so but for their uncertainty
  /// \param progress it must outlive this; if it is interrupted, equations are missing
  Exact_transitions(const Cut_map& map, const Free_points& points, const std::vector<Cut_node_kind>& kind,
                    const std::vector<double>& uncertainty, const std::vector<Exponents>& cycles, Progress& progress)
    : m_map(map),
      m_graph(map.graph),
      m_fits(map.fits),
      m_points(points),
      m_kind(kind),
      m_progress(progress),
      m_scales(m_graph, m_fits, kind, uncertainty, cycles),
      m_translation_forest(m_graph, nodes_of_kind(kind, {Cut_node_kind::BORDER, Cut_node_kind::ROTATION}), uncertainty),
      m_translation(m_graph.number_of_branches()),
      m_free(m_graph.number_of_branches() + points.size()),
      m_equations(2 * (m_graph.number_of_branches() + points.size()))
  {
  }

  /// Whether all scale factors are 1.
  bool is_isometric() const { return m_scales.are_all_1(); }

  /// Sets the isolines that are to connect cones exactly. \param lines to be kept alive
  void set_lines(const std::vector<Isoline_coincidence>& lines)
  {
    m_lines = &lines;
    m_has_equations = false;
  }

  /// Computes the transitions: with free scale factors of so many bits; or if all scale factors are 1, with
  /// translations that are multiples of the so-manieth part of the size of the map, in bits.
  void compute(const int bits)
  {
    if (!is_isometric() || !m_has_equations) {
      m_scales.compute(bits);
      collect_coefficients();
      collect_equations([this](std::size_t, const typename Equations::Row& row) { add_equation(row, 0); });
    }
    choose_free_values(bits, 1);
    if (is_isometric() && !are_on_grid()) // they have denominators that are to cancel
      choose_free_values(bits, m_equations.odd_denominator());
    compute_tree_translations();
  }

  /// Tells which lines are independent of the ones before them, clearly: of those that are not, some may follow from the
  /// others only as long as the scale factors are what they are.
  /// \param number_of_sides how many of them, the first ones, are to hold anyway
  std::vector<char> independent_lines(const std::vector<Isoline_coincidence>& lines, const std::size_t number_of_sides)
  {
    constexpr double smallest = 1. / 64;
    m_scales.compute(53);
    collect_coefficients();
    set_lines(lines);
    std::vector<char> result(lines.size(), 0);
    collect_equations([&](const std::size_t i, typename Equations::Row row) {
      result[i] = add_equation(row, i < number_of_sides ? 0 : smallest) || i < number_of_sides;
    });
    return result;
  }

  /// Tells which lines connect their cones exactly.
  std::vector<char> lines_that_hold(const std::vector<Isoline_coincidence>& lines) const
  {
    std::vector<char> result;
    Linear_function<FT> sum(m_graph.number_of_branches() + m_points.size());
    const Isoline_equation<FT> equation(m_map, m_points, m_scales.values(), m_scales.inverse_values());
    for (const Isoline_coincidence& line : lines) {
      m_progress.go_on_after(1 + line.crossed.size());
      equation.add_to(line, sum);
      result.push_back(m_equations.reduced(row(sum)).empty());
    }
    return result;
  }

  Transition transition(const int branch) const
  {
    return Transition(m_fits[branch].quarter_turns(), m_scales.values()[branch], m_translation[branch].u,
                      m_translation[branch].v);
  }

  /// The coordinates of a free point in its sector.
  std::pair<FT, FT> point(const int i) const
  {
    const Number& p = m_free[m_graph.number_of_branches() + i];
    return {p.u, p.v};
  }

  /// A coordinate of the map, on the grid of an isometric map.
  double on_grid(const double x) const { return m_unit == 0 ? x : rounded_to(x, m_unit); }

private:
  struct Coefficient {
    int branch;
    Number value;
  };

  // The linear part of the transition by which one passes an end counter-clockwise.
  Number linear_part(const Cut_graph::End& end) const
  {
    const int r = m_fits[end.branch].quarter_turns();
    if (end.is_outgoing)
      return Number{m_scales.inverse_values()[end.branch], FT(0)}.turned((4 - r) % 4);
    return Number{m_scales.values()[end.branch], FT(0)}.turned(r);
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

  static double rounded_to(const double x, const double unit)
  {
    const double n = x / unit;
    return std::abs(n) < 4503599627370496. ? std::nearbyint(n) * unit : x;
  }

  // Without a grid, a multiple of a power of two that is small against the edges of the branch.
  Number free_translation(const int branch, const double unit) const
  {
    const Plane_vector<double> t = m_fits[branch].translation(CGAL::to_double(m_scales.values()[branch]));
    int exponent;
    std::frexp(m_fits[branch].shortest_edge(), &exponent);
    const double own_unit = unit > 0 ? unit : std::ldexp(1., exponent - 32);
    return {FT(rounded_to(t.u, own_unit)), FT(rounded_to(t.v, own_unit))};
  }

  // \param factor of the unit of the grid
  void choose_free_values(const int bits, const int factor)
  {
    int exponent;
    std::frexp(m_map.size, &exponent);
    m_unit = is_isometric() ? std::ldexp(1., exponent - bits) : 0;
    const double unit = is_isometric() ? m_unit * factor : 0;
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      m_free[b] = free_translation(b, unit);
    for (int i = 0; i < m_points.size(); ++i) {
      const std::array<double, 2>& p = m_map.uv[m_points[i].corner];
      m_free[m_graph.number_of_branches() + i] =
          is_isometric() ? Number{FT(rounded_to(p[0], unit)), FT(rounded_to(p[1], unit))} : Number{FT(p[0]), FT(p[1])};
    }
    m_equations.solve([this](const int variable) -> FT& {
      Number& x = m_free[variable / 2];
      return variable % 2 == 0 ? x.u : x.v;
    });
  }

  // Whether the values are multiples of a small part of the unit.
  bool are_on_grid() const
  {
    return std::all_of(m_free.begin(), m_free.end(), [this](const Number& x) {
      return Equations::is_integer(FT(x.u / FT(m_unit)) * FT(Equations::even_denominator)) &&
             Equations::is_integer(FT(x.v / FT(m_unit)) * FT(Equations::even_denominator));
    });
  }

  bool is_line(const int node) const
  {
    return m_kind[node] == Cut_node_kind::BORDER_LINE_U || m_kind[node] == Cut_node_kind::BORDER_LINE_V;
  }

  // Of the equation of a node, what is asked for: along the border's own line nothing is.
  Number asked(const int node, Number x) const
  {
    if (m_kind[node] == Cut_node_kind::BORDER_LINE_U)
      x.v = FT(0);
    if (m_kind[node] == Cut_node_kind::BORDER_LINE_V)
      x.u = FT(0);
    return x;
  }

  void compute_tree_translations()
  {
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      m_translation[b] = m_translation_forest.is_tree(b) ? Number() : m_free[b];
    const std::vector<int>& order = m_translation_forest.order();
    for (auto node = order.rbegin(); node != order.rend(); ++node) {
      const int parent = m_translation_forest.parent_branch(*node);
      if (parent == Cut_forest::none)
        continue;
      if (is_line(*node))
        m_translation[parent] = m_free[parent];
      Number sum;
      for (const Coefficient& c : m_coefficients[*node])
        sum = sum + c.value * m_translation[c.branch];
      m_translation[parent] = m_translation[parent] - asked(*node, sum) * coefficient(*node, parent).inverse();
    }
  }

  // --- equations between what is free

  // Expresses a function of all translations by those that are free.
  void eliminate_tree(Linear_function<FT>& sum) const
  {
    for (const int node : m_translation_forest.order()) {
      const int parent = m_translation_forest.parent_branch(node);
      if (parent == Cut_forest::none || sum.weight(parent).is_zero())
        continue;
      const Number own = coefficient(node, parent), factor = sum.weight(parent) * own.inverse(),
                   determined = asked(node, factor);
      sum.set_zero(parent);
      if (is_line(node))
        sum.add(parent, (factor - determined) * own);
      for (const Coefficient& c : m_coefficients[node])
        if (c.branch != parent)
          sum.add(c.branch, -(determined * c.value));
    }
  }

  // The function as a row of real coefficients; it is cleared.
  typename Equations::Row row(Linear_function<FT>& sum) const
  {
    eliminate_tree(sum);
    typename Equations::Row result;
    std::vector<int> used = sum.used();
    std::sort(used.begin(), used.end());
    for (const int unknown : used) {
      const Number& weight = sum.weight(unknown);
      if (weight.u != FT(0))
        result.emplace_back(2 * unknown, weight.u);
      if (weight.v != FT(0))
        result.emplace_back(2 * unknown + 1, FT(-weight.v));
    }
    sum.clear();
    return result;
  }

  // Where no ground takes up what is left over, the equation of a root remains; where its root is a loop on a line, one
  // coordinate of it. Then come the isolines.
  template <typename Add>
  void collect_equations(const Add& add)
  {
    m_has_equations = true;
    m_equations.clear();
    Linear_function<FT> sum(m_graph.number_of_branches() + m_points.size());
    for (int root = 0; root < m_graph.number_of_nodes(); ++root) {
      if (m_translation_forest.root(root) != root)
        continue;
      if (!m_progress.go_on_after(100))
        return;
      for (const Number& part : {Number{FT(1), FT(0)}, Number{FT(0), FT(-1)}}) {
        if (asked(root, part).is_zero())
          continue;
        for (const Coefficient& c : m_coefficients[root])
          sum.add(c.branch, part * c.value);
        add_equation(row(sum), 0);
      }
    }
    if (m_lines == nullptr)
      return;
    const Isoline_equation<FT> equation(m_map, m_points, m_scales.values(), m_scales.inverse_values());
    for (std::size_t i = 0; i < m_lines->size(); ++i) {
      if (!m_progress.go_on_after(1000))
        return;
      equation.add_to((*m_lines)[i], sum);
      add(i, row(sum));
    }
  }

  // Adds an equation, unless what is left of it when the others are inserted is too small.
  bool add_equation(const typename Equations::Row& row, const double smallest)
  {
    constexpr double round_off = is_exact_number_type<FT> ? 0 : 1e-12; // of an equation that follows from the others
    const auto largest_of = [](const typename Equations::Row& r) {
      double result = 0;
      for (const auto& entry : r)
        result = std::max(result, std::abs(CGAL::to_double(entry.second)));
      return result;
    };
    typename Equations::Row reduced = m_equations.reduced(row);
    const double largest = largest_of(reduced);
    if (largest <= std::max(smallest, round_off) * largest_of(row))
      return false;
    const int pivot = variable_to_solve_for(reduced, largest);
    m_equations.add(std::move(reduced), pivot);
    return true;
  }

  // Of the variables with large coefficients, or without scale factors with powers of two, which keep numbers short, the
  // one that occurs least in other equations.
  int variable_to_solve_for(const typename Equations::Row& row, const double largest) const
  {
    int best = -1;
    std::pair<bool, std::size_t> best_rank;
    for (const auto& entry : row) {
      const double value = std::abs(CGAL::to_double(entry.second));
      int exponent;
      const bool is_good = is_isometric() ? std::frexp(value, &exponent) == 0.5 : value >= largest / 4;
      const std::pair<bool, std::size_t> rank(!is_good, m_equations.number_of_occurrences(entry.first));
      if (best == -1 || rank < best_rank) {
        best = entry.first;
        best_rank = rank;
      }
    }
    return best;
  }

  const Cut_map& m_map;
  const Cut_graph& m_graph;
  const std::vector<Branch_fit>& m_fits;
  const Free_points& m_points;
  const std::vector<Cut_node_kind>& m_kind;
  Progress& m_progress;
  Exact_scales<FT> m_scales;
  Cut_forest m_translation_forest;
  std::vector<Number> m_translation;                    // per branch
  std::vector<std::vector<Coefficient>> m_coefficients; // per node
  std::vector<Number> m_free; // per branch, those of the tree do not count; and per free point
  Equations m_equations;      // for the coordinates of these
  const std::vector<Isoline_coincidence>* m_lines = nullptr;
  bool m_has_equations = false; // they are those of the lines
  double m_unit = 0;            // of the grid of an isometric map
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_TRANSITIONS_H
