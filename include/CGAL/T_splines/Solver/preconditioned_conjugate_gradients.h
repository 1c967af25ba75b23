// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_PRECONDITIONED_CONJUGATE_GRADIENTS_H
#define CGAL_T_SPLINES_SOLVER_PRECONDITIONED_CONJUGATE_GRADIENTS_H

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSolver
/// The vectors that `preconditioned_conjugate_gradients()` works with; passed again, they are not allocated again.
template <typename FT>
struct Conjugate_gradients_workspace {
  std::vector<FT> residual, ///< b - A x
      preconditioned,       ///< the residual, solved with the factorization
      search,               ///< the direction of the step
      image;                ///< A times the direction
};

/// \ingroup PkgTSplinesSolver
/// solves A x = b for a symmetric positive definite A by conjugate gradients, preconditioned with a factorization of a
/// nearby matrix.
///
/// With the factorization of A itself one iteration does. An x that misses the tolerance, because the iterations were
/// not enough, the preconditioner failed or A is not positive definite, is still the best of its Krylov space.
///
/// \tparam Matrix has `multiply(const std::vector<FT>& x, std::vector<FT>& y) const`, such as `Symmetric_sparse_matrix<FT>`
/// \tparam SolverTraits a model of `SparseSpdSolverTraits` with this `FT`
/// \param a the matrix A
/// \param preconditioner holds the factorization
/// \param b the right-hand side; not the vector `x`
/// \param x the solution; its value on entry is not used
/// \param relative_tolerance bound on |b - A x| / |b|, where b - A x is the residual that the iteration updates
/// \param maximum_number_of_iterations the iteration ends after so many even if the tolerance is not met
/// \param workspace is resized as needed, its contents do not matter
/// \return the number of iterations; each is one solve with the factorization and one product with A.
template <typename Matrix, typename SolverTraits, typename FT>
int preconditioned_conjugate_gradients(const Matrix& a, const SolverTraits& preconditioner, const std::vector<FT>& b,
                                       std::vector<FT>& x, const FT relative_tolerance,
                                       const int maximum_number_of_iterations,
                                       Conjugate_gradients_workspace<FT>& workspace)
{
  CGAL_precondition(&b != &x);
  const std::size_t n = b.size();
  const auto dot = [n](const std::vector<FT>& p, const std::vector<FT>& q) {
    FT sum(0);
    for (std::size_t i = 0; i < n; ++i)
      sum += p[i] * q[i];
    return sum;
  };
  std::vector<FT>&r = workspace.residual, &z = workspace.preconditioned, &p = workspace.search, &q = workspace.image;
  x.assign(n, FT(0));
  r = b;
  FT r_r = dot(r, r), r_z(0);
  const FT goal = relative_tolerance * relative_tolerance * r_r;
  int iterations = 0;
  while (iterations < maximum_number_of_iterations && r_r > goal && preconditioner.solve(r, z)) {
    const FT previous_r_z = r_z;
    r_z = dot(r, z);
    if (iterations == 0)
      p = z;
    else {
      const FT beta = r_z / previous_r_z;
      for (std::size_t i = 0; i < n; ++i)
        p[i] = z[i] + beta * p[i];
    }
    a.multiply(p, q);
    ++iterations;
    const FT curvature = dot(p, q);
    if (!(curvature > FT(0)))
      break;
    const FT alpha = r_z / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
    }
    r_r = dot(r, r);
  }
  return iterations;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_PRECONDITIONED_CONJUGATE_GRADIENTS_H
