// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "T_mesh_with_maps.h"
#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

namespace write_t_mesh_test {

namespace {

const std::string good = T_SPLINES_TEST_DATA "/good_t_meshes/";

/// Gives each face a unit of its own, and each vertex a point and a weight, with all digits.
template <typename Graph>
void randomize(T_mesh_with_maps<Graph>& t)
{
  CGAL::Random random(11);
  const auto number = [&random] { return random.uniform_real(0.1, 1.0) * std::pow(10.0, random.get_int(-12, 13)); };
  for (const auto f : CGAL::make_range(faces(t.graph))) {
    const double unit = number();
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.graph), t.graph))
      t.knots[h] *= unit;
  }
  const auto points = get(CGAL::vertex_point, t.graph);
  for (const auto v : CGAL::make_range(vertices(t.graph))) {
    put(points, v, Kernel::Point_3(number(), -number(), number() * 1e-300));
    t.weights[v] = number();
  }
}

/// The numbers of a T-mesh, vertex by vertex and face by face from the origins of their frames.
template <typename Graph>
std::vector<double> numbers_of(const T_mesh_with_maps<Graph>& t)
{
  std::vector<double> result;
  const auto points = get(CGAL::vertex_point, t.graph);
  for (const auto v : CGAL::make_range(vertices(t.graph))) {
    for (int d = 0; d < 3; ++d)
      result.push_back(get(points, v)[d]);
    result.push_back(t.weights[v]);
  }
  for (const auto f : CGAL::make_range(faces(t.graph))) {
    auto h = halfedge(f, t.graph);
    while (!t.corners[prev(h, t.graph)])
      h = prev(h, t.graph);
    for (const auto g : CGAL::halfedges_around_face(h, t.graph)) {
      result.push_back(t.knots[g]);
      result.push_back(t.corners[g]);
    }
  }
  return result;
}

/// A stream that takes some bytes and no more.
class Full_buffer : public std::streambuf {
  std::streamsize xsputn(const char*, std::streamsize) override { return 0; }
};

} // namespace

TEMPLATE_TEST_CASE("doubles survive writing and reading, bit by bit", "", Surface_mesh, Polyhedron, Cell_complex)
{
  const Temporary_directory directory;
  const std::string file = directory.file("t_mesh.ply"), file_again = directory.file("again.ply");
  for (const char* name : {"t_joints.ply", "creases.ply", "scaled_torus.ply", "sphere_of_one_face.ply",
                           "torus_of_one_face.ply", "border.ply"}) {
    T_mesh_with_maps<TestType> t, read;
    REQUIRE(t.read(good + name).success());
    randomize(t);
    const auto np = T::parameters::vertex_weight_map(t.weight_map());
    REQUIRE_FALSE(T::write_t_mesh(file, t.view(), np));
    const T::T_mesh_reading_report report = read.read(file);
    CAPTURE(name, describe(report));
    REQUIRE(report.success());
    CHECK(numbers_of(read) == numbers_of(t));
    CHECK(read.text() == t.text());
  }
}

TEST_CASE("the frames of the faces do not depend on the halfedge of the bottom side that the graph names")
{
  T_mesh_with_maps<Surface_mesh> t;
  REQUIRE(t.read(good + "scaled_torus.ply").success());
  const std::string text = t.text();
  for (const auto f : faces(t.graph))
    set_halfedge(f, next(halfedge(f, t.graph), t.graph), t.graph); // the bottom consists of three
  CHECK(t.text() == text);

  // Another side is another frame: it comes back as it was written.
  const auto turned = *faces(t.graph).begin();
  set_halfedge(turned, prev(prev(halfedge(turned, t.graph), t.graph), t.graph), t.graph);
  CHECK(t.text() != text);
  const Temporary_directory directory;
  T_mesh_with_maps<Surface_mesh> read;
  REQUIRE_FALSE(T::write_t_mesh(directory.file("t_mesh.ply"), t.view()));
  REQUIRE(read.read(directory.file("t_mesh.ply")).success());
  const T::T_mesh_coordinates before(t.view()), after(read.view());
  const auto first_face = *faces(read.graph).begin();
  CHECK(before.width(turned) == 1);
  CHECK(after.width(first_face) == before.width(turned));
  CHECK(after.height(first_face) == before.height(turned));
  CHECK(read.graph.point(target(halfedge(first_face, read.graph), read.graph)) ==
        t.graph.point(target(halfedge(turned, t.graph), t.graph)));
}

