// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Seamless_map_checker.h"
#include "Similarity_map/chart_maps.h"
#include "Similarity_map/isoline_edges.h"
#include "Similarity_map/test_meshes.h"

#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace constrained_edges_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Status = T::Exact_map_status;
using chart_maps::Chart_map;
using isoline_edges::Edges;

/// A mesh with its uv and the exact map made of them.
template <typename FT>
struct Made {
  Mesh mesh;
  std::map<Mesh::Halfedge_index, Kernel::Point_2> uv;
  std::map<Mesh::Edge_index, bool> is_marked;
  T::Seamless_map<Mesh, FT> map;
  T::Exact_map_report<Mesh> report;

  Made(const Plain_map& plain, const Edges& marked) : mesh(test_meshes::face_graph<Mesh>(plain)), map(mesh)
  {
    for_each_corner(mesh, [&](const std::size_t t, std::size_t, const Mesh::Halfedge_index h) {
      for (int i = 0; i < 3; ++i)
        if (plain.triangles[t][i] == static_cast<int>(mesh.target(h)))
          uv[h] = Kernel::Point_2(plain.uv[t][i][0], plain.uv[t][i][1]);
    });
    for (const auto e : mesh.edges()) {
      const int a = static_cast<int>(mesh.vertex(e, 0)), b = static_cast<int>(mesh.vertex(e, 1));
      is_marked[e] = marked.count(isoline_edges::edge(a, b)) > 0;
    }
    report =
        T::make_exactly_seamless(mesh, boost::make_assoc_property_map(uv), map,
                                 CGAL::parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_marked)));
  }
};

/// Judges the map in exact arithmetic: marked edges lie on isolines. \return how many inner ones there are
int check_exact(const Made<CGAL::Exact_rational>& made, const double tolerance)
{
  INFO(describe(made.report, made.mesh));
  REQUIRE(made.report.success());
  const Exact_map map = exact_map(made.map);
  Seamless_map_checker checker(map);
  checker.check();
  auto& uv = const_cast<std::map<Mesh::Halfedge_index, Kernel::Point_2>&>(made.uv); // it is only read
  const Seamless_map_check result =
      checker.check_deviation(given_corners(made.mesh, boost::make_assoc_property_map(uv)), tolerance);
  INFO(result.text());
  CHECK(result.success());
  int number = 0, number_off = 0, number_wrong = 0;
  for (const auto e : made.mesh.edges()) {
    const bool is_inner = !made.mesh.is_border(e), is_marked = made.is_marked.at(e);
    number_wrong += made.map.is_constrained(e) != (is_marked && is_inner);
    number += is_marked && is_inner;
    if (is_marked)
      for (const auto h : {made.mesh.halfedge(e), made.mesh.opposite(made.mesh.halfedge(e))})
        if (!made.mesh.is_border(h)) {
          const auto p = made.map.uv(h), q = made.map.uv(made.mesh.prev(h));
          number_off += p.first != q.first && p.second != q.second;
        }
  }
  CHECK(number_off == 0);
  CHECK(number_wrong == 0);
  return number;
}

/// The same for a map whose scale factors are 1: all its coordinates are doubles.
void check_isometric(const Plain_map& map, const Edges& marked, const double tolerance)
{
  const Made<CGAL::Exact_rational> made(map, marked);
  CHECK(check_exact(made, tolerance) > 0);
  CHECK(made.report.is_isometric);
  CHECK(made.report.number_of_determined_corners == 0);
  CHECK(made.report.number_of_lines_left_apart == 0);
}

const auto no_hole = [](int, int) { return false; };
const auto plane = [](const int i, const int j) { return std::array<double, 2>{{double(i), double(j)}}; };

} // namespace

TEST_CASE("the edges of polycubes lie on isolines exactly, and so does what else is marked", "[constrained_edges]")
{
  const int seed = GENERATE(1, 2, 3);
  const double noise = GENERATE(0., 1e-12, 1e-9);
  const double share = GENERATE(0.05, 0.3, 0.9, 1.);
  const bool is_scattered = GENERATE(false, true);
  CAPTURE(seed, noise, share, is_scattered);
  CGAL::Random random(seed);
  for (Chart_map map : {chart_maps::planes_as_charts(test_meshes::cube(4), 4),
                        chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, 3), 3),
                        chart_maps::planes_as_charts(
                            test_meshes::voxel_surface({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, 3), 3)}) {
    const Edges marked = isoline_edges::at_random(map, share, random);
    if (is_scattered)
      isoline_edges::scatter_charts(map, 3, random);
    map.transform_all([](const double x, const double y) { return std::array<double, 2>{{x / 7, y / 7}}; });
    chart_maps::change_frames(map, false, random);
    chart_maps::add_noise(map, noise, random);
    check_isometric(map, marked, 1e-6);
  }
}

