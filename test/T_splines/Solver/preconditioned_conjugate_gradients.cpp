// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Spd_solver_traits_archetype.h"
#include "spd_matrices.h"
#include "spd_solver_traits_checks.h"

#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/preconditioned_conjugate_gradients.h>

#include <catch2/catch.hpp>

#include <vector>

namespace preconditioned_conjugate_gradients_test {

using namespace CGAL::T_splines;

TEST_CASE("the archetype is a model", "[preconditioned_conjugate_gradients]")
{
  using Checks = Spd_solver_traits_checks<Spd_solver_traits_archetype>;
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
  SECTION("refuses what is not positive definite")
  {
    Checks::refuses_what_is_not_positive_definite();
  }
}

TEMPLATE_TEST_CASE("the matrix's own factorization needs one iteration", "[preconditioned_conjugate_gradients]",
                   Spd_solver_traits_archetype, Eigen_spd_solver_traits<>)
{
  const auto a = shifted_laplacian<double>(12, 12, 0.5);
  TestType solver;
  REQUIRE((solver.analyze_pattern(a) && solver.factorize(a)));
  const std::vector<double> b = random_vector<double>(144);
  std::vector<double> x;
  Conjugate_gradients_workspace<double> workspace;
  CHECK(preconditioned_conjugate_gradients(a, solver, b, x, 1e-12, 10, workspace) == 1);
  CHECK(backward_error(a, x, b) <= 1e-12);
}

TEMPLATE_TEST_CASE("a nearby factorization needs few iterations", "[preconditioned_conjugate_gradients]",
                   Spd_solver_traits_archetype, Eigen_spd_solver_traits<>)
{
  // Weights differ by factors in [1/2, 2]: condition number at most 4, error factor 1/3 per iteration.
  const auto nearby = shifted_laplacian<double>(15, 15, 0.5, 0), a = shifted_laplacian<double>(15, 15, 0.5, 1);
  TestType solver;
  REQUIRE((solver.analyze_pattern(nearby) && solver.factorize(nearby)));
  const std::vector<double> b = random_vector<double>(225);
  std::vector<double> x(7, 1.0);
  Conjugate_gradients_workspace<double> workspace;
  const int iterations = preconditioned_conjugate_gradients(a, solver, b, x, 1e-10, 100, workspace);
  CHECK(iterations > 1);
  CHECK(iterations <= 30);
  CHECK(backward_error(a, x, b) <= 1e-10);

  SECTION("and no allocation the second time")
  {
    const double *residual = workspace.residual.data(), *preconditioned = workspace.preconditioned.data(),
                 *search = workspace.search.data(), *image = workspace.image.data(), *solution = x.data();
    const std::vector<double> first = x;
    CHECK(preconditioned_conjugate_gradients(a, solver, b, x, 1e-10, 100, workspace) == iterations);
    CHECK(x == first);
    CHECK(residual == workspace.residual.data());
    CHECK(preconditioned == workspace.preconditioned.data());
    CHECK(search == workspace.search.data());
    CHECK(image == workspace.image.data());
    CHECK(solution == x.data());
  }

  SECTION("and stops at the limit")
  {
    CHECK(preconditioned_conjugate_gradients(a, solver, b, x, 1e-10, 2, workspace) == 2);
  }
}

TEST_CASE("zero is solved without an iteration", "[preconditioned_conjugate_gradients]")
{
  const auto a = shifted_laplacian<double>(3, 3, 1.0);
  Spd_solver_traits_archetype solver;
  REQUIRE((solver.analyze_pattern(a) && solver.factorize(a)));
  std::vector<double> x(9, 1.0);
  Conjugate_gradients_workspace<double> workspace;
  CHECK(preconditioned_conjugate_gradients(a, solver, std::vector<double>(9, 0.0), x, 1e-10, 5, workspace) == 0);
  CHECK(x == std::vector<double>(9, 0.0));
}

TEST_CASE("a preconditioner that fails, or a matrix that is not definite, ends the iteration",
          "[preconditioned_conjugate_gradients]")
{
  const auto a = shifted_laplacian<double>(3, 3, 1.0);
  const std::vector<double> b(9, 1.0);
  std::vector<double> x;
  Conjugate_gradients_workspace<double> workspace;
  Spd_solver_traits_archetype solver;
  CHECK(preconditioned_conjugate_gradients(a, solver, b, x, 1e-10, 5, workspace) == 0); // not factorized
  CHECK(x == std::vector<double>(9, 0.0));

  REQUIRE((solver.analyze_pattern(a) && solver.factorize(a)));
  auto negative = a;
  for (double& number : negative.value)
    number = -number;
  CHECK(preconditioned_conjugate_gradients(negative, solver, b, x, 1e-10, 5, workspace) == 1);
}

} // namespace preconditioned_conjugate_gradients_test
