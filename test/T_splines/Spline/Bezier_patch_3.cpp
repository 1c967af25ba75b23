// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace Bezier_patch_3_test {

namespace {

using Rational = CGAL::Exact_rational;
using Exact_kernel = CGAL::Simple_cartesian<Rational>;
using Patch = CGAL::T_splines::Bezier_patch_3<Exact_kernel>;

Patch random_patch(CGAL::Random& random)
{
  Patch::Controls controls;
  for (auto& c : controls)
    c = {random.get_int(-9, 10), random.get_int(-9, 10), random.get_int(-9, 10), random.get_int(1, 5)};
  return Patch(controls);
}

} // namespace

TEST_CASE("a patch interpolates its corners and is tangent to its control net", "[Bezier_patch_3]")
{
  CGAL::Random random(1);
  const Patch patch = random_patch(random);
  for (const int i : {0, 3})
    for (const int j : {0, 3}) {
      const auto jet = patch.jet(i / 3, j / 3);
      CHECK(jet.position == patch.control_point(i, j));
      CHECK(patch.position(i / 3, j / 3) == patch.control_point(i, j));
      const int k = i == 0 ? 1 : 2, l = j == 0 ? 1 : 2;
      // The derivative at the end of a rational curve: degree times the ratio of weights times the first leg.
      CHECK(jet.du == (i == 0 ? 3 : -3) * patch.weight(k, j) / patch.weight(i, j) *
                          (patch.control_point(k, j) - patch.control_point(i, j)));
      CHECK(jet.dv == (j == 0 ? 3 : -3) * patch.weight(i, l) / patch.weight(i, j) *
                          (patch.control_point(i, l) - patch.control_point(i, j)));
    }
}

TEST_CASE("derivatives of a patch are those of de Casteljau's algorithm", "[Bezier_patch_3]")
{
  CGAL::Random random(2);
  const Patch patch = random_patch(random);
  const Rational s = Rational(3) / 7, t = Rational(2) / 11, h = Rational(1) / 1000000;
  // Differences of polynomials of degree 3 are exact with enough points: the central ones up to the third derivative.
  const auto value = [&](const Rational& x, const Rational& y) { return patch.homogeneous_jet<0>(x, y)[0]; };
  const auto jet = patch.homogeneous_jet<2>(s, t);
  for (int c = 0; c < 4; ++c) {
    const Rational du = (value(s + h, t)[c] - value(s - h, t)[c]) / (2 * h),
                   du_wide = (value(s + 2 * h, t)[c] - value(s - 2 * h, t)[c]) / (4 * h),
                   dv = (value(s, t + h)[c] - value(s, t - h)[c]) / (2 * h),
                   dv_wide = (value(s, t + 2 * h)[c] - value(s, t - 2 * h)[c]) / (4 * h);
    CHECK(jet[1][c] == (4 * du - du_wide) / 3);
    CHECK(jet[2][c] == (4 * dv - dv_wide) / 3);
    CHECK(jet[3][c] == (value(s + h, t)[c] - 2 * value(s, t)[c] + value(s - h, t)[c]) / (h * h));
    CHECK(jet[5][c] == (value(s, t + h)[c] - 2 * value(s, t)[c] + value(s, t - h)[c]) / (h * h));
    const auto mixed = patch.homogeneous_jet<1>(s, t + h), before = patch.homogeneous_jet<1>(s, t - h);
    const auto wide = patch.homogeneous_jet<1>(s, t + 2 * h), wide_before = patch.homogeneous_jet<1>(s, t - 2 * h);
    CHECK(jet[4][c] == (4 * (mixed[1][c] - before[1][c]) / (2 * h) - (wide[1][c] - wide_before[1][c]) / (4 * h)) / 3);
    CHECK(jet[0][c] == value(s, t)[c]);
  }
}

TEST_CASE("a factor of the homogeneous control points changes nothing", "[Bezier_patch_3]")
{
  CGAL::Random random(3);
  const Patch patch = random_patch(random);
  Patch other = patch;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      for (auto& x : other.homogeneous_control_point(i, j))
        x *= Rational(5) / 3;
  const auto a = patch.jet(Rational(1) / 3, Rational(1) / 5), b = other.jet(Rational(1) / 3, Rational(1) / 5);
  CHECK(a.position == b.position);
  CHECK(a.du == b.du);
  CHECK(a.dvv == b.dvv);
  CHECK(a.duv == b.duv);
}

} // namespace Bezier_patch_3_test
