// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Flat_torus.h"

#include <CGAL/T_splines/Similarity_map/internal/Dual_loops.h>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <map>
#include <vector>

namespace Dual_loops_test {

namespace {

using CGAL::T_splines::internal::Dual_loops;
using Vector = Flat_torus::Vector;

// A strip along a row of the grid: through the vertical edges and the diagonals.
std::vector<int> row(const Flat_torus& torus, const int halfedge, const std::size_t length)
{
  std::vector<int> strip(1, halfedge);
  while (strip.size() < length) {
    const int h = strip.back();
    strip.push_back((strip.size() % 2 == 1 ? torus.mesh.next(h) : torus.mesh.previous(h)) ^ 1);
  }
  return strip;
}

bool is_closed_strip(const Flat_torus& torus, const std::vector<int>& strip)
{
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const int exit = strip[(i + 1) % strip.size()] ^ 1;
    if (exit != torus.mesh.next(strip[i]) && exit != torus.mesh.previous(strip[i]))
      return false;
  }
  return !strip.empty();
}

// Twice the way from edge midpoint to edge midpoint along the loop: its homology class, since the torus is flat.
Vector twice_the_way(const Flat_torus& torus, const std::vector<int>& strip)
{
  Vector way{{0, 0}};
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const int h = strip[i], exit = strip[(i + 1) % strip.size()] ^ 1;
    way = exit == torus.mesh.next(h) ? Flat_torus::plus(way, Flat_torus::plus(torus.vector[h], torus.vector[exit]))
                                     : Flat_torus::minus(way, Flat_torus::plus(torus.vector[h], torus.vector[exit]));
  }
  return way;
}

// The intersection number of each loop with each edge, from the loops and from the edges.
void check_index(const Flat_torus& torus, const Dual_loops& loops)
{
  std::map<std::pair<int, int>, std::pair<int, int>> by_loops, by_edges; // (loop, edge) -> passages, sum of signs
  for (int loop = 0; loop < loops.number_of_loops(); ++loop)
    for (const int h : loops.halfedges(loop)) {
      auto& entry = by_loops[{loop, h / 2}];
      ++entry.first;
      entry.second += h % 2 == 0 ? 1 : -1;
    }
  for (int e = 0; e < torus.mesh.number_of_edges(); ++e) {
    CHECK(loops.has_passages(e) == (by_loops.count({0, e}) + by_loops.count({1, e}) + by_loops.count({2, e}) > 0));
    loops.for_each_passage(e, [&](const int loop, const int sign) {
      auto& entry = by_edges[{loop, e}];
      ++entry.first;
      entry.second += sign;
    });
  }
  CHECK(by_loops == by_edges);
}

} // namespace

TEST_CASE("loops stay closed strips of their homology class when edges are flipped", "[Dual_loops]")
{
  for (const int n : {3, 4, 6}) {
    CGAL::Random random(n);
    Flat_torus torus(n, random);
    Dual_loops loops(torus.mesh.number_of_edges());
    const std::size_t length = 2 * n;
    loops.add(row(torus, 2 * 1 + 1, length));           // across the first vertical edge
    loops.add(row(torus, 2 * (3 * n + 1) + 1, length)); // one row above
    loops.add(row(torus, 2 * 1, length));               // another way
    std::vector<Vector> way;
    for (int loop = 0; loop < 3; ++loop) {
      REQUIRE(is_closed_strip(torus, loops.halfedges(loop)));
      way.push_back(twice_the_way(torus, loops.halfedges(loop)));
      CHECK(way.back() != Vector{{0, 0}});
      CHECK(way.back()[0] % (2 * torus.period) == 0);
      CHECK(way.back()[1] % (2 * torus.period) == 0);
    }
    std::size_t flips = 0;
    for (int i = 0; i < 3000; ++i) {
      const int h = random.get_int(0, torus.mesh.number_of_halfedges());
      if (!torus.is_flippable(h))
        continue;
      ++flips;
      torus.flip_vectors(h);
      loops.flip(torus.mesh, h);
      for (int loop = 0; loop < 3; ++loop) {
        const std::vector<int> strip = loops.halfedges(loop);
        REQUIRE(is_closed_strip(torus, strip));
        REQUIRE(twice_the_way(torus, strip) == way[loop]);
      }
      if (i % 100 == 0)
        check_index(torus, loops);
    }
    CHECK(flips > 100);
  }
}

TEST_CASE("corners are passed on the side on which they lie", "[Dual_loops]")
{
  CGAL::Random random(5);
  Flat_torus torus(4, random);
  Dual_loops loops(torus.mesh.number_of_edges());
  const std::vector<int> strip = row(torus, 3, 8);
  loops.add(strip);
  std::size_t i = 0;
  loops.for_each_corner(torus.mesh, 0, [&](const int h, const bool turns_left) {
    REQUIRE(h == strip[i]);
    const int exit = strip[++i % strip.size()] ^ 1;
    // Halfedges are crossed from right to left, so their sources are on the left of the loop.
    CHECK(turns_left == (torus.mesh.target(exit) == torus.mesh.source(h)));
  });
  CHECK(i == strip.size());
}

} // namespace Dual_loops_test
