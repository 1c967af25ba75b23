// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are fitted to open meshes end where these end.

#include <CGAL/T_splines/Approximation/approximate_by_T_spline.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include "open_meshes.h"

#include <CGAL/Segment_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace border_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;
using Segment = Kernel::Segment_3;

std::vector<Segment> border_of(const Mesh& mesh)
{
  std::vector<Segment> result;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      result.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return result;
}

/// The largest distance of points of segments from others.
double distance(const std::vector<Segment>& from, const std::vector<Segment>& to)
{
  constexpr int parts = 24;
  double largest = 0;
  for (const Segment& s : from)
    for (int i = 0; i < parts; ++i) {
      const Point_3 p = s.source() + i * (s.target() - s.source()) / parts;
      double nearest = std::numeric_limits<double>::infinity();
      for (const Segment& t : to)
        nearest = std::min(nearest, CGAL::squared_distance(p, t));
      largest = std::max(largest, std::sqrt(nearest));
    }
  return largest;
}

Mesh hemisphere()
{
  Mesh mesh = disk(16);
  for (const Vertex v : mesh.vertices()) {
    const Point_3 p = mesh.point(v);
    const double r = std::hypot(p.x(), p.y()), angle = r * CGAL_PI / 2;
    const double factor = r > 0 ? std::sin(angle) / r : 1;
    mesh.point(v) = Point_3(factor * p.x(), factor * p.y(), std::cos(angle));
  }
  return mesh;
}

Mesh tube()
{
  Mesh mesh = annulus(std::exp(2.), 60, 20);
  for (const Vertex v : mesh.vertices()) {
    const Point_3 p = mesh.point(v);
    const double r = std::hypot(p.x(), p.y()), height = std::log(r);
    mesh.point(v) = Point_3(p.x() / r, p.y() / r, height + 0.2 * p.x() * p.x() / (r * r));
  }
  return mesh;
}

Mesh wavy(Mesh mesh)
{
  for (const Vertex v : mesh.vertices()) {
    const Point_3 p = mesh.point(v);
    mesh.point(v) = Point_3(p.x(), p.y(), std::sin(p.x() / 4) * std::cos(p.y() / 5));
  }
  return mesh;
}

Mesh wavy_plate()
{
  return wavy(plate(24, 16));
}

} // namespace

TEST_CASE("the border of the surface is that of the mesh, within the tolerance, both ways", "[border]")
{
  // The last four have corners that turn inwards, of three quarters and of four.
  for (Mesh mesh : {hemisphere(), tube(), wavy_plate(), wavy(l_shape(20)), wavy(slit_plate(16, 2)), slit_plate(16, 1),
                    wavy(perforated_plate(2, 3))}) {
    T::T_spline<Kernel> spline;
    const auto report = T::approximate_by_T_spline(mesh, spline);
    INFO(describe(report, mesh));
    REQUIRE(report.within_tolerance());
    CHECK(report.fit.deviation.normals.number_of_folded_patches == 0);
    CHECK(report.fit.self_intersections.number_of_new_intersections == 0);
    Mesh surface;
    REQUIRE(T::tessellate_T_spline(spline.surface(), 32, surface));
    const std::vector<Segment> wanted = border_of(mesh), actual = border_of(surface);
    REQUIRE_FALSE(actual.empty());
    const double tolerance = T::default_tolerance * report.fit.deviation.mesh_to_surface.extent;
    CHECK(distance(actual, wanted) <= tolerance);
    CHECK(distance(wanted, actual) <= tolerance);
    // The report says the same; the points find almost all of it.
    REQUIRE(report.fit.deviation.free_edge);
    const auto& free_edge = *report.fit.deviation.free_edge;
    CHECK(free_edge.surface_to_mesh.maximum == Approx(distance(actual, wanted)).epsilon(0.02));
    CHECK(free_edge.mesh_to_surface.maximum == Approx(distance(wanted, actual)).epsilon(0.02));
    CHECK(free_edge.largest_corner_distance <= 1e-12);
  }
}

// The lines of corners that face each other miss each other by little.
TEST_CASE("a plate with rows of square holes has a surface without folds", "[border]")
{
  for (const int holes : {3, 4}) {
    INFO(holes);
    const Mesh mesh = wavy(perforated_plate(holes, 3));
    T::T_spline<Kernel> spline;
    const auto report = T::approximate_by_T_spline(mesh, spline);
    INFO(describe(report, mesh));
    CHECK(report.within_tolerance());
    CHECK(report.fit.deviation.normals.number_of_folded_patches == 0);
    CHECK(report.fit.self_intersections.number_of_new_intersections == 0);
    CHECK(report.regularization.worst_aspect_before > 1000);
    CHECK(report.regularization.worst_aspect_after < 10);
  }
}

TEST_CASE("the surface goes through the corners of the mesh", "[border]")
{
  Mesh mesh = wavy_plate();
  T::T_spline<Kernel> spline;
  const auto report = T::approximate_by_T_spline(mesh, spline);
  REQUIRE(report);
  CHECK(report.fit.deviation.free_edge->number_of_corners == 4);
  CHECK(report.fit.deviation.free_edge->largest_corner_distance <= 1e-12);
  const auto surface = spline.surface();
  const T::T_mesh_coordinates coordinates(spline);
  int corners = 0;
  for (const auto v : spline.graph().vertices())
    if (T::is_border_vertex(v, spline) && T::extended_valence(v, spline) == 1)
      for (const auto h : CGAL::halfedges_around_target(spline.graph().halfedge(v), spline.graph()))
        if (!spline.graph().is_border(h)) {
          const auto place = coordinates.target_point(h);
          const Point_3 p = surface.position(spline.graph().face(h), place.first, place.second);
          double nearest = std::numeric_limits<double>::infinity();
          for (const double x : {0., 24.})
            for (const double y : {0., 16.})
              nearest = std::min(nearest, CGAL::squared_distance(p, Point_3(x, y, std::sin(x / 4) * std::cos(y / 5))));
          CHECK(std::sqrt(nearest) <= 1e-12);
          ++corners;
        }
  CHECK(corners == 4);
}

TEST_CASE("a flat mesh with holes becomes a flat surface", "[border]")
{
  for (Mesh mesh : {annulus(3, 48, 12), l_shape(12), slit_plate(12, 0.5), perforated_plate(2, 4)}) {
    T::T_spline<Kernel> spline;
    const auto report = T::approximate_by_T_spline(mesh, spline);
    INFO(describe(report, mesh));
    REQUIRE(report.within_tolerance());
    Mesh surface;
    REQUIRE(T::tessellate_T_spline(spline.surface(), 8, surface));
    for (const Vertex v : surface.vertices())
      REQUIRE(std::abs(surface.point(v).z()) <= 1e-12);
  }
}

TEST_CASE("faces with two edges on the border, and corners of four quarters where scale factors differ", "[border]")
{
  for (const std::string name : {"blobby_3cc.off", "pig.off"}) {
    Mesh mesh;
    REQUIRE(T::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
    T::T_spline<Kernel> spline;
    const auto report = T::approximate_by_T_spline(mesh, spline);
    INFO(name << ": " << describe(report, mesh));
    CHECK(report.within_tolerance());
  }
}

} // namespace border_test
