// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What read_triangle_mesh() repairs when it is asked to.

#include "Soup.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace repaired_meshes_test {

namespace {

namespace T = CGAL::T_splines;
using Status = T::Mesh_reading_status;

const auto repairing = T::parameters::repair(true);

Soup box()
{
  Soup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  return soup;
}

/// Checks that a soup is refused, that the report says that a repair helps, and that it does.
Read_soup repaired(const Soup& soup, const Status status, const std::string& extension = ".off")
{
  const Read_soup refused(soup, extension);
  CAPTURE(describe(refused.report));
  CHECK(refused.report.status == status);
  CHECK(refused.report.is_repairable);
  CHECK(num_vertices(refused.mesh) == 0);
  Read_soup read(soup, extension, repairing);
  CAPTURE(describe(read.report));
  REQUIRE(read.report.success());
  CHECK(CGAL::is_closed(read.mesh));
  CHECK(CGAL::is_valid_polygon_mesh(read.mesh));
  return read;
}

} // namespace

TEST_CASE("a mesh that needs no repair stays as it is")
{
  const Read_soup plain(box()), read(box(), ".off", repairing);
  REQUIRE(read.report.success());
  CHECK(note(read.report) == note(plain.report));
  CHECK(std::equal(plain.mesh.points().begin(), plain.mesh.points().end(), read.mesh.points().begin()));
  for (const auto h : plain.mesh.halfedges())
    CHECK(plain.mesh.target(h) == read.mesh.target(h));
}

TEST_CASE("each kind of fault is repaired and counted")
{
  Soup soup = box();
  soup.faces.insert(soup.faces.begin() + 2, {3, 3, 7});
  soup.faces.push_back({0, 1});
  soup.faces.push_back({5, 4, 5});
  Read_soup read = repaired(soup, Status::REPEATED_VERTEX);
  CHECK(read.report.repairs.degenerate_faces == 3);
  CHECK(note(read.report).find("repaired: 3 degenerate faces removed") != std::string::npos);

  soup = box();
  soup.faces[0] = {0, 0, 2, 3, 1, 1};
  read = repaired(soup, Status::REPEATED_VERTEX);
  CHECK(read.report.repairs.shortened_faces == 1);

  soup = box();
  soup.faces.push_back({7, 6, 4, 5});
  read = repaired(soup, Status::DUPLICATE_FACE);
  CHECK(read.report.repairs.duplicate_faces == 1);

  soup = box();
  for (const std::size_t f : {0, 3})
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  read = repaired(soup, Status::INCONSISTENT_ORIENTATION);
  CHECK(read.report.repairs.reversed_faces == 2);
  CHECK(read.volume == Approx(1));

  soup = box();
  soup.points.insert(soup.points.begin() + 3, {9, 9, 9});
  for (std::vector<std::size_t>& face : soup.faces)
    for (std::size_t& v : face)
      v += v >= 3;
  read = repaired(soup, Status::ISOLATED_VERTEX);
  CHECK(read.report.repairs.isolated_vertices == 1);
  CHECK(read.volume == Approx(1));
}

TEST_CASE("facets with equal corners in an STL file")
{
  Soup soup = box();
  soup.faces.push_back({0, 0, 1});
  const Read_soup read = repaired(soup, Status::REPEATED_VERTEX, ".stl");
  CHECK(read.report.repairs.degenerate_faces == 1);
  CHECK(read.volume == Approx(1));

  // The same with corners that differ by round-off: the neighbours of the facet have one or the other.
  Soup round_off;
  round_off.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1e-17, 0, 0}};
  round_off.faces = {{0, 2, 1}, {4, 1, 3}, {1, 2, 3}, {4, 3, 2}, {0, 1, 4}, {0, 4, 2}};
  const Read_soup tetrahedron(round_off, ".stl", repairing);
  CAPTURE(describe(tetrahedron.report));
  REQUIRE(tetrahedron.report.success());
  CHECK(tetrahedron.volume == Approx(1. / 6));
}

TEST_CASE("bodies that share vertices, edges or a side in the file become bodies of their own")
{
  for (const std::array<double, 3>& place : {std::array<double, 3>{1, 1, 1}, {1, 1, 0}, {1, 0, 0}}) {
    Soup soup = box();
    soup.add_box(place, {1, 1, 1});
    const Read_soup refused(soup.split(), ".stl"), read(soup.split(), ".stl", repairing);
    CAPTURE(place[0], place[1], place[2], describe(refused.report), describe(read.report));
    CHECK_FALSE(refused.report.success());
    CHECK(refused.report.is_repairable);
    REQUIRE(read.report.success());
    CHECK(read.components == 2);
    CHECK(read.euler_characteristic == 4);
    CHECK(read.volume == Approx(2));
    CHECK(read.report.repairs.split_vertices == (place[1] == 0 ? 4 : place[2] == 0 ? 2 : 1));
    CHECK(read.report.repairs.duplicate_faces == 0);
  }
}

TEST_CASE("of a surface with a front and a back in the file, one remains")
{
  Soup soup = box();
  const std::size_t n = soup.faces.size();
  for (std::size_t f = 0; f < n; ++f) {
    soup.faces.push_back(soup.faces[f]);
    std::reverse(soup.faces.back().begin(), soup.faces.back().end());
  }
  const Read_soup read = repaired(soup, Status::DUPLICATE_FACE);
  CHECK(read.report.repairs.duplicate_faces == n);
  CHECK(read.volume == Approx(1));
  CHECK(read.components == 1);
}

