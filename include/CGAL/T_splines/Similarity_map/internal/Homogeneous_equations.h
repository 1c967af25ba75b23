// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_HOMOGENEOUS_EQUATIONS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_HOMOGENEOUS_EQUATIONS_H

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Sparse linear equations with right-hand side 0, each solved for one of its variables: in reduced echelon form.
/// \tparam FT a field
template <typename FT>
class Homogeneous_equations {
public:
  static constexpr int none = -1;
  using Row = std::vector<std::pair<int, FT>>; ///< coefficients by variables, ascending, none of them zero

  explicit Homogeneous_equations(const int number_of_variables)
    : m_row_of_variable(number_of_variables, none),
      m_rows_with(number_of_variables)
  {
  }

  void clear()
  {
    std::fill(m_row_of_variable.begin(), m_row_of_variable.end(), none);
    for (std::vector<int>& rows : m_rows_with)
      rows.clear();
    m_rows.clear();
    m_pivots.clear();
  }

  /// How many equations are about to change if the next one is solved for a variable, or a few more.
  std::size_t number_of_occurrences(const int variable) const { return m_rows_with[variable].size(); }

  int number_of_equations() const { return static_cast<int>(m_rows.size()); }

  /// The row without the variables that the equations are solved for: empty if it follows from them.
  Row reduced(const Row& row) const
  {
    Row result = row;
    for (const auto& [variable, coefficient] : row)
      if (m_row_of_variable[variable] != none)
        result = combination(result, m_rows[m_row_of_variable[variable]], FT(-coefficient));
    return result;
  }

  /// Adds an equation that is reduced, solved for a variable.
  void add(Row row, const int pivot)
  {
    const FT inverse = FT(1) / coefficient(row, pivot);
    for (auto& entry : row)
      entry.second = FT(entry.second * inverse);
    for (const int i : m_rows_with[pivot]) {
      const FT factor = coefficient(m_rows[i], pivot);
      if (factor == FT(0))
        continue;
      for (const auto& entry : row)
        if (coefficient(m_rows[i], entry.first) == FT(0))
          m_rows_with[entry.first].push_back(i);
      m_rows[i] = combination(m_rows[i], row, FT(-factor));
    }
    m_rows_with[pivot].clear();
    m_row_of_variable[pivot] = number_of_equations();
    for (const auto& entry : row)
      m_rows_with[entry.first].push_back(number_of_equations());
    m_rows.push_back(std::move(row));
    m_pivots.push_back(pivot);
  }

  bool is_free(const int variable) const { return m_row_of_variable[variable] == none; }

  /// The equation that is solved for a variable, whose coefficient is 1. \pre `!is_free(variable)`
  const Row& row_of(const int variable) const { return m_rows[m_row_of_variable[variable]]; }

  /// Computes the variables that the equations are solved for from the others. \param value of a variable, to be changed
  template <typename Value>
  void solve(const Value& value) const
  {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      FT sum(0);
      for (const auto& [variable, coefficient] : m_rows[i])
        if (variable != m_pivots[i])
          sum = FT(sum - coefficient * value(variable));
      value(m_pivots[i]) = sum;
    }
  }

  static constexpr int even_denominator = 256;

  /// A small odd number by which all coefficients become multiples of 1 / even_denominator, or 1 if there is none.
  ///
  /// If the free variables are multiples of this, the others are multiples of 1 / even_denominator.
  int odd_denominator() const
  {
    constexpr int largest = 63;
    int result = 1;
    for (const Row& row : m_rows)
      for (const auto& entry : row)
        while (!is_integer(FT(entry.second * FT(even_denominator * result))))
          if ((result += 2) > largest)
            return 1;
    return result;
  }

  static bool is_integer(const FT& x)
  {
    const double rounded = std::nearbyint(CGAL::to_double(x));
    return FT(rounded) == x;
  }

private:
  static FT coefficient(const Row& row, const int variable)
  {
    const auto place = std::lower_bound(row.begin(), row.end(), variable,
                                        [](const auto& entry, const int v) { return entry.first < v; });
    return place == row.end() || place->first != variable ? FT(0) : place->second;
  }

  /// a + factor b.
  static Row combination(const Row& a, const Row& b, const FT& factor)
  {
    Row result;
    result.reserve(a.size() + b.size());
    for (auto p = a.begin(), q = b.begin(); p != a.end() || q != b.end();) {
      if (q == b.end() || (p != a.end() && p->first < q->first))
        result.push_back(*p++);
      else if (p == a.end() || q->first < p->first) {
        result.emplace_back(q->first, FT(factor * q->second));
        ++q;
      }
      else {
        FT sum(p->second + factor * q->second);
        if (sum != FT(0))
          result.emplace_back(p->first, std::move(sum));
        ++p, ++q;
      }
    }
    return result;
  }

  std::vector<Row> m_rows;
  std::vector<int> m_pivots;                 // per row
  std::vector<int> m_row_of_variable;        // none for the free ones
  std::vector<std::vector<int>> m_rows_with; // per variable: all that have it, and some that had it
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_HOMOGENEOUS_EQUATIONS_H
