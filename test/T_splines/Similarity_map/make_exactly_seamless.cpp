// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Seamless_map_checker.h"
#include "chart_maps.h"
#include "test_meshes.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace make_exactly_seamless_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Status = T::Exact_map_status;
using chart_maps::Chart_map;

/// A mesh with its uv and the exact map made of them.
template <typename Mesh, typename FT = CGAL::Exact_rational>
struct Made {
  Mesh mesh;
  std::map<typename boost::graph_traits<Mesh>::halfedge_descriptor, Kernel::Point_2> uv;
  T::Seamless_map<Mesh, FT> map;
  T::Exact_map_report<Mesh> report;

  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Made(const Plain_map& plain, const NamedParameters& np = CGAL::parameters::default_values())
    : mesh(test_meshes::face_graph<Mesh>(plain)),
      uv(corners(mesh, plain)),
      map(mesh),
      report(T::make_exactly_seamless(mesh, boost::make_assoc_property_map(uv), map, np))
  {
  }

  static auto corners(const Mesh& mesh, const Plain_map& plain)
  {
    std::map<typename boost::graph_traits<Mesh>::halfedge_descriptor, Kernel::Point_2> result;
    const auto number = vertex_numbers(mesh);
    for_each_corner(mesh, [&](const std::size_t t, std::size_t, const auto h) {
      for (int i = 0; i < 3; ++i)
        if (plain.triangles[t][i] == number.at(target(h, mesh)))
          result[h] = Kernel::Point_2(plain.uv[t][i][0], plain.uv[t][i][1]);
    });
    return result;
  }
};

/// A border edge must be exactly parallel to an axis.
template <typename Mesh, typename FT>
int number_of_oblique_border_edges(const Made<Mesh, FT>& made)
{
  int result = 0;
  for (const auto h : CGAL::make_range(halfedges(made.mesh)))
    if (!is_border(h, made.mesh) && is_border(opposite(h, made.mesh), made.mesh)) {
      const auto p = made.map.uv(h), q = made.map.uv(prev(h, made.mesh));
      result += p.first != q.first && p.second != q.second;
    }
  return result;
}

/// Judges the map in exact arithmetic. \param tolerance how far corners may move, by their triangle's longest side
template <typename Mesh>
void check_exact(const Made<Mesh>& made, const double tolerance = 0.125)
{
  INFO(T::message(made.report.status) << ", deviation " << made.report.deviation
                                      << ", vertex/halfedge/faces: " << made.report.faces.size());
  REQUIRE(made.report.success());
  const Exact_map map = exact_map(made.map);
  Seamless_map_checker checker(map);
  checker.check();
  const auto uv = boost::make_assoc_property_map(
      const_cast<std::map<typename boost::graph_traits<Mesh>::halfedge_descriptor, Kernel::Point_2>&>(made.uv));
  const Seamless_map_check result = checker.check_deviation(given_corners(made.mesh, uv), tolerance);
  INFO(result.text());
  CHECK(result.success());
  CHECK(number_of_oblique_border_edges(made) == 0);
  CHECK(made.report.faces.empty());
  CHECK(made.report.number_of_cut_edges == result.cut_edges);
  CHECK((made.report.scale_bits == 0) == made.report.is_isometric);
  if (made.report.is_isometric)
    CHECK(result.scaled_edges == 0);
}

/// A refused map leaves nothing behind.
template <typename Mesh, typename FT>
void check_refused(const Made<Mesh, FT>& made, const Status status)
{
  INFO(T::message(made.report.status));
  CHECK(made.report.status == status);
  CHECK(describe(made.report, made.mesh).find(T::message(status)) == 0);
  CHECK(made.map.layout().mesh().number_of_faces() == 0);
}

Chart_map cube_map(const int n)
{
  return chart_maps::planes_as_charts(test_meshes::cube(n), n);
}

