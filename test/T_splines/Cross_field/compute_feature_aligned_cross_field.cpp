// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_feature_alignment.h>
#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_feature_aligned_cross_field.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include "Counting_visitor.h"
#include "feature_meshes.h"
#include "open_meshes.h"
#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace compute_feature_aligned_cross_field_test {

namespace ts = CGAL::T_splines;
namespace fm = feature_meshes;
using Status = ts::Feature_aligned_field_status;
using Mesh = test::Surface_mesh;
using Halfedge = Mesh::Halfedge_index;
using Marks = Mesh::Property_map<Mesh::Edge_index, bool>;
using Report = ts::Feature_aligned_field_report<Mesh>;
using Vector_3 = test::Vector_3;

namespace {

Marks marks_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
}

// A mesh that is refined at its features, with its field and what belongs to it.
struct Scene {
  Mesh mesh;
  Marks features = marks_of(mesh);
  Mesh::Property_map<Mesh::Face_index, Vector_3> field =
      mesh.add_property_map<Mesh::Face_index, Vector_3>("f:field", Vector_3(7, 7, 7)).first;
  Mesh::Property_map<Halfedge, int> matching = mesh.add_property_map<Halfedge, int>("h:matching", 77).first,
                                    turns = mesh.add_property_map<Halfedge, int>("h:turns", 77).first;

  Scene(const Mesh& given, const Marks& given_features)
  {
    REQUIRE(ts::refine_at_features(given, given_features, mesh, features).success());
  }
  Scene(const Scene&) = delete;

  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Report compute(const NamedParameters& np = CGAL::parameters::default_values())
  {
    return ts::compute_feature_aligned_cross_field(
        mesh, features, field, ts::parameters::halfedge_sector_turns_map(turns, np_with_matching(np)));
  }

  template <typename NamedParameters>
  auto np_with_matching(const NamedParameters& np)
  {
    return ts::parameters::halfedge_matching_map(matching, np);
  }

  bool bounds(const Halfedge h) const { return features[edge(h, mesh)] || mesh.is_border(edge(h, mesh)); }

  Vector_3 vector(const Halfedge h) const { return mesh.point(target(h, mesh)) - mesh.point(source(h, mesh)); }

  Vector_3 normal(const Mesh::Face_index f) const
  {
    const Halfedge h = halfedge(f, mesh);
    const Vector_3 n = CGAL::cross_product(vector(h), vector(next(h, mesh)));
    return n / std::sqrt(n.squared_length());
  }

  // The direction of the cross of `f` that is `m` quarter turns counter-clockwise of the one that is stored.
  Vector_3 direction(const Mesh::Face_index f, const int m) const
  {
    const Vector_3 d = field[f], e = CGAL::cross_product(normal(f), d);
    return std::vector<Vector_3>{d, e, -d, -e}[static_cast<std::size_t>((m % 4 + 4) % 4)];
  }

  // How many quarter turns a direction of the cross is clockwise of a halfedge with a feature, 0 to 3.
  int quarter_turns_to(const Mesh::Face_index f, const int m, const Vector_3& v) const
  {
    const Vector_3 d = direction(f, m);
    const double angle = std::atan2(CGAL::cross_product(d, v) * normal(f), d * v);
    const double turns = angle / (CGAL_PI / 2);
    CHECK(std::abs(turns - std::round(turns)) < 1e-9);
    return (static_cast<int>(std::lround(turns)) % 4 + 4) % 4;
  }

  // Carries the direction along `first` to the end of its sector; how many quarter turns the end is away, modulo 4.
  int carried_turns(const Halfedge first) const
  {
    Mesh::Face_index f = face(first, mesh);
    int m = quarter_turns_to(f, 0, vector(first));
    for (Halfedge h = first;;) {
      h = opposite(prev(h, mesh), mesh);
      if (bounds(h))
        return quarter_turns_to(f, m, vector(h));
      // The direction m in the face of opposite(h) corresponds to m + matching(h) in that of h, by any halfedge.
      m += matching[h];
      f = face(h, mesh);
    }
  }
};

