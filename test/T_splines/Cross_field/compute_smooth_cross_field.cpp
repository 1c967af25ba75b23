// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>

#include "test_meshes.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/subdivision_method_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <functional>
#include <limits>
#include <string>

namespace compute_smooth_cross_field_test {

namespace ts = CGAL::T_splines;
using Status = ts::Smooth_cross_field_status;
using Mesh = test::Surface_mesh;

namespace {

test::Vector_3 unit_normal(const Mesh& mesh, const Mesh::Face_index f)
{
  const auto h = halfedge(f, mesh);
  const test::Vector_3 normal =
      CGAL::normal(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)), mesh.point(target(next(h, mesh), mesh)));
  return normal / std::sqrt(normal.squared_length());
}

// The cosine of the smallest angle between `v` and a direction of the cross of face `f`.
double alignment(const Mesh& mesh, const Mesh::Face_index f, const test::Vector_3& cross, const test::Vector_3& v)
{
  const test::Vector_3 other = CGAL::cross_product(unit_normal(mesh, f), cross);
  return (std::max)(std::abs(cross * v), std::abs(other * v)) / std::sqrt(v.squared_length());
}

// Whether the faces at an edge turn by more than `angle`.
bool is_sharp(const Mesh& mesh, const Mesh::Edge_index e, const double angle)
{
  const auto h = halfedge(e, mesh);
  return unit_normal(mesh, face(h, mesh)) * unit_normal(mesh, face(opposite(h, mesh), mesh)) < std::cos(angle);
}

// Checks that a field makes at least one quarter turn around each vertex, by its own matchings and by the closest ones.
// Returns how many vertices were repaired.
int check_quarter_turns(Mesh mesh, const bool are_sharp_edges_marked)
{
  auto field = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:cross").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching", 0).first;
  auto is_marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  for (const auto e : edges(mesh))
    is_marked[e] = are_sharp_edges_marked && is_sharp(mesh, e, 0.7);
  const auto np = ts::parameters::halfedge_matching_map(matching);
  const auto report = ts::compute_smooth_cross_field(mesh, field, np.edge_is_constrained_map(is_marked));
  REQUIRE(report.success());
  ts::Holonomy_signature<Mesh> signature;
  CHECK(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
  CHECK(ts::check_holonomy_signature(mesh, signature).success());
  CHECK(ts::holonomy_signature_of_cross_field(mesh, field, signature, np).success());
  CHECK(ts::check_holonomy_signature(mesh, signature).success());
  return report.number_of_repaired_vertices;
}

// Points on the unit sphere, evenly spread: a mesh on which many fields are equally smooth.
Mesh icosphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, test::Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  for (const auto v : mesh.vertices())
    mesh.point(v) =
        CGAL::ORIGIN + (mesh.point(v) - CGAL::ORIGIN) / std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length());
  return mesh;
}

struct Interrupting_visitor {
  void begin_stage(const char*) const {}
  void progress(double) const {}
  bool go_on() const { return false; }
};

} // namespace

TEMPLATE_TEST_CASE("the smoothest field of a cube has a cone of three at each corner", "", test::Surface_mesh,
                   test::Polyhedron_3, test::Linear_cell_complex)
{
  const auto cube = test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, 6);
  TestType mesh = test::to_mesh<TestType>(cube);
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  const auto report = ts::compute_smooth_cross_field(mesh, field);
  REQUIRE(report.success());
  CHECK(report.number_of_singularities == 8);
  ts::Holonomy_signature<TestType> signature;
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
  CHECK(signature.cones().size() == 8);
  for (const auto& cone : signature.cones()) {
    const test::Point_3 p = get(get(CGAL::vertex_point, mesh), cone.first);
    CHECK(cone.second == 3);
    for (const double x : {p.x(), p.y(), p.z()})
      CHECK(x * (1 - x) == Approx(0).margin(0.17)); // a corner, or a vertex next to it
  }
}

TEST_CASE("smooth fields are tangent, of unit length, and their signatures admissible")
{
  for (int genus = 0; genus <= 3; ++genus) {
    Mesh mesh = test::to_mesh<Mesh>(test::plate(genus, 3));
    auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
    const auto report = ts::compute_smooth_cross_field(mesh, field);
    REQUIRE(report.success());
    for (const auto f : faces(mesh)) {
      CHECK(get(field, f).squared_length() == Approx(1));
      CHECK(get(field, f) * unit_normal(mesh, f) == Approx(0).margin(1e-12));
    }
    ts::Holonomy_signature<Mesh> signature;
    REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
    CHECK(static_cast<int>(signature.cones().size()) == report.number_of_singularities);
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
  }
}

TEST_CASE("the random seed chooses among equally smooth fields, and equal seeds give equal fields")
{
  Mesh mesh = icosphere();
  const auto field_of = [&mesh](const unsigned int seed) {
    auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
    REQUIRE(ts::compute_smooth_cross_field(mesh, field, CGAL::parameters::random_seed(seed)).success());
    return field;
  };
  const auto first = field_of(1), again = field_of(1), other = field_of(2);
  double smallest = 1;
  for (const auto f : faces(mesh)) {
    CHECK(get(first, f) == get(again, f));
    smallest = (std::min)(smallest, alignment(mesh, f, get(first, f), get(other, f)));
  }
  CHECK(smallest < 0.99);
}

