// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Edges that are to lie on isolines become edges of the T-mesh.

#include "Similarity_map/chart_maps.h"
#include "Similarity_map/isoline_edges.h"
#include "Similarity_map/test_meshes.h"
#include "Tracing/Traced_map.h"

#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace walls_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traced = Traced_map<Surface_mesh, Surface_mesh, Exact>;
using chart_maps::Chart_map;
using isoline_edges::Edges;

/// The edges of the mesh that the creases of the T-mesh run along, by walking these.
Edges walked_edges(const Traced& traced)
{
  std::map<Kernel::Point_3, int> vertex;
  for (const auto v : traced.mesh.vertices())
    REQUIRE(vertex.emplace(traced.mesh.point(v), static_cast<int>(v)).second);
  std::map<Kernel::Point_3, std::vector<Kernel::Point_3>> neighbors;
  traced.creases.for_each_marked([&](const auto h) {
    const std::vector<Kernel::Point_3>& line = traced.polylines.at(edge(h, traced.graph));
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      neighbors[line[i]].push_back(line[i + 1]);
      neighbors[line[i + 1]].push_back(line[i]);
    }
  });
  Edges result;
  for (const auto& [p, beside] : neighbors) {
    if (vertex.count(p) == 0) { // a T-joint
      CHECK(beside.size() == 2);
      continue;
    }
    std::set<int> ends;
    for (Kernel::Point_3 q : beside) {
      for (Kernel::Point_3 before = p; vertex.count(q) == 0;) {
        const std::vector<Kernel::Point_3>& on = neighbors.at(q);
        const Kernel::Point_3 next = on.front() == before ? on.back() : on.front();
        before = q;
        q = next;
      }
      CHECK(ends.insert(vertex.at(q)).second); // no wall is there twice
      result.insert(isoline_edges::edge(vertex.at(p), vertex.at(q)));
    }
  }
  return result;
}

Edges inner_marked_edges(const Traced& traced)
{
  Edges result;
  for (const auto& [e, is_marked] : traced.is_marked)
    if (is_marked && !traced.mesh.is_border(e))
      result.insert(
          isoline_edges::edge(static_cast<int>(traced.mesh.vertex(e, 0)), static_cast<int>(traced.mesh.vertex(e, 1))));
  return result;
}

/// The lengths of creases, on both sides.
template <typename TMesh>
Exact length_of_walls(const TMesh& t_mesh)
{
  Exact result(0);
  for (const auto h : t_mesh.graph().halfedges())
    if (get(t_mesh.creases(), t_mesh.graph().edge(h)) && !t_mesh.graph().is_border(h))
      result += Exact(get(t_mesh.knots(), h));
  return result;
}

/// The same for the edges of the mesh in the map.
Exact length_of_walls_in_map(const Traced& traced)
{
  Exact result(0);
  for (const auto e : traced.mesh.edges())
    if (traced.map.is_constrained(e))
      for (const auto h : {traced.mesh.halfedge(e), traced.mesh.opposite(traced.mesh.halfedge(e))}) {
        const auto p = traced.map.uv(h), q = traced.map.uv(traced.mesh.prev(h));
        result += CGAL::abs(Exact(p.first - q.first)) + CGAL::abs(Exact(p.second - q.second));
      }
  return result;
}

/// Judges a traced map in exact arithmetic; each wall is covered, and nothing else is said to be one.
void check_walls(const Traced& traced, const double deviation = 0.01)
{
  INFO(traced.message_text());
  REQUIRE(traced.success());
  const Whole_check check = check_all(traced, deviation);
  INFO(check.text());
  CHECK(check.success());
  CHECK(walked_edges(traced) == inner_marked_edges(traced));
  CHECK(traced.creases.size() == num_edges(traced.graph));
}

/// Regularizes the T-mesh and splits its faces: no wall is lost, exactly.
void check_edits(const Traced& traced, CGAL::Random& random)
{
  T::T_mesh<Kernel::Point_3, Exact> t_mesh;
  REQUIRE(T::copy_T_mesh(traced.view(), t_mesh));
  const Exact length = length_of_walls(t_mesh);
  if (traced.map_report.is_isometric)
    CHECK(length == length_of_walls_in_map(traced));
  CHECK(T::regularize_T_mesh(t_mesh).success());
  CHECK(T::check_admissibility(t_mesh).success());
  CHECK(length_of_walls(t_mesh) == length);
  T::T_mesh_editor editor(t_mesh);
  const std::vector<Surface_mesh::Face_index> faces(t_mesh.graph().faces().begin(), t_mesh.graph().faces().end());
  for (const auto f : faces) {
    const int axis = random.get_int(0, 2);
    const Exact size = axis == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
    CHECK(bool(editor.split_face(f, axis, Exact(size * Exact(random.get_int(1, 8)) / Exact(8)))));
  }
  CHECK(length_of_walls(t_mesh) == length);
  for (const auto e :
       std::vector<Surface_mesh::Edge_index>(t_mesh.graph().edges().begin(), t_mesh.graph().edges().end()))
    if (!t_mesh.graph().is_removed(e)) {
      const auto h = t_mesh.graph().halfedge(e);
      const bool is_constrained = t_mesh.creases()[e];
      const auto shifted = editor.shift(h, Exact(1) / Exact(64)), removed = editor.flip_edge(h);
      CHECK((!is_constrained || (!shifted && !removed)));
    }
  CHECK(length_of_walls(t_mesh) == length);
  CHECK(T::check_admissibility(t_mesh).success());
}

