// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/fit_T_spline.h>

#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include "Spline/Planar_t_mesh.h"
#include "Spline/Spline_mesh.h"

#include <Eigen/IterativeLinearSolvers>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace spline_tests;
namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Mesh = Spline_mesh<Rational>;
using Sample = T::T_mesh_sample<Surface_mesh, Kernel>;
using Status = T::T_spline_fit_status;
using Point_3 = Kernel::Point_3;

void prepare(Mesh& t, const int splits, CGAL::Random& random)
{
  if (splits > 0) {
    REQUIRE(t.make_spline_compatible());
    t.split_randomly(splits, random);
  }
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
}

// Of a surface, in n x n places of each face, inside of the face; the weights of a face add up to 1.
template <typename Surface>
std::vector<Sample> samples_of(const Surface& surface, const int n)
{
  std::vector<Sample> result;
  for (const auto f : faces(surface.t_mesh()))
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double u = surface.width(f) * (i + 0.5) / n, v = surface.height(f) * (j + 0.5) / n;
        result.push_back({{f, u, v}, surface.position(f, u, v), 1. / (n * n)});
      }
  return result;
}

struct Fitted {
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, Point_3> points;
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, double> weights;

  explicit Fitted(Mesh& t)
    : points(t.mesh.add_property_map<Surface_mesh::Vertex_index, Point_3>("v:fitted").first),
      weights(t.mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:weight", 1.).first)
  {
    for (const auto v : t.mesh.vertices())
      weights[v] = t.control(v).weight();
  }

  double largest_distance(const Mesh& t) const
  {
    double result = 0;
    for (const auto v : t.mesh.vertices())
      result = std::max(result, std::sqrt(CGAL::squared_distance(points[v], t.control(v).point())));
    return result;
  }
};

} // namespace

TEST_CASE("A surface that is a T-spline is reproduced")
{
  for (const int splits : {0, 20})
    for (const auto& [name, faces] : closed_surfaces<Rational>()) {
      if (name == "folded square" && splits > 0)
        continue; // its random refinements may not become spline compatible
      CAPTURE(name, splits);
      CGAL::Random random(7);
      Mesh t(faces);
      prepare(t, splits, random);
      std::vector<Sample> samples = samples_of(t.surface(), 6);
      Fitted fitted(t);
      const auto np = P::vertex_weight_map(fitted.weights, P::fairness(0.)).number_of_iterations(0);
      const auto report = T::fit_T_spline(t.mesh, t.knots(), t.corners(), samples, fitted.points, np);
      REQUIRE(report.status == Status::FITTED);
      CHECK(report.error.maximum < 1e-11);
      CHECK(fitted.largest_distance(t) < 1e-9);
      CHECK(report.number_of_control_points == t.mesh.number_of_vertices());
      CHECK(report.number_of_samples == samples.size());
    }
}
