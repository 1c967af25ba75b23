// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/fill_holes.h>

#include "Counting_visitor.h"
#include "open_meshes.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace fill_holes_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Status = T::Hole_filling_status;

/// Part of a sphere, 10 x 10 cells, without some of them.
template <typename IsIn>
Mesh cap(const IsIn& is_in)
{
  return grid(10, 10, is_in, [](const int i, const int j) {
    const double x = (i - 5) / 10., y = (j - 5) / 10.;
    return Point_3(x, y, std::sqrt(1 - x * x - y * y));
  });
}

template <typename Graph>
std::size_t number_of_borders(const Graph& mesh)
{
  std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  return borders.size();
}

} // namespace

TEST_CASE("holes with few edges are filled smoothly, larger ones are left")
{
  // Holes of 4 and 12 edges in a border of 40.
  const Mesh open =
      cap([](const int i, const int j) { return !(i == 2 && j == 2) && !(i >= 5 && i < 8 && j >= 5 && j < 8); });
  REQUIRE(number_of_borders(open) == 3);
  for (const std::size_t largest : {3, 4, 11, 12, 39}) {
    CAPTURE(largest);
    Mesh mesh = open;
    const auto is_data = mesh.add_property_map<Mesh::Face_index, bool>("f:is_data", false).first;
    const auto report = T::fill_holes(mesh, largest, P::face_is_data_map(is_data));
    REQUIRE(report);
    const std::size_t filled = largest < 4 ? 0 : largest < 12 ? 1 : 2;
    CHECK(report.number_of_filled_holes == filled);
    CHECK(report.number_of_larger_holes == 3 - filled);
    CHECK(report.number_of_failed_holes == 0);
    CHECK(number_of_borders(mesh) == 3 - filled);
    CHECK(T::check_triangle_mesh(mesh));
    // What was there is there, in its order; what is new is no data.
    REQUIRE(mesh.number_of_faces() == open.number_of_faces() + report.number_of_faces);
    for (const Vertex v : open.vertices())
      CHECK(mesh.point(v) == open.point(v));
    for (const auto f : mesh.faces()) {
      CHECK(is_data[f] == (f.idx() < open.number_of_faces()));
      if (is_data[f])
        CHECK(mesh.target(mesh.halfedge(f)) == open.target(open.halfedge(f)));
    }
    for (const Vertex v : mesh.vertices())
      CHECK((mesh.point(v) - CGAL::ORIGIN).squared_length() == Approx(1).epsilon(0.02));
  }
}

TEST_CASE("a refusal, and what was left, is said")
{
  Mesh mesh = cap([](const int i, const int j) { return !(i == 2 && j == 2); });
  CHECK(describe(T::fill_holes(mesh, 3), mesh) == "0 holes filled; 2 larger ones left");
  CHECK(describe(T::fill_holes(mesh, 4), mesh) == "1 hole filled with 2 faces; 1 larger one left");
  Mesh empty;
  const auto report = T::fill_holes(empty, 4);
  CHECK(report.status == Status::INVALID_MESH);
  CHECK(describe(report, empty) == describe(T::check_triangle_mesh(empty), empty));
}

TEST_CASE("a hole that has no filling stays as it is")
{
  // The three edges of the one lie on a line, the other is the outside of a triangle.
  Mesh mesh = plate(6, 6), triangle;
  std::vector<Vertex> v;
  for (const Point_3& p : {Point_3(20, 0, 0), Point_3(21, 0, 0), Point_3(22, 0, 0), Point_3(21, 0, 5)})
    v.push_back(mesh.add_vertex(p));
  for (const auto& [a, b] : {std::make_pair(0, 1), std::make_pair(1, 2), std::make_pair(2, 0)})
    mesh.add_face(v[a], v[b], v[3]);
  REQUIRE(number_of_borders(mesh) == 2);
  triangle.add_face(triangle.add_vertex(Point_3(0, 0, 0)), triangle.add_vertex(Point_3(1, 0, 0)),
                    triangle.add_vertex(Point_3(0, 1, 0)));
  for (Mesh* const given : {&mesh, &triangle}) {
    const Mesh before = *given;
    const auto report = T::fill_holes(*given, 3);
    REQUIRE(report);
    CHECK(report.number_of_filled_holes == 0);
    CHECK(report.number_of_failed_holes == 1);
    CHECK(given->is_border(report.failed_hole));
    CHECK(given->number_of_faces() == before.number_of_faces());
    CHECK(given->number_of_vertices() == before.number_of_vertices());
    CHECK(given->is_valid());
    CHECK(describe(report, *given).find("1 hole that has no filling left, the first at the edge") != std::string::npos);
  }
}

TEST_CASE("any mutable face graph is filled, and the work may be stopped")
{
  const Mesh open = cap([](const int i, const int j) { return i % 3 != 1 || j % 3 != 1; });
  REQUIRE(number_of_borders(open) == 10);
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(open, polyhedron);
  CHECK(T::fill_holes(polyhedron, 4).number_of_filled_holes == 9);
  CHECK(number_of_borders(polyhedron) == 1);
  CHECK(CGAL::is_triangle_mesh(polyhedron));
  check_cancelling([&](const Counting_visitor& visitor) {
    Mesh mesh = open;
    const auto report = T::fill_holes(mesh, 4, CGAL::parameters::visitor(visitor));
    CHECK(number_of_borders(mesh) == 10 - report.number_of_filled_holes);
    CHECK(T::check_triangle_mesh(mesh));
    return report.status == Status::INTERRUPTED;
  });
}

} // namespace fill_holes_test
