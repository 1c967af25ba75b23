// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Map_checker.h"
#include "test_meshes.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/number_type_config.h>

#include <boost/property_map/property_map.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace compute_seamless_similarity_map_test {

namespace {

namespace T = CGAL::T_splines;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;
using Status = T::Similarity_map_status;
using Numbered_cones = std::vector<std::pair<int, int>>;

/// What a visitor hears: it must be told of progress that never falls within a stage.
struct Log {
  std::vector<std::string> stages;
  double fraction = 0;
  bool is_monotone = true;
  int patience = 1000000; // how often it says that the computation may go on
};

struct Visitor {
  Log* log;

  void begin_stage(const char* name) const
  {
    log->stages.emplace_back(name);
    log->fraction = 0;
  }
  void progress(const double fraction) const
  {
    log->is_monotone = log->is_monotone && fraction >= log->fraction && fraction <= 1;
    log->fraction = fraction;
  }
  bool go_on() const { return log->patience-- > 0; }
};

/// Writes a flag per edge to both of its halfedges.
template <typename FaceGraph>
struct Cut_map {
  using key_type = typename boost::graph_traits<FaceGraph>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::writable_property_map_tag;

  const FaceGraph* mesh;
  std::map<typename boost::graph_traits<FaceGraph>::halfedge_descriptor, bool>* is_cut;

  friend void put(const Cut_map& map, const key_type e, const bool value)
  {
    const auto h = halfedge(e, *map.mesh);
    (*map.is_cut)[h] = (*map.is_cut)[opposite(h, *map.mesh)] = value;
  }
};

/// A map with everything that can be asked for along with it.
template <typename Input, typename Output>
struct Map {
  using Traits = boost::graph_traits<Output>;
  using Transition = T::Similarity_2<double>;

  Output refined;
  std::map<typename Traits::halfedge_descriptor, Kernel::Point_2> uv;
  std::map<typename Traits::vertex_descriptor, PMP::Face_location<Input, double>> location;
  std::map<typename Traits::halfedge_descriptor, bool> is_cut;
  std::map<typename Traits::halfedge_descriptor, Transition> transition;
  Log log;
  T::Similarity_map_report<Input> report;

