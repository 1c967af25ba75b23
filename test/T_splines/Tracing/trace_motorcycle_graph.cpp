// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Each map and graph is judged by `Seamless_map_checker` and `T_mesh_checker`, in exact arithmetic.

#include "Similarity_map/chart_maps.h"
#include "Similarity_map/test_meshes.h"
#include "Tracing/Traced_map.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace trace_motorcycle_graph_test {

using namespace hand_made_maps;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Traced = Traced_map<Surface_mesh, Surface_mesh, Exact>;

static Whole_check traced_and_checked(const Plain_map& map)
{
  REQUIRE(is_simple(map));
  const Traced traced(map);
  INFO(traced.message_text());
  REQUIRE(traced.success());
  const Whole_check check = check_all(traced);
  INFO(check.text());
  CHECK(check.success());
  CHECK(traced.report.t_joints == static_cast<std::size_t>(check.t_mesh.t_joints));
  return check;
}

static Plain_map flipped(Plain_map map, const unsigned seed)
{
  flip_at_random(map, 10 * static_cast<int>(map.triangles.size()), seed);
  return map;
}

// The numbers of vertices, edges, faces, T-joints.
static void require_counts(const Whole_check& check, const int vertices, const int edges, const int faces,
                           const int t_joints)
{
  CHECK(check.t_mesh.vertices == vertices);
  CHECK(check.t_mesh.edges == edges);
  CHECK(check.t_mesh.faces == faces);
  CHECK(check.t_mesh.t_joints == t_joints);
}

// Edges of the triangle mesh along an isoline that join two cones.
static int isoline_edges_between_cones(const Plain_map& plain)
{
  const Traced traced(plain);
  const Exact_map map = traced.exact_map();
  int count = 0;
  for (std::size_t h = 0; h < map.target.size(); ++h) {
    const Exact_point e = map.uv[h] - map.uv[Exact_map::previous(static_cast<int>(h))];
    const bool joins_cones =
        map.quarter_turns[map.target[h]] != 4 && map.quarter_turns[map.source(static_cast<int>(h))] != 4;
    count += joins_cones && (e.first == 0 || e.second == 0) && static_cast<int>(h) < map.opposite[h];
  }
  return count;
}

TEST_CASE("Cones joined by edges of the mesh: the graph of a cube is the cube", "[trace]")
{
  const Plain_map map = folded(net(cube(), 1, Pattern::DIAGONALS));
  CHECK(isoline_edges_between_cones(map) == 12);
  const Whole_check check = traced_and_checked(map);
  require_counts(check, 8, 12, 6, 0);
  CHECK(check.t_mesh.unequal_knots == 0);
}

TEST_CASE("Rays along edges and through regular vertices", "[trace]")
{
  for (const Pattern pattern :
       {Pattern::DIAGONALS, Pattern::OTHER_DIAGONALS, Pattern::MIXED_DIAGONALS, Pattern::CROSSES})
    for (const int n : {2, 3, 8})
      require_counts(traced_and_checked(folded(net(cube(), n, pattern))), 8, 12, 6, 0);
}

TEST_CASE("Rays head-on on one isoline inside triangles and into other cones", "[trace]")
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Plain_map map = flipped(folded(net(cube(), 1 + seed % 4, Pattern::MIXED_DIAGONALS, seed)), seed);
    if (seed % 4 == 0)
      CHECK(isoline_edges_between_cones(map) < 12);
    require_counts(traced_and_checked(map), 8, 12, 6, 0);
  }
}

TEST_CASE("Cones with k = 1, 2, 3, 5, 8, 28", "[trace]")
{
  for (const int k : {1, 2, 3, 5, 8, 28}) {
    Net squares = net(double_star(k), 3, Pattern::CROSSES);
    if (k == 1)
      squares = subdivided(split(squares));
    const Plain_map map = folded(squares);
    for (const Plain_map& each : {map, flipped(map, 1), flipped(map, 2)}) {
      const Whole_check check = traced_and_checked(each);
      require_counts(check, 2 + 2 * k, 4 * k, 2 * k, 0);
      CHECK(check.t_mesh.extraordinary_vertices == k + 2);
    }
  }
}

