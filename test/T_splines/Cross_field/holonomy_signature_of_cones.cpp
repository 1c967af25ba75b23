// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <utility>
#include <vector>

namespace holonomy_signature_of_cones_test {

namespace ts = CGAL::T_splines;
using Status = ts::Holonomy_signature_status;

namespace {

template <typename Mesh>
using Cones = std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, int>>;

// The first vertices of the mesh with these numbers.
template <typename Mesh>
Cones<Mesh> cones(const Mesh& mesh, const std::vector<int>& numbers)
{
  Cones<Mesh> result;
  auto v = vertices(mesh).begin();
  for (const int k : numbers)
    result.emplace_back(*v++, k);
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("cones that satisfy Gauss and Bonnet make an admissible signature", "", test::Surface_mesh,
                   test::Polyhedron_3, test::Linear_cell_complex)
{
  struct Example {
    int genus;
    std::vector<int> numbers;
  };
  for (const Example& example :
       {Example{0, std::vector<int>(8, 3)}, Example{0, {1, 1, 2}}, Example{1, {}}, Example{1, {3, 5}}, Example{2, {12}},
        Example{2, std::vector<int>(8, 5)}, Example{3, {20}}}) {
    const TestType mesh = test::to_mesh<TestType>(test::plate(example.genus));
    ts::Holonomy_signature<TestType> signature;
    const auto report = ts::holonomy_signature_of_cones(mesh, cones(mesh, example.numbers), signature);
    CHECK(report.status == Status::VALID);
    CHECK(signature.cones().size() == example.numbers.size());
    CHECK(signature.loops().size() == static_cast<std::size_t>(2 * example.genus));
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
  }
}

TEST_CASE("the numbers of loops can be given")
{
  using Mesh = test::Surface_mesh;
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(12, 9));
  ts::Holonomy_signature<Mesh> signature;
  REQUIRE(ts::holonomy_signature_of_cones(mesh, Cones<Mesh>(), signature).success());
  // Geodesic loops of the flat metric do not turn.
  CHECK(signature.loops()[0].quarter_turns == 0);
  CHECK(signature.loops()[1].quarter_turns == 0);
  const auto np = ts::parameters::loop_turning_numbers(std::vector<int>{3, -2});
  REQUIRE(ts::holonomy_signature_of_cones(mesh, Cones<Mesh>(), signature, np).success());
  CHECK(signature.loops()[0].quarter_turns == 3);
  CHECK(signature.loops()[1].quarter_turns == -2);
  for (const std::vector<int>& wrong : {std::vector<int>{1}, std::vector<int>{1, 2, 3}}) {
    const auto report =
        ts::holonomy_signature_of_cones(mesh, Cones<Mesh>(), signature, ts::parameters::loop_turning_numbers(wrong));
    CHECK(report.status == Status::WRONG_NUMBER_OF_TURNS);
    CHECK(report.expected == 2);
    CHECK(report.actual == static_cast<int>(wrong.size()));
  }
}

TEST_CASE("cones that make no signature are refused by name")
{
  using Mesh = test::Surface_mesh;
  const Mesh mesh = test::to_mesh<Mesh>(test::disjoint_union(test::torus(6, 5), test::plate(0)));
  ts::Holonomy_signature<Mesh> signature;
  Cones<Mesh> list = {{Mesh::Vertex_index(3), 3}, {Mesh::Vertex_index(4), 5}};
  SECTION("by how much, and in which component")
  {
    const auto report = ts::holonomy_signature_of_cones(mesh, list, signature);
    CHECK(report.status == Status::GAUSS_BONNET_VIOLATED);
    CHECK(report.component == 1);
    CHECK(report.expected == 8);
    CHECK(report.actual == 0);
    CHECK(target(halfedge(report.face, mesh), mesh).idx() >= 30);
  }
  SECTION("twice the same vertex")
  {
    list.emplace_back(Mesh::Vertex_index(3), 3);
    const auto report = ts::holonomy_signature_of_cones(mesh, list, signature);
    CHECK(report.status == Status::DUPLICATE_CONE);
    CHECK(report.vertex == Mesh::Vertex_index(3));
    CHECK(report.index == 2);
  }
  SECTION("no quarter turn")
  {
    for (const int k : {0, -3}) {
      list.emplace_back(Mesh::Vertex_index(7), k);
      const auto report = ts::holonomy_signature_of_cones(mesh, list, signature);
      CHECK(report.status == Status::NON_POSITIVE_CONE);
      CHECK(report.vertex == Mesh::Vertex_index(7));
      CHECK(report.actual == k);
      list.pop_back();
    }
  }
  SECTION("a vertex of another mesh, or one that was removed")
  {
    list.emplace_back(Mesh::Vertex_index(100000), 3);
    auto report = ts::holonomy_signature_of_cones(mesh, list, signature);
    CHECK(report.status == Status::FOREIGN_VERTEX);
    CHECK(report.index == 2);
    Mesh edited = mesh;
    const Mesh::Vertex_index removed = edited.add_vertex(test::Point_3(0, 0, 0));
    edited.remove_vertex(removed);
    list.back().first = removed;
    report = ts::holonomy_signature_of_cones(edited, list, signature);
    CHECK(report.status == Status::FOREIGN_VERTEX);
    CHECK(report.index == 2);
  }
  SECTION("no vertex")
  {
    list.emplace_back(Mesh::null_vertex(), 3);
    CHECK(ts::holonomy_signature_of_cones(mesh, list, signature).status == Status::NULL_VERTEX);
  }
}

} // namespace holonomy_signature_of_cones_test