TEST_CASE("arcs that close up, with and without nodes, on tori and cylinders", "[constrained_edges]")
{
  const double noise = GENERATE(0., 1e-12, 1e-9);
  const bool is_scattered = GENERATE(false, true);
  CAPTURE(noise, is_scattered);
  CGAL::Random random(1);
  Chart_map map;
  Edges marked;
  SECTION("circles of one direction on a torus")
  {
    map = isoline_edges::flat_torus(7, 6);
    marked = isoline_edges::of(map, [](const int a, int, const int axis) { return axis == 1 && a % 6 % 2 == 0; });
  }
  SECTION("circles that cross")
  {
    map = isoline_edges::flat_torus(7, 6);
    marked =
        isoline_edges::of(map, [](const int a, int, const int axis) { return axis == 1 ? a % 6 == 2 : a / 6 == 3; });
  }
  SECTION("a helix on a torus whose sides are glued with a shift")
  {
    map = isoline_edges::twisted_torus(7, 6);
    marked = isoline_edges::of(map, [](int, int, const int axis) { return axis == 0; });
  }
  SECTION("a cylinder: its middle, slits that begin on its border, and what joins its borders")
  {
    const bool has_middle = GENERATE(false, true), has_joins = GENERATE(false, true);
    map = chart_maps::grid(7, 4, true, no_hole, plane);
    const auto row = [&](const int v) { return static_cast<int>(map.points[v][2]); };
    marked = isoline_edges::of(map, [&](const int a, const int b, const int axis) {
      const int column = isoline_edges::column(map, a, 7);
      const bool is_slit = axis == 0 && column % 3 == 0 && std::min(row(a), row(b)) == 0;
      return (has_middle && axis == 1 && row(a) == 2) || is_slit || (has_joins && axis == 0 && column == 1);
    });
  }
  SECTION("a cylinder with all that lies on isolines, its border included")
  {
    map = chart_maps::grid(5, 3, true, no_hole, plane);
    marked = isoline_edges::of(map, [](int, int, int) { return true; });
  }
  SECTION("a strip closed by a rotation and a translation")
  {
    map = chart_maps::grid(7, 4, true, no_hole, plane);
    for (std::size_t t = 0; t < map.chart.size(); ++t)
      map.chart[t] = (t / 2) % 7 >= 4;
    map.number_of_charts = 2;
    marked = isoline_edges::of(map, [](int, int, const int axis) { return axis == 1; });
    map.transform(1, [](const double x, const double y) { return std::array<double, 2>{{0.1 - y, x + 0.3}}; });
  }
  SECTION("trousers: a cone around which nothing turns, on two closed arcs")
  {
    map = chart_maps::trousers(5);
    marked = isoline_edges::of(map, [&](const int a, const int b, const int axis) {
      return axis == 1 && map.points[a][2] == 0 && map.points[b][2] == 0;
    });
  }
  SECTION("a plate with a hole, and arcs from its corners")
  {
    map = chart_maps::grid(
        5, 5, false, [](const int i, const int j) { return i == 2 && j == 3; }, plane);
    marked = isoline_edges::of(map, [&](const int a, int, const int axis) {
      const double x = map.points[a][0], y = map.points[a][1];
      return axis == 1 ? y == 3 : x == 3;
    });
  }
  if (is_scattered)
    isoline_edges::scatter_charts(map, 2, random);
  chart_maps::change_frames(map, false, random);
  chart_maps::add_noise(map, noise, random);
  check_isometric(map, marked, 1. / 64);
}

TEST_CASE("a closed arc with a scale factor comes to lie on the line that stays", "[constrained_edges]")
{
  const double scale = GENERATE(1.7, 2., 1.01), noise = GENERATE(0., 1e-12);
  const bool is_scattered = GENERATE(false, true);
  CAPTURE(scale, noise, is_scattered);
  CGAL::Random random(1);
  Chart_map map = isoline_edges::half_ring(scale, 8, 10);
  Edges marked;
  for (const auto& t : map.triangles)
    for (int i = 0; i < 3; ++i)
      if (map.points[t[i]][2] == 5 && map.points[t[(i + 1) % 3]][2] == 5)
        marked.insert(isoline_edges::edge(t[i], t[(i + 1) % 3]));
  CHECK(marked.size() == 8);
  if (is_scattered) {
    isoline_edges::scatter_charts(map, 3, random);
    chart_maps::change_frames(map, true, random);
  }
  chart_maps::add_noise(map, noise, random);
  const Made<CGAL::Exact_rational> made(map, marked);
  CHECK(check_exact(made, 0.25) == 8);
  CHECK_FALSE(made.report.is_isometric);
}