  template <typename NamedParameters>
  void compute(const Input& mesh, const T::Holonomy_signature<Input>& signature, const NamedParameters& np)
  {
    using namespace T::parameters;
    const auto outputs = halfedge_transition_map(boost::make_assoc_property_map(transition), np.visitor(Visitor{&log}));
    report = T::compute_seamless_similarity_map(
        mesh, signature, refined, boost::make_assoc_property_map(uv),
        vertex_location_map(boost::make_assoc_property_map(location),
                            edge_is_cut_map(Cut_map<Output>{&refined, &is_cut}, outputs)));
  }
};

/// The locations must lead to the vertices' points.
template <typename Input, typename Output>
void check_locations(const Input& mesh, const Map<Input, Output>& map)
{
  double worst = 0, size = 0;
  for (const auto v : CGAL::make_range(vertices(map.refined))) {
    const auto& location = map.location.at(v);
    const auto p = get(get(CGAL::vertex_point, map.refined), v), q = PMP::construct_point(location, mesh);
    worst = std::max(worst, std::sqrt(CGAL::squared_distance(p, q)));
    size = std::max(size, std::sqrt((p - CGAL::ORIGIN).squared_length()));
    CHECK(*std::min_element(location.second.begin(), location.second.end()) >= 0);
    CHECK(std::abs(location.second[0] + location.second[1] + location.second[2] - 1) <= 1e-14);
  }
  CHECK(worst <= 1e-14 * size);
}

/// The transitions must take the uv of one side of the cut to those of the other; elsewhere there must be no seam.
template <typename Input, typename Output>
void check_transitions(const Map<Input, Output>& map)
{
  double worst = 0, size = 0;
  for (const auto h : CGAL::make_range(halfedges(map.refined))) {
    const auto g = opposite(h, map.refined);
    const auto& transition = map.transition.at(h);
    const Kernel::Point_2 here = map.uv.at(h), there = map.uv.at(prev(g, map.refined));
    if (!map.is_cut.at(h)) {
      CHECK(transition.is_identity());
      CHECK(here == there);
    }
    worst =
        std::max(worst, std::sqrt(CGAL::squared_distance(transition(here), there)) / std::max(1., transition.scale()));
    size = std::max(size, std::sqrt((here - CGAL::ORIGIN).squared_length()));
  }
  CHECK(worst <= 1e-11 * size);
}

template <typename Mesh>
T::Holonomy_signature<Mesh> signature_of(const Mesh& mesh, const Numbered_cones& cones,
                                         const std::vector<int>* turns = nullptr)
{
  const std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> all(vertices(mesh).begin(),
                                                                               vertices(mesh).end());
  std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, int>> list;
  for (const auto& cone : cones)
    list.emplace_back(all.at(cone.first), cone.second);
  T::Holonomy_signature<Mesh> signature;
  REQUIRE(T::holonomy_signature_of_cones(mesh, list, signature).success());
  if (turns)
    for (std::size_t i = 0; i < turns->size(); ++i)
      signature.set_loop_quarter_turns(i, turns->at(i));
  return signature;
}

/// What the map must be for every admissible signature that the mesh can carry.
template <typename Output = Surface_mesh, typename Input,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T::Similarity_map_report<Input> check_map_of(const Input& mesh, const T::Holonomy_signature<Input>& signature,
                                             const NamedParameters& np = CGAL::parameters::default_values())
{
  Map<Input, Output> map;
  map.compute(mesh, signature, np);
  const auto& report = map.report;
  INFO(T::message(report.status) << ", residual " << report.residual << ", " << report.iterations << " iterations, "
                                 << report.flips << " flips");
  CHECK(report.success());
  CHECK(map.log.is_monotone);
  if (report.success()) {
    CHECK(report.residual <= 1e-12);
    CHECK(report.residual == report.residual_history.back());
    CHECK(report.residual_history.size() == static_cast<std::size_t>(report.iterations) + 1);
    const Map_check check = check_map(plain_mesh(mesh), plain_map(map.refined, boost::make_assoc_property_map(map.uv)),
                                      plain_signature(mesh, signature));
    INFO(check.text());
    CHECK(check.success());
    check_locations(mesh, map);
    check_transitions(map);
  }
  return report;
}

Surface_mesh surface_mesh(const Plain_mesh& mesh)
{
  return test_meshes::face_graph<Surface_mesh>(mesh);
}

Surface_mesh demo_mesh(const std::string& name)
{
  Surface_mesh mesh;
  REQUIRE(T::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
  return mesh;
}

const Numbered_cones eight_cones = {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}, {6, 3}, {7, 3}};

} // namespace

TEST_CASE("a cube is a seamless map of itself", "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::cube(3));
  T::Holonomy_signature<Surface_mesh> signature;
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3 p = mesh.point(v);
    if (std::abs(p.x() - 0.5) == 0.5 && std::abs(p.y() - 0.5) == 0.5 && std::abs(p.z() - 0.5) == 0.5)
      signature.set_quarter_turns(v, 3);
  }
  const auto report = check_map_of(mesh, signature);
  CHECK(report.iterations == 0);
  CHECK(report.flips == 0);
}

TEST_CASE("spheres with cones", "[compute_seamless_similarity_map]")
{
  SECTION("four half turns on a regular tetrahedron")
  {
    const Surface_mesh mesh = surface_mesh(test_meshes::tetrahedron());
    CHECK(check_map_of(mesh, signature_of(mesh, {{0, 2}, {1, 2}, {2, 2}, {3, 2}})).iterations == 0);
  }
  SECTION("other cones on a tetrahedron")
  {
    const Surface_mesh mesh = surface_mesh(test_meshes::tetrahedron());
    check_map_of(mesh, signature_of(mesh, {{0, 1}, {1, 1}, {2, 3}, {3, 3}}));
  }
  SECTION("all cones positive")
  {
    const Surface_mesh mesh = surface_mesh(test_meshes::sphere(2));
    CHECK(check_map_of(mesh, signature_of(mesh, eight_cones)).iterations <= 10);
  }
  SECTION("cones of one and of eight quarter turns")
  {
    const Surface_mesh mesh = surface_mesh(test_meshes::sphere(2));
    CHECK(check_map_of(mesh, signature_of(mesh, {{0, 1}, {3, 1}, {8, 1}, {50, 3}, {70, 2}, {20, 8}})).iterations <= 10);
  }
}

