// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "open_meshes.h"

#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/math/special_functions/ellint_1.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <random>
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
  Mesh::Property_map<Halfedge, T::Similarity_2<double>> transition;

  Mapped(const Mesh& mesh, const Signature& signature)
  {
    uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
    transition = refined.add_property_map<Halfedge, T::Similarity_2<double>>("h:transition").first;
    const auto report = T::compute_seamless_similarity_map(mesh, signature, refined, uv,
                                                           T::parameters::halfedge_transition_map(transition));
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

  // The logarithm of the scale factor along the curve of the border through v, with the surface on the left.
  double log_scale_around(const Vertex v) const
  {
    double sum = 0;
    Halfedge start;
    for (const Halfedge h : refined.halfedges_around_target(refined.halfedge(v)))
      if (refined.is_border(refined.opposite(h)))
        start = h;
    Halfedge h = start;
    do { // around the target of h, clockwise, to the next halfedge of the border
      h = refined.next(h);
      while (!refined.is_border(refined.opposite(h))) {
        sum += std::log(transition[h].scale());
        h = refined.next(refined.opposite(h));
      }
    } while (h != start);
    return sum;
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

Signature with_corners(const Mesh& mesh, const std::vector<Vertex>& vertices)
{
  std::vector<Signature::Corner> corners;
  for (const Vertex v : vertices) {
    REQUIRE(mesh.is_valid(v));
    corners.emplace_back(v, 1);
  }
  Signature signature;
  const std::vector<std::pair<Vertex, int>> no_cones;
  REQUIRE(
      T::holonomy_signature_of_cones(mesh, no_cones, signature, T::parameters::corners(std::make_optional(corners))));
  return signature;
}

// The ratio of two sides of the map to a rectangle.
double ratio_of_sides(const Mesh& mesh, const std::vector<Vertex>& corners)
{
  const std::vector<double> sides = Mapped(mesh, with_corners(mesh, corners)).sides(corners);
  CHECK(sides[0] == Approx(sides[2]).epsilon(1e-10));
  CHECK(sides[1] == Approx(sides[3]).epsilon(1e-10));
  return sides[0] / sides[1];
}

// A quarter of an annulus, n cells around, finer towards one end.
double ratio_of_sector(const double outer, const int n)
{
  const auto graded = [](const double x) { return x * (1 + x) / 2; };
  const int m = n / 2;
  const auto point = [&](const int i, const int j) {
    const double angle = CGAL_PI / 2 * graded(double(i) / n), radius = std::pow(outer, graded(double(j) / m));
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  const Mesh mesh = grid(
      n, m, [](int, int) { return true; }, point);
  return ratio_of_sides( // the mesh is seen from below
      mesh, {vertex_at(mesh, 1, 0), vertex_at(mesh, 0, 1), vertex_at(mesh, 0, outer), vertex_at(mesh, outer, 0)});
}

// An L whose arms are n cells wide and, beside the square at the bend, 2 n cells long.
double ratio_of_bend(const int n)
{
  const Mesh mesh = grid(
      3 * n, 3 * n, [n](const int i, const int j) { return i < n || j < n; },
      [](const int i, const int j) { return Point_3(i, j, 0); });
  return ratio_of_sides(mesh, {vertex_at(mesh, 0, 3 * n), vertex_at(mesh, 3 * n, 0), vertex_at(mesh, 3 * n, n),
                               vertex_at(mesh, n, 3 * n)});
}

// The logarithm of the scale factor along the circles of an annulus across which the crosses turn once.
double log_scale_of_annulus(const double outer, const int n)
{
  Mesh mesh = annulus(outer, 6 * n, n);
  Signature signature = guided(mesh);
  signature.set_arc_quarter_turns(0, 1);
  const Mapped mapped(mesh, signature);
  const double along_inner = mapped.log_scale_around(vertex_at(mesh, 1, 0)),
               along_outer = mapped.log_scale_around(vertex_at(mesh, outer, 0));
  CHECK(along_inner == Approx(-along_outer).epsilon(1e-10)); // one the other way round
  return std::abs(along_inner);
}

// Two copies of a mesh, the second one turned over, sewn together along the border. Vertex v of the mesh is vertex v.
Mesh closed_double(const Mesh& mesh, std::vector<Vertex>& image)
{
  Mesh result;
  for (const Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  image.clear();
  for (const Vertex v : mesh.vertices())
    image.push_back(mesh.is_border(v) ? v : result.add_vertex(mesh.point(v)));
  for (const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Vertex a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
    result.add_face(a, b, c);
    result.add_face(image[b], image[a], image[c]);
  }
  return result;
}

// Adds two triangles to each curve of the border, one upon the other, so that each has one neighbour or two.
void add_ears(Mesh& mesh)
{
  std::vector<Halfedge> curves;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(curves));
  for (Halfedge h : curves)
    for (int i = 0; i < 2; ++i) {
      const Point_3 p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h));
      const Kernel::Vector_3 way = q - p, left(-way.y(), way.x(), 0);
      h = CGAL::Euler::add_vertex_and_face_to_border(mesh.prev(h), h, mesh);
      mesh.point(mesh.target(h)) = CGAL::midpoint(p, q) + left / 2;
      h = mesh.is_border(h) ? h : mesh.opposite(h);
    }
}

// The map of the disk to a rectangle whose corners are at the angles +-alpha and pi +- alpha: the ratio of its sides.
double ratio_of_disk(const int rings, const int corner)
{
  Mesh mesh = disk(rings);
  const double alpha = 2 * CGAL_PI * corner / (6 * rings);
  std::vector<Vertex> corners;
  for (const double angle : {-alpha, alpha, CGAL_PI - alpha, CGAL_PI + alpha})
    corners.push_back(vertex_at(mesh, std::cos(angle), std::sin(angle)));
  return ratio_of_sides(mesh, corners);
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

TEST_CASE("a rectangle is its own map, whatever its triangles are", "[border]")
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-0.35, 0.35);
  const int n = 12, m = 9;
  std::map<std::pair<int, int>, Point_3> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      points[{i, j}] = Point_3(i + (i % n == 0 ? 0 : any(random)), j + (j % m == 0 ? 0 : any(random)), 0);
  const Mesh mesh = grid(
      n, m, [](int, int) { return true; },
      [&](const int i, const int j) {
        return points.at({i, j});
      });
  const std::vector<Vertex> corners = {vertex_at(mesh, 0, 0), vertex_at(mesh, n, 0), vertex_at(mesh, n, m),
                                       vertex_at(mesh, 0, m)};
  CHECK(ratio_of_sides(mesh, corners) == Approx(double(n) / m).epsilon(1e-12));
  const Mapped mapped(mesh, with_corners(mesh, corners));
  double smallest = 1e10, largest = 0; // ratios of lengths
  for (const Halfedge h : mapped.refined.halfedges())
    if (!mapped.refined.is_border(h)) {
      const double on_mesh = std::sqrt(CGAL::squared_distance(mapped.refined.point(mapped.refined.source(h)),
                                                              mapped.refined.point(mapped.refined.target(h))));
      smallest = std::min(smallest, mapped.length(h) / on_mesh);
      largest = std::max(largest, mapped.length(h) / on_mesh);
    }
  CHECK(largest == Approx(smallest).epsilon(1e-11));
}

