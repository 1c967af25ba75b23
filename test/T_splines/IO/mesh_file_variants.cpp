// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs write in the four formats, apart from the plain files in data/good_meshes.

#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mesh_file_variants_test {

namespace {

namespace T = CGAL::T_splines;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Status = T::Mesh_reading_status;

const std::vector<Point_3> tetrahedron = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)};

std::string content_of(const std::string& name)
{
  std::ifstream file(std::string(T_SPLINES_TEST_DATA "/good_meshes/") + name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// Reads a file with a content.
T::Mesh_reading_report read(const std::string& extension, const std::string& content, Mesh& mesh)
{
  const Temporary_directory directory;
  const std::string name = directory.file("mesh" + extension);
  std::ofstream(name, std::ios::binary) << content;
  return T::read_triangle_mesh(name, mesh);
}

/// Checks that a content is read as the tetrahedron. \return what was changed, in words.
std::string check_tetrahedron(const std::string& extension, const std::string& content)
{
  Mesh mesh;
  const T::Mesh_reading_report report = read(extension, content, mesh);
  CAPTURE(extension, content, describe(report));
  CHECK(report.success());
  CHECK(CGAL::is_closed(mesh));
  CHECK(num_faces(mesh) == 4);
  std::vector<Point_3> points, expected = tetrahedron;
  for (const auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  if (extension == ".stl") { // facets define the order of the vertices there
    std::sort(points.begin(), points.end());
    std::sort(expected.begin(), expected.end());
  }
  CHECK(points == expected);
  if (report.success())
    CHECK(CGAL::Polygon_mesh_processing::volume(mesh) == Approx(1. / 6));
  return note(report);
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + to.size()))
    text.replace(i, from.size(), to);
  return text;
}

std::string in_capitals(std::string text)
{
  for (char& c : text)
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

const std::string off_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string off_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

} // namespace

TEST_CASE("texts with a byte order mark, with any line ends, and without an end of the last line")
{
  for (const char* name : {"tetrahedron.off", "tetrahedron.obj", "tetrahedron.ply", "tetrahedron.stl"}) {
    const std::string text = replaced(content_of(name), "\r\n", "\n"), extension = std::string(name).substr(11);
    REQUIRE(text.size() > 50);
    for (const std::string& content : {"\xEF\xBB\xBF" + text, replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"),
                                       text.substr(0, text.size() - 1), text + "\n \n", replaced(text, "\n", " \t\n")})
      check_tetrahedron(extension, content);
    Mesh mesh;
    const T::Mesh_reading_report report = read(extension, "\xFF\xFE" + text, mesh);
    CHECK(report.status == Status::UNSUPPORTED_VARIANT);
    CHECK(report.text == "UTF-16");
  }
}

TEST_CASE("binary PLY files with any line ends in the header")
{
  for (const char* name : {"tetrahedron_little.ply", "tetrahedron_big.ply"}) {
    const std::string content = content_of(name);
    const std::size_t end = content.find("end_header\n") + 11;
    for (const char* line_end : {"\n", "\r\n", "\r"})
      check_tetrahedron(".ply", replaced(content.substr(0, end), "\n", line_end) + content.substr(end));
  }
}

TEST_CASE("keywords in capitals")
{
  check_tetrahedron(".stl", in_capitals(content_of("tetrahedron.stl")));
  check_tetrahedron(".obj", in_capitals(content_of("tetrahedron.obj")));
  check_tetrahedron(".off", "off\n4 4 6\n" + off_points + off_faces);
}

TEST_CASE("OFF records over several lines, and several on a line")
{
  const std::string counts = "OFF\n4 4 6\n";
  check_tetrahedron(".off", counts + off_points + replaced(off_faces, " ", "\n"));
  check_tetrahedron(".off", counts + replaced(off_points, " ", "\n") + replaced(off_faces, " ", " # why not\n\n"));
  check_tetrahedron(".off", replaced(counts + off_points + off_faces, "\n", " "));
  check_tetrahedron(".off", replaced(counts + off_points + off_faces, " ", "\n"));
  check_tetrahedron(".off", "OFF\n4 4 6\n" + replaced(off_points, "\n", " ") + "\n" + replaced(off_faces, "\n", " "));
  check_tetrahedron(".off", "OFF 4 4\n" + off_points + off_faces);
  check_tetrahedron(".off", "OFF4 4 0\n" + off_points + off_faces);
  check_tetrahedron(".off", "# a comment\nOFF # another\n\n4 4 6 # counts\n" + off_points + "# faces\n" + off_faces);
}

TEST_CASE("OFF with colours, normals and texture coordinates")
{
  const auto with = [](const std::string& keyword, const std::string& more, const std::string& colour) {
    return keyword + "\n4 4 6\n" + replaced(off_points, "\n", " " + more + "\n") +
           replaced(off_faces, "\n", " " + colour + "\n");
  };
  for (const char* colour : {"", "7", "255 0 0", "0.5 0.25 0 1", "255 0 0 255"}) {
    check_tetrahedron(".off", with("OFF", "", colour));
    check_tetrahedron(".off", with("OFF", "255 0 0", colour)); // MeshLab does so
    check_tetrahedron(".off", with("COFF", "255 0 0 255", colour));
    check_tetrahedron(".off", with("NOFF", "0 0 1", colour));
    check_tetrahedron(".off", with("STOFF", "0.5 0.5", colour));
    check_tetrahedron(".off", with("CNOFF", "1 0 0 1 0 0 1", colour));
  }
  check_tetrahedron(".off", replaced(with("NOFF", "0 0 1", ""), "\n", " "));
  check_tetrahedron(".off", replaced(with("STCNOFF", "0 0 1 1 1 1 1 1 1", ""), " ", "\n"));
}

TEST_CASE("an OFF record that is too short is not completed from the next line")
{
  Mesh mesh;
  T::Mesh_reading_report report =
      read(".off", "OFF\n4 4 6\n" + off_points + "3 0 2 1\n3 0 1\n3 1 2 3\n3 0 3 2\n", mesh);
  CHECK(report.status == Status::SYNTAX_ERROR);
  CHECK(report.line == 8);
  CHECK(report.face == 1);
  report = read(".off", "OFF\n4 4 6\n0 0 0\n1 0\n0 1 0\n0 0 1\n" + off_faces, mesh);
  CHECK(report.status == Status::SYNTAX_ERROR);
  CHECK(report.line == 4);
  CHECK(report.vertex == 1);
}

TEST_CASE("OBJ with relative indices, normals, colours, other statements and continued lines")
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  check_tetrahedron(".obj", points + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n");
  check_tetrahedron(".obj", points + "vn 0 0 1\nf 1//1 3//1 2//1\nf 1//1 2//-1 4//1\nf 2//1 3//1 4//1\nf 1 4 3\n");
  check_tetrahedron(".obj", points + "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\nf 1/1 2/-1 4/1\nf 2/1/ 3 4\nf 1 4 3\n");
  check_tetrahedron(".obj", replaced(points, "\n", " 1 0.5 0\n") + faces);
  check_tetrahedron(".obj", replaced(points, "\n", " 1.0\n") + faces);
  check_tetrahedron(".obj", faces + points);
  check_tetrahedron(".obj", "mtllib a b.mtl\no thing\ng a b\n" + points + "usemtl x\ns off\nl 1 2\np 1\n" + faces);
  check_tetrahedron(".obj", replaced(points + faces, " ", " \\\n"));
  check_tetrahedron(".obj", replaced(points, " 0\n", " \\\r\n 0\n") + replaced(faces, " 3", " \\\n3"));
  check_tetrahedron(".obj", replaced(points + faces, "1 ", "1\\\n"));
}

TEST_CASE("ASCII STL with several solids, names, any normals, any lines")
{
  const std::string text = content_of("tetrahedron.stl");
  check_tetrahedron(".stl", replaced(text, "normal 0 0 0", "normal nan -nan(ind) 1,5"));
  check_tetrahedron(".stl",
                    replaced(text, "endfacet\nfacet", "endfacet\nendsolid part of it\nSolid facet normal\nfacet"));
  const std::size_t name_end = text.find('\n') + 1, end = text.rfind("endsolid");
  check_tetrahedron(".stl", text.substr(0, name_end) + replaced(text.substr(name_end, end - name_end), "\n", " ") +
                                "\nendsolid");
  check_tetrahedron(".stl", replaced(text, " ", "\t \t"));
}

TEST_CASE("bytes behind the facets of a binary STL file are passed over, and that is said")
{
  const std::string content = content_of("tetrahedron_binary.stl");
  const std::string note = check_tetrahedron(".stl", content + std::string(7, '\0'));
  CHECK(note.find("7 bytes behind the last facet were not read") != std::string::npos);
  CHECK(check_tetrahedron(".stl", content).find("bytes") == std::string::npos);
  std::string solid = content;
  solid.replace(0, 11, "solid thing");
  check_tetrahedron(".stl", solid);
  check_tetrahedron(".stl", solid + "endsolid");
  Mesh mesh;
  CHECK(read(".stl", solid.substr(0, solid.size() - 1), mesh).status == Status::TRUNCATED);
  CHECK(read(".stl", std::string(200, 'x'), mesh).status == Status::SYNTAX_ERROR);
}

namespace {

/// The bytes of a number, in either order.
template <typename Number>
void append(std::string& bytes, const Number number, const bool is_big)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  const std::uint16_t one = 1;
  char first = 0;
  std::memcpy(&first, &one, 1);
  if (is_big == (first == 1))
    std::reverse(raw, raw + sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

/// The tetrahedron as a binary PLY file with other elements and properties, and with these types of a list.
template <typename Size, typename Index>
std::string binary_ply(const std::string& types, const bool is_big)
{
  std::string bytes = "ply\nformat binary_" + std::string(is_big ? "big" : "little") +
                      "_endian 1.0\ncomment x\nobj_info y\nelement material 2\nproperty list uchar float weights\n"
                      "element vertex 4\nproperty uchar red\nproperty double z\nproperty float x\nproperty short y\n"
                      "element face 4\nproperty list uint8 float64 texcoord\nproperty list " +
                      types + " vertex_index\nproperty int flags\nelement edge 1\nproperty uint vertex1\nend_header\n";
  for (const std::uint8_t n : {std::uint8_t(0), std::uint8_t(2)}) {
    append(bytes, n, is_big);
    for (int i = 0; i < n; ++i)
      append(bytes, 0.5f, is_big);
  }
  for (const Point_3& p : tetrahedron) {
    append(bytes, std::uint8_t(7), is_big);
    append(bytes, p.z(), is_big);
    append(bytes, static_cast<float>(p.x()), is_big);
    append(bytes, static_cast<std::int16_t>(p.y()), is_big);
  }
  for (const auto& face : {std::vector<int>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    append(bytes, std::uint8_t(1), is_big);
    append(bytes, 0.25, is_big);
    append(bytes, static_cast<Size>(face.size()), is_big);
    for (const int v : face)
      append(bytes, static_cast<Index>(v), is_big);
    append(bytes, std::int32_t(-1), is_big);
  }
  append(bytes, std::uint32_t(3), is_big);
  return bytes;
}

} // namespace

TEST_CASE("binary PLY with other elements and properties, and lists of all types")
{
  for (const bool is_big : {false, true}) {
    check_tetrahedron(".ply", binary_ply<std::uint8_t, std::int32_t>("uchar int", is_big));
    check_tetrahedron(".ply", binary_ply<std::int8_t, std::uint8_t>("int8 uint8", is_big));
    check_tetrahedron(".ply", binary_ply<std::uint16_t, std::int16_t>("ushort short", is_big));
    check_tetrahedron(".ply", binary_ply<std::int32_t, std::uint32_t>("int uint32", is_big));
    check_tetrahedron(".ply", binary_ply<float, double>("float double", is_big));
  }
}

TEST_CASE("ASCII PLY rows over several lines")
{
  const std::string text = content_of("tetrahedron.ply");
  const std::size_t end = text.find("end_header\n") + 11;
  check_tetrahedron(".ply", text.substr(0, end) + replaced(text.substr(end), " ", "\n"));
  Mesh mesh;
  const T::Mesh_reading_report report =
      read(".ply", text.substr(0, end) + replaced(text.substr(end), "3 0 1 3\n", "3 0 1\n"), mesh);
  CHECK(report.status == Status::SYNTAX_ERROR);
  CHECK(report.face == 1);
}

TEST_CASE("polygons of any size in all indexed formats")
{
  const std::string off = content_of("prism.off");
  std::istringstream in(off.substr(off.find('\n')));
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> vertices >> faces >> edges;
  std::ostringstream obj, points, lists;
  for (std::size_t i = 0; i < vertices; ++i) {
    double x, y, z;
    in >> x >> y >> z;
    points << x << " " << y << " " << z << "\n";
    obj << "v " << x << " " << y << " " << z << "\n";
  }
  for (std::size_t f = 0; f < faces; ++f) {
    std::size_t n = 0, v = 0;
    in >> n;
    obj << "f";
    lists << n;
    for (std::size_t i = 0; i < n; ++i) {
      in >> v;
      obj << " " << v + 1;
      lists << " " << v;
    }
    obj << "\n";
    lists << "\n";
  }
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
                          "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                          std::to_string(faces) + "\nproperty list uchar uint vertex_indices\nend_header\n" +
                          points.str() + lists.str();
  for (const auto& [extension, content] :
       {std::pair(".off", off), std::pair(".obj", obj.str()), std::pair(".ply", ply)}) {
    Mesh mesh;
    const T::Mesh_reading_report report = read(extension, content, mesh);
    CAPTURE(extension, describe(report));
    REQUIRE(report.success());
    CHECK(report.number_of_triangulated_faces == 8);
    CHECK(CGAL::Polygon_mesh_processing::volume(mesh) == Approx(3));
  }
}

} // namespace mesh_file_variants_test
