// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/check_admissibility.h>

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace check_admissibility_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using Status = CGAL::T_splines::Admissibility_status;
using CGAL::T_splines::check_admissibility;
using test_t_meshes::Faces;

// Two rings around a cylinder, one face each, as in [CZ17] Fig. 6 right: with one turn the upper one becomes higher by
// the edge 3, the lower one lower by the edge 6. The edge 0 between them is closed.
template <typename FT>
Faces<FT> two_rings(const FT& upper_seam_left, const FT& upper_seam_right, const FT& upper_step,
                    const FT& lower_seam_left, const FT& lower_seam_right, const FT& lower_step)
{
  const FT one(1);
  return {
      {{0, one, true}, {2, upper_seam_right, false}, {3, upper_step, true}, {1, one, true}, {2, upper_seam_left, true}},
      {{4, one, true},
       {5, lower_seam_right, true},
       {0, one, true},
       {5, lower_seam_left, false},
       {6, lower_step, true}}};
}

template <typename FT>
CGAL::T_splines::Admissibility_report<Surface_mesh> report(const Faces<FT>& faces)
{
  test_t_meshes::T_mesh<Surface_mesh, FT> t_mesh(faces);
  return check_admissibility(t_mesh);
}

} // namespace

TEMPLATE_TEST_CASE("T-meshes with cones, scale factors and borders are admissible", "[check_admissibility]",
                   (std::tuple<Surface_mesh, Rational>), (std::tuple<Surface_mesh, double>),
                   (std::tuple<Polyhedron, Rational>), (std::tuple<Polyhedron, double>))
{
  using TMesh = typename std::tuple_element<0, TestType>::type;
  using FT = typename std::tuple_element<1, TestType>::type;
  for (const Faces<FT>& faces :
       {test_t_meshes::cube<FT>(), test_t_meshes::torus<FT>(3, 2), test_t_meshes::torus<FT>(1, 1),
        test_t_meshes::folded_square<FT>(), test_t_meshes::pillow<FT>(), test_t_meshes::genus_two<FT>(),
        test_t_meshes::pinwheel<FT>(FT(3) / FT(2)), test_t_meshes::rectangle<FT>(3, 2)}) {
    test_t_meshes::T_mesh<TMesh, FT> t_mesh(faces);
    const auto r = check_admissibility(t_mesh);
    INFO(message(r.status) << ", " << r.defect);
    CHECK(r);
    CHECK(r.success());
  }
}

TEST_CASE("of two rings with opposite steps one condition fails whatever the knots are", "[check_admissibility]")
{
  SECTION("the faces are rectangles: the cycle condition fails at the vertex between the rings")
  {
    const auto r = report(two_rings<Rational>(2, 1, 1, 1, 2, 1));
    CHECK(r.status == Status::CYCLE_CONDITION_VIOLATED);
    CHECK_FALSE(r);
    CHECK((r.defect == Approx(3) || r.defect == Approx(-0.75)));
    test_t_meshes::T_mesh<Surface_mesh, Rational> t_mesh(two_rings<Rational>(2, 1, 1, 1, 2, 1));
    CHECK(r.vertex == target(t_mesh.halfedge_of(0, 0), t_mesh.mesh));
  }
  SECTION("the cycle condition holds: a face is no rectangle")
  {
    const auto r = report(two_rings<Rational>(2, 1, 1, 2, 1, 1));
    test_t_meshes::T_mesh<Surface_mesh, Rational> t_mesh(two_rings<Rational>(2, 1, 1, 2, 1, 1));
    CHECK(r.status == Status::OPPOSITE_SIDES_DIFFER);
    CHECK(r.face == t_mesh.face_list[1]);
    CHECK(std::abs(r.defect) > 0.5);
  }
  SECTION("both hold: the steps are zero")
  {
    const auto r = report(two_rings<Rational>(1, 1, 0, 1, 1, 0));
    CHECK(r.status == Status::NON_POSITIVE_KNOT);
    CHECK(r.defect == 0);
  }
  SECTION("one ring alone is admissible")
  {
    Faces<Rational> faces = two_rings<Rational>(2, 1, 1, 1, 2, 1);
    faces.pop_back();
    CHECK(report(faces));
  }
}