TEST_CASE("neither size nor place changes a field")
{
  const test::Soup soup = test::plate(2, 3);
  Mesh mesh = test::to_mesh<Mesh>(soup),
       small = test::to_mesh<Mesh>(test::transformed(soup, 1. / (1 << 30), {0, 0, 0})),
       far = test::to_mesh<Mesh>(test::transformed(soup, 3, {1 << 24, -(1 << 24), 1 << 24}));
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::compute_smooth_cross_field(mesh, field).success());
  for (Mesh* other : {&mesh, &small, &far}) {
    auto other_field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), *other);
    REQUIRE(ts::compute_smooth_cross_field(*other, other_field).success());
    for (const auto f : faces(mesh))
      CHECK(alignment(mesh, f, get(field, f), get(other_field, f)) == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("each component has the field that it has alone")
{
  const test::Soup one = test::plate(1, 2);
  Mesh mesh = test::to_mesh<Mesh>(test::disjoint_union(one, test::transformed(one, 1e-3, {0, 0, 0})));
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::compute_smooth_cross_field(mesh, field).success());
  Mesh alone = test::to_mesh<Mesh>(one);
  auto field_alone = get(CGAL::dynamic_face_property_t<test::Vector_3>(), alone);
  REQUIRE(ts::compute_smooth_cross_field(alone, field_alone).success());
  for (const auto f : faces(mesh)) {
    const Mesh::Face_index same(f.idx() % static_cast<Mesh::size_type>(one.faces.size()));
    CHECK(alignment(mesh, f, get(field, f), get(field_alone, same)) == Approx(1).epsilon(1e-6));
  }
  ts::Holonomy_signature<Mesh> signature;
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
  const auto n = static_cast<unsigned int>(one.points.size());
  int sum[2] = {0, 0}, number[2] = {0, 0};
  for (const auto& cone : signature.cones()) {
    sum[cone.first.idx() >= n] += 4 - cone.second;
    ++number[cone.first.idx() >= n];
  }
  CHECK(sum[0] == 0);
  CHECK(sum[1] == 0);
  CHECK(number[0] == number[1]);
}

TEST_CASE("crosses follow the edges that are marked")
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(24, 16));
  auto is_marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  // A diagonal across the torus, from quadrilateral to quadrilateral.
  for (const auto e : edges(mesh)) {
    const int i = static_cast<int>(source(e, mesh).idx()), j = static_cast<int>(target(e, mesh).idx());
    is_marked[e] = i / 16 == i % 16 && j / 16 == j % 16 && i != j;
  }
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::compute_smooth_cross_field(mesh, field, CGAL::parameters::edge_is_constrained_map(is_marked)).success());
  int number_of_marked = 0;
  for (const auto e : edges(mesh)) {
    if (!is_marked[e])
      continue;
    ++number_of_marked;
    const test::Vector_3 direction = mesh.point(target(e, mesh)) - mesh.point(source(e, mesh));
    for (const auto h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
      CHECK(alignment(mesh, face(h, mesh), get(field, face(h, mesh)), direction) == Approx(1).epsilon(1e-9));
  }
  CHECK(number_of_marked == 15);
  ts::Holonomy_signature<Mesh> signature;
  CHECK(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
}

TEST_CASE("where all edges are marked, each cross has the mean direction of its edges, or that of the longest")
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  auto is_marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", true).first;
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::compute_smooth_cross_field(mesh, field, CGAL::parameters::edge_is_constrained_map(is_marked)).success());
  int number_of_means = 0, number_of_longest = 0;
  for (const auto f : faces(mesh)) {
    // Directions modulo quarter turns are complex numbers to the fourth power, here with the first edge for real axis.
    const auto first = halfedge(f, mesh);
    const test::Vector_3 x = mesh.point(target(first, mesh)) - mesh.point(source(first, mesh)),
                         y = CGAL::cross_product(unit_normal(mesh, f), x);
    const auto fourfold = [&](const test::Vector_3& v) {
      return std::pow(std::complex<double>(v * x, v * y) / std::abs(std::complex<double>(v * x, v * y)), 4);
    };
    std::complex<double> sum(0), longest(0);
    double total = 0, length_of_longest = 0;
    for (const auto h : CGAL::halfedges_around_face(first, mesh)) {
      const test::Vector_3 v = mesh.point(target(h, mesh)) - mesh.point(source(h, mesh));
      const double length = std::sqrt(v.squared_length());
      sum += length * fourfold(v);
      total += length;
      if (length > length_of_longest) {
        length_of_longest = length;
        longest = fourfold(v);
      }
    }
    const bool is_mean = std::abs(sum) > 0.5 * total;
    ++(is_mean ? number_of_means : number_of_longest);
    CHECK(std::abs(fourfold(get(field, f)) - (is_mean ? sum / std::abs(sum) : longest)) < 1e-9);
  }
  CHECK(number_of_means > 0);
  CHECK(number_of_longest > 0);
}

