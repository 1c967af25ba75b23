// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <limits>

namespace ts = CGAL::T_splines;
using Status = ts::Triangle_mesh_status;
using Mesh = test::Surface_mesh;

TEMPLATE_TEST_CASE("closed triangle meshes are accepted, whatever their size and place", "", test::Surface_mesh,
                   test::Polyhedron_3, test::Linear_cell_complex)
{
  for (const test::Soup& soup :
       {test::torus(6, 5), test::plate(2), test::disjoint_union(test::torus(6, 5), test::plate(0))}) {
    CHECK(ts::check_triangle_mesh(test::to_mesh<TestType>(soup)).success());
    CHECK(ts::check_triangle_mesh(test::to_mesh<TestType>(test::transformed(soup, 1e-9, {0, 0, 0}))).success());
    CHECK(ts::check_triangle_mesh(test::to_mesh<TestType>(test::transformed(soup, 1, {1e7, -1e7, 1e7}))).success());
  }
}

TEST_CASE("each defect of a mesh is named with its element")
{
  SECTION("empty")
  {
    CHECK(ts::check_triangle_mesh(Mesh()).status == Status::EMPTY);
  }
  Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  const Mesh::Vertex_index v(7);
  SECTION("not a number")
  {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      mesh.point(v) = test::Point_3(0, bad, 0);
      const auto report = ts::check_triangle_mesh(mesh);
      CHECK(report.status == Status::NON_FINITE_POINT);
      CHECK(report.vertex == v);
    }
  }
  SECTION("isolated vertex")
  {
    const Mesh::Vertex_index isolated = mesh.add_vertex(test::Point_3(0, 0, 0));
    const auto report = ts::check_triangle_mesh(mesh);
    CHECK(report.status == Status::ISOLATED_VERTEX);
    CHECK(report.vertex == isolated);
  }
  SECTION("two ends of an edge coincide")
  {
    mesh.point(target(halfedge(v, mesh), mesh)) = mesh.point(source(halfedge(v, mesh), mesh));
    const auto report = ts::check_triangle_mesh(mesh);
    CHECK(report.status == Status::ZERO_LENGTH_EDGE);
    CHECK(mesh.point(source(report.halfedge, mesh)) == mesh.point(target(report.halfedge, mesh)));
  }
  SECTION("collinear corners, exactly")
  {
    const auto h = halfedge(v, mesh);
    mesh.point(source(h, mesh)) = test::Point_3(1e7, 1, 0);
    mesh.point(v) = test::Point_3(1e7, 2, 0);
    mesh.point(target(next(h, mesh), mesh)) = test::Point_3(1e7, 4, 0);
    CHECK(ts::check_triangle_mesh(mesh).status == Status::ZERO_AREA_FACE);
    // The next double is another point, and the face is no longer degenerate.
    mesh.point(target(next(h, mesh), mesh)) = test::Point_3(std::nextafter(1e7, 2e7), 4, 0);
    CHECK(ts::check_triangle_mesh(mesh).face != face(h, mesh));
  }
  SECTION("border")
  {
    const Mesh punctured = test::to_mesh<Mesh>(test::punctured_torus());
    const auto report = ts::check_triangle_mesh(punctured);
    CHECK(report.status == Status::BORDER);
    CHECK(punctured.is_border(report.halfedge));
    CHECK(ts::check_triangle_mesh(punctured, ts::parameters::border_is_allowed(true)).success());
  }
  SECTION("polygon")
  {
    const auto quad = CGAL::Euler::join_face(mesh.halfedge(v), mesh);
    const auto report = ts::check_triangle_mesh(mesh);
    CHECK(report.status == Status::NOT_TRIANGULATED);
    CHECK(report.face == face(quad, mesh));
  }
  SECTION("two fans at a vertex")
  {
    Mesh bow;
    const auto center = bow.add_vertex(test::Point_3(0, 0, 0));
    for (const double sign : {1., -1.}) {
      const auto a = bow.add_vertex(test::Point_3(sign, 0, 0)), b = bow.add_vertex(test::Point_3(sign, sign, 0));
      bow.add_face(center, a, b);
    }
    const auto report = ts::check_triangle_mesh(bow, ts::parameters::border_is_allowed(true));
    CHECK(report.status == Status::NON_MANIFOLD_VERTEX);
    CHECK(report.vertex == center);
  }
}

TEST_CASE("every status of a mesh has a sentence")
{
  for (int i = 0; i <= static_cast<int>(Status::ZERO_AREA_FACE); ++i)
    CHECK(std::strlen(message(static_cast<Status>(i))) > 0);
}