/// A plate with two bumps, one of them moved sideways by `offset`; `n` units of uv are one of space, and an integer.
/// With slivers, each triangle at the foot of a bump has a vertex right beside the bump's corner.
Chart_map bumps(const double offset, const int n, const bool has_slivers)
{
  std::set<std::array<int, 3>> cubes = {{{1, 1, 1}}, {{5, 1, 1}}};
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 3; ++y)
      cubes.insert({{x, y, 0}});
  Plain_mesh mesh = test_meshes::voxel_surface(cubes, 1);
  std::vector<char> is_foot;
  for (auto& p : mesh.points) {
    const bool is_moved = p[0] >= 5 && p[0] <= 6 && p[1] >= 1 && p[1] <= 2 && p[2] >= 1;
    is_foot.push_back(p[2] == 1 && p[1] >= 1 && p[1] <= 2 && (p[0] == 1 || p[0] == 2 || is_moved));
    p[1] += is_moved ? offset : 0;
  }
  const std::size_t number_of_triangles = has_slivers ? mesh.triangles.size() : 0;
  for (std::size_t t = 0; t < number_of_triangles; ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3], c = mesh.triangles[t][(i + 2) % 3];
      if (a >= static_cast<int>(is_foot.size()) || !is_foot[a] || mesh.points[b][2] != 1 || mesh.points[c][2] != 1)
        continue;
      std::array<double, 3> p = mesh.points[a];
      for (int axis = 0; axis < 3; ++axis)
        p[axis] += (mesh.points[b][axis] + mesh.points[c][axis] - 2 * p[axis]) / n;
      const int w = static_cast<int>(mesh.points.size());
      mesh.points.push_back(p);
      mesh.triangles[t] = {{a, b, w}};
      mesh.triangles.insert(mesh.triangles.end(), {{{b, c, w}}, {{c, a, w}}});
      break;
    }
  return chart_maps::planes_as_charts(mesh, n);
}

const auto no_hole = [](int, int) { return false; };
const auto plane = [](const int i, const int j) { return std::array<double, 2>{{double(i), double(j)}}; };

} // namespace

TEMPLATE_TEST_CASE("integer grid maps become exact as they are", "[make_exactly_seamless]", Surface_mesh, Polyhedron)
{
  const Plain_mesh mesh = GENERATE(test_meshes::cube(1), test_meshes::cube(3), test_meshes::slab_with_holes(1, 1),
                                   test_meshes::slab_with_holes(3, 2),
                                   test_meshes::voxel_surface({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, 2));
  const Made<TestType> made(chart_maps::planes_as_charts(mesh, 6));
  check_exact(made, 0);
  CHECK(made.report.is_isometric);
  CHECK(made.report.number_of_determined_corners == 0);
  CHECK(made.report.largest_displacement == 0);
  CHECK(made.report.deviation == 0);
}

TEST_CASE("turned and moved charts: all scale factors are exactly 1", "[make_exactly_seamless]")
{
  CGAL::Random random(GENERATE(1, 2, 3));
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(2, 2), 2);
  map.transform_all([](const double x, const double y) { return std::array<double, 2>{{x / 7, y / 7}}; });
  chart_maps::change_frames(map, false, random);
  const Made<Surface_mesh> made(map);
  check_exact(made, 1e-6);
  CHECK(made.report.is_isometric);
  CHECK(made.report.deviation > 0);
}

TEST_CASE("scaled charts", "[make_exactly_seamless]")
{
  CGAL::Random random(GENERATE(1, 2, 3));
  const int n = GENERATE(1, 2, 9, 32);
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, n), n);
  chart_maps::change_frames(map, true, random);
  const Made<Surface_mesh> made(map);
  check_exact(made);
  CHECK_FALSE(made.report.is_isometric);
  CHECK(made.report.scale_bits >= 8);
  CHECK(made.report.scale_bits <= 24);
}

TEST_CASE("noise on the coordinates below the tolerance is removed, above it refused", "[make_exactly_seamless]")
{
  CGAL::Random random(1);
  const double noise = GENERATE(1e-14, 1e-11, 1e-8, 1e-4);
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(1, 3), 3);
  chart_maps::change_frames(map, false, random);
  chart_maps::add_noise(map, noise, random);
  const Made<Surface_mesh> made(map);
  if (noise < 1e-6) {
    check_exact(made, 100 * noise + 1e-6);
    CHECK(made.report.is_isometric);
  }
  else
    CHECK_FALSE(made.report.success());
}

TEST_CASE("tori with a scale factor: one closed seam", "[make_exactly_seamless]")
{
  const double s = GENERATE(2., 1.5, 2.718281828);
  INFO("scale factor " << s);
  const Made<Surface_mesh> made(chart_maps::hopf_torus(s, 16, 6));
  check_exact(made);
  CHECK_FALSE(made.report.is_isometric);
  CHECK(made.report.number_of_branches == 1);
  CHECK(made.report.number_of_cones == 0);
}

