// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Approximation/approximate_by_T_spline.h>

#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include "Approximation/box.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace approximate_by_T_spline_test {

namespace {

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Status = T::T_spline_approximation_status;

// The largest distance of random points, both ways.
double distance_of_random_points(const T::T_spline<>& spline, const Mesh& mesh)
{
  const auto surface = T::compile_T_spline(spline.surface());
  const T::T_spline_closest_point<std::decay_t<decltype(surface)>> to_surface(surface);
  const T::Mesh_distance to_mesh(mesh);
  CGAL::Random random(1);
  double result = 0;
  for (std::size_t i = 0; i < surface.number_of_patches(); ++i)
    for (int k = 0; k < 10; ++k)
      result = std::max(result, to_mesh(surface.patch(i).position(random.get_double(), random.get_double())));
  for (const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Kernel::Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                          &r = mesh.point(mesh.target(mesh.next(h)));
    for (int k = 0; k < 500; ++k) {
      const double a = random.get_double(), b = random.get_double() * (1 - a);
      result = std::max(result, to_surface(p + a * (q - p) + b * (r - p)).distance);
    }
  }
  return result;
}

struct Stopping_visitor : T::Progress_visitor {
  bool go_on() const { return false; }
};

} // namespace

TEST_CASE("one call makes a surface within the tolerance, and its report tells how far it is")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  T::T_spline<> spline;
  const auto report = T::approximate_by_T_spline(mesh, spline, P::tolerance(0.02));
  INFO(describe(report, mesh));
  REQUIRE(report.success());
  REQUIRE(report.within_tolerance());
  const double longest_side = 4, distance = distance_of_random_points(spline, mesh);
  CHECK(distance <= 0.02 * longest_side);
  CHECK(distance <= 1.02 * report.fit.deviation.maximum());
  CHECK(report.fit.deviation.tolerance == 0.02 * longest_side);
  CHECK(report.fit.levels.at(report.fit.best_level).number_of_control_points == spline.number_of_control_points());
  CHECK_FALSE(report.fit.deviation.has_folds());
  CHECK(report.fit.self_intersections.success());
  CHECK(T::check_spline_compatibility(spline));
  CHECK(describe(report, mesh).find("within the tolerance") != std::string::npos);
}

TEST_CASE("a surface beyond the tolerance is handed out, and the report says so and why")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  T::T_spline<> coarse, spline;
  const auto first = T::approximate_by_T_spline(mesh, coarse, P::tolerance(1.));
  REQUIRE(first.within_tolerance());
  const std::size_t limit = first.fit.levels.front().number_of_control_points + 50;
  const auto report = T::approximate_by_T_spline(
      mesh, spline, P::tolerance(1e-4, P::maximum_number_of_control_points(std::optional<std::size_t>(limit))));
  REQUIRE(report.success());
  CHECK_FALSE(report.within_tolerance());
  CHECK(spline.number_of_control_points() <= limit);
  CHECK(report.fit.status == T::Adaptive_fit_status::CONTROL_POINT_LIMIT);
  CHECK(report.fit.deviation.maximum() > 1e-4 * 4);
  const std::string text = describe(report, mesh);
  CHECK(text.find(std::to_string(limit)) != std::string::npos);
  CHECK(text.find("default") == std::string::npos);
}

TEST_CASE("a thin slanted plate: refinement ends where it does not help, and what is left is told")
{
  const std::vector<Kernel::Point_3> points = {{0, 0, 0},      {530, 70, -75}, {0, 6, 0},      {885, 70, -330},
                                               {555, 70, -85}, {530, 76, -75}, {555, 76, -85}, {885, 64, -330}};
  const std::vector<std::array<std::size_t, 3>> triangles = {{0, 1, 2}, {0, 3, 7}, {0, 7, 4}, {1, 0, 4},
                                                             {2, 1, 5}, {2, 3, 0}, {4, 6, 5}, {5, 1, 4},
                                                             {5, 6, 2}, {6, 3, 2}, {6, 7, 3}, {7, 6, 4}};
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  T::T_spline<> spline;
  const auto report = T::approximate_by_T_spline(mesh, spline);
  INFO(describe(report, mesh));
  REQUIRE(report.success());
  CHECK(report.fit.status == T::Adaptive_fit_status::NO_IMPROVEMENT);
  CHECK_FALSE(report.within_tolerance());
  CHECK_FALSE(
      (report.fit.deviation.within_tolerance() && !report.fit.deviation.has_folds() && report.fit.self_intersections));
  CHECK(spline.number_of_control_points() > 0);
}

