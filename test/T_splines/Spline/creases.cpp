// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Creases of the surface.
namespace creases_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<Rational>;
using Vertex = Mesh::vertex_descriptor;
using Halfedge = Mesh::halfedge_descriptor;
using Face = Mesh::face_descriptor;

bool is_crease(const Mesh& t, const Halfedge h)
{
  return get(t.creases(), edge(h, t.mesh));
}

// A part of the surroundings of a vertex between two creases, by the halfedges that end at the vertex, counter-clockwise.
struct Sector {
  Vertex v;
  std::vector<Halfedge> halfedges;
  int quarters = 0;
};

// Those of all vertices with creases. \pre the T-mesh is closed
std::vector<Sector> sectors(const Mesh& t)
{
  std::vector<Sector> result;
  for (const Halfedge first : halfedges(t.mesh)) {
    if (!is_crease(t, next(first, t.mesh)))
      continue;
    result.push_back({target(first, t.mesh), {}, 0});
    for (Halfedge h = first;; h = prev(opposite(h, t.mesh), t.mesh)) {
      result.back().halfedges.push_back(h);
      result.back().quarters += get(t.corners(), h) ? 1 : 2;
      if (is_crease(t, h))
        break;
    }
  }
  return result;
}

// What is known of the places where the surface is less than twice differentiable.
struct Exceptions {
  std::set<Face> at_corners; // that turn inwards
  std::set<Halfedge> kinked; // on a line that begins where creases end and the surface goes straight on
  std::set<Face> at_kinks;   // where no edges run along such a line
};

// A face, and those up to three faces away from it on the same side of creases.
void add_surroundings(const Mesh& t, const Face f, std::set<Face>& result)
{
  std::set<Face> last{f};
  for (int i = 0; i < 4; ++i) {
    result.insert(last.begin(), last.end());
    std::set<Face> next;
    for (const Face g : last)
      for (const Halfedge h : CGAL::halfedges_around_face(halfedge(g, t.mesh), t.mesh))
        if (!is_crease(t, h))
          next.insert(face(opposite(h, t.mesh), t.mesh));
    last = next;
  }
}

Exceptions exceptions(const Mesh& t)
{
  Exceptions result;
  const std::vector<Sector> all = sectors(t);
  std::map<Vertex, std::vector<int>> quarters;
  for (const Sector& sector : all)
    quarters[sector.v].push_back(sector.quarters);
  for (const Sector& sector : all) {
    if (sector.quarters > 2)
      for (const Halfedge h : sector.halfedges)
        result.at_corners.insert(face(h, t.mesh));
    if (sector.quarters != 2 || quarters[sector.v] == std::vector<int>{2, 2})
      continue;
    if (sector.halfedges.size() == 1) {
      add_surroundings(t, face(sector.halfedges.front(), t.mesh), result.at_kinks);
      continue;
    }
    Halfedge h = opposite(sector.halfedges.front(), t.mesh);
    for (int i = 0; i < 16; ++i) {
      result.kinked.insert(h);
      result.kinked.insert(opposite(h, t.mesh));
      const Halfedge n = next(h, t.mesh), o = opposite(n, t.mesh);
      if (!get(t.corners(), h))
        h = n;
      else if (!is_crease(t, n) && get(t.corners(), o))
        h = next(o, t.mesh);
      else {
        if (!is_crease(t, n))
          add_surroundings(t, face(o, t.mesh), result.at_kinks);
        break;
      }
    }
  }
  return result;
}

double sine(const Kernel::Vector_3& a, const Kernel::Vector_3& b)
{
  return std::sqrt(CGAL::cross_product(a, b).squared_length() / (a.squared_length() * b.squared_length()));
}

} // namespace

