// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>

#include "Spline/Spline_mesh.h"
#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <array>
#include <set>
#include <string>
#include <tuple>

namespace check_spline_compatibility_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using Status = CGAL::T_splines::Spline_compatibility_status;
using CGAL::T_splines::check_spline_compatibility;
using CGAL::T_splines::extended_valence;
using CGAL::T_splines::is_border_vertex;

template <typename Mesh>
auto report_of(Mesh& t)
{
  return check_spline_compatibility(t);
}

template <typename FT>
Status status_of(const test_t_meshes::Faces<FT>& faces)
{
  test_t_meshes::T_mesh<Surface_mesh, FT> t(faces);
  return report_of(t).status;
}

template <typename Mesh>
bool is_corner_of(Mesh& t, const typename Mesh::face_descriptor f, const typename Mesh::vertex_descriptor v)
{
  for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh))
    if (target(h, t.mesh) == v && get(t.corners(), h))
      return true;
  return false;
}

// The cone of a star.
template <typename Mesh>
typename Mesh::vertex_descriptor cone_of(const Mesh& t)
{
  return source(t.halfedge_of(0, 0), t.mesh);
}

// Divides the squares around the cone of a star into nine each: rings with T-joints on their rim.
template <typename Mesh>
void divide_inner_squares(Mesh& t, const int sectors, const int n)
{
  using FT = typename Mesh::FT;
  CGAL::T_splines::T_mesh_editor editor(t);
  for (int s = 0; s < sectors; ++s) {
    const int square = n * n * s;
    const FT third = FT(square + 1) / FT(3);
    std::array<typename Mesh::face_descriptor, 3> column{t.face_list[square]};
    for (int x = 0; x < 2; ++x)
      column[x + 1] = face(opposite(editor.split_face(column[x], 0, third).halfedge, t.mesh), t.mesh);
    for (auto f : column)
      for (int y = 0; y < 2; ++y)
        f = face(opposite(editor.split_face(f, 1, third).halfedge, t.mesh), t.mesh);
  }
}

} // namespace

TEMPLATE_TEST_CASE("three rings around a cone, and two more before a border, are enough",
                   "[check_spline_compatibility]", (std::tuple<Surface_mesh, Rational>),
                   (std::tuple<Surface_mesh, double>), (std::tuple<Polyhedron, double>))
{
  using Mesh = test_t_meshes::T_mesh<typename std::tuple_element<0, TestType>::type,
                                     typename std::tuple_element<1, TestType>::type>;
  using FT = typename Mesh::FT;
  for (const int sectors : {3, 5, 7})
    for (int n = 1; n <= 6; ++n) {
      INFO(sectors << " sectors, " << n << " rings");
      Mesh t(test_t_meshes::star<FT>(sectors, n));
      const auto report = report_of(t);
      if (n < 3) {
        CHECK(report.status == Status::IRREGULAR_RINGS);
        CHECK(report.vertex == cone_of(t));
        continue;
      }
      CHECK(report.status == (n < 5 ? Status::BORDER_IN_RINGS : Status::SPLINE_COMPATIBLE));
      CHECK(bool(report) == (n >= 5));
      if (n < 5)
        CHECK(report.extraordinary_vertex == cone_of(t));
    }
}

TEST_CASE("supports on a torus may overlap themselves, which they do with less than four columns or rows",
          "[check_spline_compatibility]")
{
  for (int columns = 1; columns <= 5; ++columns)
    for (int rows = 1; rows <= 5; ++rows) {
      INFO(columns << " columns, " << rows << " rows");
      // The lattice of translations is made of (columns, 0) and (1, rows).
      const bool is_large = columns >= 4 && rows >= 4;
      test_t_meshes::T_mesh<Surface_mesh, Rational> exact(test_t_meshes::torus<Rational>(columns, rows));
      test_t_meshes::T_mesh<Surface_mesh, double> rounded(test_t_meshes::torus<double>(columns, rows));
      const std::size_t number = is_large ? 0 : columns * rows;
      const auto report = report_of(exact);
      CHECK(report);
      CHECK(report.self_overlapping_supports == number);
      CHECK(report_of(rounded).self_overlapping_supports == number);
    }
}

TEMPLATE_TEST_CASE("a support must not contain the centre of a spiral", "[check_spline_compatibility]", Rational,
                   double)
{
  using FT = TestType;
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, FT>;
  for (const FT& scale : {FT(FT(3) / FT(2)), FT(2), FT(FT(9) / FT(8))}) {
    INFO("scale " << scale);
    Mesh t(test_t_meshes::pinwheel<FT>(scale));
    const auto report = report_of(t);
    CHECK(report.status == Status::ENDLESS_SUPPORT);
    CHECK(report.vertex != Surface_mesh::null_vertex());
    CHECK(report.face != Surface_mesh::null_face());
  }
  // Of n x n parts of each face, those at the inner square are 2 c / n long, c < 3 / 2, and it is 1 from the centre.
  Mesh fine(spline_tests::refined(test_t_meshes::pinwheel<FT>(FT(9) / FT(8)), FT(FT(1) / FT(8))));
  CHECK(report_of(fine));
}

