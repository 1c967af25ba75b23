// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What reduce_cones() does with a cross field, and with edges that it follows.

#include <CGAL/T_splines/Cross_field/compute_feature_aligned_cross_field.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/match_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include "Counting_visitor.h"
#include "feature_meshes.h"
#include "open_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace reduce_cones_with_field_test {

namespace {

namespace ts = CGAL::T_splines;
namespace fm = feature_meshes;
using Mesh = open_meshes::Mesh;
using Vector_3 = open_meshes::Kernel::Vector_3;
using Signature = ts::Holonomy_signature<Mesh>;
using Status = ts::Cone_reduction_status;

Mesh demo_mesh(const std::string& name)
{
  Mesh mesh;
  REQUIRE(ts::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
  return mesh;
}

// A mesh that is refined at its features, with a field along them, its matchings and its signature.
struct Scene {
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> features =
      mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  Mesh::Property_map<Mesh::Face_index, Vector_3> field =
      mesh.add_property_map<Mesh::Face_index, Vector_3>("f:field").first;
  Mesh::Property_map<Mesh::Halfedge_index, int> matching =
      mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching", 0).first;
  Signature signature;

  Scene(const Mesh& given, const double feature_angle)
  {
    Mesh copy = given;
    auto sharp = copy.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
    if (feature_angle < 180)
      REQUIRE(ts::detect_features(copy, sharp, ts::parameters::feature_angle(feature_angle)).success());
    REQUIRE(ts::refine_at_features(copy, sharp, mesh, features).success());
    REQUIRE(
        ts::compute_feature_aligned_cross_field(mesh, features, field, ts::parameters::halfedge_matching_map(matching))
            .success());
    signature = signature_of_field();
  }
  Scene(const Scene&) = delete;

  Signature signature_of_field() const
  {
    Signature result;
    REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, result, ts::parameters::halfedge_matching_map(matching))
                .success());
    return result;
  }

  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  auto reduce(const NamedParameters& np = CGAL::parameters::default_values())
  {
    return ts::reduce_cones(
        mesh, signature,
        ts::parameters::cross_field_map(
            field, ts::parameters::halfedge_matching_map(matching, np.edge_is_constrained_map(features))));
  }

  bool is_on_feature(const Mesh::Vertex_index v) const
  {
    for (const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
      if (features[mesh.edge(h)])
        return true;
    return false;
  }

  // The largest sine of twice the angle between a feature and an axis of the crosses beside it.
  double largest_misalignment() const
  {
    double result = 0;
    for (const auto h : mesh.halfedges()) {
      if (!features[mesh.edge(h)] || mesh.is_border(h))
        continue;
      const Vector_3 edge = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)), d = field[mesh.face(h)];
      const double length = std::sqrt(edge.squared_length()), c = edge * d / length,
                   s = std::sqrt(CGAL::cross_product(edge, d).squared_length()) / length;
      result = std::max(result, 2 * std::abs(c * s));
    }
    return result;
  }
};

void check_equal(const Mesh& mesh, const Signature& a, const Signature& b)
{
  int number_of_differences = 0;
  for (const auto v : mesh.vertices())
    number_of_differences +=
        a.quarter_turns(v) != b.quarter_turns(v) || a.corner_quarter_turns(v) != b.corner_quarter_turns(v) ? 1 : 0;
  CHECK(number_of_differences == 0);
  REQUIRE(a.loops().size() == b.loops().size());
  for (std::size_t i = 0; i < a.loops().size(); ++i)
    CHECK(a.loops()[i].quarter_turns == b.loops()[i].quarter_turns);
  REQUIRE(a.arcs().size() == b.arcs().size());
  for (std::size_t i = 0; i < a.arcs().size(); ++i)
    CHECK(a.arcs()[i].quarter_turns == b.arcs()[i].quarter_turns);
}

} // namespace

TEST_CASE("The field turns as the reduced signature says: around vertices, along loops and arcs")
{
  std::vector<fm::Named_mesh> meshes;
  for (const char* const name : {"elephant.off", "eight.off", "bones.off", "double-torus-example.off"})
    meshes.push_back({name, demo_mesh(name)});
  meshes.push_back({"perforated plate", open_meshes::perforated_plate(3, 2)});
  for (const double curvature : {0., 100.})
    for (const fm::Named_mesh& named : meshes) {
      CAPTURE(named.name, curvature);
      Scene scene(named.mesh, 180);
      const auto report = scene.reduce(ts::parameters::curvature_alignment(curvature));
      REQUIRE(report.success());
      check_equal(scene.mesh, scene.signature, scene.signature_of_field());
    }
}

