// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/move_place.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <vector>

namespace move_place_test {

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Mesh::Face_index;
using Rational = CGAL::Exact_rational;
template <typename FT>
using Place = CGAL::T_splines::T_mesh_place<Mesh, FT>;
template <typename FT>
using Pieces = std::vector<CGAL::T_splines::T_mesh_piece<Mesh, FT>>;
template <typename FT>
using Similarity = CGAL::T_splines::Similarity_2<FT>;
using CGAL::T_splines::move_place;

const Face a(0), b(1), c(2);

// [0, 4] x [0, 2] is cut at u = 2; the right part turns by a quarter and is half as large.
Pieces<Rational> cut()
{
  const Rational half = Rational(1) / 2;
  return {{a, a, Similarity<Rational>(), 2, 2}, {a, b, Similarity<Rational>(1, half, 1, -1), 1, 1}};
}

} // namespace

TEST_CASE("A place goes by the first piece that takes it into its closed rectangle", "[move_place]")
{
  const Pieces<Rational> pieces = cut();
  const auto check = [&](Place<Rational> place, const std::size_t way, const Place<Rational>& expected) {
    CHECK(move_place(place, pieces) == &pieces[way]);
    CHECK(place.face == expected.face);
    CHECK(place.u == expected.u);
    CHECK(place.v == expected.v);
  };
  check({a, 1, 1}, 0, {a, 1, 1});
  check({a, 2, 0}, 0, {a, 2, 0}); // on the cut
  check({a, 0, 0}, 0, {a, 0, 0}); // corners
  check({a, 4, 0}, 1, {b, 1, 1});
  check({a, 4, 2}, 1, {b, 0, 1});
  check({a, 3, 1}, 1, {b, Rational(1) / 2, Rational(1) / 2});
}

TEST_CASE("A place in another face stays as it is", "[move_place]")
{
  Place<Rational> place{c, 1, 1};
  CHECK(move_place(place, cut()) == nullptr);
  CHECK(place.face == c);
  CHECK(place.u == 1);
}

TEST_CASE("What round-off leaves outside goes into the rectangle that it misses by least", "[move_place]")
{
  const Pieces<double> pieces{{a, a, Similarity<double>(), 2, 2}, {a, b, Similarity<double>(0, 1, -2, 0), 2, 2}};
  Place<double> place{a, 4 + 1e-15, 1};
  CHECK(move_place(place, pieces) == &pieces[1]);
  CHECK(place.face == b);
  CHECK(place.u == 2);
  CHECK(place.v == 1);
  place = {a, -1e-15, 2 + 1e-15};
  CHECK(move_place(place, pieces) == &pieces[0]);
  CHECK(place.face == a);
  CHECK(place.u == 0);
  CHECK(place.v == 2);
}

TEST_CASE("Places in doubles follow exact faces, and exact places follow faces in doubles", "[move_place]")
{
  Place<double> rounded{a, 0.25, 0.5};
  move_place(rounded, Pieces<Rational>{{a, c, Similarity<Rational>(2, Rational(1) / 2, 3, 3), 4, 4}});
  CHECK(rounded.face == c);
  CHECK(rounded.u == 2.875);
  CHECK(rounded.v == 2.75);
  const Rational third = Rational(1) / 3;
  Place<Rational> exact{a, third, 0};
  move_place(exact, Pieces<double>{{a, c, Similarity<double>(1, 0.5, 3, 3), 4, 4}});
  CHECK(exact.u == 3);
  CHECK(exact.v == 3 + third / 2);
}

} // namespace move_place_test
