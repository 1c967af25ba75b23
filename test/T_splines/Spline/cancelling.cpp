// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Carried_box.h"
#include "Counting_visitor.h"

#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/fit_T_spline.h>
#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>
#include <CGAL/T_splines/Spline/insert_knot_line.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <catch2/catch.hpp>

#include <iterator>
#include <vector>

namespace cancelling_test {

namespace {

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Box = spline_tests::Carried_box;
using Kernel = Box::Kernel;
using Mesh = Box::Mesh;
using T_spline = T::T_spline<Kernel>;
using Graph = T_spline::Graph;

struct Scene {
  Box box{8, spline_tests::bumpy};
  T_spline spline;

  Scene() { REQUIRE(T::fit_adaptive_T_spline(box.t_mesh, box.surface, 0.05, spline).success()); }
};

} // namespace

TEST_CASE("A T-spline whose fit is cancelled stays what it was", "[cancel]")
{
  const Scene scene;
  const auto fit = [&](const double tolerance) {
    check_cancelling([&](const auto& visitor) {
      T_spline spline;
      const auto report = T::fit_adaptive_T_spline(scene.box.t_mesh, scene.box.surface, tolerance, spline,
                                                   CGAL::parameters::visitor(visitor));
      const bool is_interrupted = report.status == T::Adaptive_fit_status::INTERRUPTED;
      CHECK((spline.number_of_control_points() == 0) == is_interrupted);
      return is_interrupted;
    });
  };
  SECTION("with one level")
  {
    fit(0.5);
  }
  SECTION("with several")
  {
    fit(0.02);
  }
}

TEST_CASE("Samples and control points stay what they were if a fit is cancelled", "[cancel]")
{
  const Scene scene;
  const auto surface = scene.spline.surface();
  using Sample = T::T_mesh_sample<Graph, Kernel>;
  std::vector<Sample> samples;
  for (const auto f : faces(scene.spline.graph()))
    for (int i = 0; i < 16; ++i) {
      const double u = surface.width(f) * (i % 4 + 0.4) / 4, v = surface.height(f) * (i / 4 + 0.6) / 4;
      samples.push_back({{f, u, v}, surface.position(f, u, v) + 0.01 * Kernel::Vector_3(i % 3, 1, i % 2), 1.});
    }
  check_cancelling([&](const auto& visitor) {
    T_spline spline = scene.spline;
    std::vector<Sample> moved = samples;
    const auto points = spline.graph().points();
    const auto report = T::fit_T_spline(spline, moved, points, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::T_spline_fit_status::INTERRUPTED;
    if (is_interrupted) {
      for (std::size_t i = 0; i < samples.size(); ++i)
        if (moved[i].place.u != samples[i].place.u || moved[i].place.v != samples[i].place.v)
          FAIL_CHECK("a sample was moved");
      for (const auto v : vertices(spline.graph()))
        if (points[v] != scene.spline.graph().point(v))
          FAIL_CHECK("a control point was written");
    }
    return is_interrupted;
  });
}

TEST_CASE("A surface and its patches can be cancelled", "[cancel]")
{
  const Scene scene;
  check_cancelling([&](const auto& visitor) {
    const T::T_spline_surface surface(scene.spline, scene.spline.control_points(), CGAL::parameters::visitor(visitor));
    return surface.report().status == T::T_spline_status::INTERRUPTED;
  });
  const auto surface = scene.spline.surface();
  check_cancelling([&](const auto& visitor) {
    const auto compiled = T::compile_T_spline(surface, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = compiled.status() == T::T_spline_compilation_status::INTERRUPTED;
    CHECK((compiled.number_of_patches() == 0) == is_interrupted);
    return is_interrupted;
  });
}

TEST_CASE("A mesh is empty if tessellation is cancelled", "[cancel]")
{
  const Scene scene;
  const auto surface = scene.spline.surface();
  check_cancelling([&](const auto& visitor) {
    Mesh mesh;
    const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
    const auto report =
        T::tessellate_T_spline(surface, 8, mesh, CGAL::parameters::vertex_normal_map(normals).visitor(visitor));
    const bool is_interrupted = report.status == T::T_spline_tessellation_status::INTERRUPTED;
    CHECK((mesh.number_of_vertices() == 0) == is_interrupted);
    CHECK((mesh.number_of_faces() == 0) == is_interrupted);
    const bool has_normals = mesh.property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").second;
    CHECK(has_normals);
    return is_interrupted;
  });
  check_cancelling([&](const auto& visitor) {
    const auto domain = T::tessellate_parameter_domain(surface, 8, CGAL::parameters::visitor(visitor));
    CHECK(domain.places.empty() == domain.triangles.empty());
    return domain.places.empty();
  });
}

TEST_CASE("No distances are written if their measurement is cancelled", "[cancel]")
{
  Scene scene;
  const auto surface = scene.spline.surface();
  const auto distances = scene.box.mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  check_cancelling([&](const auto& visitor) {
    for (const auto v : scene.box.mesh.vertices())
      distances[v] = -1;
    const auto report = T::measure_T_spline_deviation(
        surface, scene.box.mesh, P::tolerance(0.05, P::vertex_distance_map(distances)).visitor(visitor));
    const bool is_interrupted = report.status == T::T_spline_deviation_status::INTERRUPTED;
    for (const auto v : scene.box.mesh.vertices())
      if ((distances[v] == -1) != is_interrupted) {
        FAIL_CHECK("distances are written if and only if they are known");
        break;
      }
    return is_interrupted;
  });
}

TEST_CASE("The search for self-intersections can be cancelled", "[cancel]")
{
  const Scene scene;
  const auto surface = scene.spline.surface();
  check_cancelling([&](const auto& visitor) {
    std::vector<Graph::Face_index> found;
    const auto report = T::check_T_spline_self_intersections(surface, scene.box.mesh, std::back_inserter(found),
                                                             CGAL::parameters::visitor(visitor));
    CHECK(found.empty());
    const bool is_interrupted = report.status == T::T_spline_self_intersection_status::INTERRUPTED;
    CHECK(report.success() != is_interrupted);
    return is_interrupted;
  });
}

TEST_CASE("A line of knots that is cancelled is not inserted", "[cancel]")
{
  const Scene scene;
  const auto f = *scene.spline.graph().faces().begin();
  check_cancelling([&](const auto& visitor) {
    T_spline spline = scene.spline;
    const auto report = T::insert_knot_line(spline, spline.control_points(), f, 0, 0.5 * spline.surface().width(f),
                                            CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::Knot_insertion_status::INTERRUPTED;
    if (is_interrupted)
      CHECK(spline.number_of_control_points() == scene.spline.number_of_control_points());
    return is_interrupted;
  });
}

} // namespace cancelling_test