// Checks all that is promised of a field. `has_exact_border`: whether the border is straight between its corners.
void check_field(Scene& scene, const Report& report, const bool has_exact_border = true)
{
  Mesh& mesh = scene.mesh;
  REQUIRE(report.success());
  double worst = 0;
  for (const auto h : mesh.halfedges())
    if (scene.features[edge(h, mesh)]) {
      const Vector_3 d = scene.field[face(h, mesh)], v = scene.vector(h) / std::sqrt(scene.vector(h).squared_length());
      worst = (std::max)(worst, (std::min)(std::abs(d * v), std::sqrt(CGAL::cross_product(d, v).squared_length())));
    }
  CHECK(worst < 1e-12);
  ts::Holonomy_signature<Mesh> signature;
  const auto np = scene.np_with_matching(CGAL::parameters::default_values());
  const auto signature_report = ts::holonomy_signature_of_cross_field(mesh, scene.field, signature, np);
  CAPTURE(describe(signature_report, mesh));
  REQUIRE(signature_report.success());
  CHECK(ts::check_holonomy_signature(mesh, signature).success());
  CHECK(static_cast<int>(signature.cones().size()) == report.number_of_singularities);
  std::vector<int> sum(mesh.number_of_vertices(), 0);
  std::vector<char> has_feature(mesh.number_of_vertices(), 0);
  int least = 1;
  bool is_carried = true;
  for (const auto h : mesh.halfedges()) {
    if (!scene.bounds(h) || mesh.is_border(h)) {
      CHECK(scene.turns[h] == 0);
      continue;
    }
    least = (std::min)(least, scene.turns[h]);
    sum[source(h, mesh).idx()] += scene.turns[h];
    if (!mesh.is_border(edge(h, mesh)))
      has_feature[source(h, mesh).idx()] = has_feature[target(h, mesh).idx()] = 1;
    if (has_exact_border)
      is_carried = is_carried && (scene.turns[h] - scene.carried_turns(h)) % 4 == 0;
  }
  CHECK(least == 1);
  CHECK(is_carried);
  for (const auto v : mesh.vertices()) {
    const int k = mesh.is_border(v) ? signature.corner_quarter_turns(v) : signature.quarter_turns(v);
    CHECK((!has_feature[v.idx()] || sum[v.idx()] == k));
    CHECK(k >= 1);
  }
  auto turns = mesh.add_property_map<Halfedge, int>("h:checked_turns", 77).first;
  const auto check = ts::check_feature_alignment(
      mesh, scene.features, scene.field,
      ts::parameters::halfedge_sector_turns_map(turns, ts::parameters::halfedge_matching_map(scene.matching)));
  CHECK(check.success());
  CHECK(check.deviation < 1e-9);
  for (const auto h : mesh.halfedges())
    CHECK(turns[h] == scene.turns[h]);
  CHECK(report.features.number_of_edges == ts::feature_figures(mesh, scene.features).number_of_edges);
}

// The turns of the sectors at a vertex, sorted.
std::vector<int> sectors_at(const Scene& scene, const test::Point_3& p)
{
  std::vector<int> result;
  for (const auto h : scene.mesh.halfedges())
    if (scene.mesh.point(source(h, scene.mesh)) == p && scene.turns[h] != 0)
      result.push_back(scene.turns[h]);
  std::sort(result.begin(), result.end());
  return result;
}

struct Stopping_visitor : ts::Progress_visitor {
  bool go_on() const { return false; }
};

} // namespace

TEST_CASE("the fields of parts follow all features, and each sector has a quarter turn")
{
  for (fm::Named_mesh& named : fm::all()) {
    CAPTURE(named.name);
    Marks marks = marks_of(named.mesh);
    REQUIRE(ts::detect_features(named.mesh, marks).success());
    Scene scene(named.mesh, marks);
    const Report report = scene.compute();
    check_field(scene, report);
    CHECK(report.follows_all_features());
    CHECK(report.number_of_rounds == 1);
    CHECK(report.features.number_of_edges == ts::feature_figures(named.mesh, marks).number_of_edges);
    CHECK(describe(report, scene.mesh) == "the cross field follows the features");
  }
}

TEST_CASE("a cube has one quarter turn on each of its faces at each of its corners, and two along its edges")
{
  for (const int n : {1, 2, 5}) {
    Mesh cube = fm::cube(n);
    Marks marks = marks_of(cube);
    REQUIRE(ts::detect_features(cube, marks).success());
    Scene scene(cube, marks);
    const Report report = scene.compute();
    check_field(scene, report);
    CHECK(report.number_of_singularities == 8);
    for (const auto v : cube.vertices()) {
      const test::Point_3 p = cube.point(v);
      int number_of_bounds = 0;
      for (const double x : {p.x(), p.y(), p.z()})
        number_of_bounds += x == 0 || x == 1 ? 1 : 0;
      if (number_of_bounds == 3)
        CHECK(sectors_at(scene, p) == std::vector<int>{1, 1, 1});
      else if (number_of_bounds == 2)
        CHECK(sectors_at(scene, p) == std::vector<int>{2, 2});
    }
  }
}

