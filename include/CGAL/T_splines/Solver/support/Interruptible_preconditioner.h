// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_SUPPORT_INTERRUPTIBLE_PRECONDITIONER_H
#define CGAL_T_SPLINES_SOLVER_SUPPORT_INTERRUPTIBLE_PRECONDITIONER_H

#include <CGAL/T_splines/internal/Progress.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A factorization that fails when a progress is interrupted: conjugate gradients that are preconditioned with it end.
template <typename SolverTraits>
class Interruptible_preconditioner {
public:
  Interruptible_preconditioner(const SolverTraits& solver, Progress& progress) : m_solver(solver), m_progress(progress)
  {
  }

  template <typename FT>
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    return m_progress.go_on() && m_solver.solve(b, x);
  }

private:
  const SolverTraits& m_solver;
  Progress& m_progress;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_SUPPORT_INTERRUPTIBLE_PRECONDITIONER_H
