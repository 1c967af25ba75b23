// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>

#include "Counting_visitor.h"
#include "feature_meshes.h"
#include "open_meshes.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace refine_at_features_test {

namespace ts = CGAL::T_splines;
namespace fm = feature_meshes;
namespace pmp = CGAL::Polygon_mesh_processing;
using Status = ts::Feature_refinement_status;
using Mesh = test::Surface_mesh;
using Marks = Mesh::Property_map<Mesh::Edge_index, bool>;
using Location = pmp::Face_location<Mesh, double>;

namespace {

Marks marks_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
}

// The ends of the marked edges, sorted.
std::vector<std::pair<test::Point_3, test::Point_3>> segments(const Mesh& mesh, const Marks& marks)
{
  std::vector<std::pair<test::Point_3, test::Point_3>> result;
  for (const auto e : mesh.edges())
    if (marks[e]) {
      const test::Point_3 p = mesh.point(source(e, mesh)), q = mesh.point(target(e, mesh));
      result.emplace_back((std::min)(p, q), (std::max)(p, q));
    }
  std::sort(result.begin(), result.end());
  return result;
}

// Refines a mesh and checks all that is promised. Returns the number of faces of the result.
std::size_t check_refinement(Mesh& mesh, const Marks& marks)
{
  Mesh refined;
  Marks refined_marks = marks_of(refined);
  auto location = refined.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const auto report =
      ts::refine_at_features(mesh, marks, refined, refined_marks, ts::parameters::vertex_location_map(location));
  REQUIRE(report.success());
  REQUIRE(refined.is_valid());
  CHECK(ts::check_triangle_mesh(refined).success());
  CHECK(refined.number_of_vertices() == mesh.number_of_vertices() +
                                            static_cast<unsigned>(report.number_of_split_edges) +
                                            static_cast<unsigned>(report.number_of_split_faces));
  CHECK(refined.number_of_faces() == mesh.number_of_faces() + 2 * static_cast<unsigned>(report.number_of_split_edges) +
                                         2 * static_cast<unsigned>(report.number_of_split_faces));
  CHECK(segments(refined, refined_marks) == segments(mesh, marks));
  CHECK(pmp::area(refined) == Approx(pmp::area(mesh)).epsilon(1e-12));

  const auto is_bound = [&](const Mesh::Edge_index e) { return refined_marks[e] || refined.is_border(e); };
  std::vector<char> has_bound(refined.number_of_vertices(), 0);
  for (const auto e : refined.edges())
    if (is_bound(e))
      has_bound[source(e, refined).idx()] = has_bound[target(e, refined).idx()] = 1;
  for (const auto e : refined.edges())
    CHECK((is_bound(e) || !has_bound[source(e, refined).idx()] || !has_bound[target(e, refined).idx()]));
  for (const auto f : refined.faces()) {
    int number = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, refined), refined))
      number += is_bound(edge(h, refined)) ? 1 : 0;
    CHECK(number <= 1);
  }
  double largest = 0;
  for (const auto v : refined.vertices()) {
    const Location& at = location[v];
    CHECK(at.second[0] + at.second[1] + at.second[2] == Approx(1).epsilon(1e-15));
    largest = (std::max)(largest, CGAL::squared_distance(pmp::construct_point(at, mesh), refined.point(v)));
    if (v.idx() < mesh.number_of_vertices())
      CHECK(refined.point(v) == mesh.point(v));
  }
  CHECK(std::sqrt(largest) < 1e-14);
  return refined.number_of_faces();
}

struct Stopping_visitor : ts::Progress_visitor {
  bool go_on() const { return false; }
};

} // namespace

TEST_CASE("after refinement no triangle has two features, and none is lost or moved")
{
  for (fm::Named_mesh& named : fm::all()) {
    CAPTURE(named.name);
    Marks marks = marks_of(named.mesh);
    REQUIRE(ts::detect_features(named.mesh, marks).success());
    check_refinement(named.mesh, marks);
  }
}