TEST_CASE("features may end inside a face, and cross each other")
{
  Mesh cube = fm::cube(8);
  Marks marks = marks_of(cube);
  REQUIRE(ts::detect_features(cube, marks).success());
  for (const auto e : cube.edges()) {
    const test::Point_3 p = cube.point(source(e, cube)), q = cube.point(target(e, cube));
    const bool is_cross =
        p.z() == 0 && q.z() == 0 && ((p.x() == 0.5 && q.x() == 0.5) || (p.y() == 0.5 && q.y() == 0.5));
    marks[e] = marks[e] || is_cross || fm::is_dart_of_cube(cube, e);
  }
  Scene scene(cube, marks);
  const Report report = scene.compute();
  check_field(scene, report);
  CHECK(report.follows_all_features());
  CHECK(report.features.number_of_darts == 1);
  CHECK(sectors_at(scene, test::Point_3(0.5, 0.5, 1)) == std::vector<int>{4});
  CHECK(sectors_at(scene, test::Point_3(0.5, 0.5, 0)) == std::vector<int>{1, 1, 1, 1});
  CHECK(sectors_at(scene, test::Point_3(1, 0.5, 1)) == std::vector<int>{1, 1, 2});
}

TEST_CASE("features may touch the border, cross it, and close up")
{
  const auto marked = [](const Mesh& mesh, const Mesh::Edge_index e, const auto& is_on) {
    return is_on(mesh.point(source(e, mesh))) && is_on(mesh.point(target(e, mesh)));
  };
  Mesh plate = open_meshes::plate(12, 12);
  Marks marks = marks_of(plate);
  for (const auto e : plate.edges())
    marks[e] =
        marked(plate, e, [](const test::Point_3& p) { return p.x() == 4; }) ||
        marked(plate, e, [](const test::Point_3& p) { return p.y() == 6 && p.x() >= 9; }) ||
        (marked(plate, e,
                [](const test::Point_3& p) { return std::abs(p.x() - 7) <= 1 && std::abs(p.y() - 6) <= 1; }) &&
         !marked(plate, e, [](const test::Point_3& p) { return std::abs(p.x() - 7) < 1 || std::abs(p.y() - 6) < 1; }) &&
         plate.point(source(e, plate)) != test::Point_3(7, 6, 0) &&
         plate.point(target(e, plate)) != test::Point_3(7, 6, 0));
  Scene scene(plate, marks);
  const Report report = scene.compute();
  check_field(scene, report);
  CHECK(report.follows_all_features());
  CHECK(report.features.number_of_loops == 1);
  CHECK(report.features.number_of_darts == 1);
  CHECK(report.features.number_of_ends_on_border == 3);
  CHECK(report.number_of_singularities == 0);
  CHECK(sectors_at(scene, test::Point_3(4, 0, 0)) == std::vector<int>{1, 1});
  CHECK(sectors_at(scene, test::Point_3(12, 6, 0)) == std::vector<int>{1, 1});
  CHECK(sectors_at(scene, test::Point_3(9, 6, 0)) == std::vector<int>{4});
  CHECK(sectors_at(scene, test::Point_3(0, 0, 0)) == std::vector<int>{1});
  CHECK(sectors_at(scene, test::Point_3(6, 5, 0)) == std::vector<int>{1, 3});
}

