// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "T_mesh_with_maps.h"
#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/is_admissible.h>

#include <CGAL/Exact_rational.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Status = T::T_mesh_reading_status;

const std::string good = T_SPLINES_TEST_DATA "/good_t_meshes/", bad = T_SPLINES_TEST_DATA "/bad_t_meshes/";

std::string file_content(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

/// The extended valences of all vertices, in their order.
template <typename T_mesh>
std::vector<int> valences(const T_mesh& t)
{
  std::vector<int> result;
  for (const auto v : CGAL::make_range(vertices(t.graph)))
    result.push_back(T::extended_valence(v, t.view()));
  return result;
}

/// What is wrong with a file, and how the sentence about it goes on.
struct Bad_file {
  Status status;
  std::string description;
};

const std::map<std::string, Bad_file>& bad_files()
{
  static const std::map<std::string, Bad_file> files = {
      {"empty", {Status::EMPTY, "no faces"}},
      {"not_ply", {Status::SYNTAX_ERROR, "line 1: "}},
      {"binary", {Status::UNSUPPORTED_VARIANT, "line 2: "}},
      {"format", {Status::SYNTAX_ERROR, "line 2: "}},
      {"first_element", {Status::UNSUPPORTED_VARIANT, "found \"material\""}},
      {"other_element", {Status::UNSUPPORTED_VARIANT, "line 14: "}},
      {"polygon_mesh", {Status::SYNTAX_ERROR, "\"property double x\" is needed here"}},
      {"missing_weights", {Status::SYNTAX_ERROR, "\"property double w\" is needed here"}},
      {"missing_knots", {Status::SYNTAX_ERROR, "\"property list int double halfedge_knots\" is needed here"}},
      {"missing_opposite", {Status::SYNTAX_ERROR, "\"property list int int opposite\" is needed here"}},
      {"float_knots", {Status::SYNTAX_ERROR, "found \"float\""}},
      {"other_property", {Status::SYNTAX_ERROR, "line 9: "}},
      {"word_count", {Status::SYNTAX_ERROR, "found \"eight\""}},
      {"truncated_header", {Status::TRUNCATED, ""}},
      {"no_faces", {Status::EMPTY, "no faces"}},
      {"truncated_vertices", {Status::TRUNCATED, ""}},
      {"truncated_vertex", {Status::TRUNCATED, "(vertex 5, "}},
      {"truncated_faces", {Status::TRUNCATED, ""}},
      {"truncated_face", {Status::TRUNCATED, "(face 5, "}},
      {"too_many_faces", {Status::SYNTAX_ERROR, "line 29: "}},
      {"short_vertex", {Status::SYNTAX_ERROR, "line 17: the file does not follow its format here (vertex 2, "}},
      {"long_vertex", {Status::SYNTAX_ERROR, "found \"7\""}},
      {"word", {Status::SYNTAX_ERROR, "found \"one\""}},
      {"nan", {Status::NON_FINITE_NUMBER, "(vertex 3, "}},
      {"infinite", {Status::NON_FINITE_NUMBER, "found \"1e999\""}},
      {"zero_weight", {Status::NON_POSITIVE_WEIGHT, "(vertex 3, "}},
      {"negative_weight", {Status::NON_POSITIVE_WEIGHT, "found \"-1\""}},
      {"index",
       {Status::INDEX_OUT_OF_RANGE, "(face 3, entry 2, counted from 0): in the list vertex_indices, found \"8\""}},
      {"negative_index", {Status::INDEX_OUT_OF_RANGE, "found \"-6\""}},
      {"fraction_index", {Status::SYNTAX_ERROR, "found \"6.5\""}},
      {"fewer_knots", {Status::LIST_LENGTHS_DIFFER, "(face 3, counted from 0): halfedge_knots has 3 entries"}},
      {"more_corners", {Status::LIST_LENGTHS_DIFFER, "corner has 5 entries, vertex_indices 4"}},
      {"no_opposites", {Status::LIST_LENGTHS_DIFFER, "opposite has 0 entries"}},
      {"trailing_number", {Status::SYNTAX_ERROR, "found \"5\""}},
      {"word_knot", {Status::SYNTAX_ERROR, "found \"x\""}},
      {"nan_knot", {Status::NON_FINITE_NUMBER, "(face 3, entry 2, "}},
      {"zero_knot", {Status::NON_POSITIVE_KNOT, "(face 3, entry 3, "}},
      {"negative_knot", {Status::NON_POSITIVE_KNOT, "found \"-1\""}},
      {"vanishing_knot", {Status::NON_POSITIVE_KNOT, "found \"1e-999\""}},
      {"three_corners", {Status::WRONG_NUMBER_OF_CORNERS, "(face 3, counted from 0): it has 3"}},
      {"five_corners", {Status::WRONG_NUMBER_OF_CORNERS, "(face 3, counted from 0): it has 5"}},
      {"no_corners", {Status::WRONG_NUMBER_OF_CORNERS, "(face 4, counted from 0): it has 0"}},
      {"corner_two", {Status::SYNTAX_ERROR, "in the list corner, found \"2\""}},
      {"opposite_out_of_range", {Status::INDEX_OUT_OF_RANGE, "opposite is 24, and there are 24 halfedges"}},
      {"opposite_negative", {Status::INDEX_OUT_OF_RANGE, "in the list opposite, found \"-2\""}},
      {"opposite_itself", {Status::OPPOSITE_NOT_MUTUAL, "halfedge 14 has the opposite 14"}},
      {"opposite_not_mutual", {Status::OPPOSITE_NOT_MUTUAL, "(face 1, entry 2, "}},
      {"opposite_border", {Status::OPPOSITE_NOT_MUTUAL, "and that has -1"}},
      {"opposite_ends", {Status::OPPOSITE_ENDS_DIFFER, "(face 0, entry 0, "}},
      {"inconsistent_orientation",
       {Status::OPPOSITE_ENDS_DIFFER, "runs from vertex 2 to 3, its opposite 15 from 2 to 3"}},
      {"isolated_vertex", {Status::ISOLATED_VERTEX, "(vertex 8, "}},
      {"non_manifold_vertex", {Status::NON_MANIFOLD_VERTEX, "(vertex 7, "}},
      {"touching_faces", {Status::NON_MANIFOLD_VERTEX, "(vertex 2, "}},
      {"unequal_sides", {Status::UNEQUAL_SIDES, "(face 3, counted from 0): off by 0.25"}},
      {"cycle", {Status::CYCLE_CONDITION, "(vertex 0, counted from 0): off by -0.5"}}};
  return files;
}

} // namespace

