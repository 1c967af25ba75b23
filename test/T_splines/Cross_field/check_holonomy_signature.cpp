// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace check_holonomy_signature_test {

namespace ts = CGAL::T_splines;
using Status = ts::Holonomy_signature_status;
using Mesh = test::Surface_mesh;
using Signature = ts::Holonomy_signature<Mesh>;

namespace {

Signature copy_with_loops(const Signature& signature, const std::vector<Signature::Loop>& loops)
{
  Signature result;
  for (const Signature::Cone& cone : signature.cones())
    result.set_quarter_turns(cone.first, cone.second);
  for (const Signature::Loop& loop : loops)
    result.add_loop(loop.halfedges, loop.quarter_turns);
  return result;
}

} // namespace

TEST_CASE("signatures that were tampered with are refused by name")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::plate(2));
  Signature signature;
  const std::vector<std::pair<Mesh::Vertex_index, int>> cones = {{Mesh::Vertex_index(3), 12}};
  REQUIRE(ts::holonomy_signature_of_cones(mesh, cones, signature).success());
  REQUIRE(ts::check_holonomy_signature(mesh, signature).success());
  std::vector<Signature::Loop> loops = signature.loops();
  SECTION("Gauss-Bonnet")
  {
    signature.set_quarter_turns(Mesh::Vertex_index(5), 6);
    const auto report = ts::check_holonomy_signature(mesh, signature);
    CHECK(report.status == Status::GAUSS_BONNET_VIOLATED);
    CHECK(report.expected == -8);
    CHECK(report.actual == -10);
  }
  SECTION("a vertex without a quarter turn")
  {
    signature.set_quarter_turns(Mesh::Vertex_index(5), 0);
    signature.set_quarter_turns(Mesh::Vertex_index(6), 8);
    const auto report = ts::check_holonomy_signature(mesh, signature);
    CHECK(report.status == Status::NON_POSITIVE_CONE);
    CHECK(report.vertex == Mesh::Vertex_index(5));
  }
  SECTION("a vertex and a loop of another mesh")
  {
    signature.set_quarter_turns(Mesh::Vertex_index(100000), 3);
    auto report = ts::check_holonomy_signature(mesh, signature);
    CHECK(report.status == Status::FOREIGN_VERTEX);
    CHECK(report.index == 1);
    CHECK(describe(report, mesh).find("another mesh, or the mesh was edited: cone 1, counted from 0") !=
          std::string::npos);
    signature.set_quarter_turns(Mesh::Vertex_index(100000), 4);
    loops[1].halfedges.back() = Mesh::Halfedge_index(100000);
    report = ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops));
    CHECK(report.status == Status::FOREIGN_LOOP);
    CHECK(report.index == 1);
    CHECK(describe(report, mesh).find("loop 1, counted from 0") != std::string::npos);
  }
  SECTION("no vertex")
  {
    signature.set_quarter_turns(Mesh::null_vertex(), 3);
    const auto report = ts::check_holonomy_signature(mesh, signature);
    CHECK(report.status == Status::NULL_VERTEX);
    CHECK(report.index == 1);
  }
  SECTION("loops of any direction, start and order are admissible")
  {
    for (Signature::Loop& loop : loops) {
      std::reverse(loop.halfedges.begin(), loop.halfedges.end());
      for (auto& h : loop.halfedges)
        h = opposite(h, mesh);
      std::rotate(loop.halfedges.begin(), loop.halfedges.begin() + 1, loop.halfedges.end());
    }
    std::swap(loops[0], loops[3]);
    CHECK(ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops)).success());
  }
  SECTION("a gap in a loop")
  {
    loops[2].halfedges.erase(loops[2].halfedges.begin() + 1);
    const auto report = ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops));
    CHECK(report.status == Status::INVALID_LOOP);
    CHECK(report.index == 2);
  }
  SECTION("a loop that turns back")
  {
    const auto h = loops[1].halfedges.front();
    loops[1].halfedges = {h, opposite(h, mesh)};
    CHECK(ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops)).status == Status::INVALID_LOOP);
  }
  SECTION("an empty loop, and one with a null halfedge")
  {
    loops[0].halfedges.clear();
    CHECK(ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops)).status == Status::INVALID_LOOP);
    loops[0].halfedges = {Mesh::null_halfedge()};
    CHECK(ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops)).status == Status::INVALID_LOOP);
  }
  SECTION("a loop too few")
  {
    loops.pop_back();
    const auto report = ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops));
    CHECK(report.status == Status::WRONG_NUMBER_OF_LOOPS);
    CHECK(report.expected == 4);
    CHECK(report.actual == 3);
  }
  SECTION("a loop around a vertex generates nothing")
  {
    loops[3].halfedges.clear();
    for (const auto h : halfedges_around_source(Mesh::Vertex_index(8), mesh))
      loops[3].halfedges.insert(loops[3].halfedges.begin(), h);
    const auto report = ts::check_holonomy_signature(mesh, copy_with_loops(signature, loops));
    CHECK(report.status == Status::DEPENDENT_LOOPS);
  }
}

} // namespace check_holonomy_signature_test
