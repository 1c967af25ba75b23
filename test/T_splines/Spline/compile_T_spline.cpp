// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/compile_T_spline.h>

#include <CGAL/T_splines/named_parameters.h>

#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace compile_T_spline_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<Rational>;
using Face = Mesh::face_descriptor;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Compiled = CGAL::T_splines::Compiled_T_spline<Surface_mesh, Kernel>;
using Domain = Compiled::Domain;
using CGAL::T_splines::compile_T_spline;
namespace parameters = CGAL::T_splines::parameters;

void prepare(Mesh& t, const int splits, CGAL::Random& random)
{
  t.make_spline_compatible();
  t.split_randomly(splits, random);
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
}

double size_of(const Mesh::Surface& surface, const Face f)
{
  return (std::min)(surface.width(f), surface.height(f));
}

// The jet of a patch with respect to the face's parameters.
Compiled::Jet patch_jet(const Compiled& compiled, const std::size_t i, const double u, const double v)
{
  const Domain d = compiled.domain(i);
  const double a = 1 / (d.u_end - d.u_begin), b = 1 / (d.v_end - d.v_begin);
  Compiled::Jet jet = compiled.patch(i).jet((u - d.u_begin) * a, (v - d.v_begin) * b);
  jet.du = a * jet.du;
  jet.dv = b * jet.dv;
  jet.duu = a * a * jet.duu;
  jet.duv = a * b * jet.duv;
  jet.dvv = b * b * jet.dvv;
  return jet;
}

} // namespace

TEST_CASE("the patches are the surface, but for the caps", "[compile_T_spline]")
{
  CGAL::Random random(1);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 20, random);
    const Mesh::Surface spline = t.surface();
    const Compiled compiled = compile_T_spline(spline);
    Jet_difference worst;
    double cap = 0, normal = 0;
    for (std::size_t i = 0; i < compiled.number_of_patches(); ++i)
      for (int k = 0; k < 5; ++k) {
        const Domain d = compiled.domain(i);
        const double u = d.u_begin + (d.u_end - d.u_begin) * random.get_double(0.01, 0.99),
                     v = d.v_begin + (d.v_end - d.v_begin) * random.get_double(0.01, 0.99);
        REQUIRE(compiled.patch_at(d.face, u, v) == i);
        const auto a = spline.jet(d.face, u, v), b = compiled.jet(d.face, u, v);
        const auto c = compiled.position_and_normal(d.face, u, v);
        CHECK(length(c.first - b.position) < 1e-14);
        CHECK(length(c.first - compiled.position(d.face, u, v)) < 1e-14);
        if (d.is_cap)
          cap = (std::max)(cap, length(a.position - b.position));
        else {
          worst.add(difference(a, b, size_of(spline, d.face)));
          if (length(a.normal()) > 1e-3 * length(a.du) * length(a.dv))
            normal = (std::max)(normal, length(c.second - a.unit_normal()));
        }
      }
    CHECK(worst.position < 1e-13);
    CHECK(worst.first < 1e-11);
    CHECK(worst.second < 1e-10);
    CHECK(normal < 1e-9);
    CHECK(cap <= compiled.cap_deviation() * 1.25); // which is sampled
    CHECK((compiled.number_of_rings() == 0) == (compiled.cap_deviation() == 0));
  }
}

TEST_CASE("the domains of patches tile each face", "[compile_T_spline]")
{
  CGAL::Random random(2);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 20, random);
    const Mesh::Surface spline = t.surface();
    const Compiled compiled = compile_T_spline(spline);
    std::map<Face, double> area;
    for (std::size_t i = 0; i < compiled.number_of_patches(); ++i) {
      const Domain d = compiled.domain(i);
      CHECK((d.u_begin >= -1e-15 && d.u_begin < d.u_end && d.u_end <= compiled.width(d.face) * (1 + 1e-14)));
      CHECK((d.v_begin >= -1e-15 && d.v_begin < d.v_end && d.v_end <= compiled.height(d.face) * (1 + 1e-14)));
      CHECK((!d.is_cap || spline.is_at_extraordinary_vertex(d.face)));
      area[d.face] += (d.u_end - d.u_begin) * (d.v_end - d.v_begin);
    }
    CHECK(area.size() == num_faces(t.mesh));
    for (const auto& a : area)
      CHECK(a.second == Approx(compiled.width(a.first) * compiled.height(a.first)).epsilon(1e-12));
  }
}

