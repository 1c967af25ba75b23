// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Solver/Spd_solver_traits_archetype.h"
#include "test_meshes.h"

#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace compute_similarity_metric_test {

namespace {

namespace T = CGAL::T_splines;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Signature = T::Holonomy_signature<Mesh>;
using Status = T::Similarity_map_status;
using Wide = boost::multiprecision::cpp_bin_float_50;

Signature signature_of(const Mesh& mesh, const std::vector<std::pair<int, int>>& cones)
{
  std::vector<Signature::Cone> list;
  for (const auto& cone : cones)
    list.emplace_back(Vertex(cone.first), cone.second);
  Signature signature;
  REQUIRE(T::holonomy_signature_of_cones(mesh, list, signature).success());
  return signature;
}

// The largest deviation of the metric's angle sums from the signature's cones.
template <typename FT>
FT cone_deviation(const T::Similarity_metric<Mesh, FT>& metric, const Mesh& mesh, const Signature& signature)
{
  using std::abs;
  using std::atan2;
  std::map<Vertex, FT> sum;
  for (int f = 0; f < metric.number_of_faces(); ++f) {
    const std::array<FT, 3> angle = metric.angles(f);
    int opposite_side = metric.halfedge(f);
    for (int i = 0; i < 3; ++i, opposite_side = metric.next(opposite_side))
      sum[metric.target(metric.next(opposite_side))] += angle[i];
  }
  FT worst(0);
  const FT quarter = 2 * atan2(FT(1), FT(1));
  for (const Vertex v : mesh.vertices())
    worst = std::max(worst, FT(abs(sum.at(v) - signature.quarter_turns(v) * quarter)));
  return worst;
}

Mesh torus()
{
  return test_meshes::face_graph<Mesh>(test_meshes::torus(12, 9));
}

} // namespace

TEST_CASE("the metric has the cones and is conformal to the mesh", "[compute_similarity_metric]")
{
  const Mesh mesh = test_meshes::face_graph<Mesh>(test_meshes::sphere(2));
  const Signature signature = signature_of(mesh, {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}, {6, 3}, {7, 3}});
  T::Similarity_metric<Mesh> metric;
  const auto report = T::compute_similarity_metric(mesh, signature, metric);
  REQUIRE(report.success());
  CHECK(cone_deviation(metric, mesh, signature) <= 1e-12);
  REQUIRE(report.flips + report.delaunay_flips == 0); // then edges are those of the mesh
  std::vector<double> log_scale(mesh.number_of_vertices());
  for (int i = 0; i < metric.number_of_vertices(); ++i)
    log_scale[i] = metric.log_scale(i);
  for (int f = 0; f < metric.number_of_faces(); ++f) {
    const std::array<double, 3> length = metric.lengths(f);
    std::array<double, 3> expected;
    int h = metric.halfedge(f);
    for (int i = 0; i < 3; ++i, h = metric.next(h)) {
      const Vertex v = metric.target(h), w = metric.target(metric.opposite(h));
      expected[i] =
          std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))) * std::exp((log_scale[v] + log_scale[w]) / 2);
    }
    for (int i = 1; i < 3; ++i)
      CHECK(length[i] / length[0] == Approx(expected[i] / expected[0]).epsilon(1e-12));
  }
}

TEST_CASE("xi is closed, and opposite on opposite halfedges", "[compute_similarity_metric]")
{
  const Mesh mesh = torus();
  T::Similarity_metric<Mesh> metric;
  REQUIRE(T::compute_similarity_metric(mesh, signature_of(mesh, {{5, 3}, {60, 5}}), metric).success());
  for (int f = 0; f < metric.number_of_faces(); ++f) {
    const int h = metric.halfedge(f), j = metric.next(h), k = metric.next(j);
    CHECK(std::abs(metric.form(h) + metric.form(j) + metric.form(k)) <= 1e-13);
    CHECK(metric.form(metric.opposite(h)) == -metric.form(h));
    CHECK(metric.face(h) == f);
    CHECK(metric.next(k) == h);
  }
}

TEST_CASE("fifty digits", "[compute_similarity_metric]")
{
  const Mesh mesh = test_meshes::face_graph<Mesh>(test_meshes::torus(6, 4));
  const Signature signature = signature_of(mesh, {{5, 3}, {15, 5}});
  T::Similarity_metric<Mesh, Wide> metric;
  const auto np = T::parameters::number_type(Wide(), T::parameters::residual_tolerance(1e-40));
  const auto report = T::compute_similarity_metric(mesh, signature, metric, np);
  REQUIRE(report.success());
  CHECK(report.residual <= 1e-40);
  CHECK(cone_deviation(metric, mesh, signature) <= Wide("1e-40"));
}

TEST_CASE("any model of the solver's concept will do", "[compute_similarity_metric]")
{
  const Mesh mesh = torus();
  const Signature signature = signature_of(mesh, {{5, 3}, {60, 5}});
  Spd_solver_traits_archetype solver;
  T::Similarity_metric<Mesh> metric;
  const auto np = CGAL::parameters::sparse_linear_solver(std::ref(solver));
  REQUIRE(T::compute_similarity_metric(mesh, signature, metric, np).success());
  CHECK(cone_deviation(metric, mesh, signature) <= 1e-12);
}

TEST_CASE("the paper's flips give the same metric where they get through", "[compute_similarity_metric]")
{
  const Mesh mesh = torus();
  const Signature signature = signature_of(mesh, {{5, 3}, {60, 5}});
  T::Similarity_metric<Mesh> metric;
  const T::Degeneracy_flips policy{GENERATE(false, true)};
  const auto report = T::compute_similarity_metric(mesh, signature, metric, T::parameters::flip_policy(policy));
  REQUIRE(report.success());
  CHECK(cone_deviation(metric, mesh, signature) <= 1e-12);
}

TEST_CASE("a stop is not a success", "[compute_similarity_metric]")
{
  // All curvature in few points of a coarse mesh.
  const Mesh mesh = test_meshes::face_graph<Mesh>(test_meshes::sphere(1));
  const Signature signature =
      signature_of(mesh, {{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 1}, {7, 12}, {8, 9}});
  T::Similarity_metric<Mesh> metric;
  const T::Degeneracy_flips policy{GENERATE(false, true)};
  const auto report = T::compute_similarity_metric(mesh, signature, metric, T::parameters::flip_policy(policy));
  INFO(T::message(report.status) << ", residual " << report.residual << ", iterations " << report.iterations);
  CHECK(report.success() == (report.residual <= 1e-12));
  if (!report.success()) {
    CHECK(metric.number_of_faces() == 0);
    CHECK((report.vertex != Mesh::null_vertex() || report.loop != report.no_loop));
  }
  else
    CHECK(cone_deviation(metric, mesh, signature) <= 1e-12);
  // Ideal Delaunay flips always get through on a sphere.
  REQUIRE(T::compute_similarity_metric(mesh, signature, metric).success());
  CHECK(cone_deviation(metric, mesh, signature) <= 1e-12);
}

} // namespace compute_similarity_metric_test
