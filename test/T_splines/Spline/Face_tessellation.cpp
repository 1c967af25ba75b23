// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/internal/Face_tessellation.h>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Face_tessellation_test {

namespace {

using CGAL::T_splines::internal::Division_density;

struct Step {
  double begin, end, density;
};

std::vector<double> division(const std::vector<Step>& steps, const int least, const int most)
{
  Division_density density;
  for (const Step& step : steps)
    density.add(step.begin, step.end, step.density);
  return density.division(least, most);
}

// The length of a part, in units of what the largest density in it allows.
double length_of_part(const double begin, const double end, const std::vector<Step>& steps)
{
  double density = 0;
  for (const Step& step : steps)
    if ((std::min)(end, step.end) - (std::max)(begin, step.begin) > 1e-8)
      density = (std::max)(density, step.density);
  return (end - begin) * density;
}

void check_ends(const std::vector<double>& ends)
{
  CHECK(ends.front() == 0);
  CHECK(ends.back() == 1);
  CHECK(std::is_sorted(ends.begin(), ends.end()));
  CHECK(std::adjacent_find(ends.begin(), ends.end()) == ends.end());
}

} // namespace

TEST_CASE("no part is longer than its density allows, and no more parts are made than in each step by itself",
          "[Face_tessellation]")
{
  CGAL::Random random(1);
  for (int example = 0; example < 200; ++example) {
    std::vector<Step> steps;
    double begin = 0, rounded_up = 0;
    for (int i = random.get_int(1, 8); i > 0; --i) {
      const double end = i == 1 ? 1 : begin + random.get_double() * (1 - begin);
      steps.push_back({begin, end, std::pow(10, random.get_double(-2, 2.5))});
      rounded_up += std::ceil((end - begin) * steps.back().density);
      begin = end;
    }
    const std::vector<double> ends = division(steps, 1, 1000);
    check_ends(ends);
    for (std::size_t i = 1; i < ends.size(); ++i)
      CHECK(length_of_part(ends[i - 1], ends[i], steps) < 1 + 1e-6);
    CHECK(static_cast<double>(ends.size() - 1) <= rounded_up);
  }
}

TEST_CASE("the largest of overlapping densities counts, and what is outside does not", "[Face_tessellation]")
{
  const std::vector<double> ends = division({{-1, 2, 4}, {0.25, 0.5, 40}, {1, 2, 1000}, {-5, 0, 1000}}, 1, 1000);
  check_ends(ends);
  CHECK(ends.size() - 1 == 1 + 10 + 2);
  CHECK(ends[1] == Approx(0.25));
  CHECK(ends[11] == Approx(0.5));
}

TEST_CASE("parts are neither fewer nor more than asked for, and equal where the density is", "[Face_tessellation]")
{
  for (const double density : {0., 2., 5., 1e3, 1e30}) {
    const std::vector<double> ends = division({{0, 1, density}}, 3, 16);
    check_ends(ends);
    CHECK(ends.size() - 1 == static_cast<std::size_t>(std::clamp(density, 3., 16.)));
    for (std::size_t i = 1; i < ends.size(); ++i)
      CHECK(ends[i] - ends[i - 1] == Approx(1. / static_cast<double>(ends.size() - 1)).epsilon(0.01));
  }
  CHECK(division({}, 3, 16).size() == 4);
  CHECK(division({{0, 0.1, 1e6}, {0.1, 1, 0}}, 3, 16).size() <= 17);
}

} // namespace Face_tessellation_test
