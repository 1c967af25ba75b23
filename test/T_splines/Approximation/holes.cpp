// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of meshes whose holes were filled take nothing from what fills them.

#include <CGAL/T_splines/Approximation/approximate_by_T_spline.h>
#include <CGAL/T_splines/IO/fill_holes.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>

#include "open_meshes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/squared_distance_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace holes_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;

constexpr int n = 24; // cells, each of length 1

double height(const double x, const double y)
{
  return 4 * std::sin(0.15 * x) * std::cos(0.12 * y);
}

/// A wavy sheet whose hole of 8 x 8 cells is filled; and then what fills it is moved.
struct Filled_sheet {
  Mesh mesh = grid(
      n, n, [](const int i, const int j) { return i < 8 || i >= 16 || j < 8 || j >= 16; },
      [](const int i, const int j) { return Point_3(i, j, height(i, j)); });
  Mesh::Property_map<Mesh::Face_index, bool> is_data = mesh.add_property_map<Mesh::Face_index, bool>("f:is_data").first;

  explicit Filled_sheet(const double displacement)
  {
    const std::size_t number_of_vertices = mesh.number_of_vertices();
    REQUIRE(T::fill_holes(mesh, 32, P::face_is_data_map(is_data)).number_of_filled_holes == 1);
    for (const Vertex v : mesh.vertices())
      if (v.idx() >= number_of_vertices)
        mesh.point(v) = mesh.point(v) + Kernel::Vector_3(0, 0, displacement);
  }
};

/// How far a surface is from the sheet, over the hole and elsewhere, by the side of the sheet.
struct Distances {
  double in_hole = 0, elsewhere = 0;

  explicit Distances(const T::T_spline<>& spline)
  {
    constexpr int m = 8;
    const auto surface = spline.surface();
    for (const auto f : spline.graph().faces())
      for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= m; ++j) {
          const Point_3 p = surface.position(f, surface.width(f) * i / m, surface.height(f) * j / m);
          const bool is_in_hole = std::max(std::abs(p.x() - 12), std::abs(p.y() - 12)) < 4;
          double& largest = is_in_hole ? in_hole : elsewhere;
          largest = std::max(largest, std::abs(p.z() - height(p.x(), p.y())) / n);
        }
  }
};

} // namespace

TEST_CASE("the surface takes nothing from what fills a hole")
{
  constexpr double displacement = 1.5;
  const Filled_sheet sheet(displacement);
  T::T_spline<> spline, of_all;
  const auto np = P::face_is_data_map(sheet.is_data);
  const auto report = T::approximate_by_T_spline(sheet.mesh, spline, np);
  CAPTURE(describe(report, sheet.mesh));
  REQUIRE(report.within_tolerance());
  const Distances distances(spline);
  CHECK(distances.elsewhere <= T::default_tolerance);
  CHECK(distances.in_hole <= 2 * T::default_tolerance); // it goes on smoothly

  // The report has what is measured without the filling, and that differs from what is measured with it.
  const auto deviation = T::measure_T_spline_deviation(spline.surface(), sheet.mesh, np);
  CHECK(deviation.maximum() == Approx(report.fit.deviation.maximum()));
  CHECK(T::measure_T_spline_deviation(spline.surface(), sheet.mesh).maximum() > 0.8 * displacement);

  // Were it data, the surface would go there.
  REQUIRE(T::approximate_by_T_spline(sheet.mesh, of_all));
  CHECK(Distances(of_all).in_hole > 0.8 * displacement / n);
}

TEST_CASE("the faces of the refined mesh know the ones of the given mesh that they lie in")
{
  const Filled_sheet sheet(0);
  T::Mapped_mesh<Mesh> mapped;
  REQUIRE(T::compute_exact_map(sheet.mesh, mapped));
  REQUIRE(mapped.mesh().number_of_faces() > sheet.mesh.number_of_faces());
  std::map<Mesh::Face_index, double> areas;
  for (const auto f : mapped.mesh().faces()) {
    const auto origin = mapped.origin(f, sheet.mesh);
    REQUIRE(origin != Mesh::null_face());
    const auto triangle = [](const auto face, const Mesh& mesh) {
      const auto h = mesh.halfedge(face);
      return Kernel::Triangle_3(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                mesh.point(mesh.target(mesh.next(h))));
    };
    const Kernel::Triangle_3 part = triangle(f, mapped.mesh()), whole = triangle(origin, sheet.mesh);
    for (int i = 0; i < 3; ++i)
      CHECK(CGAL::squared_distance(part[i], whole.supporting_plane()) < 1e-20);
    CHECK(CGAL::squared_distance(CGAL::centroid(part), whole) < 1e-20);
    areas[origin] += std::sqrt(part.squared_area());
  }
  for (const auto f : sheet.mesh.faces())
    CHECK(areas[f] == Approx(CGAL::Polygon_mesh_processing::face_area(f, sheet.mesh)));
}

} // namespace holes_test
