// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Approximation/T_spline_approximation.h>

#include "Approximation/box.h"
#include "Counting_visitor.h"
#include "Similarity_map/chart_maps.h"
#include "Similarity_map/test_meshes.h"

#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace T_spline_approximation_test {

namespace {

namespace T = CGAL::T_splines;
namespace P = CGAL::T_splines::parameters;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Approximation = T::T_spline_approximation<Mesh>;
using Status = T::T_spline_approximation_status;
constexpr double tolerance = 0.05;

// The same knots, and the same control points.
bool are_equal(const T::T_spline<>& a, const T::T_spline<>& b)
{
  if (a.number_of_control_points() != b.number_of_control_points())
    return false;
  for (const auto v : a.graph().vertices())
    if (a.graph().point(v) != b.graph().point(v))
      return false;
  for (const auto h : a.graph().halfedges())
    if (a.knots()[h] != b.knots()[h])
      return false;
  return true;
}

std::vector<Approximation::Signature::Cone> corners(const Mesh& mesh)
{
  std::vector<Approximation::Signature::Cone> cones;
  for (const Mesh::Vertex_index v : mesh.vertices())
    cones.emplace_back(v, 3);
  return cones;
}

void check_failure(const Approximation& approximation, const Status status, const std::string& words)
{
  CHECK(approximation.report().status == status);
  CHECK_FALSE(approximation.report().success());
  INFO(describe(approximation.report(), approximation.mesh()));
  CHECK(describe(approximation.report(), approximation.mesh()).find(words) != std::string::npos);
}

} // namespace

TEST_CASE("stage by stage and by the last stage alone, the surface is the same")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  T::T_spline<> at_once, by_stages;
  Approximation one(mesh), other(mesh);
  CHECK_FALSE(one.has_signature());
  CHECK_FALSE(one.has_map());
  CHECK_FALSE(one.has_T_mesh());
  REQUIRE(one.compute_T_mesh());
  REQUIRE(one.fit(tolerance, at_once));
  REQUIRE(other.compute_cross_field());
  REQUIRE(other.reduce_cones());
  REQUIRE(other.compute_map());
  CHECK_FALSE(other.mapped_mesh().has_map());
  REQUIRE(other.make_map_exact());
  CHECK(other.mapped_mesh().has_map());
  REQUIRE(other.trace_T_mesh());
  REQUIRE(other.regularize_T_mesh());
  REQUIRE(other.fit(tolerance, by_stages));
  CHECK(are_equal(at_once, by_stages));
  CHECK(other.report().within_tolerance());
  REQUIRE(other.trace_T_mesh());
  CHECK_FALSE(other.report().within_tolerance()); // there is no surface of this T-mesh yet
}

TEST_CASE("a field, its signature, cones and a map from elsewhere take the place of computed ones")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  T::T_spline<> expected, spline;
  Approximation computed(mesh), approximation(mesh);
  REQUIRE(computed.compute_cross_field());
  const Approximation::Signature signature = computed.signature();
  REQUIRE(computed.compute_T_mesh());
  REQUIRE(computed.fit(tolerance, expected));
  SECTION("field")
  {
    REQUIRE(approximation.use_cross_field(computed.cross_field()));
    REQUIRE(approximation.compute_T_mesh());
    REQUIRE(approximation.fit(tolerance, spline));
    CHECK(are_equal(spline, expected));
  }
  SECTION("signature")
  {
    approximation.set_signature(signature);
    REQUIRE(approximation.compute_T_mesh());
    REQUIRE(approximation.fit(tolerance, spline));
    CHECK(are_equal(spline, expected));
  }
  SECTION("cones")
  {
    REQUIRE(approximation.use_cones(corners(mesh)));
    REQUIRE(approximation.compute_T_mesh());
    REQUIRE(approximation.fit(tolerance, spline));
    CHECK(approximation.report().within_tolerance());
    for (const Mesh::Vertex_index v : mesh.vertices())
      CHECK(approximation.mapped_mesh().map().quarter_turns(v) == 3);
  }
  SECTION("map")
  {
    const Mesh& refined = computed.mapped_mesh().mesh();
    Approximation of_map(refined);
    REQUIRE(of_map.use_map(computed.mapped_mesh().uv()));
    for (const auto e : refined.edges())
      CHECK(of_map.mapped_mesh().cut()[e] == of_map.mapped_mesh().map().is_cut(e));
    REQUIRE(of_map.compute_T_mesh());
    CHECK(of_map.t_mesh().t_mesh().graph().number_of_faces() == computed.t_mesh().t_mesh().graph().number_of_faces());
    REQUIRE(of_map.fit(tolerance, spline));
    CHECK(of_map.report().within_tolerance());
  }
}

