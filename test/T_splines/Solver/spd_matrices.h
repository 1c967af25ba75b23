// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SOLVER_SPD_MATRICES_H
#define T_SPLINES_TEST_SOLVER_SPD_MATRICES_H

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

/// returns L + shift I on the grid of columns x rows nodes, where L is the Laplacian of the grid's graph with random
/// weights in [1, 2]. Its row sums are `shift`, and for shift > 0 it is a positive definite M-matrix.
template <typename FT>
CGAL::T_splines::Symmetric_sparse_matrix<FT> shifted_laplacian(const int columns, const int rows, const FT shift,
                                                               const unsigned int seed = 0)
{
  std::mt19937 random(seed);
  const auto weight = [&random]() { return FT(1) + FT(random() % 1024) / FT(1024); };

  CGAL::T_splines::Symmetric_sparse_matrix<FT> a;
  std::vector<FT> degree(static_cast<std::size_t>(columns) * rows, FT(0));
  for (int j = 0; j < columns * rows; ++j) {
    const std::size_t diagonal = a.value.size();
    a.row.push_back(j);
    a.value.push_back(FT(0));
    const bool has_right = (j + 1) % columns != 0, has_upper = j + columns < columns * rows;
    for (const int i : {has_right ? j + 1 : j, has_upper ? j + columns : j})
      if (i != j) {
        const FT w = weight();
        a.row.push_back(i);
        a.value.push_back(-w);
        degree[i] += w;
        degree[j] += w;
      }
    a.value[diagonal] = degree[j] + shift;
    a.column_begin.push_back(static_cast<int>(a.row.size()));
  }
  return a;
}

template <typename FT>
std::vector<FT> random_vector(const std::size_t n, const unsigned int seed = 0)
{
  std::mt19937 random(seed);
  std::vector<FT> result(n);
  std::generate(result.begin(), result.end(), [&random]() { return FT(random() % 2001) / FT(1000) - FT(1); });
  return result;
}

template <typename FT>
FT largest_absolute(const std::vector<FT>& v)
{
  using std::abs;
  FT result(0);
  for (const FT& number : v)
    result = std::max<FT>(result, abs(number));
  return result;
}

/// returns max |b - A x| / (max |A| max |x| + max |b|): a few ulp for a backward stable solver.
template <typename FT>
FT backward_error(const CGAL::T_splines::Symmetric_sparse_matrix<FT>& a, const std::vector<FT>& x,
                  const std::vector<FT>& b)
{
  std::vector<FT> residual;
  a.multiply(x, residual);
  for (std::size_t i = 0; i < b.size(); ++i)
    residual[i] -= b[i];
  return largest_absolute(residual) / (largest_absolute(a.value) * largest_absolute(x) + largest_absolute(b));
}

#endif // T_SPLINES_TEST_SOLVER_SPD_MATRICES_H
