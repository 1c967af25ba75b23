// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>

#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include "Spline/Spline_mesh.h"
#include "Spline/Torus.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace measure_T_spline_deviation_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<double>;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
using Point_3 = Kernel::Point_3;
using Inexact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CGAL::T_splines::measure_T_spline_deviation;
using CGAL::T_splines::parameters::vertex_distance_map;
using Status = CGAL::T_splines::T_spline_deviation_status;

// The rectangle [0, 4] x [0, 3] in the plane z = 0, or with a wave over it.
class Rectangle : public Mesh {
public:
  explicit Rectangle(const double height = 0) : Mesh(test_t_meshes::rectangle<double>(columns, rows))
  {
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        for (int k = 0; k < 4; ++k) {
          const int x = i + (k == 1 || k == 2), y = j + (k >= 2);
          const bool is_border = x == 0 || x == columns || y == 0 || y == rows;
          set_control(source(halfedge_of(columns * j + i, k), mesh), Point_3(x, y, is_border ? 0 : height), 1);
        }
  }

  static constexpr int columns = 4, rows = 3;
};

// Two triangles.
Triangles flat_rectangle(const double z_left, const double z_right)
{
  Triangles mesh;
  const auto a = mesh.add_vertex(Point_3(0, 0, z_left)), b = mesh.add_vertex(Point_3(4, 0, z_right)),
             c = mesh.add_vertex(Point_3(4, 3, z_right)), d = mesh.add_vertex(Point_3(0, 3, z_left));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  return mesh;
}

// Calls `use(surface, mesh)` for closed surfaces with random control points, each `step`-th of them, and their
// tessellations.
template <typename Use>
void for_each_random_surface(const unsigned seed, const std::size_t step, const int resolution, const Use& use)
{
  CGAL::Random random(seed);
  const auto surfaces = closed_surfaces<double>();
  for (std::size_t i = 0; i < surfaces.size(); i += step) {
    INFO(surfaces[i].first);
    Mesh t(surfaces[i].second);
    REQUIRE(t.make_spline_compatible());
    if (num_vertices(t.mesh) < 4)
      continue; // the surface lies on itself, and every point has many that are closest
    t.set_random_controls(random);
    const Mesh::Surface surface = t.surface();
    Triangles mesh;
    CGAL::T_splines::tessellate_T_spline(surface, resolution, mesh);
    use(surface, mesh);
  }
}

} // namespace

TEST_CASE("a surface is as far from its tessellation as this is from it: order two", "[measure_T_spline_deviation]")
{
  Torus t;
  const Mesh::Surface surface = t.surface();
  REQUIRE(surface.is_valid());
  double last_mesh = 0, last_surface = 0, last_rms = 0;
  for (const int n : {2, 4, 8}) {
    Triangles mesh;
    CGAL::T_splines::tessellate_T_spline(surface, n, mesh);
    const auto distance = mesh.add_property_map<Triangles::Vertex_index, double>("v:distance", -1.).first;
    const auto report = measure_T_spline_deviation(surface, mesh, vertex_distance_map(distance));
    REQUIRE(report.success());
    for (const auto v : mesh.vertices())
      REQUIRE(std::abs(distance[v]) < 1e-14); // they are vertices of the tessellation
    CHECK(report.mesh_to_surface.rms <= report.mesh_to_surface.maximum);
    CHECK(report.maximum() == (std::max)(report.mesh_to_surface.maximum, report.surface_to_mesh.maximum));
    if (last_mesh > 0) {
      CHECK(std::log2(last_mesh / report.mesh_to_surface.maximum) > 1.8);
      CHECK(std::log2(last_surface / report.surface_to_mesh.maximum) > 1.8);
      CHECK(std::log2(last_rms / report.surface_to_mesh.rms) > 1.8);
    }
    last_mesh = report.mesh_to_surface.maximum;
    last_surface = report.surface_to_mesh.maximum;
    last_rms = report.surface_to_mesh.rms;
  }
}

