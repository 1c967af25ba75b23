// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Tracing/Tracing_traits.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <deque>

namespace Tracing_traits_test {

namespace T = CGAL::T_splines;

namespace {

using FT = CGAL::Exact_rational;
using Traits = T::Exact_tracing_traits<FT>;

/// Numbers in all forms that maps store: doubles, and fractions with an interval.
class Numbers {
public:
  Traits::Coordinate number(const FT& x)
  {
    const auto interval = CGAL::to_interval(x);
    if (interval.first == interval.second)
      return {interval.first, interval.second, nullptr};
    m_values.push_back(x);
    return {interval.first, interval.second, &m_values.back()};
  }

private:
  std::deque<FT> m_values;
};

CGAL::Orientation exact_orientation(const std::array<FT, 6>& x)
{
  return CGAL::sign((x[2] - x[0]) * (x[5] - x[1]) - (x[3] - x[1]) * (x[4] - x[0]));
}

} // namespace

TEST_CASE("predicates agree with exact arithmetic, close to their zeros and at all sizes", "[Tracing_traits]")
{
  CGAL::Random random(1);
  Numbers numbers;
  const Traits traits;
  int zeros = 0;
  for (int n = 0; n < 20000; ++n) {
    const double size = std::ldexp(1., random.get_int(-300, 300)), shift = std::ldexp(size, random.get_int(0, 60));
    std::array<FT, 6> x;
    for (int i = 0; i < 4; ++i) {
      x[i] = FT(shift) + FT(size * random.get_double(-1, 1));
      if (random.get_bool())
        x[i] /= 3;
    }
    // a point on the line, or next to it
    const FT t = FT(random.get_int(-5, 6)) / FT(random.get_int(1, 6));
    x[4] = x[0] + t * (x[2] - x[0]);
    x[5] = x[1] + t * (x[3] - x[1]);
    if (n % 3 != 0)
      x[5] += FT(std::ldexp(size, random.get_int(-120, 2)) * random.get_double(-1, 1));
    const auto point = [&](const int i) { return Traits::Point{numbers.number(x[i]), numbers.number(x[i + 1])}; };
    const CGAL::Orientation orientation = exact_orientation(x);
    zeros += orientation == CGAL::ZERO ? 1 : 0;
    REQUIRE(traits.orientation(point(0), point(2), point(4)) == orientation);
    REQUIRE(traits.compare(numbers.number(x[1]), numbers.number(x[5])) == CGAL::compare(x[1], x[5]));
  }
  CHECK(zeros > 5000);
  CHECK(traits.statistics().calls == 40000);
  CHECK(traits.statistics().exact_calls > static_cast<std::size_t>(zeros));
  CHECK(traits.statistics().exact_calls < 40000);
}

TEST_CASE("the filter answers what is clear", "[Tracing_traits]")
{
  Numbers numbers;
  const Traits traits;
  const auto point = [&](const FT& u, const FT& v) { return Traits::Point{numbers.number(u), numbers.number(v)}; };
  const FT third = FT(1) / 3;
  CHECK(traits.orientation(point(0, 0), point(third, 0), point(0, third)) == CGAL::POSITIVE);
  CHECK(traits.orientation(point(0, 0), point(0, third), point(third, 0)) == CGAL::NEGATIVE);
  CHECK(traits.compare(numbers.number(third), numbers.number(1)) == CGAL::SMALLER);
  CHECK(traits.compare(numbers.number(2), numbers.number(2)) == CGAL::EQUAL);
  const auto same = numbers.number(third);
  CHECK(traits.compare(same, same) == CGAL::EQUAL);
  CHECK(traits.statistics().calls == 5);
  CHECK(traits.statistics().exact_calls == 0);
}

TEST_CASE("without exactness, a determinant of round-off decides", "[Tracing_traits]")
{
  const T::Inexact_tracing_traits traits;
  const auto point = [](const double u, const double v) {
    return T::Inexact_tracing_traits::Point{{u, u, nullptr}, {v, v, nullptr}};
  };
  CHECK(traits.orientation(point(0, 0), point(1, 0), point(0, 1)) == CGAL::POSITIVE);
  // To the left by 2^-80, which is lost where 1 is added.
  CHECK(traits.orientation(point(-1, -1), point(1, 1), point(0, std::ldexp(1., -80))) == CGAL::ZERO);
  CHECK(traits.statistics().calls == 2);
}

} // namespace Tracing_traits_test
