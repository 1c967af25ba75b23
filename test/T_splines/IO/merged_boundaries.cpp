// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How read_triangle_mesh() merges ends of boundary edges.

#include "Soup.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/named_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace merged_boundaries_test {

namespace {

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Status = T::Mesh_reading_status;

const std::vector<std::string> extensions = {".off", ".obj", ".ply", ".stl"};

Soup box()
{
  Soup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  return soup;
}

/// Moves each corner of each face by at most `noise` per coordinate.
Soup with_noise(const Soup& soup, const double noise)
{
  Soup result = soup.split();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(-noise, noise);
  for (std::array<double, 3>& p : result.points)
    for (double& x : p)
      x += step(random);
  return result;
}

} // namespace

TEST_CASE("vertices split along seams are merged in all formats, and counted")
{
  for (const std::string& extension : extensions) {
    const Read_soup read(box().split(), extension);
    CAPTURE(extension, describe(read.report));
    REQUIRE(read.report.success());
    CHECK(read.mesh.number_of_vertices() == 8);
    CHECK(read.volume == Approx(1));
    CHECK(read.euler_characteristic == 2);
    CHECK(read.report.number_of_merged_vertices == (extension == ".stl" ? 0 : 16));
    CHECK(read.report.merged_distance == 0);
    CHECK((note(read.report).find("16 vertices were merged into others at the same place") == std::string::npos) ==
          (extension == ".stl"));
  }
}

TEST_CASE("of merged vertices the first one stays, and the order is that of the file")
{
  const Soup soup = box().split();
  const Read_soup read(soup);
  REQUIRE(read.report.success());
  std::vector<std::array<double, 3>> expected, points;
  for (const std::array<double, 3>& p : soup.points)
    if (std::find(expected.begin(), expected.end(), p) == expected.end())
      expected.push_back(p);
  for (const auto v : read.mesh.vertices())
    points.push_back({read.mesh.point(v).x(), read.mesh.point(v).y(), read.mesh.point(v).z()});
  CHECK(points == expected);
}

TEST_CASE("round-off of float is merged by default")
{
  Soup torus;
  torus.add_torus(20);
  const double longest_side = 6;
  for (const std::string& extension : extensions) {
    const Read_soup read(with_noise(torus, 1e-7 * longest_side), extension);
    CAPTURE(extension, describe(read.report));
    REQUIRE(read.report.success());
    CHECK(read.mesh.number_of_vertices() == torus.points.size());
    CHECK(read.euler_characteristic == 0);
    CHECK(read.report.number_of_merged_vertices == 5 * torus.points.size());
    CHECK(read.report.merged_distance > 1e-8);
    CHECK(read.report.merged_distance < 2 * T::default_merge_distance);
    CHECK_FALSE(Read_soup(with_noise(torus, 1e-7 * longest_side), extension, P::merge_distance(0.)).report.success());
    CHECK_FALSE(Read_soup(with_noise(torus, 1e-7 * longest_side), extension, P::merge_distance(-1.)).report.success());
  }
}

TEST_CASE("the distance that the report of an open mesh names closes it, and a smaller one does not")
{
  Soup soup = box().split();
  for (std::size_t i = 0; i < 4; ++i)
    soup.points[i][2] -= 3e-5; // one side, moved away from the others
  const Read_soup read(soup);
  REQUIRE(read.report.status == Status::BOUNDARY);
  CHECK(read.report.number_of_boundary_edges == 8);
  CHECK(read.report.number_of_boundary_loops == 2);
  REQUIRE(read.report.closing_distance.has_value());
  CHECK(*read.report.closing_distance == Approx(3e-5).epsilon(0.04));
  CHECK(describe(read.report).find("8 boundary edges in 2 loops, whose ends lie within 3e-05 of the longest side") !=
        std::string::npos);
  const Read_soup closed(soup, ".off", P::merge_distance(*read.report.closing_distance));
  REQUIRE(closed.report.success());
  CHECK(closed.mesh.number_of_vertices() == 8);
  CHECK(closed.report.merged_distance == Approx(3e-5).epsilon(1e-3));
  CHECK_FALSE(Read_soup(soup, ".off", P::merge_distance(0.9 * *read.report.closing_distance)).report.success());

  soup = box().split();
  const Read_soup not_merged(soup, ".off", P::merge_distance(-1.));
  REQUIRE(not_merged.report.status == Status::BOUNDARY);
  CHECK(not_merged.report.closing_distance == 0);
  CHECK(describe(not_merged.report).find("whose ends coincide") != std::string::npos);
}

