// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The borders of surface and mesh, measured against each other by `measure_T_spline_deviation()`.

#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>

#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Border_curve.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include "Spline/Spline_mesh.h"
#include "Spline/Torus.h"

#include <CGAL/Random.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/squared_distance_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace free_edge_deviation_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Segment = Kernel::Segment_3;
using Triangles = CGAL::Surface_mesh<Point_3>;
using CGAL::T_splines::measure_T_spline_deviation;
namespace P = CGAL::T_splines::parameters;

constexpr int columns = 8, rows = 6;

/// The rectangle [0, 8] x [0, 6] with 8 x 6 faces; its control points are where a function of their places in it says.
class Plate : public Mesh {
public:
  template <typename PointOf>
  explicit Plate(const PointOf& point) : Mesh(test_t_meshes::rectangle<double>(columns, rows))
  {
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        for (int k = 0; k < 4; ++k) {
          const int x = i + (k == 1 || k == 2), y = j + (k >= 2);
          set_control(source(halfedge_of(columns * j + i, k), mesh), point(x, y), 1);
        }
  }
  Plate() : Plate([](const int x, const int y) { return Point_3(x, y, 0); }) {}
};

/// A grid of n x n cells on each unit square.
Triangles flat_mesh(const int n, const Vector_3& shift = Vector_3(0, 0, 0))
{
  Triangles mesh;
  CGAL::make_grid(
      columns * n, rows * n, mesh, [&](const double i, const double j) { return Point_3(i / n, j / n, 0) + shift; },
      true);
  return mesh;
}

std::vector<Segment> border_of(const Triangles& mesh)
{
  std::vector<Segment> result;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      result.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return result;
}

/// Of a surface that is evaluated at `number` places along each edge, directly and not as Bezier patches.
template <typename Surface>
std::vector<Segment> border_of(const Mesh& t, const Surface& surface, const int number)
{
  const CGAL::T_splines::T_mesh_coordinates coordinates(t);
  std::vector<Segment> result;
  for (const auto h : t.mesh.halfedges()) {
    if (t.mesh.is_border(h) || !t.mesh.is_border(t.mesh.opposite(h)))
      continue;
    const auto a = coordinates.source_point(h), b = coordinates.target_point(h);
    const auto at = [&](const int i) {
      const double x = double(i) / number;
      return surface.position(t.mesh.face(h), a.first + x * (b.first - a.first), a.second + x * (b.second - a.second));
    };
    for (int i = 0; i < number; ++i)
      result.emplace_back(at(i), at(i + 1));
  }
  return result;
}

/// The largest distance, and the root of the mean square, of `number` places on each segment from other segments.
std::pair<double, double> distances(const std::vector<Segment>& from, const std::vector<Segment>& to, const int number)
{
  double largest = 0, sum = 0, length = 0;
  for (const Segment& s : from)
    for (int i = 0; i < number; ++i) {
      const Point_3 p = s.source() + (i + 0.5) / number * s.to_vector();
      double nearest = std::numeric_limits<double>::infinity();
      for (const Segment& t : to)
        nearest = std::min(nearest, CGAL::squared_distance(p, t));
      largest = std::max(largest, nearest);
      sum += nearest * std::sqrt(s.squared_length());
      length += std::sqrt(s.squared_length());
    }
  return {std::sqrt(largest), std::sqrt(sum / length)};
}

/// \param found by few samples: less, but not much
void check_way(const CGAL::T_splines::One_way_deviation& way, const std::pair<double, double>& found)
{
  CHECK(found.first <= way.upper_bound);
  CHECK(found.first <= 1.0101 * way.maximum);
  CHECK(found.first >= 0.98 * way.maximum);
  CHECK(std::abs(found.second - way.rms) <= 0.01 * way.rms);
  CHECK(way.upper_bound <= 1.0101 * way.maximum);
  CHECK(std::sqrt(CGAL::squared_distance(way.farthest_point, way.closest_point)) == Approx(way.maximum).epsilon(1e-12));
}

double distance_from_edge(const Point_3& p, const Triangles::Halfedge_index h, const Triangles& mesh)
{
  return std::sqrt(CGAL::squared_distance(p, Segment(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))));
}

