// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/check_T_spline_self_intersections.h>

#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include "Spline/Torus.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <iterator>
#include <set>
#include <vector>

namespace check_T_spline_self_intersections_test {

namespace {

using namespace spline_tests;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
using Point_3 = Kernel::Point_3;
using Face = Torus::face_descriptor;
namespace T = CGAL::T_splines;

Triangles tessellated(Torus& t, const int resolution)
{
  Triangles mesh;
  T::tessellate_T_spline(t.surface(), resolution, mesh);
  return mesh;
}

// Draws a corner of the first face through the tube to the other side.
void pierce(Torus& t)
{
  const auto v = source(t.halfedge_of(0, 0), t.mesh);
  const Point_3 p = t.control(v).point(), axis(3, 0, 0);
  t.set_control(v, axis - 6 * (p - axis), 1);
}

} // namespace

TEST_CASE("a torus does not intersect itself", "[check_T_spline_self_intersections]")
{
  Torus t;
  const Triangles mesh = tessellated(t, 3);
  std::vector<Face> faces;
  for (const int n : {2, 5}) {
    const auto report = T::check_T_spline_self_intersections(t.surface(), mesh, std::back_inserter(faces),
                                                             T::parameters::tessellation_resolution(n));
    CHECK(report);
    CHECK(report.number_of_triangles == 2u * 96 * n * n);
    CHECK(report.number_of_intersections == 0);
    CHECK(report.number_of_mesh_intersections == 0);
    CHECK(faces.empty());
  }
}

TEST_CASE("a surface that is drawn through itself is found, with the faces", "[check_T_spline_self_intersections]")
{
  Torus t;
  const Triangles mesh = tessellated(t, 3);
  pierce(t);
  std::vector<Face> faces;
  const auto report = T::check_T_spline_self_intersections(t.surface(), mesh, std::back_inserter(faces));
  CHECK_FALSE(report);
  CHECK(report.number_of_intersections > 0);
  CHECK(report.number_of_new_intersections == report.number_of_intersections);
  CHECK(report.number_of_mesh_intersections == 0);
  CHECK(std::hypot(report.place.x() - 3, report.place.y(), report.place.z()) < 2);
  // The control point acts on 16 faces, and they meet others on the far side of the tube.
  const auto v = source(t.halfedge_of(0, 0), t.mesh);
  int around = 0;
  for (const Face f : faces)
    for (const auto w : CGAL::vertices_around_face(halfedge(f, t.mesh), t.mesh))
      around += w == v ? 1 : 0;
  CHECK(around > 0);
  CHECK(static_cast<std::size_t>(around) < faces.size());
  CHECK(std::set<Face>(faces.begin(), faces.end()).size() == faces.size());
  std::vector<Face> same;
  const auto compiled = T::compile_T_spline(t.surface());
  CHECK(T::check_T_spline_self_intersections(compiled, mesh, std::back_inserter(same)).number_of_intersections ==
        report.number_of_intersections);
  CHECK(same == faces);
}

TEMPLATE_TEST_CASE("what the mesh does, too, is not new", "[check_T_spline_self_intersections]", Triangles,
                   CGAL::Polyhedron_3<Kernel>)
{
  Torus t;
  pierce(t);
  TestType mesh;
  CGAL::copy_face_graph(tessellated(t, 6), mesh);
  const Point_3 p(100, 0, 0); // a face without area
  CGAL::make_triangle(p, p, p, mesh);
  std::vector<Face> faces;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double longest_side = std::max({box.x_span(), box.y_span(), box.z_span()});
  const auto with = [&](const double distance) {
    faces.clear();
    return T::check_T_spline_self_intersections(t.surface(), mesh, std::back_inserter(faces),
                                                T::parameters::tolerance(distance / longest_side));
  };
  const auto report = with(0.2);
  CHECK(report);
  CHECK(report.number_of_intersections > 0);
  CHECK(report.number_of_mesh_intersections > 0);
  CHECK(report.number_of_new_intersections == 0);
  CHECK(faces.empty());
  // The corners of these triangles lie elsewhere.
  CHECK(with(0).number_of_new_intersections > 0);
}

} // namespace check_T_spline_self_intersections_test
