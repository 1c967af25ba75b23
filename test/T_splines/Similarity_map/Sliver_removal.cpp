// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Similarity_map/internal/Sliver_removal.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Sliver_removal_test {

namespace {

using namespace CGAL::T_splines::internal;
using Point = std::array<double, 3>;
using Uv = std::array<double, 2>;
using Triangles = std::vector<std::array<int, 3>>;

Progress nobody;

const Triangles tetrahedron = {{{0, 1, 2}}, {{0, 3, 1}}, {{1, 3, 2}}, {{2, 3, 0}}};

Triangulation_connectivity connectivity(const Triangles& triangles, const int number_of_vertices)
{
  Triangulation_connectivity mesh;
  std::map<std::pair<int, int>, int> halfedge;
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (!halfedge.count({a, b})) {
        const int h = static_cast<int>(halfedge.size());
        halfedge[{a, b}] = h;
        halfedge[{b, a}] = h + 1;
      }
    }
  mesh.m_number_of_vertices = number_of_vertices;
  mesh.m_next.resize(halfedge.size(), Triangulation_connectivity::null);
  mesh.m_target.resize(halfedge.size());
  mesh.m_face.resize(halfedge.size(), Triangulation_connectivity::null);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& t = triangles[f];
    for (int i = 0; i < 3; ++i) {
      const int h = halfedge.at({t[i], t[(i + 1) % 3]});
      mesh.m_next[h] = halfedge.at({t[(i + 1) % 3], t[(i + 2) % 3]});
      mesh.m_target[h] = t[(i + 1) % 3];
      mesh.m_face[h] = static_cast<int>(f);
    }
    mesh.m_face_halfedge.push_back(halfedge.at({t[0], t[1]}));
  }
  for (const auto& [ends, h] : halfedge)
    if (mesh.face(h) == Triangulation_connectivity::null) {
      mesh.m_target[h] = ends.second;
      for (const auto& [other_ends, g] : halfedge)
        if (mesh.face(g) == Triangulation_connectivity::null && other_ends.first == ends.second)
          mesh.m_next[h] = g;
    }
  return mesh;
}

/// A tetrahedron whose first face, a right triangle in the plane z = 0, is refined; that face is its own map, the others have charts of
/// their own.
struct Refined_tetrahedron {
  std::vector<Point> input_point = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0.3, 0.3, -1}}};
  Triangulation_connectivity input = connectivity(tetrahedron, 4);
  Refined_triangulation refined;
  std::vector<char> is_cut;

  Refined_tetrahedron(const std::vector<Point>& added, const Triangles& of_first_face)
  {
    Triangles triangles = of_first_face;
    triangles.insert(triangles.end(), tetrahedron.begin() + 1, tetrahedron.end());
    refined.point = input_point;
    refined.point.insert(refined.point.end(), added.begin(), added.end());
    const int vertices = static_cast<int>(refined.point.size());
    refined.mesh = connectivity(triangles, vertices);
    refined.place.resize(vertices);
    for (int v = 0; v < vertices; ++v)
      refined.place[v] = v < 4 ? Input_place{Input_place::Kind::VERTEX, v} : Input_place{Input_place::Kind::FACE, 0};
    for (std::size_t f = 0; f < triangles.size(); ++f)
      refined.input_face.push_back(f < of_first_face.size() ? 0 : static_cast<int>(f - of_first_face.size()) + 1);
    const int halfedges = refined.mesh.number_of_halfedges();
    refined.uv.resize(halfedges);
    refined.final_halfedge.assign(halfedges, Refined_triangulation::none);
    refined.input_halfedge.assign(halfedges, Refined_triangulation::none);
    is_cut.assign(halfedges / 2, 0);
    for (int h = 0; h < halfedges; ++h) {
      const Point& p = refined.point[refined.mesh.target(h)];
      const int f = refined.mesh.face(h), first = refined.mesh.halfedge_of_face(f);
      const Uv corner = h == first ? Uv{{0, 0}} : h == refined.mesh.next(first) ? Uv{{1, 0}} : Uv{{0, 1}};
      refined.uv[h] = refined.input_face[f] == 0 ? Uv{{p[0], p[1]}} : corner;
      for (int g = 0; g < input.number_of_halfedges(); ++g)
        if (input.source(g) == refined.mesh.source(h) && input.target(g) == refined.mesh.target(h)) {
          refined.input_halfedge[h] = g;
          is_cut[h / 2] = 1;
        }
    }
  }

  bool is_positive(const int f) const
  {
    const int h = refined.mesh.halfedge_of_face(f);
    const Uv &p = refined.uv[h], &q = refined.uv[refined.mesh.next(h)], &r = refined.uv[refined.mesh.previous(h)];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0;
  }

  void check_closed() const
  {
    const Triangulation_connectivity& mesh = refined.mesh;
    CHECK(mesh.number_of_vertices() - mesh.number_of_edges() + mesh.number_of_faces() == 2);
    CHECK(std::size_t(mesh.number_of_vertices()) == refined.point.size());
    CHECK(std::equal(input_point.begin(), input_point.end(), refined.point.begin()));
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      CHECK(mesh.next(mesh.next(mesh.next(h))) == h);
      CHECK(mesh.face(mesh.next(h)) == mesh.face(h));
      CHECK(mesh.target(mesh.previous(h)) == mesh.source(h));
    }
  }
};

