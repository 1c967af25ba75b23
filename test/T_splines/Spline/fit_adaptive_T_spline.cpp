// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/fit_adaptive_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>

#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include "Spline/Carried_box.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Segment_3.h>
#include <CGAL/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <boost/container_hash/hash.hpp>
#include <boost/property_map/property_map.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace fit_adaptive_T_spline_test {

namespace {

using namespace spline_tests;
namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Mesh = Carried_box::Mesh;
using Kernel = Carried_box::Kernel;
using Point_3 = Kernel::Point_3;
using Status = T::Adaptive_fit_status;

using Result = T::T_spline<Kernel>;

double longest_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::max({box.x_span(), box.y_span(), box.z_span()});
}

using Fit_report = T::Adaptive_fit_report<Mesh, Result::Graph, Mesh>;

// \param tolerance a length
template <typename NamedParameters>
Fit_report fit(const Carried_box& box, const double tolerance, Result& result, const NamedParameters& np)
{
  return T::fit_adaptive_T_spline(box.t_mesh, box.surface, box.mesh, tolerance / longest_side(box.mesh), result, np);
}

Fit_report fit(const Carried_box& box, const double tolerance, Result& result)
{
  return fit(box, tolerance, result, CGAL::parameters::default_values());
}

// The largest distances of random points, both ways.
template <typename Surface>
double distance_of_random_points(const Surface& surface, const Mesh& mesh)
{
  CGAL::Random random(1);
  const T::Mesh_distance to_mesh(mesh);
  const T::T_spline_closest_point<Surface> to_surface(surface);
  double result = 0;
  for (const auto f : faces(surface.graph()))
    for (int i = 0; i < 20; ++i)
      result = std::max(result, to_mesh(surface.position(f, surface.width(f) * random.get_double(),
                                                         surface.height(f) * random.get_double())));
  const int per_face = static_cast<int>(1 + 6000 / num_faces(mesh));
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const Point_3 &p = mesh.point(source(h, mesh)), &q = mesh.point(target(h, mesh)),
                  &r = mesh.point(target(next(h, mesh), mesh));
    for (int i = 0; i < per_face; ++i) {
      const double a = random.get_double(), b = random.get_double() * (1 - a);
      result = std::max(result, to_surface(p + a * (q - p) + b * (r - p)).distance);
    }
  }
  return result;
}

// Keeps the numbers of control points of the levels.
struct Level_recorder {
  std::vector<std::size_t>* numbers;

  template <typename TMesh>
  void operator()(const T::T_spline_fit_level& level, const TMesh& t_mesh) const
  {
    CHECK(level.number_of_control_points == num_vertices(t_mesh.graph()));
    CHECK(level.number_of_faces == num_faces(t_mesh.graph()));
    CHECK(T::T_spline_surface(t_mesh, t_mesh.graph().points()).is_valid());
    numbers->push_back(level.number_of_control_points);
  }
};

struct Stopping_visitor : T::Progress_visitor {
  bool go_on() const { return false; }
};

struct Failing_solver {
  using FT = double;
  using Matrix = T::Symmetric_sparse_matrix<double>;

  bool analyze_pattern(const Matrix&) { return true; }
  bool factorize(const Matrix&) { return false; }
  bool solve(const std::vector<double>&, std::vector<double>&) const { return false; }
};

// Two squares that share one vertex, where the border meets itself: no refinement makes that spline compatible.
struct Touching_squares {
  T::T_mesh<Point_3> t_mesh;
  T::Carried_surface<Mesh> surface;

