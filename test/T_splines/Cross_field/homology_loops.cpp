// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/homology_classes.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>

#include "test_meshes.h"

#include <CGAL/number_type_config.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <set>

namespace homology_loops_test {

namespace in = CGAL::T_splines::internal;
using Mesh = test::Surface_mesh;
using Domain = in::Signature_domain<Mesh>;

namespace {

in::Progress nobody;

std::vector<int> all_faces(const Domain& mesh)
{
  std::vector<int> result(mesh.m_connectivity.number_of_faces());
  std::iota(result.begin(), result.end(), 0);
  return result;
}

bool generate(const Domain& mesh, const std::vector<std::vector<int>>& strips)
{
  return in::generate_homology(mesh.m_connectivity, in::dual_edge_lengths(mesh.m_connectivity, mesh.m_geometry),
                               all_faces(mesh), strips, nobody);
}

double length(const Domain& mesh, const std::vector<int>& strip)
{
  const std::vector<double> dual_length = in::dual_edge_lengths(mesh.m_connectivity, mesh.m_geometry);
  double sum = 0;
  for (const int h : strip)
    sum += dual_length[h / 2];
  return sum * mesh.m_geometry.m_unit;
}

} // namespace

TEST_CASE("2g closed strips generate the homology, and none enters a face twice")
{
  for (int genus = 0; genus <= 4; ++genus) {
    const Mesh mesh = test::to_mesh<Mesh>(test::plate(genus));
    const Domain domain(mesh, CGAL::parameters::default_values());
    REQUIRE(domain.m_components.size() == 1);
    CHECK(domain.m_components.genus(0) == genus);
    const std::vector<std::vector<int>> loops = domain.short_loops(nobody);
    REQUIRE(static_cast<int>(loops.size()) == 2 * genus);
    for (const std::vector<int>& loop : loops) {
      CHECK(in::is_closed_strip(domain.m_connectivity, loop));
      std::set<int> faces;
      for (const int h : loop)
        faces.insert(domain.m_connectivity.face(h));
      CHECK(faces.size() == loop.size());
    }
    CHECK(generate(domain, loops));
  }
}

TEST_CASE("loops that are dependent, or generate a part only, are found out")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::plate(2));
  const Domain domain(mesh, CGAL::parameters::default_values());
  const std::vector<std::vector<int>> loops = domain.short_loops(nobody);
  std::vector<std::vector<int>> repeated = loops;
  repeated[1] = repeated[0];
  CHECK_FALSE(generate(domain, repeated));
  // Twice around: independent over the rationals, yet no generator.
  std::vector<std::vector<int>> doubled = loops;
  doubled[2].insert(doubled[2].end(), loops[2].begin(), loops[2].end());
  CHECK(in::is_closed_strip(domain.m_connectivity, doubled[2]));
  CHECK_FALSE(generate(domain, doubled));
}

TEST_CASE("loops of a torus are about as short as its circles")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::torus(60, 20));
  const Domain domain(mesh, CGAL::parameters::default_values());
  const std::vector<std::vector<int>> loops = domain.short_loops(nobody);
  REQUIRE(loops.size() == 2);
  // Dual paths by the midpoints of edges zigzag.
  CHECK(length(domain, loops[0]) < 1.5 * 2 * CGAL_PI * 1);
  CHECK(length(domain, loops[1]) < 1.5 * 2 * CGAL_PI * 2.5);
}

TEST_CASE("components are numbered by their first faces and have their own loops")
{
  const Mesh mesh = test::to_mesh<Mesh>(
      test::disjoint_union(test::plate(2), test::disjoint_union(test::plate(0), test::torus(6, 5))));
  const Domain domain(mesh, CGAL::parameters::default_values());
  REQUIRE(domain.m_components.size() == 3);
  CHECK(domain.m_components.euler_characteristic == std::vector<int>{-2, 2, 0});
  std::vector<int> number_of_loops(3, 0);
  for (const std::vector<int>& loop : domain.short_loops(nobody))
    ++number_of_loops[domain.m_components.of_face[domain.m_connectivity.face(loop.front())]];
  CHECK(number_of_loops == std::vector<int>{4, 0, 2});
}

TEST_CASE("the turning around a vertex is its angle, and reversing a strip reverses its turning")
{
  const Mesh mesh = test::to_mesh<Mesh>(test::plate(1));
  const Domain domain(mesh, CGAL::parameters::default_values());
  const in::Triangulation_connectivity& connectivity = domain.m_connectivity;
  const std::vector<double>& angle = domain.m_geometry.m_corner_angle;
  const std::vector<int> outgoing = connectivity.outgoing_halfedges();
  std::vector<double> total(connectivity.number_of_vertices(), 0.);
  for (int h = 0; h < connectivity.number_of_halfedges(); ++h)
    total[connectivity.target(h)] += angle[h];
  for (int v = 0; v < connectivity.number_of_vertices(); ++v) {
    std::vector<int> strip;
    int h = outgoing[v];
    do {
      strip.push_back(h);
      h = connectivity.next_around_source(h);
    } while (h != outgoing[v]);
    CHECK(in::strip_turning(connectivity, strip, angle) == Approx(total[v]));
  }
  for (const std::vector<int>& loop : domain.short_loops(nobody)) {
    std::vector<int> reverse;
    for (auto h = loop.rbegin(); h != loop.rend(); ++h)
      reverse.push_back(in::opposite(*h));
    CHECK(in::strip_turning(connectivity, reverse, angle) == Approx(-in::strip_turning(connectivity, loop, angle)));
  }
}

} // namespace homology_loops_test