/// A right triangle in the plane z = 0, refined, without other faces around it; it is its own map.
struct Refined_triangle {
  std::vector<Point> input_point = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
  Triangulation_connectivity input = connectivity({{{0, 1, 2}}}, 3);
  Refined_triangulation refined;
  std::vector<char> is_cut;

  /// \param added points inside, or on the side from (0, 0) to (1, 0)
  Refined_triangle(const std::vector<Point>& added, const Triangles& triangles)
  {
    refined.point = input_point;
    refined.point.insert(refined.point.end(), added.begin(), added.end());
    const int vertices = static_cast<int>(refined.point.size());
    refined.mesh = connectivity(triangles, vertices);
    refined.input_face.assign(triangles.size(), 0);
    for (int v = 0; v < vertices; ++v)
      refined.place.push_back({v < 3                      ? Input_place::Kind::VERTEX
                               : refined.point[v][1] == 0 ? Input_place::Kind::EDGE
                                                          : Input_place::Kind::FACE,
                               0,
                               {{0, 0, 0}}});
    const int halfedges = refined.mesh.number_of_halfedges();
    refined.final_halfedge.assign(halfedges, Refined_triangulation::none);
    is_cut.assign(halfedges / 2, 0);
    for (int h = 0; h < halfedges; ++h) {
      const Point &p = refined.point[refined.mesh.target(h)], &q = refined.point[refined.mesh.source(h)];
      refined.uv.push_back({{p[0], p[1]}});
      int on_input = Refined_triangulation::none;
      for (int g = 0; g < 6; ++g) {
        const Point &a = input_point[input.source(g)], &b = input_point[input.target(g)];
        const auto is_on = [&](const Point& x) {
          return (b[0] - a[0]) * (x[1] - a[1]) == (b[1] - a[1]) * (x[0] - a[0]);
        };
        if (is_on(p) && is_on(q) && (b[0] - a[0]) * (p[0] - q[0]) + (b[1] - a[1]) * (p[1] - q[1]) > 0)
          on_input = g;
      }
      refined.input_halfedge.push_back(on_input);
    }
  }

  void check() const
  {
    const Triangulation_connectivity& mesh = refined.mesh;
    CHECK(mesh.number_of_vertices() - mesh.number_of_edges() + mesh.number_of_faces() == 1);
    CHECK(std::equal(input_point.begin(), input_point.end(), refined.point.begin()));
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      CHECK(mesh.source(mesh.next(h)) == mesh.target(h));
      CHECK(mesh.face(mesh.next(h)) == mesh.face(h));
      if (mesh.face(h) == Triangulation_connectivity::null) {
        CHECK(refined.input_halfedge[h] != Refined_triangulation::none);
        CHECK(refined.input_halfedge[opposite(h)] == opposite(refined.input_halfedge[h]));
        continue;
      }
      CHECK(mesh.next(mesh.next(mesh.next(h))) == h);
      CHECK(refined.uv[h][0] == refined.point[mesh.target(h)][0]);
      CHECK(refined.uv[h][1] == refined.point[mesh.target(h)][1]);
    }
    double area = 0;
    for (int f = 0; f < mesh.number_of_faces(); ++f) {
      const int h = mesh.halfedge_of_face(f);
      const Uv &p = refined.uv[h], &q = refined.uv[mesh.next(h)], &r = refined.uv[mesh.previous(h)];
      const double twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
      CHECK(twice > 1e-6);
      area += twice / 2;
    }
    CHECK(area == Approx(0.5).epsilon(1e-14)); // the border stays
  }
};

} // namespace