TEST_CASE("a torus without cones has maps with many signatures", "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::torus(24, 16));
  for (const std::vector<int>& turns : {std::vector<int>{0, 0}, {1, 0}, {1, 2}})
    CHECK(check_map_of(mesh, signature_of(mesh, {}, &turns)).iterations <= 10);
}

TEST_CASE("signatures that no isometric seamless map has", "[compute_seamless_similarity_map]")
{
  SECTION("a torus with a pair of cones of three and five quarter turns")
  {
    const Surface_mesh mesh = surface_mesh(test_meshes::torus(24, 16));
    CHECK(check_map_of(mesh, signature_of(mesh, {{5, 3}, {200, 5}})).iterations <= 10);
  }
  SECTION("one cone with all curvature")
  {
    const int genus = GENERATE(2, 3);
    const Surface_mesh mesh = surface_mesh(test_meshes::slab_with_holes(genus, 4));
    CHECK(check_map_of(mesh, signature_of(mesh, {{7, 4 + 8 * (genus - 1)}})).iterations <= 10);
  }
}

TEST_CASE("components are mapped side by side", "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::both(test_meshes::sphere(1), test_meshes::torus(12, 9), 5));
  check_map_of(mesh, signature_of(mesh, eight_cones));
}

TEST_CASE("the map does not depend on where and how large the surface is", "[compute_seamless_similarity_map]")
{
  Plain_mesh plain = test_meshes::torus(16, 10);
  SECTION("far from the origin")
  for (auto& p : plain.points)
    p = {{p[0] + 1e7, p[1] - 1e7, p[2] + 1e7}};
  SECTION("tiny")
  for (auto& p : plain.points)
    p = {{p[0] * 1e-9, p[1] * 1e-9, p[2] * 1e-9}};
  SECTION("huge")
  for (auto& p : plain.points)
    p = {{p[0] * 1e30, p[1] * 1e30, p[2] * 1e30}};
  const Surface_mesh mesh = surface_mesh(plain);
  check_map_of(mesh, signature_of(mesh, {{5, 3}, {100, 5}}));
}

TEST_CASE("thin triangles do not spoil the map", "[compute_seamless_similarity_map]")
{
  Plain_mesh plain = test_meshes::torus(16, 10);
  for (auto& p : plain.points)
    p[2] *= 1e-4;
  const Surface_mesh mesh = surface_mesh(plain);
  check_map_of(mesh, signature_of(mesh, {{5, 3}, {100, 5}}));
}

TEST_CASE("the flip policies agree on the signature", "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::torus(24, 16));
  const auto signature = signature_of(mesh, {{5, 3}, {200, 5}});
  check_map_of(mesh, signature, T::parameters::flip_policy(T::Degeneracy_flips{GENERATE(false, true)}));
}

TEST_CASE("a wider number type", "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::torus(12, 9));
  const auto report = check_map_of(mesh, signature_of(mesh, {{5, 3}, {100, 5}}),
                                   T::parameters::number_type(0.L, T::parameters::residual_tolerance(1e-17)));
  CHECK(report.residual <= 1e-17);
  CHECK(report.mantissa_bits == std::numeric_limits<long double>::digits);
}

