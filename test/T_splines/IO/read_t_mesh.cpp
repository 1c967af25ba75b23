// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "T_mesh_with_maps.h"
#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>

#include <CGAL/Exact_rational.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace read_t_mesh_test {

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
      {"binary", {Status::INDEX_OUT_OF_RANGE, "(face 0"}},
      {"format", {Status::UNSUPPORTED_VARIANT, "line 2: "}},
      {"polygon_mesh", {Status::SYNTAX_ERROR, "\"property double w\" is needed in the element vertex"}},
      {"missing_weights", {Status::SYNTAX_ERROR, "\"property double w\" is needed in the element vertex"}},
      {"missing_knots",
       {Status::SYNTAX_ERROR, "\"property list uchar double halfedge_knots\" is needed in the element face"}},
      {"missing_opposite",
       {Status::SYNTAX_ERROR, "\"property list uchar int opposite\" is needed in the element face"}},
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
      {"fewer_creases", {Status::LIST_LENGTHS_DIFFER, "(face 3, counted from 0): crease has 3 entries"}},
      {"crease_two", {Status::SYNTAX_ERROR, "(face 3, entry 2, counted from 0): in the list crease, found \"2\""}},
      {"crease_not_mutual",
       {Status::CREASE_NOT_MUTUAL, "(face 3, entry 0, counted from 0): halfedge 12 is a crease, and its opposite 18"}},
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
    CHECK(T::check_admissibility(t.view()));
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
    CHECK((t.knots.empty() && t.corners.empty() && t.creases.empty()));
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

TEMPLATE_TEST_CASE("edges are creases where the file says so, but not on the border", "", Surface_mesh, Polyhedron,
                   Cell_complex)
{
  T_mesh_with_maps<TestType> cube;
  REQUIRE(cube.read(good + "creases.ply").success());
  CHECK(cube.creases.size() == 12);
  int number = 0;
  for (const auto& [e, is_crease] : cube.creases)
    number += is_crease;
  CHECK(number == 4);

  std::string content = file_content(good + "border.ply");
  const auto insert = [&content](const std::string& after, const std::string& what) {
    const std::size_t at = content.find(after);
    REQUIRE(at != std::string::npos);
    content.insert(at + after.size(), what);
  };
  insert("property list uchar int opposite\n", "property list uchar uchar crease\n");
  insert("5 -1 -1 9 5 -1", " 5 1 1 0 0 0");
  insert("4 3 12 -1 -1", " 4 0 0 1 1");
  insert("4 2 -1 -1 6", " 4 0 0 0 0");
  T_mesh_with_maps<TestType> border;
  std::istringstream in(content);
  const auto np = T::parameters::vertex_weight_map(border.weight_map());
  REQUIRE(T::read_t_mesh(in, border.view(), np).success());
  for (const auto& [e, is_crease] : border.creases)
    CHECK_FALSE(is_crease);
  CHECK(border.text() == file_content(good + "border.ply"));
}

TEST_CASE("creases of a file are lost where there is no map of them")
{
  T_mesh_with_maps<Surface_mesh> t;
  const T::T_mesh_view view(t.graph, t.knot_map(), t.corner_map());
  REQUIRE(T::read_t_mesh(good + "creases.ply", view).success());
  std::ostringstream out;
  REQUIRE_FALSE(T::write_t_mesh(out, view));
  CHECK(out.str().find("crease") == std::string::npos);
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
  replace("list uchar", "list int32");
  replace("uchar", "uint8");
  replace("element face", "obj_info none\ncomment by hand\nelement face");
  replace("\n", "\r\n");
  T_mesh_with_maps<Surface_mesh> t;
  std::istringstream in(content);
  const auto np = T::parameters::vertex_weight_map(t.weight_map());
  REQUIRE(T::read_t_mesh(in, t.view(), np).success());
  CHECK(t.text() == file_content(good + "cube.ply"));
}

namespace {

/// A file as another program might write it: the properties in another order, more of them, other elements.
class Rewritten_file {
public:
  enum class Format { TEXT, LITTLE, BIG };

  Rewritten_file(const std::string& content, const Format format) : m_format(format)
  {
    std::istringstream in(content);
    std::string line, word;
    std::size_t vertices = 0, faces = 0;
    const bool has_creases = content.find(" crease\n") != std::string::npos;
    while (std::getline(in, line) && line != "end_header") {
      std::istringstream words(line);
      words >> word;
      if (word == "element")
        words >> word >> (word == "vertex" ? vertices : faces);
    }
    const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    m_out << "ply\nformat " << names[static_cast<int>(format)] << " 1.0\nelement material 2\nproperty uchar shade\n"
          << "element vertex " << vertices << "\nproperty double w\nproperty uchar red\nproperty double z\n"
          << "property double x\nproperty double y\nproperty list uchar short tags\nelement face " << faces
          << "\nproperty list ushort short opposite\nproperty float area\nproperty list uchar double halfedge_knots\n"
          << "property list uint uint vertex_index\nproperty list uchar short other\nproperty list uchar int corner\n"
          << (has_creases ? "property list ushort float crease\n" : "")
          << "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    for (int i = 0; i < 2; ++i) {
      put<unsigned char>(i);
      end_row();
    }
    for (std::size_t v = 0; v < vertices; ++v) {
      double x, y, z, w;
      in >> x >> y >> z >> w;
      put<double>(w);
      put<unsigned char>(255);
      put<double>(z);
      put<double>(x);
      put<double>(y);
      put_list<unsigned char, short>({1, -2, 3});
      end_row();
    }
    for (std::size_t f = 0; f < faces; ++f) {
      const std::vector<double> indices = list(in), knots = list(in), corners = list(in), opposites = list(in);
      put_list<unsigned short, short>(opposites);
      put<float>(0.5);
      put_list<unsigned char, double>(knots);
      put_list<unsigned int, unsigned int>(indices);
      put_list<unsigned char, short>({});
      put_list<unsigned char, int>(corners);
      if (has_creases)
        put_list<unsigned short, float>(list(in));
      end_row();
    }
    put<int>(0);
    put<int>(1);
    end_row();
  }

