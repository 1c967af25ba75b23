// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/IO/read_features.h>
#include <CGAL/T_splines/IO/write_features.h>

#include "Cross_field/test_meshes.h"
#include "IO/Temporary_directory.h"
#include "feature_meshes.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <ios>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace read_features_test {

namespace ts = CGAL::T_splines;
using Status = ts::Feature_file_status;
using Format = ts::Feature_file_format;
using Mesh = test::Surface_mesh;
using Marks = Mesh::Property_map<Mesh::Edge_index, bool>;

namespace {

// A tetrahedron with a fifth vertex in the middle of its bottom: vertex 4 has an edge to 0, 1 and 2, none to 3.
struct Scene {
  Mesh mesh;
  Marks marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;

  Scene()
  {
    test::Soup soup;
    soup.points = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 1, 0}};
    soup.faces = {{0, 2, 4}, {2, 1, 4}, {1, 0, 4}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  }

  ts::Feature_file_report read(const std::string& text, const Format format)
  {
    std::istringstream input(text);
    return ts::read_features(input, mesh, marks, format);
  }

  std::set<std::pair<int, int>> marked() const
  {
    std::set<std::pair<int, int>> result;
    for (const auto e : mesh.edges())
      if (marks[e])
        result.insert(std::minmax({static_cast<int>(source(e, mesh)), static_cast<int>(target(e, mesh))}));
    return result;
  }
};

using Pairs = std::set<std::pair<int, int>>;

} // namespace

TEST_CASE("pairs of vertices are read, with comments and in either direction")
{
  Scene scene;
  const auto report = scene.read("# features\r\n0 1\r\n\r\n  3\t2 # up\n1 0\n4 2", Format::VERTEX_PAIRS);
  REQUIRE(report.success());
  CHECK(scene.marked() == Pairs{{0, 1}, {2, 3}, {2, 4}});
  CHECK(report.number_of_edges == 3);
  CHECK(report.number_of_repetitions == 1);
  CHECK(describe(report) == "the file was read: 3 feature edges");
  CHECK(scene.read("\n# none\n", Format::VERTEX_PAIRS).success());
  CHECK(scene.marked().empty());
}

TEST_CASE("quadwild's features are read: edges of faces, from corner to corner")
{
  Scene scene;
  const auto report = scene.read("4\n0 3 0\n1 3 1\n1 3 2\n0 5 0\n", Format::SHARP);
  REQUIRE(report.success());
  CHECK(scene.marked() == Pairs{{0, 1}, {1, 3}, {0, 3}, {0, 2}});
  const auto twice = scene.read("2\n0 3 0\n0 2 0\n", Format::SHARP); // one edge from both of its sides
  REQUIRE(twice.success());
  CHECK(scene.marked() == Pairs{{0, 1}});
  CHECK(twice.number_of_repetitions == 1);
  CHECK(scene.read("0\n", Format::SHARP).success());
  CHECK(scene.marked().empty());
}

TEST_CASE("lines of an OBJ file are read: chains, counted from one end or the other")
{
  Scene scene;
  const auto report =
      scene.read("o thing\nv 0 0 0\nv 3 0 0\nv 0 3 0\nl 1 2 3/1\nv 0 0 3\nv 1 1 0 \\\n 1\nf 1 3 5\nl -1 \\\n"
                 "  -4\nusemtl a\n",
                 Format::OBJ_LINES);
  REQUIRE(report.success());
  CHECK(scene.marked() == Pairs{{0, 1}, {1, 2}, {1, 4}});
}