TEST_CASE("the vertices of a tessellation lie on the surface, cones or not", "[measure_T_spline_deviation]")
{
  for_each_random_surface(1, 1, 8, [](const Mesh::Surface& surface, Triangles& mesh) {
    const auto distance = mesh.add_property_map<Triangles::Vertex_index, double>("v:distance", -1.).first;
    REQUIRE(measure_T_spline_deviation(surface, mesh, vertex_distance_map(distance)));
    for (const auto v : mesh.vertices())
      CHECK(std::abs(distance[v]) < 1e-13);
  });
}

TEST_CASE("a mesh that is displaced along the normals is that far away", "[measure_T_spline_deviation]")
{
  Torus t;
  const Mesh::Surface surface = t.surface();
  Triangles mesh;
  const auto normals = mesh.add_property_map<Triangles::Vertex_index, Kernel::Vector_3>("v:normal").first;
  CGAL::T_splines::tessellate_T_spline(surface, 16, mesh, CGAL::parameters::vertex_normal_map(normals));
  const double d = 0.05;
  for (const auto v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + d * normals[v];
  const auto check = [&](const auto& report) {
    REQUIRE(report.success());
    for (const auto& way : {report.mesh_to_surface, report.surface_to_mesh})
      for (const double x : {way.rms, way.maximum})
        CHECK(std::abs(x - d) < 0.02 * d);
    const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
    CHECK(report.mesh_to_surface.extent == (std::max)(box.x_span(), box.y_span()));
    CHECK(report.mesh_to_surface.relative_rms() == report.mesh_to_surface.rms / report.surface_to_mesh.extent);
  };
  check(measure_T_spline_deviation(surface, mesh));
  check(measure_T_spline_deviation(CGAL::T_splines::compile_T_spline(surface), mesh));
}

TEST_CASE("large triangles are measured inside", "[measure_T_spline_deviation]")
{
  Rectangle flat;
  const Mesh::Surface plane = flat.surface();
  REQUIRE(plane.is_valid());
  const double d = 0.5;
  const auto parallel = measure_T_spline_deviation(plane, flat_rectangle(d, d));
  for (const auto& way : {parallel.mesh_to_surface, parallel.surface_to_mesh}) {
    CHECK(std::abs(way.rms - d) < 1e-14);
    CHECK(std::abs(way.maximum - d) < 1e-14);
    CHECK(way.extent == 4);
    CHECK(way.number_of_samples > 100);
  }
  // On an inclined rectangle the height grows from 0 to d: the mean of its square is d^2 / 3.
  const auto inclined = measure_T_spline_deviation(plane, flat_rectangle(0, d));
  CHECK(std::abs(inclined.mesh_to_surface.rms - d / std::sqrt(3.)) < 1e-5);
  CHECK(std::abs(inclined.mesh_to_surface.maximum - d) < 1e-14);
  CHECK(inclined.mesh_to_surface.farthest_point.x() == 4);
  CHECK(inclined.surface_to_mesh.maximum < d);
  // All four vertices lie on this surface.
  Rectangle wave(1);
  const auto bulge = measure_T_spline_deviation(wave.surface(), flat_rectangle(0, 0));
  CHECK(bulge.mesh_to_surface.maximum > 0.5);
  CHECK(std::abs(bulge.surface_to_mesh.farthest_point.z() - bulge.surface_to_mesh.maximum) < 1e-14);
  CHECK(bulge.surface_to_mesh.maximum > 0.75 / 1.02); // the exact value is 0.75
}

TEST_CASE("a spike is far from the surface, but not the surface from the mesh", "[measure_T_spline_deviation]")
{
  Rectangle flat;
  const Mesh::Surface plane = flat.surface();
  Triangles mesh;
  constexpr int n = 40;
  CGAL::make_grid(
      4 * n, 3 * n, mesh, [](const double i, const double j) { return Point_3(i / n, j / n, 0); }, true);
  const double height = 1e4;
  const auto apex = *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                  [&](const auto v) { return mesh.point(v) == Point_3(1, 1, 0); });
  mesh.point(apex) = Point_3(1, 1, height);
  const auto report = measure_T_spline_deviation(plane, mesh);
  REQUIRE(report.success());
  CHECK(std::abs(report.mesh_to_surface.maximum / height - 1) < 1e-14);
  CHECK(report.mesh_to_surface.farthest_point == Point_3(1, 1, height));
  CHECK(report.surface_to_mesh.maximum < 1. / n);
  CHECK(report.mesh_to_surface.number_of_samples < 3000000);
  // Thin triangles of the spike: their area counts, their distance grows evenly.
  double area = 0;
  for (const auto f : mesh.faces())
    area += CGAL::T_splines::internal::area(Kernel::Triangle_3(mesh.point(target(mesh.halfedge(f), mesh)),
                                                               mesh.point(source(mesh.halfedge(f), mesh)),
                                                               mesh.point(target(next(mesh.halfedge(f), mesh), mesh))));
  // Of a triangle with its apex at h, the mean of the squared height is h^2 / 6.
  const double expected = height * std::sqrt((area - 12) / area / 6);
  CHECK(std::abs(report.mesh_to_surface.rms / expected - 1) < 0.1);
}

