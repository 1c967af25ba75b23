// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_CHOLMOD_SPD_SOLVER_TRAITS_H
#define CGAL_T_SPLINES_SOLVER_CHOLMOD_SPD_SOLVER_TRAITS_H

#ifdef CGAL_T_SPLINES_WITH_CHOLMOD

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/internal/is_finite.h>

#include <CGAL/assertions.h>

#include <cholmod.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSolver
/// solves sparse symmetric positive definite systems with CHOLMOD's supernodal Cholesky factorization.
///
/// Matrices and vectors are passed without copies. The order of elimination is by approximate minimum degree. Nested
/// dissection saves a quarter of the time of a factorization (on triangle meshes with 360 thousand vertices), but takes
/// as long as two factorizations itself: it pays where one pattern is factorized ten times. Choose it with
/// `parameters().method[0].ordering = CHOLMOD_METIS`.
///
/// CHOLMOD calls BLAS. On meshes the supernodes are too small for threads, and threads that wait for each other on a busy
/// machine cost a multiple: set `OPENBLAS_NUM_THREADS=1` or what other libraries have instead.
///
/// The header is empty unless `CGAL_T_SPLINES_WITH_CHOLMOD` is defined; the CMake target `T_splines::Cholmod_support`
/// does this. Copies share one solver. Nothing is printed.
///
/// \cgalModels{SparseSpdSolverTraits}
class Cholmod_spd_solver_traits {
public:
  using FT = double; ///< number type

  /// prepares for matrices with the pattern of `a`: ordering and symbolic factorization.
  /// \return `false` if memory, or the range of the indices, does not suffice for the factor.
  bool analyze_pattern(const Symmetric_sparse_matrix<FT>& a)
  {
    m_state->reset();
    cholmod_sparse matrix = view(a);
    m_state->factor = cholmod_analyze(&matrix, &m_state->common);
    return m_state->factor != nullptr;
  }

  /// factorizes `a`. \pre `analyze_pattern()` has been called with a matrix of the same pattern, and succeeded.
  /// \return `false` if `a` is not finite, or not positive definite to working precision, or memory does not suffice.
  bool factorize(const Symmetric_sparse_matrix<FT>& a)
  {
    CGAL_precondition(m_state->factor != nullptr && m_state->factor->n == static_cast<std::size_t>(a.size()));
    if (!internal::is_finite(a.value)) // an infinite pivot would pass for a zero in the solution
      return false;
    cholmod_sparse matrix = view(a);
    // A matrix that is not positive definite leaves the return value true and `minor`, the first bad column, below n.
    return cholmod_factorize(&matrix, m_state->factor, &m_state->common) != 0 && m_state->common.status == CHOLMOD_OK &&
           m_state->factor->minor == m_state->factor->n;
  }

  /// solves A x = b with the last factorization. \pre It succeeded.
  /// \param b as many numbers as A has rows; not the vector `x`
  /// \param x the solution; its value on entry is not used
  /// \return `false` if memory does not suffice, or if a number of `x` is not finite.
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    CGAL_precondition(m_state->factor != nullptr && m_state->factor->n == b.size() && &b != &x);
    x.resize(b.size());
    cholmod_dense right_hand_side = view(b), solution = view(x);
    cholmod_dense* solution_handle = &solution; // stays: it has the size that CHOLMOD asks for
    const bool is_solved = cholmod_solve2(CHOLMOD_A, m_state->factor, &right_hand_side, nullptr, &solution_handle,
                                          nullptr, &m_state->workspace_y, &m_state->workspace_e, &m_state->common) != 0;
    CGAL_assertion(solution_handle == &solution);
    return is_solved && internal::is_finite(x);
  }

  /// returns CHOLMOD's parameters; changes hold from the next `analyze_pattern()` on.
  cholmod_common& parameters() { return m_state->common; }

private:
  struct State {
    cholmod_common common;
    cholmod_factor* factor = nullptr;
    cholmod_dense* workspace_y = nullptr; // of cholmod_solve2()
    cholmod_dense* workspace_e = nullptr;

    State()
    {
      cholmod_start(&common);
      common.supernodal = CHOLMOD_SUPERNODAL;
      common.nmethods = 1;
      common.method[0].ordering = CHOLMOD_AMD;
      common.print = 0;
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State()
    {
      reset();
      cholmod_finish(&common);
    }

    void reset()
    {
      cholmod_free_factor(&factor, &common);
      cholmod_free_dense(&workspace_y, &common);
      cholmod_free_dense(&workspace_e, &common);
    }
  };

  // CHOLMOD's structures know no const; what they point to here is only read.
  static cholmod_sparse view(const Symmetric_sparse_matrix<FT>& a)
  {
    cholmod_sparse matrix = {};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(a.size());
    matrix.nzmax = a.number_of_entries();
    matrix.p = const_cast<int*>(a.column_begin.data());
    matrix.i = const_cast<int*>(a.row.data());
    matrix.x = const_cast<FT*>(a.value.data());
    matrix.stype = -1; // symmetric, the lower triangle is stored
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
  }

  static cholmod_dense view(const std::vector<FT>& v)
  {
    cholmod_dense vector = {};
    vector.nrow = vector.nzmax = vector.d = v.size();
    vector.ncol = 1;
    vector.x = const_cast<FT*>(v.data());
    vector.xtype = CHOLMOD_REAL;
    vector.dtype = CHOLMOD_DOUBLE;
    return vector;
  }

  std::shared_ptr<State> m_state = std::make_shared<State>();
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_WITH_CHOLMOD

#endif // CGAL_T_SPLINES_SOLVER_CHOLMOD_SPD_SOLVER_TRAITS_H