TEST_CASE("exact knots are rounded, each by itself, and are admissible up to round-off")
{
  T_mesh_with_maps<Surface_mesh, CGAL::Exact_rational> t;
  T_mesh_with_maps<Surface_mesh> read;
  REQUIRE(t.read(good + "scaled_torus.ply").success());
  for (auto& [h, knot] : t.knots)
    knot /= 3 + 4 * static_cast<int>(static_cast<std::size_t>(t.graph.face(h)));
  const Temporary_directory directory;
  REQUIRE_FALSE(T::write_t_mesh(directory.file("t_mesh.ply"), t.view()));
  REQUIRE(read.read(directory.file("t_mesh.ply")).success());
  for (const auto f : faces(t.graph)) {
    auto h = halfedge(f, t.graph), g = halfedge(f, read.graph); // faces are numbered alike
    for (int i = 0; i < 6; ++i, h = next(h, t.graph), g = next(g, read.graph)) {
      const CGAL::Exact_rational error = CGAL::Exact_rational(read.knots[g]) / t.knots[h] - 1;
      CHECK(CGAL::abs(error) < CGAL::Exact_rational(2 * std::numeric_limits<double>::epsilon()));
    }
  }
}

TEST_CASE("creases are written if there are any, those of the border are none")
{
  T_mesh_with_maps<Surface_mesh> t;
  REQUIRE(t.read(good + "border.ply").success());
  const std::string text = t.text();
  for (const auto e : edges(t.graph))
    if (t.graph.is_border(e))
      put(t.crease_map(), e, true);
  CHECK(t.text() == text);
  for (const auto e : edges(t.graph))
    put(t.crease_map(), e, true);
  std::string with_creases = text;
  const auto insert = [&with_creases](const std::string& after, const std::string& what) {
    with_creases.insert(with_creases.find(after) + after.size(), what);
  };
  insert("property list uchar int opposite\n", "property list uchar uchar crease\n");
  insert("5 -1 -1 9 5 -1", " 5 0 0 1 1 0");
  insert("4 3 12 -1 -1", " 4 1 1 0 0");
  insert("4 2 -1 -1 6", " 4 1 0 0 1");
  CHECK(t.text() == with_creases);
}

TEST_CASE("other points and weights than the graph's own can be written")
{
  T_mesh_with_maps<Surface_mesh> t, read;
  REQUIRE(t.read(good + "cube.ply").success());
  auto points = t.graph.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_3>("v:control_point").first;
  for (const auto v : vertices(t.graph)) {
    points[v] = Kernel::Point_3(7, 8, 9);
    t.weights[v] = 0.25;
  }
  const Temporary_directory directory;
  const auto np = T::parameters::vertex_weight_map(t.weight_map(), CGAL::parameters::vertex_point_map(points));
  REQUIRE_FALSE(T::write_t_mesh(directory.file("t_mesh.ply"), t.view(), np));
  REQUIRE(read.read(directory.file("t_mesh.ply")).success());
  for (const auto v : vertices(read.graph)) {
    CHECK(read.graph.point(v) == Kernel::Point_3(7, 8, 9));
    CHECK(read.weights[v] == 0.25);
  }
}

TEST_CASE("a T-mesh file that cannot be written leaves nothing behind and leaves what was there")
{
  T_mesh_with_maps<Surface_mesh> t;
  REQUIRE(t.read(good + "cube.ply").success());
  const Temporary_directory directory;
  CHECK(T::write_t_mesh(directory.file("no_such_directory/t.ply"), t.view()) == std::errc::no_such_file_or_directory);
  std::filesystem::create_directories(directory.file("directory.ply/inside"));
  CHECK(T::write_t_mesh(directory.file("directory.ply"), t.view()));
  CHECK(std::filesystem::is_directory(directory.file("directory.ply/inside")));
  int number_of_entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(directory.path()))
    ++number_of_entries;
  CHECK(number_of_entries == 1);

  Full_buffer full;
  std::ostream out(&full);
  CHECK(T::write_t_mesh(out, t.view()) == std::io_errc::stream);
}

} // namespace write_t_mesh_test
