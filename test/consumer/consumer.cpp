// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines.h>

#include <cmath>
#include <vector>

#ifndef CGAL_EIGEN3_ENABLED
#error "the package's target has to pass on the definitions of its dependencies"
#endif

// 2 x - y = 1, -x + 2 y = 1.
template <typename SolverTraits>
bool solves(SolverTraits solver)
{
  CGAL::T_splines::Symmetric_sparse_matrix<double> a;
  a.column_begin = {0, 2, 3};
  a.row = {0, 1, 1};
  a.value = {2, -1, 2};
  std::vector<double> x;
  return solver.analyze_pattern(a) && solver.factorize(a) && solver.solve({1, 1}, x) &&
         std::abs(x[0] - 1) + std::abs(x[1] - 1) < 1e-15;
}

int main()
{
  bool good = solves(CGAL::T_splines::Default_spd_solver_traits());
#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
  good = good && solves(CGAL::T_splines::Cholmod_spd_solver_traits());
#endif
  return good ? 0 : 1;
}
