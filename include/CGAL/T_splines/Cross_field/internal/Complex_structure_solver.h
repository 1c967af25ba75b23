// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_COMPLEX_STRUCTURE_SOLVER_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_COMPLEX_STRUCTURE_SOLVER_H

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/default_solver.h>

#include <CGAL/Named_function_parameters.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#endif

#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

#ifdef CGAL_EIGEN3_ENABLED

/// Solves real systems that are complex ones in disguise, as those of `Connection_laplacian`: rows and columns come in pairs, and
/// the blocks have the form (a, -b), (b, a). The complex matrix is half as large and takes half as long.
/// \cgalModels `SparseSpdSolverTraits`
class Complex_structure_solver {
  using Complex = std::complex<double>;
  using Matrix = Eigen::SparseMatrix<Complex>;
  using Vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

public:
  using FT = double;

  Complex_structure_solver() = default;
  Complex_structure_solver(const Complex_structure_solver&) = delete;
  Complex_structure_solver& operator=(const Complex_structure_solver&) = delete;

  bool analyze_pattern(const Symmetric_sparse_matrix<double>& a)
  {
    m_solver.analyzePattern(complex_matrix(a));
    return true;
  }

  bool factorize(const Symmetric_sparse_matrix<double>& a)
  {
    m_solver.factorize(complex_matrix(a));
    return m_solver.info() == Eigen::Success && (m_solver.vectorD().real().array() > 0).all();
  }

  bool solve(const std::vector<double>& b, std::vector<double>& x) const
  {
    // An array of complex numbers is one of pairs of real numbers ([complex.numbers] of the C++ standard).
    const auto size = static_cast<Eigen::Index>(b.size() / 2);
    x.resize(b.size());
    const Eigen::Map<const Vector> right_hand_side(reinterpret_cast<const Complex*>(b.data()), size);
    Eigen::Map<Vector> solution(reinterpret_cast<Complex*>(x.data()), size);
    solution = m_solver.solve(right_hand_side);
    return solution.allFinite();
  }

private:
  // The even columns: the diagonal entry, a zero is not stored, and pairs of real and imaginary parts.
  static Matrix complex_matrix(const Symmetric_sparse_matrix<double>& a)
  {
    const int n = a.size() / 2;
    std::vector<int> column_begin(1, 0), row;
    std::vector<Complex> value;
    for (int j = 0; j < n; ++j) {
      int entry = a.column_begin[2 * j];
      row.push_back(j);
      value.emplace_back(a.value[entry]);
      for (++entry; entry < a.column_begin[2 * j + 1]; entry += 2) {
        row.push_back(a.row[entry] / 2);
        value.emplace_back(a.value[entry], a.value[entry + 1]);
      }
      column_begin.push_back(static_cast<int>(row.size()));
    }
    return Eigen::Map<const Matrix>(n, n, static_cast<Eigen::Index>(row.size()), column_begin.data(), row.data(), value.data());
  }

  Eigen::SimplicialLDLT<Matrix> m_solver;
};

#endif // CGAL_EIGEN3_ENABLED

/// returns the solver of the named parameter `sparse_linear_solver`; without the parameter, one that makes use of the complex structure.
template <typename NamedParameters>
decltype(auto) complex_structure_solver(const NamedParameters& np)
{
#ifdef CGAL_EIGEN3_ENABLED
  using Parameter = decltype(CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::sparse_linear_solver));
  if constexpr (std::is_same_v<std::decay_t<Parameter>, CGAL::internal_np::Param_not_found>)
    return Complex_structure_solver();
  else
    return sparse_linear_solver(np);
#else
  return sparse_linear_solver(np);
#endif
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_COMPLEX_STRUCTURE_SOLVER_H
