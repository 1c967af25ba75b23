// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_cone_angles.h>

#include "Cross_field/test_meshes.h"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace read_cone_angles_test {

namespace ts = CGAL::T_splines;
using Status = ts::Field_file_status;

namespace {

template <typename Mesh>
using Cones = std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, int>>;

} // namespace

TEST_CASE("total angles are read as cones")
{
  using Mesh = test::Surface_mesh;
  const Mesh mesh = test::to_mesh<Mesh>(test::punctured_torus());
  const auto text = [&mesh](const int changed, const std::string& by) {
    std::string result;
    int i = 0;
    for (const auto v : vertices(mesh)) {
      const char* regular = CGAL::is_border(v, mesh) ? "3.1415926535897931" : "6.2831853071795862";
      result += (i++ == changed ? by : regular) + std::string("\n");
    }
    return result;
  };
  const auto read = [&mesh](const std::string& input_text, Cones<Mesh>& cones) {
    std::istringstream input(input_text);
    return ts::read_cone_angles(input, mesh, cones);
  };
  Cones<Mesh> cones;
  REQUIRE(read(text(-1, ""), cones).success());
  CHECK(cones.empty());
  REQUIRE(read(text(50, "4.71238898038469"), cones).success());
  CHECK(cones == Cones<Mesh>{{Mesh::Vertex_index(50), 3}});
  CHECK(read(text(50, "4.7"), cones).status == Status::NOT_A_QUARTER_TURN);
  CHECK(read(text(50, "4.7"), cones).index == 50);
  CHECK(read(text(50, "0"), cones).status == Status::NON_POSITIVE_CONE);
  CHECK(read(text(50, "inf"), cones).status == Status::NON_FINITE_NUMBER);
  CHECK(read(text(50, ""), cones).status == Status::WRONG_COUNT);
  CHECK(read(text(-1, "") + "3.14159265358979\n", cones).status == Status::WRONG_COUNT);
  CHECK(cones.size() == 1);
}

} // namespace read_cone_angles_test
