// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include <CGAL/T_splines/IO/read_t_mesh.h>

#include "Spline/Planar_t_mesh.h"
#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <CGAL/Aff_transformation_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace T_spline_surface_test {

namespace {

using namespace spline_tests;
using CGAL::T_splines::Basis_function_jet;
using CGAL::T_splines::Similarity_2;
using Mesh = Spline_mesh<Rational>;
using Exact_mesh = Spline_mesh<Rational, Exact_kernel>;
using Face = Mesh::face_descriptor;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

// Refined at random, spline compatible, with random control points.
template <typename Mesh>
void prepare(Mesh& t, const int splits, CGAL::Random& random)
{
  if (splits > 0) {
    t.make_spline_compatible();
    t.split_randomly(splits, random);
  }
  const auto report = t.make_spline_compatible();
  INFO(message(report.status));
  REQUIRE(report);
  t.set_random_controls(random);
}

struct Place {
  Face face;
  double u, v;
};

template <typename Surface>
std::vector<Place> random_places(const Surface& surface, const int number, CGAL::Random& random)
{
  const auto range = faces(surface.graph());
  const std::vector<Face> list(range.begin(), range.end());
  std::vector<Place> result;
  for (int i = 0; i < number; ++i) {
    const Face f = list[random.get_int(0, static_cast<int>(list.size()))];
    result.push_back({f, surface.width(f) * random.get_double(), surface.height(f) * random.get_double()});
  }
  return result;
}

// Of a face, its faces' corners at extraordinary vertices: per vertex, the places of the corner in all sectors.
template <typename Mesh>
std::map<typename Mesh::vertex_descriptor, std::vector<Place>> places_at_extraordinary_vertices(Mesh& t)
{
  const CGAL::T_splines::T_mesh_coordinates coordinates(t);
  std::map<typename Mesh::vertex_descriptor, std::vector<Place>> result;
  for (const auto v : vertices(t.mesh)) {
    if (CGAL::T_splines::is_border_vertex(v, t) || !CGAL::T_splines::is_extraordinary(v, t))
      continue;
    for (const auto h : CGAL::halfedges_around_target(halfedge(v, t.mesh), t.mesh)) {
      const auto p = converted<double>(coordinates.target_point(h));
      result[v].push_back({face(h, t.mesh), p.first, p.second});
    }
  }
  return result;
}

template <typename Surface>
std::vector<Basis_function_jet<Surface_mesh, typename Surface::FT>> basis_functions(const Surface& surface,
                                                                                    const Place& place)
{
  std::vector<Basis_function_jet<Surface_mesh, typename Surface::FT>> result;
  surface.basis_functions(place.face, place.u, place.v, std::back_inserter(result));
  return result;
}

template <typename Functions>
double sum(const Functions& functions)
{
  return std::accumulate(functions.begin(), functions.end(), 0.,
                         [](const double x, const auto& f) { return x + f.value; });
}

} // namespace

TEST_CASE("the surface is C2 where faces meet", "[T_spline_surface]")
{
  CGAL::Random random(1);
  auto surfaces = closed_surfaces<Rational>();
  surfaces.emplace_back("rectangle", test_t_meshes::rectangle<Rational>(5, 4));
  for (const auto& surface : surfaces_with_winding_supports<Rational>())
    surfaces.push_back(surface);
  for (const auto& surface : surfaces)
    for (const int splits : {0, 6, 25}) {
      INFO(surface.first << ", " << splits << " splits");
      Mesh t(surface.second);
      prepare(t, splits, random);
      const Mesh::Surface spline = t.surface();
      REQUIRE(spline.is_valid());
      const auto pieces = edge_pieces<double>(t);
      const Continuity c = continuity(spline, pieces, 10000, random);
      CHECK(c.position < 1e-12);
      CHECK(c.first < 1e-10);
      CHECK(c.second < 1e-9);
      if (splits > 0)
        CHECK(c.at_t_joints > 500);
      CHECK((c.scaled > 500 || surface.second.size() == 1)); // one face, and no holonomy that scales
    }
}

