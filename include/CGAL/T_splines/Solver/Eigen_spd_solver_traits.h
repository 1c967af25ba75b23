// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_EIGEN_SPD_SOLVER_TRAITS_H
#define CGAL_T_SPLINES_SOLVER_EIGEN_SPD_SOLVER_TRAITS_H

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace CGAL {
namespace T_splines {

/// solves sparse symmetric positive definite systems with a direct solver of Eigen.
///
/// Any solver of Eigen will do that offers `analyzePattern()`, `factorize()`, `solve()` and `info()` and reads the
/// lower triangle, e.g. `Eigen::SimplicialLLT` or `Eigen::ConjugateGradient`; with Eigen's wrapper modules also
/// Pardiso's and Accelerate's.
/// \cgalModels `SparseSpdSolverTraits`
/// \tparam EigenSolver a sparse solver of Eigen whose matrix type is column-major.
template <typename EigenSolver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>
class Eigen_spd_solver_traits {
public:
  using FT = typename EigenSolver::Scalar;

  /// prepares for matrices with the pattern of `a`: ordering and symbolic factorization.
  /// \return `false` if the solver fails.
  bool analyze_pattern(const Symmetric_sparse_matrix<FT>& a)
  {
    m_solver->analyzePattern(view(a));
    return true;
  }

  /// factorizes `a`. \pre `analyze_pattern()` has been called with a matrix of the same pattern.
  /// \return `false` if `a` is not positive definite to working precision.
  bool factorize(const Symmetric_sparse_matrix<FT>& a)
  {
    m_solver->factorize(view(a));
    return m_solver->info() == Eigen::Success;
  }

  /// solves A x = b with the last factorization.
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    x.resize(b.size());
    const Eigen::Map<const Vector> right_hand_side(b.data(), static_cast<Eigen::Index>(b.size()));
    Eigen::Map<Vector>(x.data(), static_cast<Eigen::Index>(x.size())) = m_solver->solve(right_hand_side);
    return m_solver->info() == Eigen::Success;
  }

private:
  using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;
  using Matrix = Eigen::SparseMatrix<FT, Eigen::ColMajor, int>;

  static Matrix view(const Symmetric_sparse_matrix<FT>& a)
  {
    return Eigen::Map<const Matrix>(a.size(), a.size(), static_cast<int>(a.number_of_entries()),
                                    a.column_begin.data(), a.row.data(), a.value.data());
  }

  // Eigen's solvers cannot be copied or moved; traits can be moved.
  std::unique_ptr<EigenSolver> m_solver = std::make_unique<EigenSolver>();
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_EIGEN_SPD_SOLVER_TRAITS_H