TEST_CASE("a cube of six faces with twelve creases is a cube, exactly", "[creases]")
{
  using Exact_mesh = Spline_mesh<Rational, Exact_kernel>;
  Exact_mesh t(test_t_meshes::cube<Rational>());
  for (const auto e : edges(t.mesh))
    put(t.creases(), e, true);
  const auto report = t.make_spline_compatible();
  INFO(message(report.status));
  REQUIRE(report);
  CHECK(report.vertices_after == 8);
  // Corners of the cube: face 0 is the bottom, seen from below.
  std::map<Exact_mesh::vertex_descriptor, Exact_kernel::Point_3> corner;
  const auto set = [&](const std::size_t f, const int i, const int x, const int y, const int z) {
    const auto v = source(t.halfedge_of(f, i), t.mesh);
    corner[v] = Exact_kernel::Point_3(x, y, z);
    t.set_control(v, corner[v], Rational(1));
  };
  set(0, 0, 0, 0, 0), set(0, 1, 0, 1, 0), set(0, 2, 1, 1, 0), set(0, 3, 1, 0, 0);
  for (int i = 0; i < 4; ++i) { // above the corner below
    const auto h = t.halfedge_of(0, i), o = opposite(h, t.mesh);
    const auto v = target(next(o, t.mesh), t.mesh);
    const auto below = target(o, t.mesh);
    corner[v] = corner[below] + Exact_kernel::Vector_3(0, 0, 1);
    t.set_control(v, corner[v], Rational(1));
  }
  const Exact_mesh::Surface surface = t.surface();
  REQUIRE(surface.is_valid());
  CGAL::Random random(1);
  for (const auto f : faces(t.mesh)) {
    std::vector<Exact_kernel::Point_3> corners;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh))
      corners.push_back(corner[source(h, t.mesh)]);
    for (int i = 0; i < 10; ++i) {
      const Rational x = Rational(random.get_int(0, 65)) / 64, y = Rational(random.get_int(0, 65)) / 64;
      const auto jet = surface.jet(f, Rational(x * surface.width(f)), Rational(y * surface.height(f)));
      CHECK(jet.position == corners[0] + x * (corners[1] - corners[0]) + y * (corners[3] - corners[0]));
      CHECK(jet.duu == CGAL::NULL_VECTOR);
      CHECK(jet.duv == CGAL::NULL_VECTOR);
    }
  }
}

TEST_CASE("creases have one curve, and the surface is smooth elsewhere", "[creases]")
{
  CGAL::Random random(1);
  for (const auto& [name, given] : closed_surfaces<Rational>())
    for (const int one_in : {1, 2, 4, 12})
      for (const int splits : {0, 12}) {
        INFO(name << ", " << splits << " splits, one edge in " << one_in);
        Mesh t(given);
        for (const auto e : edges(t.mesh))
          put(t.creases(), e, random.get_int(0, one_in) == 0);
        if (splits > 0) {
          const auto report = CGAL::T_splines::make_spline_compatible(t);
          INFO(message(report.status));
          REQUIRE(report);
          t.split_randomly(splits, random);
        }
        const auto report = CGAL::T_splines::make_spline_compatible(t);
        INFO(message(report.status));
        REQUIRE(report);
        t.set_random_controls(random);
        const Mesh::Surface surface = t.surface();
        REQUIRE(surface.is_valid());
        const auto compiled = CGAL::T_splines::compile_T_spline(surface);
        const Exceptions special = exceptions(t);
        Jet_difference smooth, at_corners, compilation;
        double gap = 0, kinked = 0, angle = 0;
        const auto is_special = [&](const Face f) { return special.at_corners.count(f) != 0; };
        std::size_t i = 0;
        const auto pieces = edge_pieces<double>(t);
        for (const Halfedge h : halfedges(t.mesh)) {
          const auto& piece = pieces[i++];
          REQUIRE(piece.face == face(h, t.mesh));
          for (const double s : {0., 1e-6, 0.01, 0.3, 0.5, 0.6, 0.99, 1.}) {
            if ((s == 0 && piece.has_cone[0]) || (s == 1 && piece.has_cone[1]))
              continue;
            const auto p = inside(surface, piece.face, piece.at(s));
            const auto q = inside(surface, piece.opposite_face, piece.transition(p.first, p.second));
            const auto a = surface.jet(piece.face, p.first, p.second);
            const auto b = pulled_back(surface.jet(piece.opposite_face, q.first, q.second), piece.transition);
            const double size = (std::min)(surface.width(piece.face), surface.height(piece.face));
            Jet_difference d = difference(a, b, size);
            if (!surface.is_at_extraordinary_vertex(piece.face))
              compilation.add(difference(a, compiled.jet(piece.face, p.first, p.second), size));
            if (is_crease(t, h))
              gap = (std::max)(gap, d.position);
            else if (special.kinked.count(h) != 0 || special.at_kinks.count(piece.face) != 0)
              kinked = (std::max)(kinked, d.position);
            else if (!is_special(piece.face) && !is_special(piece.opposite_face))
              smooth.add(d);
            else {
              angle = (std::max)(angle, sine(CGAL::cross_product(a.du, a.dv), CGAL::cross_product(b.du, b.dv)));
              d.second = d.first = 0;
              at_corners.add(d);
            }
          }
        }
        CHECK(gap < 1e-13);
        CHECK(kinked < 1e-13);
        CHECK(smooth.largest() < 1e-9);
        CHECK(at_corners.position < 1e-13);
        CHECK(angle < 1e-6);
        CHECK(compilation.position < 1e-12);
      }
}

} // namespace creases_test