TEST_CASE("A cone whose rotation is the identity, and whose rays end in itself", "[trace]")
{
  for (const int n : {3, 4}) {
    const Plain_map map = folded(net(translation_surface(), n, Pattern::MIXED_DIAGONALS));
    require_counts(traced_and_checked(map), 1, 6, 3, 0);
    require_counts(traced_and_checked(flipped(map, 5)), 1, 6, 3, 0);
  }
}

TEST_CASE("Polycubes: cones with k = 3 and 5, crossings at vertices, on edges, in triangles", "[trace]")
{
  const std::set<std::array<int, 3>> l = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}};
  const std::set<std::array<int, 3>> t = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{1, 1, 0}}, {{1, 1, 1}}, {{1, 1, 2}}};
  std::set<std::array<int, 3>> ring;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 4; ++y)
      if (x != 1 || y == 0 || y == 3)
        ring.insert({{x, y, 0}});
  for (const auto& cubes : {l, t, ring})
    for (unsigned seed = 0; seed < 8; ++seed) {
      const Pattern pattern = seed % 2 ? Pattern::CROSSES : Pattern::MIXED_DIAGONALS;
      const Plain_map map = folded(net(polycube(cubes), 1 + seed % 3, pattern, seed));
      CHECK(traced_and_checked(map).t_mesh.unequal_knots == 0);
      CHECK(traced_and_checked(flipped(map, seed)).t_mesh.unequal_knots == 0);
    }
}

TEST_CASE("A ray ends exactly on an edge that is a trace itself", "[trace]")
{
  for (const double x : {0.5, 0.25, 0.375}) {
    const Whole_check check = traced_and_checked(folded(folded_triangle({{1, 0}}, {{x, 1}})));
    CHECK(check.map.cones == 4);
  }
}

TEST_CASE("Rays cross the same triangles hundreds of times, many in one triangle", "[trace]")
{
  for (const double width : {1. / 64, 1. / 256, 1. / 512}) {
    // A tube along a diagonal: what spirals around it one way goes to its other end.
    const Plain_map map = folded(folded_triangle({{width, -63 * width / 64}}, {{1, 1 - 3 * width / 128}}));
    REQUIRE(map.triangles.size() == 4);
    const Traced traced(map);
    REQUIRE(traced.success());
    CHECK(traced.report.crossed_faces > 2 / width);
    const Whole_check check = check_all(traced);
    INFO(check.text());
    CHECK(check.success());
    CHECK(check.t_mesh.vertices - check.map.cones > 4); // crossings: more than there are triangles
  }
}

TEST_CASE("Generic translation surfaces: cones with k = 12, twice k = 8", "[trace]")
{
  const std::vector<Position> octagon = {{{1, -0.25}}, {{0.75, 0.5}}, {{0.125, 1}}, {{-0.5, 0.75}}};
  std::vector<Position> decagon = octagon;
  decagon.push_back({{-1, 0.53125}});
  for (const auto& sides : {octagon, decagon})
    for (const bool is_fine : {false, true}) {
      Net polygon = subdivided(subdivided(symmetric_polygon(sides)));
      if (is_fine)
        polygon = subdivided(polygon);
      const Whole_check check = traced_and_checked(folded(polygon));
      CHECK(check.map.cones == (sides.size() == 4 ? 1 : 2));
      CHECK(check.t_mesh.extraordinary_vertices == check.map.cones);
      traced_and_checked(flipped(folded(polygon), 9));
    }
}

TEST_CASE("Tori without cones", "[trace]")
{
  for (const int shift : {0, 1, 2}) // closed isolines along edges
    traced_and_checked(folded(net(square_torus(3, 2, shift), 2, Pattern::MIXED_DIAGONALS)));
  for (const Position& a :
       {Position{{1, 0}}, Position{{1, 0.25}}, Position{{0.99609375, 0.0078125}}, Position{{0.625, 0.376953125}}})
    for (const Position& b : {Position{{0, 1}}, Position{{-0.25, 1}}, Position{{-0.380859375, 0.615234375}}}) {
      const Plain_map map = folded(lattice_torus(a, b, 4, 3));
      const Whole_check check = traced_and_checked(map);
      CHECK(check.t_mesh.extraordinary_vertices == 0);
      CHECK(check.t_mesh.unequal_knots == 0);
      traced_and_checked(flipped(map, 4));
    }
}

