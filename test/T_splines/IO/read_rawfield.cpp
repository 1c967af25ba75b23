// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_rawfield.h>

#include "Cross_field/test_meshes.h"
#include "IO/Triangle_with_field.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace read_rawfield_test {

namespace ts = CGAL::T_splines;
using Status = ts::Field_file_status;
using Mesh = test::Surface_mesh;

namespace {

Mesh square()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(test::Point_3(0, 0, 0)), b = mesh.add_vertex(test::Point_3(1, 0, 0)),
             c = mesh.add_vertex(test::Point_3(1, 1, 0)), d = mesh.add_vertex(test::Point_3(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  return mesh;
}

ts::Field_file_report read(const std::string& text, std::vector<test::Vector_3>* field = nullptr)
{
  Mesh mesh = square();
  auto map = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:field").first;
  std::istringstream input(text);
  const ts::Field_file_report report = ts::read_rawfield(input, mesh, map);
  if (field)
    for (const auto f : faces(mesh))
      field->push_back(map[f]);
  return report;
}

const std::string good = "1 0 0  0 1 0  -1 0 0  0 -1 0";

} // namespace

TEST_CASE("the four vectors may come in either order and have any length")
{
  std::vector<test::Vector_3> field;
  REQUIRE(read("4 2\n2 1 0  -1 2 0  -2 -1 0  1 -2 0\n# a comment\n.2 .1 0  .1 -.2 0  -.2 -.1 0  -.1 .2 0\n", &field)
              .success());
  for (const test::Vector_3& v : field) {
    CHECK(v.squared_length() == Approx(1));
    CHECK(angle_of_cross(v) == Approx(std::atan2(1., 2.)));
  }
}

TEST_CASE("a sheared frame stands for the cross that is symmetric to it")
{
  for (const double shear : {0.1, 0.7, 0.8, 1.2}) { // the axes enclose pi/2 - shear
    std::ostringstream text;
    text << "4 2\n";
    for (int f = 0; f < 2; ++f) {
      const double a = 0.3 + shear / 2, b = 0.3 + std::acos(0.) - shear / 2;
      text << std::cos(a) << ' ' << std::sin(a) << " 0 " << 3 * std::cos(b) << ' ' << 3 * std::sin(b) << " 0 "
           << -std::cos(a) << ' ' << -std::sin(a) << " 0 " << -3 * std::cos(b) << ' ' << -3 * std::sin(b) << " 0\n";
    }
    std::vector<test::Vector_3> field;
    REQUIRE(read(text.str(), &field).success());
    CHECK(angle_of_cross(field[0]) == Approx(0.3).margin(1e-5));
  }
}

TEST_CASE("bad files are refused with the line and the face")
{
  struct Example {
    std::string text;
    Status status;
    std::size_t line, index;
  };
  const std::size_t none = ts::Field_file_report::none;
  for (const Example& example :
       {Example{"", Status::TRUNCATED, 1, none},
        Example{"2 2\n1 0 0 -1 0 0\n1 0 0 -1 0 0\n", Status::WRONG_SYMMETRY, 1, none},
        Example{"6 2\n", Status::WRONG_SYMMETRY, 1, none}, Example{"1 2\n", Status::WRONG_SYMMETRY, 1, none},
        Example{"4 3\n" + good + "\n" + good + "\n" + good + "\n", Status::WRONG_COUNT, 1, none},
        Example{"4 2\n" + good + "\n1 0 0 0 1", Status::TRUNCATED, 3, 1},
        Example{"4 2\n" + good + "\n1 0 0 0 x 0", Status::SYNTAX_ERROR, 3, 1},
        Example{"4 2\n1 0 0  0 nan 0  -1 0 0  0 -1 0\n" + good, Status::NON_FINITE_NUMBER, 2, 0},
        Example{"4 2\n1 0 0  0 1e999 0  -1 0 0  0 -1 0\n" + good, Status::NON_FINITE_NUMBER, 2, 0},
        Example{"4 2\n" + good + "\n1 0 0  0 0 0  -1 0 0  0 -1 0\n", Status::ZERO_VECTOR, 3, 1},
        Example{"4 2\n" + good + "\n1 0 .1  0 1 0  -1 0 0  0 -1 0\n", Status::NOT_TANGENT, 3, 1},
        Example{"4 2\n" + good + "\n1 0 0  1 0 0  -1 0 0  -1 0 0\n", Status::NOT_A_CROSS, 3, 1},
        Example{"4 2\n1 0 0  1 0 0  1 0 0  1 0 0\n" + good, Status::NOT_A_CROSS, 2, 0},
        Example{"4 2\n" + good + "\n" + good + "\n1\n", Status::TRAILING_DATA, 4, none}}) {
    CAPTURE(example.text);
    const ts::Field_file_report report = read(example.text);
    CHECK(report.status == example.status);
    CHECK(report.line == example.line);
    CHECK(report.index == example.index);
  }
  const ts::Field_file_report report = read("4 7\n");
  CHECK(report.expected == 2);
  CHECK(report.actual == 7);
  CHECK(read("4 2\nfoo").text == "foo");
}

TEST_CASE("an unreadable stream and an invalid mesh are reported")
{
  Mesh mesh = square();
  auto map = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:field").first;
  std::istringstream bad("4 2\n");
  bad.setstate(std::ios::failbit);
  CHECK(ts::read_rawfield(bad, mesh, map).status == Status::UNREADABLE);
  mesh.point(Mesh::Vertex_index(1)) = mesh.point(Mesh::Vertex_index(0));
  std::istringstream input("4 2\n");
  CHECK(ts::read_rawfield(input, mesh, map).status == Status::INVALID_MESH);
}

} // namespace read_rawfield_test
