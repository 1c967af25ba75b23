// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Similarity_map/internal/Triangle_angles.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace Triangle_angles_test {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
template <typename FT>
using Triangle_angles = CGAL::T_splines::internal::Triangle_angles<FT>;

template <typename FT>
FT pi()
{
  using std::atan2;
  return 4 * atan2(FT(1), FT(1));
}

template <typename FT>
std::array<FT, 3> log_lengths(const FT& a, const FT& b, const FT& c)
{
  using std::log;
  return {{FT(log(a)), FT(log(b)), FT(log(c))}};
}

} // namespace

TEMPLATE_TEST_CASE("angles of triangles that are known", "[Triangle_angles]", double, long double, Wide)
{
  using std::abs;
  using std::sqrt;
  const TestType tolerance = 8 * std::numeric_limits<TestType>::epsilon(), turn = pi<TestType>();
  SECTION("equilateral")
  for (const TestType& angle : Triangle_angles<TestType>(log_lengths<TestType>(7, 7, 7)).angle)
    CHECK(abs(angle - turn / 3) <= tolerance);
  SECTION("half of a square")
  {
    const Triangle_angles<TestType> half(log_lengths<TestType>(1, sqrt(TestType(2)), 1));
    CHECK(abs(half.angle[0] - turn / 4) <= tolerance);
    CHECK(abs(half.angle[1] - turn / 2) <= tolerance);
    CHECK(abs(half.cotangent[0] - 1) <= 1e-14);
    CHECK(abs(half.cotangent[1]) <= 1e-14);
  }
}

TEMPLATE_TEST_CASE("the sum of angles, the law of sines, cotangents", "[Triangle_angles]", double, long double, Wide)
{
  using std::abs;
  using std::exp;
  using std::sin;
  using std::tan;
  CGAL::Random random(1);
  const TestType epsilon = std::numeric_limits<TestType>::epsilon();
  for (int i = 0; i < 500; ++i) {
    const TestType a = random.uniform_real(0.01, 1.), b = random.uniform_real(0.01, 1.),
                   unit = random.uniform_real(-300., 300.);
    const TestType c =
        abs(a - b) + (a + b - abs(a - b)) * TestType(random.uniform_real(0.001, 0.999)); // between |a - b| and a + b
    std::array<TestType, 3> l = log_lengths<TestType>(a, b, c);
    for (TestType& x : l)
      x += unit; // no influence
    const Triangle_angles<TestType> t(l);
    REQUIRE(t.is_triangle);
    CHECK(abs(t.angle[0] + t.angle[1] + t.angle[2] - pi<TestType>()) <= 16 * epsilon);
    for (int k = 0; k < 3; ++k) {
      const int j = (k + 1) % 3;
      // Angles depend on lengths, whose logarithms have an absolute error of epsilon |unit|, the more the thinner the triangle.
      CHECK(abs(sin(t.angle[k]) * exp(TestType(l[j] - l[k])) - sin(t.angle[j])) <= 1e8 * epsilon);
      CHECK(abs(static_cast<double>(TestType(tan(t.angle[k]))) * t.cotangent[k] - 1) <= 1e-7);
    }
  }
}

TEST_CASE("needles keep their relative accuracy", "[Triangle_angles]")
{
  // Two long sides of length 1; the angle between them is 2 asin(c / 2), close to c.
  for (const double c : {1e-3, 1e-8, 1e-15, 1e-100}) {
    const Triangle_angles<double> needle(std::array<double, 3>{{0., 0., std::log(c)}});
    CHECK(needle.is_triangle);
    CHECK(needle.angle[2] / (2 * std::asin(std::exp(std::log(c)) / 2)) == Approx(1).epsilon(1e-14));
    CHECK(std::abs(needle.angle[0] + needle.angle[1] + needle.angle[2] - pi<double>()) <= 1e-15);
  }
}

TEST_CASE("where the triangle inequality fails, the longest side takes all", "[Triangle_angles]")
{
  for (int longest = 0; longest < 3; ++longest)
    for (const double length : {2., 2.5, 1e10}) {
      std::array<double, 3> l{};
      l[longest] = std::log(length) + 1e-15;
      const Triangle_angles<double> none(l);
      CHECK_FALSE(none.is_triangle);
      for (int i = 0; i < 3; ++i) {
        CHECK(none.angle[i] == (i == longest ? pi<double>() : 0.));
        CHECK(none.cotangent[i] == 0);
      }
    }
}

} // namespace Triangle_angles_test