TEST_CASE("Tori with a scale factor, whose isolines spiral", "[trace]")
{
  for (const double scale : {1.5, 2., 1 + 1. / 16})
    for (const int sectors : {1, 2, 4, 5})
      for (const int turns : {0, 1}) {
        const Whole_check check = traced_and_checked(folded(scaled_torus(scale, sectors, turns, 4, 4)));
        INFO("scale " << scale << ", sectors " << sectors << ", turns " << turns);
        CHECK(check.map.scaled_edges > 0);
        CHECK(check.t_mesh.unequal_knots > 0);
      }
}

TEST_CASE("A surface with a border: rays leave the reflex corner", "[trace]")
{
  for (const int n : {1, 3}) {
    const Whole_check check = traced_and_checked(folded(bordered_l(n, Pattern::MIXED_DIAGONALS)));
    require_counts(check, 8, 10, 3, 0);
  }
}

TEST_CASE("Two components", "[trace]")
{
  Net both = net(cube(), 2, Pattern::CROSSES);
  const Net other = net(double_star(5), 2, Pattern::CROSSES);
  const int offset = static_cast<int>(both.at.size());
  both.at.insert(both.at.end(), other.at.begin(), other.at.end());
  for (auto t : other.triangles)
    both.triangles.push_back({{t[0] + offset, t[1] + offset, t[2] + offset}});
  for (auto g : other.glue)
    both.glue.push_back({{g[0] + offset, g[1] + offset, g[2] + offset, g[3] + offset}});
  const Whole_check check = traced_and_checked(folded(both));
  CHECK(check.map.components == 2);
  CHECK(check.t_mesh.faces == 16);
}

TEST_CASE("Maps of the package: cones in general position, scale factors", "[trace]")
{
  struct Case {
    Plain_mesh mesh;
    std::vector<std::pair<int, int>> cones;
  };
  const std::vector<Case> cases = {
      {test_meshes::sphere(2), {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}, {6, 3}, {7, 3}}},
      {test_meshes::sphere(2), {{0, 1}, {1, 2}, {2, 3}, {3, 2}, {4, 6}, {5, 2}}},
      {test_meshes::torus(16, 10), {{5, 3}, {77, 5}}},
      {test_meshes::slab_with_holes(2, 2), {{0, 5}, {21, 6}, {30, 5}, {50, 8}}}};
  for (const Case& each : cases) {
    Surface_mesh mesh = test_meshes::face_graph<Surface_mesh>(each.mesh), refined;
    std::vector<std::pair<Surface_mesh::Vertex_index, int>> cones;
    for (const auto& [v, k] : each.cones)
      cones.emplace_back(Surface_mesh::Vertex_index(v), k);
    CGAL::T_splines::Holonomy_signature<Surface_mesh> signature;
    REQUIRE(CGAL::T_splines::holonomy_signature_of_cones(mesh, cones, signature).success());
    const auto uv = refined.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    REQUIRE(CGAL::T_splines::compute_seamless_similarity_map(mesh, signature, refined, uv).success());
    const Traced traced(refined, uv);
    INFO(traced.message_text());
    REQUIRE(traced.success());
    const Exact_map map = traced.exact_map();
    Seamless_map_checker map_checker(map);
    map_checker.check();
    const Seamless_map_check map_check =
        map_checker.check_cones(each.cones); // the first vertices are those of the mesh
    INFO(map_check.text());
    CHECK(map_check.success());
    const Whole_check check = check_all(traced, 0.5);
    INFO(check.text());
    CHECK(check.success());
    CHECK(check.t_mesh.extraordinary_vertices == static_cast<int>(each.cones.size()));
  }
}

TEST_CASE("The same input gives the same graph, to the last digit", "[trace]")
{
  for (const Plain_map& map :
       {flipped(folded(net(cube(), 3, Pattern::CROSSES)), 1),
        folded(folded_triangle({{1, -0.0078125}}, {{0.380859375, 0.625}})), folded(scaled_torus(1.5, 4, 0, 4, 4))}) {
    const Traced first(map), second(map);
    REQUIRE(first.success());
    CHECK(dump(first.exact_t_mesh()) == dump(second.exact_t_mesh()));
  }
}

