// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>

#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/T_mesh/is_spline_compatible.h>

#include "Spline/Spline_mesh.h"

#include <CGAL/Polyhedron_3.h>

#include <boost/container_hash/hash.hpp>
#include <boost/property_map/property_map.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace {

using namespace spline_tests;
namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Mesh = Spline_mesh<Rational>;
using Sample = T::T_mesh_sample<Surface_mesh, Kernel>;
using Status = T::Adaptive_fit_status;
using Point_3 = Kernel::Point_3;

// A T-mesh, and samples of a surface that is no T-spline: the image of one under a map of space.
struct Problem {
  Mesh t;
  std::vector<Sample> samples;

  Problem(const Faces<Rational>& faces_given, const int n) : t(faces_given)
  {
    CGAL::Random random(4);
    REQUIRE(t.make_spline_compatible());
    t.set_random_controls(random);
    const auto surface = t.surface();
    for (const auto f : faces(t.mesh))
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double u = surface.width(f) * (i + 0.5) / n, v = surface.height(f) * (j + 0.5) / n;
          const Point_3 p = surface.position(f, u, v);
          const auto bent = [](const double x, const double y) { return x + 0.2 * std::sin(5 * y); };
          samples.push_back({{f, u, v}, Point_3(bent(p.x(), p.y()), bent(p.y(), p.z()), bent(p.z(), p.x())), 1});
        }
  }
};

struct Result {
  Surface_mesh mesh;
  Surface_mesh::Property_map<Surface_mesh::Halfedge_index, double> knots =
      mesh.add_property_map<Surface_mesh::Halfedge_index, double>("h:knot").first;
  Surface_mesh::Property_map<Surface_mesh::Halfedge_index, bool> corners =
      mesh.add_property_map<Surface_mesh::Halfedge_index, bool>("h:is_corner").first;

  auto surface() { return T::T_spline_surface(mesh, knots, corners, mesh.points()); }
};

template <typename NamedParameters>
T::Adaptive_fit_report<Surface_mesh> fit(Problem& problem, const double tolerance, Result& result,
                                         const NamedParameters& np)
{
  return T::fit_adaptive_T_spline(problem.t.mesh, problem.t.knots(), problem.t.corners(), problem.samples, tolerance,
                                  result.mesh, result.knots, result.corners, result.mesh.points(), np);
}

T::Adaptive_fit_report<Surface_mesh> fit(Problem& problem, const double tolerance, Result& result)
{
  return fit(problem, tolerance, result, CGAL::parameters::default_values());
}

// Keeps what it is told, and asks to stop after some levels.
struct Level_recorder : T::Adaptive_fit_visitor {
  std::vector<std::size_t>* numbers;
  std::size_t last = 1000;

  template <typename TMesh, typename KnotMap, typename CornerMap, typename PointMap>
  void level_fitted(const T::T_spline_fit_level& level, const TMesh& t_mesh, const KnotMap knots,
                    const CornerMap corners, const PointMap points) const
  {
    CHECK(level.number_of_control_points == num_vertices(t_mesh));
    CHECK(level.number_of_faces == num_faces(t_mesh));
    CHECK(T::T_spline_surface(t_mesh, knots, corners, points).is_valid());
    numbers->push_back(level.number_of_control_points);
  }

  bool go_on() const { return numbers->size() < last; }
};

} // namespace

TEST_CASE("An adaptive fit comes within the tolerance, with more control points for a smaller one")
{
  for (const auto& [name, faces_given] : closed_surfaces<Rational>()) {
    CAPTURE(name);
    if (name == "torus")
      continue; // its coarsest T-mesh is fine enough
    Problem problem(faces_given, 8);
    std::size_t last = 0;
    for (const double tolerance : {0.06, 0.02}) {
      Result result;
      const auto report = fit(problem, tolerance, result);
      REQUIRE(report.status == Status::WITHIN_TOLERANCE);
      const T::T_spline_fit_level& level = report.levels[report.best_level];
      CHECK(level.error.maximum <= tolerance);
      CHECK(level.number_of_control_points == num_vertices(result.mesh));
      CHECK(level.number_of_control_points >= last);
      last = level.number_of_control_points;
      CHECK(T::is_spline_compatible(result.mesh, result.knots, result.corners));
      const auto surface = result.surface();
      REQUIRE(surface.is_valid());
      // Whatever the places of the samples are: they are that close.
      const T::T_spline_closest_point<decltype(surface)> closest(surface);
      for (std::size_t i = 0; i < problem.samples.size(); i += 31)
        REQUIRE(closest(problem.samples[i].point).distance <= tolerance * (1 + 1e-9));
    }
  }
}

TEST_CASE("The errors fall from level to level")
{
  Problem problem(test_t_meshes::cube<Rational>(), 14);
  std::vector<std::size_t> numbers;
  Level_recorder recorder;
  recorder.numbers = &numbers;
  Result result;
  const auto report = fit(problem, 0.004, result, CGAL::parameters::visitor(recorder));
  REQUIRE(report.success());
  REQUIRE(report.levels.size() >= 2);
  REQUIRE(numbers.size() == report.levels.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    CHECK(numbers[i] == report.levels[i].number_of_control_points);
    CHECK(report.levels[i].control_points_in_rings > 0);
    if (i > 0) {
      CHECK(numbers[i] > numbers[i - 1]);
      CHECK(report.levels[i].error.rms < report.levels[i - 1].error.rms);
    }
  }
}

