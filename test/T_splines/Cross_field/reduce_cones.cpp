// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>

#include "open_meshes.h"
#include "test_meshes.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/Dense>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace reduce_cones_test {

namespace ts = CGAL::T_splines;
using Status = ts::Cone_reduction_status;
using Mesh = test::Surface_mesh;
using Signature = ts::Holonomy_signature<Mesh>;
using Domain = ts::internal::Signature_domain<Mesh>;

namespace {

test::Soup cube(const int n)
{
  return test::cubes([](int x, int y, int z) { return x == 0 && y == 0 && z == 0; }, 1, n);
}

// The cube on a sphere.
test::Soup sphere(const int n)
{
  test::Soup soup = cube(n);
  for (test::Point_3& p : soup.points) {
    const test::Vector_3 v = p - test::Point_3(0.5, 0.5, 0.5);
    p = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  }
  return soup;
}

// Six arms of cubes around one.
test::Soup cross(const int n)
{
  return test::cubes(
      [](const int x, const int y, const int z) {
        const auto is_inside = [](const int i) { return i >= 0 && i < 7; };
        return (x == 3) + (y == 3) + (z == 3) >= 2 && is_inside(x) && is_inside(y) && is_inside(z);
      },
      7, n);
}

template <typename TriangleMesh>
ts::Holonomy_signature<TriangleMesh> smooth_signature(TriangleMesh& mesh)
{
  auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::compute_smooth_cross_field(mesh, field).success());
  ts::Holonomy_signature<TriangleMesh> signature;
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature).success());
  return signature;
}

template <typename TriangleMesh>
bool are_equal(const TriangleMesh& mesh, const ts::Holonomy_signature<TriangleMesh>& a,
               const ts::Holonomy_signature<TriangleMesh>& b)
{
  for (const auto v : vertices(mesh))
    if (a.quarter_turns(v) != b.quarter_turns(v))
      return false;
  return std::equal(a.loops().begin(), a.loops().end(), b.loops().begin(), b.loops().end(),
                    [](const auto& l, const auto& m) { return l.quarter_turns == m.quarter_turns; });
}

// A signature with random cones that are merged in pairs: k = 3 and k = 5, with the eight corners' worth in addition.
Signature random_signature(const Mesh& mesh, const int number_of_pairs, const unsigned int seed)
{
  std::vector<Mesh::Vertex_index> shuffled(vertices(mesh).begin(), vertices(mesh).end());
  std::mt19937 random(seed);
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const Domain domain(mesh, CGAL::parameters::default_values());
  std::vector<std::pair<Mesh::Vertex_index, int>> cones;
  const int sum = 4 * domain.m_components.euler_characteristic[0];
  for (int i = 0; i < std::abs(sum) + 2 * number_of_pairs; ++i)
    cones.emplace_back(shuffled[i], i < std::abs(sum) ? (sum > 0 ? 3 : 5) : 3 + i % 2 * 2);
  Signature signature;
  REQUIRE(ts::holonomy_signature_of_cones(mesh, cones, signature).success());
  return signature;
}

// The strip of triangles of each loop and arc, and what is missing to its turning.
struct Strips {
  std::vector<std::vector<int>> strips;
  std::vector<double> residual;

  Strips(const Domain& mesh, const Signature& signature)
  {
    const auto add = [&](const auto& loops_or_arcs) {
      for (const auto& strip : loops_or_arcs) {
        strips.emplace_back();
        for (const auto h : strip.halfedges)
          strips.back().push_back(mesh.m_indexing.halfedge_index(h));
        residual.push_back(
            strip.quarter_turns * ts::internal::quarter_turn -
            ts::internal::strip_turning(mesh.m_connectivity, strips.back(), mesh.m_geometry.m_corner_angle));
      }
    };
    add(signature.loops());
    add(signature.arcs());
  }
};

double cotangent_weight(const Domain& mesh, const int e)
{
  double weight = 0;
  for (const int h : {2 * e, 2 * e + 1})
    if (mesh.m_connectivity.face(h) != ts::internal::Triangulation_connectivity::null)
      weight += 0.5 / std::tan(mesh.m_geometry.m_corner_angle[mesh.m_connectivity.next(h)]);
  return weight;
}