TEMPLATE_TEST_CASE("Models of triangle mesh and T-mesh, exact knots", "[trace]", (std::tuple<Surface_mesh, Polyhedron>),
                   (std::tuple<Polyhedron, Surface_mesh>), (std::tuple<Polyhedron, Polyhedron>))
{
  using Other = Traced_map<std::tuple_element_t<0, TestType>, std::tuple_element_t<1, TestType>, Exact>;
  for (const Plain_map& map :
       {folded(net(cube(), 2, Pattern::CROSSES)), folded(folded_triangle({{1, 0.25}}, {{0.375, 1}})),
        folded(net(translation_surface(), 3, Pattern::MIXED_DIAGONALS)), folded(scaled_torus(1.5, 4, 0, 4, 4))}) {
    const Traced reference(map);
    const Other other(map);
    REQUIRE(other.success());
    const Whole_check check = check_all(other);
    INFO(check.text());
    CHECK(check.success());
    const Exact_t_mesh t = other.exact_t_mesh(), r = reference.exact_t_mesh();
    CHECK(t.number_of_vertices == r.number_of_vertices);
    CHECK(t.number_of_halfedges() == r.number_of_halfedges());
    CHECK(t.number_of_faces() == r.number_of_faces());
  }
}

TEMPLATE_TEST_CASE("Knots in doubles are those of the exact graph, rounded", "[trace]", Surface_mesh, Polyhedron)
{
  for (const Plain_map& map :
       {flipped(folded(net(cube(), 3, Pattern::CROSSES)), 1),
        folded(folded_triangle({{1, -0.0078125}}, {{0.380859375, 0.625}})), folded(scaled_torus(1.5, 4, 0, 4, 4))}) {
    const Traced_map<Surface_mesh, TestType, double> rounded(map);
    const Traced_map<Surface_mesh, TestType, Exact> exact(map);
    REQUIRE(rounded.success());
    REQUIRE(exact.success());
    const Exact_t_mesh r = rounded.exact_t_mesh(), e = exact.exact_t_mesh();
    CHECK(r.next == e.next);
    CHECK(r.target == e.target);
    CHECK(r.face == e.face);
    CHECK(r.is_corner == e.is_corner);
    CHECK(r.halfedge_of_face == e.halfedge_of_face);
    for (int h = 0; h < e.number_of_halfedges(); ++h)
      CHECK(std::abs(CGAL::to_double(Exact(r.knot[h] / e.knot[h] - 1))) < 1e-15);
    for (std::size_t v = 0; v < e.place.size(); ++v) {
      CHECK(r.place[v].face == e.place[v].face);
      CHECK(CGAL::to_double(r.place[v].at.first) == Approx(CGAL::to_double(e.place[v].at.first)).margin(1e-12));
      CHECK(CGAL::to_double(r.place[v].at.second) == Approx(CGAL::to_double(e.place[v].at.second)).margin(1e-12));
    }
    const T_mesh_check check = T_mesh_checker(rounded.exact_map(), r, 1e-12).check();
    INFO(check.text());
    CHECK(check.success());
  }
}

// --- isolines that connect cones up to round-off

// What a T-mesh is made of, whatever the numbering.
struct Shape {
  std::size_t vertices, edges, faces, t_joints;

  explicit Shape(const Traced& traced)
    : vertices(num_vertices(traced.graph)),
      edges(num_edges(traced.graph)),
      faces(num_faces(traced.graph)),
      t_joints(traced.report.t_joints)
  {
  }
  friend bool operator==(const Shape& a, const Shape& b)
  {
    return std::tie(a.vertices, a.edges, a.faces, a.t_joints) == std::tie(b.vertices, b.edges, b.faces, b.t_joints);
  }
  friend std::ostream& operator<<(std::ostream& out, const Shape& s)
  {
    return out << s.vertices << " vertices, " << s.edges << " edges, " << s.faces << " faces, " << s.t_joints
               << " T-joints";
  }
};

// By how much knots are off multiples of the shortest one.
static double distance_from_grid(const Exact_t_mesh& t_mesh)
{
  const double shortest = CGAL::to_double(*std::min_element(t_mesh.knot.begin(), t_mesh.knot.end()));
  double result = 0;
  for (const Exact& knot : t_mesh.knot) {
    const double n = CGAL::to_double(knot) / shortest;
    result = std::max(result, std::abs(n - std::round(n)));
  }
  return result;
}

static int number_of_knots_that_are_no_doubles(const Exact_t_mesh& t_mesh)
{
  return static_cast<int>(std::count_if(t_mesh.knot.begin(), t_mesh.knot.end(),
                                        [](const Exact& knot) { return Exact(CGAL::to_double(knot)) != knot; }));
}