TEST_CASE("No more control points are used than allowed")
{
  Problem problem(test_t_meshes::cube<Rational>(), 14);
  Result coarse, result;
  const std::size_t first = fit(problem, 10, coarse).levels.front().number_of_control_points;
  const std::size_t limit = first + 100;
  const auto report = fit(problem, 1e-6, result, P::maximum_number_of_control_points(limit));
  CHECK(report.status == Status::CONTROL_POINT_LIMIT);
  CHECK(num_vertices(result.mesh) <= limit);
  CHECK(num_vertices(result.mesh) > first);
  for (const auto& level : report.levels)
    CHECK(level.number_of_control_points <= limit);
}

TEST_CASE("A tolerance that cannot be reached ends an adaptive fit when the samples do not suffice")
{
  Problem problem(test_t_meshes::cube<Rational>(), 4);
  Result result;
  const auto report = fit(problem, 1e-9, result, P::maximum_number_of_control_points(problem.samples.size()));
  CHECK(report.success());
  CHECK(report.status != Status::WITHIN_TOLERANCE);
  CHECK(result.surface().is_valid());
}

TEST_CASE("An open surface is fitted adaptively, into another model of a T-mesh")
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Halfedge = boost::graph_traits<Polyhedron>::halfedge_descriptor;
  Problem problem(test_t_meshes::rectangle<Rational>(4, 3), 12);
  Polyhedron mesh;
  std::unordered_map<Halfedge, double, boost::hash<Halfedge>> knots;
  std::unordered_map<Halfedge, bool, boost::hash<Halfedge>> corners;
  const auto report = T::fit_adaptive_T_spline(problem.t.mesh, problem.t.knots(), problem.t.corners(), problem.samples,
                                               0.01, mesh, boost::make_assoc_property_map(knots),
                                               boost::make_assoc_property_map(corners), get(CGAL::vertex_point, mesh));
  REQUIRE(report.status == Status::WITHIN_TOLERANCE);
  const auto surface = T::T_spline_surface(mesh, boost::make_assoc_property_map(knots),
                                           boost::make_assoc_property_map(corners), get(CGAL::vertex_point, mesh));
  REQUIRE(surface.is_valid());
  const T::T_spline_closest_point<decltype(surface)> closest(surface);
  for (std::size_t i = 0; i < problem.samples.size(); i += 5)
    REQUIRE(closest(problem.samples[i].point).distance <= 0.01 * (1 + 1e-9));
}

TEST_CASE("Bad input of an adaptive fit is refused, and nothing is written")
{
  Problem problem(test_t_meshes::cube<Rational>(), 4);
  const auto refused = [&](const double tolerance, const auto& np) {
    Result result;
    const auto report = fit(problem, tolerance, result, np);
    CHECK_FALSE(report.success());
    CHECK_FALSE(report);
    CHECK(num_vertices(result.mesh) == 0);
    CHECK_FALSE(describe(report, problem.t.mesh).empty());
    return report;
  };
  const auto defaults = CGAL::parameters::default_values();
  SECTION("tolerance")
  {
    for (const double tolerance :
         {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      CHECK(refused(tolerance, defaults).status == Status::INVALID_TOLERANCE);
  }
  SECTION("more control points than samples")
  {
    const std::size_t number = problem.samples.size();
    const auto report = refused(0.1, P::maximum_number_of_control_points(number + 1));
    CHECK(report.status == Status::LIMIT_ABOVE_SAMPLES);
    CHECK(describe(report, problem.t.mesh).find(std::to_string(number)) != std::string::npos);
  }
  SECTION("fewer control points than the rings need")
  {
    const auto report = refused(0.1, P::maximum_number_of_control_points(std::size_t(20)));
    CHECK(report.status == Status::LIMIT_TOO_LOW);
    CHECK(report.levels.front().number_of_control_points > 20);
  }
  SECTION("samples")
  {
    problem.samples[3].weight = std::numeric_limits<double>::quiet_NaN();
    const auto report = refused(0.1, defaults);
    CHECK(report.status == Status::FIT_FAILED);
    CHECK(report.fit.status == T::T_spline_fit_status::INVALID_SAMPLE);
    problem.samples.clear();
    CHECK(refused(0.1, defaults).fit.status == T::T_spline_fit_status::NO_SAMPLES);
  }
  SECTION("fairness")
  {
    CHECK(refused(0.1, P::fairness(-1.)).fit.status == T::T_spline_fit_status::INVALID_FAIRNESS);
  }
  SECTION("knots")
  {
    const auto h = *halfedges(problem.t.mesh).begin();
    put(problem.t.knots(), h, Rational(get(problem.t.knots(), h) * Rational(2)));
    CHECK(refused(0.1, defaults).status == Status::INADMISSIBLE);
  }
  SECTION("interruption")
  {
    std::vector<std::size_t> numbers;
    Level_recorder recorder;
    recorder.numbers = &numbers;
    recorder.last = 0;
    CHECK(refused(1e-5, CGAL::parameters::visitor(recorder)).status == Status::INTERRUPTED);
  }
}

TEST_CASE("Every status of an adaptive fit has a message")
{
  for (int i = 0; i <= static_cast<int>(Status::INTERRUPTED); ++i)
    CHECK_FALSE(std::string(message(static_cast<Status>(i))).empty());
}
