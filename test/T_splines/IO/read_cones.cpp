// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_cones.h>

#include "Cross_field/test_meshes.h"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace read_cones_test {

namespace ts = CGAL::T_splines;
using Status = ts::Field_file_status;

namespace {

template <typename Mesh>
using Cones = std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, int>>;

} // namespace

TEST_CASE("bad cone files are refused with the line and the vertex, and nothing is read")
{
  using Mesh = test::Surface_mesh;
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  struct Example {
    const char* text;
    Status status;
    std::size_t line;
  };
  for (const Example& example :
       {Example{"3 3\n4", Status::TRUNCATED, 2}, Example{"3 3\n4 x\n", Status::SYNTAX_ERROR, 2},
        Example{"3 3.5\n", Status::SYNTAX_ERROR, 1}, Example{"3 3\n\n30 5\n", Status::INDEX_OUT_OF_RANGE, 3},
        Example{"-1 3\n", Status::INDEX_OUT_OF_RANGE, 1}, Example{"3 3\n3 5\n", Status::DUPLICATE_CONE, 2},
        Example{"3 0\n", Status::NON_POSITIVE_CONE, 1}, Example{"3 -2\n", Status::NON_POSITIVE_CONE, 1},
        Example{"3 99999999999999999999\n", Status::SYNTAX_ERROR, 1}}) {
    CAPTURE(example.text);
    std::istringstream input(example.text);
    Cones<Mesh> cones = {{Mesh::Vertex_index(1), 7}};
    const ts::Field_file_report report = ts::read_cones(input, mesh, cones);
    CHECK(report.status == example.status);
    CHECK(report.line == example.line);
    CHECK(cones.size() == 1);
  }
  std::istringstream empty("\n# nothing\n");
  Cones<Mesh> cones;
  CHECK(ts::read_cones(empty, mesh, cones).success());
  CHECK(cones.empty());
}

} // namespace read_cones_test