TEST_CASE("between two borders there must be three intervals", "[check_spline_compatibility]")
{
  for (int columns = 1; columns <= 4; ++columns)
    for (int rows = 1; rows <= 4; ++rows) {
      INFO(columns << " columns, " << rows << " rows");
      CHECK(status_of(test_t_meshes::rectangle<double>(columns, rows)) ==
            (columns >= 3 && rows >= 3 ? Status::SPLINE_COMPATIBLE : Status::TOO_FEW_BORDER_INTERVALS));
      CHECK(status_of(test_t_meshes::cylinder<double>(columns + 3, rows)) ==
            (rows >= 3 ? Status::SPLINE_COMPATIBLE : Status::TOO_FEW_BORDER_INTERVALS));
    }
}

TEST_CASE("condition A names the vertex and a face of its rings", "[check_spline_compatibility]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  SECTION("where other cones are too close")
  {
    Mesh t(test_t_meshes::cube<Rational>());
    const auto report = report_of(t);
    CHECK(report.status == Status::IRREGULAR_RINGS);
    CHECK(extended_valence(report.vertex, t) == 3);
    CHECK(report.face != Surface_mesh::null_face());
  }
  SECTION("where a face is not square, or has a T-joint")
  {
    const int n = 6;
    Mesh t(test_t_meshes::star<Rational>(5, n));
    CGAL::T_splines::T_mesh_editor editor(t);
    const int x = GENERATE(0, 1, 2, 3), y = GENERATE(0, 1, 2, 3);
    const Surface_mesh::Face_index f = t.face_list[n * n + n * y + x];
    REQUIRE(editor.split_face(f, 0, editor.coordinates().width(f) / 2));
    const auto report = report_of(t);
    CAPTURE(x, y);
    // A line behind the rings may only end on their rim.
    CHECK(report.status == (x < 3 && y < 3 ? Status::IRREGULAR_RINGS : Status::SPLINE_COMPATIBLE));
    if (!report)
      CHECK(report.vertex == cone_of(t));
  }
  SECTION("where the cone is a T-joint")
  {
    Mesh t(test_t_meshes::star_with_t_joint<Rational>(5));
    const auto report = report_of(t);
    CHECK(report.status == Status::IRREGULAR_RINGS);
    CHECK(report.vertex == cone_of(t));
  }
}

TEMPLATE_TEST_CASE("condition B names the vertex, the cone and the face", "[check_spline_compatibility]", Rational,
                   double)
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, TestType>;
  const int sectors = GENERATE(3, 5), n = 5;
  Mesh t(test_t_meshes::star<TestType>(sectors, n));
  divide_inner_squares(t, sectors, n);
  const auto report = report_of(t);
  CHECK(report.status == Status::SUPPORT_REACHES_CONE);
  CHECK(report.extraordinary_vertex == cone_of(t));
  CHECK(is_corner_of(t, report.face, cone_of(t)));
  // Two squares away on the diagonal, the only one in its sector.
  std::set<Surface_mesh::Vertex_index> far;
  for (int s = 0; s < sectors; ++s)
    far.insert(source(t.halfedge_of(n * n * s + 2 * n + 2, 0), t.mesh));
  CHECK(far.count(report.vertex) == 1);
}

TEST_CASE("cones of one or two quarter turns need rings as others do", "[check_spline_compatibility]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  for (const auto& faces : {test_t_meshes::pillow<double>(), test_t_meshes::folded_square<double>()}) {
    Mesh t(faces);
    const auto report = report_of(t);
    CHECK(report.status == Status::IRREGULAR_RINGS);
    CHECK(extended_valence(report.vertex, t) <= 2);
  }
}

TEMPLATE_TEST_CASE("a corner of the border that turns inwards needs rings as cones do", "[check_spline_compatibility]",
                   double, Rational)
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, TestType>;
  const int quarters = GENERATE(3, 4, 5, 7);
  Mesh small(test_t_meshes::fan<TestType>(quarters, 2));
  const auto report = report_of(small);
  CHECK(report.status == Status::IRREGULAR_RINGS);
  CHECK(extended_valence(report.vertex, small) == quarters);
  // Three rings, and two intervals beyond them before the next border.
  Mesh near(test_t_meshes::fan<TestType>(quarters, 4)), far(test_t_meshes::fan<TestType>(quarters, 5));
  CHECK(report_of(near).status == Status::BORDER_IN_RINGS);
  CHECK(report_of(far));
}

TEST_CASE("a border that meets itself is not supported", "[check_spline_compatibility]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  Mesh t(test_t_meshes::squares<double>({{0, 1, 2, 3}, {4, 5, 6, 7}}));
  const auto v = test_t_meshes::join_corners_of_two_faces(t);
  const auto report = report_of(t);
  CHECK(report.status == Status::TOUCHING_BORDERS);
  CHECK(report.vertex == v);
}

TEST_CASE("inadmissible knots are told first", "[check_spline_compatibility]")
{
  test_t_meshes::T_mesh<Surface_mesh, double> t(test_t_meshes::pillow<double>());
  put(t.knots(), t.halfedge_of(1, 2), 1.);
  const auto report = report_of(t);
  CHECK(report.status == Status::INADMISSIBLE);
  CHECK(report.admissibility.status == CGAL::T_splines::Admissibility_status::OPPOSITE_SIDES_DIFFER);
  CHECK(report.face == t.face_list[1]);
  CHECK(describe(report, t.mesh).find("two opposite sides of a face have different lengths: face 1, counted from 0") ==
        0);
}

} // namespace check_spline_compatibility_test