TEST_CASE("the surface of a T-mesh from a file is C2 where faces meet", "[T_spline_surface]")
{
  CGAL::Random random(2);
  for (const std::string name : {"border", "cube", "scaled_torus", "t_joints", "torus_of_one_face"}) {
    INFO(name);
    Spline_mesh<double> t(Faces<double>{});
    REQUIRE(CGAL::T_splines::read_t_mesh(T_SPLINES_TEST_DATA "/good_t_meshes/" + name + ".ply", t).success());
    prepare(t, 0, random);
    const auto spline = t.surface();
    REQUIRE(spline.is_valid());
    const Continuity c = continuity(spline, edge_pieces<double>(t), 10000, random);
    CHECK(c.position < 1e-12);
    CHECK(c.first < 1e-10);
    CHECK(c.second < 1e-9);
    if (name == "scaled_torus")
      CHECK((c.scaled > 500 && c.turned > 500));
  }
}

TEST_CASE("knot intervals may differ by ten orders of magnitude", "[T_spline_surface]")
{
  CGAL::Random random(10);
  const double narrow = std::ldexp(1., -33);
  for (const int splits : {0, 20}) {
    Planar_t_mesh plane({0, 1, 2, 3, 3 + narrow, 4, 5, 6, 7}, {0, 1, 2, 2 + narrow, 3, 8, 9, 10}, true);
    plane.split_randomly(splits, random);
    Spline_mesh<double> t(plane.faces<double>());
    prepare(t, 0, random);
    const auto spline = t.surface();
    REQUIRE(spline.is_valid());
    const Continuity c = continuity(spline, edge_pieces<double>(t), 10000, random);
    CHECK(c.position < 1e-12);
    CHECK(c.first < 1e-12);
  }
}

TEST_CASE("the tangent plane is continuous at extraordinary vertices", "[T_spline_surface]")
{
  CGAL::Random random(3);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 10, random);
    const Mesh::Surface spline = t.surface();
    for (const auto& vertex : places_at_extraordinary_vertices(t)) {
      const std::vector<Place>& places = vertex.second;
      INFO("valence " << places.size());
      const Point_3 p = spline.position(places[0].face, places[0].u, places[0].v);
      const Vector_3 n = spline.unit_normal(places[0].face, places[0].u, places[0].v);
      const bool has_tangent_plane = places.size() >= 3;
      if (has_tangent_plane)
        CHECK(length(n) == Approx(1));
      for (const Place& place : places) {
        CHECK(spline.is_at_extraordinary_vertex(place.face));
        CHECK(length(spline.position(place.face, place.u, place.v) - p) < 1e-14);
        if (!has_tangent_plane)
          continue;
        CHECK(length(spline.unit_normal(place.face, place.u, place.v) - n) < 1e-12);
        // Towards the vertex, normals differ by powers of the ratio of the third eigenvalue to the second one.
        double previous = 0;
        const double a = random.get_double(0.2, 1), b = random.get_double(0.2, 1);
        for (const int k : {20, 40}) {
          const double x = std::ldexp(a, -k), y = std::ldexp(b, -k);
          const double w = spline.width(place.face), h = spline.height(place.face);
          const double u = place.u == 0 ? w * x : w * (1 - x), v = place.v == 0 ? h * y : h * (1 - y);
          CHECK(length(spline.position(place.face, u, v) - p) < std::pow(0.8, k));
          const double distance = length(spline.unit_normal(place.face, u, v) - n);
          if (k == 40)
            CHECK(distance < previous / 3 + 1e-9);
          previous = distance;
        }
      }
    }
  }
}