TEMPLATE_TEST_CASE("models of a face graph", "[compute_seamless_similarity_map]", Surface_mesh, Polyhedron,
                   Linear_cell_complex)
{
  const Plain_mesh plain = test_meshes::torus(9, 7);
  SECTION("as input")
  {
    const TestType mesh = test_meshes::face_graph<TestType>(plain);
    check_map_of<Surface_mesh>(mesh, signature_of(mesh, {{5, 3}, {50, 5}}));
  }
  SECTION("as output")
  {
    const Surface_mesh mesh = surface_mesh(plain);
    check_map_of<TestType>(mesh, signature_of(mesh, {{5, 3}, {50, 5}}));
  }
}

namespace {

// A cylinder of radius 1 whose bottom and top are fans around one vertex of the rim.
Plain_mesh fan_cylinder(const int sides, const double height)
{
  Plain_mesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * CGAL_PI * i / sides;
    for (const double z : {0., height})
      mesh.points.push_back({{std::cos(a), std::sin(a), z}});
    const int j = (i + 1) % sides;
    mesh.triangles.push_back({{2 * i, 2 * j, 2 * j + 1}});
    mesh.triangles.push_back({{2 * i, 2 * j + 1, 2 * i + 1}});
    if (i > 0 && j > 0) {
      mesh.triangles.push_back({{0, 2 * j, 2 * i}});
      mesh.triangles.push_back({{1, 2 * i + 1, 2 * j + 1}});
    }
  }
  return mesh;
}

// A cube with an additional vertex on a side, `height` above the middle of an edge of length 10.
Plain_mesh cube_with_cap(const double height)
{
  Plain_mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({{i & 1 ? 10. : 0., i & 2 ? 10. : 0., i & 4 ? 10. : 0.}});
  mesh.points.push_back({{5, 0, height}});
  mesh.triangles = {{{0, 2, 3}}, {{0, 3, 1}}, {{4, 5, 7}}, {{4, 7, 6}}, {{2, 6, 7}}, {{2, 7, 3}}, {{0, 4, 6}},
                    {{0, 6, 2}}, {{1, 3, 7}}, {{1, 7, 5}}, {{0, 5, 4}}, {{0, 8, 5}}, {{8, 1, 5}}, {{0, 1, 8}}};
  return mesh;
}

// A solver that refuses every system.
struct Failing_solver {
  using FT = double;
  using Matrix = T::Symmetric_sparse_matrix<double>;

  bool analyze_pattern(const Matrix&) { return true; }
  bool factorize(const Matrix&) { return false; }
  bool solve(const std::vector<double>&, std::vector<double>&) const { return false; }
};

// The signature of the smoothest field.
T::Holonomy_signature<Surface_mesh> signature_of_smooth_field(Surface_mesh mesh)
{
  const auto field = mesh.add_property_map<Surface_mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  T::Holonomy_signature<Surface_mesh> signature;
  REQUIRE(T::compute_smooth_cross_field(mesh, field).success());
  REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature).success());
  return signature;
}

} // namespace

TEST_CASE("where the iteration stalls in double it starts again in a wider number type",
          "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(fan_cylinder(60, 0.001));
  const auto report = check_map_of(mesh, signature_of_smooth_field(mesh));
  CHECK(report.mantissa_bits > 53);
}

TEST_CASE("nearly flat triangles are mapped, in numbers as wide as it takes", "[compute_seamless_similarity_map]")
{
  for (const double height : {1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-13}) {
    CAPTURE(height);
    const Surface_mesh mesh = surface_mesh(cube_with_cap(height));
    check_map_of(mesh, signature_of_smooth_field(mesh));
  }
}

