// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Spd_solver_traits_archetype.h"

#include <CGAL/T_splines/Solver/default_solver.h>

#include <CGAL/Named_function_parameters.h>

#include <catch2/catch.hpp>

#include <Eigen/SparseCholesky>

#include <functional>
#include <type_traits>

namespace default_solver_test {

using CGAL::T_splines::Default_spd_solver_traits;
using CGAL::T_splines::Solver_traits_from;
using CGAL::T_splines::Solver_traits_or_default;
using CGAL::T_splines::internal::sparse_linear_solver;

using Llt = CGAL::T_splines::Eigen_spd_solver_traits<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>>;

TEST_CASE("without the named parameter there is a default", "[default_solver]")
{
  const auto np = CGAL::parameters::verbose(true);
  STATIC_REQUIRE(std::is_same<Solver_traits_from<decltype(np)>, Default_spd_solver_traits>::value);
  auto&& solver = sparse_linear_solver(np);
  STATIC_REQUIRE(std::is_same<std::decay_t<decltype(solver)>, Default_spd_solver_traits>::value);
}

TEST_CASE("a solver is passed by value", "[default_solver]")
{
  Llt mine;
  const auto np = CGAL::parameters::verbose(true).sparse_linear_solver(mine);
  STATIC_REQUIRE(std::is_same<Solver_traits_from<decltype(np)>, Llt>::value);
  auto&& solver = sparse_linear_solver(np);
  CHECK(&solver != &mine);
  CHECK(&solver.solver() == &mine.solver()); // with its settings
}

TEST_CASE("a solver is passed by reference, one that cannot be copied too", "[default_solver]")
{
  Spd_solver_traits_archetype mine;
  const auto np = CGAL::parameters::sparse_linear_solver(std::ref(mine)).verbose(true);
  STATIC_REQUIRE(std::is_same<Solver_traits_from<decltype(np)>, Spd_solver_traits_archetype>::value);
  auto&& solver = sparse_linear_solver(np);
  CHECK(&solver == &mine);
}

TEST_CASE("a template argument may be CGAL::Default", "[default_solver]")
{
  STATIC_REQUIRE(std::is_same<Solver_traits_or_default<CGAL::Default>, Default_spd_solver_traits>::value);
  STATIC_REQUIRE(std::is_same<Solver_traits_or_default<Llt>, Llt>::value);
}

} // namespace default_solver_test
