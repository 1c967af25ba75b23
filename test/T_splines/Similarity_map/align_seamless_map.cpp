// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Counting_visitor.h"
#include "Seamless_map_checker.h"
#include "feature_meshes.h"
#include "open_meshes.h"

#include <CGAL/T_splines/Approximation/Mapped_mesh.h>
#include <CGAL/T_splines/Cross_field/compute_feature_aligned_cross_field.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Similarity_map/align_seamless_map.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/cross_field_of_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>

#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace align_seamless_map_test {

namespace {

namespace ts = CGAL::T_splines;
namespace fm = feature_meshes;
using Mesh = open_meshes::Mesh;
using Kernel = open_meshes::Kernel;
using Point_2 = Kernel::Point_2;
using Vector_3 = Kernel::Vector_3;
using Mapped = ts::Mapped_mesh<Mesh>;
using Report = ts::Map_alignment_report<Mapped::Mesh>;
using Status = ts::Map_alignment_status;
using Policy = ts::Scale_policy;

Mesh demo_mesh(const std::string& name)
{
  Mesh mesh;
  REQUIRE(ts::read_triangle_mesh(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name, mesh).success());
  return mesh;
}

// A mesh with a cross field, and the conformal map that has its signature, onto which the field is carried.
struct Scene {
  Mesh given;
  Mesh::Property_map<Mesh::Edge_index, bool> given_features =
      given.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  Mesh::Property_map<Mesh::Face_index, Vector_3> given_field =
      given.add_property_map<Mesh::Face_index, Vector_3>("f:field").first;
  Mesh::Property_map<Mesh::Halfedge_index, int> given_matching =
      given.add_property_map<Mesh::Halfedge_index, int>("h:matching", 0).first;
  ts::Holonomy_signature<Mesh> signature;
  Mapped mapped;
  Mapped::Mesh& mesh = mapped.mesh();
  Mesh::Property_map<Mesh::Face_index, Vector_3> field =
      mesh.add_property_map<Mesh::Face_index, Vector_3>("f:field").first;
  Mesh::Property_map<Mesh::Halfedge_index, int> matching =
      mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching", 0).first;

  // \param angle of features; none, if it is 180
  Scene(const Mesh& original, const double feature_angle, const bool are_cones_reduced = false)
  {
    Mesh copy = original;
    auto features = copy.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
    if (feature_angle < 180)
      REQUIRE(ts::detect_features(copy, features, ts::parameters::feature_angle(feature_angle)).success());
    REQUIRE(ts::refine_at_features(copy, features, given, given_features).success());
    REQUIRE(ts::compute_feature_aligned_cross_field(given, given_features, given_field,
                                                    ts::parameters::halfedge_matching_map(given_matching))
                .success());
    REQUIRE(ts::holonomy_signature_of_cross_field(given, given_field, signature,
                                                  ts::parameters::halfedge_matching_map(given_matching))
                .success());
    if (are_cones_reduced)
      REQUIRE(ts::reduce_cones(
                  given, signature,
                  ts::parameters::cross_field_map(
                      given_field, ts::parameters::halfedge_matching_map(
                                       given_matching, CGAL::parameters::edge_is_constrained_map(given_features))))
                  .success());
    compute_map();
    for (const auto f : mesh.faces())
      field[f] = given_field[mapped.origin(f, given)];
    for (const auto h : mesh.halfedges()) {
      if (mesh.is_border(h))
        continue;
      const auto origin = mapped.origin(h, given);
      if (origin == Mesh::null_halfedge())
        continue;
      matching[h] = given_matching[origin];
      if (given_features[given.edge(origin)])
        mapped.constrained_edges()[mesh.edge(h)] = true;
    }
  }

  // The map of cones, and as the field its isolines.
  Scene(const Mesh& original, const std::vector<std::pair<Mesh::Vertex_index, int>>& cones) : given(original)
  {
    REQUIRE(ts::holonomy_signature_of_cones(given, cones, signature).success());
    compute_map();
    ts::cross_field_of_map(mesh, mapped.uv(), field, ts::parameters::halfedge_matching_map(matching));
  }
  Scene(const Scene&) = delete;

  void compute_map()
  {
    REQUIRE(ts::compute_seamless_similarity_map(
                given, signature, mesh, mapped.uv(),
                ts::parameters::edge_is_cut_map(mapped.cut(), ts::parameters::vertex_location_map(mapped.locations())))
                .success());
  }

  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Report align(const NamedParameters& np = CGAL::parameters::default_values())
  {
    return ts::align_seamless_map(
        mesh, field, mapped.uv(),
        ts::parameters::halfedge_matching_map(matching, np.edge_is_constrained_map(mapped.constrained_edges())));
  }
  Report align(const Policy policy) { return align(ts::parameters::scale_policy(policy)); }

