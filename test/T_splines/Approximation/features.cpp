// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The way along the features of a mesh, and to other scale factors.

#include "feature_meshes.h"

#include <CGAL/T_splines/Approximation/T_spline_approximation.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include <catch2/catch.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

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

using Segment = CGAL::Exact_predicates_inexact_constructions_kernel::Segment_3;

std::vector<Segment> features_of(const Featured_mesh& given)
{
  std::vector<Segment> result;
  for (const auto e : given.mesh.edges())
    if (given.features[e])
      result.emplace_back(given.mesh.point(given.mesh.vertex(e, 0)), given.mesh.point(given.mesh.vertex(e, 1)));
  return result;
}

// Chords of the images of the creases.
std::vector<Segment> creases_of(const T::T_spline<>& spline)
{
  constexpr int parts = 200;
  const auto surface = spline.surface();
  const T::T_mesh_coordinates coordinates(spline);
  std::vector<Segment> result;
  for (const auto h : spline.graph().halfedges()) {
    if (!spline.creases()[spline.graph().edge(h)])
      continue;
    const auto from = coordinates.source_point(h), to = coordinates.target_point(h);
    const auto at = [&](const int i) {
      const double t = static_cast<double>(i) / parts;
      return surface.position(spline.graph().face(h), from.first + t * (to.first - from.first),
                              from.second + t * (to.second - from.second));
    };
    for (int i = 0; i < parts; ++i)
      result.emplace_back(at(i), at(i + 1));
  }
  return result;
}

// The largest distance of points of segments from others.
double distance(const std::vector<Segment>& from, const std::vector<Segment>& to)
{
  constexpr int parts = 24;
  double largest = 0;
  for (const Segment& s : from)
    for (int i = 0; i <= parts; ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Segment& t : to)
        nearest = std::min(nearest, CGAL::squared_distance(s.source() + i * (s.target() - s.source()) / parts, t));
      largest = std::max(largest, std::sqrt(nearest));
    }
  return largest;
}

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
  // Creases and features are where each other are, as points of them find, too.
  const auto& deviation = report.fit.deviation;
  REQUIRE(deviation.crease);
  CHECK(deviation.crease->number_of_corners == 20);
  CHECK(deviation.crease->largest_corner_distance < 1e-12);
  const std::vector<Segment> wanted = features_of(bracket), actual = creases_of(spline);
  CHECK(deviation.crease->mesh_to_surface.maximum == Approx(distance(wanted, actual)).epsilon(0.05).margin(1e-6));
  CHECK(deviation.crease->surface_to_mesh.maximum == Approx(distance(actual, wanted)).epsilon(0.05).margin(1e-6));
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