// The energy of a connected Delaunay mesh by one system for all of xi = du + sum c_l eta_l: the flow of xi out of each
// vertex, and through each loop and arc, is what the signature demands. Each cone is a point.
double energy_by_definition(const Mesh& mesh, const Signature& signature)
{
  const Domain domain(mesh, CGAL::parameters::default_values());
  const auto& connectivity = domain.m_connectivity;
  const Strips strips(domain, signature);
  const int n = connectivity.number_of_vertices(), g = static_cast<int>(strips.strips.size());
  Eigen::MatrixXd forms = Eigen::MatrixXd::Zero(connectivity.number_of_edges(), n + g); // of unknowns, per edge
  Eigen::VectorXd weights(connectivity.number_of_edges()), demanded(n + g);
  for (int e = 0; e < connectivity.number_of_edges(); ++e) {
    weights(e) = cotangent_weight(domain, e);
    REQUIRE(weights(e) > -1e-10);
    forms(e, connectivity.target(2 * e)) = 1;
    forms(e, connectivity.source(2 * e)) = -1;
  }
  for (int l = 0; l < g; ++l)
    for (const int h : strips.strips[l])
      forms(h / 2, n + l) += h % 2 == 0 ? 1 : -1;
  const std::vector<double> defects = ts::internal::angle_defects(connectivity, domain.m_geometry);
  for (int v = 0; v < n; ++v)
    demanded(v) = (4 - signature.quarter_turns(domain.m_indexing.vertex(v)) + 2 -
                   signature.corner_quarter_turns(domain.m_indexing.vertex(v))) *
                      ts::internal::quarter_turn -
                  defects[v];
  for (int l = 0; l < g; ++l)
    demanded(n + l) = strips.residual[l];
  const Eigen::MatrixXd system = forms.transpose() * weights.asDiagonal() * forms;
  const Eigen::VectorXd solution = system.completeOrthogonalDecomposition().solve(demanded);
  CHECK((system * solution - demanded).norm() < 1e-9);
  const Eigen::VectorXd xi = forms * solution;
  return 0.5 * xi.dot(weights.asDiagonal() * xi);
}

struct Interrupting_visitor {
  void begin_stage(const char*) const {}
  void progress(double) const {}
  bool go_on() const { return false; }
};

struct Failing_solver {
  using FT = double;
  using Matrix = ts::Symmetric_sparse_matrix<double>;

  bool analyze_pattern(const Matrix&) { return true; }
  bool factorize(const Matrix&) { return false; }
  bool solve(const std::vector<double>&, std::vector<double>&) const { return false; }
};

} // namespace

TEST_CASE("quarter turns moved along paths are those of the field that jumps across them")
{
  const auto has_border = GENERATE(0, 1);
  const Mesh mesh = has_border == 1 ? open_meshes::perforated_plate(2, 3) : test::to_mesh<Mesh>(test::plate(2, 3));
  const Domain domain(mesh, CGAL::parameters::default_values());
  const auto& connectivity = domain.m_connectivity;
  std::vector<double> angle(connectivity.number_of_faces());
  std::mt19937 random(1);
  for (double& a : angle)
    a = random() / 4294967296.;
  std::vector<double> rotation = ts::internal::field_rotations(
      connectivity, ts::internal::angles_to_halfedges(connectivity, domain.m_geometry, angle));
  ts::internal::Progress nobody;
  std::vector<std::vector<int>> strips = domain.short_loops(nobody);
  for (const std::vector<int>& arc : domain.short_arcs(nobody))
    strips.push_back(arc);
  REQUIRE(strips.size() == 4);
  const std::vector<double> border_cross(connectivity.number_of_edges(), 0.);
  const auto turns = [&] {
    std::vector<double> result =
        ts::internal::vertex_quarter_turns(connectivity, domain.m_geometry.m_corner_angle, rotation, border_cross);
    for (const auto& strip : strips)
      result.push_back(ts::internal::strip_quarter_turns(connectivity, strip, domain.m_geometry.m_corner_angle,
                                                         rotation, border_cross));
    return result;
  };
  std::vector<int> ends;
  for (int i = 0; i < 12; ++i)
    ends.push_back(static_cast<int>((i * 37u) % static_cast<unsigned int>(connectivity.number_of_vertices())));
  ts::internal::Cone_paths paths(connectivity, domain.m_geometry.m_edge_length, ends, strips, nobody);
  ts::internal::Edge_distances distances(connectivity, domain.m_geometry.m_edge_length);
  int number_of_crossings = 0;
  for (int a = 0; a < 12; ++a) {
    for (int b = 0; b < 12; ++b) {
      if (a == b)
        continue;
      const int q = a % 3 - 1;
      std::vector<double> expected = turns();
      expected[ends[a]] -= q;
      expected[ends[b]] += q;
      for (std::size_t l = 0; l < strips.size(); ++l) {
        expected[connectivity.number_of_vertices() + l] -= q * paths.crossings(a, b)[l];
        number_of_crossings += std::abs(paths.crossings(a, b)[l]);
      }
      // There is one path for both directions, that from the cone with the smaller index.
      const int sign = a < b ? q : -q;
      distances.search(ends[(std::min)(a, b)], [](int, double) { return true; });
      for (const int h : distances.path_to(ends[(std::max)(a, b)]))
        rotation[h / 2] += (h % 2 == 0 ? sign : -sign) * ts::internal::quarter_turn;
      const std::vector<double> actual = turns();
      for (std::size_t i = 0; i < actual.size(); ++i)
        REQUIRE(std::abs(actual[i] - expected[i]) < 1e-9);
    }
  }
  CHECK(number_of_crossings > 0);
}