TEST_CASE("nothing is written unless the map exists", "[compute_seamless_similarity_map]")
{
  Surface_mesh mesh = surface_mesh(test_meshes::sphere(2));
  T::Holonomy_signature<Surface_mesh> signature = signature_of(mesh, eight_cones);
  Map<Surface_mesh, Surface_mesh> map;
  const auto np = CGAL::parameters::default_values();
  SECTION("interrupted")
  {
    map.log.patience = GENERATE(0, 1, 2);
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::INTERRUPTED);
  }
  SECTION("Gauss and Bonnet disagree")
  {
    signature.set_quarter_turns(Surface_mesh::Vertex_index(9), 5);
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::INVALID_SIGNATURE);
  }
  SECTION("no quarter turn")
  {
    signature.set_quarter_turns(Surface_mesh::Vertex_index(0), 0);
    signature.set_quarter_turns(Surface_mesh::Vertex_index(1), 6);
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::INVALID_SIGNATURE);
  }
  SECTION("a hole that the signature does not have")
  {
    CGAL::Euler::remove_face(halfedge(*mesh.faces().begin(), mesh), mesh);
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::INVALID_SIGNATURE);
  }
  SECTION("a triangle without area")
  {
    const auto h = halfedge(*mesh.faces().begin(), mesh);
    mesh.point(target(h, mesh)) = mesh.point(source(h, mesh));
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::INVALID_MESH);
  }
  SECTION("too few iterations")
  {
    map.compute(mesh, signature, CGAL::parameters::number_of_iterations(1));
    CHECK(map.report.status == Status::ITERATION_LIMIT);
    CHECK(map.report.iterations == 1);
  }
  SECTION("a solver that fails")
  {
    map.compute(mesh, signature, CGAL::parameters::sparse_linear_solver(Failing_solver()));
    CHECK(map.report.status == Status::SOLVER_FAILED);
  }
  SECTION("edges of long triangles that cross too many others")
  {
    mesh = surface_mesh(fan_cylinder(800, 2));
    signature = signature_of_smooth_field(mesh);
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::SUBDIVISION_TOO_LARGE);
  }
  SECTION("a signature of another mesh")
  {
    const Surface_mesh other = surface_mesh(test_meshes::torus(3, 3));
    map.compute(other,
                signature_of(mesh, {{3, 3}, {20, 5}, {21, 3}, {22, 3}, {0, 3}, {1, 3}, {2, 3}, {4, 3}, {5, 3}, {6, 3}}),
                np);
    CHECK(map.report.status == Status::INVALID_SIGNATURE);
    CHECK(map.report.signature.status == T::Holonomy_signature_status::FOREIGN_VERTEX);
    CHECK(describe(map.report, other).find(": cone 1, counted from 0") != std::string::npos);
  }
  SECTION("a signature of the mesh before an edit")
  {
    const auto removed = signature.cones().front().first;
    CGAL::Euler::remove_center_vertex(halfedge(removed, mesh), mesh);
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    map.compute(mesh, signature, np);
    CHECK(map.report.status == Status::INVALID_SIGNATURE);
    CHECK(map.report.signature.status == T::Holonomy_signature_status::FOREIGN_VERTEX);
  }
  SECTION("a tolerance that no number type reaches")
  {
    map.compute(mesh, signature, T::parameters::residual_tolerance(1e-300));
    CHECK(map.report.status == Status::STALLED);
    CHECK(map.report.residual < 1e-30);
  }
  CHECK_FALSE(map.report.success());
  CHECK(CGAL::is_empty(map.refined));
  CHECK(map.uv.empty());
  CHECK(map.location.empty());
}

TEST_CASE("a failure names the flattest triangle, if that may be the cause", "[compute_seamless_similarity_map]")
{
  const auto failure = [](const double height) {
    const Surface_mesh mesh = surface_mesh(cube_with_cap(height));
    Map<Surface_mesh, Surface_mesh> map;
    map.compute(mesh, signature_of_smooth_field(mesh), CGAL::parameters::number_of_iterations(1));
    REQUIRE(map.report.status == Status::ITERATION_LIMIT);
    return describe(map.report, mesh);
  };
  CHECK(failure(1e-8).find("; triangle 13 is nearly flat, its height is 1e-09 of its longest side: remove it") !=
        std::string::npos);
  CHECK(failure(1).find("nearly flat") == std::string::npos);
}

