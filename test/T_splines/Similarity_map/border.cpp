// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "open_meshes.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <boost/math/special_functions/ellint_1.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace border_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;
using Signature = T::Holonomy_signature<Mesh>;
using Halfedge = Mesh::Halfedge_index;

// A map, refused by the test if anything that holds for all maps does not hold for it.
struct Mapped {
  Mesh refined;
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv;

  Mapped(const Mesh& mesh, const Signature& signature)
  {
    uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
    const auto report = T::compute_seamless_similarity_map(mesh, signature, refined, uv);
    INFO(describe(report, mesh));
    REQUIRE(report);
    CHECK(report.residual <= 1e-12);
    REQUIRE(refined.number_of_vertices() >= mesh.number_of_vertices());
    for (const Vertex v : mesh.vertices()) {
      CHECK(refined.point(v) == mesh.point(v));
      CHECK(refined.is_border(v) == mesh.is_border(v));
    }
    for (const Halfedge h : refined.halfedges())
      if (!refined.is_border(h) && refined.is_border(refined.opposite(h)))
        CHECK(std::min(std::abs(side(h).x()), std::abs(side(h).y())) <= 1e-12 * length(h));
    for (const auto f : refined.faces()) {
      const Halfedge h = refined.halfedge(f);
      CHECK(CGAL::orientation(uv[h], uv[refined.next(h)], uv[refined.prev(h)]) == CGAL::LEFT_TURN);
    }
    check_angles(mesh, signature);
    T::Seamless_map<Mesh> map(refined);
    const auto exact = T::make_exactly_seamless(refined, uv, map);
    INFO(describe(exact, refined));
    CHECK(exact);
    for (const Halfedge h : refined.halfedges()) // exactly on isolines
      if (!refined.is_border(h) && refined.is_border(refined.opposite(h))) {
        const auto p = map.uv(refined.prev(h)), q = map.uv(h);
        CHECK((p.first == q.first || p.second == q.second));
      }
  }

  Kernel::Vector_2 side(const Halfedge h) const { return uv[h] - uv[refined.prev(h)]; }
  double length(const Halfedge h) const { return std::sqrt(side(h).squared_length()); }

  // The lengths of the sides between corners, along the border from the first corner.
  std::vector<double> sides(const std::vector<Vertex>& corners) const
  {
    std::vector<double> result;
    for (const Vertex corner : corners) {
      double sum = 0;
      Vertex v = corner;
      do {
        for (const Halfedge h : refined.halfedges_around_target(refined.halfedge(v)))
          if (refined.is_border(h)) { // against the direction in which the surface is on the left
            v = refined.source(h);
            sum += length(refined.opposite(h));
            break;
          }
      } while (v != corner && std::find(corners.begin(), corners.end(), v) == corners.end());
      result.push_back(sum);
    }
    return result;
  }

private:
  void check_angles(const Mesh& mesh, const Signature& signature) const
  {
    std::vector<double> angle(refined.number_of_vertices(), 0.);
    for (const Halfedge h : refined.halfedges()) {
      if (refined.is_border(h))
        continue;
      const Kernel::Vector_2 a = side(refined.next(h)), b = -side(h);
      angle[refined.target(h)] += std::atan2(a.x() * b.y() - a.y() * b.x(), a * b);
    }
    double worst = 0;
    for (const Vertex v : refined.vertices()) {
      const bool is_of_mesh = v.idx() < mesh.number_of_vertices();
      const int k = refined.is_border(v) ? (is_of_mesh ? signature.corner_quarter_turns(v) : 2)
                                         : (is_of_mesh ? signature.quarter_turns(v) : 4);
      worst = std::max(worst, std::abs(angle[v] - k * CGAL_PI / 2));
    }
    CHECK(worst < 1e-9);
  }
};

Signature guided(Mesh& mesh)
{
  Signature signature;
  const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  const auto matching = mesh.add_property_map<Halfedge, int>("h:matching").first;
  const auto np = T::parameters::halfedge_matching_map(matching);
  REQUIRE(T::compute_smooth_cross_field(mesh, field, np));
  REQUIRE(T::holonomy_signature_of_cross_field(mesh, field, signature, np));
  return signature;
}

Vertex vertex_at(const Mesh& mesh, const double x, const double y)
{
  for (const Vertex v : mesh.vertices())
    if (std::hypot(mesh.point(v).x() - x, mesh.point(v).y() - y) < 1e-9)
      return v;
  return Vertex();
}

// The map of the disk to a rectangle whose corners are at the angles +-alpha and pi +- alpha: the ratio of its sides.
double ratio_of_disk(const int rings, const int corner)
{
  Mesh mesh = disk(rings);
  const double alpha = 2 * CGAL_PI * corner / (6 * rings);
  std::vector<Signature::Corner> corners;
  std::vector<Vertex> vertices;
  for (const double angle : {-alpha, alpha, CGAL_PI - alpha, CGAL_PI + alpha}) {
    vertices.push_back(vertex_at(mesh, std::cos(angle), std::sin(angle)));
    REQUIRE(mesh.is_valid(vertices.back()));
    corners.emplace_back(vertices.back(), 1);
  }
  Signature signature;
  const std::vector<std::pair<Vertex, int>> no_cones;
  REQUIRE(
      T::holonomy_signature_of_cones(mesh, no_cones, signature, T::parameters::corners(std::make_optional(corners))));
  const std::vector<double> sides = Mapped(mesh, signature).sides(vertices);
  CHECK(sides[0] == Approx(sides[2]).epsilon(1e-10));
  CHECK(sides[1] == Approx(sides[3]).epsilon(1e-10));
  return sides[0] / sides[1];
}

} // namespace