  std::string content() const { return m_out.str(); }

private:
  static std::vector<double> list(std::istream& in)
  {
    std::size_t n = 0;
    in >> n;
    std::vector<double> result(n);
    for (double& x : result)
      in >> x;
    return result;
  }

  template <typename Number>
  void put(const double value)
  {
    if (m_format == Format::TEXT) {
      m_out.precision(17);
      m_out << (m_is_row_empty ? "" : " ") << value;
    }
    else {
      const Number number = static_cast<Number>(value);
      std::array<char, sizeof(Number)> bytes;
      std::memcpy(bytes.data(), &number, sizeof(Number));
      const unsigned short one = 1;
      const bool is_little = *reinterpret_cast<const unsigned char*>(&one) == 1;
      if (is_little != (m_format == Format::LITTLE))
        std::reverse(bytes.begin(), bytes.end());
      m_out.write(bytes.data(), sizeof(Number));
    }
    m_is_row_empty = false;
  }

  template <typename Size, typename Number>
  void put_list(const std::vector<double>& values)
  {
    put<Size>(static_cast<double>(values.size()));
    for (const double value : values)
      put<Number>(value);
  }

  void end_row()
  {
    if (m_format == Format::TEXT)
      m_out << "\n";
    m_is_row_empty = true;
  }

  Format m_format;
  std::ostringstream m_out;
  bool m_is_row_empty = true;
};

} // namespace

TEST_CASE("files that another program has rewritten are the same T-meshes, in text and binary")
{
  using Format = Rewritten_file::Format;
  for (const auto& entry : std::filesystem::directory_iterator(good)) {
    const std::string content = file_content(entry.path().string());
    for (const Format format : {Format::TEXT, Format::LITTLE, Format::BIG}) {
      CAPTURE(entry.path(), static_cast<int>(format));
      const std::string rewritten = Rewritten_file(content, format).content();
      T_mesh_with_maps<Surface_mesh> t;
      std::istringstream in(rewritten);
      const T::T_mesh_reading_report report =
          T::read_t_mesh(in, t.view(), T::parameters::vertex_weight_map(t.weight_map()));
      CAPTURE(describe(report));
      REQUIRE(report.success());
      CHECK(t.text() == content);
    }
  }
}

TEST_CASE("rewritten files that are cut off anywhere are refused")
{
  using Format = Rewritten_file::Format;
  for (const Format format : {Format::TEXT, Format::BIG}) {
    const std::string content = Rewritten_file(file_content(good + "cube.ply"), format).content();
    for (std::size_t length = 0; length + 2 < content.size(); ++length) {
      T_mesh_with_maps<Surface_mesh> t;
      std::istringstream in(content.substr(0, length));
      CAPTURE(length);
      CHECK_FALSE(T::read_t_mesh(in, t.view()).success());
      CHECK(t.graph.number_of_vertices() == 0);
    }
    T_mesh_with_maps<Surface_mesh> t;
    std::istringstream in(content + "1 2");
    CHECK(T::read_t_mesh(in, t.view()).status == Status::SYNTAX_ERROR);
  }
}

TEST_CASE("lengths of lists are written in one byte where that suffices")
{
  for (const int length : {255, 256}) {
    // One rectangle, with T-joints along its bottom.
    const int segments = length - 3;
    std::ostringstream content;
    const char* list = length < 256 ? "property list uchar " : "property list int ";
    content << "ply\nformat ascii 1.0\ncomment T-mesh with halfedge knots\nelement vertex " << length
            << "\nproperty double x\nproperty double y\nproperty double z\nproperty double w\nelement face 1\n"
            << list << "int vertex_indices\n"
            << list << "double halfedge_knots\n"
            << list << "uchar corner\n"
            << list << "int opposite\nend_header\n";
    for (int i = 0; i <= segments; ++i)
      content << i << " 0 0 1\n";
    content << segments << " 1 0 1\n0 1 0 1\n" << length;
    for (int i = 0; i < length; ++i)
      content << " " << i;
    content << " " << length;
    for (int i = 0; i < length; ++i)
      content << " " << (i == segments + 1 ? segments : 1);
    content << " " << length;
    for (int i = 0; i < length; ++i)
      content << (i == 0 || i >= segments ? " 1" : " 0");
    content << " " << length;
    for (int i = 0; i < length; ++i)
      content << " -1";
    content << "\n";
    T_mesh_with_maps<Surface_mesh> t;
    std::istringstream in(content.str());
    const auto np = T::parameters::vertex_weight_map(t.weight_map());
    const T::T_mesh_reading_report report = T::read_t_mesh(in, t.view(), np);
    CAPTURE(describe(report));
    REQUIRE(report.success());
    CHECK(t.text() == content.str());
  }
}

TEST_CASE("a T-mesh that is not empty is refused, and left as it was")
{
  T_mesh_with_maps<Surface_mesh> t;
  REQUIRE(t.read(good + "cube.ply").success());
  const std::string text = t.text();
  const T::T_mesh_reading_report report = t.read(good + "border.ply");
  CHECK(report.status == Status::OUTPUT_NOT_EMPTY);
  CHECK(describe(report) == message(report.status));
  CHECK(t.text() == text);
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
  CHECK(T::check_admissibility(t.view()));
  CHECK(t.text() == file_content(good + "scaled_torus.ply"));
}

} // namespace read_t_mesh_test
