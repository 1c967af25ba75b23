// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Similarity_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <utility>
#include <vector>

namespace Similarity_2_test {

namespace {

using FT = CGAL::Exact_rational;
using Similarity = CGAL::T_splines::Similarity_2<FT>;

FT random_number(CGAL::Random& random)
{
  return FT(random.get_int(-50, 51)) / FT(random.get_int(1, 20));
}

Similarity random_similarity(CGAL::Random& random)
{
  const FT scale = FT(random.get_int(1, 50)) / FT(random.get_int(1, 50));
  return Similarity(random.get_int(-9, 10), scale, random_number(random), random_number(random));
}

} // namespace

TEST_CASE("similarities are a group", "[Similarity_2]")
{
  CGAL::Random random(1);
  const Similarity identity;
  CHECK(identity.is_identity());
  for (int i = 0; i < 100; ++i) {
    const Similarity a = random_similarity(random), b = random_similarity(random), c = random_similarity(random);
    CHECK(compose(compose(a, b), c) == compose(a, compose(b, c)));
    CHECK(compose(a, identity) == a);
    CHECK(compose(identity, a) == a);
    CHECK(compose(a, a.inverse()).is_identity());
    CHECK(compose(a.inverse(), a).is_identity());
    CHECK(compose(a, b).inverse() == compose(b.inverse(), a.inverse()));
    CHECK((a == b) == !(a != b));
  }
}

TEST_CASE("they act on points from the left", "[Similarity_2]")
{
  CGAL::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Similarity a = random_similarity(random), b = random_similarity(random);
    const FT u = random_number(random), v = random_number(random);
    const std::pair<FT, FT> p = b(u, v);
    CHECK(compose(a, b)(u, v) == a(p.first, p.second));
    CHECK(b.inverse()(p.first, p.second) == std::make_pair(u, v));
  }
}

TEST_CASE("a quarter turn is counter-clockwise, and four of them are the identity", "[Similarity_2]")
{
  const Similarity turn(1, 1, 0, 0);
  CHECK(turn(FT(1), FT(0)) == std::make_pair(FT(0), FT(1)));
  CHECK(turn(FT(0), FT(1)) == std::make_pair(FT(-1), FT(0)));
  CHECK(compose(turn, compose(turn, compose(turn, turn))).is_identity());
  for (int r = -8; r <= 8; ++r) {
    CHECK(Similarity(r, 1, 0, 0) == Similarity(r + 4, 1, 0, 0));
    CHECK((Similarity(r, 1, 0, 0).quarter_turns() - r) % 4 == 0);
  }
}

TEST_CASE("distances are multiplied by the scale, orientation is kept", "[Similarity_2]")
{
  CGAL::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Similarity a = random_similarity(random);
    const std::pair<FT, FT> o = a(FT(0), FT(0)), e = a(FT(1), FT(0)), f = a(FT(0), FT(1));
    const FT eu = e.first - o.first, ev = e.second - o.second, fu = f.first - o.first, fv = f.second - o.second;
    CHECK(eu * eu + ev * ev == a.scale() * a.scale());
    CHECK(eu * fv - ev * fu == a.scale() * a.scale());
    CHECK(eu * fu + ev * fv == 0);
  }
}

TEST_CASE("points of a kernel are mapped exactly", "[Similarity_2]")
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const CGAL::T_splines::Similarity_2<Kernel::FT> a(3, Kernel::FT(1) / 3, 2, 5);
  CHECK(a(Kernel::Point_2(3, 6)) == Kernel::Point_2(4, 4));
  CHECK(a.inverse()(Kernel::Point_2(4, 4)) == Kernel::Point_2(3, 6));
}

} // namespace Similarity_2_test
