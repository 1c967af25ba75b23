// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/Control_point_map.h>

#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <CGAL/Polyhedron_3.h>

#include <catch2/catch.hpp>

#include <map>
#include <tuple>
#include <type_traits>

namespace Control_point_map_test {

namespace {

using namespace spline_tests;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using CGAL::T_splines::make_control_point_map;
using CGAL::T_splines::T_spline_surface;
using Point_3 = Kernel::Point_3;

} // namespace

TEST_CASE("a map of control points reads and writes points and weights", "[Control_point_map]")
{
  std::map<int, Point_3> points{{1, Point_3(1, 2, 3)}, {2, Point_3(4, 5, 6)}};
  std::map<int, double> weights{{1, 0.5}, {2, 4}};
  const auto map =
      make_control_point_map(boost::make_assoc_property_map(points), boost::make_assoc_property_map(weights));
  CHECK(get(map, 1) == Kernel::Weighted_point_3(Point_3(1, 2, 3), 0.5));
  CHECK(get(map, 2).weight() == 4);
  put(map, 2, Kernel::Weighted_point_3(Point_3(7, 8, 9), 2));
  CHECK(points.at(2) == Point_3(7, 8, 9));
  CHECK(weights.at(2) == 2);
  CHECK(std::is_same<typename boost::property_traits<decltype(map)>::value_type, Kernel::Weighted_point_3>::value);
}

TEMPLATE_TEST_CASE("control points may be points, weighted points, or points and weights in maps of their own",
                   "[Control_point_map]", Surface_mesh, Polyhedron)
{
  using Mesh = Spline_mesh<double, Kernel, TestType>;
  using Vertex = typename Mesh::vertex_descriptor;
  CGAL::Random random(1);
  Mesh t(torus_with_two_cones<double>());
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  std::map<Vertex, Point_3> points;
  std::map<Vertex, float> weights;
  for (const auto v : vertices(t.mesh)) {
    points[v] = t.control(v).point();
    weights[v] = static_cast<float>(t.control(v).weight());
  }
  const auto point_map = boost::make_assoc_property_map(points);
  const auto map = make_control_point_map(point_map, boost::make_assoc_property_map(weights));
  const auto surface = t.surface();
  const T_spline_surface other(t, map);
  REQUIRE((surface.is_valid() && other.is_valid()));
  for (const auto f : faces(t.mesh)) {
    const double u = surface.width(f) * random.get_double(), v = surface.height(f) * random.get_double();
    CHECK(surface.position(f, u, v) == other.position(f, u, v));
  }

  for (const auto v : vertices(t.mesh))
    t.set_control(v, points[v], 1);
  const auto unweighted = t.surface();
  const T_spline_surface of_points(t, point_map);
  REQUIRE((unweighted.is_valid() && of_points.is_valid()));
  CHECK(of_points.number_of_control_points() == num_vertices(t.mesh));
  for (const auto f : faces(t.mesh)) {
    const double u = surface.width(f) * random.get_double(), v = surface.height(f) * random.get_double();
    CHECK(unweighted.position(f, u, v) == of_points.position(f, u, v));
  }
}

} // namespace Control_point_map_test