TEST_CASE("corners that are given are met, also where features touch the border")
{
  using Corners = std::vector<ts::Holonomy_signature<Mesh>::Corner>;
  for (const int n : {4, 12}) {
    Mesh plate = open_meshes::plate(n, n);
    Marks marks = marks_of(plate);
    for (const auto e : plate.edges())
      marks[e] = plate.point(source(e, plate)).x() == n / 2 && plate.point(target(e, plate)).x() == n / 2;
    Scene scene(plate, marks);
    const auto vertex_at = [&](const test::Point_3& p) {
      return *std::find_if(scene.mesh.vertices().begin(), scene.mesh.vertices().end(),
                           [&](const auto v) { return scene.mesh.point(v) == p; });
    };
    // Beside those of the square: two that turn inwards at both ends of the feature, and two on straight sides.
    const Corners corners = {{vertex_at({0., 0., 0.}), 1},
                             {vertex_at({double(n / 2 - 1), 0., 0.}), 1},
                             {vertex_at({double(n / 2), double(n), 0.}), 3},
                             {vertex_at({double(n / 2), 0., 0.}), 3},
                             {vertex_at({double(n), 0., 0.}), 1},
                             {vertex_at({0., double(n), 0.}), 1},
                             {vertex_at({double(n), double(n), 0.}), 1},
                             {vertex_at({double(n), double(n / 2), 0.}), 1}};
    const auto np = ts::parameters::corners(std::optional<Corners>(corners));
    const Report report = scene.compute(np);
    REQUIRE(report.success());
    CHECK(report.follows_all_features());
    ts::Holonomy_signature<Mesh> signature;
    const auto made =
        ts::holonomy_signature_of_cross_field(scene.mesh, scene.field, signature, scene.np_with_matching(np));
    CAPTURE(describe(made, scene.mesh));
    REQUIRE(made.success());
    for (const auto& corner : corners)
      CHECK(signature.corner_quarter_turns(corner.first) == corner.second);
    CHECK(signature.corners().size() == corners.size());
    for (const double y : {0., double(n)}) {
      const std::vector<int> sectors = sectors_at(scene, test::Point_3(n / 2, y, 0));
      CHECK(sectors == std::vector<int>{1, 2});
    }
    CHECK(static_cast<int>(signature.cones().size()) == report.number_of_singularities);
  }
}

namespace {

// A disk of radius 1 with `sides` sectors and two features from its centre, one sector apart.
Report compute_on_disk(const int sides, const double smallest_angle, std::vector<int>& turns)
{
  Mesh disk;
  const auto centre = disk.add_vertex(test::Point_3(0, 0, 0));
  std::vector<std::vector<Mesh::Vertex_index>> ring(4);
  for (int r = 0; r < 4; ++r)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * CGAL_PI * i / sides;
      ring[r].push_back(disk.add_vertex(test::Point_3((r + 1) * std::cos(angle), (r + 1) * std::sin(angle), 0)));
    }
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    disk.add_face(centre, ring[0][i], ring[0][j]);
    for (int r = 0; r < 3; ++r) {
      disk.add_face(ring[r][i], ring[r + 1][i], ring[r + 1][j]);
      disk.add_face(ring[r][i], ring[r + 1][j], ring[r][j]);
    }
  }
  Marks marks = marks_of(disk);
  for (int i = 0; i < 2; ++i) {
    marks[disk.edge(disk.halfedge(centre, ring[0][i]))] = true;
    for (int r = 0; r < 2; ++r)
      marks[disk.edge(disk.halfedge(ring[r][i], ring[r + 1][i]))] = true;
  }
  Scene scene(disk, marks);
  const Report report = scene.compute(ts::parameters::smallest_sector_angle(smallest_angle));
  check_field(scene, report, false);
  turns = sectors_at(scene, test::Point_3(0, 0, 0));
  return report;
}

} // namespace

TEST_CASE("a narrow sector gets a quarter turn from elsewhere, or makes its weaker feature soft")
{
  for (const int sides : {9, 10, 16, 30, 60}) {
    CAPTURE(sides);
    std::vector<int> turns;
    const Report carried = compute_on_disk(sides, 0, turns);
    CHECK(carried.follows_all_features());
    CHECK(carried.number_of_repaired_sectors >= 1);
    CHECK(turns.size() == 2);
    CHECK(turns[0] == 1);
    const Report soft = compute_on_disk(sides, 360, turns);
    CHECK(soft.soft_edges.size() >= 1);
    CHECK(soft.number_of_rounds >= 2);
    CHECK_FALSE(soft.follows_all_features());
    CHECK(turns.size() == 1);
    const Report usual = compute_on_disk(sides, ts::default_smallest_sector_angle, turns);
    CHECK(usual.follows_all_features() == (360. / sides >= ts::default_smallest_sector_angle));
  }
}

TEST_CASE("the report names the features that went soft, and the map has no mark there")
{
  std::vector<int> turns;
  const Report report = compute_on_disk(30, 360, turns);
  REQUIRE(report.soft_edges.size() >= 1);
  CHECK(report.soft_edges.front().vertex == Mesh::Vertex_index(0));
  Mesh names = fm::cube(1);
  Report made;
  made.soft_edges.push_back({names.halfedge(Mesh::Vertex_index(0), Mesh::Vertex_index(1)), Mesh::Vertex_index(1)});
  CHECK(describe(made, names) ==
        "the cross field follows the features but for 1, counted from 0: edge from vertex 0 to "
        "vertex 1 at vertex 1");
}

