// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/T_spline_report.h>

#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace T_spline_report_test {

namespace {

using namespace spline_tests;
using CGAL::T_splines::Admissibility_status;
using CGAL::T_splines::Spline_compatibility_status;
using CGAL::T_splines::T_spline_status;
using Mesh = Spline_mesh<double>;
using Point_3 = Kernel::Point_3;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("a T-mesh that is not spline compatible is refused", "[T_spline_report]")
{
  CGAL::Random random(1);
  Mesh t(test_t_meshes::cube<double>());
  t.set_random_controls(random);
  Mesh::Surface surface = t.surface();
  CHECK_FALSE(surface.is_valid());
  CHECK(surface.report().status == T_spline_status::NOT_SPLINE_COMPATIBLE);
  CHECK(surface.report().compatibility.status == Spline_compatibility_status::IRREGULAR_RINGS);
  CHECK(CGAL::T_splines::is_extraordinary(surface.report().compatibility.vertex, t));
  CHECK_FALSE(surface.update_control_points());
  CHECK(surface.report().status == T_spline_status::NOT_SPLINE_COMPATIBLE);
  CHECK(describe(surface.report(), t.mesh).find("condition A") != std::string::npos);
}

TEST_CASE("an inadmissible T-mesh is refused", "[T_spline_report]")
{
  CGAL::Random random(2);
  for (const double knot : {0., -1., 2.5, infinity, not_a_number}) {
    INFO(knot);
    Mesh t(test_t_meshes::torus<double>(6, 5));
    t.set_random_controls(random);
    CHECK(t.surface().is_valid());
    put(t.knots(), t.halfedge_of(7, 1), knot);
    const Mesh::Surface surface = t.surface();
    CHECK(surface.report().status == T_spline_status::NOT_SPLINE_COMPATIBLE);
    CHECK(surface.report().compatibility.status == Spline_compatibility_status::INADMISSIBLE);
    const auto expected = !std::isfinite(knot) ? Admissibility_status::KNOT_NOT_FINITE
                          : knot > 0           ? Admissibility_status::OPPOSITE_SIDES_DIFFER
                                               : Admissibility_status::NON_POSITIVE_KNOT;
    CHECK(surface.report().compatibility.admissibility.status == expected);
    CHECK(surface.report().compatibility.admissibility.face == t.face_list[7]);
    CHECK(describe(surface.report(), t.mesh).find(message(expected)) == 0);
  }
}

TEST_CASE("a bad control point is named, and may be replaced", "[T_spline_report]")
{
  CGAL::Random random(3);
  Mesh t(test_t_meshes::torus<double>(6, 5));
  t.set_random_controls(random);
  Mesh::Surface surface = t.surface();
  REQUIRE(surface.is_valid());
  const auto f = t.face_list[3];
  const Point_3 before = surface.position(f, 0.5, 0.25);
  const auto v = *(vertices(t.mesh).begin() + 17);
  const Mesh::Control_point good = t.control(v);
  const auto check = [&](const Point_3& p, const double weight, const T_spline_status status) {
    t.set_control(v, p, weight);
    CHECK_FALSE(surface.update_control_points());
    CHECK_FALSE(surface.is_valid());
    CHECK(surface.report().status == status);
    CHECK(surface.report().vertex == v);
    CHECK(describe(surface.report(), t.mesh).find("17") != std::string::npos);
    const Mesh::Surface other = t.surface();
    CHECK(other.report().status == status);
    CHECK(other.report().vertex == v);
  };
  check(Point_3(1, not_a_number, 2), 1, T_spline_status::CONTROL_POINT_NOT_FINITE);
  check(Point_3(1, 2, -infinity), 1, T_spline_status::CONTROL_POINT_NOT_FINITE);
  check(Point_3(1, 2, 3), not_a_number, T_spline_status::CONTROL_POINT_NOT_FINITE);
  check(Point_3(1, 2, 3), infinity, T_spline_status::CONTROL_POINT_NOT_FINITE);
  check(Point_3(1, 2, 3), 0, T_spline_status::WEIGHT_NOT_POSITIVE);
  check(Point_3(1, 2, 3), -0.5, T_spline_status::WEIGHT_NOT_POSITIVE);
  check(Point_3(infinity, 2, 3), 0, T_spline_status::CONTROL_POINT_NOT_FINITE);
  t.set_control(v, good.point(), good.weight());
  CHECK(surface.update_control_points());
  CHECK(surface.report());
  CHECK(surface.report().status == T_spline_status::VALID);
  CHECK(surface.position(f, 0.5, 0.25) == before);
}

TEST_CASE("borders that carry no spline are refused", "[T_spline_report]")
{
  CGAL::Random random(4);
  Mesh narrow(test_t_meshes::rectangle<double>(2, 5));
  narrow.set_random_controls(random);
  CHECK(narrow.surface().report().compatibility.status == Spline_compatibility_status::TOO_FEW_BORDER_INTERVALS);

  Mesh touching(test_t_meshes::squares<double>({{0, 1, 2, 3}, {4, 5, 6, 7}}));
  test_t_meshes::join_corners_of_two_faces(touching);
  touching.set_random_controls(random);
  CHECK(touching.surface().report().compatibility.status == Spline_compatibility_status::TOUCHING_BORDERS);

  Mesh bent(test_t_meshes::fan<double>(3, 2));
  bent.set_random_controls(random);
  CHECK(bent.surface().report().compatibility.status == Spline_compatibility_status::IRREGULAR_RINGS);
}

} // namespace T_spline_report_test
