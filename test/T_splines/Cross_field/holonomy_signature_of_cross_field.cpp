// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

namespace holonomy_signature_of_cross_field_test {

namespace ts = CGAL::T_splines;
using Status = ts::Holonomy_signature_status;

namespace {

// A direction in each face that has nothing to do with those of its neighbors.
template <typename Mesh>
test::Face_vector_map<Mesh> random_field(Mesh& mesh, const unsigned int seed)
{
  auto field = test::field_around_axis(mesh);
  std::mt19937 random(seed);
  const auto points = get(CGAL::vertex_point, mesh);
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const test::Vector_3 a = get(points, target(h, mesh)) - get(points, source(h, mesh)),
                         b = get(points, target(next(h, mesh), mesh)) - get(points, source(h, mesh));
    put(field, f, (random() / 2147483648. - 1) * a + (random() / 2147483648. - 1) * b);
  }
  return field;
}

template <typename Mesh>
int sum_of_cones(const ts::Holonomy_signature<Mesh>& signature)
{
  int sum = 0;
  for (const auto& cone : signature.cones())
    sum += 4 - cone.second;
  return sum;
}

} // namespace

TEMPLATE_TEST_CASE("the field around a torus has no cones, and its circles do not turn", "", test::Surface_mesh,
                   test::Polyhedron_3, test::Linear_cell_complex)
{
  TestType mesh = test::to_mesh<TestType>(test::torus(24, 12));
  ts::Holonomy_signature<TestType> signature;
  const auto report = ts::holonomy_signature_of_cross_field(mesh, test::field_around_axis(mesh), signature);
  CHECK(report.status == Status::VALID);
  CHECK(report.deviation < 1e-9);
  CHECK(signature.cones().empty());
  REQUIRE(signature.loops().size() == 2);
  CHECK(signature.loops()[0].quarter_turns == 0);
  CHECK(signature.loops()[1].quarter_turns == 0);
  CHECK(ts::check_holonomy_signature(mesh, signature).success());
}

TEST_CASE("cones of any field satisfy the theorem of Gauss and Bonnet in each component")
{
  using Mesh = test::Surface_mesh;
  for (int genus = 0; genus <= 3; ++genus) {
    Mesh mesh = test::to_mesh<Mesh>(test::disjoint_union(test::plate(genus), test::torus(9, 7)));
    for (unsigned int seed = 0; seed < 5; ++seed) {
      ts::Holonomy_signature<Mesh> signature;
      const auto report = ts::holonomy_signature_of_cross_field(mesh, random_field(mesh, seed), signature);
      CHECK((report.status == Status::VALID || report.status == Status::NON_POSITIVE_CONE));
      CHECK(report.deviation < 1e-9);
      CHECK(sum_of_cones(signature) == 4 * (2 - 2 * genus));
      CHECK(signature.loops().size() == static_cast<std::size_t>(2 * genus + 2));
    }
  }
}

TEST_CASE("which of the four directions is given, its length and its normal part do not matter")
{
  using Mesh = test::Surface_mesh;
  Mesh mesh = test::to_mesh<Mesh>(test::plate(2));
  auto field = random_field(mesh, 17);
  ts::Holonomy_signature<Mesh> signature, turned;
  ts::holonomy_signature_of_cross_field(mesh, field, signature);
  int i = 0;
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    test::Vector_3 normal =
        CGAL::normal(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)), mesh.point(target(next(h, mesh), mesh)));
    normal = normal / std::sqrt(normal.squared_length());
    test::Vector_3 direction = get(field, f);
    for (int turn = 0; turn < ++i % 4; ++turn)
      direction = CGAL::cross_product(normal, direction);
    put(field, f, 1e-200 * (direction + 0.5 * std::sqrt(direction.squared_length()) * normal));
  }
  ts::holonomy_signature_of_cross_field(mesh, field, turned);
  for (const auto v : vertices(mesh))
    CHECK(signature.quarter_turns(v) == turned.quarter_turns(v));
  for (std::size_t l = 0; l < signature.loops().size(); ++l)
    CHECK(signature.loops()[l].quarter_turns == turned.loops()[l].quarter_turns);
}

