// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Flat_torus.h"

#include <CGAL/T_splines/Similarity_map/internal/Normal_coordinates.h>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace Normal_coordinates_test {

namespace {

using CGAL::T_splines::internal::Normal_coordinates;
using Vector = Flat_torus::Vector;
using Number = Flat_torus::Number;

/// Flips on a flat torus, with the coordinates of its first triangulation.
struct Flipped_torus {
  CGAL::Random random;
  Flat_torus torus, first;
  Normal_coordinates coordinates;
  std::vector<int> flips;

  Flipped_torus(const int n, const unsigned int seed)
    : random(seed),
      torus(n, random),
      first(torus),
      coordinates(torus.mesh)
  {
  }

  bool flip(const int h)
  {
    if (!torus.is_flippable(h))
      return false;
    Normal_coordinates::Flip update(coordinates, torus.mesh, h);
    torus.flip_vectors(h);
    torus.mesh.flip(h);
    update.finish(torus.mesh);
    flips.push_back(h);
    return true;
  }

  void flip_at_random(const int attempts)
  {
    for (int i = 0; i < attempts; ++i)
      flip(random.get_int(0, torus.mesh.number_of_halfedges()));
  }
};

// Whether the interiors of two segments cross in one point.
bool cross(const Vector& p, const Vector& d, const Vector& q, const Vector& e)
{
  const auto side = [](const Vector& o, const Vector& v, const Vector& x) {
    return Flat_torus::cross(v, Flat_torus::minus(x, o));
  };
  const Number a = side(p, d, q), b = side(p, d, Flat_torus::plus(q, e)), c = side(q, e, p),
               f = side(q, e, Flat_torus::plus(p, d));
  return ((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && f < 0) || (c < 0 && f > 0));
}

// Crossings of an edge with the edges of the first triangulation and all their translates.
int crossings(const Flipped_torus& t, const int edge)
{
  const Vector p = t.torus.position[t.torus.mesh.source(2 * edge)], d = t.torus.vector[2 * edge];
  const Number reach = std::max(std::abs(d[0]), std::abs(d[1])) / t.torus.period + 2;
  int count = 0;
  for (int e = 0; e < t.first.mesh.number_of_edges(); ++e)
    for (Number i = -reach; i <= reach; ++i)
      for (Number j = -reach; j <= reach; ++j) {
        const Vector q =
            Flat_torus::plus(t.first.position[t.first.mesh.source(2 * e)], {{i * t.torus.period, j * t.torus.period}});
        count += cross(p, d, q, t.first.vector[2 * e]) ? 1 : 0;
      }
  return count;
}

bool is_first_edge(const Flipped_torus& t, const int edge)
{
  const int source = t.torus.mesh.source(2 * edge);
  for (int h = 0; h < t.first.mesh.number_of_halfedges(); ++h)
    if (t.first.mesh.source(h) == source && t.first.vector[h] == t.torus.vector[2 * edge])
      return true;
  return false;
}

// The k-th halfedge around v in the first triangulation.
int numbered_halfedge(const Flat_torus& first, const int v, const int k)
{
  int h = first.mesh.outgoing_halfedges()[v];
  for (int i = 0; i < k; ++i)
    h = first.mesh.next_around_source(h);
  return h;
}

} // namespace

TEST_CASE("crossings are counted as straight lines have them", "[Normal_coordinates]")
{
  for (const int n : {1, 2, 3, 5}) {
    Flipped_torus t(n, 10 + n);
    for (int round = 0; round < 6; ++round) {
      for (int e = 0; e < t.torus.mesh.number_of_edges(); ++e) {
        CHECK(t.coordinates.is_shared(e) == is_first_edge(t, e));
        CHECK(t.coordinates.number_of_crossings(e) == crossings(t, e));
      }
      t.flip_at_random(2 * n * n);
    }
    CHECK(t.flips.size() > 0);
  }
}