  Touching_squares()
  {
    Mesh& graph = t_mesh.graph();
    std::vector<Mesh::Vertex_index> v;
    for (int i = 0; i < 9; ++i) {
      v.push_back(graph.add_vertex(Point_3(i % 3, i / 3, 0.1 * (i % 3) * (i / 3))));
      surface.add_point({graph.point(v.back()).x(), graph.point(v.back()).y(), graph.point(v.back()).z()});
    }
    for (const std::size_t i : {0, 4}) {
      const Mesh::Face_index f = graph.add_face(v[i], v[i + 1], v[i + 4], v[i + 3]);
      std::vector<std::size_t> corners; // from the origin of the frame
      for (const Mesh::Halfedge_index h : graph.halfedges_around_face(graph.halfedge(f))) {
        put(t_mesh.knots(), h, 1);
        put(t_mesh.corners(), h, true);
        corners.push_back(graph.source(h));
      }
      surface.add_image(f, {surface.add_triangle({corners[0], corners[1], corners[2]}), {{{0, 0}, {1, 0}, {1, 1}}}});
      surface.add_image(f, {surface.add_triangle({corners[0], corners[2], corners[3]}), {{{0, 0}, {1, 1}, {0, 1}}}});
    }
  }
};

} // namespace

TEST_CASE("An adaptive fit comes within the tolerance both ways, with more control points for a smaller one")
{
  const Carried_box box(16, bumpy);
  std::size_t last = 0;
  for (const double tolerance : {0.03, 0.01}) {
    Result result;
    const auto report = fit(box, tolerance, result);
    REQUIRE(report.status == Status::WITHIN_TOLERANCE);
    const T::T_spline_fit_level& level = report.levels[report.best_level];
    CHECK(level.error.maximum <= tolerance);
    CHECK(level.number_of_folded_faces == 0);
    CHECK(level.number_of_control_points == result.number_of_control_points());
    CHECK(level.number_of_control_points > last);
    last = level.number_of_control_points;
    CHECK(T::check_spline_compatibility(result));
    const auto surface = result.surface();
    REQUIRE(surface.is_valid());
    const double distance = distance_of_random_points(surface, box.mesh);
    CHECK(distance <= 1.02 * level.error.maximum);
    CHECK(distance <= tolerance);
    CHECK(T::check_T_spline_self_intersections(surface, box.mesh, CGAL::Emptyset_iterator()).success());
  }
}

TEST_CASE("A thin plate of few triangles is met between its vertices, and does not fold")
{
  const Carried_box box(1, plate);
  REQUIRE(num_faces(box.mesh) == 12);
  Result result;
  const double tolerance = 0.05;
  const auto report = fit(box, tolerance, result);
  REQUIRE(report.status == Status::WITHIN_TOLERANCE);
  CHECK(distance_of_random_points(result.surface(), box.mesh) <= tolerance);
  CHECK(T::check_T_spline_self_intersections(result.surface(), box.mesh, CGAL::Emptyset_iterator()).success());
}

TEST_CASE("All levels are observed, and the best of them is the surface")
{
  const Carried_box box(16, bumpy);
  std::vector<std::size_t> numbers;
  Result result;
  const auto report = fit(box, 0.01, result, P::level_observer(Level_recorder{&numbers}));
  REQUIRE(report.success());
  REQUIRE(report.levels.size() >= 2);
  REQUIRE(numbers.size() == report.levels.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    CHECK(numbers[i] == report.levels[i].number_of_control_points);
    CHECK(report.levels[report.best_level].error.maximum <= report.levels[i].error.maximum);
  }
  CHECK(result.number_of_control_points() == numbers[report.best_level]);
  CHECK(numbers.back() > numbers.front());
}

TEST_CASE("No more control points are used than allowed")
{
  const Carried_box box(12, bumpy);
  Result coarse, result;
  const std::size_t first = fit(box, 10, coarse).levels.front().number_of_control_points;
  const std::size_t limit = first + 400;
  const auto report = fit(box, 1e-4, result, P::maximum_number_of_control_points(limit));
  CHECK(report.status == Status::CONTROL_POINT_LIMIT);
  CHECK(result.number_of_control_points() <= limit);
  for (const auto& level : report.levels)
    CHECK(level.number_of_control_points <= limit);
}