TEST_CASE("With features, cones on them stay, and the field follows them as before")
{
  std::vector<fm::Named_mesh> meshes = fm::all();
  for (const char* const name : {"anchor.off", "oblong.off", "rotor.off", "pinion.off"})
    meshes.push_back({name, demo_mesh(name)});
  int number_of_merges = 0;
  for (const fm::Named_mesh& named : meshes) {
    INFO(named.name);
    Scene scene(named.mesh, 40);
    const Signature before = scene.signature;
    const auto report = scene.reduce();
    REQUIRE(report.success());
    number_of_merges += report.number_of_merges;
    check_equal(scene.mesh, scene.signature, scene.signature_of_field());
    CHECK(scene.largest_misalignment() < 1e-12);
    int number_of_changed = 0;
    for (const auto v : scene.mesh.vertices())
      number_of_changed +=
          scene.is_on_feature(v) && scene.signature.quarter_turns(v) != before.quarter_turns(v) ? 1 : 0;
    CHECK(number_of_changed == 0);
  }
  CHECK(number_of_merges > 0);
}

TEST_CASE("The field stays near what it was, if that is asked for")
{
  Scene free(demo_mesh("elephant.off"), 180), near(demo_mesh("elephant.off"), 180);
  std::vector<Vector_3> before;
  for (const auto f : free.mesh.faces())
    before.push_back(free.field[f]);
  REQUIRE(free.reduce().success());
  REQUIRE(near.reduce(ts::parameters::curvature_alignment(1e4)).success());
  // The mean of the cosine of four times the angle, 1 where crosses are the same.
  const auto agreement = [&](const Scene& scene) {
    double sum = 0;
    for (const auto f : scene.mesh.faces()) {
      const double c = scene.field[f] * before[f], c2 = 2 * c * c - 1;
      sum += 2 * c2 * c2 - 1;
    }
    return sum / static_cast<double>(before.size());
  };
  CHECK(agreement(near) > agreement(free));
  CHECK(agreement(near) > 0.9);
}

TEST_CASE("Without a cone to merge, a field is relaxed and keeps its signature")
{
  Scene scene(fm::cube(4), 40);
  const Signature before = scene.signature;
  REQUIRE(scene.reduce().success());
  check_equal(scene.mesh, scene.signature, before);
  check_equal(scene.mesh, scene.signature_of_field(), before);
}

TEST_CASE("A reduction that is interrupted leaves the signature and the field as they are")
{
  Scene scene(demo_mesh("eight.off"), 180);
  const Signature signature = scene.signature;
  std::vector<Vector_3> field;
  for (const auto f : scene.mesh.faces())
    field.push_back(scene.field[f]);
  check_cancelling([&](const auto& visitor) {
    const auto report = scene.reduce(CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == Status::INTERRUPTED;
    if (is_interrupted) {
      check_equal(scene.mesh, scene.signature, signature);
      int number_of_changed = 0;
      for (const auto f : scene.mesh.faces())
        number_of_changed += scene.field[f] != field[f] ? 1 : 0;
      CHECK(number_of_changed == 0);
    }
    scene.signature = signature;
    for (const auto f : scene.mesh.faces())
      scene.field[f] = field[f];
    ts::match_cross_field(scene.mesh, scene.field, scene.matching);
    return is_interrupted;
  });
}

TEST_CASE("The closest matchings are those that a signature takes by itself")
{
  Scene scene(demo_mesh("eight.off"), 180);
  ts::match_cross_field(scene.mesh, scene.field, scene.matching);
  Signature by_itself;
  REQUIRE(ts::holonomy_signature_of_cross_field(scene.mesh, scene.field, by_itself).success());
  check_equal(scene.mesh, by_itself, scene.signature_of_field());
  scene.field[*scene.mesh.faces().begin()] = Vector_3(0, 0, 0);
  CHECK_FALSE(ts::match_cross_field(scene.mesh, scene.field, scene.matching));
}

} // namespace reduce_cones_with_field_test