TEST_CASE("constrained edges go the whole way, from the map to the surface")
{
  const int n = 4;
  const chart_maps::Chart_map cube = chart_maps::planes_as_charts(test_meshes::cube(n), n);
  Mesh mesh = test_meshes::face_graph<Mesh>(cube);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  for_each_corner(mesh, [&](const std::size_t t, std::size_t, const Mesh::Halfedge_index h) {
    for (int i = 0; i < 3; ++i)
      if (cube.triangles[t][i] == static_cast<int>(mesh.target(h)))
        uv[h] = Kernel::Point_2(cube.uv[t][i][0], cube.uv[t][i][1]);
    const auto beside = mesh.face(mesh.opposite(h));
    is_sharp[mesh.edge(h)] = cube.chart[t] != cube.chart[static_cast<std::size_t>(beside)];
  });
  const auto length_of = [](const auto& t_mesh) { // of creases, on both sides
    double result = 0;
    for (const auto h : t_mesh.graph().halfedges())
      result += get(t_mesh.creases(), t_mesh.graph().edge(h)) ? CGAL::to_double(t_mesh.knots()[h]) : 0;
    return result;
  };
  Approximation approximation(mesh);
  REQUIRE(approximation.use_map(uv, CGAL::parameters::edge_is_constrained_map(is_sharp)));
  for (const bool is_again : {false, true}) {
    if (is_again) // the mapped mesh remembers them
      REQUIRE(approximation.make_map_exact());
    const auto& mapped = approximation.mapped_mesh();
    for (const auto e : mapped.mesh().edges())
      CHECK(mapped.map().is_constrained(e) == is_sharp[e]);
    REQUIRE(approximation.compute_T_mesh());
    CHECK(length_of(approximation.t_mesh().t_mesh()) == 24 * n);
    T::T_spline<> spline;
    REQUIRE(approximation.fit(tolerance, spline));
    CHECK(length_of(spline) == Approx(24 * n));
    CHECK(spline.graph().number_of_vertices() == 8); // with creases, a cube needs no more
    CHECK(approximation.report().fit.deviation.maximum() < 1e-12 * n);
  }
  const auto none = CGAL::Static_boolean_property_map<Mesh::Edge_index, false>();
  REQUIRE(approximation.make_map_exact(CGAL::parameters::edge_is_constrained_map(none)));
  REQUIRE(approximation.compute_T_mesh());
  CHECK(length_of(approximation.t_mesh().t_mesh()) == 0);
}

TEST_CASE("what is replaced makes later stages forget their results")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  Approximation approximation(mesh);
  REQUIRE(approximation.compute_T_mesh());
  REQUIRE(approximation.has_map());
  REQUIRE(approximation.use_cones(corners(mesh)));
  CHECK_FALSE(approximation.has_map());
  CHECK_FALSE(approximation.has_T_mesh());
  REQUIRE(approximation.compute_T_mesh());
  REQUIRE(approximation.make_map_exact());
  CHECK(approximation.has_map());
  CHECK_FALSE(approximation.has_T_mesh());
}

TEST_CASE("the points and polylines of the T-mesh are on the mesh, after regularization too")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  Approximation approximation(mesh);
  REQUIRE(approximation.compute_T_mesh());
  REQUIRE(approximation.place_T_mesh());
  const auto& t_mesh = approximation.t_mesh();
  const auto& graph = t_mesh.t_mesh().graph();
  const auto is_on_box = [](const Kernel::Point_3& p) {
    const double distance = std::min({std::abs(p.x()), std::abs(p.x() - 4), std::abs(p.y()), std::abs(p.y() - 3),
                                      std::abs(p.z()), std::abs(p.z() - 2)});
    return distance < 1e-12;
  };
  for (const auto v : graph.vertices())
    CHECK(is_on_box(graph.point(v)));
  for (const auto e : graph.edges()) {
    const std::vector<Kernel::Point_3>& line = t_mesh.polylines()[e];
    REQUIRE(line.size() >= 2);
    CHECK(line.front() == graph.point(graph.source(graph.halfedge(e))));
    CHECK(line.back() == graph.point(graph.target(graph.halfedge(e))));
    for (const Kernel::Point_3& p : line)
      CHECK(is_on_box(p));
  }
}