TEST_CASE("the surface does not depend on orders and frames", "[T_spline_surface]")
{
  CGAL::Random random(4);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 15, random);
    const Mesh::Surface spline = t.surface();
    const Faces<Rational> original = faces_of(t);
    const std::vector<Face> list(faces(t.mesh).begin(), faces(t.mesh).end());
    const int number = static_cast<int>(original.size());

    // Face i becomes number order[i], begins with its halfedge number shift[i], and has another unit.
    std::vector<int> order(number), shift(number);
    std::iota(order.begin(), order.end(), 0);
    Faces<Rational> changed(number);
    const int number_of_edges = static_cast<int>(num_edges(t.mesh));
    for (int i = 0; i < number; ++i)
      std::swap(order[i], order[random.get_int(i, number)]);
    for (int i = 0; i < number; ++i) {
      const int size = static_cast<int>(original[i].size());
      shift[i] = random.get_int(0, size);
      for (int k = 0; k < size; ++k) {
        auto h = original[i][(shift[i] + k) % size];
        h.edge = number_of_edges - h.edge;
        changed[order[i]].push_back(h);
      }
      test_t_meshes::rescale(changed[order[i]], Rational(Rational(random.get_int(1, 1000)) / 7));
    }
    Mesh other(changed);
    for (int i = 0; i < number; ++i) {
      const int size = static_cast<int>(original[i].size());
      auto h = halfedge(list[i], t.mesh);
      for (int k = 0; k < size; ++k, h = next(h, t.mesh)) {
        const auto v = target(other.halfedge_of(order[i], (k - shift[i] + size) % size), other.mesh);
        other.set_control(v, t.control(target(h, t.mesh)).point(), t.control(target(h, t.mesh)).weight());
      }
    }
    const Mesh::Surface other_spline = other.surface();
    REQUIRE(other_spline.is_valid());

    const CGAL::T_splines::T_mesh_coordinates coordinates(t);
    const CGAL::T_splines::T_mesh_coordinates other_coordinates(other);
    Jet_difference worst;
    for (int i = 0; i < number; ++i)
      for (int k = 0; k < 20; ++k) {
        const Face f = list[i], g = other.face_list[order[i]];
        const int size = static_cast<int>(original[i].size());
        const auto to = other.halfedge_of(order[i], (size - shift[i]) % size); // what halfedge(f) has become
        const int side = other_coordinates.side(to);
        const auto origin = other_coordinates.point(g, side, Rational(0));
        const auto similarity = converted<double>(Similarity_2<Rational>(
            side, other_coordinates.side_length(to) / coordinates.width(f), origin.first, origin.second));
        const double u = spline.width(f) * random.get_double(), v = spline.height(f) * random.get_double();
        const auto q = inside(other_spline, g, similarity(u, v));
        worst.add(difference(spline.jet(f, u, v), pulled_back(other_spline.jet(g, q.first, q.second), similarity),
                             (std::min)(spline.width(f), spline.height(f))));
      }
    CHECK(worst.position < 1e-12);
    CHECK(worst.first < 1e-11);
    CHECK(worst.second < 1e-10);
  }
}

TEST_CASE("affine maps commute with evaluation, and a factor of all weights changes nothing", "[T_spline_surface]")
{
  CGAL::Random random(5);
  Mesh t(torus_with_two_cones<Rational>());
  prepare(t, 15, random);
  Mesh::Surface spline = t.surface();
  const std::vector<Place> places = random_places(spline, 2000, random);
  std::vector<Mesh::Surface::Jet> before;
  spline.jets(places, std::back_inserter(before));
  REQUIRE(before.size() == places.size());
  const CGAL::Aff_transformation_3<Kernel> affine(0.5, 2, -1, 3, 0, -0.25, 1, -7, 1.5, 0.125, 0.5, 0.25);
  for (const auto v : vertices(t.mesh))
    t.set_control(v, affine(t.control(v).point()), 3 * t.control(v).weight());
  REQUIRE(spline.update_control_points());
  double worst = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto after = spline.jet(places[i].face, places[i].u, places[i].v);
    worst = (std::max)(worst, length(after.position - affine(before[i].position)));
    worst = (std::max)(worst, length(after.du - affine(before[i].du)) / (1 + length(after.du)));
    worst = (std::max)(worst, length(after.duv - affine(before[i].duv)) / (1 + length(after.duv)));
  }
  CHECK(worst < 1e-11);
}