  ts::Exact_map_report<Mapped::Mesh> make_exact()
  {
    return ts::make_exactly_seamless(mesh, mapped.uv(), mapped.reset_map(),
                                     CGAL::parameters::edge_is_constrained_map(mapped.constrained_edges()));
  }

  std::vector<Point_2> corners() const
  {
    std::vector<Point_2> result;
    for (const auto h : mesh.halfedges())
      result.push_back(mesh.is_border(h) ? Point_2(0, 0) : mapped.uv()[h]);
    return result;
  }

  // How many constrained edges are not exactly parallel to an axis, in one of their charts.
  int number_of_oblique_edges() const
  {
    int result = 0;
    for (const auto h : mesh.halfedges()) {
      if (mesh.is_border(h) || !(mapped.constrained_edges()[mesh.edge(h)] || mesh.is_border(mesh.edge(h))))
        continue;
      const auto p = mapped.map().uv(mesh.prev(h)), q = mapped.map().uv(h);
      result += p.first != q.first && p.second != q.second ? 1 : 0;
    }
    return result;
  }

  // How many vertices have another cone angle than the signature says.
  int number_of_wrong_cones() const
  {
    int result = 0;
    for (const auto v : given.vertices()) {
      const int k = given.is_border(v) ? signature.corner_quarter_turns(v) : signature.quarter_turns(v);
      result += mapped.map().quarter_turns(v) != k ? 1 : 0;
    }
    return result;
  }
};

} // namespace

TEST_CASE("The derivatives of the distortion are those of its value, and its Hessian has no negative part")
{
  using ts::internal::Plane_matrix;
  CGAL::Random random(1);
  const ts::internal::Plane_distortion distortion{0.1};
  const auto moved = [](const Plane_matrix& f, const std::array<double, 4>& d, const double t) {
    return Plane_matrix{f.a + t * d[0], f.b + t * d[1], f.c + t * d[2], f.d + t * d[3]};
  };
  int number_of_clamped = 0;
  for (int i = 0; i < 200; ++i) {
    Plane_matrix f;
    do
      f = {random.get_double(-2, 2), random.get_double(-2, 2), random.get_double(-2, 2), random.get_double(-2, 2)};
    while (f.determinant() < 0.1);
    std::array<double, 4> first, d;
    std::array<std::array<double, 4>, 4> second;
    distortion.derivatives(f, first, second);
    for (double& x : d)
      x = random.get_double(-1, 1);
    double slope = 0, curvature = 0;
    for (int k = 0; k < 4; ++k) {
      slope += first[k] * d[k];
      for (int l = 0; l < 4; ++l)
        curvature += d[k] * second[k][l] * d[l];
    }
    const double h = 1e-4, here = distortion.value(f), ahead = distortion.value(moved(f, d, h)),
                 behind = distortion.value(moved(f, d, -h));
    CHECK(slope == Approx((ahead - behind) / (2 * h)).margin(1e-3).epsilon(1e-4));
    const double true_curvature = (ahead - 2 * here + behind) / (h * h);
    CHECK(curvature >= 0);
    CHECK(curvature >= true_curvature - 1e-3 * std::abs(true_curvature) - 1e-3);
    if (curvature > true_curvature + 1e-2 * std::abs(true_curvature))
      ++number_of_clamped;
  }
  CHECK(number_of_clamped < 60); // elsewhere it is the Hessian itself
  CHECK(std::isinf(distortion.value({-1, 0, 0, 1})));
  CHECK(distortion.value({1, 0, 0, 1}) == Approx(0).margin(1e-15));
}

