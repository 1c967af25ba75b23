// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/Field_file_report.h>

#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/read_rawfield.h>

#include "Cross_field/test_meshes.h"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Field_file_report_test {

namespace {

using Mesh = test::Surface_mesh;

std::string refusal_of_cones(const std::string& content)
{
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  std::istringstream input(content);
  std::vector<std::pair<Mesh::Vertex_index, int>> cones;
  const auto report = CGAL::T_splines::read_cones(input, mesh, cones);
  CHECK_FALSE(report);
  return describe(report);
}

std::string refusal_of_field(const std::string& content)
{
  Mesh mesh = test::to_mesh<Mesh>(test::torus(6, 5));
  std::istringstream input(content);
  const auto field = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:cross").first;
  const auto report = CGAL::T_splines::read_rawfield(input, mesh, field);
  CHECK_FALSE(report);
  return describe(report);
}

} // namespace

TEST_CASE("a refusal of a field file says the line, the element and the numbers")
{
  CHECK(refusal_of_cones("3 5\n30 3\n") ==
        "line 2: an index is out of range: the mesh has no such vertex (vertex 30, counted from 0, of 30)");
  CHECK(refusal_of_cones("3 5\n3 3\n") == "line 2: a vertex is listed twice (vertex 3, counted from 0); list it once");
  CHECK(
      refusal_of_cones("4 0\n") ==
      "line 1: a vertex has fewer than one quarter turn (vertex 4, counted from 0, has k = 0); give it at least 1, or "
      "leave it out");
  CHECK(refusal_of_cones("4 three\n").find(": \"three\"") != std::string::npos);
  CHECK(refusal_of_field("4 59\n").find("another number of elements (59 instead of 60)") != std::string::npos);
  CHECK(refusal_of_field("2 60\n").find("four directions per face (2 instead of 4)") != std::string::npos);
}

} // namespace Field_file_report_test