TEST_CASE("basis functions are not negative, and their rational form sums to one", "[T_spline_surface]")
{
  CGAL::Random random(6);
  double smallest_sum = 1, largest_sum = 1;
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Mesh t(surface.second);
    prepare(t, 25, random);
    for (const auto v : vertices(t.mesh)) // a constant
      t.set_control(v, Point_3(1, -2, 3), 1);
    const Mesh::Surface spline = t.surface();
    for (const Place& place : random_places(spline, 3000, random)) {
      const auto functions = basis_functions(spline, place);
      double smallest = 0, du = 0, dvv = 0, largest_dvv = 0;
      std::map<Mesh::vertex_descriptor, int> count;
      for (const auto& f : functions) {
        smallest = (std::min)(smallest, f.value);
        du += f.du;
        dvv += f.dvv;
        largest_dvv = (std::max)(largest_dvv, std::abs(f.dvv));
        ++count[f.vertex];
      }
      CHECK(smallest >= (spline.is_at_extraordinary_vertex(place.face) ? -1e-15 : 0));
      CHECK(count.size() == functions.size());
      const double total = sum(functions);
      if (spline.is_at_extraordinary_vertex(place.face)) {
        CHECK(std::abs(total - 1) < 1e-13);
        CHECK(std::abs(dvv) < 1e-11 * largest_dvv);
      }
      smallest_sum = (std::min)(smallest_sum, total);
      largest_sum = (std::max)(largest_sum, total);
      const auto jet = spline.jet(place.face, place.u, place.v);
      CHECK(length(jet.position - Point_3(1, -2, 3)) < 1e-14);
      CHECK(length(jet.du) <= 1e-12 * (1 + std::abs(du)) / spline.width(place.face));
    }
  }
  CHECK(smallest_sum > 0.1);
  CHECK(largest_sum < 3);
}

TEST_CASE("derivatives of basis functions are those of the surface", "[T_spline_surface]")
{
  CGAL::Random random(7);
  Mesh t(torus_with_two_cones<Rational>());
  prepare(t, 15, random);
  for (const auto v : vertices(t.mesh)) // without weights the first homogeneous coordinate is a polynomial over the sum
    t.set_control(v, t.control(v).point(), 1);
  const Mesh::Surface spline = t.surface();
  Jet_difference worst;
  for (const Place& place : random_places(spline, 1000, random)) {
    std::array<std::array<double, 4>, 6> h{};
    for (const auto& f : basis_functions(spline, place)) {
      const auto& p = t.control(f.vertex);
      const std::array<double, 6> values{f.value, f.du, f.dv, f.duu, f.duv, f.dvv};
      for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 4; ++k)
          h[i][k] += values[i] * (k == 0 ? p.x() : k == 1 ? p.y() : k == 2 ? p.z() : 1);
    }
    // Differentiates w p = h.
    const auto part = [&](const int i) { return Vector_3(h[i][0], h[i][1], h[i][2]); };
    const auto jet = spline.jet(place.face, place.u, place.v);
    auto expected = jet;
    const double w = h[0][3];
    const Vector_3 p = part(0) / w;
    expected.position = CGAL::ORIGIN + p;
    expected.du = (part(1) - h[1][3] * p) / w;
    expected.dv = (part(2) - h[2][3] * p) / w;
    expected.duu = (part(3) - 2 * h[1][3] * expected.du - h[3][3] * p) / w;
    expected.duv = (part(4) - h[1][3] * expected.dv - h[2][3] * expected.du - h[4][3] * p) / w;
    expected.dvv = (part(5) - 2 * h[2][3] * expected.dv - h[5][3] * p) / w;
    worst.add(difference(jet, expected, (std::min)(spline.width(place.face), spline.height(place.face))));
  }
  CHECK(worst.largest() < 1e-10);
}

