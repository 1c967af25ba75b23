// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Solver/Cholmod_spd_solver_traits.h>

#ifdef CGAL_T_SPLINES_WITH_CHOLMOD

#include "spd_solver_traits_checks.h"

#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Cholmod_spd_solver_traits_test {

using CGAL::T_splines::Cholmod_spd_solver_traits;

TEST_CASE("CHOLMOD does what the concept asks for", "[Cholmod_spd_solver_traits]")
{
  using Checks = Spd_solver_traits_checks<Cholmod_spd_solver_traits>;
  SECTION("solves")
  {
    Checks::solves();
  }
  SECTION("reuses the analysis")
  {
    Checks::reuses_the_analysis();
  }
  SECTION("can be moved")
  {
    Checks::can_be_moved();
  }
  SECTION("solves one equation")
  {
    Checks::solves_one_equation();
  }
  SECTION("refuses what is not positive definite")
  {
    Checks::refuses_what_is_not_positive_definite();
  }
  SECTION("refuses what is not finite")
  {
    Checks::refuses_what_is_not_finite();
  }
}

TEST_CASE("CHOLMOD and Eigen agree", "[Cholmod_spd_solver_traits]")
{
  const double shift = 1e-3;
  const auto a = shifted_laplacian<double>(150, 100, shift);
  const std::vector<double> b = random_vector<double>(15000);
  std::vector<double> x, y;
  Cholmod_spd_solver_traits cholmod;
  CGAL::T_splines::Eigen_spd_solver_traits<> eigen;
  REQUIRE((cholmod.analyze_pattern(a) && cholmod.factorize(a) && cholmod.solve(b, x)));
  REQUIRE((eigen.analyze_pattern(a) && eigen.factorize(a) && eigen.solve(b, y)));
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] -= y[i];
  // The condition number is at most 16 / shift + 1.
  CHECK(largest_absolute(x) <= 16 / shift * 1e-14 * largest_absolute(y));
}

TEST_CASE("CHOLMOD takes its parameters", "[Cholmod_spd_solver_traits]")
{
  const auto a = shifted_laplacian<double>(60, 60, 1e-3);
  const std::vector<double> b = random_vector<double>(3600);
  std::vector<double> x;
  Cholmod_spd_solver_traits solver;
  solver.parameters().method[0].ordering = CHOLMOD_METIS;
  REQUIRE((solver.analyze_pattern(a) && solver.factorize(a) && solver.solve(b, x)));
  CHECK(backward_error(a, x, b) <= 1e-14);
}

TEST_CASE("CHOLMOD solves for 700 thousand unknowns", "[Cholmod_spd_solver_traits]")
{
  const auto a = shifted_laplacian<double>(840, 840, 1e-6);
  const std::size_t n = static_cast<std::size_t>(a.size());
  const std::vector<double> b = random_vector<double>(n);
  std::vector<double> x;
  Cholmod_spd_solver_traits solver;
  REQUIRE((solver.analyze_pattern(a) && solver.factorize(a) && solver.solve(b, x)));
  CHECK(backward_error(a, x, b) <= 1e-14);
}

} // namespace Cholmod_spd_solver_traits_test

#endif // CGAL_T_SPLINES_WITH_CHOLMOD
