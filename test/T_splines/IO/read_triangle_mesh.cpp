// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace read_triangle_mesh_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Status = T::Mesh_reading_status;

constexpr std::size_t none = T::Mesh_reading_report::none;

std::string data_file(const std::string& name)
{
  return std::string(T_SPLINES_TEST_DATA "/") + name;
}

/// A file and what the reader has to say of it.
struct Bad_file {
  const char* name;
  Status status;
  std::size_t line, vertex, face;
};

const std::vector<Bad_file>& bad_files()
{
  static const std::vector<Bad_file> files = {{"empty.off", Status::EMPTY, none, none, none},
                                              {"no_faces.off", Status::EMPTY, none, none, none},
                                              {"no_faces.obj", Status::EMPTY, none, none, none},
                                              {"no_faces.ply", Status::SYNTAX_ERROR, 7, none, none},
                                              {"truncated_vertices.off", Status::TRUNCATED, 5, 2, none},
                                              {"truncated_faces.off", Status::TRUNCATED, 9, none, none},
                                              {"truncated_face.off", Status::TRUNCATED, 10, none, 3},
                                              {"truncated_header.ply", Status::TRUNCATED, 1, none, none},
                                              {"truncated.ply", Status::TRUNCATED, none, none, 3},
                                              {"truncated_ascii.ply", Status::TRUNCATED, 16, none, 1},
                                              {"truncated.stl", Status::TRUNCATED, 5, none, 0},
                                              {"truncated_binary.stl", Status::TRUNCATED, none, none, none},
                                              {"too_many_faces.off", Status::SYNTAX_ERROR, 10, none, none},
                                              {"trailing_data.ply", Status::SYNTAX_ERROR, none, none, none},
                                              {"not_off.off", Status::SYNTAX_ERROR, 1, none, none},
                                              {"word.off", Status::SYNTAX_ERROR, 4, 1, none},
                                              {"junk.obj", Status::SYNTAX_ERROR, 2, none, none},
                                              {"keyword.stl", Status::SYNTAX_ERROR, 5, none, 0},
                                              {"binary.off", Status::UNSUPPORTED_VARIANT, 1, none, none},
                                              {"four.off", Status::UNSUPPORTED_VARIANT, 1, none, none},
                                              {"unknown_encoding.ply", Status::UNSUPPORTED_VARIANT, 2, none, none},
                                              {"nan.off", Status::NON_FINITE_COORDINATE, 5, 2, none},
                                              {"nan.ply", Status::NON_FINITE_COORDINATE, none, 2, none},
                                              {"nan.stl", Status::NON_FINITE_COORDINATE, none, none, 1},
                                              {"infinity.off", Status::NON_FINITE_COORDINATE, 6, 3, none},
                                              {"overflow.obj", Status::NON_FINITE_COORDINATE, 2, 1, none},
                                              {"index.off", Status::INDEX_OUT_OF_RANGE, 8, none, 1},
                                              {"negative_index.off", Status::INDEX_OUT_OF_RANGE, 8, none, 1},
                                              {"index.obj", Status::INDEX_OUT_OF_RANGE, 7, none, 2},
                                              {"zero_index.obj", Status::INDEX_OUT_OF_RANGE, 6, none, 1},
                                              {"negative_index.obj", Status::INDEX_OUT_OF_RANGE, 6, none, 1},
                                              {"uv_index.obj", Status::INDEX_OUT_OF_RANGE, 6, none, 0},
                                              {"index.ply", Status::INDEX_OUT_OF_RANGE, none, none, 3},
                                              {"negative_index.ply", Status::INDEX_OUT_OF_RANGE, 18, none, 3},
                                              {"two_corners.off", Status::TOO_FEW_CORNERS, 8, none, 1},
                                              {"repeated_vertex.off", Status::REPEATED_VERTEX, 8, 1, 1},
                                              {"duplicate_face.off", Status::DUPLICATE_FACE, 11, none, 4},
                                              {"non_manifold_edge.off", Status::NON_MANIFOLD_EDGE, 9, 1, 0},
                                              {"inconsistent.off", Status::INCONSISTENT_ORIENTATION, 7, 2, 0},
                                              {"projective_plane.off", Status::NON_ORIENTABLE, 16, 5, 7},
                                              {"non_manifold_vertex.off", Status::NON_MANIFOLD_VERTEX, 3, 0, 7},
                                              {"isolated_vertex.off", Status::ISOLATED_VERTEX, 7, 4, none},
                                              {"zero_length_edge.off", Status::ZERO_LENGTH_EDGE, 12, 4, 4},
                                              {"collinear.off", Status::ZERO_AREA_TRIANGLE, 13, none, 5}};
  return files;
}

