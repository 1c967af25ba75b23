// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/fit_T_spline.h>

#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>
#include <CGAL/T_splines/Spline/insert_knot_line.h>
#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>

#include "Spline/Spline_mesh.h"

#include <Eigen/IterativeLinearSolvers>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace fit_T_spline_test {

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
  for (const auto f : faces(surface.graph()))
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
    for (const auto v : t.mesh.vertices()) {
      points[v] = Point_3(0, 0, 0);
      weights[v] = t.control(v).weight();
    }
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
      const auto report = T::fit_T_spline(t, samples, fitted.points, np);
      REQUIRE(report.status == Status::FITTED);
      CHECK(report.error.maximum < 1e-11);
      CHECK(fitted.largest_distance(t) < 1e-9);
      CHECK(report.number_of_control_points == t.mesh.number_of_vertices());
      CHECK(report.number_of_samples == samples.size());
    }
}

TEST_CASE("A surface that is a T-spline stays as it is when its samples are moved and smoothed a little")
{
  CGAL::Random random(3);
  Mesh t(test_t_meshes::cube<Rational>());
  prepare(t, 0, random);
  std::vector<Sample> samples = samples_of(t.surface(), 6);
  Fitted fitted(t);
  SECTION("corrections")
  {
    const auto report =
        T::fit_T_spline(t, samples, fitted.points, P::vertex_weight_map(fitted.weights, P::fairness(0.)));
    REQUIRE(report.success());
    CHECK(fitted.largest_distance(t) < 1e-9);
  }
  SECTION("the error is of the order of the fairness")
  {
    double last = 0;
    for (const double fairness : {1e-6, 1e-8}) {
      std::vector<Sample> again = samples;
      const auto np = P::vertex_weight_map(fitted.weights, P::fairness(fairness)).number_of_iterations(0);
      REQUIRE(T::fit_T_spline(t, again, fitted.points, np));
      const double distance = fitted.largest_distance(t);
      CHECK(distance > 0);
      if (last > 0)
        CHECK(distance / last == Approx(0.01).epsilon(0.05));
      last = distance;
    }
  }
}

TEST_CASE("Samples that the T-mesh carries are fitted to as they are")
{
  // Where knot lines are inserted, the surface stays the same: so it is reproduced on the changed T-mesh, too.
  CGAL::Random random(5);
  Mesh t(test_t_meshes::torus<Rational>(6, 5));
  prepare(t, 0, random);
  T::Carried_samples<Surface_mesh, Sample> carried(samples_of(t.surface(), 6));
  int lines = 0;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 8; ++i) {
      const auto f = *std::next(t.mesh.faces().begin(), random.get_int(0, static_cast<int>(t.mesh.number_of_faces())));
      const int axis = random.get_int(0, 2);
      const T::T_mesh_coordinates coordinates(t);
      const Rational size = axis == 0 ? coordinates.width(f) : coordinates.height(f);
      lines +=
          T::insert_knot_line(t, t.controls(), f, axis, Rational(size / 2), P::observer(carried.observer())).success();
    }
    Fitted fitted(t);
    const auto report =
        T::fit_T_spline(t, carried.samples(), fitted.points, P::vertex_weight_map(fitted.weights, P::fairness(0.)));
    REQUIRE(report.status == Status::FITTED);
    CHECK(report.error.maximum < 1e-9);
    CHECK(fitted.largest_distance(t) < 1e-7);
    t.mesh.remove_property_map(fitted.points);
    t.mesh.remove_property_map(fitted.weights);
  }
  CHECK(lines > 3);
}

TEST_CASE("Fits follow similarity transformations of the samples, and do not depend on the units of knots")
{
  CGAL::Random random(11);
  Mesh t(test_t_meshes::genus_two<Rational>());
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  // Not a T-spline, and sampled at random places.
  std::vector<Sample> samples = samples_of(t.surface(), 4);
  for (Sample& sample : samples) {
    sample.point = sample.point + Kernel::Vector_3(random.get_double(), random.get_double(), random.get_double()) * 0.1;
    sample.weight *= random.get_double(0.5, 2.);
  }
  const auto fit = [&](const std::vector<Sample>& given) {
    std::vector<Sample> moved = given;
    Fitted fitted(t);
    const auto report = T::fit_T_spline(t, moved, fitted.points, CGAL::parameters::number_of_iterations(0));
    REQUIRE(report.success());
    std::vector<Point_3> points;
    for (const auto v : t.mesh.vertices())
      points.push_back(fitted.points[v]);
    return points;
  };
  const std::vector<Point_3> points = fit(samples);
  SECTION("turned, scaled and moved far away")
  {
    const auto image = [](const Point_3& p) { return Point_3(3 * p.y() + 1e4, -3 * p.x(), 3 * p.z() - 1e3); };
    std::vector<Sample> images = samples;
    for (Sample& sample : images) {
      sample.point = image(sample.point);
      sample.weight *= 9;
    }
    const std::vector<Point_3> image_points = fit(images);
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(std::sqrt(CGAL::squared_distance(image_points[i], image(points[i]))) < 1e-8);
  }
  SECTION("other units of the faces")
  {
    // All intervals of a face, and the samples' places, times 2, 3 or 5.
    for (const auto f : t.mesh.faces()) {
      const int factor = std::vector<int>{2, 3, 5}[static_cast<std::size_t>(f) % 3];
      for (const auto h : CGAL::halfedges_around_face(t.mesh.halfedge(f), t.mesh))
        put(t.knots(), h, Rational(get(t.knots(), h) * Rational(factor)));
      for (Sample& sample : samples)
        if (sample.place.face == f) {
          sample.place.u *= factor;
          sample.place.v *= factor;
        }
    }
    const std::vector<Point_3> other_points = fit(samples);
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(std::sqrt(CGAL::squared_distance(other_points[i], points[i])) < 1e-10);
  }
}