TEST_CASE("the fields of mechanical parts follow all their features")
{
  struct Example {
    const char* name;
    int arcs;
  };
  for (const Example& example :
       {Example{"u.off", 18}, Example{"joint.off", 22}, Example{"anchor.off", 32}, Example{"part.off", 5},
        Example{"couplingdown.off", 55}, Example{"P.off", 39}, Example{"cross.off", 36}, Example{"rotor.off", 9},
        Example{"spool.off", 11}, Example{"pinion.off", 122}, Example{"oblong.off", 52}, Example{"cactus.off", 6},
        Example{"tetrahedron.off", 6}, Example{"quint_tris.off", 16}, Example{"fandisk.off", 35},
        Example{"bones.off", 69}, Example{"star.off", 36}}) {
    CAPTURE(example.name);
    Mesh mesh;
    REQUIRE(ts::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + example.name, mesh).success());
    Marks marks = marks_of(mesh);
    const auto detected = ts::detect_features(mesh, marks);
    REQUIRE(detected.success());
    CHECK(detected.features.number_of_arcs == example.arcs);
    Scene scene(mesh, marks);
    const Report report = scene.compute();
    check_field(scene, report);
    CHECK(report.follows_all_features());
  }
}

TEST_CASE("sharp corners of the border have a quarter turn, too")
{
  for (const char* const name : {"triangular_hole.off", "elephant-with-holes.off"}) {
    CAPTURE(name);
    Mesh mesh;
    REQUIRE(ts::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
    Marks marks = marks_of(mesh);
    REQUIRE(ts::detect_features(mesh, marks).success());
    Scene scene(mesh, marks);
    const Report report = scene.compute();
    check_field(scene, report, false);
    CHECK(report.number_of_repaired_sectors > 0);
    CHECK(report.follows_all_features());
  }
}

TEST_CASE("where every edge is a feature, as on a torus, fields follow all but few of them")
{
  Mesh torus = test::to_mesh<Mesh>(test::torus(6, 5));
  Marks marks = torus.add_property_map<Mesh::Edge_index, bool>("e:is_feature", true).first;
  Scene scene(torus, marks);
  const Report report = scene.compute();
  check_field(scene, report);
  CHECK(report.soft_edges.size() < torus.number_of_edges() / 2);
}

TEMPLATE_TEST_CASE("features are followed on any model of graphs, and all maps but the field may be missing", "",
                   test::Surface_mesh, test::Polyhedron_3, test::Linear_cell_complex)
{
  TestType mesh =
      test::to_mesh<TestType>(test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, 3));
  auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  REQUIRE(ts::detect_features(mesh, marks).success());
  TestType refined;
  auto refined_marks = get(CGAL::dynamic_edge_property_t<bool>(), refined);
  REQUIRE(ts::refine_at_features(mesh, marks, refined, refined_marks).success());
  auto field = get(CGAL::dynamic_face_property_t<Vector_3>(), refined);
  const auto report = ts::compute_feature_aligned_cross_field(refined, refined_marks, field);
  REQUIRE(report.success());
  CHECK(report.number_of_singularities == 8);
  CHECK(ts::check_feature_alignment(refined, refined_marks, field).success());
}

TEST_CASE("a field that does not follow features is told apart, with the place and the angle")
{
  Mesh cube = fm::cube(4);
  Marks marks = marks_of(cube);
  REQUIRE(ts::detect_features(cube, marks).success());
  Scene scene(cube, marks);
  REQUIRE(scene.compute().success());
  const auto check = [&] { return ts::check_feature_alignment(scene.mesh, scene.features, scene.field); };
  CHECK(check().success());
  // One cross is turned by a degree.
  Mesh::Face_index f;
  for (const auto h : scene.mesh.halfedges())
    if (scene.features[edge(h, scene.mesh)])
      f = face(h, scene.mesh);
  const Vector_3 before = scene.field[f], other = CGAL::cross_product(scene.normal(f), before);
  scene.field[f] = std::cos(CGAL_PI / 180) * before + std::sin(CGAL_PI / 180) * other;
  const auto turned = check();
  CHECK(turned.status == ts::Feature_alignment_status::NOT_ALIGNED);
  CHECK(turned.deviation == Approx(1));
  CHECK(face(turned.halfedge, scene.mesh) == f);
  CHECK(describe(turned, scene.mesh).find("the field does not follow a feature: it is off by 1 degrees at the edge") ==
        0);
  CHECK(ts::check_feature_alignment(scene.mesh, scene.features, scene.field,
                                    ts::parameters::largest_feature_deviation(1.01))
            .success());
  scene.field[f] = Vector_3(0, 0, 0);
  const auto zero = check();
  CHECK(zero.status == ts::Feature_alignment_status::INVALID_FIELD);
  CHECK(zero.face == f);
  CHECK(ts::check_feature_alignment(scene.mesh, scene.features, scene.field,
                                    CGAL::parameters::visitor(Stopping_visitor()))
            .status == ts::Feature_alignment_status::INTERRUPTED);
  using Corners = std::vector<ts::Holonomy_signature<Mesh>::Corner>;
  const auto cornered =
      ts::check_feature_alignment(scene.mesh, scene.features, scene.field,
                                  ts::parameters::corners(std::optional<Corners>(Corners{{Mesh::Vertex_index(0), 1}})));
  CHECK(cornered.status == ts::Feature_alignment_status::INVALID_CORNERS);
  CHECK(describe(cornered, scene.mesh).find("a corner is not on the border") == 0);
  const Mesh empty;
  CHECK(ts::check_feature_alignment(empty, scene.features, scene.field).status ==
        ts::Feature_alignment_status::INVALID_MESH);
}