const auto no_hole = [](int, int) { return false; };
const auto plane = [](const int i, const int j) { return std::array<double, 2>{{double(i), double(j)}}; };

} // namespace

TEST_CASE("Edges of polycubes at random: they begin, end, meet and cross in all ways", "[walls]")
{
  const int seed = GENERATE(1, 2, 3, 4);
  const double share = GENERATE(0.02, 0.1, 0.3, 0.7, 1.), noise = GENERATE(0., 1e-12);
  CAPTURE(seed, share, noise);
  CGAL::Random random(seed);
  for (Chart_map map : {chart_maps::planes_as_charts(test_meshes::cube(4), 4),
                        chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, 2), 2),
                        chart_maps::planes_as_charts(
                            test_meshes::voxel_surface({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, 3), 3)}) {
    const Edges marked = isoline_edges::at_random(map, share, random);
    if (noise > 0) {
      isoline_edges::scatter_charts(map, 2, random);
      chart_maps::change_frames(map, false, random);
      chart_maps::add_noise(map, noise, random);
    }
    const Traced traced(map, marked);
    check_walls(traced);
    check_edits(traced, random);
  }
}

TEST_CASE("The edges of a polycube are the walls of its T-mesh", "[walls]")
{
  // The triangles at an edge lie in two planes.
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(2, 3), 3);
  std::map<std::pair<int, int>, std::set<int>> charts;
  for (std::size_t t = 0; t < map.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      charts[isoline_edges::edge(map.triangles[t][i], map.triangles[t][(i + 1) % 3])].insert(map.chart[t]);
  Edges marked;
  for (const auto& [e, beside] : charts)
    if (beside.size() > 1)
      marked.insert(e);
  CGAL::Random random(1);
  chart_maps::change_frames(map, false, random);
  chart_maps::add_noise(map, 1e-12, random);
  const Traced traced(map, marked);
  check_walls(traced);
  check_edits(traced, random);
  T::T_mesh<Kernel::Point_3, Exact> t_mesh;
  REQUIRE(T::copy_T_mesh(traced.view(), t_mesh));
  const std::size_t faces = t_mesh.graph().number_of_faces();
  CHECK(T::make_spline_compatible(t_mesh).success());
  CHECK(t_mesh.graph().number_of_faces() > faces);
  CHECK(length_of_walls(t_mesh) == length_of_walls_in_map(traced));
}

TEST_CASE("Walls that close up get seeds on the sides on which nothing meets them", "[walls]")
{
  const double noise = GENERATE(0., 1e-12);
  CGAL::Random random(1);
  Chart_map map;
  Edges marked;
  int seeds = 0, faces = 0;
  SECTION("a circle on a torus")
  {
    map = isoline_edges::flat_torus(7, 6);
    marked = isoline_edges::of(map, [](const int a, int, const int axis) { return axis == 1 && a % 6 == 2; });
    seeds = 1; // what leaves it on one side comes back on the other
    faces = 1;
  }
  SECTION("three circles on a torus")
  {
    map = isoline_edges::flat_torus(7, 6);
    marked = isoline_edges::of(map, [](const int a, int, const int axis) { return axis == 1 && a % 2 == 0; });
    seeds = 3;
    faces = 3;
  }
  SECTION("circles that cross")
  {
    map = isoline_edges::flat_torus(7, 6);
    marked = isoline_edges::of(
        map, [](const int a, int, const int axis) { return axis == 1 ? a % 6 == 2 : a / 6 == 3 || a / 6 == 5; });
    faces = 2;
  }
  SECTION("a helix that covers a torus")
  {
    map = isoline_edges::twisted_torus(7, 6);
    marked = isoline_edges::of(map, [](int, int, const int axis) { return axis == 0; });
    seeds = 1;
    faces = 1;
  }
  SECTION("the middle of a cylinder")
  {
    map = chart_maps::grid(7, 4, true, no_hole, plane);
    marked =
        isoline_edges::of(map, [&](const int a, int, const int axis) { return axis == 1 && map.points[a][2] == 2; });
    seeds = 2;
    faces = 2;
  }
  SECTION("the middle of a cylinder, met from one side by a slit that begins on the border")
  {
    map = chart_maps::grid(7, 4, true, no_hole, plane);
    marked = isoline_edges::of(map, [&](const int a, const int b, const int axis) {
      const double z = std::min(map.points[a][2], map.points[b][2]);
      return axis == 1 ? z == 2 : isoline_edges::column(map, a, 7) == 3 && z < 2;
    });
    seeds = 1;
    faces = 2;
  }
  SECTION("the same, met between two vertices")
  {
    map = chart_maps::grid(7, 4, true, no_hole, [](const int i, const int j) {
      return std::array<double, 2>{{j < 2 ? i : i + 0.375, double(j)}};
    });
    marked = isoline_edges::of(map, [&](const int a, const int b, const int axis) {
      const double z = std::min(map.points[a][2], map.points[b][2]);
      return axis == 1 ? z == 2 : isoline_edges::column(map, a, 7) == 3 && z == 0;
    });
    seeds = 1;
    faces = 3;
  }
  chart_maps::add_noise(map, noise, random);
  const Traced traced(map, marked);
  check_walls(traced);
  CHECK(traced.report.seeds == static_cast<std::size_t>(seeds));
  CHECK(num_faces(traced.graph) == static_cast<std::size_t>(faces));
  check_edits(traced, random);
}