TEST_CASE("Conjugate gradients give the same fit as a factorization")
{
  using Gradients = Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower>;
  CGAL::Random random(5);
  Mesh t(torus_with_two_cones<Rational>());
  prepare(t, 10, random);
  std::vector<Sample> samples = samples_of(t.surface(), 5), again = samples;
  Fitted direct(t), iterative(t);
  T::Eigen_spd_solver_traits<Gradients> solver;
  solver.solver().setTolerance(1e-13);
  REQUIRE(T::fit_T_spline(t, samples, direct.points, CGAL::parameters::number_of_iterations(0)));
  REQUIRE(T::fit_T_spline(t, again, iterative.points,
                          CGAL::parameters::number_of_iterations(0).sparse_linear_solver(std::ref(solver))));
  for (const auto v : t.mesh.vertices())
    CHECK(std::sqrt(CGAL::squared_distance(direct.points[v], iterative.points[v])) < 1e-9);
}

TEST_CASE("Moving the samples reduces the distances, and leaves the samples on the T-mesh")
{
  CGAL::Random random(9);
  Mesh t(test_t_meshes::cube<Rational>());
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  std::vector<Sample> samples = samples_of(t.surface(), 5);
  // Of a sphere, in places that the fit has to correct.
  for (Sample& sample : samples) {
    const Kernel::Vector_3 p = sample.point - CGAL::ORIGIN;
    sample.point = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
  }
  Fitted fitted(t);
  const auto report = T::fit_T_spline(t, samples, fitted.points);
  REQUIRE(report.success());
  CHECK(report.number_of_corrections > 0);
  CHECK(report.error.rms < report.first_error.rms);
  const auto surface = T::T_spline_surface(t, fitted.points);
  double sum = 0, weight = 0, maximum = 0;
  for (const Sample& sample : samples) {
    REQUIRE(sample.place.u >= 0);
    REQUIRE(sample.place.u <= surface.width(sample.place.face));
    REQUIRE(sample.place.v >= 0);
    REQUIRE(sample.place.v <= surface.height(sample.place.face));
    const double d =
        CGAL::squared_distance(surface.position(sample.place.face, sample.place.u, sample.place.v), sample.point);
    sum += sample.weight * d;
    weight += sample.weight;
    maximum = std::max(maximum, d);
  }
  CHECK(report.error.rms == Approx(std::sqrt(sum / weight)));
  CHECK(report.error.maximum == Approx(std::sqrt(maximum)));
  const Sample& worst = samples[report.sample];
  CHECK(std::sqrt(CGAL::squared_distance(surface.position(worst.place.face, worst.place.u, worst.place.v),
                                         worst.point)) == Approx(report.error.maximum));
  CHECK(report.error.extent == Approx(2).epsilon(0.1));
}

TEST_CASE("An open surface is reproduced, with samples that are moved along the border")
{
  CGAL::Random random(13);
  Mesh t(test_t_meshes::rectangle<Rational>(5, 4));
  prepare(t, 8, random);
  std::vector<Sample> samples = samples_of(t.surface(), 6);
  for (Sample& sample : samples) // many are moved to the border, from where the correction takes them back
    sample.place.u = std::max(0., sample.place.u - 0.1);
  const std::vector<Sample> exact = samples_of(t.surface(), 6);
  Fitted fitted(t);
  const auto np = P::vertex_weight_map(fitted.weights, P::fairness(1e-9)).number_of_iterations(20);
  const auto report = T::fit_T_spline(t, samples, fitted.points, np);
  REQUIRE(report.success());
  CHECK(report.error.rms < 0.5 * report.first_error.rms);
  samples = exact;
  REQUIRE(T::fit_T_spline(t, samples, fitted.points, P::vertex_weight_map(fitted.weights, P::fairness(0.))));
  CHECK(fitted.largest_distance(t) < 1e-9);
}