TEST_CASE("an output that is not empty is refused and left as it was, be it the input",
          "[compute_seamless_similarity_map]")
{
  Surface_mesh mesh = surface_mesh(test_meshes::sphere(1));
  const T::Holonomy_signature<Surface_mesh> signature = signature_of(mesh, eight_cones);
  const auto number_of_faces = mesh.number_of_faces();
  std::map<Surface_mesh::Halfedge_index, Kernel::Point_2> uv;
  const auto uv_map = boost::make_assoc_property_map(uv);
  const auto report = T::compute_seamless_similarity_map(mesh, signature, mesh, uv_map);
  CHECK(report.status == Status::OUTPUT_NOT_EMPTY);
  CHECK(describe(report, mesh) == message(report.status));
  CHECK(mesh.number_of_faces() == number_of_faces);
  Surface_mesh refined;
  refined.remove_vertex(refined.add_vertex(Kernel::Point_3(0, 0, 0))); // new vertices would not be in order
  CHECK(T::compute_seamless_similarity_map(mesh, signature, refined, uv_map).status == Status::OUTPUT_NOT_EMPTY);
  CHECK(uv.empty());
  refined.collect_garbage();
  CHECK(T::compute_seamless_similarity_map(mesh, signature, refined, uv_map).success());
}

TEST_CASE("signatures beyond what a coarse mesh carries are told from those whose map does not fit into doubles",
          "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::torus(3, 3));
  CGAL::Random random(3);
  std::set<Status> found;
  for (int i = 0; i < 60 && found.size() < 3; ++i) {
    std::vector<int> k(9, 4);
    for (int move = 0; move < 4; ++move) {
      const int a = random.get_int(0, 9), b = random.get_int(0, 9);
      if (a != b && k[a] > 1) {
        --k[a];
        ++k[b];
      }
    }
    Numbered_cones cones;
    for (int v = 0; v < 9; ++v)
      if (k[v] != 4)
        cones.emplace_back(v, k[v]);
    const std::vector<int> turns = {random.get_int(-20, 21), random.get_int(-20, 21)};
    Map<Surface_mesh, Surface_mesh> map;
    map.compute(mesh, signature_of(mesh, cones, &turns), CGAL::parameters::default_values());
    const auto& report = map.report;
    const std::string text = describe(report, mesh);
    if (report.status == Status::SIGNATURE_OUT_OF_REACH) {
      CHECK(std::abs(report.scale_period) > 0.9 * report.hyperbolic_length);
      CHECK(std::abs(report.scale_period) < report.hyperbolic_length * (1 + 1e-9));
      CHECK(text.find("refine the mesh (residual ") != std::string::npos);
      CHECK(text.find("the short loop closest to its limit has a scale factor of exp(") != std::string::npos);
    }
    else if (report.status == Status::LAYOUT_FAILED) {
      CHECK(report.residual <= 1e-12);
      REQUIRE(report.face != Surface_mesh::null_face());
      CHECK(text.find(", face " + std::to_string(report.face.idx()) + ", counted from 0)") != std::string::npos);
    }
    else if (!report.success())
      continue;
    CHECK(CGAL::is_empty(map.refined) != report.success());
    found.insert(report.status);
  }
  CHECK(found == std::set<Status>{Status::CONVERGED, Status::SIGNATURE_OUT_OF_REACH, Status::LAYOUT_FAILED});
}