TEMPLATE_TEST_CASE("models of a mesh", "[measure_T_spline_deviation]", CGAL::Polyhedron_3<Kernel>,
                   CGAL::Polyhedron_3<Inexact_kernel>, CGAL::Surface_mesh<Inexact_kernel::Point_3>)
{
  Torus t;
  const Mesh::Surface surface = t.surface();
  Triangles mesh;
  CGAL::T_splines::tessellate_T_spline(surface, 3, mesh);
  TestType other;
  CGAL::copy_face_graph(mesh, other);
  const auto expected = measure_T_spline_deviation(surface, mesh), report = measure_T_spline_deviation(surface, other);
  REQUIRE(report.success());
  CHECK(std::abs(report.mesh_to_surface.rms - expected.mesh_to_surface.rms) < 1e-14);
  CHECK(std::abs(report.surface_to_mesh.maximum - expected.surface_to_mesh.maximum) < 1e-14);
}

TEST_CASE("degenerate faces and vertices without faces do not count", "[measure_T_spline_deviation]")
{
  Rectangle flat;
  const Mesh::Surface plane = flat.surface();
  Triangles mesh = flat_rectangle(1, 1);
  const auto isolated = mesh.add_vertex(Point_3(100, 0, 0));
  CGAL::make_triangle(Point_3(1, 1, 1), Point_3(1, 1, 1), Point_3(2, 2, 1), mesh);
  CGAL::make_triangle(Point_3(1, 1, 1), Point_3(1, 1, 1), Point_3(1, 1, 1), mesh);
  const auto distance = mesh.add_property_map<Triangles::Vertex_index, double>("v:distance", -1.).first;
  const auto report = measure_T_spline_deviation(plane, mesh, vertex_distance_map(distance));
  CHECK(std::abs(report.mesh_to_surface.maximum - 1) < 1e-14);
  CHECK(std::abs(report.mesh_to_surface.rms - 1) < 1e-14);
  CHECK(report.mesh_to_surface.extent == 4);
  CHECK(distance[isolated] == -1);
  // A mesh without area still has a maximum.
  Triangles point;
  CGAL::make_triangle(Point_3(1, 1, 1), Point_3(1, 1, 1), Point_3(1, 1, 1), point);
  const auto degenerate = measure_T_spline_deviation(plane, point);
  REQUIRE(degenerate.success());
  CHECK(std::abs(degenerate.mesh_to_surface.maximum - 1) < 1e-14);
  CHECK(degenerate.mesh_to_surface.relative_maximum() == 0);
}