TEST_CASE("Bad input of a fit is refused, and leaves control points and samples alone")
{
  CGAL::Random random(1);
  Mesh t(test_t_meshes::cube<Rational>());
  prepare(t, 0, random);
  std::vector<Sample> samples = samples_of(t.surface(), 3);
  Fitted fitted(t);
  const auto fit = [&](const auto& np) {
    const std::vector<Sample> before = samples;
    const auto report = T::fit_T_spline(t, samples, fitted.points, np);
    for (const auto v : t.mesh.vertices())
      CHECK(fitted.points[v] == Point_3(CGAL::ORIGIN));
    for (std::size_t i = 0; i < samples.size(); ++i)
      CHECK(samples[i].place.face == before[i].place.face);
    return report;
  };
  const auto defaults = CGAL::parameters::default_values();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  SECTION("fairness")
  {
    CHECK(fit(P::fairness(-1.)).status == Status::INVALID_FAIRNESS);
    CHECK(fit(P::fairness(nan)).status == Status::INVALID_FAIRNESS);
  }
  SECTION("no samples")
  {
    samples.clear();
    CHECK(fit(defaults).status == Status::NO_SAMPLES);
  }
  SECTION("samples without weight")
  {
    for (Sample& sample : samples)
      sample.weight = 0;
    CHECK(fit(defaults).status == Status::NO_SAMPLES);
  }
  SECTION("invalid samples")
  {
    const Sample good = samples[4];
    samples[4].point = Point_3(0, nan, 0);
    CHECK(fit(defaults).status == Status::INVALID_SAMPLE);
    samples[4] = good;
    samples[4].weight = -1;
    CHECK(fit(defaults).status == Status::INVALID_SAMPLE);
    samples[4] = good;
    samples[4].place.u = -0.5;
    const auto report = fit(defaults);
    CHECK(report.status == Status::INVALID_SAMPLE);
    CHECK(report.sample == 4);
    CHECK(describe(report, t.mesh).find("sample 4") != std::string::npos);
  }
  SECTION("too few samples without fairness")
  {
    samples.resize(20);
    CHECK(fit(P::fairness(0.)).status == Status::UNDERDETERMINED);
  }
  SECTION("weights")
  {
    fitted.weights[*t.mesh.vertices().begin()] = 0;
    const auto report = fit(P::vertex_weight_map(fitted.weights));
    CHECK(report.status == Status::INVALID_SURFACE);
    CHECK(report.surface.status == T::T_spline_status::WEIGHT_NOT_POSITIVE);
  }
  SECTION("faces of another T-mesh, none, and one that was removed")
  {
    const auto given = samples;
    for (const auto face : {Surface_mesh::Face_index(100000), Surface_mesh::null_face()}) {
      samples = given;
      samples[7].place.face = face;
      const auto report = fit(CGAL::parameters::default_values());
      CHECK(report.status == Status::INVALID_SAMPLE);
      CHECK(report.sample == 7);
      CHECK(describe(report, t.mesh).find("has a face that the T-mesh does not have: sample 7") != std::string::npos);
    }
    samples = given;
  }
  SECTION("a T-mesh that is not spline compatible")
  {
    Mesh cube(test_t_meshes::cube<Rational>());
    const auto f = *cube.mesh.faces().begin();
    std::vector<Sample> one{{{f, 0.5, 0.5}, Point_3(0, 0, 0), 1}};
    const auto points = cube.mesh.add_property_map<Surface_mesh::Vertex_index, Point_3>("v:fitted").first;
    const auto report = T::fit_T_spline(cube, one, points);
    CHECK(report.status == Status::INVALID_SURFACE);
    CHECK_FALSE(describe(report, cube.mesh).empty());
  }
}

TEST_CASE("Too few samples do with some fairness")
{
  CGAL::Random random(1);
  Mesh t(test_t_meshes::cube<Rational>());
  prepare(t, 0, random);
  std::vector<Sample> samples;
  for (const auto& sample : samples_of(t.surface(), 3))
    if (samples.size() < 20)
      samples.push_back({sample.place, Point_3(1, 2, 3), 1});
  Fitted fitted(t);
  REQUIRE(T::fit_T_spline(t, samples, fitted.points));
  for (const auto v : t.mesh.vertices()) // constants have no energy
    CHECK(std::sqrt(CGAL::squared_distance(fitted.points[v], Point_3(1, 2, 3))) < 1e-7);
}

} // namespace fit_T_spline_test
