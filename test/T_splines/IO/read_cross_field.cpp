// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_cross_field.h>

#include "Cross_field/test_meshes.h"
#include "IO/Temporary_directory.h"
#include "IO/Triangle_with_field.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_cone_angles.h>
#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/write_rawfield.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <ios>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace read_cross_field_test {

namespace ts = CGAL::T_splines;
using Status = ts::Field_file_status;
using Mesh = test::Surface_mesh;
using Cones = std::vector<std::pair<Mesh::Vertex_index, int>>;

namespace {

struct Triangle : Triangle_with_field {
  Mesh::Property_map<Mesh::Halfedge_index, int> matching =
      mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching", 7).first;

  ts::Field_file_report read(const std::string& filename)
  {
    return ts::read_cross_field(filename, mesh, field, ts::parameters::halfedge_matching_map(matching));
  }
};

std::string written(const Temporary_directory& directory, const std::string& name, const std::string& content)
{
  std::ofstream(directory.file(name), std::ios::binary) << content;
  return directory.file(name);
}

// A file per format, with the direction of the x-axis.
const std::vector<std::pair<std::string, std::string>> examples = {
    {"a.rawfield", "4 1\n1 0 0  0 1 0  -1 0 0  0 -1 0\n"},
    {"a.crossfield", "2 1\n0  1 0 0  0 1 0\n"},
    {"a.rosy", "1\n4\n1 0 0\n"},
    {"a.ffield", "target_frame\n1\nk1 k2\n1 1 1 0 0 0 1 0\ncrossfield_angles\n0\nMI_matchings\n1 2 0 0 0 0\n"}};

} // namespace

TEST_CASE("the extension of a field file, in any case, decides its format")
{
  const Temporary_directory directory;
  for (const auto& [name, content] : examples) {
    Triangle triangle;
    const ts::Field_file_report report = triangle.read(written(directory, name, content));
    CAPTURE(name, describe(report));
    REQUIRE(report.success());
    const test::Vector_3 v = triangle.field[*triangle.mesh.faces().begin()];
    CHECK(v.x() * v.y() == Approx(0).margin(1e-12));
    for (const auto h : halfedges(triangle.mesh))
      CHECK(triangle.matching[h] == 0);
  }
  Triangle triangle;
  CHECK(triangle.read(written(directory, "a.RawField", examples[0].second)).success());
  CHECK(triangle.read(written(directory, "b.rosy", examples[0].second)).status == Status::WRONG_SYMMETRY);
}

TEST_CASE("a field file with an unknown extension is refused with the known ones, one that is not there without a line")
{
  const Temporary_directory directory;
  Triangle triangle;
  CHECK(describe(triangle.read(written(directory, "field.txt", ""))) ==
        "the file format is not known; fields are read from .rawfield, .crossfield, .rosy and .ffield");
  std::filesystem::create_directory(directory.file("directory.rosy"));
  for (const char* name : {"none.rosy", "none.ffield", "directory.rosy"})
    CHECK(describe(triangle.read(directory.file(name))) == "the file cannot be read");
  Cones cones;
  CHECK(ts::read_cones(directory.file("none.cones"), triangle.mesh, cones).status == Status::UNREADABLE);
  CHECK(ts::read_cone_angles(directory.file("Th_hat"), triangle.mesh, cones).status == Status::UNREADABLE);
}

TEST_CASE("each reader of fields and cones takes the name of a file")
{
  const Temporary_directory directory;
  Triangle t;
  const auto file = [&](const int i) { return written(directory, "any_name", examples[i].second); };
  CHECK(ts::read_rawfield(file(0), t.mesh, t.field).success());
  CHECK(ts::read_crossfield(file(1), t.mesh, t.field).success());
  CHECK(ts::read_rosy(file(2), t.mesh, t.field).success());
  CHECK(ts::read_ffield(file(3), t.mesh, t.field, t.matching).success());
  const std::filesystem::path path = written(directory, "any_name", "1 3\n");
  Cones cones;
  CHECK(ts::read_cones(path, t.mesh, cones).success());
  CHECK(cones == Cones{{Mesh::Vertex_index(1), 3}});
  CHECK(ts::read_cones(path.c_str(), t.mesh, cones).success());
  const std::string angles = written(directory, "any_name", "3.14159265 1.57079633 3.14159265");
  CHECK(ts::read_cone_angles(angles, t.mesh, cones).success());
  CHECK(cones == Cones{{Mesh::Vertex_index(1), 1}});
}

TEST_CASE("a format without matchings has those by the closest rotation")
{
  const Temporary_directory directory;
  Mesh mesh = test::to_mesh<Mesh>(test::torus(12, 9));
  const auto field = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:field").first;
  const auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching", 7).first;
  REQUIRE(ts::compute_smooth_cross_field(mesh, field).success());
  for (const auto f : faces(mesh)) // turned by quarter turns, as a matching must undo
    for (int i = 0; i < static_cast<int>(f) % 4; ++i)
      field[f] = CGAL::cross_product(CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh), field[f]);
  std::ofstream output(directory.file("torus.rawfield"));
  ts::write_rawfield(output, mesh, field);
  output.close();
  const auto np = ts::parameters::halfedge_matching_map(matching);
  REQUIRE(ts::read_cross_field(directory.file("torus.rawfield"), mesh, field, np).success());
  ts::Holonomy_signature<Mesh> with_matchings, closest;
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, with_matchings, np).success());
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, closest).success());
  for (const auto h : halfedges(mesh))
    CHECK(matching[h] == -matching[opposite(h, mesh)]);
  CHECK(with_matchings.cones() == closest.cones());
  for (std::size_t l = 0; l < closest.loops().size(); ++l)
    CHECK(with_matchings.loops()[l].quarter_turns == closest.loops()[l].quarter_turns);
}

TEST_CASE("lines of field files end as those of mesh files, and marks of UTF-8 do not matter")
{
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xEF\xBB\xBF# comment" + end + "4 1" + end + end + "1 0 0  0 1 0" + end + "-1 0 0  0 -1" + end;
    Triangle t;
    std::istringstream truncated(text), complete(text + "+0" + end);
    const ts::Field_file_report report = ts::read_rawfield(truncated, t.mesh, t.field);
    CHECK(report.status == Status::TRUNCATED);
    CHECK(report.line == 5);
    CHECK(ts::read_rawfield(complete, t.mesh, t.field).success());
  }
}

TEST_CASE("what underflows is zero, whatever its digits and the locale")
{
  Triangle t;
  std::istringstream input("1 4\n1 1.5e-400 -2.5e-999999999999999999999");
  CHECK(ts::read_rosy(input, t.mesh, t.field).success());
  for (const char* number : {"1.5e400", "-1e999999999999999999999", "inf", "nan"}) {
    std::istringstream bad(std::string("1 4\n1 0 ") + number);
    CHECK(ts::read_rosy(bad, t.mesh, t.field).status == Status::NON_FINITE_NUMBER);
  }
}

} // namespace read_cross_field_test
