// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/internal/Anderson_acceleration.h>

#include <Eigen/Dense>

#include <catch2/catch.hpp>

#include <cmath>

namespace Anderson_acceleration_test {

namespace {

using Acceleration = CGAL::T_splines::internal::Anderson_acceleration<double>;
using Vector = Acceleration::Vector;
using Matrix = Eigen::MatrixXd;

// A symmetric matrix with these eigenvalues.
Matrix matrix(const Vector& eigenvalues)
{
  const Eigen::Index n = eigenvalues.size();
  Matrix a(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      a(i, j) = std::sin(1. + static_cast<double>(i * n + j));
  const Matrix q = Eigen::HouseholderQR<Matrix>(a).householderQ();
  return q * eigenvalues.asDiagonal() * q.transpose();
}

} // namespace

TEST_CASE("An affine iteration with few eigenvalues ends after as many steps", "[Anderson_acceleration]")
{
  Vector eigenvalues(12);
  for (Eigen::Index i = 0; i < 12; ++i)
    eigenvalues[i] = 0.99 - 0.2 * static_cast<double>(i % 4);
  const Matrix a = matrix(eigenvalues);
  const Vector b = Vector::LinSpaced(12, -1, 3);
  const Vector fixed_point = (Matrix::Identity(12, 12) - a).fullPivLu().solve(b);
  Acceleration acceleration;
  Vector x = Vector::Zero(12), plain = x;
  for (int step = 0; step < 6; ++step) {
    x = acceleration.next(x, a * x + b);
    plain = a * plain + b;
  }
  CHECK((x - fixed_point).norm() < 1e-8 * fixed_point.norm());
  CHECK((plain - fixed_point).norm() > 0.1 * fixed_point.norm());
}

TEST_CASE("The first step and the one after a reset are those of the iteration itself", "[Anderson_acceleration]")
{
  Acceleration acceleration;
  const Vector x = Vector::LinSpaced(5, 0, 1), g = Vector::LinSpaced(5, 2, -1);
  CHECK(acceleration.next(x, g) == g);
  acceleration.next(g, x);
  acceleration.reset();
  CHECK(acceleration.next(x, g) == g);
}

TEST_CASE("At the fixed point the acceleration stays", "[Anderson_acceleration]")
{
  Acceleration acceleration;
  const Vector x = Vector::LinSpaced(5, 0, 1);
  for (int i = 0; i < 8; ++i)
    CHECK(acceleration.next(x, x) == x);
}

} // namespace Anderson_acceleration_test
