// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/internal/Thin_plate_energy.h>

#include "Spline/Spline_mesh.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace Thin_plate_energy_test {

namespace {

using namespace spline_tests;
namespace I = CGAL::T_splines::internal;
using Mesh = Spline_mesh<Rational>;

} // namespace

TEST_CASE("At extraordinary vertices the energy vanishes for the linear functions of the characteristic map alone")
{
  for (const int valence : {2, 3, 4, 5, 6, 8, 12, 20}) {
    CAPTURE(valence);
    const I::Catmull_clark_evaluator<double> evaluator(valence);
    const I::Cone_face_quadrature<double> quadrature(evaluator);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * valence + 8, 2 * valence + 8);
    for (const auto& point : quadrature.points()) {
      Eigen::MatrixXd derivatives(5, matrix.cols());
      for (Eigen::Index i = 0; i < matrix.cols(); ++i)
        for (int k = 0; k < 5; ++k)
          derivatives(k, i) = point.jets[i][k + 1];
      matrix += (point.form * derivatives).transpose() * (point.form * derivatives);
    }
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    CHECK(values[2] < 1e-10 * values[values.size() - 1]); // 1, x and y
    if (valence > 2 && valence < 8) // of the many functions at a higher valence, some depend on others in one face
      CHECK(values[3] > 1e-8 * values[values.size() - 1]);
    CHECK(values[values.size() - 1] < 100); // nothing grows towards the vertex
  }
}

TEST_CASE("In other faces the energy is the integral of the squared second derivatives of the surface")
{
  CGAL::Random random(8);
  Mesh t(torus_with_two_cones<Rational>());
  REQUIRE(t.make_spline_compatible());
  t.split_randomly(10, random);
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  const auto surface = t.surface();
  std::vector<double> weights;
  for (const auto& p : surface.homogeneous_control_points())
    weights.push_back(p[3]);
  I::Face_functions<double> functions(surface.basis(), weights);
  I::Thin_plate_energy<double> energy(surface.basis());
  for (int f = 0; f < surface.t_mesh_arrays().number_of_faces(); ++f) {
    const auto face = surface.indexing().face(f);
    if (surface.is_at_extraordinary_vertex(face))
      continue;
    functions.enter(f);
    const Eigen::MatrixXd matrix = energy.matrix(functions).selfadjointView<Eigen::Lower>();
    double of_matrix = 0;
    for (int k = 0; k < 3; ++k) {
      Eigen::VectorXd x(matrix.cols());
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        const auto& p = surface.homogeneous_control_points()[functions.vertices()[i]];
        x[i] = p[k] / p[3];
      }
      of_matrix += x.dot(matrix * x);
    }
    constexpr int n = 96; // midpoints
    const double width = surface.width(face), height = surface.height(face);
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto jet = surface.jet(face, width * (i + 0.5) / n, height * (j + 0.5) / n);
        sum += jet.duu.squared_length() + 2 * jet.duv.squared_length() + jet.dvv.squared_length();
      }
    // In the unit of length in which the face has area 1.
    CHECK(of_matrix == Approx(sum / (n * n) * width * height * width * height).epsilon(0.01));
  }
}

} // namespace Thin_plate_energy_test
