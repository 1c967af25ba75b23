// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SOLVER_SPD_SOLVER_TRAITS_CHECKS_H
#define T_SPLINES_TEST_SOLVER_SPD_SOLVER_TRAITS_CHECKS_H

#include "spd_matrices.h"

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// What every model of SparseSpdSolverTraits owes, direct or iterative.
template <typename SolverTraits>
struct Spd_solver_traits_checks {
  using FT = typename SolverTraits::FT;
  using Matrix = CGAL::T_splines::Symmetric_sparse_matrix<FT>;
  using Vector = std::vector<FT>;

  static FT precision() { return 64 * std::numeric_limits<FT>::epsilon(); }

  static void solves()
  {
    const Matrix a = shifted_laplacian<FT>(9, 7, FT(1) / 8);
    const std::size_t n = static_cast<std::size_t>(a.size());
    SolverTraits solver;
    REQUIRE(solver.analyze_pattern(a));
    REQUIRE(solver.factorize(a));

    const Vector b = random_vector<FT>(n);
    Vector x(3, std::numeric_limits<FT>::quiet_NaN()); // neither size nor contents matter
    REQUIRE(solver.solve(b, x));
    REQUIRE(x.size() == n);
    CHECK(backward_error(a, x, b) <= precision());

    // Row sums 1/8: the constant 8 solves for ones.
    REQUIRE(solver.solve(Vector(n, FT(1)), x));
    for (const FT& number : x)
      CHECK(abs_of(number - 8) <= 1000 * precision());

    // The inverse of an irreducible M-matrix is symmetric and positive.
    Vector unit(n, FT(0)), y;
    unit[5] = 1;
    REQUIRE(solver.solve(unit, x));
    unit[5] = 0;
    unit[40] = 1;
    REQUIRE(solver.solve(unit, y));
    CHECK(abs_of(x[40] - y[5]) <= precision());
    CHECK(*std::min_element(x.begin(), x.end()) > 0);
  }

  static void reuses_the_analysis()
  {
    SolverTraits solver;
    REQUIRE(solver.analyze_pattern(shifted_laplacian<FT>(8, 8, FT(1), 0)));
    for (const unsigned int seed : {1u, 2u, 3u}) {
      const Vector b = random_vector<FT>(64, seed);
      Vector x;
      Matrix a = shifted_laplacian<FT>(8, 8, FT(1), seed);
      const Matrix copy = a;
      REQUIRE(solver.factorize(a));
      // The solver owns what it needs: the matrix may change and go.
      std::fill(a.value.begin(), a.value.end(), FT(0));
      a = Matrix();
      REQUIRE(solver.solve(b, x));
      CHECK(backward_error(copy, x, b) <= precision());
    }
    // Another pattern needs another analysis, and gets it.
    const Matrix other = shifted_laplacian<FT>(5, 4, FT(1));
    REQUIRE(solver.analyze_pattern(other));
    REQUIRE(solver.factorize(other));
    const Vector b = random_vector<FT>(20);
    Vector x;
    REQUIRE(solver.solve(b, x));
    CHECK(backward_error(other, x, b) <= precision());
  }

  static void can_be_moved()
  {
    const Matrix a = shifted_laplacian<FT>(6, 6, FT(1));
    const Vector b = random_vector<FT>(36);
    Vector x;
    std::vector<SolverTraits> solvers(1);
    REQUIRE(solvers[0].analyze_pattern(a));
    REQUIRE(solvers[0].factorize(a));
    SolverTraits moved = std::move(solvers[0]);
    solvers.clear();
    solvers.shrink_to_fit();
    REQUIRE(moved.solve(b, x));
    CHECK(backward_error(a, x, b) <= precision());
  }

  static void solves_one_equation()
  {
    Matrix a;
    a.column_begin = {0, 1};
    a.row = {0};
    a.value = {FT(4)};
    SolverTraits solver;
    Vector x;
    REQUIRE(solver.analyze_pattern(a));
    REQUIRE(solver.factorize(a));
    REQUIRE(solver.solve({FT(2)}, x));
    CHECK(abs_of(x[0] - FT(1) / 2) <= precision());
  }

  // Direct solvers only: iterative ones notice late or never.
  static void refuses_what_is_not_positive_definite()
  {
    const Matrix good = shifted_laplacian<FT>(8, 8, FT(1));
    SolverTraits solver;
    REQUIRE(solver.analyze_pattern(good));

    // L - I has an eigenvalue -1 (of the constant) and positive ones.
    CHECK_FALSE(solver.factorize(shifted_laplacian<FT>(8, 8, FT(-1))));

    Matrix negative = good;
    for (FT& number : negative.value)
      number = -number;
    CHECK_FALSE(solver.factorize(negative));

    Matrix zero = good;
    std::fill(zero.value.begin(), zero.value.end(), FT(0));
    CHECK_FALSE(solver.factorize(zero));

    // What failed leaves no trace.
    REQUIRE(solver.factorize(good));
    const Vector b = random_vector<FT>(64);
    Vector x;
    REQUIRE(solver.solve(b, x));
    CHECK(backward_error(good, x, b) <= precision());
  }

  // A number that is not finite is noticed by factorize() or solve().
  static void refuses_what_is_not_finite()
  {
    for (const FT& bad : {std::numeric_limits<FT>::quiet_NaN(), std::numeric_limits<FT>::infinity()})
      for (const std::size_t entry : {0, 1, 50}) {
        Matrix a = shifted_laplacian<FT>(8, 8, FT(1));
        SolverTraits solver;
        Vector x;
        REQUIRE(solver.analyze_pattern(a));
        a.value[entry] = bad;
        CHECK_FALSE((solver.factorize(a) && solver.solve(Vector(64, FT(1)), x)));
      }
    const Matrix a = shifted_laplacian<FT>(8, 8, FT(1));
    SolverTraits solver;
    REQUIRE(solver.analyze_pattern(a));
    REQUIRE(solver.factorize(a));
    Vector b(64, FT(1)), x;
    b[7] = std::numeric_limits<FT>::quiet_NaN();
    CHECK_FALSE(solver.solve(b, x));
  }

private:
  static FT abs_of(const FT& number) { return number < 0 ? FT(-number) : number; }
};

#endif // T_SPLINES_TEST_SOLVER_SPD_SOLVER_TRAITS_CHECKS_H