TEST_CASE("triangles with three features get a vertex at their centre")
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  Marks marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", true).first;
  CHECK(check_refinement(mesh, marks) == 3 * mesh.number_of_faces());
}

TEST_CASE("edges on the border count as features")
{
  Mesh plate = open_meshes::plate(1, 1); // its diagonal joins two corners
  Marks marks = marks_of(plate);
  CHECK(check_refinement(plate, marks) == 4);
  Mesh triangle;
  triangle.add_face(triangle.add_vertex(test::Point_3(0, 0, 0)), triangle.add_vertex(test::Point_3(1, 0, 0)),
                    triangle.add_vertex(test::Point_3(0, 1, 0)));
  CHECK(check_refinement(triangle, marks_of(triangle)) == 3);
  // A feature from border to border, and one that touches the border: around them, and at corners, edges are split.
  Mesh wide = open_meshes::plate(8, 8);
  Marks on_wide = marks_of(wide);
  for (const auto e : wide.edges()) {
    const test::Point_3 p = wide.point(source(e, wide)), q = wide.point(target(e, wide));
    on_wide[e] = (p.x() == 4 && q.x() == 4) || (p.y() == 3 && q.y() == 3 && p.x() + q.x() < 7);
  }
  CHECK(check_refinement(wide, on_wide) > wide.number_of_faces());
}

TEMPLATE_TEST_CASE("the refined mesh may be another model of graphs than the mesh", "", test::Surface_mesh,
                   test::Polyhedron_3, test::Linear_cell_complex)
{
  TestType mesh =
      test::to_mesh<TestType>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, 1));
  auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  REQUIRE(ts::detect_features(mesh, marks).success());
  test::Polyhedron_3 refined;
  auto refined_marks = get(CGAL::dynamic_edge_property_t<bool>(), refined);
  const auto report = ts::refine_at_features(mesh, marks, refined, refined_marks);
  REQUIRE(report.success());
  CHECK(report.number_of_split_edges == 6); // the diagonals
  CHECK(CGAL::is_valid_polygon_mesh(refined));
  CHECK(num_faces(refined) == 24);
  CHECK(ts::feature_figures(refined, refined_marks).number_of_edges == 12);
  TestType copy;
  auto copied_marks = get(CGAL::dynamic_edge_property_t<bool>(), copy);
  REQUIRE(ts::refine_at_features(refined, refined_marks, copy, copied_marks).success());
  CHECK(faces(copy).size() == 24);
}

TEST_CASE("what cannot be refined is refused, and nothing is written")
{
  Mesh mesh = fm::cube(2), empty, full = fm::cube(1), refined;
  Marks marks = marks_of(mesh), refined_marks = marks_of(refined);
  CHECK(ts::refine_at_features(empty, marks_of(empty), refined, refined_marks).status == Status::INVALID_MESH);
  CHECK(ts::refine_at_features(mesh, marks, full, marks_of(full)).status == Status::OUTPUT_NOT_EMPTY);
  const auto report =
      ts::refine_at_features(mesh, marks, refined, refined_marks, CGAL::parameters::visitor(Stopping_visitor()));
  CHECK(report.status == Status::INTERRUPTED);
  CHECK(describe(report, mesh) == "interrupted by the visitor");
  CHECK(refined.number_of_vertices() == 0);
  const auto done = ts::refine_at_features(mesh, marks, refined, refined_marks);
  CHECK(describe(done, mesh) == "the mesh was refined at its features: 0 edges and 0 triangles were split");
}

TEST_CASE("the refinement at features can be cancelled", "[cancel]")
{
  Mesh mesh = fm::cube(12);
  Marks marks = marks_of(mesh);
  check_cancelling([&](const auto& visitor) {
    Mesh refined;
    const auto report =
        ts::refine_at_features(mesh, marks, refined, marks_of(refined), CGAL::parameters::visitor(visitor));
    CHECK((report.success() || refined.number_of_vertices() == 0));
    return report.status == Status::INTERRUPTED;
  });
}

} // namespace refine_at_features_test
