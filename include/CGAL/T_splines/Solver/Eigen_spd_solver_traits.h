// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_EIGEN_SPD_SOLVER_TRAITS_H
#define CGAL_T_SPLINES_SOLVER_EIGEN_SPD_SOLVER_TRAITS_H

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/internal/Interruptible_ldlt.h>
#include <CGAL/T_splines/Solver/internal/is_finite.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSolver
/// solves sparse symmetric positive definite systems with a solver of Eigen.
///
/// Any solver of Eigen will do that offers `analyzePattern()`, `factorize()`, `solve()` and `info()` and reads the
/// lower triangle, e.g. `Eigen::SimplicialLLT` or `Eigen::ConjugateGradient`; with Eigen's wrapper modules also
/// Pardiso's and Accelerate's. Of an iterative solver, `factorize()` makes the preconditioner.
///
/// Copies share one solver, as those of `CGAL::Eigen_solver_traits` do.
///
/// \cgalModels{SparseSpdSolverTraits}
///
/// \tparam EigenSolver a sparse solver of Eigen whose `MatrixType` is a column-major `Eigen::SparseMatrix`.
template <typename EigenSolver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>
class Eigen_spd_solver_traits {
  using Matrix = typename EigenSolver::MatrixType;
  static_assert(!Matrix::IsRowMajor, "the matrix of the solver has to be column-major");

public:
  using FT = typename EigenSolver::Scalar; ///< number type

  /// prepares for matrices with the pattern of `a`: ordering and symbolic factorization.
  /// \return `false` if the solver fails.
  bool analyze_pattern(const Symmetric_sparse_matrix<FT>& a)
  {
    m_state->matrix =
        Eigen::Map<const Eigen::SparseMatrix<FT>>(a.size(), a.size(), static_cast<int>(a.number_of_entries()),
                                                  a.column_begin.data(), a.row.data(), a.value.data());
    m_state->solver.analyzePattern(m_state->matrix);
    return m_state->solver.info() == Eigen::Success;
  }

  /// factorizes `a`. \pre `analyze_pattern()` has been called with a matrix of the same pattern.
  /// \param a symmetric and positive definite
  /// \param go_on if it is not empty, `Eigen::SimplicialLDLT` asks it every few milliseconds, and fails if it says no.
  /// Other solvers do not ask.
  /// \return `false` if `a` is not finite, or not positive definite to working precision; an iterative solver notices the
  /// latter in `solve()`, or not at all.
  bool factorize(const Symmetric_sparse_matrix<FT>& a, [[maybe_unused]] const std::function<bool()>& go_on = nullptr)
  {
    CGAL_precondition(m_state->matrix.rows() == a.size() &&
                      static_cast<std::size_t>(m_state->matrix.nonZeros()) == a.number_of_entries());
    if (!internal::is_finite(a.value)) // an infinite pivot would pass for a zero in the solution
      return false;
    std::copy(a.value.begin(), a.value.end(), m_state->matrix.valuePtr());
    if constexpr (std::is_same<Solver, EigenSolver>::value) {
      m_state->solver.factorize(m_state->matrix);
      return m_state->solver.info() == Eigen::Success;
    }
    else
      return m_state->solver.factorize(m_state->matrix, go_on);
  }

  /// solves A x = b with the last factorization. \pre It succeeded.
  /// \param b as many numbers as A has rows; not the vector `x`
  /// \param x the solution; its value on entry is not used
  /// \return `false` if an iterative solver does not converge, or if a number of `x` is not finite.
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    CGAL_precondition(b.size() == static_cast<std::size_t>(m_state->matrix.rows()) && &b != &x);
    x.resize(b.size());
    const Eigen::Map<const Vector> right_hand_side(b.data(), static_cast<Eigen::Index>(b.size()));
    Eigen::Map<Vector>(x.data(), static_cast<Eigen::Index>(x.size())) = m_state->solver.solve(right_hand_side);
    return m_state->solver.info() == Eigen::Success && internal::is_finite(x);
  }

  /// returns the solver, for its own settings such as the tolerance of an iterative one.
  EigenSolver& solver() { return m_state->solver; }

private:
  using Solver = typename internal::Interruptible_solver<EigenSolver>::type;
  using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;

  // Eigen's iterative solvers point into the matrix that they were given last: both live together, at one address.
  struct State {
    Matrix matrix;
    Solver solver;
  };

  std::shared_ptr<State> m_state = std::make_shared<State>();
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_T_SPLINES_SOLVER_EIGEN_SPD_SOLVER_TRAITS_H