TEST_CASE("triangles of area zero are removed")
{
  // A vertex amid an edge of the neighbour, and the flat triangle between; two flat triangles beside each other.
  Soup soup;
  soup.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 0, 0}, {2, 0, 0}};
  soup.faces = {{0, 2, 1}, {0, 1, 4}, {4, 1, 5}, {0, 4, 3}, {4, 5, 3}, {5, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const Read_soup read = repaired(soup, Status::ZERO_AREA_TRIANGLE);
  CHECK(read.report.repairs.flat_triangles == 2);
  CHECK(read.volume == Approx(64. / 6));
  CHECK(read.mesh.number_of_vertices() == 6);

  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  soup.faces = {{0, 2, 1}, {4, 1, 3}, {1, 2, 3}, {4, 3, 2}, {0, 1, 4}, {0, 4, 2}};
  const Read_soup tetrahedron = repaired(soup, Status::ZERO_LENGTH_EDGE);
  CHECK(tetrahedron.mesh.number_of_vertices() == 4);
  CHECK(tetrahedron.volume == Approx(1. / 6));
}

TEST_CASE("what a repair does not mend is refused")
{
  Soup open = box();
  open.faces.pop_back();
  CHECK(Read_soup(open, ".off", T::parameters::border_is_allowed(false, repairing)).report.status == Status::BOUNDARY);
  Soup eight = box();
  eight.faces[0] = {0, 2, 3, 1, 2, 6};
  CHECK(Read_soup(eight, ".off", repairing).report.status == Status::REPEATED_VERTEX);
  Soup nothing;
  nothing.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  nothing.faces = {{0, 1, 1}};
  CHECK(Read_soup(nothing, ".off", repairing).report.status == Status::EMPTY);
}

TEST_CASE("for every bad file the report says truly whether a repair helps")
{
  std::size_t number_of_repairable = 0;
  for (const auto& entry : std::filesystem::directory_iterator(T_SPLINES_TEST_DATA "/bad_meshes")) {
    Read_soup::Mesh mesh, repaired_mesh;
    const bool is_repairable = T::read_triangle_mesh(entry.path().string(), mesh).is_repairable;
    const T::Mesh_reading_report report = T::read_triangle_mesh(entry.path().string(), repaired_mesh, repairing);
    CAPTURE(entry.path(), describe(report));
    CHECK(report.success() == is_repairable);
    CHECK_FALSE(report.is_repairable);
    number_of_repairable += is_repairable;
  }
  CHECK(number_of_repairable >= 7);
}

TEST_CASE("a torus with random faults is repaired to the torus")
{
  Soup torus;
  torus.add_torus(8);
  const double volume = Read_soup(torus).volume;
  std::mt19937 random(1);
  const auto below = [&random](const std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  for (int trial = 0; trial < 40; ++trial) {
    Soup soup = trial % 2 ? torus : torus.split();
    const std::size_t n = soup.faces.size();
    for (int i = 0; i < 20; ++i) {
      std::vector<std::size_t>& face = soup.faces[below(n)];
      std::reverse(face.begin(), face.end());
    }
    for (int i = 0; i < 5; ++i) {
      const std::vector<std::size_t> face = soup.faces[below(n)];
      soup.faces.push_back({face[1], face[2], face[0]});
      soup.faces.push_back({face[1], face[2], face[2]});
      soup.points.push_back({1, 2, 3});
    }
    const Read_soup read(soup, trial % 4 < 2 ? ".off" : ".stl", repairing);
    CAPTURE(trial, describe(read.report));
    REQUIRE(read.report.success());
    CHECK(read.mesh.number_of_vertices() == torus.points.size());
    CHECK(read.mesh.number_of_faces() == torus.faces.size());
    CHECK(read.volume == Approx(volume));
    CHECK(read.euler_characteristic == 0);
  }
}

TEST_CASE("random flat triangles are removed from a box")
{
  std::mt19937 random(2);
  for (int trial = 0; trial < 40; ++trial) {
    // Triangles of the box are split at points exactly on their edges, on one side only: flat triangles fill the gaps.
    const Read_soup read_box(box());
    Soup soup;
    for (const auto v : read_box.mesh.vertices())
      soup.points.push_back({read_box.mesh.point(v).x(), read_box.mesh.point(v).y(), read_box.mesh.point(v).z()});
    for (const auto f : read_box.mesh.faces()) {
      soup.faces.emplace_back();
      for (const auto v : read_box.mesh.vertices_around_face(read_box.mesh.halfedge(f)))
        soup.faces.back().push_back(v);
    }
    for (int i = 0; i < 10; ++i) {
      const std::size_t f = std::uniform_int_distribution<std::size_t>(0, 11)(random);
      const std::size_t a = soup.faces[f][0], b = soup.faces[f][1], c = soup.faces[f][2], m = soup.points.size();
      std::array<double, 3> middle;
      for (std::size_t k = 0; k < 3; ++k)
        middle[k] = (soup.points[a][k] + soup.points[b][k]) / 2;
      soup.points.push_back(middle);
      soup.faces[f] = {m, b, c};
      soup.faces.push_back({a, m, c});
      soup.faces.push_back({a, b, m});
    }
    const Read_soup read(soup, ".off", repairing);
    CAPTURE(trial, describe(read.report));
    REQUIRE(read.report.success());
    CHECK(read.volume == Approx(1));
    CHECK(read.euler_characteristic == 2);
    for (const auto f : read.mesh.faces())
      CHECK_FALSE(CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, read.mesh));
  }
}

} // namespace repaired_meshes_test