TEST_CASE("far from the origin and at extreme scales", "[measure_T_spline_deviation]")
{
  for (const double scale : {1e-60, 1e60}) {
    Rectangle flat;
    Triangles mesh = flat_rectangle(0, 1);
    for (const auto v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    for (const auto v : flat.mesh.vertices()) {
      const auto p = flat.control(v).point();
      flat.set_control(v, Point_3(scale * p.x(), scale * p.y(), scale * p.z()), 1);
    }
    const auto report = measure_T_spline_deviation(flat.surface(), mesh);
    REQUIRE(report.success());
    CHECK(std::abs(report.mesh_to_surface.maximum / scale - 1) < 1e-14);
    CHECK(std::abs(report.mesh_to_surface.rms / scale - 1 / std::sqrt(3.)) < 1e-2);
  }
  Rectangle distant;
  Triangles mesh = flat_rectangle(0, 0);
  for (const auto v : distant.mesh.vertices()) {
    const auto p = distant.control(v).point();
    distant.set_control(v, Point_3(1e16 + 2 * p.x(), p.y(), p.z()), 1);
  }
  for (const auto v : mesh.vertices())
    mesh.point(v) = Point_3(1e16 + 2 * mesh.point(v).x(), mesh.point(v).y(), 1);
  CHECK(measure_T_spline_deviation(distant.surface(), mesh).success());
}

namespace {

// The largest distances that many random points find.
template <typename Surface>
std::pair<double, double> random_maxima(const Surface& surface, const Triangles& mesh, const int number)
{
  CGAL::Random random(5);
  const auto patches = CGAL::T_splines::compile_T_spline(surface);
  const CGAL::T_splines::Mesh_distance distance(mesh);
  const CGAL::T_splines::T_spline_closest_point<std::decay_t<decltype(patches)>> closest(patches);
  double to_mesh = 0, to_surface = 0;
  for (std::size_t i = 0; i < patches.number_of_patches(); ++i)
    for (int k = 0; k < number; ++k)
      to_mesh = (std::max)(to_mesh, distance(patches.patch(i).position(random.get_double(), random.get_double())));
  for (const auto f : mesh.faces()) {
    std::vector<Point_3> p;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      p.push_back(mesh.point(v));
    for (int k = 0; k < number; ++k) {
      const double a = random.get_double(), b = random.get_double();
      const Point_3 q = p[0] + (std::min)(a, b) * (p[1] - p[0]) + (1 - (std::max)(a, b)) * (p[2] - p[0]);
      to_surface = (std::max)(to_surface, closest(q).distance);
    }
  }
  return {to_surface, to_mesh};
}

template <typename Report>
void check_against_random_points(const Report& report, const std::pair<double, double>& maxima)
{
  CHECK(maxima.first <= 1.02 * report.mesh_to_surface.maximum);
  CHECK(maxima.second <= 1.02 * report.surface_to_mesh.maximum);
  CHECK(maxima.first <= report.mesh_to_surface.upper_bound * (1 + 1e-9));
  CHECK(maxima.second <= report.surface_to_mesh.upper_bound * (1 + 1e-9));
}

} // namespace

TEST_CASE("random points find no larger distance", "[measure_T_spline_deviation]")
{
  for_each_random_surface(7, 2, 2, [](const Mesh::Surface& surface, const Triangles& mesh) {
    const auto report = measure_T_spline_deviation(surface, mesh);
    REQUIRE(report.success());
    check_against_random_points(report, random_maxima(surface, mesh, 8));
    for (const auto& way : {report.mesh_to_surface, report.surface_to_mesh}) {
      CHECK(way.upper_bound >= way.maximum);
      CHECK(std::abs(CGAL::squared_distance(way.farthest_point, way.closest_point) - way.maximum * way.maximum) <
            1e-12);
    }
    const auto& place = report.surface_to_mesh_place.place;
    CHECK(CGAL::squared_distance(CGAL::T_splines::compile_T_spline(surface).position(place.face, place.u, place.v),
                                 report.surface_to_mesh.farthest_point) < 1e-20);
  });
}

TEST_CASE("a bulge between the vertices is found where it is", "[measure_T_spline_deviation]")
{
  // 24 x 18 faces; one control point is 1 high: its function is 4 / 9 there, and less than 1e-3 two faces away.
  class Plate : public Mesh {
  public:
    Plate() : Mesh(test_t_meshes::rectangle<double>(24, 18))
    {
      for (int j = 0; j < 18; ++j)
        for (int i = 0; i < 24; ++i)
          for (int k = 0; k < 4; ++k) {
            const int x = i + (k == 1 || k == 2), y = j + (k >= 2);
            set_control(source(halfedge_of(24 * j + i, k), mesh), Point_3(x / 6., y / 6., x == 7 && y == 5 ? 1 : 0), 1);
          }
    }
  };
  Plate plate;
  const Mesh::Surface surface = plate.surface();
  std::map<Mesh::face_descriptor, double> deviations;
  const Triangles mesh = flat_rectangle(0, 0);
  const auto report = measure_T_spline_deviation(
      surface, mesh,
      CGAL::T_splines::parameters::tolerance(
          0.01 / 8, CGAL::T_splines::parameters::face_deviation_map(boost::make_assoc_property_map(deviations))));
  const double height = 4. / 9;
  CHECK(report.surface_to_mesh.maximum > height / 1.02);
  CHECK(report.surface_to_mesh.maximum < height * (1 + 1e-12));
  CHECK(report.surface_to_mesh.upper_bound > height * (1 - 1e-12));
  CHECK(report.surface_to_mesh.upper_bound < 1.02 * height);
  CHECK(std::abs(report.surface_to_mesh.farthest_point.x() - 7. / 6) < 0.1);
  CHECK(std::abs(report.surface_to_mesh.farthest_point.y() - 5. / 6) < 0.1);
  CHECK_FALSE(report.within_tolerance());
  // The bulge covers 16 of 432 faces.
  CHECK(report.surface_to_mesh.share_within_tolerance > 1 - 0.08);
  CHECK(report.surface_to_mesh.share_within_tolerance < 1 - 0.01);
  CHECK(report.surface_to_mesh.share_within_half <= report.surface_to_mesh.share_within_tolerance);
  CHECK(deviations.size() == 432);
  int number = 0;
  for (const auto& face : deviations)
    number += face.second > 1e-9 ? 1 : 0;
  CHECK(number == 16);
  CHECK(deviations[report.surface_to_mesh_place.place.face] == report.surface_to_mesh.maximum);
  check_against_random_points(report, random_maxima(surface, mesh, 400));
}

TEST_CASE("what only closes a hole is not measured", "[measure_T_spline_deviation]")
{
  Rectangle rectangle(0.3);
  const Mesh::Surface surface = rectangle.surface();
  constexpr int m = 10; // triangles per unit of length, and two per square
  const auto number = [](const int x, const int y) { return Triangles::Vertex_index(y * (4 * m + 1) + x); };
  const auto is_in_hole = [](const int x, const int y) { return x > m && x < 3 * m && y > m && y < 2 * m; };
  Triangles mesh;
  auto is_data = mesh.add_property_map<Triangles::Face_index, bool>("f:is_data", true).first;
  for (int y = 0; y <= 3 * m; ++y)
    for (int x = 0; x <= 4 * m; ++x)
      mesh.add_vertex(Point_3(x / double(m), y / double(m), is_in_hole(x, y) ? -0.15 : 0));
  for (int y = 0; y < 3 * m; ++y)
    for (int x = 0; x < 4 * m; ++x)
      for (const auto f : {mesh.add_face(number(x, y), number(x + 1, y), number(x + 1, y + 1)),
                           mesh.add_face(number(x, y), number(x + 1, y + 1), number(x, y + 1))})
        is_data[f] = !(x >= m && x < 3 * m && y >= m && y < 2 * m);
  std::map<Triangles::Vertex_index, double> distances;
  std::map<Mesh::face_descriptor, double> deviations;
  namespace P = CGAL::T_splines::parameters;
  const auto report = measure_T_spline_deviation(
      surface, mesh,
      P::face_is_data_map(is_data,
                          P::vertex_distance_map(boost::make_assoc_property_map(distances),
                                                 P::face_deviation_map(boost::make_assoc_property_map(deviations)))));
  REQUIRE(report.success());
  CHECK(distances.size() == (4 * m + 1) * (3 * m + 1) - (2 * m - 1) * (m - 1));

  // By brute force, and up to what lies as near to the one as to the other.
  const CGAL::T_splines::Mesh_distance to_data(mesh, P::face_is_data_map(is_data)), to_all(mesh);
  double largest = 0, of_all = 0;
  std::map<Mesh::face_descriptor, double> largest_in_face;
  for (const auto f : faces(rectangle.mesh))
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; j <= 100; ++j) {
        const Point_3 p = surface.position(f, surface.width(f) * i / 100, surface.height(f) * j / 100);
        of_all = std::max(of_all, to_all(p));
        if (to_data(p) <= to_all(p))
          largest_in_face[f] = std::max(largest_in_face[f], to_all(p));
      }
  for (const auto& face : largest_in_face) {
    largest = std::max(largest, face.second);
    CHECK(deviations[face.first] < 1.05 * face.second + 1e-3);
  }
  CHECK(report.surface_to_mesh.maximum > largest / 1.02);
  CHECK(report.surface_to_mesh.maximum < 1.02 * largest);
  CHECK(report.surface_to_mesh.upper_bound < 1.02 * report.surface_to_mesh.maximum);
  CHECK(is_data[report.surface_to_mesh_place.mesh_face]);
  CHECK(is_data[report.mesh_to_surface_place.mesh_face]);
  const auto without_map = measure_T_spline_deviation(surface, mesh);
  CHECK(without_map.surface_to_mesh.maximum > of_all / 1.02);
  CHECK(without_map.mesh_to_surface.maximum > report.mesh_to_surface.maximum + 0.1);

  for (const auto f : mesh.faces())
    is_data[f] = false;
  CHECK(measure_T_spline_deviation(surface, mesh, P::face_is_data_map(is_data)).status == Status::NO_FACES);
}

