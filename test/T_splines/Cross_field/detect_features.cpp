// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/feature_figures.h>

#include "Counting_visitor.h"
#include "feature_meshes.h"
#include "test_meshes.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace detect_features_test {

namespace ts = CGAL::T_splines;
namespace fm = feature_meshes;
using Status = ts::Feature_detection_status;
using Mesh = test::Surface_mesh;
using Marks = Mesh::Property_map<Mesh::Edge_index, bool>;

namespace {

Marks marks_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
}

ts::Feature_figures detected(Mesh mesh)
{
  const auto report = ts::detect_features(mesh, marks_of(mesh));
  REQUIRE(report.success());
  return report.features;
}

// A square sheet of n x n cells with the height z(x, y), x and y from 0 to 1.
template <typename Height>
Mesh sheet(const int n, const Height& height)
{
  test::Soup soup;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = double(i) / n, y = double(j) / n;
      soup.points.emplace_back(x, y, height(x, y));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto at = [n](const int k, const int l) { return static_cast<std::size_t>(k * (n + 1) + l); };
      soup.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return test::to_mesh<Mesh>(soup);
}

struct Stopping_visitor : ts::Progress_visitor {
  bool go_on() const { return false; }
};

// Noise that is the same for the same place.
double noise(const double x, const double y)
{
  return std::fmod(std::abs(1e4 * std::sin(12.9898 * x + 78.233 * y)), 1.);
}

} // namespace

TEMPLATE_TEST_CASE("the features of a cube are its twelve edges", "", test::Surface_mesh, test::Polyhedron_3,
                   test::Linear_cell_complex)
{
  for (const int n : {1, 2, 7}) {
    TestType mesh =
        test::to_mesh<TestType>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, n));
    auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    const auto report = ts::detect_features(mesh, marks);
    REQUIRE(report.success());
    CHECK(report.features.number_of_edges == 12 * n);
    CHECK(report.features.number_of_arcs == 12);
    CHECK(report.features.number_of_loops == 0);
    CHECK(report.features.number_of_corners == 8);
    CHECK(report.features.number_of_darts == 0);
    CHECK(report.features.relative_length == Approx(12 / std::sqrt(6.)));
    CHECK(report.features.divide_surface());
    const ts::Feature_figures figures = ts::feature_figures(mesh, marks);
    CHECK(figures.number_of_edges == 12 * n);
    CHECK(figures.relative_length == report.features.relative_length);
    CHECK(describe(report, mesh) == std::to_string(12 * n) +
                                        " feature edges in 12 arcs, 0 of them closed; 8 corners, 0 "
                                        "ends inside, 0 on the border");
  }
}

TEST_CASE("the features of parts are found with few and with many triangles")
{
  for (const int n : {1, 2, 4}) {
    CAPTURE(n);
    const ts::Feature_figures cylinder = detected(fm::cylinder(16 * n, n)),
                              cone = detected(fm::truncated_cone(16 * n, n));
    for (const ts::Feature_figures& round : {cylinder, cone}) {
      CHECK(round.number_of_edges == 2 * 16 * n);
      CHECK(round.number_of_loops == 2);
      CHECK(round.number_of_arcs == 2);
      CHECK(round.divide_surface());
    }
    const ts::Feature_figures bracket = detected(fm::bracket_with_hole(n));
    CHECK(bracket.number_of_arcs == 18 + 12);
    CHECK(bracket.number_of_corners == 12 + 8);
    CHECK(bracket.number_of_darts == 0);
    CHECK(bracket.divide_surface());
    const ts::Feature_figures gear = detected(fm::gear(9, n));
    CHECK(gear.number_of_arcs == 9 * 4 * 3); // per tooth and height: flanks, and the rims above and below
    CHECK(gear.number_of_corners == 9 * 4 * 2);
  }
}

TEST_CASE("a crease that fades is followed to the weak angle, however fine the mesh is")
{
  const auto roof = [](const double x, const double y) { return (0.5 - std::abs(y - 0.5)) * (1 - x); };
  for (const int n : {20, 40, 160}) {
    Mesh mesh = sheet(n, roof);
    Marks marks = marks_of(mesh);
    const auto report = ts::detect_features(mesh, marks);
    REQUIRE(report.success());
    CHECK(report.features.number_of_arcs == 1);
    CHECK(report.features.number_of_darts == 1);
    CHECK(report.features.number_of_ends_on_border == 1);
    CHECK_FALSE(report.features.divide_surface()); // it ends inside
    // On the ridge the sides turn by 2 atan((1 - x) / sqrt(1.25)): by 20 degrees at x = 0.803, by 40 at 0.593.
    CHECK(std::abs(report.features.number_of_edges - 0.803 * n) <= 1.5);
    const auto strong = ts::detect_features(mesh, marks, ts::parameters::weak_feature_angle(40.));
    CHECK(std::abs(strong.features.number_of_edges - 0.593 * n) <= 1.5);
  }
}