TEST_CASE("a torus whose scale factor is close to 1 keeps it", "[make_exactly_seamless]")
{
  const double s = 1 + std::ldexp(1., -20);
  const Made<Surface_mesh> made(chart_maps::hopf_torus(s, 12, 12));
  REQUIRE(made.report.success());
  CHECK_FALSE(made.report.is_isometric);
  bool has_scale = false;
  for (const auto h : made.mesh.halfedges())
    has_scale = has_scale || std::abs(CGAL::to_double(made.map.transition(h).scale()) / s - 1) < 1e-8;
  CHECK(has_scale);
}

TEST_CASE("faces with corners of their own, rounded, are welded", "[make_exactly_seamless]")
{
  CGAL::Random random(1);
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(2, 4), 4);
  chart_maps::change_frames(map, false, random);
  for (auto& triangle : map.uv)
    for (auto& p : triangle)
      for (double& x : p)
        x += random.get_double(-1e-7, 1e-7);
  const Made<Surface_mesh> made(map);
  check_exact(made, 1e-5);
  CHECK(made.report.is_isometric);
  CHECK(made.report.number_of_cut_edges < static_cast<int>(num_edges(made.mesh)) / 2);
}

TEST_CASE("a seam through the fixed point of its transition", "[make_exactly_seamless]")
{
  // Near the fixed point the coordinates on both sides agree within the tolerance, farther away they do not.
  const int n = 12;
  Chart_map map = cube_map(n);
  const double s = 1 + GENERATE(1e-7, 1e-6, 2e-6, 5e-6, 1e-5, 1e-3);
  // Unrolls a second chart to continue the first: what they share then agrees up to the factor.
  const Made<Surface_mesh> flat(map);
  int from = -1;
  for (const auto h : flat.mesh.halfedges())
    if (flat.map.is_cut(flat.mesh.edge(h)) && from == -1)
      from = static_cast<int>(h.idx());
  REQUIRE(from >= 0);
  const Surface_mesh::Halfedge_index h(from), g = flat.mesh.opposite(h);
  const auto transition = flat.map.transition(g); // from the chart beyond h to that of h
  const auto middle = flat.uv.at(h);
  map.transform(map.chart[flat.mesh.face(g).idx()], [&](const double x, const double y) {
    const auto p = transition(Exact(x), Exact(y));
    const double u = CGAL::to_double(p.first), v = CGAL::to_double(p.second);
    return std::array<double, 2>{{middle.x() + s * (u - middle.x()), middle.y() + s * (v - middle.y())}};
  });
  const Made<Surface_mesh> made(map);
  check_exact(made);
}

TEST_CASE("maps of this package", "[make_exactly_seamless]")
{
  using Signature = T::Holonomy_signature<Surface_mesh>;
  Surface_mesh mesh, refined;
  Signature signature;
  const auto from_field = [&] {
    const auto field = mesh.add_property_map<Surface_mesh::Face_index, Kernel::Vector_3>("f:cross").first;
    REQUIRE(T::compute_smooth_cross_field(mesh, field).success());
    REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature).success());
  };
  SECTION("a real mesh")
  {
    const std::string name =
        GENERATE("elephant.off", "anchor.off", "bones.off", "handle.off", "cow.off", "knot1.off", "couplingdown.off");
    REQUIRE(T::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
    from_field();
  }
  SECTION("holes")
  {
    mesh = test_meshes::face_graph<Surface_mesh>(test_meshes::slab_with_holes(3, 3));
    from_field();
  }
  SECTION("a torus with two cones: no isometric map exists")
  {
    mesh = test_meshes::face_graph<Surface_mesh>(test_meshes::torus(24, 12));
    REQUIRE(
        T::holonomy_signature_of_cones(mesh,
                                       std::vector<std::pair<Surface_mesh::Vertex_index, int>>{
                                           {Surface_mesh::Vertex_index(3), 3}, {Surface_mesh::Vertex_index(150), 5}},
                                       signature)
            .success());
  }
  SECTION("cones of many kinds")
  {
    mesh = test_meshes::face_graph<Surface_mesh>(test_meshes::sphere(3));
    std::vector<std::pair<Surface_mesh::Vertex_index, int>> cones;
    const int k[] = {1, 2, 8, 3, 3, 2, 1, 5, 3, 2, 3, 7}; // 4 - k sums to 8
    for (int v = 0; v < 12; ++v)
      cones.emplace_back(Surface_mesh::Vertex_index(v), k[v]);
    REQUIRE(T::holonomy_signature_of_cones(mesh, cones, signature).success());
  }
  const auto uv = refined.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  REQUIRE(T::compute_seamless_similarity_map(mesh, signature, refined, uv).success());
  T::Seamless_map<Surface_mesh> map(refined);
  const auto report = T::make_exactly_seamless(refined, uv, map);
  REQUIRE(report.success());
  const Exact_map exact = exact_map(map);
  Seamless_map_checker checker(exact);
  checker.check();
  checker.check_deviation(given_corners(refined, uv), 0.125);
  std::vector<std::pair<int, int>> cones;
  for (const auto& cone : signature.cones())
    cones.emplace_back(static_cast<int>(cone.first.idx()), cone.second);
  const Seamless_map_check result = checker.check_cones(cones);
  INFO(result.text());
  CHECK(result.success());
  CHECK(report.deviation <= 1e-11);
  // The same once more, bit by bit.
  T::Seamless_map<Surface_mesh> again(refined);
  REQUIRE(T::make_exactly_seamless(refined, uv, again).success());
  bool is_same = true;
  for (const auto h : refined.halfedges())
    is_same = is_same && again.uv(h) == map.uv(h) && again.transition(h) == map.transition(h);
  CHECK(is_same);
}