TEST_CASE("Parameters of linear equations give solutions, exactly, and as many as there are")
{
  CGAL::Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    constexpr int n = 40;
    std::vector<ts::internal::Linear_parameters::Row> rows;
    ts::internal::Homogeneous_equations<CGAL::Exact_rational> exact(n);
    for (int i = 0; i < 30; ++i) { // differences of unknowns, and of what two rotations make of them
      const int a = random.get_int(0, n - 2), b = random.get_int(a + 1, n);
      rows.push_back({{a, 1.}, {b, random.get_bool() ? -1. : 1.}});
      ts::internal::Homogeneous_equations<CGAL::Exact_rational>::Row row;
      for (const auto& [unknown, coefficient] : rows.back())
        row.emplace_back(unknown, coefficient);
      row = exact.reduced(row);
      if (!row.empty())
        exact.add(row, row.front().first);
    }
    ts::internal::Linear_parameters parameters(n);
    const int number_of_dependent = parameters.add(rows);
    CHECK(parameters.number_of_parameters() == n - exact.number_of_equations());
    CHECK(number_of_dependent == 30 - exact.number_of_equations());
    std::vector<double> z;
    for (int i = 0; i < parameters.number_of_parameters(); ++i)
      z.push_back(random.get_int(-1000, 1000));
    const std::vector<double> x = parameters.unknowns(z);
    for (const auto& row : rows)
      CHECK(ts::internal::Alignment_energy::value(row, x) == 0);
    CHECK(parameters.parameters(x) == z);
  }
}

TEST_CASE("A map comes nearer to its field, and keeps cones and seams")
{
  for (const char* const name : {"elephant.off", "eight.off", "bones.off"}) {
    INFO(name);
    Scene scene(demo_mesh(name), 180);
    const Report report = scene.align();
    REQUIRE(report.status == Status::ALIGNED);
    CHECK(report.rotated.mean <= report.before.mean);
    CHECK(report.after.mean < 0.7 * report.rotated.mean);
    CHECK(report.after.quantile_95 < report.rotated.quantile_95);
    CHECK(report.largest_log_scale_after == Approx(report.largest_log_scale_before).margin(1e-9));
    REQUIRE(scene.make_exact().success());
    CHECK(scene.number_of_wrong_cones() == 0);
  }
}

TEST_CASE("A field that is turned everywhere by one angle turns the aligned map, and changes nothing else")
{
  Scene scene(demo_mesh("eight.off"), 180), turned(demo_mesh("eight.off"), 180);
  const double angle = 0.3;
  for (const auto f : turned.mesh.faces()) {
    const auto h = turned.mesh.halfedge(f);
    const auto p = turned.mesh.point(turned.mesh.source(h)), q = turned.mesh.point(turned.mesh.target(h)),
               r = turned.mesh.point(turned.mesh.target(turned.mesh.next(h)));
    const Vector_3 normal = CGAL::cross_product(q - p, r - p), d = turned.field[f];
    turned.field[f] =
        std::cos(angle) * d + std::sin(angle) * CGAL::cross_product(normal / std::sqrt(normal.squared_length()), d);
  }
  const Report report = scene.align(), of_turned = turned.align();
  REQUIRE(report.success());
  REQUIRE(of_turned.success());
  CHECK(of_turned.before.mean > report.before.mean - 0.3);
  CHECK(of_turned.rotated.mean == Approx(report.rotated.mean).epsilon(1e-6));
  CHECK(of_turned.after.mean == Approx(report.after.mean).epsilon(1e-4));
  CHECK(of_turned.mean_distortion == Approx(report.mean_distortion).epsilon(1e-3));
}

TEST_CASE("The aligned map does not depend on the charts of the map that is given")
{
  // The faces of one half get charts of their own: turned, scaled and moved.
  Scene scene(demo_mesh("elephant.off"), 180), scattered(demo_mesh("elephant.off"), 180);
  const ts::Similarity_2<double> change(1, 2., 3., -5.);
  const auto has_own_chart = [&](const Mesh::Halfedge_index h) {
    const auto p = scattered.mesh.point(scattered.mesh.target(scattered.mesh.next(h)));
    return scattered.mesh.point(scattered.mesh.target(h)).x() + p.x() +
               scattered.mesh.point(scattered.mesh.source(h)).x() >
           0;
  };
  const auto changed = [&](const Point_2& p) {
    const auto [u, v] = change(p.x(), p.y());
    return Point_2(u, v);
  };
  for (const auto h : scattered.mesh.halfedges())
    if (has_own_chart(h))
      scattered.mapped.uv()[h] = changed(scattered.mapped.uv()[h]);
  const Report report = scene.align(), of_scattered = scattered.align();
  REQUIRE(report.success());
  REQUIRE(of_scattered.success());
  CHECK(of_scattered.after.mean == Approx(report.after.mean).epsilon(1e-4));
  CHECK(of_scattered.mean_distortion == Approx(report.mean_distortion).epsilon(1e-3));
  CHECK(of_scattered.number_of_steps == report.number_of_steps);
}