TEST_CASE("defects are named with the element and their size", "[check_admissibility]")
{
  using FT = double;
  Faces<FT> faces = test_t_meshes::torus<FT>(3, 2);
  test_t_meshes::T_mesh<Surface_mesh, FT> t_mesh(faces);
  const auto check = [&] { return check_admissibility(t_mesh); };
  const auto h = t_mesh.halfedge_of(4, 1);
  REQUIRE(check());

  SECTION("three or five corners")
  {
    put(t_mesh.corners(), h, false);
    CHECK(check().status == Status::WRONG_CORNER_COUNT);
    CHECK(check().face == t_mesh.face_list[4]);
    CHECK(check().number_of_corners == 3);

    faces[2].insert(faces[2].begin(), {100, 1., true});
    faces.push_back({{100, 1., true}, {101, 1., true}, {102, 1., true}, {103, 1., true}});
    const auto r = report(faces);
    CHECK(r.status == Status::WRONG_CORNER_COUNT);
    CHECK(r.number_of_corners == 5);
  }
  SECTION("no corners at all")
  {
    for (int i = 0; i < 4; ++i)
      put(t_mesh.corners(), t_mesh.halfedge_of(4, i), false);
    CHECK(check().status == Status::WRONG_CORNER_COUNT);
    CHECK(check().number_of_corners == 0);
  }
  SECTION("negative, infinite and undefined intervals")
  {
    put(t_mesh.knots(), h, -2.);
    CHECK(check().status == Status::NON_POSITIVE_KNOT);
    CHECK(check().halfedge == h);
    CHECK(check().defect == -2);
    put(t_mesh.knots(), h, std::numeric_limits<double>::infinity());
    CHECK(check().status == Status::KNOT_NOT_FINITE);
    put(t_mesh.knots(), h, std::numeric_limits<double>::quiet_NaN());
    CHECK(check().status == Status::KNOT_NOT_FINITE);
    CHECK(check().face == t_mesh.face_list[4]);
  }
  SECTION("sides of different lengths, up to the tolerance")
  {
    const double knot = get(t_mesh.knots(), h);
    put(t_mesh.knots(), h, knot * (1 + 1e-6));
    CHECK(check().status == Status::OPPOSITE_SIDES_DIFFER);
    CHECK(std::abs(check().defect) == Approx(1e-6));
    CHECK(check_admissibility(t_mesh, CGAL::T_splines::parameters::relative_tolerance(1e-5)));
    put(t_mesh.knots(), h, knot * (1 + 1e-12));
    CHECK(check());
  }
}

TEST_CASE("exact knots have no tolerance", "[check_admissibility]")
{
  Faces<Rational> faces = test_t_meshes::torus<Rational>(3, 2);
  faces[3][1].knot += Rational(1) / Rational(1e30);
  CHECK(report(faces).status == Status::OPPOSITE_SIDES_DIFFER);
  faces[3][3].knot += Rational(1) / Rational(1e30);
  CHECK(report(faces).status == Status::CYCLE_CONDITION_VIOLATED);
}

TEST_CASE("extended valences", "[check_admissibility]")
{
  using CGAL::T_splines::extended_valence;
  using CGAL::T_splines::is_extraordinary;
  const auto valences = [](const Faces<double>& faces) {
    test_t_meshes::T_mesh<Surface_mesh, double> t(faces);
    std::vector<int> result;
    for (const auto v : vertices(t.mesh)) {
      result.push_back(extended_valence(v, t));
      CHECK(is_extraordinary(v, t) == (result.back() != (CGAL::T_splines::is_border_vertex(v, t) ? 2 : 4)));
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  CHECK(valences(test_t_meshes::cube<double>()) == std::vector<int>(8, 3));
  CHECK(valences(test_t_meshes::genus_two<double>()) == std::vector<int>{12});
  CHECK(valences(test_t_meshes::folded_square<double>()) == std::vector<int>{1, 1, 2});
  CHECK(valences(test_t_meshes::pinwheel<double>(1.25)) == std::vector<int>(8, 4));
  CHECK(valences(test_t_meshes::rectangle<double>(2, 1)) == std::vector<int>{1, 1, 1, 1, 2, 2});
}

} // namespace check_admissibility_test