TEST_CASE("the same in round-off", "[make_exactly_seamless]")
{
  CGAL::Random random(1);
  Chart_map map = chart_maps::planes_as_charts(test_meshes::slab_with_holes(2, 4), 4);
  chart_maps::change_frames(map, true, random);
  const Made<Surface_mesh, double> made(map);
  REQUIRE(made.report.success());
  CHECK(made.report.number_of_determined_corners == 0);
  double worst = 0;
  for (const auto h : made.mesh.halfedges()) {
    const auto here = made.map.uv(h), there = made.map.uv(made.mesh.prev(made.mesh.opposite(h)));
    const auto image = made.map.transition(h)(here.first, here.second);
    worst = std::max({worst, std::abs(image.first - there.first), std::abs(image.second - there.second)});
  }
  CHECK(worst > 0);
  CHECK(worst < 1e-10);
}

TEST_CASE("borders become straight", "[make_exactly_seamless]")
{
  CGAL::Random random(1);
  const double noise = GENERATE(0., 1e-13, 1e-9);
  Chart_map map;
  int cones = 0;
  SECTION("a square")
  {
    map = chart_maps::grid(5, 5, false, no_hole, plane);
    cones = 4;
  }
  SECTION("a square with a square hole")
  {
    map = chart_maps::grid(
        5, 5, false, [](const int i, const int j) { return i == 2 && j == 3; }, plane);
    cones = 8;
  }
  SECTION("a strip closed by a translation")
  {
    map = chart_maps::grid(7, 3, true, no_hole, plane);
  }
  SECTION("a strip closed by a rotation and a translation, cut in the middle")
  {
    map = chart_maps::grid(7, 3, true, no_hole, plane);
    for (std::size_t t = 0; t < map.chart.size(); ++t)
      map.chart[t] = (t / 2) % 7 >= 4;
    map.number_of_charts = 2;
    map.transform(1, [](const double x, const double y) { return std::array<double, 2>{{0.1 - y, x + 0.3}}; });
  }
  SECTION("a strip closed by a translation, with a hole on the cut")
  {
    map = chart_maps::grid(
        7, 5, true, [](const int i, const int j) { return (i == 0 || i == 6) && j == 2; }, plane);
    cones = 4;
  }
  SECTION("half a ring closed by a similarity")
  {
    // Between the two halves of the first axis through the center.
    const double pi = 4 * std::atan(1.);
    map = chart_maps::grid(6, 9, true, no_hole, [pi](const int i, const int j) {
      const double r = std::pow(1.7, i / 6.), angle = pi * j / 9;
      return std::array<double, 2>{{0.3 + r * std::cos(angle), 0.7 + r * std::sin(angle)}};
    });
  }
  SECTION("trousers: three straight borders, and a cone around which nothing turns")
  {
    map = chart_maps::trousers(5);
    for (int c = 0; c < 3; ++c)
      map.transform(c, [c](const double x, const double y) { return std::array<double, 2>{{x + c / 3., y - c / 9.}}; });
    cones = 1;
  }
  SECTION("trousers, their legs turned")
  {
    map = chart_maps::trousers(5);
    map.transform(1, [](const double x, const double y) { return std::array<double, 2>{{0.1 - y, x}}; });
    map.transform(2, [](const double x, const double y) { return std::array<double, 2>{{0.3 - 1.7 * x, -1.7 * y}}; });
    cones = 1;
  }
  chart_maps::add_noise(map, noise, random);
  const Made<Surface_mesh> made(map);
  check_exact(made, 1. / 64);
  CHECK(made.report.number_of_cones == cones);
  CHECK(Made<Surface_mesh, double>(map).report.success());
}