TEST_CASE("a hole is a boundary, whatever is merged elsewhere, and said")
{
  Soup soup = box().split();
  soup.faces.pop_back();
  soup.points.resize(20);
  for (const std::string& extension : extensions) {
    const Read_soup open(soup, extension);
    REQUIRE(open.report.success());
    CHECK(open.report.number_of_boundary_edges == 4);
    CHECK(open.report.number_of_boundary_loops == 1);
    CHECK(note(open.report).find("the surface is open, with 4 boundary edges in 1 loop") != std::string::npos);
    const Read_soup refused(soup, extension, P::border_is_allowed(false));
    CHECK(refused.report.status == Status::BOUNDARY);
    CHECK(refused.report.number_of_boundary_edges == 4);
    CHECK(refused.report.number_of_boundary_loops == 1);
    CHECK_FALSE(refused.report.closing_distance.has_value());
    CHECK_FALSE(refused.report.is_repairable);
  }
}

TEST_CASE("a crack is no border, unless it is meant")
{
  Soup soup = box().split();
  for (std::size_t i = 0; i < 4; ++i)
    soup.points[i][2] -= 3e-5;
  const Read_soup crack(soup);
  REQUIRE(crack.report.status == Status::BOUNDARY);
  CHECK(crack.report.number_of_boundary_loops == 2);
  CHECK(crack.report.closing_distance.has_value());
  REQUIRE(crack.report.face < soup.faces.size()); // the edge is named in the numbers of the file
  for (const std::size_t v : {crack.report.vertex, crack.report.other_vertex}) {
    const std::vector<std::size_t>& face = soup.faces[crack.report.face];
    CHECK(std::find(face.begin(), face.end(), v) != face.end());
  }
  const Read_soup forbidden(soup, ".off", P::border_is_allowed(false));
  CHECK(describe(forbidden.report) == describe(crack.report));
  const Read_soup meant(soup, ".off", P::border_is_allowed(true));
  REQUIRE(meant.report.success());
  CHECK(meant.report.number_of_boundary_loops == 2);
  soup.faces.pop_back(); // with a hole as well, merging would not close it
  soup.points.resize(20);
  const Read_soup with_hole(soup);
  REQUIRE(with_hole.report.success());
  CHECK(with_hole.report.number_of_boundary_loops >= 2);
}

TEST_CASE("bodies that touch remain bodies of their own")
{
  const std::vector<std::array<double, 3>> places = {{1, 1, 0}, {1, 1, 1}, {1, 0, 0}, {1, 0.5, 0}};
  for (const std::array<double, 3>& place : places) // along an edge, at a corner, along a side, along a part of a side
    for (const bool is_inside_out : {false, true}) {
      Soup soup = box();
      soup.add_box(place, {1, 1, 1});
      if (is_inside_out)
        for (std::vector<std::size_t>& face : soup.faces)
          std::reverse(face.begin(), face.end());
      const Read_soup read(soup.split());
      CAPTURE(place[0], place[1], place[2], is_inside_out, describe(read.report));
      REQUIRE(read.report.success());
      CHECK(read.components == 2);
      CHECK(read.mesh.number_of_vertices() == 16);
      CHECK(read.volume == Approx(is_inside_out ? -2 : 2));
    }
}

TEST_CASE("vertices of closed surfaces are never merged")
{
  Soup soup = box();
  soup.add_box({1, 1, 0}, {1, 1, 1});
  soup.add_box({3, 0, 0}, {1e-9, 1, 1}); // thinner than what is merged
  const Read_soup read(soup);
  REQUIRE(read.report.success());
  CHECK(read.mesh.number_of_vertices() == 24);
  CHECK(read.report.number_of_merged_vertices == 0);
}

TEST_CASE("two corners of one face are never merged")
{
  Soup soup;
  soup.add_box({0, 0, 0}, {1e-9, 1, 1});
  const Read_soup read(soup.split());
  REQUIRE(read.report.success());
  CHECK(read.mesh.number_of_vertices() == 8);
  CHECK(read.mesh.number_of_faces() == 12);

  T::internal::Polygon_soup open; // a strip of two triangles, whose ends are shorter than what is merged
  open.points = {{0, 0, 0}, {1e-9, 0, 0}, {0, 1, 0}, {1e-9, 1, 0}};
  open.corners = {0, 1, 2, 2, 1, 3};
  open.first_corner = {0, 3, 6};
  T::internal::merge_boundaries(1e-6, 1e-6, T::internal::Merge_conflicts::AVOIDED, open);
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(open.corner(f, i) != open.corner(f, (i + 1) % 3));
}

TEST_CASE("merging makes no edge with more than two faces")
{
  // Three sheets with corners of their own that meet in one line.
  T::internal::Polygon_soup soup;
  for (const std::array<double, 3>& tip : {std::array<double, 3>{0, 1, 0}, {1, -1, 0}, {-1, -1, 0}}) {
    const std::size_t n = soup.points.size();
    soup.points.insert(soup.points.end(), {{0, 0, 0}, {0, 0, 1}, tip});
    soup.corners.insert(soup.corners.end(), {n, n + 1, n + 2});
    soup.end_polygon();
  }
  T::internal::merge_boundaries(0, 0, T::internal::Merge_conflicts::AVOIDED, soup);
  T::internal::for_each_edge(soup, [](const auto* first, const auto* last) { CHECK(last - first <= 2); });
}

} // namespace merged_boundaries_test