TEST_CASE("a guided field follows the principal curvature directions")
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(60, 30));
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  const auto report = ts::compute_smooth_cross_field(mesh, field, ts::parameters::curvature_alignment(100.));
  REQUIRE(report.success());
  CHECK(report.number_of_singularities == 0);
  const auto expected = test::field_around_axis(mesh);
  for (const auto f : faces(mesh))
    CHECK(alignment(mesh, f, get(field, f), get(expected, f)) > std::cos(0.1));
}

TEST_CASE("a mesh with a border has a field")
{
  Mesh mesh = test::to_mesh<Mesh>(test::punctured_torus());
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  CHECK(ts::compute_smooth_cross_field(mesh, field).success());
  Mesh square;
  const auto a = square.add_vertex(test::Point_3(0, 0, 0)), b = square.add_vertex(test::Point_3(1, 0, 0)),
             c = square.add_vertex(test::Point_3(1, 1, 0)), d = square.add_vertex(test::Point_3(0, 1, 0));
  square.add_face(a, b, c);
  square.add_face(a, c, d);
  auto flat = get(CGAL::dynamic_face_property_t<test::Vector_3>(), square);
  REQUIRE(ts::compute_smooth_cross_field(square, flat).success());
  CHECK(alignment(square, Mesh::Face_index(0), get(flat, Mesh::Face_index(0)), get(flat, Mesh::Face_index(1))) ==
        Approx(1));
}

TEST_CASE("a needle gets a positive number of quarter turns")
{
  // A box with a long spike on its top.
  Mesh mesh = test::to_mesh<Mesh>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, 4));
  for (const auto v : vertices(mesh))
    if (mesh.point(v) == test::Point_3(0.5, 0.5, 1))
      mesh.point(v) = test::Point_3(0.5, 0.5, 50);
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::compute_smooth_cross_field(mesh, field).success());
  ts::Holonomy_signature<Mesh> signature;
  CHECK(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
}

TEST_CASE("around every vertex there is at least one quarter turn, with and without marked edges")
{
  int number_of_repaired = 0, number_of_repaired_at_marks = 0;
  const auto check = [&](const test::Soup& soup) {
    number_of_repaired += check_quarter_turns(test::to_mesh<Mesh>(soup), false);
    number_of_repaired_at_marks += check_quarter_turns(test::to_mesh<Mesh>(soup), true);
  };
  for (const std::size_t sides : {5, 12, 180, 400, 5000}) {
    CAPTURE(sides);
    for (const double height : {0.001, 2.}) {
      check(test::cylinder(sides, height, true));
      check(test::cylinder(sides, height, false));
    }
    check(test::double_cone(sides, 0, 3));
    check(test::double_cone(sides, -50, 50));
    check(test::double_cone(sides, -0.01, 0.01));
    check(test::double_cone(sides, 0.9, 1));
  }
  CHECK(number_of_repaired > 0);
  CHECK(number_of_repaired_at_marks > 0);
}

TEST_CASE("a hedgehog and a rough surface have at least one quarter turn at every vertex")
{
  Mesh mesh = test::to_mesh<Mesh>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, 8));
  Mesh rough = mesh;
  for (const auto v : vertices(mesh)) {
    const test::Vector_3 outward = mesh.point(v) - test::Point_3(0.5, 0.5, 0.5);
    if (v.idx() % 3 == 0)
      mesh.point(v) = mesh.point(v) + 5 * outward;
    const auto random = [&v](const int k) { return 0.2 * std::sin(1e4 * (v.idx() + 1) * k); };
    rough.point(v) = rough.point(v) + test::Vector_3(random(1), random(2), random(3));
  }
  CHECK(check_quarter_turns(mesh, false) > 0);
  check_quarter_turns(rough, false);
  check_quarter_turns(mesh, true);
  check_quarter_turns(rough, true);
}

TEST_CASE("real meshes with bad triangles have admissible fields")
{
  for (const char* name : {"anchor_dense.off", "u.off", "couplingdown.off"}) {
    Mesh mesh;
    std::ifstream input(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name);
    REQUIRE(CGAL::IO::read_OFF(input, mesh));
    auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
    REQUIRE(ts::compute_smooth_cross_field(mesh, field).success());
    ts::Holonomy_signature<Mesh> signature;
    CHECK(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
  }
}

TEST_CASE("invalid meshes and interruptions are reported")
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  CHECK(ts::compute_smooth_cross_field(mesh, field, CGAL::parameters::visitor(Interrupting_visitor())).status ==
        Status::INTERRUPTED);
  mesh.point(Mesh::Vertex_index(3)) = test::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const auto report = ts::compute_smooth_cross_field(mesh, field);
  CHECK(report.status == Status::INVALID_MESH);
  CHECK(report.mesh.vertex == Mesh::Vertex_index(3));
  CHECK(describe(report, mesh) ==
        "a vertex has a coordinate that is infinite or not a number: vertex 3, counted from 0; correct it");
}

} // namespace compute_smooth_cross_field_test