// The cones of the surfaces below lie at distances of one or more units. Where more than two motorcycles come to a
// place at the same time, the surface may be divided in several ways.
static void check_like(const Traced& traced, const Traced& ideal, const bool is_unique)
{
  INFO(traced.message_text());
  REQUIRE(traced.success());
  CHECK(traced.map_report.number_of_joined_lines == ideal.map_report.number_of_joined_lines);
  CHECK(traced.map_report.number_of_lines_left_apart == 0);
  if (is_unique)
    CHECK(Shape(traced) == Shape(ideal));
  if (traced.map_report.is_isometric)
    CHECK(distance_from_grid(traced.exact_t_mesh()) < 1e-4);
  const Whole_check check = check_all(traced, 0.125);
  INFO(check.text());
  CHECK(check.success());
}

// A rotation of space that no round-off is used to.
static Plain_mesh rotated(Plain_mesh mesh, CGAL::Random& random)
{
  for (const std::array<int, 2>& axes : {std::array<int, 2>{{0, 1}}, {{1, 2}}, {{2, 0}}, {{0, 1}}}) {
    const double angle = random.get_double(0, 6), c = std::cos(angle), s = std::sin(angle);
    for (auto& p : mesh.points) {
      const double x = p[axes[0]], y = p[axes[1]];
      p[axes[0]] = c * x - s * y;
      p[axes[1]] = s * x + c * y;
    }
  }
  return mesh;
}

static Plain_mesh mirrored(Plain_mesh mesh)
{
  for (auto& p : mesh.points)
    p[0] = -p[0];
  for (auto& t : mesh.triangles)
    std::swap(t[0], t[1]);
  return mesh;
}

// The seamless map with given cones, in doubles.
static void compute_map(const Surface_mesh& mesh, const std::vector<std::pair<Surface_mesh::Vertex_index, int>>& cones,
                        Surface_mesh& refined,
                        Surface_mesh::Property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>& uv)
{
  namespace T = CGAL::T_splines;
  T::Holonomy_signature<Surface_mesh> signature;
  REQUIRE(T::holonomy_signature_of_cones(mesh, cones, signature).success());
  uv = refined.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  REQUIRE(T::compute_seamless_similarity_map(mesh, signature, refined, uv).success());
}

// Turns a map so that an edge of the mesh runs along an axis.
template <typename HalfedgeUVMap>
static void turn_along(const Surface_mesh& mesh, const Surface_mesh::Vertex_index from,
                       const Surface_mesh::Vertex_index to, HalfedgeUVMap uv)
{
  for (const auto h : mesh.halfedges()) {
    if (mesh.source(h) != from || mesh.target(h) != to)
      continue;
    const Kernel::Vector_2 d = uv[h] - uv[mesh.prev(h)], e = d / std::sqrt(d.squared_length());
    for (const auto each : mesh.halfedges())
      uv[each] = {e.x() * uv[each].x() + e.y() * uv[each].y(), e.x() * uv[each].y() - e.y() * uv[each].x()};
    return;
  }
  FAIL("the refined mesh lacks the edge");
}

static const std::vector<std::set<std::array<int, 3>>>& polycubes()
{
  static const std::vector<std::set<std::array<int, 3>>> result = {
      {{{0, 0, 0}}},
      {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}, {{0, 2, 0}}, {{1, 2, 0}}}, // a box
      {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 2, 0}}},                           // a prism over an L
      {{{0, 0, 0}}, {{1, 0, 0}}, {{-1, 0, 0}}, {{0, 1, 0}}, {{0, -1, 0}}, {{0, 0, 1}}, {{0, 0, -1}}}, // a cross
      {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}, {{2, 1, 0}}, {{0, 2, 0}}, {{1, 2, 0}}, {{2, 2, 0}}}};
  return result;
}

// All cones are joined, by lines that do not cross.
static bool has_one_t_mesh(const std::set<std::array<int, 3>>& cubes)
{
  return cubes.size() != 4 && cubes.size() != 8;
}