template <typename Report, typename Compiled>
void check_places(const Report& report, const Compiled& compiled, const Triangles& mesh)
{
  const auto& free_edge = *report.free_edge;
  const auto point = [&](const auto& place) {
    return compiled.position(place.place.face, place.place.u, place.place.v);
  };
  const auto &on_surface = free_edge.surface_to_mesh_place, &on_mesh = free_edge.mesh_to_surface_place;
  const double eps = 1e-9 * report.mesh_to_surface.extent;
  CHECK(std::sqrt(CGAL::squared_distance(point(on_surface), free_edge.surface_to_mesh.farthest_point)) <= eps);
  CHECK(std::sqrt(CGAL::squared_distance(point(on_mesh), free_edge.mesh_to_surface.closest_point)) <= eps);
  CHECK(mesh.is_border(on_surface.mesh_halfedge));
  CHECK(mesh.is_border(on_mesh.mesh_halfedge));
  CHECK(distance_from_edge(free_edge.surface_to_mesh.closest_point, on_surface.mesh_halfedge, mesh) <= eps);
  CHECK(distance_from_edge(free_edge.mesh_to_surface.farthest_point, on_mesh.mesh_halfedge, mesh) <= eps);
}

} // namespace

TEST_CASE("a part of an arc is the arc there", "[free_edge]")
{
  CGAL::T_splines::internal::Cubic_arc arc;
  arc.controls = {{{0, 0, 1, 1}, {1, 2, 0, 2}, {3, 1, 1, 0.5}, {4, 0, 2, 1}}};
  const auto part = restricted(arc, 0.25, 0.5), same = arc.halves()[0].halves()[1];
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 4; ++x)
      CHECK(std::abs(part.controls[i][x] - same.controls[i][x]) <= 1e-15);
  CHECK(same.begin == 0.25);
  CHECK(same.end == 0.5);
}

TEST_CASE("closed surfaces and closed meshes have no free edge", "[free_edge]")
{
  Torus t;
  Triangles mesh;
  CGAL::T_splines::tessellate_T_spline(t.surface(), 4, mesh);
  const auto closed = measure_T_spline_deviation(t.surface(), mesh);
  REQUIRE(closed.success());
  CHECK_FALSE(closed.free_edge);
  CHECK_FALSE(measure_T_spline_deviation(t.surface(), flat_mesh(1)).free_edge);
  Plate plate;
  CHECK_FALSE(measure_T_spline_deviation(plate.surface(), mesh).free_edge);
}

TEST_CASE("a border that is moved away is that far away", "[free_edge]")
{
  Plate plate;
  for (const int n : {1, 5})
    for (const Vector_3 shift : {Vector_3(0, 0, 0.25), Vector_3(0, 0, -3)}) {
      const auto report = measure_T_spline_deviation(plate.surface(), flat_mesh(n, shift));
      REQUIRE(report.success());
      REQUIRE(report.free_edge);
      const double d = std::abs(shift.z());
      for (const auto& way : {report.free_edge->surface_to_mesh, report.free_edge->mesh_to_surface}) {
        CHECK(std::abs(way.maximum - d) <= 1e-14);
        CHECK(way.upper_bound >= way.maximum);
        CHECK(way.upper_bound <= 1.0101 * d);
        CHECK(std::abs(way.rms - d) <= 1e-12 * d);
        CHECK(way.extent == columns);
      }
      CHECK(report.free_edge->number_of_corners == 4);
      CHECK(std::abs(report.free_edge->largest_corner_distance - d) <= 1e-14);
    }
  // In the plane, two of the sides slide along themselves.
  const double d = 0.125;
  const auto report = measure_T_spline_deviation(plate.surface(), flat_mesh(2, Vector_3(d, 0, 0)), P::tolerance(1e-2));
  REQUIRE(report.free_edge);
  CHECK(std::abs(report.free_edge->maximum() - d) <= 1e-14);
  CHECK(std::abs(report.free_edge->largest_corner_distance - d) <= 1e-14);
  // The distance is d along the short sides, but less near the corners for the one inside, and grows from 0 to d at one
  // end of the long sides.
  const double mean = ((2 * rows - 2 * d) * d * d + 4 * d * d * d / 3) / (2 * rows + 2 * columns);
  CHECK(report.free_edge->rms() == Approx(std::sqrt(mean)).epsilon(1e-4));
  CHECK_FALSE(report.within_tolerance());
  // More than the tolerance of 0.08 remains at one end of the long sides, less near the corners inside.
  CHECK(report.free_edge->mesh_to_surface.share_within_tolerance ==
        Approx((2. * columns - 2 * (d - 0.08) + 2 * 0.08) / (2 * rows + 2 * columns)).epsilon(2e-3));
}

