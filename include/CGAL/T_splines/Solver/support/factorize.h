// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_SUPPORT_FACTORIZE_H
#define CGAL_T_SPLINES_SOLVER_SUPPORT_FACTORIZE_H

#include <CGAL/T_splines/internal/Progress.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename SolverTraits, typename Matrix, typename = void>
struct Is_interruptible : std::false_type {
};

template <typename SolverTraits, typename Matrix>
struct Is_interruptible<SolverTraits, Matrix,
                        std::void_t<decltype(std::declval<SolverTraits&>().factorize(
                            std::declval<const Matrix&>(), std::declval<const std::function<bool()>&>()))>>
  : std::true_type {
};

/// Factorizes a matrix, asks whether to go on before, and meanwhile if the solver can.
/// \return false if the solver fails, or `progress` is interrupted
template <typename SolverTraits, typename Matrix>
bool factorize(SolverTraits& solver, const Matrix& matrix, Progress& progress)
{
  if (!progress.go_on())
    return false;
  if constexpr (Is_interruptible<SolverTraits, Matrix>::value)
    return solver.factorize(matrix, [&progress] { return progress.go_on(); });
  else
    return solver.factorize(matrix);
}

/// Analyzes the pattern of a matrix, and factorizes it.
/// \return false if the solver fails, or `progress` is interrupted
template <typename SolverTraits, typename Matrix>
bool analyze_and_factorize(SolverTraits& solver, const Matrix& matrix, Progress& progress)
{
  return progress.go_on() && solver.analyze_pattern(matrix) && factorize(solver, matrix, progress);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_SUPPORT_FACTORIZE_H