TEST_CASE("reduced signatures are admissible, and have no more cones than asked for")
{
  for (int genus = 0; genus <= 3; ++genus) {
    const Mesh mesh = test::to_mesh<Mesh>(test::plate(genus, 3));
    const int fewest = genus == 0 ? 3 : (genus == 1 ? 0 : 1);
    for (const int limit : {20, 9, 4, 3, 1, 0}) {
      Signature signature = random_signature(mesh, 12, static_cast<unsigned int>(limit));
      const auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(limit));
      CHECK(report.status == (limit >= fewest ? Status::REDUCED : Status::LIMIT_UNREACHABLE));
      CHECK(ts::check_holonomy_signature(mesh, signature).success());
      CHECK(report.number_of_cones == static_cast<int>(signature.cones().size()));
      CHECK(report.number_of_cones <= (std::max)(limit, fewest));
      CHECK(report.number_of_cones_before == 24 + std::abs(8 * (1 - genus)));
    }
  }
}

TEST_CASE("a bound on the energy leaves three to six quarter turns, and fewer cones the higher it is")
{
  const Mesh mesh = test::to_mesh<Mesh>(sphere(12));
  const Signature signature = random_signature(mesh, 15, 3);
  std::size_t fewest = signature.cones().size();
  for (const double bound : {-100., 0., 0.3, 1., 3., 100.}) {
    Signature reduced = signature;
    const auto report = ts::reduce_cones(mesh, reduced, ts::parameters::maximum_energy_change(bound));
    CHECK(report.success());
    CHECK(report.largest_energy_change <= (std::max)(0., bound));
    CHECK(ts::check_holonomy_signature(mesh, reduced).success());
    CHECK(reduced.cones().size() <= fewest);
    fewest = reduced.cones().size();
    for (const auto& cone : reduced.cones())
      CHECK((cone.second >= 3 && cone.second <= 6));
    CHECK(are_equal(mesh, signature, reduced) == (report.number_of_merges == 0));
  }
  CHECK(fewest == 8);
}

TEST_CASE("the number is a demand, and the bound rules beyond it")
{
  const Mesh mesh = test::to_mesh<Mesh>(sphere(12));
  const Signature signature = random_signature(mesh, 15, 4);
  Signature by_number = signature, by_bound = signature, by_both = signature;
  REQUIRE(ts::reduce_cones(mesh, by_number, ts::parameters::maximum_number_of_cones(30)).success());
  REQUIRE(ts::reduce_cones(mesh, by_bound, ts::parameters::maximum_energy_change(0.5)).success());
  REQUIRE(ts::reduce_cones(mesh, by_both,
                           ts::parameters::maximum_number_of_cones(30, ts::parameters::maximum_energy_change(0.5)))
              .success());
  CHECK(by_number.cones().size() >= 29); // a merge takes away at most two
  CHECK(by_number.cones().size() <= 30);
  CHECK(by_bound.cones().size() < 29);
  CHECK(are_equal(mesh, by_bound, by_both));
}