TEST_CASE("noise has hardly any features, and hides no crease")
{
  for (const int n : {20, 60}) {
    const auto rough = [n](const double x, const double y) { return 1.5 / n * noise(x, y); };
    Mesh mesh = sheet(n, rough);
    Marks marks = marks_of(mesh);
    const int number_of_features = ts::detect_features(mesh, marks).features.number_of_edges;
    int number_of_sharp_edges = 0;
    for (const auto e : mesh.edges())
      if (!mesh.is_border(e)) {
        const auto h = halfedge(e, mesh);
        const auto normal = [&mesh](const Mesh::Halfedge_index g) {
          return CGAL::unit_normal(mesh.point(source(g, mesh)), mesh.point(target(g, mesh)),
                                   mesh.point(target(next(g, mesh), mesh)));
        };
        number_of_sharp_edges += normal(h) * normal(opposite(h, mesh)) < std::cos(40 * CGAL_PI / 180) ? 1 : 0;
      }
    CHECK(number_of_sharp_edges > static_cast<int>(mesh.number_of_edges()) / 4);
    CHECK(number_of_features < number_of_sharp_edges / 20);
    Mesh with_crease =
        sheet(n, [&rough](const double x, const double y) { return 0.02 * rough(x, y) + 1.5 * std::abs(y - 0.5); });
    const auto crease = detected(with_crease);
    CHECK(crease.number_of_arcs == 1);
    CHECK(crease.number_of_edges == n);
  }
}

TEST_CASE("a weak edge in the middle of a crease belongs to it, though the edges beside it turn, too")
{
  const int n = 12;
  // The ridge of a roof: four vertices beside one of its edges are moved down, so that it turns by 28 degrees there.
  Mesh mesh = sheet(n, [](const double x, const double y) {
    const bool is_moved = std::abs(x * n - 5.5) < 1 && std::abs(std::abs(y * n - 6) - 1) < 0.5;
    return (is_moved ? 0.25 : 0.5) * std::abs(y - 0.5);
  });
  const auto figures = detected(mesh);
  CHECK(figures.number_of_edges == n);
  CHECK(figures.number_of_darts == 0);
  CHECK(figures.number_of_ends_on_border == 2);
}

TEST_CASE("a single triangle that is folded over has no features")
{
  const int n = 12;
  Mesh mesh = sheet(n, [](double, double) { return 0.; });
  CHECK(detected(mesh).number_of_edges == 0);
  // The third corner of a triangle is moved across the opposite side: the triangle faces down, all others up.
  mesh.point(Mesh::Vertex_index(6 * (n + 1) + 5)) = test::Point_3(5.45 / n, 5.55 / n, 0);
  CHECK(detected(mesh).number_of_edges == 0);
}

TEST_CASE("a sphere has no features, and neither size nor place changes what is found")
{
  Mesh sphere;
  CGAL::make_icosahedron(sphere, test::Point_3(0, 0, 0), 1.);
  CHECK(detected(sphere).number_of_edges == 30); // a solid of twenty flat faces
  CGAL::Subdivision_method_3::Loop_subdivision(sphere, CGAL::parameters::number_of_iterations(1));
  CHECK(detected(sphere).number_of_edges == 0);

  const auto bracket = test::cubes(
      [](int x, int y, int z) { return z == 0 ? x < 3 && x >= 0 && y == 0 : x == 0 && y == 0 && z == 1; }, 3, 2);
  const int expected = detected(test::to_mesh<Mesh>(bracket)).number_of_edges;
  CHECK(expected > 0);
  CHECK(detected(test::to_mesh<Mesh>(test::transformed(bracket, 1e-9, {0, 0, 0}))).number_of_edges == expected);
  CHECK(detected(test::to_mesh<Mesh>(test::transformed(bracket, 3, {1 << 24, -(1 << 24), 1 << 24}))).number_of_edges ==
        expected);
  // Each component is measured by itself.
  CHECK(detected(test::to_mesh<Mesh>(test::disjoint_union(bracket, test::transformed(bracket, 1e-3, {0, 0, 0}))))
            .number_of_edges == 2 * expected);
}

TEST_CASE("scans and models of animals have few features")
{
  struct Example {
    const char* name;
    int most; // arcs; of edges of more than 40 degrees there are 0, 787, 237, 442 and 0
  };
  for (const Example& example : {Example{"bunny00.off", 0}, Example{"armadillo.off", 4}, Example{"elephant.off", 4},
                                 Example{"cow.off", 22}, Example{"eight.off", 0}}) {
    CAPTURE(example.name);
    Mesh mesh;
    REQUIRE(CGAL::IO::read_OFF(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + example.name, mesh));
    CHECK(detected(mesh).number_of_arcs <= example.most);
  }
}

TEST_CASE("angles that are none, meshes that are refused and cancelling leave the marks as they were")
{
  Mesh mesh = fm::cube(2);
  Marks marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:mine", true).first;
  const auto check_untouched = [&] {
    for (const auto e : mesh.edges())
      if (!marks[e])
        FAIL_CHECK("a mark was changed");
  };
  for (const double angle : {-1., 0., 180., std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(ts::detect_features(mesh, marks, ts::parameters::feature_angle(angle)).status == Status::INVALID_ANGLE);
    CHECK(ts::detect_features(mesh, marks, ts::parameters::weak_feature_angle(angle)).status == Status::INVALID_ANGLE);
  }
  CHECK(ts::detect_features(mesh, marks, ts::parameters::weak_feature_angle(41.)).status == Status::INVALID_ANGLE);
  CHECK(ts::detect_features(mesh, marks, CGAL::parameters::visitor(Stopping_visitor())).status == Status::INTERRUPTED);
  check_untouched();
  Mesh empty;
  const auto report = ts::detect_features(empty, marks_of(empty));
  CHECK(report.status == Status::INVALID_MESH);
  CHECK(describe(report, empty) == "the mesh has no face: it needs at least one");
}

TEST_CASE("the detection of features can be cancelled", "[cancel]")
{
  Mesh mesh = fm::gear(9, 4);
  Marks marks = marks_of(mesh);
  check_cancelling([&](const auto& visitor) {
    return ts::detect_features(mesh, marks, CGAL::parameters::visitor(visitor)).status == Status::INTERRUPTED;
  });
}

} // namespace detect_features_test