TEST_CASE("A wall on the line that a similarity maps to itself", "[walls]")
{
  const double noise = GENERATE(0., 1e-12);
  CGAL::Random random(1);
  Chart_map map = isoline_edges::half_ring(1.7, 8, 10);
  Edges marked;
  for (const auto& t : map.triangles)
    for (int i = 0; i < 3; ++i)
      if (map.points[t[i]][2] == 5 && map.points[t[(i + 1) % 3]][2] == 5)
        marked.insert(isoline_edges::edge(t[i], t[(i + 1) % 3]));
  chart_maps::add_noise(map, noise, random);
  const Traced traced(map, marked);
  check_walls(traced, 0.25);
  CHECK(traced.report.seeds > 0);
  T::T_mesh<Kernel::Point_3, Exact> t_mesh;
  REQUIRE(T::copy_T_mesh(traced.view(), t_mesh));
  CHECK(T::regularize_T_mesh(t_mesh).success());
  CHECK(T::check_admissibility(t_mesh).success());
  const T::T_mesh_view_of<decltype(t_mesh)> view(t_mesh);
  CHECK(length_of_walls(t_mesh) > 0);
  for (const auto v : t_mesh.graph().vertices())
    CHECK_FALSE(T::internal::is_node_of_creases(v, view));
}

TEST_CASE("Walls on surfaces with a border", "[walls]")
{
  CGAL::Random random(GENERATE(1, 2, 3, 4, 5, 6));
  const double share = GENERATE(0.1, 0.4, 1.), noise = GENERATE(0., 1e-12);
  for (Chart_map map : {chart_maps::grid(7, 4, true, no_hole, plane), chart_maps::trousers(5),
                        chart_maps::grid(
                            6, 6, false, [](const int i, const int j) { return i == 2 && j == 3; }, plane)}) {
    const Edges marked = isoline_edges::at_random(map, share, random);
    chart_maps::add_noise(map, noise, random);
    const Traced traced(map, marked);
    check_walls(traced);
    check_edits(traced, random);
  }
}

TEST_CASE("Walls in a polyhedron, mesh and T-mesh", "[walls]")
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  CGAL::Random random(1);
  const Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, 2), 2);
  const Edges marked = isoline_edges::at_random(map, 0.3, random);
  const Traced traced(map, marked);
  const Traced_map<Polyhedron, Polyhedron, Exact> other(map, marked);
  check_walls(traced);
  INFO(other.message_text());
  REQUIRE(other.success());
  CHECK(check_all(other).success());
  CHECK(other.creases.number_of_marked() > 0);
  CHECK(other.creases.number_of_marked() == traced.creases.number_of_marked());
}

TEST_CASE("Where a wall ends inside, motorcycles leave its end; where three walls meet, none do", "[walls]")
{
  Chart_map map = chart_maps::grid(6, 6, false, no_hole, plane);
  const auto at = [&](const int x, const int y) {
    for (int v = 0;; ++v)
      if (map.points[v][0] == x && map.points[v][1] == y)
        return v;
  };
  SECTION("a slit")
  {
    const Traced traced(map, {isoline_edges::edge(at(2, 3), at(3, 3)), isoline_edges::edge(at(3, 3), at(4, 3))});
    check_walls(traced);
    CHECK(traced.report.motorcycles == 6);
    CHECK(num_faces(traced.graph) == 6);
  }
  SECTION("a turn")
  {
    const Traced traced(map, {isoline_edges::edge(at(0, 3), at(1, 3)), isoline_edges::edge(at(1, 3), at(2, 3)),
                              isoline_edges::edge(at(2, 3), at(2, 2)), isoline_edges::edge(at(2, 2), at(2, 1)),
                              isoline_edges::edge(at(2, 1), at(2, 0))});
    check_walls(traced);
    CHECK(traced.report.motorcycles == 2);
    CHECK(num_faces(traced.graph) == 4);
  }
  SECTION("from side to side to side")
  {
    Edges marked;
    for (int i = 0; i < 6; ++i) {
      marked.insert(isoline_edges::edge(at(i, 3), at(i + 1, 3)));
      if (i < 3)
        marked.insert(isoline_edges::edge(at(2, i), at(2, i + 1)));
    }
    const Traced traced(map, marked);
    check_walls(traced);
    CHECK(traced.report.motorcycles == 0);
    CHECK(num_faces(traced.graph) == 3);
  }
}

} // namespace walls_test