TEST_CASE("bad files with features are refused with the line, and nothing is written")
{
  struct Example {
    Format format;
    const char* text;
    Status status;
    std::size_t line;
    const char* description;
  };
  for (const Example& example :
       {Example{Format::VERTEX_PAIRS, "0 1\n3 4\n", Status::NOT_AN_EDGE, 2,
                "line 2: a feature is no edge of the mesh (from vertex 3 to vertex 4, counted from 0)"},
        Example{Format::VERTEX_PAIRS, "2 2\n", Status::NOT_AN_EDGE, 1,
                "line 1: a feature is no edge of the mesh (from vertex 2 to vertex 2, counted from 0)"},
        Example{Format::VERTEX_PAIRS, "0 1\n\n0\n", Status::WRONG_NUMBER_OF_COLUMNS, 3,
                "line 3: a line has the wrong number of columns (1 instead of 2)"},
        Example{Format::VERTEX_PAIRS, "0 1 2\n", Status::WRONG_NUMBER_OF_COLUMNS, 1,
                "line 1: a line has the wrong number of columns (3 instead of 2)"},
        Example{Format::VERTEX_PAIRS, "0 5\n", Status::VERTEX_OUT_OF_RANGE, 1,
                "line 1: an index is out of range: the mesh has no such vertex (of 5 vertices): \"5\""},
        Example{Format::VERTEX_PAIRS, "-1 0\n", Status::VERTEX_OUT_OF_RANGE, 1,
                "line 1: an index is out of range: the mesh has no such vertex (of 5 vertices): \"-1\""},
        Example{Format::VERTEX_PAIRS, "0 1\n0 x\n", Status::SYNTAX_ERROR, 2,
                "line 2: an integer is expected here: \"x\""},
        Example{Format::VERTEX_PAIRS, "0 1.0\n", Status::SYNTAX_ERROR, 1, nullptr},
        Example{Format::VERTEX_PAIRS, "0 99999999999999999999\n", Status::SYNTAX_ERROR, 1, nullptr},
        Example{Format::SHARP, "", Status::TRUNCATED, 1, nullptr},
        Example{
            Format::SHARP, "2\n0 3 0\n", Status::TRUNCATED, 2,
            "line 2: the file is truncated: it ends before all features that it announces have come (1 instead of 2)"},
        Example{Format::SHARP, "1\n0 3\n", Status::WRONG_NUMBER_OF_COLUMNS, 2, nullptr},
        Example{Format::SHARP, "1 0 3 0\n", Status::WRONG_NUMBER_OF_COLUMNS, 1, nullptr},
        Example{Format::SHARP, "-1\n", Status::SYNTAX_ERROR, 1, nullptr},
        Example{Format::SHARP, "1\nconvex 3 0\n", Status::SYNTAX_ERROR, 2, nullptr},
        Example{Format::SHARP, "1\n0 6 0\n", Status::FACE_OUT_OF_RANGE, 2,
                "line 2: an index is out of range: the mesh has no such face (of 6 faces): \"6\""},
        Example{Format::SHARP, "1\n0 3 3\n", Status::EDGE_OUT_OF_RANGE, 2,
                "line 2: an index is out of range: a face has the edges 0, 1 and 2: \"3\""},
        Example{Format::SHARP, "1\n0 3 0\n0 3 1\n", Status::TRAILING_DATA, 3, nullptr},
        Example{Format::OBJ_LINES, "v 0 0 0\nl 1\n", Status::WRONG_NUMBER_OF_COLUMNS, 2, nullptr},
        Example{Format::OBJ_LINES, "l 1 2\nl 1 0\n", Status::VERTEX_OUT_OF_RANGE, 2, nullptr},
        Example{Format::OBJ_LINES, "l 1 6\n", Status::VERTEX_OUT_OF_RANGE, 1, nullptr},
        Example{Format::OBJ_LINES, "v 0 0 0\nl 1 -2\n", Status::VERTEX_OUT_OF_RANGE, 2, nullptr},
        Example{Format::OBJ_LINES, "l 1 two\n", Status::SYNTAX_ERROR, 1, nullptr},
        Example{Format::OBJ_LINES, "l 1 2 \\\n 4 5\n", Status::NOT_AN_EDGE, 2, nullptr}}) {
    CAPTURE(example.text);
    Scene scene;
    for (const auto e : scene.mesh.edges())
      scene.marks[e] = true;
    const ts::Feature_file_report report = scene.read(example.text, example.format);
    CHECK(report.status == example.status);
    CHECK(report.line == example.line);
    if (example.description != nullptr)
      CHECK(describe(report) == example.description);
    CHECK(scene.marked().size() == scene.mesh.number_of_edges());
  }
}

TEST_CASE("the extension of a file says its format")
{
  const Temporary_directory directory;
  Scene scene;
  const auto read = [&](const std::string& name, const std::string& text) {
    std::ofstream(directory.file(name)) << text;
    return ts::read_features(directory.file(name), scene.mesh, scene.marks);
  };
  CHECK(read("a.txt", "0 1\n").number_of_edges == 1);
  CHECK(read("a.SHARP", "1\n0 3 0\n").number_of_edges == 1);
  CHECK(read("a.obj", "l 1 2 3\n").number_of_edges == 2);
  CHECK(read("a", "0 1\n").number_of_edges == 1);
  const auto missing = ts::read_features(directory.file("none.txt"), scene.mesh, scene.marks);
  CHECK(missing.status == Status::UNREADABLE);
  CHECK(describe(missing) == "the file cannot be read");
  std::istringstream failed("0 1\n");
  failed.setstate(std::ios::failbit);
  CHECK(ts::read_features(failed, scene.mesh, scene.marks).status == Status::UNREADABLE);
}

TEMPLATE_TEST_CASE("features are written and read back", "", test::Surface_mesh, test::Polyhedron_3,
                   test::Linear_cell_complex)
{
  TestType mesh =
      test::to_mesh<TestType>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, 2));
  auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh), again = marks;
  REQUIRE(ts::detect_features(mesh, marks).success());
  std::stringstream stream;
  CHECK_FALSE(ts::write_features(stream, mesh, marks));
  const std::string text = stream.str();
  auto read_marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  const auto report = ts::read_features(stream, mesh, read_marks);
  REQUIRE(report.success());
  CHECK(report.number_of_edges == 24);
  CHECK(report.number_of_repetitions == 0);
  for (const auto e : edges(mesh))
    CHECK(get(read_marks, e) == get(marks, e));
  std::ostringstream second;
  CHECK_FALSE(ts::write_features(second, mesh, read_marks));
  CHECK(second.str() == text);
  second.setstate(std::ios::badbit);
  CHECK(ts::write_features(second, mesh, marks) == std::io_errc::stream);

  const Temporary_directory directory;
  REQUIRE_FALSE(ts::write_features(directory.file("a.features"), mesh, marks));
  CHECK(ts::read_features(directory.file("a.features"), mesh, again).number_of_edges == 24);
  CHECK(ts::write_features(directory.file("none/a.features"), mesh, marks));
}

} // namespace read_features_test