TEST_CASE("the energy is that of the definition, before and after")
{
  // Cones are points where edges are longer than the disks' radius, and tori of quadrilaterals are Delaunay.
  for (const auto& [m, n] : std::vector<std::pair<int, int>>{{16, 8}, {12, 12}}) {
    const Mesh mesh = test::to_mesh<Mesh>(test::torus(m, n));
    for (unsigned int seed = 0; seed < 3; ++seed) {
      Signature signature = random_signature(mesh, 6, seed);
      const double before = energy_by_definition(mesh, signature);
      const auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(5));
      const double after = energy_by_definition(mesh, signature);
      CHECK(report.energy_before == Approx(before).epsilon(1e-9));
      CHECK(report.energy - report.energy_before == Approx(after - before).margin(1e-8));
    }
  }
}

TEST_CASE("the first merge is the cheapest one that can be made")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(12, 8));
  Signature signature = random_signature(mesh, 3, 11);
  const Signature before = signature;
  const auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(5));
  REQUIRE(report.number_of_merges == 1);
  const Domain domain(mesh, CGAL::parameters::default_values());
  std::vector<int> cones;
  for (const auto& cone : before.cones())
    cones.push_back(domain.m_indexing.vertex_index(cone.first));
  ts::internal::Progress nobody;
  ts::internal::Cone_paths paths(domain.m_connectivity, domain.m_geometry.m_edge_length, cones,
                                 ts::internal::strips_of(domain.m_indexing, before), nobody);
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const int k_a = before.cones()[a].second, k_b = before.cones()[b].second, q = k_a - 4;
      if (a == b || k_a + k_b < 7)
        continue;
      Signature merged = before;
      merged.set_quarter_turns(before.cones()[a].first, 4);
      merged.set_quarter_turns(before.cones()[b].first, k_b + q);
      for (std::size_t l = 0; l < before.loops().size(); ++l)
        merged.set_loop_quarter_turns(l, before.loops()[l].quarter_turns - q * paths.crossings(a, b)[l]);
      CHECK(energy_by_definition(mesh, merged) >= report.energy - 1e-8);
    }
  }
}

TEST_CASE("a pair of cones that does not belong there goes first")
{
  const Mesh torus = test::to_mesh<Mesh>(test::torus(24, 12)), ball = test::to_mesh<Mesh>(cube(8));
  for (const Mesh* mesh : {&torus, &ball}) {
    Signature signature = random_signature(*mesh, 0, 0);
    if (mesh == &ball) { // the corners of the cube are its cones
      signature.clear();
      for (const auto v : vertices(ball)) {
        const test::Vector_3 p = ball.point(v) - test::Point_3(0.5, 0.5, 0.5);
        if (std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()) == 1.5)
          signature.set_quarter_turns(v, 3);
      }
    }
    for (const std::size_t e : {31u, 99u, 170u}) {
      Signature disturbed = signature;
      const auto h = mesh->halfedge(Mesh::Edge_index(static_cast<Mesh::size_type>(e)));
      const auto a = mesh->source(h), b = mesh->target(h);
      if (signature.quarter_turns(a) != 4 || signature.quarter_turns(b) != 4)
        continue;
      disturbed.set_quarter_turns(a, 3);
      disturbed.set_quarter_turns(b, 5);
      for (std::size_t l = 0; l < signature.loops().size(); ++l) {
        int passages = 0; // a quarter turn more into the face of h makes the pair, see above
        for (const auto g : signature.loops()[l].halfedges)
          passages += g == h ? 1 : (g == opposite(h, *mesh) ? -1 : 0);
        disturbed.set_loop_quarter_turns(l, signature.loops()[l].quarter_turns - passages);
      }
      REQUIRE(ts::check_holonomy_signature(*mesh, disturbed).success());
      const auto report = ts::reduce_cones(*mesh, disturbed, ts::parameters::maximum_energy_change(0.));
      CHECK(report.number_of_merges == 1);
      CHECK(are_equal(*mesh, signature, disturbed));
    }
  }
}

