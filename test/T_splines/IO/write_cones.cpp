// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/write_cones.h>

#include "Cross_field/test_meshes.h"
#include "IO/Temporary_directory.h"

#include <catch2/catch.hpp>

#include <ios>
#include <sstream>
#include <utility>
#include <vector>

namespace write_cones_test {

namespace ts = CGAL::T_splines;

namespace {

template <typename Mesh>
using Cones = std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, int>>;

} // namespace

TEMPLATE_TEST_CASE("cones are written by index and read back", "", test::Surface_mesh, test::Polyhedron_3,
                   test::Linear_cell_complex)
{
  const TestType mesh = test::to_mesh<TestType>(test::torus(6, 5));
  std::vector<typename boost::graph_traits<TestType>::vertex_descriptor> v(vertices(mesh).begin(),
                                                                           vertices(mesh).end());
  ts::Holonomy_signature<TestType> signature;
  signature.set_quarter_turns(v[20], 5);
  signature.set_quarter_turns(v[3], 3);
  std::stringstream stream;
  CHECK_FALSE(ts::write_cones(stream, mesh, signature));
  CHECK(stream.str() == "3 3\n20 5\n");
  Cones<TestType> cones;
  REQUIRE(ts::read_cones(stream, mesh, cones).success());
  CHECK(cones == Cones<TestType>{{v[3], 3}, {v[20], 5}});
  stream.setstate(std::ios::badbit);
  CHECK(ts::write_cones(stream, mesh, signature) == std::io_errc::stream);

  const Temporary_directory directory;
  REQUIRE_FALSE(ts::write_cones(directory.file("a.cones"), mesh, signature));
  REQUIRE(ts::read_cones(directory.file("a.cones"), mesh, cones).success());
  CHECK(cones == Cones<TestType>{{v[3], 3}, {v[20], 5}});
  CHECK(ts::write_cones(directory.file("none/a.cones"), mesh, signature));
}

} // namespace write_cones_test