TEST_CASE("a sector that has no quarter turn by the closest rotations is told apart")
{
  Mesh star;
  REQUIRE(ts::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/star.off", star).success());
  Marks marks = marks_of(star);
  REQUIRE(ts::detect_features(star, marks).success());
  Scene scene(star, marks);
  REQUIRE(scene.compute().success());
  const auto report = ts::check_feature_alignment(scene.mesh, scene.features, scene.field);
  CHECK(report.status == ts::Feature_alignment_status::SECTOR_WITHOUT_TURN);
  CHECK(report.actual == 0);
  CHECK(scene.features[edge(report.halfedge, scene.mesh)]);
  CHECK(describe(report, scene.mesh).find("between two features at a vertex the field makes no quarter turn: at") == 0);
}

TEST_CASE("what cannot be computed is refused, and nothing is written")
{
  Mesh cube = fm::cube(1);
  Marks marks = marks_of(cube);
  REQUIRE(ts::detect_features(cube, marks).success());
  auto field = cube.add_property_map<Mesh::Face_index, Vector_3>("f:field", Vector_3(7, 7, 7)).first;
  const auto not_refined = ts::compute_feature_aligned_cross_field(cube, marks, field);
  CHECK(not_refined.status == Status::NOT_REFINED);
  CHECK(not_refined.face == Mesh::Face_index(0));
  CHECK(describe(not_refined, cube) ==
        "a face has two edges that are features or on the border; refine the mesh at its "
        "features first: face 0, counted from 0");
  Scene scene(cube, marks);
  for (const double angle : {-1., 361., std::numeric_limits<double>::quiet_NaN()})
    CHECK(scene.compute(ts::parameters::smallest_sector_angle(angle)).status == Status::INVALID_ANGLE);
  CHECK(scene.compute(CGAL::parameters::visitor(Stopping_visitor())).status == Status::INTERRUPTED);
  using Corners = std::vector<ts::Holonomy_signature<Mesh>::Corner>;
  CHECK(scene.compute(ts::parameters::corners(std::optional<Corners>(Corners{{Mesh::Vertex_index(0), 1}}))).status ==
        Status::INVALID_CORNERS);
  for (const auto f : scene.mesh.faces())
    CHECK(scene.field[f] == Vector_3(7, 7, 7));
  Mesh empty;
  CHECK(ts::compute_feature_aligned_cross_field(empty, marks_of(empty), field).status == Status::INVALID_MESH);
}

TEST_CASE("the computation of a field along features can be cancelled", "[cancel]")
{
  Mesh gear = fm::gear(9, 4);
  Marks marks = marks_of(gear);
  REQUIRE(ts::detect_features(gear, marks).success());
  Scene scene(gear, marks);
  check_cancelling([&](const auto& visitor) {
    for (const auto f : scene.mesh.faces())
      scene.field[f] = Vector_3(7, 7, 7);
    const Report report = scene.compute(CGAL::parameters::visitor(visitor));
    if (!report.success())
      for (const auto f : scene.mesh.faces())
        if (scene.field[f] != Vector_3(7, 7, 7)) {
          FAIL_CHECK("the field was written");
          break;
        }
    return report.status == Status::INTERRUPTED;
  });
}

} // namespace compute_feature_aligned_cross_field_test