TEST_CASE("Computed maps of polycubes, turned and mirrored, are traced like the ideal ones", "[trace]")
{
  CGAL::Random random(1);
  for (const auto& cubes : polycubes())
    for (const int n : {2, 3, 5}) {
      const Plain_mesh plain = test_meshes::voxel_surface(cubes, n);
      const Traced ideal(chart_maps::planes_as_charts(plain, n));
      REQUIRE(ideal.success());
      CHECK(ideal.map_report.number_of_joined_lines > 0);
      std::vector<std::pair<Surface_mesh::Vertex_index, int>> cones;
      for (const auto v : ideal.mesh.vertices())
        if (ideal.map.quarter_turns(v) != 4)
          cones.emplace_back(v, ideal.map.quarter_turns(v));
      const Plain_mesh turned = rotated(plain, random);
      for (const bool is_mirrored : {false, true}) {
        Surface_mesh refined;
        Surface_mesh::Property_map<Surface_mesh::Halfedge_index, Kernel::Point_2> uv;
        compute_map(test_meshes::face_graph<Surface_mesh>(is_mirrored ? mirrored(turned) : turned), cones, refined, uv);
        turn_along(refined, Surface_mesh::Vertex_index(plain.triangles.front()[0]),
                   Surface_mesh::Vertex_index(plain.triangles.front()[1]), uv);
        const Traced traced(refined, uv);
        INFO(cubes.size() << " cubes, " << n << " squares, " << (is_mirrored ? "mirrored" : "not mirrored"));
        check_like(traced, ideal, has_one_t_mesh(cubes));
        CHECK(traced.map_report.is_isometric);
        CHECK(traced.map_report.number_of_determined_corners == 0);
        CHECK(number_of_knots_that_are_no_doubles(traced.exact_t_mesh()) == 0);
      }
    }
}

TEST_CASE("Given maps with noise, or with charts on scales of their own, are traced like the ideal ones", "[trace]")
{
  CGAL::Random random(2);
  for (const auto& cubes : polycubes())
    for (const int n : {1, 3, 4}) {
      const chart_maps::Chart_map map = chart_maps::planes_as_charts(test_meshes::voxel_surface(cubes, n), n);
      const Traced ideal(map);
      for (const double noise : {0., 1e-13, 1e-10, 1e-7})
        for (const bool is_scaled : {false, true}) {
          if (is_scaled && (noise > 1e-13 || cubes.size() == 8)) // scales around the hole would have to cancel
            continue;
          chart_maps::Chart_map noisy = map;
          noisy.transform_all([](const double x, const double y) { return std::array<double, 2>{{x / 7, y / 7}}; });
          chart_maps::change_frames(noisy, is_scaled, random);
          chart_maps::add_noise(noisy, noise, random);
          const Traced traced(noisy);
          INFO(cubes.size() << " cubes, " << n << " squares, noise " << noise
                            << (is_scaled ? ", scaled" : ", not scaled"));
          check_like(traced, ideal, has_one_t_mesh(cubes));
          CHECK(traced.map_report.largest_gap <= 1000 * noise + 1e-8);
        }
    }
}

TEST_CASE("Corners of the border on one isoline up to noise are joined", "[trace]")
{
  CGAL::Random random(3);
  const auto is_hole = [](const int i, const int j) { return j == 1 && (i == 2 || i == 6); };
  const auto plane = [](const int i, const int j) { return std::array<double, 2>{{i / 7., j / 7.}}; };
  for (const double noise : {0., 1e-13, 1e-9}) {
    chart_maps::Chart_map map = chart_maps::grid(9, 3, false, is_hole, plane);
    chart_maps::add_noise(map, noise, random);
    const Traced traced(map);
    INFO("noise " << noise << ", " << traced.message_text());
    REQUIRE(traced.success());
    CHECK(traced.map_report.number_of_joined_lines == 2); // between the holes
    CHECK(traced.map_report.number_of_lines_left_apart == 0);
    CHECK(distance_from_grid(traced.exact_t_mesh()) < 1e-6);
    require_counts(check_all(traced), 24, 38, 13, 0); // five columns, without the holes
  }
}

