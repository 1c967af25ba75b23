// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <catch2/catch.hpp>

#include <vector>

namespace Symmetric_sparse_matrix_test {

using Matrix = CGAL::T_splines::Symmetric_sparse_matrix<double>;

TEST_CASE("the stored triangle stands for both", "[Symmetric_sparse_matrix]")
{
  // ( 2 -1  4 )
  // (-1  3  0 )
  // ( 4  0  5 )
  Matrix a;
  a.column_begin = {0, 3, 4, 5};
  a.row = {0, 1, 2, 1, 2};
  a.value = {2, -1, 4, 3, 5};
  REQUIRE(a.size() == 3);
  REQUIRE(a.number_of_entries() == 5);

  std::vector<double> y = {7}; // what was there does not matter
  a.multiply({1, 10, 100}, y);
  CHECK(y == std::vector<double>{392, 29, 504});
}

TEST_CASE("a matrix without rows multiplies", "[Symmetric_sparse_matrix]")
{
  const Matrix a;
  std::vector<double> y = {7};
  a.multiply({}, y);
  CHECK(y.empty());
}

} // namespace Symmetric_sparse_matrix_test
