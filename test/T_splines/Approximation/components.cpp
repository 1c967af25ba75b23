// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh of several components becomes one surface with all of them.

#include <CGAL/T_splines/Approximation/approximate_by_T_spline.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include "box.h"
#include "open_meshes.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace components_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;

/// Copies a mesh beside another one, scaled such that its longest side is `size`.
void add(Mesh part, const double x, const double size, Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(part);
  const double scale = size / std::max({box.x_span(), box.y_span(), box.z_span()});
  for (const Vertex v : part.vertices()) {
    const Point_3& p = part.point(v);
    part.point(v) =
        Point_3(x + scale * (p.x() - box.xmin()), scale * (p.y() - box.ymin()), scale * (p.z() - box.zmin()));
  }
  CGAL::copy_face_graph(part, mesh);
}

/// The boxes of the components from left to right.
template <typename Graph>
std::vector<CGAL::Bbox_3> boxes_of_components(Graph& mesh)
{
  auto component = mesh.template add_property_map<typename Graph::Face_index, std::size_t>("f:component").first;
  std::vector<CGAL::Bbox_3> boxes(CGAL::Polygon_mesh_processing::connected_components(mesh, component));
  for (const auto f : mesh.faces())
    boxes[component[f]] += CGAL::Polygon_mesh_processing::face_bbox(f, mesh);
  mesh.remove_property_map(component);
  std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.xmin() < b.xmin(); });
  return boxes;
}

template <typename Graph>
std::size_t number_of_borders(const Graph& mesh)
{
  std::vector<typename boost::graph_traits<Graph>::halfedge_descriptor> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  return borders.size();
}

} // namespace

TEST_CASE("closed and open components of any size become one surface with all of them")
{
  Mesh mesh;
  add(approximation_tests::box<Mesh>(), 0, 1, mesh);
  add(plate(6, 4), 2, 1, mesh);
  add(annulus(3, 48, 6), 4, 1, mesh);
  add(approximation_tests::box<Mesh>(), 6, 0.01, mesh); // hardly larger than the tolerance
  const std::vector<CGAL::Bbox_3> wanted = boxes_of_components(mesh);
  REQUIRE(wanted.size() == 4);
  REQUIRE(number_of_borders(mesh) == 3);

  T::T_spline<> spline;
  const auto report = T::approximate_by_T_spline(mesh, spline);
  CAPTURE(describe(report, mesh));
  REQUIRE(report.within_tolerance());
  Mesh surface;
  REQUIRE(T::tessellate_T_spline(spline.surface(), 8, surface));
  CHECK(number_of_borders(surface) == 3);
  const std::vector<CGAL::Bbox_3> actual = boxes_of_components(surface);
  REQUIRE(actual.size() == wanted.size());
  const double tolerance = T::default_tolerance * report.fit.deviation.mesh_to_surface.extent;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(std::abs(actual[i].min(axis) - wanted[i].min(axis)) <= tolerance);
      CHECK(std::abs(actual[i].max(axis) - wanted[i].max(axis)) <= tolerance);
    }
}

} // namespace components_test