TEST_CASE("Without scale factors, knots of real meshes are doubles, short enough to be added up", "[trace]")
{
  namespace T = CGAL::T_splines;
  const std::string name = GENERATE("bones.off", "cow.off", "cube-meshed.off", "bear_bis.off", "man.off", "star.off");
  INFO(name);
  Surface_mesh mesh, refined;
  REQUIRE(T::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
  const auto field = mesh.add_property_map<Surface_mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  REQUIRE(T::compute_smooth_cross_field(mesh, field).success());
  T::Holonomy_signature<Surface_mesh> signature;
  REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature).success());
  const auto uv = refined.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  REQUIRE(T::compute_seamless_similarity_map(mesh, signature, refined, uv).success());
  const Traced traced(refined, uv);
  REQUIRE(traced.success());
  CHECK(traced.map_report.is_isometric);
  CHECK(traced.map_report.number_of_determined_corners == 0);
  CHECK(traced.report.predicates.exact_calls < traced.report.predicates.calls / 100);
  const Exact_t_mesh t_mesh = traced.exact_t_mesh();
  CHECK(number_of_knots_that_are_no_doubles(t_mesh) == 0);
  for (int f = 0; f < t_mesh.number_of_faces(); ++f) {
    Exact sum = 0;
    double sum_of_doubles = 0;
    int h = t_mesh.halfedge_of_face[f];
    do {
      sum += t_mesh.knot[h] / 2;
      sum_of_doubles += CGAL::to_double(t_mesh.knot[h]) / 2;
      h = t_mesh.next[h];
    } while (h != t_mesh.halfedge_of_face[f]);
    CHECK(sum == Exact(sum_of_doubles));
  }
}

// Stops the work after a number of questions whether to go on.
struct Stopping_visitor : CGAL::T_splines::Progress_visitor {
  int* left;

  explicit Stopping_visitor(int& questions) : left(&questions) {}
  bool go_on() const { return (*left)-- > 0; }
};

TEST_CASE("An empty map, and a visitor that stops the work: the T-mesh stays empty", "[trace]")
{
  const auto trace = [](const Plain_map& plain, int questions) {
    const Surface_mesh mesh = test_meshes::face_graph<Surface_mesh>(plain);
    std::map<Surface_mesh::Halfedge_index, Kernel::Point_2> uv;
    put_corners(plain, mesh, boost::make_assoc_property_map(uv));
    CGAL::T_splines::Seamless_map<Surface_mesh> map(mesh);
    if (num_faces(mesh) > 0)
      REQUIRE(make_exactly_seamless(mesh, boost::make_assoc_property_map(uv), map).success());
    CGAL::T_splines::T_mesh<Kernel::Point_3, Exact> t_mesh;
    const auto report = trace_motorcycle_graph(map, t_mesh, CGAL::parameters::visitor(Stopping_visitor(questions)));
    const Surface_mesh& graph = t_mesh.graph();
    CHECK(num_vertices(graph) + num_halfedges(graph) + num_faces(graph) == (report.success() ? 8 + 24 + 6 : 0));
    return report.status;
  };
  using Status = CGAL::T_splines::Motorcycle_graph_status;
  CHECK(trace(Plain_map(), 1000000) == Status::EMPTY_MAP);
  CHECK(trace(folded(net(cube(), 8, Pattern::CROSSES)), 1000000) == Status::SUCCESS);
  CHECK(trace(folded(folded_triangle({{1. / 4096, -63. / 262144}}, {{1, 1 - 3. / 524288}})), 0) == Status::INTERRUPTED);
}

// Predicates of coordinates that are rounded to multiples of a unit; they count how often they are asked.
class Coarse_traits : public CGAL::T_splines::Exact_tracing_traits<Exact> {
  using Base = CGAL::T_splines::Exact_tracing_traits<Exact>;

public:
  explicit Coarse_traits(const double unit) : m_unit(unit) {}

  CGAL::Comparison_result compare(const Coordinate& a, const Coordinate& b) const
  {
    ++m_statistics.calls;
    return CGAL::compare(rounded(a), rounded(b));
  }
  CGAL::Orientation orientation(const Point& p, const Point& q, const Point& r) const
  {
    ++m_statistics.calls;
    const double u = rounded(p.u), v = rounded(p.v);
    return CGAL::sign((rounded(q.u) - u) * (rounded(r.v) - v) - (rounded(q.v) - v) * (rounded(r.u) - u));
  }
  const CGAL::T_splines::Predicate_statistics& statistics() const { return m_statistics; }

private:
  double rounded(const Coordinate& x) const { return std::round(x.lower / m_unit) * m_unit; }

  double m_unit;
  mutable CGAL::T_splines::Predicate_statistics m_statistics;
};