TEST_CASE("closed arcs through the same fixed point, along the cut and across it", "[constrained_edges]")
{
  // The axes of the plane without the origin modulo z -> s z.
  const double s = GENERATE(2., 1.5, 2.718281828), noise = GENERATE(0., 1e-12);
  CAPTURE(s, noise);
  CGAL::Random random(1);
  Chart_map map = chart_maps::hopf_torus(s, 16, 6);
  Edges marked;
  for (const auto& t : map.triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = std::min(t[i], t[(i + 1) % 3]), b = std::max(t[i], t[(i + 1) % 3]);
      if (a / 6 == b / 6 && a / 6 % 4 == 0)
        marked.emplace(a, b);
    }
  for (int i = 0; i < 8; ++i) // half of the circle that is cut becomes a cut along one of the axes
    for (std::size_t t = 2 * 6 * i; t < static_cast<std::size_t>(2 * 6 * (i + 1)); ++t)
      map.chart[t] = 1;
  map.number_of_charts = 2;
  map.transform(1, [s](const double x, const double y) { return std::array<double, 2>{{s * x, s * y}}; });
  map.transform_all([](const double x, const double y) { return std::array<double, 2>{{x + 0.3, y - 0.7}}; });
  chart_maps::add_noise(map, noise, random);
  const Made<CGAL::Exact_rational> made(map, marked);
  CHECK(check_exact(made, 0.25) == 24);
  CHECK_FALSE(made.report.is_isometric);
}

TEST_CASE("where arcs close up through charts of many sizes, their scale factors multiply to 1", "[constrained_edges]")
{
  const int seed = GENERATE(1, 2, 3);
  const double share = GENERATE(0.1, 0.5, 1.);
  CAPTURE(seed, share);
  CGAL::Random random(seed);
  for (Chart_map map : {chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, 3), 3),
                        chart_maps::planes_as_charts(test_meshes::slab_with_holes(2, 1), 1)}) {
    const Edges marked = isoline_edges::at_random(map, share, random);
    isoline_edges::scatter_charts(map, 2, random);
    chart_maps::change_frames(map, true, random);
    const Made<CGAL::Exact_rational> made(map, marked);
    CHECK(check_exact(made, 0.25) > 0);
    CHECK_FALSE(made.report.is_isometric);
  }
}

TEST_CASE("marked edges in round-off", "[constrained_edges]")
{
  CGAL::Random random(1);
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, 3), 3);
  const Edges marked = isoline_edges::at_random(map, 0.5, random);
  chart_maps::add_noise(map, 1e-12, random);
  const Made<double> made(map, marked);
  CHECK(made.report.success());
  double worst = 0;
  for (const auto e : made.mesh.edges())
    if (made.map.is_constrained(e)) {
      const auto p = made.map.uv(made.mesh.halfedge(e)), q = made.map.uv(made.mesh.prev(made.mesh.halfedge(e)));
      worst = std::max(worst, std::min(std::abs(p.first - q.first), std::abs(p.second - q.second)));
    }
  CHECK(worst < 1e-14);
}

TEST_CASE("marked edges off the axes are refused", "[constrained_edges]")
{
  Chart_map map = chart_maps::planes_as_charts(test_meshes::cube(3), 3);
  const double angle = GENERATE(0., 1e-3);
  Edges marked = isoline_edges::of(map, [](int, int, int) { return true; });
  if (angle == 0) { // diagonals
    for (const auto& t : map.triangles)
      for (int i = 0; i < 3; ++i)
        marked.insert(isoline_edges::edge(t[i], t[(i + 1) % 3]));
  }
  else
    map.transform_all([angle](const double x, const double y) {
      return std::array<double, 2>{
          {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)}};
    });
  const Made<CGAL::Exact_rational> made(map, marked);
  REQUIRE(made.report.status == Status::CONSTRAINED_EDGE_NOT_ALIGNED);
  REQUIRE(made.report.halfedge != Mesh::null_halfedge());
  CHECK(made.is_marked.at(made.mesh.edge(made.report.halfedge)));
  CHECK(made.report.deviation == Approx(angle == 0 ? std::atan(1.) : angle));
  CHECK(describe(made.report, made.mesh).find(message(made.report.status)) == 0);
  CHECK(made.map.layout().mesh().number_of_faces() == 0);
}

} // namespace constrained_edges_test