TEMPLATE_TEST_CASE("a T-mesh file that is read and written is the same, byte by byte", "", Surface_mesh, Polyhedron,
                   Cell_complex)
{
  for (const auto& entry : std::filesystem::directory_iterator(good)) {
    T_mesh_with_maps<TestType> t;
    const T::T_mesh_reading_report report = t.read(entry.path().string());
    CAPTURE(entry.path(), describe(report));
    REQUIRE(report.success());
    CHECK(report.number_of_vertices == vertices_of(t.graph));
    CHECK(report.number_of_faces == faces_of(t.graph));
    CHECK(T::is_admissible(t.view()));
    CHECK(t.text() == file_content(entry.path().string()));
  }
}

TEMPLATE_TEST_CASE("links and frames are those of the file", "", Surface_mesh, Polyhedron, Cell_complex)
{
  T_mesh_with_maps<TestType> cube, torus, sphere, border;
  REQUIRE(cube.read(good + "t_joints.ply").success());
  REQUIRE(torus.read(good + "scaled_torus.ply").success());
  REQUIRE(sphere.read(good + "sphere_of_one_face.ply").success());
  REQUIRE(border.read(good + "border.ply").success());
  CHECK(valences(cube) == std::vector<int>{3, 3, 3, 3, 3, 3, 3, 3, 4, 4});
  CHECK(valences(torus) == std::vector<int>(8, 4));
  CHECK(valences(sphere) == std::vector<int>{1, 2, 1});
  CHECK(valences(border) == std::vector<int>{1, 1, 2, 4, 2, 1, 2, 1});

  // Each face begins at the origin of its frame, and is as wide and as high as the lists say.
  const T::T_mesh_coordinates coordinates(torus.view());
  std::vector<double> sizes;
  for (const auto f : CGAL::make_range(faces(torus.graph))) {
    CHECK(get(torus.corner_map(), prev(halfedge(f, torus.graph), torus.graph)));
    sizes.push_back(coordinates.width(f));
    sizes.push_back(coordinates.height(f));
  }
  CHECK(sizes == std::vector<double>{3, 1, 9, 3, 1.5, 0.5, 3, 1});

  // Border halfedges form closed curves.
  int number_of_border_halfedges = 0;
  for (const auto h : CGAL::make_range(halfedges(border.graph)))
    if (is_border(h, border.graph)) {
      ++number_of_border_halfedges;
      CHECK(is_border(next(h, border.graph), border.graph));
      CHECK(source(next(h, border.graph), border.graph) == target(h, border.graph));
      CHECK(prev(next(h, border.graph), border.graph) == h);
    }
  CHECK(number_of_border_halfedges == 7);
}

