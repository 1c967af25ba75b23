// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/Carried_surface.h>

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>

#include "Spline/Carried_box.h"

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Carried_surface_test {

namespace {

using namespace spline_tests;
namespace T = CGAL::T_splines;
using Mesh = Carried_box::Mesh;
using Polygon = std::vector<std::array<double, 2>>;

// The part of a convex polygon where sign * (x[axis] - bound) <= 0.
Polygon clipped(const Polygon& polygon, const int axis, const double bound, const double sign)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = sign * (p[axis] - bound), b = sign * (q[axis] - bound);
    if (a <= 0)
      result.push_back(p);
    if ((a < 0 && b > 0) || (a > 0 && b < 0))
      result.push_back({p[0] + a / (a - b) * (q[0] - p[0]), p[1] + a / (a - b) * (q[1] - p[1])});
  }
  return result;
}

double area(const Polygon& p)
{
  double result = 0;
  for (std::size_t i = 2; i < p.size(); ++i)
    result += (p[i - 1][0] - p[0][0]) * (p[i][1] - p[0][1]) - (p[i - 1][1] - p[0][1]) * (p[i][0] - p[0][0]);
  return result / 2;
}

// Each face is covered once: the parts of its images inside of it have its area, and each place is one point.
void check_covered(const Carried_box& box)
{
  const T::T_mesh_coordinates coordinates(box.t_mesh);
  std::vector<double> seen(box.surface.triangles().size(), 0);
  for (const auto f : box.t_mesh.graph().faces()) {
    const double width = CGAL::to_double(coordinates.width(f)), height = CGAL::to_double(coordinates.height(f));
    double sum = 0;
    for (const auto& image : box.surface.images(f)) {
      Polygon part(image.corners.begin(), image.corners.end());
      const double whole = area(part);
      REQUIRE(whole > 0);
      part = clipped(clipped(clipped(clipped(part, 0, 0, -1), 0, width, 1), 1, 0, -1), 1, height, 1);
      sum += area(part);
      seen[image.triangle] += area(part) / whole;
    }
    CHECK(sum == Approx(width * height).epsilon(1e-9));
  }
  for (const double share : seen)
    CHECK(share == Approx(1).epsilon(1e-9));
}

} // namespace

TEST_CASE("The faces of a motorcycle graph are covered by the images of all triangles, each once")
{
  check_covered(Carried_box(5, bumpy));
  check_covered(Carried_box(1, plate));
  check_covered(Carried_box(3, bumpy, 1));
}

TEST_CASE("The images stay where they are while faces are split and lines removed")
{
  Carried_box box(4, bumpy);
  CGAL::Random random(2);
  const auto observer = box.surface.observer();
  T::T_mesh_editor editor(box.t_mesh, observer);
  for (int i = 0; i < 60; ++i) {
    const Mesh::Face_index f(
        static_cast<Mesh::size_type>(random.get_int(0, static_cast<int>(box.t_mesh.graph().number_of_faces()))));
    const int axis = random.get_int(0, 2);
    const auto size = axis == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
    REQUIRE(editor.split_face(f, axis, Carried_box::FT(size * random.get_int(1, 4) / 4)));
  }
  check_covered(box);
  const auto report = T::regularize_T_mesh(box.t_mesh, CGAL::T_splines::parameters::observer(observer));
  CHECK(report.removals + report.flips + report.partial_removals > 0);
  check_covered(box);
}

} // namespace Carried_surface_test
