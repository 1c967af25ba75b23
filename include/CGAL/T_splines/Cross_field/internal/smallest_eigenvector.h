// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMALLEST_EIGENVECTOR_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMALLEST_EIGENVECTOR_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A unit eigenvector of the largest eigenvalue of a symmetric tridiagonal matrix with non-negative eigenvalues, by
/// repeated squaring of the matrix.
inline std::vector<double> largest_eigenvector_of_tridiagonal(const std::vector<double>& diagonal,
                                                              const std::vector<double>& subdiagonal)
{
  const std::size_t n = diagonal.size();
  std::vector<double> matrix(n * n, 0.), square(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    matrix[i * n + i] = diagonal[i];
    if (i + 1 < n)
      matrix[i * n + i + 1] = matrix[(i + 1) * n + i] = subdiagonal[i];
  }
  // 2^40 steps of the power method: only eigenvalues that agree to twelve digits stay mixed.
  for (int squaring = 0; squaring < 40; ++squaring) {
    double trace = 0;
    for (std::size_t i = 0; i < n; ++i)
      trace += matrix[i * n + i];
    std::fill(square.begin(), square.end(), 0.);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < n; ++j)
          square[i * n + j] += (matrix[i * n + k] / trace) * (matrix[k * n + j] / trace);
    matrix.swap(square);
  }
  std::size_t largest = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (matrix[i * n + i] > matrix[largest * n + largest])
      largest = i;
  std::vector<double> result(matrix.begin() + static_cast<std::ptrdiff_t>(largest * n),
                             matrix.begin() + static_cast<std::ptrdiff_t>((largest + 1) * n));
  const double norm = std::sqrt(std::inner_product(result.begin(), result.end(), result.begin(), 0.));
  for (double& entry : result)
    entry /= norm;
  return result;
}

/// computes an eigenvector of the smallest eigenvalue of K x = mu M x by Lanczos' method on M^(1/2) K^-1 M^(1/2): inverse power
/// iteration that keeps all its iterates and takes the best vector of their span.
/// \param solver has factorized K, symmetric and positive definite
/// \param mass the diagonal of M, positive
/// \param x on entry a start vector, on return the eigenvector, with x^T M x = 1
/// \param eigenvalue mu
/// \return `false` if the solver fails.
/// Complexity: at most `number_of_solves` solves.
template <typename SolverTraits>
bool smallest_eigenvector(const SolverTraits& solver, const std::vector<double>& mass, const int number_of_solves,
                          std::vector<double>& x, double& eigenvalue)
{
  const std::size_t n = mass.size();
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
  };
  const auto add = [](std::vector<double>& a, const double factor, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += factor * b[i];
  };
  std::vector<double> root(n), right_hand_side(n), image(n), diagonal, subdiagonal;
  std::transform(mass.begin(), mass.end(), root.begin(), [](const double m) { return std::sqrt(m); });
  std::vector<std::vector<double>> basis;
  double norm = std::sqrt(dot(x, x));
  while (static_cast<int>(basis.size()) < number_of_solves && basis.size() < n) {
    for (double& entry : x)
      entry /= norm;
    basis.push_back(x);
    for (std::size_t i = 0; i < n; ++i)
      right_hand_side[i] = root[i] * x[i];
    if (!solver.solve(right_hand_side, image))
      return false;
    for (std::size_t i = 0; i < n; ++i)
      x[i] = root[i] * image[i];
    diagonal.push_back(dot(x, basis.back()));
    for (int pass = 0; pass < 2; ++pass) // twice is enough
      for (const std::vector<double>& previous : basis)
        add(x, -dot(x, previous), previous);
    norm = std::sqrt(dot(x, x));
    subdiagonal.push_back(norm);
    if (!(norm > 1e-10 * diagonal.front()))
      break;
  }
  const std::vector<double> coordinates = largest_eigenvector_of_tridiagonal(diagonal, subdiagonal);
  x.assign(n, 0.);
  double inverse = 0;
  for (std::size_t k = 0; k < basis.size(); ++k) {
    add(x, coordinates[k], basis[k]);
    inverse += coordinates[k] * (diagonal[k] * coordinates[k] +
                                 (k + 1 < basis.size() ? 2 * subdiagonal[k] * coordinates[k + 1] : 0.));
  }
  for (std::size_t i = 0; i < n; ++i)
    x[i] /= root[i];
  eigenvalue = 1 / inverse;
  return true;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SMALLEST_EIGENVECTOR_H