TEST_CASE("given matchings decide instead of the closest rotation")
{
  using Mesh = test::Surface_mesh;
  Mesh mesh = test::to_mesh<Mesh>(test::torus(24, 12));
  const auto field = test::field_around_axis(mesh);
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching", 0).first;
  ts::Holonomy_signature<Mesh> signature;
  // The field turns little from face to face: without quarter turns nothing changes.
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature, ts::parameters::halfedge_matching_map(matching))
              .success());
  CHECK(signature.cones().empty());
  // A quarter turn across one edge makes one end of it a cone of five, the other one of three.
  const Mesh::Edge_index e(11);
  for (const int m : {1, -1, 5}) {
    matching[halfedge(e, mesh)] = m;
    REQUIRE(
        ts::holonomy_signature_of_cross_field(mesh, field, signature, ts::parameters::halfedge_matching_map(matching))
            .success());
    REQUIRE(signature.cones().size() == 2);
    // Entering the face of h from the right turns counter-clockwise around its source.
    CHECK(signature.quarter_turns(source(e, mesh)) == (m == -1 ? 5 : 3));
    CHECK(signature.quarter_turns(target(e, mesh)) == (m == -1 ? 3 : 5));
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
  }
}

TEST_CASE("fields and meshes that have no signature are refused by name")
{
  using Mesh = test::Surface_mesh;
  Mesh mesh = test::to_mesh<Mesh>(test::torus(24, 12));
  auto field = test::field_around_axis(mesh);
  ts::Holonomy_signature<Mesh> signature;
  const Mesh::Face_index f(40);
  const auto h = halfedge(f, mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const test::Vector_3 normal =
      CGAL::normal(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)), mesh.point(target(next(h, mesh), mesh)));
  for (const test::Vector_3& bad : {test::Vector_3(0, 0, 0), test::Vector_3(nan, 1, 0), normal}) {
    put(field, f, bad);
    const auto report = ts::holonomy_signature_of_cross_field(mesh, field, signature);
    CHECK(report.status == Status::INVALID_FIELD);
    CHECK(report.face == f);
  }
}

TEST_CASE("a field on triangles so small that squares of their areas vanish need not close up, which is said")
{
  // A thin torus, rough and tiny beside the other component.
  using Mesh = test::Surface_mesh;
  const int length = 600, width = 4;
  std::set<Status> found;
  for (int step = 0; step < 400 && found.size() < 3; ++step) {
    const double size = std::pow(10., -80.2 - 0.01 * (step % 20));
    test::Soup tiny = test::torus(length, width, 360, 4);
    std::mt19937 random(static_cast<unsigned int>(step));
    for (test::Point_3& p : tiny.points)
      p = p + 1.5 * test::Vector_3(random() / 4294967296. - 0.5, random() / 4294967296. - 0.5,
                                   random() / 4294967296. - 0.5);
    Mesh mesh = test::to_mesh<Mesh>(test::disjoint_union(test::transformed(tiny, size, {0, 0, 0}), test::plate(0)));
    auto field = test::field_around_axis(mesh);
    for (const auto f : faces(mesh))
      put(field, f, test::Vector_3(1, 2, 0.3));
    ts::Holonomy_signature<Mesh> signature;
    const auto report = ts::holonomy_signature_of_cross_field(mesh, field, signature);
    found.insert(report.status);
    if (report.status == Status::VERTEX_NOT_INTEGER) {
      CHECK(report.vertex.idx() < static_cast<std::size_t>(length * width));
      CHECK(report.deviation > 1e-6);
      CHECK(describe(report, mesh) == "the field does not close up around a vertex: vertex " +
                                          std::to_string(report.vertex.idx()) + ", counted from 0");
    }
    if (report.status == Status::LOOP_NOT_INTEGER) {
      CHECK(report.index < 2);
      CHECK(describe(report, mesh) ==
            "the field does not close up along a loop: loop " + std::to_string(report.index) + ", counted from 0");
    }
  }
  CHECK(found.count(Status::VALID) == 1);
  CHECK(found.count(Status::VERTEX_NOT_INTEGER) == 1);
  CHECK(found.count(Status::LOOP_NOT_INTEGER) == 1);
}

} // namespace holonomy_signature_of_cross_field_test