TEST_CASE("isolines that miss a cone by little are made to run into it, unless triangles are in the way",
          "[make_exactly_seamless]")
{
  const int n = 1 << 22;
  const auto np = T::parameters::transition_tolerance(1e-9); // the offset is no noise
  const Made<Surface_mesh> ideal(bumps(0, n, false), np);
  check_exact(ideal, 0);
  const int lines = ideal.report.number_of_joined_lines;
  CHECK(lines > 24); // the edges of the plate and of the bumps, and what lies between these
  SECTION("a millionth of a triangle")
  {
    const Made<Surface_mesh> made(bumps(std::ldexp(1., -18), n, false), np);
    check_exact(made, 1e-5);
    CHECK(made.report.number_of_joined_lines == lines);
    CHECK(made.report.number_of_lines_left_apart == 0);
    CHECK(made.report.largest_gap > 1e-6);
    CHECK(made.report.largest_gap < T::internal::coincidence_tolerance);
    CHECK(made.report.largest_displacement > 1e-7);
  }
  SECTION("a thousandth of a triangle is no coincidence")
  {
    const Made<Surface_mesh> made(bumps(std::ldexp(1., -10), n, false), np);
    check_exact(made, 0);
    CHECK(made.report.largest_displacement == 0);
    CHECK(made.report.number_of_lines_left_apart == 0);
  }
  SECTION("triangles in the way")
  {
    CHECK(Made<Surface_mesh>(bumps(0, n, true), np).report.number_of_joined_lines == lines);
    const Made<Surface_mesh> made(bumps(std::ldexp(1., -18), n, true), np);
    check_exact(made, 0);
    CHECK(made.report.number_of_joined_lines + made.report.number_of_lines_left_apart == lines);
    CHECK(made.report.number_of_lines_left_apart > 0);
    CHECK(made.report.largest_gap == 0);
  }
}

TEST_CASE("a border whose factor is nearly 1 keeps its line", "[make_exactly_seamless]")
{
  // With few bits, the factors of the half rings are equal, and the third border would be closed by a translation.
  for (const double a : {1.5, 1.7, 2.}) {
    for (const double difference : {0., 1e-7, 1e-5, 1e-3, 0.1}) {
      CAPTURE(a, difference);
      const Made<Surface_mesh> made(chart_maps::two_half_rings(a, a * (1 + difference)));
      check_exact(made, 0.25);
      CHECK(made.report.number_of_cones == 2);
    }
  }
}

TEST_CASE("two borders that only a triangle without area could keep straight are refused", "[make_exactly_seamless]")
{
  // A strip closed by a similarity that keeps no more than one of the lines on which its borders nearly lie.
  const double factor = 1 + 3e-7;
  const Made<Surface_mesh> made(chart_maps::grid(7, 3, true, no_hole, [factor](const int i, const int j) {
    const double scale = std::pow(factor, i / 7.);
    return std::array<double, 2>{{i * scale, (j - 1) * scale}};
  }));
  check_refused(made, Status::ORIENTATION_LOST);
  REQUIRE(made.report.faces.size() >= 14);
  CHECK(made.report.faces.front() == Surface_mesh::Face_index(0));
  const std::string text = describe(made.report, made.mesh);
  CHECK(text.find("without flipping a triangle: " + std::to_string(made.report.faces.size()) + " faces, 0 1 2") !=
        std::string::npos);
}