TEST_CASE("The fit of a surface far from the origin, and large, is the same")
{
  const double size = 1e5, shift = 3e6;
  const Carried_box box(8, bumpy), far(8, [&](const Point_3&p, const int n) {
    const Point_3 q = bumpy(p, n);
    return Point_3(size * q.x() + shift, size * q.y() - shift, size * q.z() + shift);
  });
  Result near_result, far_result;
  const auto near_report = fit(box, 0.02, near_result), far_report = fit(far, 0.02 * size, far_result);
  REQUIRE(near_report.success());
  REQUIRE(far_report.success());
  REQUIRE(near_result.number_of_control_points() == far_result.number_of_control_points());
  for (const auto v : near_result.graph().vertices()) {
    const Point_3 &p = near_result.graph().point(v), &q = far_result.graph().point(v);
    CHECK(q.x() == Approx(size * p.x() + shift).margin(1e-3));
    CHECK(q.y() == Approx(size * p.y() - shift).margin(1e-3));
    CHECK(q.z() == Approx(size * p.z() + shift).margin(1e-3));
  }
}

TEST_CASE("An open surface is fitted adaptively, and copied into another model of a graph")
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Halfedge = boost::graph_traits<Polyhedron>::halfedge_descriptor;
  const Carried_box box(
      12, [](const Point_3& p, const int n) { return Point_3(0.2 * std::sin(3 * p.y() / n), p.y() / n, p.z() / n); },
      1);
  Result result;
  const auto report = fit(box, 0.01, result);
  REQUIRE(report.status == Status::WITHIN_TOLERANCE);
  CHECK(distance_of_random_points(result.surface(), box.mesh) <= 0.01);

  Polyhedron graph;
  std::unordered_map<Halfedge, double, boost::hash<Halfedge>> knots;
  std::unordered_map<Halfedge, bool, boost::hash<Halfedge>> corners;
  const T::T_mesh_view copy(graph, boost::make_assoc_property_map(knots), boost::make_assoc_property_map(corners));
  T::copy_T_mesh(result, copy);
  auto from = vertices(result.graph()).begin();
  for (const auto v : vertices(graph))
    v->point() = result.graph().point(*from++);
  const T::T_spline_surface surface(copy, get(CGAL::vertex_point, graph));
  REQUIRE(surface.is_valid());
  CHECK(distance_of_random_points(surface, box.mesh) <= 0.01);
}