TEST_CASE("Features lie on isolines exactly, and no triangle turns over")
{
  for (const fm::Named_mesh& named : fm::all())
    for (const bool are_cones_reduced : {false, true}) {
      INFO(named.name << (are_cones_reduced ? ", few cones" : ""));
      Scene scene(named.mesh, 40, are_cones_reduced);
      const Report report = scene.align();
      REQUIRE(report.status == Status::ALIGNED);
      CHECK(report.edges_not_met.empty());
      CHECK(report.largest_log_scale_after == 0);
      const auto exact = scene.make_exact();
      REQUIRE(exact.success());
      CHECK(exact.is_isometric);
      CHECK(exact.number_of_determined_corners == 0); // all of them are doubles
      CHECK(scene.number_of_oblique_edges() == 0);
      CHECK(scene.number_of_wrong_cones() == 0);
    }
}

TEST_CASE("A feature that ends inside of a flat face lies on an isoline")
{
  Mesh cube = fm::cube(6);
  Scene scene(cube, 40);
  for (const auto e : scene.mesh.edges())
    if (fm::is_dart_of_cube(scene.mesh, e))
      scene.mapped.constrained_edges()[e] = true;
  REQUIRE(scene.align().status == Status::ALIGNED);
  REQUIRE(scene.make_exact().success());
  CHECK(scene.number_of_oblique_edges() == 0);
}

TEST_CASE("Borders stay on isolines")
{
  Scene plate(open_meshes::perforated_plate(2, 3), 180);
  const Report report = plate.align();
  REQUIRE(report.status == Status::ALIGNED);
  CHECK(report.number_of_constrained_edges > 0);
  REQUIRE(plate.make_exact().success());
  CHECK(plate.number_of_oblique_edges() == 0);
  CHECK(plate.number_of_wrong_cones() == 0);
}

TEST_CASE("Scale factors become 1, or powers of two")
{
  for (const char* const name : {"eight.off", "double-torus-example.off"}) {
    INFO(name);
    Scene scene(demo_mesh(name), 180, true);
    const Report as_is = Scene(demo_mesh(name), 180, true).align(Policy::AS_IS), unit = scene.align(Policy::UNIT);
    REQUIRE(as_is.success());
    CHECK(as_is.largest_log_scale_after > 0.1);
    CHECK(as_is.largest_log_scale_after == Approx(as_is.largest_log_scale_before).margin(1e-9));
    REQUIRE(unit.status == Status::ALIGNED);
    CHECK(unit.largest_log_scale_after == 0);
    const auto exact = scene.make_exact();
    REQUIRE(exact.success());
    CHECK(exact.is_isometric);
    CHECK(scene.number_of_wrong_cones() == 0);
  }
}

TEST_CASE("Without cones a torus has the powers of two that are next to its scale factors")
{
  Scene scene(demo_mesh("torus_quad.off"), 180, true);
  const Report report = scene.align(Policy::DYADIC);
  REQUIRE(report.success());
  REQUIRE(scene.make_exact().success());
  for (const auto h : scene.mesh.halfedges()) {
    int exponent;
    CHECK(std::frexp(CGAL::to_double(scene.mapped.map().transition(h).scale()), &exponent) == 0.5);
  }
}

TEST_CASE("A torus with one cone of three and one of five quarter turns has no map without scaling, which is said")
{
  // Jucovic, Trenkler, A theorem on the structure of cell-decompositions of orientable 2-manifolds, 1973.
  const Mesh torus = demo_mesh("torus_quad.off");
  Scene scene(torus, {{*torus.vertices().begin(), 3}, {*(torus.vertices().begin() + 10), 5}});
  const std::vector<Point_2> before = scene.corners();
  const Report report = scene.align(Policy::UNIT);
  CHECK(report.status == Status::SCALES_NOT_MET);
  CHECK(!report.success());
  CHECK((scene.corners() == before));
  CHECK(scene.align(Policy::AS_IS).success());
}

TEST_CASE("Of features that cannot all be met the weakest are given up and named")
{
  // With few cones, opposite sides of patches force arcs between features to have length 0.
  Scene scene(demo_mesh("elk.off"), 30, true);
  const Report report = scene.align();
  REQUIRE(report.success());
  CHECK(report.status == Status::CONSTRAINTS_NOT_MET);
  CHECK(!report.meets_constraints());
  CHECK(!report.edges_not_met.empty());
  CHECK(report.edges_not_met.size() < report.number_of_constrained_edges);
  CHECK(describe(report, scene.mesh).find("the first one edge from vertex") != std::string::npos);
  for (const auto e : report.edges_not_met)
    scene.mapped.constrained_edges()[e] = false;
  REQUIRE(scene.make_exact().success());
  CHECK(scene.number_of_oblique_edges() == 0);
}

