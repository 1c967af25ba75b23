// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Similarity_map/internal/Chord_arrangement.h>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Chord_arrangement_test {

namespace {

using CGAL::T_splines::internal::Chord_arrangement;
using Chord = Chord_arrangement::Chord;
using Point = std::array<double, 2>;

// Whether chords of a convex polygon cross in their interiors.
bool cross(const Chord& a, const Chord& b)
{
  const auto is_between = [](const int x, const Chord& c) {
    return std::min(c.from, c.to) < x && x < std::max(c.from, c.to);
  };
  const bool ends_differ = a.from != b.from && a.from != b.to && a.to != b.from && a.to != b.to;
  return ends_differ && is_between(b.from, a) != is_between(b.to, a);
}

bool is_same(const Chord& a, const Chord& b)
{
  return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
}

std::vector<Chord> random_family(const int positions, const int attempts, CGAL::Random& random)
{
  std::vector<Chord> family;
  for (int i = 0; i < attempts; ++i) {
    const Chord chord{random.get_int(0, positions), random.get_int(0, positions), i};
    const int apart = (chord.to - chord.from + positions) % positions;
    if (apart >= 2 && apart <= positions - 2 && std::none_of(family.begin(), family.end(), [&](const Chord& c) {
          return cross(c, chord) || is_same(c, chord);
        }))
      family.push_back(chord);
  }
  return family;
}

Point on_circle(const int i, const int positions)
{
  const double turn = 8 * std::atan(1.);
  return {{std::cos(turn * i / positions), std::sin(turn * i / positions)}};
}

Point crossing_point(const Chord& a, const Chord& b, const int positions)
{
  const Point p = on_circle(a.from, positions), q = on_circle(a.to, positions), r = on_circle(b.from, positions),
              s = on_circle(b.to, positions);
  const auto side = [&](const Point& x) { return (s[0] - r[0]) * (x[1] - r[1]) - (s[1] - r[1]) * (x[0] - r[0]); };
  const double t = side(p) / (side(p) - side(q));
  return {{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])}};
}

} // namespace

TEST_CASE("the cells of random chords tile the polygon", "[Chord_arrangement]")
{
  CGAL::Random random(1);
  Chord_arrangement arrangement;
  for (int trial = 0; trial < 200; ++trial) {
    const int positions = random.get_int(4, 25);
    const std::vector<Chord> first = random_family(positions, random.get_int(0, 40), random);
    const std::vector<Chord> second = random_family(positions, random.get_int(0, 40), random);
    arrangement.compute(positions, first, second);

    std::size_t crossings = 0, shared = 0;
    for (const Chord& a : first)
      for (const Chord& b : second) {
        crossings += cross(a, b) ? 1 : 0;
        shared += is_same(a, b) ? 1 : 0;
      }
    REQUIRE(arrangement.crossings().size() == crossings);
    const std::size_t chords = first.size() + second.size() - shared;

    std::vector<Point> point;
    for (int i = 0; i < positions; ++i)
      point.push_back(on_circle(i, positions));
    for (const auto& c : arrangement.crossings())
      point.push_back(crossing_point(first[c.first_chord], second[c.second_chord], positions));

    std::size_t cells = 0, sides = 0;
    double area = 0;
    arrangement.for_each_cell([&](const std::vector<int>& cell) {
      ++cells;
      sides += cell.size();
      double twice = 0;
      for (std::size_t i = 0; i < cell.size(); ++i) {
        const int h = cell[i], next = cell[(i + 1) % cell.size()];
        REQUIRE(arrangement.node(arrangement.twin(h)) == arrangement.node(next));
        CHECK_FALSE(arrangement.is_outer(h));
        const bool has_curve =
            arrangement.first_curve(h) != arrangement.none || arrangement.second_curve(h) != arrangement.none;
        CHECK(has_curve != arrangement.is_boundary(h));
        const Point &p = point[arrangement.node(h)], &q = point[arrangement.node(next)];
        twice += p[0] * q[1] - p[1] * q[0];
      }
      CHECK(twice > -1e-12);
      area += twice / 2;
    });
    CHECK(cells == 1 + chords + crossings);
    const std::size_t edges = positions + chords + 2 * crossings;
    CHECK(sides == 2 * edges - positions); // all but the outer sides of the boundary
    CHECK(positions + static_cast<long>(crossings) - static_cast<long>(edges) + static_cast<long>(cells) == 1);
    CHECK(area == Approx(positions * std::sin(8 * std::atan(1.) / positions) / 2));
  }
}

} // namespace Chord_arrangement_test