TEST_CASE("folds are found, and their absence is certified", "[measure_T_spline_deviation]")
{
  Torus t;
  Triangles mesh;
  CGAL::T_splines::tessellate_T_spline(t.surface(), 16, mesh);
  const auto smooth = measure_T_spline_deviation(t.surface(), mesh);
  CHECK_FALSE(smooth.has_folds());
  CHECK(smooth.normals.number_of_certified_patches == smooth.normals.number_of_patches);
  CHECK(smooth.normals.number_of_patches == 96);
  CHECK(smooth.normals.largest_angle < 0.1);
  // A control point is drawn over its neighbour.
  const auto v = source(t.halfedge_of(0, 0), t.mesh), w = target(t.halfedge_of(0, 0), t.mesh);
  const Point_3 p = t.control(v).point(), q = t.control(w).point();
  t.set_control(v, q + 2 * (q - p), 1);
  std::map<Mesh::face_descriptor, bool> is_folded;
  const auto folded = measure_T_spline_deviation(
      t.surface(), mesh, CGAL::T_splines::parameters::face_is_folded_map(boost::make_assoc_property_map(is_folded)));
  CHECK(folded.has_folds());
  CHECK(folded.normals.largest_angle >= CGAL_PI / 2);
  CHECK(folded.normals.number_of_folded_patches + folded.normals.number_of_certified_patches <=
        folded.normals.number_of_patches);
  // What the point does not act on is certified.
  CHECK(folded.normals.number_of_certified_patches >= 80);
  CHECK(is_folded.at(folded.normals.place.place.face));
  CHECK(std::count_if(is_folded.begin(), is_folded.end(), [](const auto& face) { return face.second; }) <= 16);
  CHECK(folded.normals.number_of_doubtful_patches == 0);
  // All triangles are within a large tolerance, and some have any normal.
  const auto doubtful = measure_T_spline_deviation(
      t.surface(), mesh,
      CGAL::T_splines::parameters::tolerance(
          100., CGAL::T_splines::parameters::face_is_folded_map(boost::make_assoc_property_map(is_folded))));
  CHECK_FALSE(doubtful.has_folds());
  CHECK(doubtful.normals.number_of_doubtful_patches == folded.normals.number_of_folded_patches);
  CHECK(doubtful.normals.largest_angle == folded.normals.largest_angle);
  CHECK(std::none_of(is_folded.begin(), is_folded.end(), [](const auto& face) { return face.second; }));
}

