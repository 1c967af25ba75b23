// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "spd_solver_traits_checks.h"

#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include <catch2/catch.hpp>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include <vector>

namespace Eigen_spd_solver_traits_test {

using CGAL::T_splines::Eigen_spd_solver_traits;

using Ldlt = Eigen_spd_solver_traits<>;
using Llt = Eigen_spd_solver_traits<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>>;
using Ldlt_natural = Eigen_spd_solver_traits<
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>>;
using Ldlt_long_double = Eigen_spd_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<long double>>>;
using Ldlt_50_digits =
    Eigen_spd_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<boost::multiprecision::cpp_bin_float_50>>>;
using Conjugate_gradient = Eigen_spd_solver_traits<Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower>>;

TEMPLATE_TEST_CASE("Eigen's solvers do what the concept asks for", "[Eigen_spd_solver_traits]", Ldlt, Llt, Ldlt_natural,
                   Ldlt_long_double, Ldlt_50_digits, Conjugate_gradient)
{
  using Checks = Spd_solver_traits_checks<TestType>;
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
  SECTION("refuses what is not finite")
  {
    Checks::refuses_what_is_not_finite();
  }
}

TEMPLATE_TEST_CASE("Eigen's direct solvers refuse what is not positive definite", "[Eigen_spd_solver_traits]", Ldlt,
                   Llt, Ldlt_natural, Ldlt_long_double, Ldlt_50_digits)
{
  Spd_solver_traits_checks<TestType>::refuses_what_is_not_positive_definite();
}

TEST_CASE("an iterative solver that does not converge fails", "[Eigen_spd_solver_traits]")
{
  const auto a = shifted_laplacian<double>(20, 20, 1e-3);
  Conjugate_gradient solver;
  solver.solver().setMaxIterations(2);
  REQUIRE(solver.analyze_pattern(a));
  REQUIRE(solver.factorize(a));
  const std::vector<double> b = random_vector<double>(400);
  std::vector<double> x;
  CHECK_FALSE(solver.solve(b, x));
  solver.solver().setMaxIterations(1000).setTolerance(1e-12);
  CHECK(solver.solve(b, x));
  CHECK(backward_error(a, x, b) <= 1e-12);
}

TEMPLATE_TEST_CASE("a factorization can be given up, asks often, and its result does not depend on the questions",
                   "[Eigen_spd_solver_traits]", Ldlt, Ldlt_natural)
{
  const auto a = shifted_laplacian<double>(300, 300, 1e-2);
  TestType asking, plain;
  REQUIRE(asking.analyze_pattern(a));
  REQUIRE(plain.analyze_pattern(a));
  int number_of_questions = 0;
  REQUIRE(asking.factorize(a, [&] {
    ++number_of_questions;
    return true;
  }));
  CHECK(number_of_questions > 2);
  REQUIRE(plain.factorize(a));
  const std::vector<double> b = random_vector<double>(90000);
  std::vector<double> x, y;
  REQUIRE(asking.solve(b, x));
  REQUIRE(plain.solve(b, y));
  CHECK(x == y);

  int last_question = 2;
  CHECK_FALSE(asking.factorize(a, [&] { return --last_question > 0; }));
  CHECK(last_question == 0); // there is no question after a no
  REQUIRE(asking.factorize(a));
  REQUIRE(asking.solve(b, x));
  CHECK(x == y);
}

TEST_CASE("settings of Eigen's solver are heeded, and the factorization is Eigen's", "[Eigen_spd_solver_traits]")
{
  const auto a = shifted_laplacian<double>(30, 20, 1e-2);
  const Eigen::Map<const Eigen::SparseMatrix<double>> matrix(
      a.size(), a.size(), static_cast<int>(a.number_of_entries()), a.column_begin.data(), a.row.data(), a.value.data());
  Ldlt solver;
  solver.solver().setShift(0.5, 2);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> eigen;
  eigen.setShift(0.5, 2);
  eigen.compute(matrix);
  REQUIRE(solver.analyze_pattern(a));
  REQUIRE(solver.factorize(a));
  const Eigen::VectorXd expected = eigen.vectorD();
  CHECK((solver.solver().vectorD() - expected).norm() <= 1e-14 * expected.norm());
  CHECK((solver.solver().matrixL().nestedExpression() - eigen.matrixL().nestedExpression()).norm() <= 1e-14 * 600);
}

TEST_CASE("copies share the solver", "[Eigen_spd_solver_traits]")
{
  const auto a = shifted_laplacian<double>(5, 5, 1.);
  Ldlt solver;
  const Ldlt copy = solver;
  REQUIRE(solver.analyze_pattern(a));
  REQUIRE(solver.factorize(a));
  const std::vector<double> b = random_vector<double>(25);
  std::vector<double> x;
  REQUIRE(copy.solve(b, x));
  CHECK(backward_error(a, x, b) <= 1e-14);
}

} // namespace Eigen_spd_solver_traits_test