TEST_CASE("cones merge on surfaces with border, corners stay, and the energies are those by definition", "[border]")
{
  open_meshes::Mesh plate = open_meshes::perforated_plate(2, 3), ring = open_meshes::annulus(4, 24, 8);
  for (const Mesh* mesh : {&plate, &ring}) {
    std::vector<std::pair<Mesh::Vertex_index, int>> cones;
    for (const auto v : vertices(*mesh))
      if (!is_border(v, *mesh) && v.idx() % 17 == 5)
        cones.emplace_back(v, cones.size() % 2 == 0 ? 3 : 5);
    if (cones.size() % 2 == 1)
      cones.pop_back();
    REQUIRE(cones.size() >= 4);
    Signature signature;
    const auto made = ts::holonomy_signature_of_cones(*mesh, cones, signature);
    INFO(describe(made, *mesh));
    REQUIRE(made);
    for (std::size_t a = 0; a < signature.arcs().size(); ++a)
      signature.set_arc_quarter_turns(a, signature.arcs()[a].quarter_turns + (a % 2 == 0 ? 1 : -1));
    const Signature before = signature;
    const auto report = ts::reduce_cones(*mesh, signature, ts::parameters::maximum_energy_change(1e9));
    REQUIRE(report.success());
    CHECK(report.energy_before == Approx(energy_by_definition(*mesh, before)).epsilon(1e-9));
    CHECK(report.energy == Approx(energy_by_definition(*mesh, signature)).epsilon(1e-9).margin(1e-9));
    CHECK(signature.cones().empty());
    CHECK(signature.corners() == before.corners());
    CHECK(ts::check_holonomy_signature(*mesh, signature));
  }
}

TEST_CASE("the corners of a box of twelve triangles become its cones")
{
  const test::Soup box = cube(1);
  const auto corner = [&](const double x, const double y, const double z) {
    const auto p = std::find(box.points.begin(), box.points.end(), test::Point_3(x, y, z));
    REQUIRE(p != box.points.end());
    return Mesh::Vertex_index(static_cast<unsigned int>(p - box.points.begin()));
  };
  for (const double length : {1., 4., 20.}) {
    test::Soup stretched = box;
    for (test::Point_3& p : stretched.points)
      p = test::Point_3(length * p.x(), length * p.y(), p.z());
    const Mesh mesh = test::to_mesh<Mesh>(stretched);
    Signature pairs, uneven; // two quarter turns at every other corner; and what a smooth field may come to
    for (const auto v : {corner(0, 0, 0), corner(1, 1, 0), corner(1, 0, 1), corner(0, 1, 1)})
      pairs.set_quarter_turns(v, 2);
    uneven.set_quarter_turns(corner(0, 0, 0), 1);
    uneven.set_quarter_turns(corner(1, 1, 0), 2);
    for (const auto v : {corner(0, 1, 0), corner(1, 1, 1), corner(1, 0, 1)})
      uneven.set_quarter_turns(v, 3);
    for (Signature* signature : {&pairs, &uneven}) {
      REQUIRE(ts::check_holonomy_signature(mesh, *signature).success());
      const auto report = ts::reduce_cones(mesh, *signature);
      CHECK(report.success());
      CHECK(report.number_of_splits == (signature == &pairs ? 4 : 3));
      CHECK(report.number_of_merges == 0);
      CHECK(report.energy_before > 0.2);
      CHECK(report.energy == Approx(0).margin(1e-9)); // the surface of the box is flat elsewhere
      for (const auto v : vertices(mesh))
        CHECK(signature->quarter_turns(v) == 3);
    }
  }
}

TEST_CASE("the corners of a tetrahedron become cones of two quarter turns")
{
  Mesh mesh;
  CGAL::make_tetrahedron(test::Point_3(1, 1, 1), test::Point_3(1, -1, -1), test::Point_3(-1, 1, -1),
                         test::Point_3(-1, -1, 1), mesh);
  Signature signature;
  const std::vector<Mesh::Vertex_index> corners(vertices(mesh).begin(), vertices(mesh).end());
  for (const auto& [corner, k] : {std::pair(0, 1), std::pair(1, 3), std::pair(2, 2), std::pair(3, 2)})
    signature.set_quarter_turns(corners[corner], k);
  REQUIRE(ts::check_holonomy_signature(mesh, signature).success());
  const auto report = ts::reduce_cones(mesh, signature);
  CHECK(report.energy == Approx(0).margin(1e-9));
  for (const auto v : vertices(mesh))
    CHECK(signature.quarter_turns(v) == 2);
}