TEST_CASE("the checker finds what is wrong with a map", "[Map_checker]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::torus(12, 9));
  const auto signature = signature_of(mesh, {{5, 3}, {100, 5}});
  Map<Surface_mesh, Surface_mesh> made;
  made.compute(mesh, signature, CGAL::parameters::default_values());
  const Plain_mesh input = plain_mesh(mesh);
  const Plain_map map = plain_map(made.refined, boost::make_assoc_property_map(made.uv));
  const Plain_signature plain = plain_signature(mesh, signature);
  Plain_map other = map;
  Plain_signature other_signature = plain;
  REQUIRE(check_map(input, map, plain).success());
  REQUIRE(map.points.size() > input.points.size());
  SECTION("a vertex of the input is moved by one ulp")
  {
    other.points[3][0] = std::nextafter(other.points[3][0], 10.);
  }
  SECTION("an added vertex leaves the surface")
  {
    other.points.back()[2] += 1e-10;
  }
  SECTION("an added vertex moves on the surface, over an edge")
  {
    const std::array<double, 3> p = other.points.back(), q = other.points[0];
    other.points.back() = {{q[0], q[1], q[2]}};
    CHECK(p != q);
  }
  SECTION("a uv triangle is turned over")
  {
    std::swap(other.uv[7][0], other.uv[7][1]);
  }
  SECTION("a triangle is turned over")
  {
    std::swap(other.triangles[7][0], other.triangles[7][1]);
  }
  SECTION("a triangle is missing")
  {
    other.triangles.pop_back();
    other.uv.pop_back();
  }
  SECTION("one corner has its own uv")
  {
    other.uv[7][0][0] += 1e-4 * (other.uv[7][1][0] - other.uv[7][0][0]);
  }
  SECTION("a chart is turned by a little")
  for (auto& corner : other.uv[7])
    corner = {{corner[0] - 1e-6 * corner[1], corner[1] + 1e-6 * corner[0]}};
  SECTION("another cone")
  {
    other_signature.cones[0].second = 4;
  }
  SECTION("a cone elsewhere")
  {
    ++other_signature.cones[0].first;
  }
  SECTION("another turning number")
  {
    other_signature.loops[1].quarter_turns += GENERATE(-4, -1, 1, 4);
  }
  SECTION("a loop in the other direction, around another turning number")
  {
    other_signature.loops[0].quarter_turns = 1 - other_signature.loops[0].quarter_turns;
    std::reverse(other_signature.loops[0].halfedges.begin(), other_signature.loops[0].halfedges.end());
    for (auto& ends : other_signature.loops[0].halfedges)
      std::swap(ends[0], ends[1]);
  }
  CHECK_FALSE(check_map(input, other, other_signature).success());
}

TEST_CASE("loops are needed", "[compute_seamless_similarity_map]")
{
  const Surface_mesh mesh = surface_mesh(test_meshes::torus(12, 9));
  Map<Surface_mesh, Surface_mesh> map;
  map.compute(mesh, T::Holonomy_signature<Surface_mesh>(), CGAL::parameters::default_values());
  CHECK(map.report.status == Status::INVALID_SIGNATURE);
}

// Crossings of input edges with those of the final triangulation come closer than doubles resolve there, several in one
// place; in the second mesh, single collapses do, and others lead nowhere.
TEST_CASE("vertices of the refinement that nearly coincide become one", "[compute_seamless_similarity_map]")
{
  const std::string file = GENERATE(std::string(T_SPLINES_TEST_DATA) + "/hard_meshes/extruded_profile.off",
                                    std::string(T_SPLINES_DEMO_DATA) + "/meshes/mpi.off");
  INFO(file);
  Surface_mesh mesh;
  REQUIRE(T::read_triangle_mesh(file, mesh).success());
  const auto field = mesh.add_property_map<Surface_mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  REQUIRE(T::compute_smooth_cross_field(mesh, field).success());
  T::Holonomy_signature<Surface_mesh> signature;
  REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature).success());
  REQUIRE(T::reduce_cones(mesh, signature).success());
  check_map_of(mesh, signature);
}

TEST_CASE("real meshes with smooth cross fields", "[compute_seamless_similarity_map]")
{
  const std::string name = GENERATE("elephant.off", "anchor.off", "bones.off", "handle.off", "cow.off", "knot1.off",
                                    "couplingdown.off", "refined_elephant.off");
  INFO(name);
  Surface_mesh mesh = demo_mesh(name);
  const auto field = mesh.add_property_map<Surface_mesh::Face_index, Kernel::Vector_3>("f:cross").first;
  REQUIRE(T::compute_smooth_cross_field(mesh, field).success());
  T::Holonomy_signature<Surface_mesh> signature;
  REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature).success());
  CHECK(check_map_of(mesh, signature).iterations <= 10);
}

} // namespace compute_seamless_similarity_map_test
