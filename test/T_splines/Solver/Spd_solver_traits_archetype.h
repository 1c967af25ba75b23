// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SOLVER_SPD_SOLVER_TRAITS_ARCHETYPE_H
#define T_SPLINES_TEST_SOLVER_SPD_SOLVER_TRAITS_ARCHETYPE_H

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <cmath>
#include <cstddef>
#include <vector>

/// A model of `SparseSpdSolverTraits` that offers what the concept asks for and no more: dense Cholesky. It cannot be
/// copied, and says so if it is used out of order.
class Spd_solver_traits_archetype {
public:
  using FT = double;
  using Matrix = CGAL::T_splines::Symmetric_sparse_matrix<FT>;

  Spd_solver_traits_archetype() = default;
  Spd_solver_traits_archetype(const Spd_solver_traits_archetype&) = delete;
  Spd_solver_traits_archetype(Spd_solver_traits_archetype&&) = default;
  Spd_solver_traits_archetype& operator=(const Spd_solver_traits_archetype&) = delete;
  Spd_solver_traits_archetype& operator=(Spd_solver_traits_archetype&&) = default;

  bool analyze_pattern(const Matrix& a)
  {
    m_size = static_cast<std::size_t>(a.size());
    m_is_factorized = false;
    return true;
  }

  bool factorize(const Matrix& a)
  {
    m_is_factorized = false;
    if (m_size != static_cast<std::size_t>(a.size()))
      return false;
    m_factor.assign(m_size * m_size, 0);
    for (std::size_t j = 0; j < m_size; ++j)
      for (int entry = a.column_begin[j]; entry < a.column_begin[j + 1]; ++entry)
        factor(a.row[entry], j) = a.value[entry];
    for (std::size_t j = 0; j < m_size; ++j)
      for (std::size_t i = j; i < m_size; ++i) {
        for (std::size_t k = 0; k < j; ++k)
          factor(i, j) -= factor(i, k) * factor(j, k);
        if (i == j && !(factor(j, j) > 0))
          return false;
        factor(i, j) = i == j ? std::sqrt(factor(i, j)) : factor(i, j) / factor(j, j);
      }
    return m_is_factorized = true;
  }

  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    if (!m_is_factorized || b.size() != m_size)
      return false;
    x = b;
    for (std::size_t i = 0; i < m_size; ++i) {
      for (std::size_t k = 0; k < i; ++k)
        x[i] -= factor(i, k) * x[k];
      x[i] /= factor(i, i);
    }
    for (std::size_t i = m_size; i-- > 0;) {
      for (std::size_t k = i + 1; k < m_size; ++k)
        x[i] -= factor(k, i) * x[k];
      x[i] /= factor(i, i);
    }
    return true;
  }

private:
  FT& factor(const std::size_t i, const std::size_t j) { return m_factor[i * m_size + j]; }
  const FT& factor(const std::size_t i, const std::size_t j) const { return m_factor[i * m_size + j]; }

  std::size_t m_size = 0;
  bool m_is_factorized = false;
  std::vector<FT> m_factor;
};

#endif // T_SPLINES_TEST_SOLVER_SPD_SOLVER_TRAITS_ARCHETYPE_H