TEST_CASE("a map made on another mesh, or before its mesh was changed, is refused and not written",
          "[make_exactly_seamless]")
{
  const Chart_map map = cube_map(2);
  Made<Surface_mesh> made(map), other(map);
  REQUIRE(made.report.success());
  const auto uv = boost::make_assoc_property_map(made.uv);
  CHECK(T::make_exactly_seamless(made.mesh, uv, other.map).status == Status::MAP_OF_OTHER_MESH);
  made.mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  const auto report = T::make_exactly_seamless(made.mesh, uv, made.map);
  CHECK(report.status == Status::MAP_OF_OTHER_MESH);
  CHECK(describe(report, made.mesh) == message(report.status));
}

TEST_CASE("oblique borders are refused", "[make_exactly_seamless]")
{
  const double angle = GENERATE(1e-3, 0.3);
  const Chart_map map = chart_maps::grid(4, 4, false, no_hole, [angle](const int i, const int j) {
    return std::array<double, 2>{
        {i * std::cos(angle) - j * std::sin(angle), i * std::sin(angle) + j * std::cos(angle)}};
  });
  const Made<Surface_mesh> made(map);
  check_refused(made, Status::BORDER_NOT_ALIGNED);
  REQUIRE(made.report.halfedge != Surface_mesh::null_halfedge());
  CHECK(made.mesh.is_border(made.mesh.edge(made.report.halfedge)));
  CHECK(made.report.deviation == Approx(angle));
}