TEST_CASE("the closest point may lie on the other side of a thin plate", "[measure_T_spline_deviation]")
{
  Rectangle flat(0);
  for (const auto v : flat.mesh.vertices()) {
    const Point_3 p = flat.control(v).point();
    flat.set_control(v, Point_3(p.x(), p.y(), -0.08), 1);
  }
  Triangles mesh = flat_rectangle(0, 0);
  CGAL::make_triangle(Point_3(0, 0, -0.1), Point_3(0, 6, -0.1), Point_3(8, 0, -0.1), mesh); // seen from below
  const auto report = measure_T_spline_deviation(flat.surface(), mesh);
  CHECK(std::abs(report.surface_to_mesh.maximum - 0.02) < 1e-14);
  CHECK(std::abs(report.surface_to_mesh.rms - 0.02) < 1e-14);
  CHECK(report.has_folds());
  CHECK(std::abs(report.normals.largest_angle - CGAL_PI) < 1e-7);
  CHECK(report.normals.number_of_certified_patches == 0);
  CHECK(report.surface_to_mesh_place.mesh_face == Triangles::Face_index(2));
  // The side that the surface belongs to is within the tolerance, or is not.
  CHECK(measure_T_spline_deviation(flat.surface(), mesh, CGAL::T_splines::parameters::tolerance(0.07 / 8)).has_folds());
  const auto thin = measure_T_spline_deviation(flat.surface(), mesh, CGAL::T_splines::parameters::tolerance(0.09 / 8));
  CHECK_FALSE(thin.has_folds());
  CHECK(thin.normals.number_of_doubtful_patches == thin.normals.number_of_patches);
}