TEST_CASE("loops turn as they should")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(16, 8));
  Signature straight;
  REQUIRE(ts::holonomy_signature_of_cones(mesh, std::vector<std::pair<Mesh::Vertex_index, int>>(), straight).success());
  for (std::size_t l = 0; l < 2; ++l)
    straight.set_loop_quarter_turns(l, 0);
  for (const auto& [first, second] : std::vector<std::pair<int, int>>{{0, 0}, {0, 2}, {-3, 0}, {1, 5}, {-2, -2}}) {
    Signature signature = straight;
    signature.set_loop_quarter_turns(0, first);
    signature.set_loop_quarter_turns(1, second);
    const auto report = ts::reduce_cones(mesh, signature);
    CHECK(report.number_of_loop_turns == std::abs(first) + std::abs(second));
    CHECK(are_equal(mesh, straight, signature));
    CHECK(report.energy == Approx(energy_by_definition(mesh, straight)).margin(1e-9));
  }
}

TEST_CASE("splits and loop turns lower the energy of the definition, as reported")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(12, 12)); // cones are points, see above
  const auto vertex = [](const unsigned int i) { return Mesh::Vertex_index(i); };
  for (const unsigned int shift : {0u, 5u, 17u}) {
    Signature signature;
    REQUIRE(ts::holonomy_signature_of_cones(
                mesh,
                std::vector<std::pair<Mesh::Vertex_index, int>>{
                    {vertex(shift), 1}, {vertex(shift + 30), 8}, {vertex(shift + 66), 2}, {vertex(shift + 90), 5}},
                signature)
                .success());
    const double before = energy_by_definition(mesh, signature);
    const auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_energy_change(-1000.));
    const double after = energy_by_definition(mesh, signature);
    CHECK(report.number_of_merges == 0);
    CHECK(report.number_of_splits >= 3);
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
    for (const auto& cone : signature.cones())
      CHECK((cone.second >= 3 && cone.second <= 6));
    CHECK(after < before);
    CHECK(report.energy - report.energy_before == Approx(after - before).margin(1e-8));
  }
}

TEST_CASE("four half turns on a sphere become three cones")
{
  const Mesh mesh = test::to_mesh<Mesh>(sphere(4));
  Signature signature;
  for (const unsigned int v : {3u, 20u, 50u, 70u})
    signature.set_quarter_turns(Mesh::Vertex_index(v), 2);
  REQUIRE(ts::check_holonomy_signature(mesh, signature).success());
  const auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(3));
  CHECK(report.success());
  CHECK(signature.cones().size() == 3);
  CHECK(ts::check_holonomy_signature(mesh, signature).success());
  CHECK(ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(2)).status ==
        Status::LIMIT_UNREACHABLE);
  CHECK(signature.cones().size() == 3);
}

TEST_CASE("components do not mix, and their sizes do not matter")
{
  const test::Soup one = sphere(6);
  const Mesh mesh = test::to_mesh<Mesh>(test::disjoint_union(one, test::transformed(one, 1. / (1 << 20), {0, 0, 0})));
  const auto n = static_cast<unsigned int>(one.points.size());
  Signature signature;
  for (unsigned int i = 0; i < 14; ++i)
    for (const unsigned int first : {0u, n})
      signature.set_quarter_turns(Mesh::Vertex_index(first + 7 * i), i < 11 ? 3 : 5);
  REQUIRE(ts::check_holonomy_signature(mesh, signature).success());
  for (const int limit : {20, 16, 10, 6}) {
    Signature reduced = signature;
    const auto report = ts::reduce_cones(mesh, reduced, ts::parameters::maximum_number_of_cones(limit));
    CHECK(report.success());
    CHECK(ts::check_holonomy_signature(mesh, reduced).success());
    CHECK(static_cast<int>(reduced.cones().size()) <= limit);
  }
  REQUIRE(ts::reduce_cones(mesh, signature).success());
  for (unsigned int v = 0; v < n; ++v)
    CHECK(signature.quarter_turns(Mesh::Vertex_index(v)) == signature.quarter_turns(Mesh::Vertex_index(n + v)));
}