TEST_CASE("vertices on a border are moved along it", "[Sliver_removal]")
{
  // Two nearly coincide in the middle of the side, or one of them with one of its ends.
  for (const auto& [x, y] :
       {std::make_pair(0.5, 0.5 + 1e-12), std::make_pair(1e-13, 0.5), std::make_pair(0.5, 1 - 1e-13)}) {
    Refined_triangle t({{{x, 0, 0}}, {{y, 0, 0}}}, {{{0, 3, 2}}, {{3, 4, 2}}, {{4, 1, 2}}});
    CHECK(Sliver_removal(t.input, t.input_point, t.refined, t.is_cut, nobody).first_bad_input_face() == -1);
    CHECK(t.refined.mesh.number_of_faces() == 2);
    t.check();
  }
}

TEST_CASE("a vertex beside a border is moved away from it or into it", "[Sliver_removal]")
{
  // Vertex 4 is beyond the side, beside vertex 3 on it.
  Refined_triangle t({{{0.5, 0, 0}}, {{0.5 + 1e-12, -1e-14, 0}}}, {{{0, 3, 2}}, {{3, 4, 2}}, {{4, 1, 2}}, {{3, 1, 4}}});
  CHECK(Sliver_removal(t.input, t.input_point, t.refined, t.is_cut, nobody).first_bad_input_face() == -1);
  t.check();
}

TEST_CASE("what is positive is left alone", "[Sliver_removal]")
{
  Refined_tetrahedron t({{{0.2, 0.2, 0}}}, {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 0, 4}}});
  CHECK(Sliver_removal(t.input, t.input_point, t.refined, t.is_cut, nobody).first_bad_input_face() == -1);
  CHECK(t.refined.mesh.number_of_faces() == 6);
  t.check_closed();
}

TEST_CASE("a vertex on the wrong side of an edge is taken out", "[Sliver_removal]")
{
  Refined_tetrahedron t({{{0.2, -1e-17, 0}}}, {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 0, 4}}});
  REQUIRE_FALSE(t.is_positive(0));
  CHECK(Sliver_removal(t.input, t.input_point, t.refined, t.is_cut, nobody).first_bad_input_face() == -1);
  CHECK(t.refined.mesh.number_of_faces() == 4);
  t.check_closed();
  for (int f = 0; f < t.refined.mesh.number_of_faces(); ++f)
    CHECK(t.is_positive(f));
}

TEST_CASE("a diagonal outside of its quadrilateral is flipped", "[Sliver_removal]")
{
  // Vertex 4 lies inside the triangle 0, 1, 5.
  Refined_tetrahedron t({{{0.4, 0.2, 0}}, {{0.2, 0.5, 0}}},
                        {{{0, 1, 5}}, {{1, 4, 5}}, {{1, 2, 4}}, {{2, 5, 4}}, {{2, 0, 5}}});
  REQUIRE_FALSE(t.is_positive(1));
  CHECK(Sliver_removal(t.input, t.input_point, t.refined, t.is_cut, nobody).first_bad_input_face() == -1);
  t.check_closed();
  for (int f = 0; f < t.refined.mesh.number_of_faces(); ++f)
    CHECK(t.is_positive(f));
}

TEST_CASE("what cannot be repaired is named", "[Sliver_removal]")
{
  Refined_tetrahedron t({}, {{{0, 1, 2}}});
  const int h = t.refined.mesh.halfedge_of_face(2);
  std::swap(t.refined.uv[h], t.refined.uv[t.refined.mesh.next(h)]);
  CHECK(Sliver_removal(t.input, t.input_point, t.refined, t.is_cut, nobody).first_bad_input_face() == 2);
}

} // namespace Sliver_removal_test