TEST_CASE("the border curve may bulge between the vertices of the mesh", "[free_edge]")
{
  // Cubic B-splines with uniform knots: the curve follows a control point by 2/3.
  const double bulge = 0.3, height = 2 * bulge / 3;
  Plate plate([&](const int x, const int y) { return Point_3(x, y == 0 && x == 4 ? -bulge : y, 0); });
  for (const int n : {1, 3}) {
    const Triangles mesh = flat_mesh(n);
    const auto report = measure_T_spline_deviation(plate.surface(), mesh);
    REQUIRE(report.free_edge);
    const auto& way = report.free_edge->surface_to_mesh;
    CHECK(way.maximum <= height * (1 + 1e-12));
    CHECK(way.maximum >= height / 1.0101);
    CHECK(way.upper_bound >= height * (1 - 1e-12));
    CHECK(std::abs(way.farthest_point.x() - 4) < 0.2);
    CHECK(report.free_edge->largest_corner_distance <= 1e-14);
    CHECK(report.free_edge->mesh_to_surface.maximum < way.maximum);
    check_places(report, CGAL::T_splines::compile_T_spline(plate.surface()), mesh);
  }
}

TEST_CASE("a notch that is narrow but deep counts", "[free_edge]")
{
  // The surface has none; it is near to the mesh everywhere.
  constexpr int n = 8;
  const double depth = 1.5, width = 1. / n;
  Plate plate;
  Triangles mesh = flat_mesh(n);
  Triangles notched;
  std::vector<Triangles::Vertex_index> copy;
  for (const auto v : mesh.vertices())
    copy.push_back(notched.add_vertex(mesh.point(v)));
  for (const auto f : mesh.faces()) {
    std::vector<Triangles::Vertex_index> corners;
    Vector_3 sum(0, 0, 0);
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      corners.push_back(copy[v]);
      sum = sum + (mesh.point(v) - CGAL::ORIGIN) / 3;
    }
    if (std::abs(sum.x() - 4 - width / 2) > width / 2 || sum.y() > depth)
      notched.add_face(corners);
  }
  const auto report = measure_T_spline_deviation(plate.surface(), notched);
  REQUIRE(report.free_edge);
  CHECK(report.maximum() <= width / 2 + 1e-12);
  CHECK(std::abs(report.free_edge->mesh_to_surface.maximum - depth) <= 1e-12);
  CHECK(report.free_edge->surface_to_mesh.maximum <= width / 2 + 1e-12);
  const double between = (report.maximum() + depth) / 2 / columns;
  CHECK_FALSE(measure_T_spline_deviation(plate.surface(), notched, P::tolerance(between)).within_tolerance());
}

TEST_CASE("rational borders of any T-mesh, by brute force", "[free_edge]")
{
  CGAL::Random random(3);
  for (int trial = 0; trial < 6; ++trial) {
    Mesh t(test_t_meshes::rectangle<double>(3, 2));
    t.split_randomly(trial, random);
    REQUIRE(t.make_spline_compatible());
    t.set_random_controls(random);
    const auto surface = t.surface();
    REQUIRE(surface.is_valid());
    Triangles mesh;
    CGAL::T_splines::tessellate_T_spline(surface, 2, mesh);
    const Vector_3 shift(0.01 * trial, 0, 0);
    for (const auto v : mesh.vertices())
      mesh.point(v) = mesh.point(v) + shift;
    const auto report = measure_T_spline_deviation(surface, mesh);
    REQUIRE(report.success());
    REQUIRE(report.free_edge);
    const std::vector<Segment> curve = border_of(t, surface, 200), polygon = border_of(mesh);
    check_way(report.free_edge->surface_to_mesh, distances(curve, polygon, 1));
    check_way(report.free_edge->mesh_to_surface, distances(polygon, curve, 100));
    check_places(report, CGAL::T_splines::compile_T_spline(surface), mesh);
    CHECK(report.free_edge->number_of_corners == 4);
    CHECK(report.free_edge->largest_corner_distance <= shift.x() + 1e-14);
  }
}

TEST_CASE("free edges at extreme scales", "[free_edge]")
{
  for (const double scale : {1e-60, 1e60}) {
    Plate plate(
        [&](const int x, const int y) { return Point_3(scale * x, scale * (y == 0 && x == 4 ? -0.3 : y), scale); });
    Triangles mesh = flat_mesh(1);
    for (const auto v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    const auto report = measure_T_spline_deviation(plate.surface(), mesh);
    REQUIRE(report.free_edge);
    const double height = std::hypot(1, 0.2);
    CHECK(report.free_edge->surface_to_mesh.maximum / scale >= height / 1.0101);
    CHECK(report.free_edge->surface_to_mesh.maximum / scale <= height * (1 + 1e-12));
  }
  // A surface that is much larger than the mesh.
  Plate plate([](const int x, const int y) { return Point_3(1e6 * x, 1e6 * y * (1 + 0.1 * x * x), 0); });
  const auto report = measure_T_spline_deviation(plate.surface(), flat_mesh(1));
  REQUIRE(report.free_edge);
  CHECK(report.free_edge->surface_to_mesh.maximum / 1e6 ==
        Approx(std::hypot(columns, rows * (1 + 0.1 * columns * columns))).epsilon(1e-2));
}

} // namespace free_edge_deviation_test
