// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>

#include "open_meshes.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <catch2/catch.hpp>

#include <limits>
#include <string>

namespace check_triangle_mesh_test {

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
    const auto report = ts::check_triangle_mesh(punctured, ts::parameters::border_is_allowed(false));
    CHECK(report.status == Status::BORDER);
    CHECK(punctured.is_border(report.halfedge));
    CHECK(ts::check_triangle_mesh(punctured).success());
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
  SECTION("a border that touches itself, and one that touches another")
  {
    for (const bool is_at_border : {false, true}) {
      const auto is_in = [&](const int i, const int j) {
        return !(i == 2 && j == 2) && !(is_at_border ? i == 3 && j > 2 : i == 3 && j == 3);
      };
      Mesh touching = open_meshes::grid(6, 6, is_in, [](const int i, const int j) { return test::Point_3(i, j, 0); });
      const auto report = ts::check_triangle_mesh(touching);
      REQUIRE(report.status == Status::NON_MANIFOLD_VERTEX);
      CHECK(touching.point(report.vertex) == test::Point_3(3, 3, 0));
      CHECK(describe(report, touching).find("duplicate_non_manifold_vertices()") != std::string::npos);
      CHECK(CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(touching) == 1); // as is said
      CHECK(ts::check_triangle_mesh(touching).success());
    }
  }
  SECTION("a curve of the border with two edges")
  {
    const auto h = halfedge(v, mesh);
    open_meshes::open_edge(h, mesh);
    REQUIRE(mesh.is_valid());
    const auto report = ts::check_triangle_mesh(mesh);
    REQUIRE(report.status == Status::BORDER_OF_TWO_EDGES);
    CHECK(mesh.is_border(report.halfedge));
    CHECK(mesh.is_border(mesh.next(report.halfedge)));
    CHECK(ts::check_triangle_mesh(mesh, ts::parameters::border_is_allowed(false)).status == Status::BORDER);
    CHECK(describe(report, mesh).find("stitch_borders()") != std::string::npos);
    CHECK(CGAL::Polygon_mesh_processing::stitch_borders(mesh) == 1);
    CHECK(ts::check_triangle_mesh(mesh).success());
  }
}

TEST_CASE("a refusal says what is wrong, where, and what to do")
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  CHECK(describe(ts::check_triangle_mesh(mesh), mesh) == "the mesh is valid");
  SECTION("empty")
  {
    mesh.clear();
    CHECK(describe(ts::check_triangle_mesh(mesh), mesh) == "the mesh has no face: it needs at least one");
  }
  SECTION("a hole")
  {
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(0), mesh), mesh);
    const auto report = ts::check_triangle_mesh(mesh, ts::parameters::border_is_allowed(false));
    REQUIRE(report.status == Status::BORDER);
    CHECK(describe(report, mesh) == "the mesh has a border: edge from vertex " +
                                        std::to_string(source(report.halfedge, mesh).idx()) + " to vertex " +
                                        std::to_string(target(report.halfedge, mesh).idx()) +
                                        ", counted from 0; fill the holes first");
  }
  SECTION("numbers count what is left where elements were removed")
  {
    CGAL::Euler::remove_center_vertex(halfedge(Mesh::Vertex_index(7), mesh), mesh);
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    mesh.point(Mesh::Vertex_index(20)) = test::Point_3(0, std::numeric_limits<double>::infinity(), 0);
    CHECK(describe(ts::check_triangle_mesh(mesh), mesh).find(": vertex 19, counted from 0; correct it") !=
          std::string::npos);
  }
  SECTION("two ends of an edge coincide")
  {
    const auto h = halfedge(Mesh::Vertex_index(7), mesh);
    mesh.point(target(h, mesh)) = mesh.point(source(h, mesh));
    CHECK(describe(ts::check_triangle_mesh(mesh), mesh).find("counted from 0; collapse it") != std::string::npos);
  }
  SECTION("collinear corners")
  {
    Mesh cubes = test::to_mesh<Mesh>(test::plate(1));
    const auto h = halfedge(Mesh::Face_index(17), cubes);
    cubes.point(target(next(h, cubes), cubes)) =
        CGAL::midpoint(cubes.point(source(h, cubes)), cubes.point(target(h, cubes)));
    const auto report = ts::check_triangle_mesh(cubes);
    REQUIRE(report.status == Status::ZERO_AREA_FACE);
    CHECK(describe(report, cubes) == "a face has area zero: face " + std::to_string(report.face.idx()) +
                                         ", counted from 0; remove it by collapsing or flipping an edge of it");
  }
}

namespace {

// For the test below: takes all points for collinear.
struct Collinear_traits : CGAL::Exact_predicates_exact_constructions_kernel {
  struct Collinear_3 {
    bool operator()(const Point_3&, const Point_3&, const Point_3&) const { return true; }
  };
  Collinear_3 collinear_3_object() const { return {}; }
};

} // namespace

TEST_CASE("collinearity of exact points is asked from the geometric traits")
{
  using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
  Exact_mesh mesh;
  CGAL::copy_face_graph(test::to_mesh<Mesh>(test::torus(6, 5)), mesh);
  CHECK(ts::check_triangle_mesh(mesh).success());
  CHECK(ts::check_triangle_mesh(mesh, CGAL::parameters::geom_traits(Collinear_traits())).status ==
        Status::ZERO_AREA_FACE);
}

} // namespace check_triangle_mesh_test
