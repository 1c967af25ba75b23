// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/Surface_jet.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace Surface_jet_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Jet = CGAL::T_splines::Surface_jet<Kernel>;

// The jet of a surface whose parameters are x = a u + b v, y = c u + d v.
Jet reparametrized(const Jet& j, const double a, const double b, const double c, const double d)
{
  Jet result;
  result.position = j.position;
  result.du = a * j.du + c * j.dv;
  result.dv = b * j.du + d * j.dv;
  result.duu = a * a * j.duu + 2 * a * c * j.duv + c * c * j.dvv;
  result.duv = a * b * j.duu + (a * d + b * c) * j.duv + c * d * j.dvv;
  result.dvv = b * b * j.duu + 2 * b * d * j.duv + d * d * j.dvv;
  return result;
}

// z = (p x^2 + q y^2) / 2 at the origin: the principal curvatures are p and q.
Jet paraboloid(const double p, const double q)
{
  return {Point_3(0, 0, 0),  Vector_3(1, 0, 0), Vector_3(0, 1, 0),
          Vector_3(0, 0, p), Vector_3(0, 0, 0), Vector_3(0, 0, q)};
}

} // namespace

TEST_CASE("curvatures do not depend on the parameters", "[Surface_jet]")
{
  CGAL::Random random(1);
  for (int k = 0; k < 200; ++k) {
    const double p = random.get_double(-3, 1), q = p + random.get_double(0.1, 2);
    const double a = random.get_double(-2, 2), b = random.get_double(-2, 2), c = random.get_double(-2, 2),
                 d = random.get_double(-2, 2);
    if (a * d - b * c < 0.1)
      continue;
    // The tangential parts of second derivatives do not matter.
    Jet jet = reparametrized(paraboloid(p, q), a, b, c, d);
    jet.duu = jet.duu + random.get_double(-5, 5) * jet.du;
    jet.duv = jet.duv + random.get_double(-5, 5) * jet.dv;
    jet.dvv = jet.dvv + random.get_double(-5, 5) * jet.du;
    const auto curvatures = jet.curvatures();
    CHECK(curvatures.minimal == Approx(p).margin(1e-9));
    CHECK(curvatures.maximal == Approx(q).margin(1e-9));
    CHECK(curvatures.gaussian == Approx(p * q).margin(1e-9));
    CHECK(curvatures.mean == Approx((p + q) / 2).margin(1e-9));
    CHECK(std::abs(curvatures.minimal_direction.x()) == Approx(1).epsilon(1e-9));
    CHECK(std::abs(curvatures.maximal_direction.y()) == Approx(1).epsilon(1e-9));
    CHECK(curvatures.minimal_direction * curvatures.maximal_direction == Approx(0).margin(1e-12));
    CHECK((jet.unit_normal() - Vector_3(0, 0, 1)).squared_length() < 1e-20);
  }
}

TEST_CASE("at an umbilic the principal directions are orthonormal", "[Surface_jet]")
{
  for (const double p : {-2., 0., 0.5}) {
    const auto curvatures = reparametrized(paraboloid(p, p), 2, 0.5, -0.25, 1).curvatures();
    CHECK(curvatures.minimal == Approx(p).margin(1e-12));
    CHECK(curvatures.maximal == Approx(p).margin(1e-12));
    CHECK(curvatures.minimal_direction.squared_length() == Approx(1));
    CHECK(curvatures.maximal_direction.squared_length() == Approx(1));
    CHECK(curvatures.minimal_direction * curvatures.maximal_direction == Approx(0).margin(1e-12));
  }
}

TEST_CASE("a sphere with normals outwards has negative curvatures", "[Surface_jet]")
{
  const double r = 3, s = std::sqrt(0.5); // at latitude 45 degrees, longitude 0
  const Jet jet{Point_3(r * s, 0, r * s), Vector_3(0, r * s, 0),  Vector_3(-r * s, 0, r * s),
                Vector_3(-r * s, 0, 0),   Vector_3(0, -r * s, 0), Vector_3(-r * s, 0, -r * s)};
  CHECK(jet.normal() * (jet.position - CGAL::ORIGIN) > 0);
  CHECK(jet.curvatures().minimal == Approx(-1 / r));
  CHECK(jet.curvatures().maximal == Approx(-1 / r));
  CHECK(jet.curvatures().gaussian == Approx(1 / (r * r)));
}

TEST_CASE("the unit normal of a degenerate jet is the zero vector", "[Surface_jet]")
{
  Jet jet = paraboloid(1, 2);
  jet.dv = Vector_3(0, 0, 0);
  CHECK(jet.unit_normal() == Vector_3(0, 0, 0));
}

} // namespace Surface_jet_test