TEST_CASE("Bad input of an adaptive fit is refused, and nothing is written")
{
  Carried_box box(4, bumpy);
  const auto refused = [&](const double tolerance, const auto& np) {
    Result result;
    const auto report = fit(box, tolerance, result, np);
    CHECK_FALSE(report.success());
    CHECK_FALSE(report);
    CHECK(result.number_of_control_points() == 0);
    CHECK_FALSE(describe(report, box.t_mesh.graph()).empty());
    return report;
  };
  const auto defaults = CGAL::parameters::default_values();
  SECTION("tolerance")
  {
    for (const double tolerance :
         {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      CHECK(refused(tolerance, defaults).status == Status::INVALID_TOLERANCE);
  }
  SECTION("no surface")
  {
    box.surface = T::Carried_surface<Mesh>();
    CHECK(refused(0.1, defaults).status == Status::NO_SURFACE);
  }
  SECTION("a mesh that cannot be measured")
  {
    const Mesh::Vertex_index v(3);
    box.mesh.point(v) = Point_3(0, 0, std::numeric_limits<double>::quiet_NaN());
    Result result;
    const auto report = T::fit_adaptive_T_spline(box.t_mesh, box.surface, box.mesh, 0.1, result);
    CHECK(report.status == Status::NOT_MEASURABLE);
    CHECK(report.deviation.vertex == v);
    CHECK(result.number_of_control_points() == 0);
  }
  SECTION("fewer control points than the rings need")
  {
    const auto report = refused(0.1, P::maximum_number_of_control_points(std::size_t(20)));
    CHECK(report.status == Status::LIMIT_TOO_LOW);
    CHECK(report.levels.front().number_of_control_points > 20);
  }
  SECTION("fairness")
  {
    const auto report = refused(0.1, P::fairness(-1.));
    CHECK(report.status == Status::FIT_FAILED);
    CHECK(report.fit.status == T::T_spline_fit_status::INVALID_FAIRNESS);
  }
  SECTION("a solver that fails")
  {
    const auto report = refused(0.1, CGAL::parameters::sparse_linear_solver(Failing_solver()));
    CHECK(report.status == Status::FIT_FAILED);
    CHECK(report.fit.status == T::T_spline_fit_status::UNDERDETERMINED);
    CHECK(report.levels.empty());
  }
  SECTION("a border that meets itself")
  {
    const Touching_squares squares;
    Result result;
    const auto report = T::fit_adaptive_T_spline(squares.t_mesh, squares.surface, 0.1, result);
    CHECK(report.status == Status::NOT_SPLINE_COMPATIBLE);
    CHECK(report.incompatibility == T::Spline_compatibility_status::TOUCHING_BORDERS);
    CHECK(report.levels.empty());
    CHECK(result.number_of_control_points() == 0);
    CHECK_FALSE(describe(report, squares.t_mesh.graph()).empty());
  }
  SECTION("knots")
  {
    const auto knots = box.t_mesh.knots();
    const auto h = *halfedges(box.t_mesh.graph()).begin();
    knots[h] = knots[h] * 2;
    CHECK(refused(0.1, defaults).status == Status::INADMISSIBLE);
  }
  SECTION("interruption")
  {
    CHECK(refused(1e-5, CGAL::parameters::visitor(Stopping_visitor())).status == Status::INTERRUPTED);
  }
}

namespace {

std::vector<Kernel::Segment_3> border_of(const Mesh& mesh)
{
  std::vector<Kernel::Segment_3> result;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      result.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return result;
}

/// The largest distance of points on segments from other segments.
double distance(const std::vector<Kernel::Segment_3>& from, const std::vector<Kernel::Segment_3>& to)
{
  constexpr int points_per_segment = 8;
  double largest = 0;
  for (const auto& s : from)
    for (int i = 0; i < points_per_segment; ++i) {
      const Point_3 p = s.source() + double(i) / points_per_segment * s.to_vector();
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& t : to)
        nearest = std::min(nearest, CGAL::squared_distance(p, t));
      largest = std::max(largest, std::sqrt(nearest));
    }
  return largest;
}

} // namespace

TEST_CASE("a notch in the border that hardly changes the surface is refined", "[fit_adaptive_T_spline]")
{
  // The square [-1, 1]^2 with a notch from below, 0.1 deep and at most 0.025 wide.
  const Carried_box box(
      16,
      [](const Point_3& p, const int n) {
        const double x = p.y() / n, y = p.z() / n, depth = 0.1;
        if (p.y() == 0)
          return Point_3(0, y + depth * (1 - y) / 2, 0);
        return Point_3(p.z() == -n && std::abs(p.y()) == 2 ? 0.1 * x : x, y, 0);
      },
      1);
  const double tolerance = 0.02;
  Result result;
  const auto report = fit(box, tolerance, result);
  INFO(describe(report, box.t_mesh.graph()));
  CHECK(report.within_tolerance());
  CHECK(report.levels.size() > 1);
  CHECK(report.levels.front().error.maximum > 2 * tolerance);
  REQUIRE(report.deviation.free_edge);
  Mesh surface;
  REQUIRE(T::tessellate_T_spline(result.surface(), 16, surface));
  const auto wanted = border_of(box.mesh), actual = border_of(surface);
  CHECK(distance(wanted, actual) <= tolerance);
  CHECK(distance(actual, wanted) <= tolerance);
  CHECK(std::max(distance(wanted, actual), distance(actual, wanted)) ==
        Approx(report.deviation.free_edge->maximum()).epsilon(0.02));
  // A coarse surface is as near, but for its border.
  Result coarse;
  const auto first = fit(box, tolerance, coarse, P::maximum_number_of_control_points(std::optional<std::size_t>(20)));
  CHECK_FALSE(first.within_tolerance());
  CHECK(first.deviation.maximum() <= tolerance);
  CHECK(first.deviation.free_edge->maximum() > 2 * tolerance);
}

} // namespace fit_adaptive_T_spline_test
