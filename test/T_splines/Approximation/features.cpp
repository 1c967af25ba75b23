// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The way along the features of a mesh, and to other scale factors.

#include "feature_meshes.h"

#include <CGAL/T_splines/Approximation/T_spline_approximation.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <string>

namespace approximation_features_test {

namespace {

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Mesh = feature_meshes::Mesh;
using Approximation = T::T_spline_approximation<Mesh>;
using Status = T::T_spline_approximation_status;
using Features = Mesh::Property_map<Mesh::Edge_index, bool>;

// A mesh that is refined at its sharp edges.
struct Featured_mesh {
  Mesh mesh;
  Features features = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;

  explicit Featured_mesh(Mesh given)
  {
    const Features sharp = given.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
    REQUIRE(T::detect_features(given, sharp).success());
    REQUIRE(T::refine_at_features(given, sharp, mesh, features).success());
  }
};

Mesh demo_mesh(const std::string& name)
{
  Mesh mesh;
  REQUIRE(T::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
  return mesh;
}

} // namespace

TEST_CASE("Features of the mesh are edges of the T-mesh of the surface")
{
  Featured_mesh bracket(feature_meshes::bracket_with_hole(2));
  Approximation approximation(bracket.mesh);
  approximation.set_features(bracket.features);
  REQUIRE(approximation.compute_T_mesh());
  const auto& report = approximation.report();
  CHECK(report.feature_field.follows_all_features());
  CHECK(report.alignment.meets_constraints());
  CHECK(report.exact_map.is_isometric);
  const auto& t_mesh = approximation.t_mesh().t_mesh();
  std::size_t number_of_constrained = 0;
  for (const auto e : t_mesh.graph().edges())
    number_of_constrained += t_mesh.creases()[e] ? 1 : 0;
  CHECK(number_of_constrained > 0);
  T::T_spline<> spline;
  REQUIRE(approximation.fit(0.01, spline));
  CHECK(report.within_tolerance());
  // The transitions of the mapped mesh are those of the map that is aligned.
  const auto& mapped = approximation.mapped_mesh();
  for (const auto h : mapped.mesh().halfedges())
    CHECK(mapped.transitions()[h].scale() == 1);
}

TEST_CASE("Without features, nothing is aligned; with a scale policy, only scale factors change")
{
  const Mesh mesh = demo_mesh("eight.off");
  Approximation approximation(mesh);
  CHECK_FALSE(approximation.align_map());
  CHECK(approximation.report().status == Status::MISSING_RESULT);
  REQUIRE(approximation.compute_cross_field());
  REQUIRE(approximation.reduce_cones());
  CHECK_FALSE(approximation.guidance().has_field());
  REQUIRE(approximation.compute_map());
  REQUIRE(approximation.align_map(P::scale_policy(T::Scale_policy::UNIT)));
  CHECK(approximation.report().alignment.largest_log_scale_before > 0.1);
  REQUIRE(approximation.make_map_exact());
  CHECK(approximation.report().exact_map.is_isometric);
}

TEST_CASE("A mesh that is not refined at its features is refused, with the face")
{
  Mesh cube = feature_meshes::cube(1);
  const Features sharp = cube.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  REQUIRE(T::detect_features(cube, sharp).success());
  Approximation approximation(cube);
  approximation.set_features(sharp);
  CHECK_FALSE(approximation.compute_cross_field());
  CHECK(approximation.report().feature_field.status == T::Feature_aligned_field_status::NOT_REFINED);
  CHECK(approximation.report().reason.find("face ") != std::string::npos);
}

TEST_CASE("A given field is carried to the map, and followed")
{
  const Mesh mesh = demo_mesh("elephant.off");
  Approximation computed(mesh), given(mesh);
  REQUIRE(computed.compute_cross_field());
  REQUIRE(given.use_cross_field(computed.cross_field()));
  CHECK(given.guidance().has_field());
  for (Approximation* const approximation : {&computed, &given}) {
    REQUIRE(approximation->compute_map());
    REQUIRE(approximation->align_map());
    CHECK(approximation->report().alignment.after.mean < 0.7 * approximation->report().alignment.rotated.mean);
  }
  CHECK(given.report().alignment.after.mean == Approx(computed.report().alignment.after.mean).epsilon(1e-6));
}

} // namespace approximation_features_test
