// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `SparseSpdSolverTraits` describes what the algorithms of this package ask of a solver for sparse symmetric
positive definite linear systems. Analysis of the pattern, numeric factorization and solution are apart, because one
analysis serves many factorizations, and one factorization serves many right-hand sides.

Matrices are `CGAL::T_splines::Symmetric_sparse_matrix<FT>`, the lower triangle in compressed columns; vectors are
`std::vector<FT>`. A model keeps what it needs of a matrix: the caller may change or destroy it after any call.

A factorization of a large matrix takes seconds. A model may have one more function, `bool factorize(a, go_on)` with a
`const std::function<bool()>& go_on`, which asks `go_on()` every few milliseconds whether to go on and fails if it says no.
Algorithms with a visitor call it then. Without it, they ask the visitor before and after a factorization.

A model reports failure by its return values. It throws nothing but `std::bad_alloc` and prints nothing. No function
may run in two threads on one object, nor on objects that share their state.

\cgalRefines{DefaultConstructible}
\cgalRefines{MoveConstructible}

A model that is also `CopyConstructible` can be passed by value to the named parameter `sparse_linear_solver`; others
are passed by `std::ref()`. Copies may share their state: an algorithm works with one of them.

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Eigen_spd_solver_traits}
\cgalHasModels{CGAL::T_splines::Cholmod_spd_solver_traits}
\cgalHasModelsEnd
*/
class SparseSpdSolverTraits {
public:
  /// \name Types
  /// @{

  /*!
  the number type of matrices and vectors, a floating-point type.
  */
  typedef unspecified_type FT;

  /// @}

  /// \name Operations
  /// @{

  /*!
  prepares for matrices with the pattern of `a`: the same `column_begin` and `row`. The values are not read. What was
  analyzed and factorized before is forgotten.
  \return `false` if this fails, for want of memory for instance.
  */
  bool analyze_pattern(const CGAL::T_splines::Symmetric_sparse_matrix<FT>& a);

  /*!
  factorizes `a`; an iterative model makes its preconditioner. May be called any number of times after one
  `analyze_pattern()`, also after a failure.
  \pre The last call of `analyze_pattern()` succeeded and had a matrix of the same pattern.
  \return `false` if `a` is not finite or not positive definite to working precision, as far as the model notices. A
  direct model notices.
  */
  bool factorize(const CGAL::T_splines::Symmetric_sparse_matrix<FT>& a);

  /*!
  solves A x = b, where A is the matrix of the last call of `factorize()`. With unchanged sizes it does not allocate the
  memory of `x` anew.
  \param b as many numbers as A has rows; not the vector `x`.
  \param x the solution, resized if need be; its value on entry is not used, and after a failure it has none.
  \pre The last call of `factorize()` succeeded.
  \return `false` if the solution is not finite, or an iterative model did not converge.
  */
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const;

  /// @}
};