template <typename Mesh>
std::vector<Point_3> points_in_order(const Mesh& mesh)
{
  std::vector<Point_3> points;
  for (const auto v : CGAL::make_range(vertices(mesh)))
    points.push_back(get(CGAL::get_const_property_map(CGAL::vertex_point, mesh), v));
  return points;
}

/// A face as the cycle of its corners, begun with the least one.
template <typename Mesh>
std::vector<std::array<Point_3, 3>> faces_in_order(const Mesh& mesh)
{
  std::vector<std::array<Point_3, 3>> result;
  for (const auto f : CGAL::make_range(faces(mesh))) {
    std::array<Point_3, 3> corners;
    std::size_t i = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners[i++] = get(CGAL::get_const_property_map(CGAL::vertex_point, mesh), v);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.push_back(corners);
  }
  return result;
}

const std::vector<Point_3> tetrahedron = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)};
const std::vector<std::array<std::size_t, 3>> tetrahedron_faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

} // namespace

TEST_CASE("every bad file is refused with its reason and its place")
{
  std::set<std::string> known;
  for (const Bad_file& file : bad_files()) {
    known.insert(file.name);
    CAPTURE(file.name);
    Surface_mesh mesh;
    const T::Mesh_reading_report report =
        T::read_triangle_mesh(data_file(std::string("bad_meshes/") + file.name), mesh);
    CAPTURE(describe(report));
    CHECK(report.status == file.status);
    CHECK(report.line == file.line);
    CHECK(report.vertex == file.vertex);
    CHECK(report.face == file.face);
    CHECK(num_vertices(mesh) == 0);
    CHECK(describe(report).find(message(report.status)) != std::string::npos);
  }
  for (const auto& entry : std::filesystem::directory_iterator(data_file("bad_meshes")))
    CHECK(known.count(entry.path().filename().string()) == 1);
}

TEST_CASE("a file that ends anywhere before its end is refused")
{
  const Temporary_directory directory;
  for (const auto& entry : std::filesystem::directory_iterator(data_file("good_meshes"))) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string content(std::istreambuf_iterator<char>(file), {});
    const std::string name = directory.file(entry.path().filename().string());
    for (std::size_t length = 0; length < content.size(); ++length) {
      std::ofstream(name, std::ios::binary) << content.substr(0, length);
      Surface_mesh mesh;
      const T::Mesh_reading_report report = T::read_triangle_mesh(name, mesh, T::parameters::border_is_allowed(false));
      // What may be missing is the end of the last line, and the name of the solid in an STL file.
      if (report.success() && content.find_first_not_of(" t\r\n", length) != std::string::npos)
        FAIL(entry.path() << " is accepted with a length of " << length);
    }
  }
}

TEST_CASE("a file with any byte changed is accepted or refused, and nothing worse")
{
  const Temporary_directory directory;
  for (const auto& entry : std::filesystem::directory_iterator(data_file("good_meshes"))) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string content(std::istreambuf_iterator<char>(file), {});
    const std::string name = directory.file(entry.path().filename().string());
    for (std::size_t i = 0; i < content.size(); ++i)
      for (const char c : {'\0', '9', '-', '\n', '\xff'}) {
        std::string changed = content;
        changed[i] = c;
        std::ofstream(name, std::ios::binary) << changed;
        Surface_mesh mesh;
        const T::Mesh_reading_report report = T::read_triangle_mesh(name, mesh);
        const bool is_as_told = report.success() ? CGAL::is_closed(mesh) == (report.number_of_boundary_edges == 0) &&
                                                       CGAL::is_valid_polygon_mesh(mesh)
                                                 : num_vertices(mesh) == 0;
        if (!is_as_told)
          FAIL(entry.path() << " with byte " << i << " changed to " << static_cast<int>(c) << ": " << describe(report));
      }
  }
}