TEST_CASE("edges are traced as straight lines run", "[Normal_coordinates]")
{
  for (const int n : {1, 2, 3, 5}) {
    Flipped_torus t(n, 20 + n);
    t.flip_at_random(10 * n * n);
    std::vector<std::vector<std::pair<double, Normal_coordinates::Count>>> on_edge(t.torus.mesh.number_of_edges());
    int count = 0;
    t.coordinates.for_each_reference_halfedge(
        t.torus.mesh,
        [&](const int v, const int k, const Normal_coordinates::Curve& curve) {
          ++count;
          const Vector straight = t.first.vector[numbered_halfedge(t.first, v, k)];
          REQUIRE(t.torus.mesh.source(curve.first_corner) == v);
          REQUIRE(t.torus.mesh.face(curve.first_corner) == t.torus.mesh.face(curve.crossings.front().halfedge));
          Vector source =
              t.torus.vector[curve.first_corner]; // of the halfedge by which a triangle is left, seen from v
          for (std::size_t i = 0; i < curve.crossings.size(); ++i) {
            const int exit = curve.crossings[i].halfedge;
            const Vector d = t.torus.vector[exit];
            const Number right = Flat_torus::cross(straight, source),
                         left = Flat_torus::cross(straight, Flat_torus::plus(source, d));
            CHECK(right < 0);
            CHECK(left > 0);
            const double along = double(right) / double(right - left);
            const Normal_coordinates::Count position = curve.crossings[i].position;
            if (exit % 2 == 0)
              on_edge[exit / 2].emplace_back(along, position);
            else
              on_edge[exit / 2].emplace_back(1 - along, t.coordinates.number_of_crossings(exit / 2) - 1 - position);
            if (i + 1 < curve.crossings.size()) {
              const int following = curve.crossings[i + 1].halfedge, entry = exit ^ 1;
              const bool is_next = following == t.torus.mesh.next(entry);
              REQUIRE((is_next || following == t.torus.mesh.previous(entry)));
              source = is_next ? source : Flat_torus::plus(source, t.torus.vector[t.torus.mesh.next(entry)]);
            }
            else {
              CHECK(curve.last_corner == t.torus.mesh.previous(exit ^ 1));
              CHECK(Flat_torus::plus(source, t.torus.vector[t.torus.mesh.next(exit ^ 1)]) == straight);
            }
          }
        },
        [&](const int v, const int k, const int h) {
          ++count;
          CHECK(t.torus.mesh.source(h) == v);
          CHECK(t.first.vector[numbered_halfedge(t.first, v, k)] == t.torus.vector[h]);
        });
    CHECK(count == t.first.mesh.number_of_halfedges());
    for (std::size_t e = 0; e < on_edge.size(); ++e) { // each crossing twice: from both ends of the curve
      std::sort(on_edge[e].begin(), on_edge[e].end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      REQUIRE(on_edge[e].size() == std::size_t(2 * t.coordinates.number_of_crossings(int(e))));
      for (std::size_t i = 0; i < on_edge[e].size(); ++i) {
        CHECK(on_edge[e][i].second == Normal_coordinates::Count(i / 2));
        CHECK((i < 2 || on_edge[e][i].first > on_edge[e][i - 2].first));
      }
    }
  }
}

TEST_CASE("flips are undone by flips", "[Normal_coordinates]")
{
  Flipped_torus t(4, 30);
  t.flip_at_random(500);
  const std::vector<int> flips = t.flips;
  REQUIRE(flips.size() > 100);
  for (std::size_t i = flips.size(); i-- > 0;)
    REQUIRE(t.flip(flips[i]));
  for (int e = 0; e < t.torus.mesh.number_of_edges(); ++e)
    CHECK(t.coordinates.is_shared(e));
  int count = 0;
  t.coordinates.for_each_reference_halfedge(
      t.torus.mesh, [](int, int, const Normal_coordinates::Curve&) { FAIL("no edge is crossed"); },
      [&](const int v, const int k, const int h) {
        ++count;
        CHECK(t.first.vector[numbered_halfedge(t.first, v, k)] == t.torus.vector[h]);
      });
  CHECK(count == t.first.mesh.number_of_halfedges());
}

} // namespace Normal_coordinates_test
