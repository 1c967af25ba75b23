// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/internal/Cubic_b_spline.h>

#include "Spline/Planar_t_mesh.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace Cubic_b_spline_test {

namespace {

using Rational = CGAL::Exact_rational;
template <typename FT>
using Knots = std::array<FT, 5>;
using Spline = CGAL::T_splines::internal::Cubic_b_spline<double>;
using Exact_spline = CGAL::T_splines::internal::Cubic_b_spline<Rational>;

const std::vector<Knots<double>> some_knots{{0, 1, 2, 3, 4},       {-3, -2.5, 0, 0.125, 7}, {0, 0, 0, 0, 2},
                                            {0, 0, 0, 1, 3},       {0, 0, 1, 3, 4},         {-2, -1, 0, 0, 0},
                                            {-4, -2, -1, 0, 0},    {-1, 0, 0, 0, 0},        {-1, -1, -1, 2, 2},
                                            {-1e-6, 0, 1, 2, 1e6}, {0, 0, 0, 2, 2}};

} // namespace

TEST_CASE("a cubic B-spline is that of Cox and de Boor, and not negative", "[Cubic_b_spline]")
{
  CGAL::Random random(1);
  for (const auto& knots : some_knots) {
    const Spline spline(knots);
    const spline_tests::Reference_b_spline reference(knots);
    for (int k = 0; k < 1000; ++k) {
      const double x = k < 5 ? knots[k] : random.get_double(knots[0], knots[4]);
      CHECK(spline.value(x) >= 0);
      CHECK(std::abs(spline.value(x) - reference(x)) < 1e-14);
      CHECK(spline.jet(x)[0] == spline.value(x));
    }
  }
}

TEST_CASE("a cubic B-spline is continuous to the order that its knots allow", "[Cubic_b_spline]")
{
  const Exact_spline simple(Knots<Rational>{0, 1, 3, 4, 7}), twice(Knots<Rational>{0, 0, 1, 3, 4});
  const Rational e = Rational(1) / 1000000000 / 1000000000;
  for (const int x : {0, 1, 3, 4, 7})
    for (int d = 0; d < 3; ++d)
      CHECK(abs(Rational(simple.jet(x - e)[d] - simple.jet(x + e)[d])) < 10 * e);
  for (int d = 0; d < 2; ++d)
    CHECK(twice.jet(0)[d] == 0);
  CHECK(twice.jet(0)[2] > 0);
  // Derivatives are those of the value, which is a cubic between the knots: four-point differences are exact.
  const Rational h = Rational(1) / 10, x = Rational(7) / 2;
  const auto f = [&](const int k) { return simple.value(x + k * h); };
  CHECK(simple.jet(x)[1] == (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * h));
  CHECK(simple.jet(x)[2] == (f(1) - 2 * f(0) + f(-1)) / (h * h));
}

TEST_CASE("beyond a border the function goes on, elsewhere it vanishes", "[Cubic_b_spline]")
{
  const double e = 1e-17;
  for (const auto& knots : some_knots) {
    const Spline spline(knots);
    for (const bool is_first : {true, false}) {
      const double end = is_first ? knots[0] : knots[4], outside = end + (is_first ? -1e-9 : 1e-9);
      const bool is_border = is_first ? knots[0] == knots[1] : knots[3] == knots[4];
      CHECK(spline.vanishes_at(outside) == !is_border);
      if (!is_border)
        CHECK(spline.value(outside) == 0);
      else
        for (int d = 0; d < 3; ++d)
          CHECK(spline.jet(outside)[d] == Approx(spline.jet(end)[d]).margin(1e-7));
    }
  }
  CHECK(Spline(std::array<double, 5>{0, 0, 0, 0, 2}).value(-e) == Approx(1));
  CHECK(Spline(std::array<double, 5>{0, 0, 0, 1, 3}).jet(-e)[1] == Approx(3));
}

TEST_CASE("the Bernstein coefficients of a piece give its values", "[Cubic_b_spline]")
{
  for (const auto& knots : some_knots)
    for (int i = 0; i < 4; ++i) {
      const double a = knots[i], b = knots[i + 1];
      if (!(a < b))
        continue;
      const Spline spline(knots);
      const std::array<double, 4> c = spline.bernstein_coefficients(a, b);
      for (const double t : {0.125, 0.5, 0.75}) {
        const double s = 1 - t;
        CHECK(c[0] * s * s * s + 3 * c[1] * s * s * t + 3 * c[2] * s * t * t + c[3] * t * t * t ==
              Approx(spline.value(a + t * (b - a))).margin(1e-14));
      }
    }
}

} // namespace Cubic_b_spline_test