TEST_CASE("a plate is its own map", "[border]")
{
  Mesh mesh = plate(14, 5);
  const Signature signature = guided(mesh);
  const Mapped mapped(mesh, signature);
  const std::vector<double> sides =
      mapped.sides({vertex_at(mesh, 0, 0), vertex_at(mesh, 14, 0), vertex_at(mesh, 14, 5), vertex_at(mesh, 0, 5)});
  CHECK(sides[0] / sides[1] == Approx(14. / 5).epsilon(1e-12));
  CHECK(sides[2] == Approx(sides[0]).epsilon(1e-12));
}

TEST_CASE("the modulus of a quadrilateral in the disk is a quotient of elliptic integrals", "[border]")
{
  const double alpha = CGAL_PI / 6, k = std::pow(std::tan(alpha / 2), 2);
  const double expected = 2 * boost::math::ellint_1(k) / boost::math::ellint_1(std::sqrt(1 - k * k));
  const double coarse = std::abs(ratio_of_disk(8, 4) / expected - 1),
               fine = std::abs(ratio_of_disk(32, 16) / expected - 1);
  INFO(coarse << " " << fine);
  CHECK(fine < 2e-3);
  CHECK(fine < coarse / 7); // of order 3/2, which the corners leave, where the border is straight
}

TEST_CASE("an annulus becomes a strip whose width is the logarithm of the ratio of its radii", "[border]")
{
  Mesh mesh = annulus(2.5, 96, 14);
  Signature signature = guided(mesh);
  REQUIRE(signature.arcs().size() == 1);
  const Mapped mapped(mesh, signature);
  const double inner = mapped.sides({vertex_at(mesh, 1, 0)})[0], outer = mapped.sides({vertex_at(mesh, 2.5, 0)})[0];
  CHECK(inner == Approx(outer).epsilon(1e-11)); // the scale factor is 1
  double area = 0;
  for (const auto f : mapped.refined.faces()) {
    const Halfedge h = mapped.refined.halfedge(f);
    area += CGAL::area(mapped.uv[h], mapped.uv[mapped.refined.next(h)], mapped.uv[mapped.refined.prev(h)]);
  }
  CHECK(area / (inner * outer) == Approx(std::log(2.5) / (2 * CGAL_PI)).epsilon(1e-3));
}

TEST_CASE("an annulus whose crosses turn on the way across has a scale factor", "[border]")
{
  Mesh mesh = annulus(2.5, 96, 14);
  Signature signature = guided(mesh);
  signature.set_arc_quarter_turns(0, 1);
  const Mapped mapped(mesh, signature);
  // One of its curves is a straight line, from which to the other, orthogonal line it is a quarter turn.
  const double inner = mapped.sides({vertex_at(mesh, 1, 0)})[0], outer = mapped.sides({vertex_at(mesh, 2.5, 0)})[0];
  CHECK(inner > 0);
  CHECK(outer > 0);
}

TEST_CASE("corners that turn inwards, holes, and cones beside them", "[border]")
{
  Mesh l = l_shape(10), plate = perforated_plate(3, 4), round = disk(12);
  for (Mesh* const mesh : {&l, &plate, &round}) {
    const Signature signature = guided(*mesh);
    const Mapped mapped(*mesh, signature);
    CHECK(mapped.refined.number_of_faces() >= mesh->number_of_faces());
  }
}

TEST_CASE("the reflected mesh has the reflected map", "[border]")
{
  Mesh mesh = disk(10);
  const Signature signature = guided(mesh);
  Mesh reflected = mesh;
  for (const Vertex v : reflected.vertices())
    reflected.point(v) = Point_3(-mesh.point(v).x(), mesh.point(v).y(), 0);
  CGAL::Polygon_mesh_processing::reverse_face_orientations(reflected);
  Signature same_numbers;
  for (const auto& cone : signature.cones())
    same_numbers.set_quarter_turns(cone.first, cone.second);
  for (const auto& corner : signature.corners())
    same_numbers.set_corner_quarter_turns(corner.first, corner.second);
  const Mapped one(mesh, signature), other(reflected, same_numbers);
  // Lengths up to a common factor, per edge of the border, by its vertices.
  const auto lengths = [](const Mapped& mapped) {
    std::map<std::pair<Vertex, Vertex>, double> result;
    double total = 0;
    for (const Halfedge h : mapped.refined.halfedges())
      if (!mapped.refined.is_border(h) && mapped.refined.is_border(mapped.refined.opposite(h))) {
        const Vertex v = mapped.refined.source(h), w = mapped.refined.target(h);
        result[{std::min(v, w), std::max(v, w)}] = mapped.length(h);
        total += mapped.length(h);
      }
    for (auto& entry : result)
      entry.second /= total;
    return result;
  };
  const auto a = lengths(one), b = lengths(other);
  REQUIRE(a.size() == b.size());
  for (const auto& [edge, length] : a) {
    REQUIRE(b.count(edge) == 1);
    CHECK(b.at(edge) == Approx(length).epsilon(1e-11));
  }
}

} // namespace border_test