TEST_CASE("What cannot be aligned is refused, with the element concerned, and the map stays as it is")
{
  Scene scene(demo_mesh("eight.off"), 180);
  const std::vector<Point_2> before = scene.corners();
  const auto refused = [&](const Report& report, const Status status) {
    CHECK(report.status == status);
    CHECK(!report.success());
    CHECK(describe(report, scene.mesh).find(message(status)) != std::string::npos);
    CHECK((scene.corners() == before));
  };
  for (const double weight :
       {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    refused(scene.align(ts::parameters::distortion_weight(weight)), Status::INVALID_OPTION);

  SECTION("a field without a direction")
  {
    scene.field[*scene.mesh.faces().begin()] = Vector_3(0, 0, 0);
    const Report report = scene.align();
    refused(report, Status::INVALID_FIELD);
    CHECK(report.faces == std::vector<Mesh::Face_index>{*scene.mesh.faces().begin()});
  }
  SECTION("a field that turns otherwise")
  {
    const auto e = *(scene.mesh.edges().begin() + 100);
    ++scene.matching[scene.mesh.halfedge(e)];
    const Report report = scene.align();
    refused(report, Status::FIELD_OF_OTHER_SIGNATURE);
    CHECK(report.halfedge != Mesh::null_halfedge());
    CHECK(report.deviation == Approx(std::acos(0.)));
  }
  SECTION("a field that does not follow a constrained edge")
  {
    for (const auto e : scene.mesh.edges()) {
      const auto h = scene.mesh.halfedge(e);
      const Vector_3 edge = scene.mesh.point(scene.mesh.target(h)) - scene.mesh.point(scene.mesh.source(h));
      const double c = std::abs(edge * scene.field[scene.mesh.face(h)]) / std::sqrt(edge.squared_length());
      if (c > std::cos(0.7) || c < std::cos(0.85))
        continue;
      scene.mapped.constrained_edges()[e] = true;
      break;
    }
    const Report report = scene.align();
    refused(report, Status::FIELD_NOT_ALIGNED);
    CHECK(report.deviation > 0.6);
  }
  SECTION("a map with a triangle that is turned over")
  {
    const auto h = *scene.mesh.halfedges().begin();
    scene.mapped.uv()[h] = scene.mapped.uv()[scene.mesh.next(h)];
    const Report report = scene.align();
    CHECK(report.status == Status::FLIPPED_TRIANGLES);
    CHECK(!report.faces.empty());
  }
  SECTION("a map that is not seamless")
  {
    // One side of a seam is stretched a little.
    const auto e = std::find_if(scene.mesh.edges().begin(), scene.mesh.edges().end(),
                                [&](const auto edge) { return scene.mapped.cut()[edge]; });
    const auto h = scene.mesh.halfedge(*e);
    const Point_2 p = scene.mapped.uv()[h], q = scene.mapped.uv()[scene.mesh.prev(h)], moved = p + 0.1 * (p - q);
    auto first = h;
    while (!scene.mapped.cut()[scene.mesh.edge(scene.mesh.next(first))])
      first = scene.mesh.opposite(scene.mesh.next(first));
    for (auto g = first;; g = scene.mesh.prev(scene.mesh.opposite(g))) {
      scene.mapped.uv()[g] = moved;
      if (scene.mapped.cut()[scene.mesh.edge(g)])
        break;
    }
    const Report report = scene.align();
    CHECK(report.status == Status::NOT_SEAMLESS);
    CHECK(report.halfedge != Mesh::null_halfedge());
    CHECK(report.deviation > 0);
  }
}

TEST_CASE("An alignment that is interrupted leaves the map as it is")
{
  Scene scene(demo_mesh("eight.off"), 180, true);
  const std::vector<Point_2> before = scene.corners();
  check_cancelling([&](const auto& visitor) {
    const Report report = scene.align(ts::parameters::scale_policy(Policy::UNIT, CGAL::parameters::visitor(visitor)));
    const bool is_interrupted = report.status == Status::INTERRUPTED;
    CHECK((is_interrupted || report.success()));
    if (is_interrupted)
      CHECK((scene.corners() == before));
    std::size_t i = 0;
    for (const auto h : scene.mesh.halfedges())
      scene.mapped.uv()[h] = before[i++];
    return is_interrupted;
  });
}

} // namespace align_seamless_map_test