TEST_CASE("at knot lines inside faces the patches and the surface are C2", "[compile_T_spline]")
{
  CGAL::Random random(3);
  int lines = 0;
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 20, random);
    const Mesh::Surface spline = t.surface();
    const Compiled compiled = compile_T_spline(spline);
    Jet_difference of_patches, of_surface;
    for (std::size_t i = 0; i < compiled.number_of_patches(); ++i) {
      const Domain d = compiled.domain(i);
      if (d.is_cap || spline.is_at_extraordinary_vertex(d.face))
        continue;
      for (const bool is_right : {true, false}) {
        const double u = is_right ? d.u_end : random.get_double(d.u_begin, d.u_end),
                     v = is_right ? random.get_double(d.v_begin, d.v_end) : d.v_end;
        const double after_u = is_right ? u + 1e-9 * spline.width(d.face) : u,
                     after_v = is_right ? v : v + 1e-9 * spline.height(d.face);
        if (after_u >= spline.width(d.face) || after_v >= spline.height(d.face))
          continue;
        ++lines;
        const std::size_t j = compiled.patch_at(d.face, after_u, after_v);
        REQUIRE(j != i);
        const double size = size_of(spline, d.face);
        of_patches.add(difference(patch_jet(compiled, i, u, v), patch_jet(compiled, j, u, v), size));
        // Just before and behind the line, other pieces of the basis functions are used.
        const double e = 1e-14;
        of_surface.add(difference(spline.jet(d.face, is_right ? u * (1 - e) : u, is_right ? v : v * (1 - e)),
                                  spline.jet(d.face, is_right ? u * (1 + e) : u, is_right ? v : v * (1 + e)), size));
      }
    }
    CHECK(of_patches.position < 1e-13);
    CHECK(of_patches.first < 1e-11);
    CHECK(of_patches.second < 1e-10);
    CHECK(of_surface.position < 1e-12);
    CHECK(of_surface.first < 1e-11);
    CHECK(of_surface.second < 1e-10);
  }
  CHECK(lines > 100);
}

TEST_CASE("there are no cracks between patches, caps included", "[compile_T_spline]")
{
  CGAL::Random random(4);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 20, random);
    const Mesh::Surface spline = t.surface();
    const Compiled compiled = compile_T_spline(spline, parameters::number_of_rings(2));
    // Across the edges of the T-mesh: position, and between others than caps derivatives as well.
    double worst = 0;
    const auto pieces = edge_pieces<double>(t);
    for (const auto& piece : pieces)
      for (int k = 0; k <= 16; ++k) {
        const auto p = inside(spline, piece.face, piece.at(k == 16 ? 1 : (k + random.get_double()) / 17));
        const auto q = inside(spline, piece.opposite_face, piece.transition(p.first, p.second));
        worst = (std::max)(worst, length(compiled.position(piece.face, p.first, p.second) -
                                         compiled.position(piece.opposite_face, q.first, q.second)));
      }
    CHECK(worst < 1e-12);

    // Between a cap and the patches next to it in its face: position, and the first derivatives too.
    Jet_difference at_caps;
    int caps = 0;
    for (std::size_t i = 0; i < compiled.number_of_patches(); ++i) {
      const Domain d = compiled.domain(i);
      if (!d.is_cap)
        continue;
      ++caps;
      for (int side = 0; side < 4; ++side)
        for (int k = 0; k <= 8; ++k) {
          const double x = k / 8., u_size = d.u_end - d.u_begin, v_size = d.v_end - d.v_begin;
          const double u = side == 0   ? d.u_begin
                           : side == 1 ? d.u_end
                                       : d.u_begin + x * u_size,
                       v = side == 2   ? d.v_begin
                           : side == 3 ? d.v_end
                                       : d.v_begin + x * v_size;
          const double e = 1e-6,
                       out_u = u + (side == 0   ? -e
                                    : side == 1 ? e
                                                : 0) *
                                       u_size,
                       out_v = v + (side == 2   ? -e
                                    : side == 3 ? e
                                                : 0) *
                                       v_size;
          if (out_u < 0 || out_v < 0 || out_u > compiled.width(d.face) || out_v > compiled.height(d.face))
            continue; // a border of the face
          const std::size_t j = compiled.patch_at(d.face, out_u, out_v);
          REQUIRE(j != i);
          Jet_difference difference = spline_tests::difference(patch_jet(compiled, i, u, v),
                                                               patch_jet(compiled, j, u, v), size_of(spline, d.face));
          difference.second = 0; // it is C1
          at_caps.add(difference);
        }
    }
    CHECK(at_caps.position < 1e-13);
    CHECK(at_caps.first < 1e-12);
    CHECK((caps > 0) == (compiled.cap_deviation() > 0));
  }
}