TEST_CASE("derivatives are limits of difference quotients", "[T_spline_surface]")
{
  CGAL::Random random(8);
  Exact_mesh t(torus_with_two_cones<Rational>());
  prepare(t, 5, random);
  const Exact_mesh::Surface spline = t.surface();
  int cones = 0;
  for (int i = 0; i < 40; ++i) {
    const auto f = *(faces(t.mesh).begin() + random.get_int(0, static_cast<int>(num_faces(t.mesh))));
    const Rational w = spline.width(f), h = Rational(1) / 1000000000 / 1000000000 / 1000000000;
    const Rational u = w * Rational(random.get_int(1, 1000)) / 1001,
                   v = spline.height(f) * Rational(random.get_int(1, 1000)) / 1001;
    cones += spline.is_at_extraordinary_vertex(f);
    const auto jet = spline.jet(f, u, v), du = spline.jet(f, u + h, v), dv = spline.jet(f, u, v + h);
    CHECK(length((du.position - jet.position) / h - jet.du) < 1e-15);
    CHECK(length((dv.position - jet.position) / h - jet.dv) < 1e-15);
    CHECK(length((du.du - jet.du) / h - jet.duu) < 1e-15);
    CHECK(length((dv.du - jet.du) / h - jet.duv) < 1e-15);
    CHECK(length((du.dv - jet.dv) / h - jet.duv) < 1e-15);
    CHECK(length((dv.dv - jet.dv) / h - jet.dvv) < 1e-15);
  }
  CHECK(cones > 0);
}

TEST_CASE("with an exact kernel both sides of an edge are equal", "[T_spline_surface]")
{
  CGAL::Random random(9);
  for (const auto& surface : closed_surfaces<Rational>()) {
    INFO(surface.first);
    Exact_mesh t(surface.second);
    prepare(t, 10, random);
    const Exact_mesh::Surface exact = t.surface();
    REQUIRE(exact.is_valid());
    const Continuity c = continuity(exact, edge_pieces<Rational>(t), 150, random);
    CHECK(c.largest() == 0);
    CHECK(c.at_t_joints > 0);

    const CGAL::T_splines::T_spline_surface<CGAL::T_splines::Const_T_mesh_view_of<Exact_mesh>, Exact_mesh::Control_map,
                                            Kernel>
        rounded(t, t.controls());
    REQUIRE(rounded.is_valid());
    const CGAL::Cartesian_converter<Exact_kernel, Kernel> to_double;
    Jet_difference worst;
    for (const auto f : faces(t.mesh)) {
      const int i = random.get_int(0, 65), j = random.get_int(0, 65);
      if (i == 0 && j == 0)
        continue;
      const auto a = exact.jet(f, exact.width(f) * Rational(i) / 64, exact.height(f) * Rational(j) / 64);
      const auto b = rounded.jet(f, rounded.width(f) * i / 64, rounded.height(f) * j / 64);
      const Mesh::Surface::Jet converted{to_double(a.position), to_double(a.du),  to_double(a.dv),
                                         to_double(a.duu),      to_double(a.duv), to_double(a.dvv)};
      if (length(converted.du) > 0) // else an extraordinary vertex
        worst.add(difference(converted, b, (std::min)(rounded.width(f), rounded.height(f))));
      else
        CHECK(length(converted.position - b.position) < 1e-14);
    }
    CHECK(worst.position < 1e-12);
    CHECK(worst.first < 1e-12);
    CHECK(worst.second < 1e-10);
  }
}

} // namespace T_spline_surface_test