TEST_CASE("rigid motions and scales change nothing but the unit", "[measure_T_spline_deviation]")
{
  Torus t;
  Triangles mesh;
  CGAL::T_splines::tessellate_T_spline(t.surface(), 3, mesh);
  const auto expected = measure_T_spline_deviation(t.surface(), mesh);
  const double a = 0.7, scale = 250;
  const CGAL::Aff_transformation_3<Kernel> motion(std::cos(a) * scale, -std::sin(a) * scale, 0, 17, std::sin(a) * scale,
                                                  std::cos(a) * scale, 0, -5, 0, 0, scale, 3);
  for (const auto v : mesh.vertices())
    mesh.point(v) = motion(mesh.point(v));
  for (const auto v : t.mesh.vertices())
    t.set_control(v, motion(t.control(v).point()), 1);
  const auto report = measure_T_spline_deviation(t.surface(), mesh);
  CHECK(std::abs(report.surface_to_mesh.maximum / scale / expected.surface_to_mesh.maximum - 1) < 0.01);
  CHECK(std::abs(report.mesh_to_surface.maximum / scale / expected.mesh_to_surface.maximum - 1) < 0.01);
  CHECK(std::abs(report.surface_to_mesh.rms / scale / expected.surface_to_mesh.rms - 1) < 1e-6);
  CHECK(std::abs(report.mesh_to_surface.rms / scale / expected.mesh_to_surface.rms - 1) < 1e-6);
  CHECK(std::abs(report.normals.largest_angle - expected.normals.largest_angle) < 1e-6);
}