TEST_CASE("each stage that fails says which it is, and why")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  Approximation approximation(mesh);
  SECTION("cones")
  {
    std::vector<Approximation::Signature::Cone> cones = corners(mesh);
    cones.pop_back();
    CHECK_FALSE(approximation.use_cones(cones));
    check_failure(approximation, Status::INVALID_SIGNATURE, "is 7 instead of 8");
  }
  SECTION("corners")
  {
    const std::vector<Approximation::Signature::Corner> inside(1, {*vertices(mesh).begin(), 1});
    CHECK_FALSE(approximation.compute_cross_field(P::corners(std::optional(inside))));
    check_failure(approximation, Status::INVALID_SIGNATURE, "a corner is not on the border");
    CHECK(approximation.report().signature.status == CGAL::T_splines::Holonomy_signature_status::CORNER_INSIDE);
  }
  SECTION("number of cones")
  {
    REQUIRE(approximation.compute_cross_field());
    CHECK_FALSE(approximation.reduce_cones(P::maximum_number_of_cones(1)));
    check_failure(approximation, Status::CONE_REDUCTION_FAILED, "3");
  }
  SECTION("map")
  {
    REQUIRE(approximation.compute_cross_field());
    CHECK_FALSE(approximation.compute_map(CGAL::parameters::number_of_iterations(1)));
    check_failure(approximation, Status::MAP_FAILED, "1 iteration");
  }
  SECTION("uv")
  {
    Mesh other = mesh;
    const auto uv = other.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", Kernel::Point_2(0, 0)).first;
    Approximation of_map(other);
    CHECK_FALSE(of_map.use_map(uv));
    check_failure(of_map, Status::EXACT_MAP_FAILED, "0");
    CHECK_FALSE(of_map.mapped_mesh().has_map());
  }
  SECTION("T-mesh that does not lie on the mesh")
  {
    REQUIRE(approximation.compute_T_mesh());
    auto& t_mesh = approximation.t_mesh().t_mesh();
    for (const auto h : t_mesh.graph().halfedges())
      t_mesh.knots()[h] = 100 * t_mesh.knots()[h];
    CHECK_FALSE(approximation.place_T_mesh());
    check_failure(approximation, Status::PLACEMENT_FAILED, "does not fit");
  }
  SECTION("fit")
  {
    T::T_spline<> spline;
    CHECK_FALSE(approximation.fit(0.1, spline));
    check_failure(approximation, Status::MISSING_RESULT, "T-mesh");
    REQUIRE(approximation.compute_T_mesh());
    CHECK_FALSE(approximation.fit(-1, spline));
    check_failure(approximation, Status::FIT_FAILED, "positive");
    CHECK(spline.number_of_control_points() == 0);
  }
}

TEST_CASE("a visitor stops the work in whatever stage it is, and nothing is written")
{
  const Mesh mesh = approximation_tests::box<Mesh>();
  T::T_spline<> spline;
  const auto number_of_questions = [&](const int last_question) {
    Visitor_record record;
    record.last_question = last_question;
    Approximation approximation(mesh);
    T::T_spline<> result;
    const auto np = CGAL::parameters::visitor(Counting_visitor(record));
    const bool is_fitted = approximation.compute_T_mesh(np) && approximation.fit(0.2, result, np);
    if (record.number_of_questions == last_question) {
      CHECK_FALSE(is_fitted);
      CHECK(approximation.report().status == Status::INTERRUPTED);
      CHECK(result.number_of_control_points() == 0);
    }
    return record.number_of_questions;
  };
  const int n = number_of_questions((std::numeric_limits<int>::max)());
  REQUIRE(n > 20);
  for (int i = 1; i < n; i += 1 + n / 20)
    CHECK(number_of_questions(i) == i);
}

} // namespace T_spline_approximation_test
