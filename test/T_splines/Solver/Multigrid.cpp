// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Solver/support/Hermitian_rows.h>
#include <CGAL/T_splines/Solver/support/Multigrid.h>
#include <CGAL/T_splines/Solver/support/multigrid_iterations.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/number_type_config.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace Multigrid_test {

using namespace CGAL::T_splines::internal;

namespace {

using Complex = std::complex<double>;

// The energy of differences on a periodic grid of n times n unknowns, with weights `stretch` in one direction, plus `shift`.
// A complex one is that of sections with the curvature 2 pi `flux` in all.
template <typename Scalar>
Hermitian_rows<Scalar> periodic_grid(const int n, const double stretch, const double shift, const int flux)
{
  using Entry = typename Hermitian_rows<Scalar>::Lower_entry;
  std::vector<double> diagonal(n * n, 2 + 2 * stretch + shift);
  std::vector<Entry> entries;
  const auto add_edge = [&](const int from, const int to, const double weight, const double angle) {
    Scalar value(-weight);
    if constexpr (!std::is_same<Scalar, double>::value)
      value = std::polar(weight, angle + CGAL_PI); // of the value at `from` in the row of `to`
    entries.push_back(to > from ? Entry{to, from, value} : Entry{from, to, conjugate(value)});
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double turn = 2 * CGAL_PI * flux / (static_cast<double>(n) * n);
      add_edge(i * n + j, i * n + (j + 1) % n, stretch, turn * i);
      add_edge(i * n + j, (i + 1) % n * n + j, 1., i + 1 == n ? -turn * n * j : 0.);
    }
  }
  return Hermitian_rows<Scalar>::from_lower_triangle(diagonal, entries);
}

template <typename Scalar>
std::vector<Scalar> random_vector(const std::size_t n)
{
  std::mt19937 random(7);
  std::vector<Scalar> result(n);
  for (Scalar& x : result)
    x = static_cast<double>(random()) / 4294967296. - 0.5;
  return result;
}

// How many iterations the system with a known solution takes; checks the error in the norm of the matrix.
template <typename Scalar>
int iterations_to_solve(Hermitian_rows<Scalar> matrix, const double tolerance)
{
  const std::size_t n = matrix.size();
  CGAL::T_splines::internal::Progress progress;
  Multigrid<Scalar> multigrid(std::move(matrix), progress);
  const std::vector<Scalar> solution = random_vector<Scalar>(n);
  std::vector<Scalar> x(n), b, image;
  multigrid.matrix(0).multiply(solution, b);
  const int iterations =
      solve_with_multigrid(multigrid, 1., std::vector<double>(n, 0.), b, x, tolerance, 200, progress);
  add(x, -1., solution);
  multigrid.matrix(0).multiply(x, image);
  CHECK(std::sqrt(dot(x, image)) <= 10 * tolerance * std::sqrt(dot(solution, b)));
  return iterations;
}

} // namespace

TEMPLATE_TEST_CASE("a cycle is symmetric and positive definite", "[Multigrid]", double, Complex)
{
  CGAL::T_splines::internal::Progress progress;
  Multigrid<TestType> multigrid(periodic_grid<TestType>(24, 3., 1e-3, 1), progress);
  CHECK(multigrid.number_of_levels() > 1);
  std::vector<TestType> a = random_vector<TestType>(24 * 24), b = a, cycle_a, cycle_b;
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] = a[i] * a[a.size() - 1 - i] + 0.1;
  multigrid.cycle(a, cycle_a);
  multigrid.cycle(b, cycle_b);
  CHECK(dot(a, cycle_b) == Approx(dot(cycle_a, b)).epsilon(1e-12));
  CHECK(dot(a, cycle_a) > 0);
  CHECK(dot(b, cycle_b) > 0);
}

TEMPLATE_TEST_CASE("the number of iterations hardly depends on the size or on the shape of triangles", "[Multigrid]",
                   double, Complex)
{
  for (const int n : {8, 32, 128, 256}) {
    for (const double stretch : {1., 30., 1e4, 1e8}) {
      CAPTURE(n, stretch);
      CHECK(iterations_to_solve(periodic_grid<TestType>(n, stretch, 1e-4 / n, 1), 1e-8) <= 40);
    }
  }
}

TEST_CASE("unknowns that are coupled with none are solved for", "[Multigrid]")
{
  const int n = 500;
  std::vector<double> diagonal(n, 2.);
  CHECK(iterations_to_solve(Hermitian_rows<double>::from_lower_triangle(diagonal, {}), 1e-12) <= 2);
  std::vector<Hermitian_rows<double>::Lower_entry> entries;
  for (int i = 1; i < n / 2; ++i)
    entries.push_back({i, i - 1, -1.});
  CHECK(iterations_to_solve(Hermitian_rows<double>::from_lower_triangle(diagonal, entries), 1e-10) <= 30);
}

TEST_CASE("entries at equal places are added", "[Multigrid]")
{
  const auto rows = Hermitian_rows<Complex>::from_lower_triangle({1., 2.}, {{1, 0, {1, 2}}, {1, 0, {3, 4}}});
  REQUIRE(rows.entry.size() == 2);
  CHECK(rows.entry[0].value == Complex(4, -6));
  CHECK(rows.entry[1].value == Complex(4, 6));
  std::vector<Complex> image;
  rows.multiply({Complex(1), Complex(0, 1)}, image);
  CHECK(image[0] == Complex(7, 4));
  CHECK(image[1] == Complex(4, 8));
}

TEST_CASE("the smallest eigenvalue of a grid is its shift, and that of a flux is Landau's", "[Multigrid]")
{
  for (const int n : {3, 9, 40, 150}) {
    const double shift = 0.1 / (n * n);
    const std::vector<double> mass(n * n, 1.);
    CGAL::T_splines::internal::Progress progress;
    Multigrid<double> real(periodic_grid<double>(n, 2., shift, 0), progress);
    std::vector<double> x;
    CHECK(smallest_eigenvector(real, mass, 0, x, progress) == Approx(shift).epsilon(1e-4));
    CHECK(dot(x, x) == Approx(1));
    for (const double entry : x)
      CHECK(entry * x.front() * n * n == Approx(1).epsilon(0.05));
  }
  // Of a constant field 2 pi k on a torus of area 1, for smooth functions: 2 pi k.
  const int n = 150;
  const std::vector<double> mass(n * n, 1. / (n * n));
  for (const int flux : {1, 3}) {
    CGAL::T_splines::internal::Progress progress;
    Multigrid<Complex> multigrid(periodic_grid<Complex>(n, 1., 0., flux), progress);
    std::vector<Complex> x;
    CHECK(smallest_eigenvector(multigrid, mass, 0, x, progress) == Approx(2 * CGAL_PI * flux).epsilon(2e-3));
  }
}

} // namespace Multigrid_test
