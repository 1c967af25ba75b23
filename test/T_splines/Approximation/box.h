// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_APPROXIMATION_BOX_H
#define T_SPLINES_TEST_APPROXIMATION_BOX_H

#include <CGAL/T_splines/Approximation/approximate_by_T_spline.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace approximation_tests {

/// The mesh of a box with the corners (0, 0, 0) and (4, 3, 2), of twelve triangles.
template <typename Mesh>
Mesh box()
{
  using Point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Point_3 = typename boost::property_traits<Point_map>::value_type;
  std::vector<Point_3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(4 * (i & 1), 3 * (i >> 1 & 1), 2 * (i >> 2));
  const std::vector<std::array<std::size_t, 3>> triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                                             {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                                             {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

/// Checks that the box as a mesh of another type, or with points of another kernel, has a surface within the tolerance,
/// with about as many control points.
template <typename Mesh>
void check_box()
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  namespace T = CGAL::T_splines;
  const auto np = T::parameters::tolerance(0.05);
  const auto surface_mesh = box<CGAL::Surface_mesh<Kernel::Point_3>>();
  T::T_spline<> expected, spline;
  REQUIRE(T::approximate_by_T_spline(surface_mesh, expected, np).within_tolerance());
  const Mesh mesh = box<Mesh>();
  const auto report = T::approximate_by_T_spline(mesh, spline, np);
  INFO(describe(report, mesh));
  REQUIRE(report.success());
  CHECK(report.within_tolerance());
  CHECK(5 * spline.number_of_control_points() < 6 * expected.number_of_control_points());
}

} // namespace approximation_tests

#endif // T_SPLINES_TEST_APPROXIMATION_BOX_H