TEST_CASE("The tracing traits given decide: coarse predicates lead to all that may go wrong, and it is said", "[trace]")
{
  using Status = CGAL::T_splines::Motorcycle_graph_status;
  const auto trace = [](const Plain_map& plain, const double unit) {
    const Surface_mesh mesh = test_meshes::face_graph<Surface_mesh>(plain);
    std::map<Surface_mesh::Halfedge_index, Kernel::Point_2> uv;
    put_corners(plain, mesh, boost::make_assoc_property_map(uv));
    CGAL::T_splines::Seamless_map<Surface_mesh> map(mesh);
    REQUIRE(make_exactly_seamless(mesh, boost::make_assoc_property_map(uv), map).success());
    CGAL::T_splines::T_mesh<Kernel::Point_3, double> t_mesh;
    const auto report =
        trace_motorcycle_graph(map, t_mesh, CGAL::T_splines::parameters::tracing_traits(Coarse_traits(unit)));
    CHECK(report.predicates.calls > 0);
    CHECK(report.predicates.exact_calls == 0); // the default ones have some on these maps
    CHECK(CGAL::is_empty(t_mesh.graph()) != report.success());
    CHECK(describe(report).find(message(report.status)) == 0);
    const bool is_explained =
        describe(report).find(" crossed triangles); use the exact predicates of Exact_tracing_traits") !=
        std::string::npos;
    CHECK(is_explained != report.success());
    return report.status;
  };
  const std::vector<Position> octagon = {{{1, -0.25}}, {{0.75, 0.5}}, {{0.125, 1}}, {{-0.5, 0.75}}};
  const Plain_map map = folded(subdivided(subdivided(symmetric_polygon(octagon))));
  CHECK(trace(map, 1e-12) == Status::SUCCESS);
  CHECK(trace(map, 1. / 16) == Status::NO_T_MESH);
  CHECK(trace(map, 0.1) == Status::TRACE_LOST);
  CHECK(trace(map, 0.755) == Status::TRACE_LOST); // a vertex has not as many rays as its angle says
  std::set<Status> found;                         // on a torus whose isolines spiral slowly
  for (int n = 500; n > 50; n -= 5)
    found.insert(trace(folded(scaled_torus(1.01, 4, 0, 4, 4)), 1. / n));
  CHECK(found.count(Status::TRACE_WITHOUT_END) == 1);
}

TEST_CASE("A T-mesh that is not empty is refused, and left as it was", "[trace]")
{
  using Status = CGAL::T_splines::Motorcycle_graph_status;
  const Traced traced(folded(net(cube(), 2, Pattern::CROSSES)));
  REQUIRE(traced.success());
  CGAL::T_splines::T_mesh<Kernel::Point_3, Exact> t_mesh;
  REQUIRE(trace_motorcycle_graph(traced.map, t_mesh).success());
  const auto report = trace_motorcycle_graph(traced.map, t_mesh);
  CHECK(report.status == Status::OUTPUT_NOT_EMPTY);
  CHECK(describe(report) == message(report.status));
  CHECK(num_vertices(t_mesh.graph()) == 8);
}

TEST_CASE("The checker finds what is wrong with a T-mesh", "[trace]")
{
  const Traced traced(folded(net(cube(), 2, Pattern::CROSSES)));
  REQUIRE(traced.success());
  const Exact_map map = traced.exact_map();
  const Exact_t_mesh right = traced.exact_t_mesh();
  REQUIRE(T_mesh_checker(map, right).check().success());
  const auto is_refused = [&](auto&& spoil) {
    Exact_t_mesh wrong = right;
    spoil(wrong);
    return !T_mesh_checker(map, wrong).check().success();
  };
  CHECK(is_refused([](Exact_t_mesh& t) { t.knot[3] += 1; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.knot[3] *= -1; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.is_corner[5] = 0; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.origin[0] = Exact_t_mesh::none; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.halfedge_of_face[2] = t.next[t.halfedge_of_face[2]]; })); // another frame
  CHECK(is_refused([](Exact_t_mesh& t) { t.anchor[1].triangle = (t.anchor[1].triangle + 24) % 48; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.place[7].at.first += Exact(1) / 1024; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.point[3][0] += 1e-6; }));
  CHECK(is_refused([](Exact_t_mesh& t) { t.polyline[2].erase(t.polyline[2].begin() + 1); }));
  CHECK(is_refused([](Exact_t_mesh& t) {
    for (auto& knot : t.knot)
      knot *= 2;
  }));
}

} // namespace trace_motorcycle_graph_test
