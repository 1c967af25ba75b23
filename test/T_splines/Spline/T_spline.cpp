// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/insert_knot_line.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include "random_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <type_traits>

namespace T_spline_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using T_spline = T::T_spline<Kernel>;
constexpr int n = 6;

// Whether both surfaces are the same, bit by bit.
bool are_equal(const T_spline& a, const T_spline& b)
{
  const auto one = a.surface(), other = b.surface();
  if (!one.is_valid() || !other.is_valid() || a.number_of_control_points() != b.number_of_control_points())
    return false;
  for (const auto f : a.graph().faces())
    for (const double u : {0., 0.3, 1.})
      if (one.position(f, u, 0.4) != other.position(f, u, 0.4))
        return false;
  return true;
}

} // namespace

TEST_CASE("copies of a T-spline have their own control points and weights", "[T_spline]")
{
  const T_spline original = random_torus(n);
  REQUIRE(original.surface().is_valid());
  T_spline copy = original, assigned;
  CHECK_FALSE(assigned.number_of_control_points() > 0);
  assigned = original;
  CHECK(are_equal(original, copy));
  CHECK(are_equal(original, assigned));
  const auto v = *copy.graph().vertices().begin();
  copy.weights()[v] = 7;
  assigned.graph().point(v) = {9, 9, 9};
  CHECK_FALSE(are_equal(original, copy));
  CHECK_FALSE(are_equal(original, assigned));
  CHECK(original.weights()[v] < 7);
}

TEST_CASE("a T-spline is evaluated with its weights, and written and read with them", "[T_spline]")
{
  const T_spline original = random_torus(n);
  std::stringstream file;
  REQUIRE_FALSE(T::write_t_mesh(file, original));
  T_spline read;
  REQUIRE(T::read_t_mesh(file, read).success());
  CHECK(are_equal(original, read));

  // The same with maps of its own, and without weights.
  const T::T_spline_surface weighted(original, original.control_points());
  const T::T_spline_surface plain(original, original.graph().points());
  const auto f = *original.graph().faces().begin();
  CHECK(original.surface().position(f, 0.5, 0.5) == weighted.position(f, 0.5, 0.5));
  CHECK(original.surface().position(f, 0.5, 0.5) != plain.position(f, 0.5, 0.5));
}

TEST_CASE("a T-spline is written and read with its creases", "[T_spline]")
{
  const T_spline smooth = random_torus(n);
  T_spline original = smooth;
  T_spline::Graph& graph = original.graph();
  const auto mark_from = [&](T_spline::halfedge_descriptor h) { // around the torus
    for (int i = 0; i < n; ++i) {
      put(original.creases(), graph.edge(h), true);
      h = graph.next(graph.opposite(graph.next(h)));
    }
  };
  const auto h = graph.halfedge(*graph.faces().begin());
  mark_from(h);
  mark_from(graph.next(h));
  std::stringstream file;
  REQUIRE_FALSE(T::write_t_mesh(file, original));
  T_spline read;
  REQUIRE(T::read_t_mesh(file, read).success());
  int number = 0;
  for (const auto e : read.graph().edges())
    number += get(read.creases(), e);
  CHECK(number == 2 * n);
  CHECK(are_equal(original, read));
  CHECK_FALSE(are_equal(smooth, read));
}

TEST_CASE("a line of knots goes into a T-spline without changing it", "[T_spline]")
{
  T_spline spline = random_torus(n);
  const auto f = *spline.graph().faces().begin();
  const auto before = spline.surface().position(f, 0.25, 0.75);
  REQUIRE(T::insert_knot_line(spline, spline.control_points(), f, 0, 0.5));
  CHECK(spline.number_of_control_points() == n * (n + 1));
  const auto surface = spline.surface();
  REQUIRE(surface.is_valid());
  CHECK(CGAL::squared_distance(before, surface.position(f, 0.25, 0.75)) < 1e-28);
}

} // namespace T_spline_test