TEST_CASE("by default the genus of each component sets its limit")
{
  test::Soup soup;
  std::vector<std::size_t> first_vertex;
  for (int genus = 0; genus <= 3; ++genus) {
    first_vertex.push_back(soup.points.size());
    soup = test::disjoint_union(soup, genus == 0 ? cross(3) : test::plate(genus, 3));
  }
  const Mesh mesh = test::to_mesh<Mesh>(soup);
  std::vector<std::pair<Mesh::Vertex_index, int>> cones;
  std::vector<std::vector<Mesh::Vertex_index>> component(4);
  for (const Mesh::Vertex_index v : vertices(mesh))
    component[std::upper_bound(first_vertex.begin(), first_vertex.end(), std::size_t(v)) - first_vertex.begin() - 1]
        .push_back(v);
  std::mt19937 random(5);
  for (int genus = 0; genus <= 3; ++genus) {
    std::shuffle(component[genus].begin(), component[genus].end(), random);
    const int sum = 8 * (1 - genus);
    for (int i = 0; i < std::abs(sum) + 24; ++i)
      cones.emplace_back(component[genus][i], i < std::abs(sum) ? (sum > 0 ? 3 : 5) : 3 + i % 2 * 2);
  }
  Signature signature;
  REQUIRE(ts::holonomy_signature_of_cones(mesh, cones, signature).success());
  const auto reduced = [&](const std::optional<double> energy) {
    Signature result = signature;
    REQUIRE(ts::reduce_cones(mesh, result, ts::parameters::maximum_energy_change(energy)).success());
    return result;
  };
  const Signature by_default = reduced(std::nullopt);
  std::array<int, 4> number_of_differences{};
  for (const double energy : {0.3, 3., 4., 6.}) {
    const Signature by_energy = reduced(energy);
    for (int genus = 0; genus <= 3; ++genus) {
      const bool is_default = energy == (genus == 0 ? 6 : genus == 1 ? 3 : 4);
      for (const Mesh::Vertex_index v : component[genus]) {
        const bool is_equal = by_default.quarter_turns(v) == by_energy.quarter_turns(v);
        if (is_default)
          REQUIRE(is_equal);
        else
          number_of_differences[genus] += is_equal ? 0 : 1;
      }
    }
  }
  for (int genus = 0; genus <= 3; ++genus) {
    CAPTURE(genus);
    CHECK(number_of_differences[genus] > 0);
  }
}

TEST_CASE("the order in which cones are set does not matter, and equal input gives equal results")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::plate(2, 4));
  const Signature signature = random_signature(mesh, 20, 7);
  Signature reversed = signature, first = signature, second = signature;
  for (const auto& cone : signature.cones())
    reversed.set_quarter_turns(cone.first, 4);
  for (auto cone = signature.cones().rbegin(); cone != signature.cones().rend(); ++cone)
    reversed.set_quarter_turns(cone->first, cone->second);
  for (Signature* s : {&reversed, &first, &second})
    CHECK(ts::reduce_cones(mesh, *s).success());
  CHECK(are_equal(mesh, first, second));
  CHECK(are_equal(mesh, first, reversed));
}

TEST_CASE("the resolution of a mesh hardly changes energies")
{
  double energy_before[2], energy[2];
  for (const int i : {0, 1}) {
    const Mesh mesh = test::to_mesh<Mesh>(sphere(i == 0 ? 36 : 72));
    Signature signature;
    for (const auto v : vertices(mesh)) { // corners and middles of edges of the cube
      const test::Point_3 p = mesh.point(v);
      std::vector<double> x = {std::abs(p.x()), std::abs(p.y()), std::abs(p.z())};
      std::sort(x.begin(), x.end());
      if (x[2] - x[0] < 1e-9)
        signature.set_quarter_turns(v, 3);
      else if (x[0] < 1e-9 && x[2] - x[1] < 1e-9 && std::abs(p.z()) > 0.5)
        signature.set_quarter_turns(v, p.x() + 1.5 * p.y() > 0 ? 3 : 5);
    }
    REQUIRE(signature.cones().size() == 16);
    const auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(8));
    CHECK(report.number_of_cones == 8);
    energy_before[i] = report.energy_before;
    energy[i] = report.energy;
  }
  CHECK(std::abs(energy_before[0] - energy_before[1]) < 0.03 * energy_before[1]);
  CHECK(std::abs((energy[0] - energy_before[0]) - (energy[1] - energy_before[1])) < 0.03 * energy_before[1]);
}

TEMPLATE_TEST_CASE("fields of real meshes are thinned out, and their signatures still have a map", "",
                   test::Surface_mesh, test::Polyhedron_3)
{
  for (const char* name : {"eight.off", "elephant.off", "cow.off"}) {
    TestType mesh;
    std::ifstream input(std::string(T_SPLINES_DEMO_DATA) + "/meshes/" + name);
    REQUIRE(CGAL::IO::read_OFF(input, mesh));
    ts::Holonomy_signature<TestType> signature = smooth_signature(mesh);
    const auto report = ts::reduce_cones(mesh, signature);
    REQUIRE(report.success());
    CHECK(report.number_of_cones <= 0.8 * report.number_of_cones_before);
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
    ts::Similarity_metric<TestType> metric;
    CHECK(ts::compute_similarity_metric(mesh, signature, metric).success());
  }
}