TEST_CASE("a surface of long doubles", "[measure_T_spline_deviation]")
{
  using Long_kernel = CGAL::Simple_cartesian<long double>;
  Spline_mesh<long double, Long_kernel> t(test_t_meshes::rectangle<long double>(4, 3));
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) {
        const int x = i + (k == 1 || k == 2), y = j + (k >= 2);
        t.set_control(source(t.halfedge_of(4 * j + i, k), t.mesh), Long_kernel::Point_3(x, y, 0.5), 1);
      }
  const auto report = measure_T_spline_deviation(t.surface(), flat_rectangle(0, 0));
  REQUIRE(report.success());
  CHECK(std::abs(report.maximum() - 0.5) < 1e-14);
  CHECK(report.upper_bound() < 0.5 * 1.01 + 1e-14);
}

TEST_CASE("a surface that is a curve or a point", "[measure_T_spline_deviation]")
{
  for (const double width : {1., 0.}) {
    Rectangle flat;
    for (const auto v : flat.mesh.vertices())
      flat.set_control(v, Point_3(width * flat.control(v).point().x(), 0, 1), 1);
    const auto report = measure_T_spline_deviation(flat.surface(), flat_rectangle(0, 0));
    REQUIRE(report.success());
    CHECK(std::abs(report.surface_to_mesh.maximum - 1) < 1e-14);
    const double farthest = std::hypot(1., 3., width > 0 ? 0. : 4.);
    CHECK(std::abs(report.mesh_to_surface.maximum / farthest - 1) < 1e-14);
    CHECK(report.normals.number_of_certified_patches == 0);
  }
}

TEST_CASE("bad input is reported with its place", "[measure_T_spline_deviation]")
{
  Rectangle flat;
  const Mesh::Surface plane = flat.surface();
  CHECK(measure_T_spline_deviation(plane, Triangles()).status == Status::NO_FACES);

  Triangles quad = flat_rectangle(0, 0);
  CGAL::make_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), quad);
  const auto not_triangulated = measure_T_spline_deviation(plane, quad);
  CHECK(not_triangulated.status == Status::NOT_TRIANGULATED);
  CHECK(not_triangulated.face == Triangles::Face_index(2));
  CHECK_FALSE(not_triangulated);
  CHECK_THAT(describe(not_triangulated, quad), Catch::Contains("face 2"));

  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e100}) {
    Triangles mesh = flat_rectangle(0, 0);
    mesh.point(Triangles::Vertex_index(1)) = Point_3(0, 0, x);
    const auto report = measure_T_spline_deviation(plane, mesh);
    CHECK(report.status == Status::VERTEX_NOT_FINITE);
    CHECK(report.vertex == Triangles::Vertex_index(1));
  }

  const CGAL::T_splines::T_spline<Kernel> empty;
  const auto without_faces = measure_T_spline_deviation(empty.surface(), flat_rectangle(0, 0));
  CHECK(without_faces.status == Status::SURFACE_WITHOUT_FACES);
  CHECK(describe(without_faces, flat_rectangle(0, 0)) == message(Status::SURFACE_WITHOUT_FACES));

  flat.set_control(*flat.mesh.vertices().begin(), Point_3(0, 0, 1e200), 1);
  CHECK(measure_T_spline_deviation(flat.surface(), flat_rectangle(0, 0)).status == Status::SURFACE_NOT_FINITE);
}

} // namespace measure_T_spline_deviation_test
