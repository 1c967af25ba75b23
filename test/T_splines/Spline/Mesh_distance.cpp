// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/Mesh_distance.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace Mesh_distance_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using CGAL::T_splines::Mesh_distance;
using Status = CGAL::T_splines::T_spline_deviation_status;

// With corners in [-1, 1]; some triangles have no area, some are points.
Mesh random_triangles(const int number, CGAL::Random& random)
{
  Mesh mesh;
  const auto point = [&] {
    return Point_3(random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1));
  };
  for (int i = 0; i < number; ++i) {
    const Point_3 p = point(), q = i % 5 == 0 ? p : point(), r = i % 3 == 0 ? CGAL::midpoint(p, q) : point();
    CGAL::make_triangle(p, q, r, mesh);
  }
  return mesh;
}

// The distance from a triangle, in exact arithmetic.
double exact_distance(const Point_3& p, const std::vector<Point_3>& t)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto exact = [](const Point_3& q) { return Exact::Point_3(q.x(), q.y(), q.z()); };
  const Exact::Point_3 a = exact(t[0]), b = exact(t[1]), c = exact(t[2]), q = exact(p);
  Exact::FT d = CGAL::squared_distance(q, a);
  const auto offer = [&](const Exact::Point_3& s, const Exact::Point_3& e) {
    d = s == e ? (std::min)(d, CGAL::squared_distance(q, s))
               : (std::min)(d, CGAL::squared_distance(q, Exact::Segment_3(s, e)));
  };
  offer(a, b);
  offer(b, c);
  offer(c, a);
  if (!CGAL::collinear(a, b, c))
    d = (std::min)(d, CGAL::squared_distance(q, Exact::Triangle_3(a, b, c)));
  return std::sqrt(CGAL::to_double(CGAL::exact(d)));
}

} // namespace

TEST_CASE("distances are those of the closest triangle, degenerate ones included", "[Mesh_distance]")
{
  CGAL::Random random(1);
  for (const int number : {1, 2, 40}) {
    const Mesh mesh = random_triangles(number, random);
    const Mesh_distance distance(mesh);
    REQUIRE(distance.is_valid());
    for (int i = 0; i < 100; ++i) {
      const double size = i % 2 == 0 ? 1 : 3;
      const Point_3 p(random.get_double(-size, size), random.get_double(-size, size), random.get_double(-size, size));
      double expected = (std::numeric_limits<double>::max)();
      for (const auto f : mesh.faces()) {
        std::vector<Point_3> corners;
        for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
          corners.push_back(mesh.point(v));
        expected = (std::min)(expected, exact_distance(p, corners));
      }
      CHECK(std::abs(distance(p) - expected) < 1e-14);
      CHECK(std::abs(std::sqrt(CGAL::squared_distance(p, distance.closest_point(p))) - expected) < 1e-14);
    }
  }
}

TEST_CASE("thin triangles do not harm the accuracy", "[Mesh_distance]")
{
  CGAL::Random random(2);
  const auto point = [&] {
    return Point_3(random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1));
  };
  for (const double height : {1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-13, 1e-17, 1e-200})
    for (int i = 0; i < 100; ++i) {
      const Point_3 a = point(), b = point(), c = a + 0.3 * (b - a) + height * (point() - CGAL::ORIGIN);
      Mesh mesh;
      CGAL::make_triangle(a, b, c, mesh);
      const Mesh_distance distance(mesh);
      const Point_3 inside = CGAL::centroid(a, b, c);
      INFO(height);
      for (const Point_3& p : {inside, inside + height * (point() - CGAL::ORIGIN), point()})
        CHECK(std::abs(distance(p) - exact_distance(p, {a, b, c})) < 1e-15);
    }
}

TEST_CASE("many triangles may share a point", "[Mesh_distance]")
{
  constexpr int number = 50000;
  Mesh mesh;
  for (int i = 0; i < number; ++i)
    CGAL::make_triangle(Point_3(0, 0, 1), Point_3(i, 0, 0), Point_3(i + 1, 0, 0), mesh);
  const Mesh_distance distance(mesh);
  CHECK(distance(Point_3(0, 0, 2)) == 1);
  CHECK(distance(Point_3(0.25, 3, 0.25)) == 3);
}

TEST_CASE("a copy is independent of its origin and of the mesh; ranges are measured point by point", "[Mesh_distance]")
{
  std::vector<Mesh_distance> copies;
  {
    CGAL::Polyhedron_3<Kernel> mesh;
    CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), mesh);
    copies.push_back(Mesh_distance(mesh));
  }
  const std::vector<Point_3> points = {Point_3(0, 0, -2), Point_3(0.25, 0.25, 0), Point_3(-3, 0, 0)};
  std::vector<double> distances;
  copies.front().distances(points, std::back_inserter(distances));
  CHECK(distances == std::vector<double>{2, 0, 3});
}

TEST_CASE("points come from the vertex point map", "[Mesh_distance]")
{
  using Exact_point_3 = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  Mesh mesh;
  CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), mesh);
  const auto points = mesh.add_property_map<Mesh::Vertex_index, Exact_point_3>("v:other").first;
  for (const auto v : mesh.vertices())
    points[v] = Exact_point_3(mesh.point(v).x(), mesh.point(v).y(), 5);
  CHECK(Mesh_distance(mesh, CGAL::parameters::vertex_point_map(points))(Exact_point_3(0, 0, 0)) == 5);
}

TEST_CASE("bad meshes are recognized", "[Mesh_distance]")
{
  CHECK(Mesh_distance(Mesh()).status() == Status::NO_FACES);
  Mesh quad;
  CGAL::make_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), quad);
  CHECK(Mesh_distance(quad).status() == Status::NOT_TRIANGULATED);
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300}) {
    Mesh mesh;
    CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, x, 0), Point_3(0, 1, 0), mesh);
    CHECK(Mesh_distance(mesh).status() == Status::VERTEX_NOT_FINITE);
    CHECK_FALSE(Mesh_distance(mesh).is_valid());
  }
}

} // namespace Mesh_distance_test