TEST_CASE("what is not a mesh file is refused")
{
  Surface_mesh mesh;
  CHECK(T::read_triangle_mesh(data_file("no_such_file.off"), mesh).status == Status::CANNOT_OPEN);
  CHECK(T::read_triangle_mesh(data_file("no_such_file.xyz"), mesh).status == Status::UNKNOWN_FORMAT);
  CHECK(T::read_triangle_mesh(data_file("good_meshes"), mesh).status == Status::UNKNOWN_FORMAT);
  const Temporary_directory directory;
  std::filesystem::create_directory(directory.file("directory.off"));
  CHECK(T::read_triangle_mesh(directory.file("directory.off"), mesh).status == Status::CANNOT_OPEN);
}

TEMPLATE_TEST_CASE("the formats give the same mesh in the order of the file", "", Surface_mesh, Polyhedron)
{
  for (const char* name : {"tetrahedron.off", "tetrahedron.obj", "tetrahedron.ply", "tetrahedron_little.ply",
                           "tetrahedron_big.ply", "tetrahedron.stl", "tetrahedron_binary.stl"}) {
    CAPTURE(name);
    TestType mesh;
    const T::Mesh_reading_report report = T::read_triangle_mesh(data_file(std::string("good_meshes/") + name), mesh);
    CAPTURE(describe(report));
    REQUIRE(report.success());
    CHECK(CGAL::is_closed(mesh));
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    const bool is_stl = std::string(name).find(".stl") != std::string::npos;
    CHECK(report.number_of_merged_points == (is_stl ? 8 : 0));
    CHECK(note(report).empty() == !is_stl);
    if (!is_stl) // facets define the order of the vertices there
      CHECK(points_in_order(mesh) == tetrahedron);
    const std::vector<std::array<Point_3, 3>> faces = faces_in_order(mesh);
    REQUIRE(faces.size() == 4);
    for (std::size_t f = 0; f < 4; ++f) {
      std::array<Point_3, 3> expected;
      for (std::size_t i = 0; i < 3; ++i)
        expected[i] = tetrahedron[tetrahedron_faces[f][i]];
      std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
      CHECK(faces[f] == expected);
    }
  }
}

TEST_CASE("several components are accepted")
{
  Surface_mesh mesh;
  REQUIRE(T::read_triangle_mesh(data_file("good_meshes/two_tetrahedra.off"), mesh).success());
  CHECK(num_vertices(mesh) == 8);
  CHECK(num_faces(mesh) == 8);
}

TEST_CASE("other polygons are triangulated, with a note")
{
  Surface_mesh cube, prism;
  const T::Mesh_reading_report report = T::read_triangle_mesh(data_file("good_meshes/cube.obj"), cube);
  REQUIRE(report.success());
  CHECK(report.number_of_triangulated_faces == 6);
  CHECK(note(report).find("6 of 6 faces") == 0);
  CHECK(num_faces(cube) == 12);
  CHECK(CGAL::Polygon_mesh_processing::volume(cube) == Approx(1));

  // A fan from any corner of the L would leave it or be degenerate: area and volume tell.
  REQUIRE(T::read_triangle_mesh(data_file("good_meshes/prism.off"), prism).success());
  CHECK(CGAL::Polygon_mesh_processing::volume(prism) == Approx(3));
  CHECK(CGAL::Polygon_mesh_processing::area(prism) == Approx(2 * 3 + 8));
}

TEST_CASE("a quadrilateral gets its better diagonal, and never one that is an edge elsewhere")
{
  T::internal::Polygon_soup kite;
  kite.points = {{0, 0, 0}, {1, -0.1, 0}, {2, 0, 0}, {1, 0.1, 0}};
  kite.corners = {0, 1, 2, 3};
  kite.end_polygon();
  const T::internal::Triangle_soup triangles = T::internal::triangulate_polygon_soup(kite);
  REQUIRE(triangles.triangles.size() == 2);
  for (const std::array<std::size_t, 3>& triangle : triangles.triangles) {
    CHECK(std::count(triangle.begin(), triangle.end(), 1) == 1);
    CHECK(std::count(triangle.begin(), triangle.end(), 3) == 1);
  }

  kite.points.push_back({1, 0, 1});
  kite.corners.insert(kite.corners.end(), {1, 3, 4});
  kite.end_polygon();
  for (const std::array<std::size_t, 3>& triangle : T::internal::triangulate_polygon_soup(kite).triangles)
    CHECK((std::count(triangle.begin(), triangle.end(), 1) == 0 ||
           std::count(triangle.begin(), triangle.end(), 3) == 0 ||
           std::count(triangle.begin(), triangle.end(), 4) == 1));
}