TEST_CASE("bad maps are refused and the element is named", "[make_exactly_seamless]")
{
  const int n = 4;
  Chart_map map = cube_map(n);
  SECTION("not a number")
  {
    const double bad = GENERATE(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
    map.uv[17][1][0] = bad;
    const Made<Surface_mesh> made(map);
    check_refused(made, Status::NON_FINITE_UV);
    REQUIRE(made.report.halfedge != Surface_mesh::null_halfedge());
    CHECK(made.mesh.face(made.report.halfedge).idx() == 17);
  }
  SECTION("flipped and degenerate triangles: all are listed")
  {
    std::swap(map.uv[3][0], map.uv[3][1]);
    map.uv[50][2] = map.uv[50][1];
    std::swap(map.uv[77][1], map.uv[77][2]);
    const Made<Surface_mesh> made(map);
    check_refused(made, Status::FLIPPED_TRIANGLES);
    CHECK(made.report.faces == std::vector<Surface_mesh::Face_index>{Surface_mesh::Face_index(3),
                                                                     Surface_mesh::Face_index(50),
                                                                     Surface_mesh::Face_index(77)});
  }
  SECTION("degenerate by one bit")
  {
    // 0.3 and three times 0.1 differ in the last bit, 0.5 and twice 0.25 do not.
    const bool is_degenerate = GENERATE(true, false);
    const double x = is_degenerate ? 0.5 : 0.3, y = is_degenerate ? 0.25 : 0.1;
    map.uv[5] = {{{{0, 0}}, {{1, y}}, {{is_degenerate ? 2. : 3., x}}}};
    const Made<Surface_mesh> made(map);
    if (is_degenerate) {
      check_refused(made, Status::DEGENERATE_TRIANGLES);
      CHECK(made.report.faces == std::vector<Surface_mesh::Face_index>{Surface_mesh::Face_index(5)});
    }
    else
      CHECK(made.report.status != Status::DEGENERATE_TRIANGLES);
  }
  SECTION("a sheared chart: the cone angles are off")
  {
    map.transform(2, [](const double x, const double y) { return std::array<double, 2>{{x + 0.2 * y, y}}; });
    const Made<Surface_mesh> made(map);
    check_refused(made, Status::CONE_ANGLE);
    REQUIRE(made.report.vertex != Surface_mesh::null_vertex());
    const auto p = made.mesh.point(made.report.vertex); // a corner of the cube
    for (int axis = 0; axis < 3; ++axis)
      CHECK((p[axis] == 0 || p[axis] == 1));
    CHECK(made.report.deviation == Approx(std::atan(0.2)));
  }
  SECTION("a cone of 100 degrees")
  {
    // A circular sector closed up: a disk of straight sides around the cone, its own border elsewhere.
    const double degree = std::atan(1.) / 45;
    Chart_map disk;
    disk.points = {{{0, 0, 1}}};
    for (int i = 0; i < 5; ++i)
      disk.points.push_back({{std::cos(72 * degree * i), std::sin(72 * degree * i), 0}});
    disk.points.push_back({{0, 0, -1}});
    for (int i = 0; i < 5; ++i) {
      const auto at = [&](const int k) {
        return std::array<double, 2>{{std::cos(20 * degree * k), std::sin(20 * degree * k)}};
      };
      disk.triangles.push_back({{0, 1 + i, 1 + (i + 1) % 5}});
      disk.uv.push_back({{{{0, 0}}, at(i), at(i + 1)}});
      disk.triangles.push_back({{6, 1 + (i + 1) % 5, 1 + i}});
      disk.uv.push_back({{{{9, 9}}, {{9 + at(i + 1)[1], 9 + at(i + 1)[0]}}, {{9 + at(i)[1], 9 + at(i)[0]}}}});
    }
    const Made<Surface_mesh> made(disk);
    check_refused(made, Status::CONE_ANGLE);
    REQUIRE(made.report.vertex != Surface_mesh::null_vertex());
    CHECK(made.report.deviation == Approx(10 * degree));
  }
  SECTION("a turned chart: no rotation by quarter turns")
  {
    const double angle = GENERATE(1e-4, 0.01, 0.3);
    map.transform(4, [angle](const double x, const double y) {
      return std::array<double, 2>{
          {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)}};
    });
    const Made<Surface_mesh> made(map);
    check_refused(made, Status::TRANSITION_ROTATION);
    REQUIRE(made.report.halfedge != Surface_mesh::null_halfedge());
    const int here = map.chart[made.mesh.face(made.report.halfedge).idx()],
              there = map.chart[made.mesh.face(made.mesh.opposite(made.report.halfedge)).idx()];
    CHECK((here == 4) != (there == 4));
    CHECK(made.report.deviation == Approx(angle));
  }
  SECTION("a branch that is bent: no similarity")
  {
    // The vertices along the sides move towards one end; angles of a right angle at the corners stay.
    map.transform(1, [](const double x, const double y) {
      return std::array<double, 2>{{x + 0.02 * x * (4 - x), y + 0.02 * y * (4 - y)}};
    });
    const Made<Surface_mesh> made(map);
    check_refused(made, Status::TRANSITION_NOT_SIMILAR);
    REQUIRE(made.report.halfedge != Surface_mesh::null_halfedge());
    CHECK(made.report.deviation > 1e-3);
  }
  SECTION("rectangles that do not fit together")
  {
    map.transform(0, [](const double x, const double y) { return std::array<double, 2>{{1.01 * x, y}}; });
    const Made<Surface_mesh> made(map);
    check_refused(made, Status::SCALE_PRODUCT);
    REQUIRE(made.report.vertex != Surface_mesh::null_vertex());
    CHECK(made.report.deviation == Approx(0.01).epsilon(0.02));
  }
  SECTION("a tolerance makes bad maps good")
  {
    map.transform(4, [](const double x, const double y) {
      return std::array<double, 2>{{x - 1e-5 * y, y + 1e-5 * x}};
    });
    CHECK(Made<Surface_mesh>(map).report.status == Status::TRANSITION_ROTATION);
    check_exact(Made<Surface_mesh>(map, T::parameters::transition_tolerance(1e-4)), 1e-3);
  }
}

TEST_CASE("what is not a closed triangle mesh is refused", "[make_exactly_seamless]")
{
  Surface_mesh mesh;
  const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  SECTION("no face")
  {
    T::Seamless_map<Surface_mesh> map(mesh);
    const auto report = T::make_exactly_seamless(mesh, uv, map);
    CHECK(report.status == Status::INVALID_MESH);
    CHECK(report.mesh.status == T::Triangle_mesh_status::EMPTY);
  }
  SECTION("a quadrilateral")
  {
    std::vector<Surface_mesh::Vertex_index> v;
    for (int i = 0; i < 4; ++i)
      v.push_back(mesh.add_vertex(Kernel::Point_3(i, i * i, 0)));
    const auto f = mesh.add_face(v);
    T::Seamless_map<Surface_mesh> map(mesh);
    const auto report = T::make_exactly_seamless(mesh, uv, map);
    CHECK(report.status == Status::INVALID_MESH);
    CHECK(report.mesh.status == T::Triangle_mesh_status::NOT_TRIANGULATED);
    CHECK(report.mesh.face == f);
  }
}

} // namespace make_exactly_seamless_test