TEST_CASE("a quarter of an annulus becomes a rectangle whose sides are a logarithm and a quarter turn", "[border]")
{
  const double expected = (CGAL_PI / 2) / std::log(3.);
  const double coarse = std::abs(ratio_of_sector(3, 8) / expected - 1),
               fine = std::abs(ratio_of_sector(3, 32) / expected - 1);
  INFO(coarse << " " << fine);
  CHECK(fine < 1e-3);
  CHECK(fine < coarse / 14); // of order 2
}

TEST_CASE("an L becomes a rectangle: its bend counts for one square but for 2 ln 2 / pi", "[border]")
{
  // That is the bend of two half strips; arms of length 2 leave less than 1e-6 of a difference.
  const double expected = 5 - 2 * std::log(2.) / CGAL_PI;
  const double coarse = std::abs(ratio_of_bend(2) / expected - 1), fine = std::abs(ratio_of_bend(16) / expected - 1);
  INFO(coarse << " " << fine);
  CHECK(fine < 1e-3);
  CHECK(fine < coarse / 16); // of order 4/3 at least, which the corner that turns inwards leaves
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

TEST_CASE("an annulus whose crosses turn on the way across has a scale factor along its circles", "[border]")
{
  // In the logarithm of the place, z = x + i y with x from 0 to L, the derivative of the map is exp(i pi z / (2 L)): it turns
  // by a quarter from one circle to the other, and shrinks by exp(-pi^2 / L) around.
  const double expected = CGAL_PI * CGAL_PI / std::log(2.5);
  const double coarse = std::abs(log_scale_of_annulus(2.5, 6) / expected - 1),
               fine = std::abs(log_scale_of_annulus(2.5, 24) / expected - 1);
  INFO(coarse << " " << fine);
  CHECK(fine < 1e-3);
  CHECK(fine < coarse / 14); // of order 2
}

TEST_CASE("the double, taken as a closed mesh, has the same metric", "[border]")
{
  Mesh l = l_shape(8), round = disk(8);
  for (Mesh* const mesh : {&l, &round}) {
    const Signature signature = guided(*mesh);
    std::vector<Vertex> image;
    const Mesh closed = closed_double(*mesh, image);
    Signature of_closed;
    for (const auto& cone : signature.cones())
      for (const Vertex v : {cone.first, image[cone.first]})
        of_closed.set_quarter_turns(v, cone.second);
    for (const auto& corner : signature.corners())
      of_closed.set_quarter_turns(corner.first, 2 * corner.second);
    T::Similarity_metric<Mesh> metric, metric_of_closed;
    REQUIRE(T::compute_similarity_metric(*mesh, signature, metric));
    REQUIRE(T::compute_similarity_metric(closed, of_closed, metric_of_closed));
    for (const Vertex v : mesh->vertices())
      for (const Vertex w : {v, image[v]})
        CHECK(metric.log_scale(v) == Approx(metric_of_closed.log_scale(w)).margin(1e-11));
    CHECK(metric.number_of_faces() == metric_of_closed.number_of_faces());
  }
}

TEST_CASE("the metric of a mesh with border does not depend on other components", "[border]")
{
  Mesh mesh = perforated_plate(2, 3);
  for (const Vertex v : mesh.vertices())
    if (!mesh.is_border(v))
      mesh.point(v) = mesh.point(v) + Kernel::Vector_3(0, 0, 0.3 * std::sin(1. * v.idx()));
  const Signature signature = guided(mesh);
  T::Similarity_metric<Mesh> metric, of_both;
  REQUIRE(T::compute_similarity_metric(mesh, signature, metric));
  // A closed component comes first: a tetrahedron, each angle of which is two right angles.
  Mesh both;
  std::vector<Vertex> t;
  for (const Point_3& p : {Point_3(30, 0, 0), Point_3(31, 0, 0), Point_3(30, 1, 0), Point_3(30, 0, 2)})
    t.push_back(both.add_vertex(p));
  both.add_face(t[0], t[2], t[1]);
  both.add_face(t[0], t[1], t[3]);
  both.add_face(t[1], t[2], t[3]);
  both.add_face(t[2], t[0], t[3]);
  std::vector<Vertex> copy;
  std::vector<Halfedge> copy_of_halfedge(mesh.number_of_halfedges());
  for (const Vertex v : mesh.vertices())
    copy.push_back(both.add_vertex(mesh.point(v)));
  for (const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    both.add_face(copy[mesh.source(h)], copy[mesh.target(h)], copy[mesh.target(mesh.next(h))]);
  }
  for (const Halfedge h : mesh.halfedges())
    copy_of_halfedge[h] = both.halfedge(copy[mesh.source(h)], copy[mesh.target(h)]);
  Signature signature_of_both;
  for (const Vertex v : t)
    signature_of_both.set_quarter_turns(v, 2);
  for (const auto& cone : signature.cones())
    signature_of_both.set_quarter_turns(copy[cone.first], cone.second);
  for (const auto& corner : signature.corners())
    signature_of_both.set_corner_quarter_turns(copy[corner.first], corner.second);
  for (const auto& arc : signature.arcs()) {
    std::vector<Halfedge> halfedges;
    for (const Halfedge h : arc.halfedges)
      halfedges.push_back(copy_of_halfedge[h]);
    signature_of_both.add_arc(halfedges, arc.quarter_turns);
  }
  REQUIRE(T::compute_similarity_metric(both, signature_of_both, of_both));
  for (const Vertex v : mesh.vertices())
    CHECK(of_both.log_scale(copy[v]) == Approx(metric.log_scale(v) + of_both.log_scale(copy[0])).margin(1e-10));
}

TEST_CASE("flips at degeneracies meet the signature of a mesh with border", "[border]")
{
  Mesh ring = annulus(2.5, 30, 5), plate = perforated_plate(2, 3);
  for (Mesh* const mesh : {&ring, &plate}) {
    const Signature signature = guided(*mesh);
    for (const bool delaunay : {false, true}) {
      T::Similarity_metric<Mesh> metric;
      const auto report = T::compute_similarity_metric(*mesh, signature, metric,
                                                       T::parameters::flip_policy(T::Degeneracy_flips{delaunay}));
      CHECK(report);
      CHECK(report.residual <= 1e-12);
    }
  }
}

TEST_CASE("corners that turn inwards, holes, and cones beside them", "[border]")
{
  Mesh l = l_shape(10), plate = perforated_plate(3, 4), round = disk(12), with_ears = perforated_plate(2, 4);
  add_ears(with_ears);
  for (Mesh* const mesh : {&l, &plate, &round, &with_ears}) {
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
    CHECK(b.at(edge) == Approx(length).epsilon(1e-13));
  }
}

} // namespace border_test