TEST_CASE("more rings make better caps", "[compile_T_spline]")
{
  CGAL::Random random(5);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 0, random);
    const Mesh::Surface spline = t.surface();
    double previous = 0;
    for (const int rings : {1, 4, 8, 12}) {
      const Compiled compiled = compile_T_spline(spline, parameters::number_of_rings(rings));
      if (compiled.number_of_rings() == 0)
        break; // no extraordinary vertices
      CHECK(compiled.number_of_rings() == rings);
      CHECK(compiled.cap_deviation() > 0);
      if (rings > 1)
        CHECK(compiled.cap_deviation() < previous / 1.5 + 1e-14);
      previous = compiled.cap_deviation();
      double largest = 0;
      for (std::size_t i = 0; i < compiled.number_of_patches(); ++i) {
        const Domain d = compiled.domain(i);
        for (int k = 0; k < 30 && d.is_cap; ++k) {
          const double u = random.get_double(d.u_begin, d.u_end), v = random.get_double(d.v_begin, d.v_end);
          largest = (std::max)(largest, length(compiled.position(d.face, u, v) - spline.position(d.face, u, v)));
        }
      }
      CHECK(largest <= compiled.cap_deviation() * 1.25 + 1e-14);
      CHECK(largest >= compiled.cap_deviation() / 4 - 1e-14);
    }
  }
}

TEST_CASE("ranges of places give what single places give", "[compile_T_spline]")
{
  CGAL::Random random(6);
  Mesh t(torus_with_two_cones<Rational>());
  prepare(t, 10, random);
  const Mesh::Surface spline = t.surface();
  const Compiled compiled = compile_T_spline(spline);
  CHECK(&compiled.graph() == &t.mesh);
  std::vector<Compiled::Place> places;
  for (const auto f : faces(t.mesh))
    for (int k = 0; k < 3; ++k)
      places.push_back({f, compiled.width(f) * random.get_double(), compiled.height(f) * random.get_double()});
  std::vector<std::pair<Point_3, Vector_3>> points_and_normals;
  std::vector<Point_3> points;
  compiled.positions_and_normals(places, std::back_inserter(points_and_normals));
  compiled.positions(places, std::back_inserter(points));
  REQUIRE(points.size() == places.size());
  REQUIRE(points_and_normals.size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(points[i] == compiled.position(places[i].face, places[i].u, places[i].v));
    CHECK(points_and_normals[i].second == compiled.unit_normal(places[i].face, places[i].u, places[i].v));
    CHECK(length(points_and_normals[i].second) == Approx(1));
  }
}

TEST_CASE("with an exact kernel the patches are exactly the surface", "[compile_T_spline]")
{
  CGAL::Random random(7);
  Spline_mesh<Rational, Exact_kernel> t(torus_with_two_cones<Rational>());
  t.make_spline_compatible();
  t.split_randomly(5, random);
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  const auto spline = t.surface();
  const auto compiled = compile_T_spline(spline, parameters::number_of_rings(2));
  int patches = 0;
  for (std::size_t i = 0; i < compiled.number_of_patches(); ++i) {
    const auto d = compiled.domain(i);
    if (d.is_cap)
      continue;
    ++patches;
    const Rational u = d.u_begin + (d.u_end - d.u_begin) * random.get_int(0, 16) / 16,
                   v = d.v_begin + (d.v_end - d.v_begin) * random.get_int(0, 16) / 16;
    if (compiled.domain(compiled.patch_at(d.face, u, v)).is_cap)
      continue; // on its rim
    const auto a = spline.jet(d.face, u, v), b = compiled.jet(d.face, u, v);
    CHECK(difference(a, b, 1.).largest() == 0);
  }
  CHECK(patches > 50);
}

} // namespace compile_T_spline_test
