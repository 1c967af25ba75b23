// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_LINEAR_PARAMETERS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_LINEAR_PARAMETERS_H

#include <CGAL/T_splines/Similarity_map/internal/Homogeneous_equations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// All solutions of homogeneous linear equations: the unknowns x = Z z as functions of free parameters z.
///
/// If all coefficients of the equations are 0 or +-1, as those of seams without scaling and of isolines are, those of Z
/// are short dyadic numbers in practice: pivots are powers of two where there is a choice, and nothing is rounded.
class Linear_parameters {
public:
  using Row = Homogeneous_equations<double>::Row; ///< (unknown, coefficient), by ascending unknowns
  struct Term {
    int parameter;
    double coefficient;
  };

  /// There are no equations yet.
  explicit Linear_parameters(const int number_of_unknowns)
    : m_number_of_unknowns(number_of_unknowns),
      m_equations(number_of_unknowns)
  {
    index_parameters();
  }

  /// Adds equations, each with 0 on the right, and finds the parameters anew.
  /// \return the number of equations that followed from others, up to round-off
  int add(const std::vector<Row>& rows)
  {
    int number_of_dependent = 0;
    for (const Row& row : rows)
      number_of_dependent += add(row) ? 0 : 1;
    index_parameters();
    return number_of_dependent;
  }

  int number_of_unknowns() const { return m_number_of_unknowns; }
  int number_of_parameters() const { return static_cast<int>(m_unknown_of_parameter.size()); }

  /// Calls `visit(term)` for the terms of an unknown.
  template <typename Visit>
  void for_each_term(const int unknown, const Visit& visit) const
  {
    for (int i = m_begin[unknown]; i < m_begin[unknown + 1]; ++i)
      visit(m_terms[i]);
  }

  /// x = Z z.
  std::vector<double> unknowns(const std::vector<double>& z) const
  {
    std::vector<double> x(number_of_unknowns(), 0.);
    for (int i = 0; i < number_of_unknowns(); ++i)
      for_each_term(i, [&](const Term& term) { x[i] += term.coefficient * z[term.parameter]; });
    return x;
  }

  /// Z^T x: the derivatives by parameters from those by unknowns.
  std::vector<double> derivatives(const std::vector<double>& x) const
  {
    std::vector<double> z(number_of_parameters(), 0.);
    for (int i = 0; i < number_of_unknowns(); ++i)
      for_each_term(i, [&](const Term& term) { z[term.parameter] += term.coefficient * x[i]; });
    return z;
  }

  /// The parameters of unknowns that satisfy the equations: these determine the others.
  std::vector<double> parameters(const std::vector<double>& x) const
  {
    std::vector<double> z(number_of_parameters());
    for (std::size_t i = 0; i < z.size(); ++i)
      z[i] = x[m_unknown_of_parameter[i]];
    return z;
  }

  /// Whether the equations force two unknowns to be the same.
  bool are_equal(const int a, const int b) const
  {
    Row row{{(std::min)(a, b), 1.}, {(std::max)(a, b), -1.}};
    return a == b || largest(m_equations.reduced(row)) < round_off;
  }

private:
  static constexpr double round_off = 1e-11; // of sums of a few coefficients of order 1

  static double largest(const Row& row)
  {
    double result = 0;
    for (const auto& entry : row)
      result = (std::max)(result, std::abs(entry.second));
    return result;
  }

  bool add(const Row& row)
  {
    constexpr double dependent = 1e-7; // scale factors are known to some 1e-12, and a clear equation has some 1e-3 left
    Row reduced = m_equations.reduced(row);
    const double size = largest(reduced);
    if (!(size > dependent * largest(row)))
      return false;
    reduced.erase(std::remove_if(reduced.begin(), reduced.end(),
                                 [size](const auto& entry) { return std::abs(entry.second) < round_off * size; }),
                  reduced.end());
    const int pivot = pivot_of(reduced, size);
    m_equations.add(std::move(reduced), pivot);
    return true;
  }

  // Of the unknowns with large coefficients the one with the fewest occurrences; powers of two come first.
  int pivot_of(const Row& row, const double size) const
  {
    constexpr double large = 0.1; // by the largest one
    int best = -1;
    std::pair<bool, std::size_t> best_rank;
    for (const auto& [unknown, coefficient] : row) {
      if (std::abs(coefficient) < large * size)
        continue;
      int exponent;
      const bool is_power_of_two = std::abs(std::frexp(coefficient, &exponent)) == 0.5;
      const std::pair<bool, std::size_t> rank(!is_power_of_two, m_equations.number_of_occurrences(unknown));
      if (best == -1 || rank < best_rank) {
        best = unknown;
        best_rank = rank;
      }
    }
    return best;
  }

  void index_parameters()
  {
    std::vector<int> parameter(m_number_of_unknowns, -1);
    m_unknown_of_parameter.clear();
    for (int i = 0; i < m_number_of_unknowns; ++i)
      if (m_equations.is_free(i)) {
        parameter[i] = number_of_parameters();
        m_unknown_of_parameter.push_back(i);
      }
    m_begin.assign(1, 0);
    m_terms.clear();
    for (int i = 0; i < m_number_of_unknowns; ++i) {
      if (m_equations.is_free(i))
        m_terms.push_back({parameter[i], 1.});
      else
        for (const auto& [unknown, coefficient] : m_equations.row_of(i))
          if (unknown != i && std::abs(coefficient) > round_off)
            m_terms.push_back({parameter[unknown], -coefficient});
      m_begin.push_back(static_cast<int>(m_terms.size()));
    }
  }

  int m_number_of_unknowns;
  Homogeneous_equations<double> m_equations;
  std::vector<int> m_unknown_of_parameter;
  std::vector<int> m_begin; // of the terms of an unknown
  std::vector<Term> m_terms;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_LINEAR_PARAMETERS_H