TEST_CASE("a surface of high genus, on which only near cones are merged with each other")
{
  // Genus 60 and more than 400 cones: the vectors of all pairs would be 180 MB.
  Mesh mesh = test::to_mesh<Mesh>(test::plate(60, 2));
  const Signature before = smooth_signature(mesh);
  REQUIRE(before.loops().size() == 120);
  REQUIRE(before.cones().size() > 400);
  for (const int limit : {0, 20}) {
    Signature signature = before;
    const auto report = limit == 0 ? ts::reduce_cones(mesh, signature)
                                   : ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(limit));
    REQUIRE(report.success());
    CHECK(report.number_of_cones <= (limit == 0 ? report.number_of_cones_before - 50 : limit));
    CHECK(ts::check_holonomy_signature(mesh, signature).success());
    // The energy that the merges add up to is that of the signature that they leave.
    const auto again = ts::reduce_cones(
        mesh, signature, ts::parameters::maximum_energy_change(-std::numeric_limits<double>::infinity()));
    CHECK(again.number_of_merges == 0);
    CHECK(again.energy_before == Approx(report.energy).epsilon(1e-6));
  }
}

TEST_CASE("bad input and interruptions leave the signature as it was")
{
  Mesh mesh = test::to_mesh<Mesh>(test::plate(2, 2));
  Signature signature = random_signature(mesh, 5, 0);
  const Signature before = signature;
  CHECK(ts::reduce_cones(mesh, signature, CGAL::parameters::visitor(Interrupting_visitor())).status ==
        Status::INTERRUPTED);
  CHECK(are_equal(mesh, signature, before));
  CHECK(ts::reduce_cones(mesh, signature, CGAL::parameters::sparse_linear_solver(Failing_solver())).status ==
        Status::SOLVER_FAILED);
  CHECK(are_equal(mesh, signature, before));
  const auto v = before.cones().front().first;
  signature.set_quarter_turns(v, before.quarter_turns(v) + 1);
  const Signature violated = signature;
  auto report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(1));
  CHECK(report.status == Status::INVALID_SIGNATURE);
  CHECK(report.signature.status == ts::Holonomy_signature_status::GAUSS_BONNET_VIOLATED);
  CHECK(are_equal(mesh, signature, violated));
  signature = before;
  mesh.point(Mesh::Vertex_index(3)) = test::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  report = ts::reduce_cones(mesh, signature, ts::parameters::maximum_number_of_cones(1));
  CHECK(report.status == Status::INVALID_MESH);
  CHECK(report.signature.mesh.vertex == Mesh::Vertex_index(3));
  CHECK(are_equal(mesh, signature, before));
  CHECK(describe(report, mesh) ==
        "a vertex has a coordinate that is infinite or not a number: vertex 3, counted from 0; correct it");
}

TEST_CASE("a signature of another mesh, or of the mesh before an edit, is refused")
{
  Mesh mesh = test::to_mesh<Mesh>(test::plate(2, 2)), small = test::to_mesh<Mesh>(test::torus(4, 4));
  Signature signature = random_signature(mesh, 5, 0);
  const Signature before = signature;
  SECTION("another mesh")
  {
    const auto report = ts::reduce_cones(small, signature);
    CHECK(report.status == Status::INVALID_SIGNATURE);
    CHECK(report.signature.status == ts::Holonomy_signature_status::FOREIGN_VERTEX);
    CHECK(describe(report, small).find("cone ") != std::string::npos);
    CHECK(are_equal(mesh, signature, before));
  }
  SECTION("before an edit")
  {
    // The mesh loses a vertex that is a cone.
    const auto h = halfedge(before.cones().front().first, mesh);
    CGAL::Euler::remove_center_vertex(h, mesh);
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    REQUIRE(ts::check_triangle_mesh(mesh).success());
    const auto report = ts::reduce_cones(mesh, signature);
    CHECK(report.status == Status::INVALID_SIGNATURE);
    CHECK(report.signature.status == ts::Holonomy_signature_status::FOREIGN_VERTEX);
    CHECK(report.signature.index == 0);
  }
}

} // namespace reduce_cones_test