TEST_CASE("every bad T-mesh file is refused with its element, and the graph stays empty")
{
  for (const auto& entry : std::filesystem::directory_iterator(bad)) {
    CAPTURE(entry.path());
    const auto expected = bad_files().find(entry.path().stem().string());
    REQUIRE(expected != bad_files().end());
    T_mesh_with_maps<Surface_mesh> t;
    const T::T_mesh_reading_report report = t.read(entry.path().string());
    const std::string description = describe(report);
    CAPTURE(description);
    CHECK(report.status == expected->second.status);
    CHECK(description.find(message(report.status)) != std::string::npos);
    CHECK(description.find(expected->second.description) != std::string::npos);
    CHECK((t.graph.number_of_vertices() == 0 && t.graph.number_of_halfedges() == 0 && t.graph.number_of_faces() == 0));
    CHECK((t.knots.empty() && t.corners.empty()));
  }
  for (const auto& file : bad_files())
    CHECK(std::filesystem::exists(bad + file.first + ".ply"));
}

TEST_CASE("a file that is cut off anywhere is refused")
{
  const std::string content = file_content(good + "t_joints.ply");
  for (std::size_t length = 0; length + 2 < content.size(); ++length) { // without its last line feed it is complete
    T_mesh_with_maps<Surface_mesh> t;
    std::istringstream in(content.substr(0, length));
    const T::T_mesh_reading_report report = T::read_t_mesh(in, t.view());
    CAPTURE(length, describe(report));
    CHECK_FALSE(report.success());
    CHECK(t.graph.number_of_vertices() == 0);
  }
}

TEST_CASE("no file, a directory, a stream that failed")
{
  T_mesh_with_maps<Surface_mesh> t;
  CHECK(t.read(good + "no_such_file.ply").status == Status::CANNOT_OPEN);
  CHECK(t.read(good).status == Status::CANNOT_OPEN);
  std::istringstream in("ply\n");
  in.setstate(std::ios::failbit);
  CHECK(T::read_t_mesh(in, t.view()).status == Status::CANNOT_OPEN);
}

TEST_CASE("other names of the types, comments and other ends of lines are accepted")
{
  std::string content = file_content(good + "cube.ply");
  const auto replace = [&content](const std::string& from, const std::string& to) {
    for (std::size_t i = content.find(from); i != std::string::npos; i = content.find(from, i + to.size()))
      content.replace(i, from.size(), to);
  };
  replace("double", "float64");
  replace("list int", "list uint8");
  replace("uchar", "uint8");
  replace("element face", "obj_info none\ncomment by hand\nelement face");
  replace("\n", "\r\n");
  T_mesh_with_maps<Surface_mesh> t;
  std::istringstream in(content);
  const auto np = T::parameters::vertex_weight_map(t.weight_map());
  REQUIRE(T::read_t_mesh(in, t.view(), np).success());
  CHECK(t.text() == file_content(good + "cube.ply"));
}

TEST_CASE("the tolerance of the knots is the caller's")
{
  std::string content = file_content(good + "cube.ply");
  const std::string knots = " 4 1 1 1 1 ";
  content.replace(content.find(knots), knots.size(), " 4 1 1 1.000001 1 ");
  for (const double tolerance : {1e-9, 1e-5}) {
    T_mesh_with_maps<Surface_mesh> t;
    std::istringstream in(content);
    const auto np = T::parameters::relative_tolerance(tolerance);
    CHECK(T::read_t_mesh(in, t.view(), np).success() == (tolerance > 1e-6));
  }
}

TEST_CASE("knots are read into exact numbers as they stand")
{
  T_mesh_with_maps<Surface_mesh, CGAL::Exact_rational> t;
  REQUIRE(t.read(good + "scaled_torus.ply").success());
  CHECK(T::is_admissible(t.view()));
  CHECK(t.text() == file_content(good + "scaled_torus.ply"));
}