TEST_CASE("a far offset and a tiny scale are read to the last bit")
{
  const Temporary_directory directory;
  const std::string name = directory.file("offset.obj");
  for (const auto& [offset, scale] : {std::pair(1e7, 1.0), std::pair(0.0, 1e-9), std::pair(-1e7, 1e-3)}) {
    std::ofstream file(name);
    file.precision(17);
    std::vector<Point_3> points;
    for (const Point_3& p : tetrahedron) {
      points.emplace_back(offset + scale * p.x(), offset + scale * p.y(), offset + scale * p.z());
      file << "v " << points.back() << "\n";
    }
    for (const std::array<std::size_t, 3>& f : tetrahedron_faces)
      file << "f " << f[0] + 1 << " " << f[1] + 1 << " " << f[2] + 1 << "\n";
    file.close();
    Surface_mesh mesh;
    REQUIRE(T::read_triangle_mesh(name, mesh).success());
    CHECK(points_in_order(mesh) == points);
  }
}

TEST_CASE("a mesh that is not empty receives no triangles")
{
  const Temporary_directory directory;
  const std::string name = directory.file("tetrahedron.obj");
  std::ofstream(name) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  Surface_mesh mesh;
  REQUIRE(T::read_triangle_mesh(name, mesh));
  const T::Mesh_reading_report report = T::read_triangle_mesh(name, mesh);
  CHECK(report.status == Status::OUTPUT_NOT_EMPTY);
  CHECK(describe(report) == message(report.status));
  CHECK(mesh.number_of_faces() == 4);
}

TEST_CASE("a polygon is triangulated up to a thousand corners")
{
  // A prism whose bottom and top are regular polygons.
  const Temporary_directory directory;
  const std::string name = directory.file("prism.off");
  for (const int n : {1000, 1001}) {
    std::ofstream file(name);
    file << "OFF\n" << 2 * n << " " << n + 2 << " 0\n";
    for (const int z : {0, 1})
      for (int i = 0; i < n; ++i)
        file << std::cos(2 * CGAL_PI * i / n) << " " << std::sin(2 * CGAL_PI * i / n) << " " << z << "\n";
    for (int i = 0; i < n; ++i)
      file << "4 " << i << " " << (i + 1) % n << " " << n + (i + 1) % n << " " << n + i << "\n";
    file << n;
    for (int i = n; i > 0; --i)
      file << " " << i - 1;
    file << "\n" << n;
    for (int i = 0; i < n; ++i)
      file << " " << n + i;
    file << "\n";
    file.close();
    Surface_mesh mesh;
    const T::Mesh_reading_report report = T::read_triangle_mesh(name, mesh);
    CAPTURE(n, describe(report));
    CHECK(report.status == (n == 1000 ? Status::SUCCESS : Status::TOO_MANY_CORNERS));
    CHECK(report.face == (n == 1000 ? T::Mesh_reading_report::none : std::size_t(n)));
    CHECK(mesh.number_of_faces() == (n == 1000 ? 3996u : 0u));
  }
}

TEST_CASE("collinearity is decided exactly")
{
  // 0.1, 0.2, 0.3 are not collinear as doubles on the diagonal with x = 1, 2, 3; the same times ten is.
  T::internal::Polygon_soup soup;
  soup.points = {{1, 0.1, 0}, {2, 0.2, 0}, {3, 0.3, 0}};
  soup.corners = {0, 1, 2};
  soup.end_polygon();
  const auto status = [&soup] {
    T::internal::Progress nobody;
    return T::internal::check_triangle_geometry(soup, T::internal::triangulate_polygon_soup(soup), nobody).status;
  };
  CHECK(status() == Status::SUCCESS);
  soup.points = {{1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
  CHECK(status() == Status::ZERO_AREA_TRIANGLE);
}

} // namespace read_triangle_mesh_test
