// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Counting_visitor.h"
#include "Similarity_map/test_meshes.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <catch2/catch.hpp>

namespace cancelling_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Signature = T::Holonomy_signature<Mesh>;

struct Scene {
  Mesh mesh = test_meshes::face_graph<Mesh>(test_meshes::icosahedron());
  Signature signature;

  Scene()
  {
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
    const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
    REQUIRE(T::compute_smooth_cross_field(mesh, field).success());
    REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature).success());
  }
};

} // namespace

TEST_CASE("A metric whose computation is cancelled stays what it was", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    T::Similarity_metric<Mesh, double> metric;
    const auto report =
        T::compute_similarity_metric(scene.mesh, scene.signature, metric, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::Similarity_map_status::INTERRUPTED;
    CHECK((metric.number_of_faces() == 0) == is_interrupted);
    return is_interrupted;
  });
}

TEST_CASE("A map whose computation is cancelled is not written", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    Mesh refined;
    const Uv_map uv = refined.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    const auto report = T::compute_seamless_similarity_map(scene.mesh, scene.signature, refined, uv,
                                                           CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::Similarity_map_status::INTERRUPTED;
    CHECK((refined.number_of_vertices() == 0) == is_interrupted);
    return is_interrupted;
  });
}

TEST_CASE("An exact map whose computation is cancelled stays what it was", "[cancel]")
{
  const Scene scene;
  Mesh refined;
  const Uv_map uv = refined.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  REQUIRE(T::compute_seamless_similarity_map(scene.mesh, scene.signature, refined, uv).success());
  check_cancelling([&](const auto& visitor) {
    T::Seamless_map<Mesh, CGAL::Exact_rational> map(refined);
    const auto report = T::make_exactly_seamless(refined, uv, map, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::Exact_map_status::INTERRUPTED;
    CHECK((map.layout().mesh().number_of_faces() == 0) == is_interrupted);
    return is_interrupted;
  });
}

} // namespace cancelling_test