TEST_CASE("a disk much thinner than the tolerance: faces are not split for ever")
{
  constexpr int n = 180;
  std::vector<Kernel::Point_3> points;
  for (const double z : {0., 0.001})
    for (int i = 0; i < n; ++i)
      points.emplace_back(std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n), z);
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.push_back({i, j, j + n});
    triangles.push_back({i, j + n, i + n});
    if (i > 0 && j > 0) {
      triangles.push_back({0, j, i});
      triangles.push_back({n, i + n, j + n});
    }
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  REQUIRE(mesh.number_of_faces() == 4 * n - 4);
  T::T_spline<> spline;
  const auto report = T::approximate_by_T_spline(mesh, spline);
  INFO(describe(report, mesh));
  REQUIRE(report.success());
  CHECK(report.fit.status == T::Adaptive_fit_status::RESOLUTION_REACHED);
  CHECK_FALSE(report.within_tolerance());
}

TEST_CASE("what cannot be approximated is refused, with the element, and the spline stays what it was")
{
  Mesh mesh = approximation_tests::box<Mesh>();
  T::T_spline<> spline;
  REQUIRE(T::approximate_by_T_spline(mesh, spline, P::tolerance(1.)).success());
  const std::size_t before = spline.number_of_control_points();
  const auto check = [&](const Status status, const auto& report) {
    CHECK(report.status == status);
    CHECK_FALSE(report.success());
    CHECK_FALSE(report.within_tolerance());
    CHECK(spline.number_of_control_points() == before);
    return describe(report, mesh);
  };
  SECTION("no faces")
  {
    mesh.clear();
    CHECK_FALSE(check(Status::INVALID_MESH, T::approximate_by_T_spline(mesh, spline)).empty());
  }
  SECTION("no number")
  {
    mesh.point(Mesh::Vertex_index(5)) = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
    const auto report = T::approximate_by_T_spline(mesh, spline);
    CHECK(check(Status::INVALID_MESH, report).find('5') != std::string::npos);
    CHECK(report.mesh.vertex == Mesh::Vertex_index(5));
  }
  SECTION("tolerance")
  {
    const auto report = T::approximate_by_T_spline(mesh, spline, P::tolerance(-1.));
    check(Status::FIT_FAILED, report);
    CHECK(report.fit.status == T::Adaptive_fit_status::INVALID_TOLERANCE);
  }
  SECTION("too few control points")
  {
    const auto report =
        T::approximate_by_T_spline(mesh, spline, P::maximum_number_of_control_points(std::optional<std::size_t>(9)));
    CHECK(check(Status::FIT_FAILED, report).find("allowed are 9") != std::string::npos);
  }
  SECTION("too few cones")
  {
    const auto report = T::approximate_by_T_spline(mesh, spline, P::maximum_number_of_cones(std::optional<int>(1)));
    check(Status::CONE_REDUCTION_FAILED, report);
  }
  SECTION("interruption")
  {
    check(Status::INTERRUPTED, T::approximate_by_T_spline(mesh, spline, CGAL::parameters::visitor(Stopping_visitor())));
  }
}

TEST_CASE("the first half hands out the refined mesh with its exact map")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  T::Mapped_mesh<Mesh> mapped;
  const auto report = T::compute_exact_map(mesh, mapped);
  REQUIRE(report.success());
  REQUIRE(mapped.has_map());
  CHECK(num_vertices(mapped.mesh()) >= num_vertices(mesh));
  int quarter_turns = 0;
  for (const auto v : mapped.mesh().vertices())
    quarter_turns += 4 - mapped.map().quarter_turns(v);
  CHECK(quarter_turns == 8); // Gauss and Bonnet
  for (const auto h : mapped.mesh().halfedges()) {
    // Across an edge, both ends agree with the transition, exactly.
    const auto g = mapped.mesh().opposite(h);
    const auto t = mapped.map().transition(h);
    const auto target = mapped.map().uv(h);
    CHECK(t(target.first, target.second) == mapped.map().uv(mapped.mesh().prev(g)));
  }

  T::Surface_T_mesh<T::Mapped_mesh<Mesh>::Mesh> placed;
  REQUIRE(T::compute_T_mesh(mapped.map(), placed).success());
  T::T_spline<> spline, in_one_call;
  REQUIRE(T::fit_adaptive_T_spline(placed.t_mesh(), placed.surface(), mesh, 0.02, spline).within_tolerance());
  REQUIRE(T::approximate_by_T_spline(mesh, in_one_call, P::tolerance(0.02)).within_tolerance());
  REQUIRE(spline.number_of_control_points() == in_one_call.number_of_control_points());
  for (const auto v : spline.graph().vertices())
    CHECK(spline.graph().point(v) == in_one_call.graph().point(v));
}

} // namespace approximate_by_T_spline_test
