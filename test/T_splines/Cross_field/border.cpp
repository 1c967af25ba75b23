// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "open_meshes.h"

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Random.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace border_test {

namespace {

using namespace open_meshes;
namespace T = CGAL::T_splines;
using Signature = T::Holonomy_signature<Mesh>;
using Status = T::Holonomy_signature_status;

struct Guided {
  Signature signature;
  std::map<int, int> corners; // how many have each number

  explicit Guided(Mesh& mesh)
  {
    const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
    const auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
    const auto np = T::parameters::halfedge_matching_map(matching);
    REQUIRE(T::compute_smooth_cross_field(mesh, field, np));
    const auto report = T::holonomy_signature_of_cross_field(mesh, field, signature, np);
    INFO(describe(report, mesh));
    REQUIRE(report);
    CHECK(report.deviation < 1e-9);
    CHECK(T::check_holonomy_signature(mesh, signature));
    for (const auto& corner : signature.corners())
      ++corners[corner.second];
  }
};

} // namespace

TEST_CASE("a plate has four corners, an L five and one that turns inwards, and neither has cones", "[border]")
{
  Mesh plate = open_meshes::plate(12, 7), l_shape = open_meshes::l_shape(10);
  const Guided p(plate), l(l_shape);
  CHECK(p.corners == std::map<int, int>{{1, 4}});
  CHECK(p.signature.cones().empty());
  CHECK(l.corners == std::map<int, int>{{1, 5}, {3, 1}});
  CHECK(l.signature.cones().empty());
  for (const auto& corner : p.signature.corners())
    CHECK((plate.point(corner.first).x() == 0 || plate.point(corner.first).x() == 12));
}

TEST_CASE("how finely a border is divided, and its noise, do not make corners", "[border]")
{
  for (const int n : {6, 20, 60}) {
    Mesh plate = open_meshes::plate(2 * n, n);
    CGAL::Random random(n);
    if (n > 6) // zigzag on two sides, of a third of the edges
      for (const Vertex v : plate.vertices()) {
        const Point_3 p = plate.point(v);
        if (p.x() > 0 && p.x() < 2 * n && (p.y() == 0 || p.y() == n))
          plate.point(v) = Point_3(p.x(), p.y() + random.get_double(-0.3, 0.3), 0);
      }
    INFO(n);
    CHECK(Guided(plate).corners == std::map<int, int>{{1, 4}});
    Mesh disk = open_meshes::disk(n);
    const Guided round(disk);
    CHECK(round.corners.empty());
    CHECK(round.signature.cones().size() == 4);
  }
}

TEST_CASE("the curves of a border are joined by arcs, one less than there are", "[border]")
{
  Mesh plate = perforated_plate(3, 4);
  const Guided guided(plate);
  CHECK(guided.signature.loops().empty());
  CHECK(guided.signature.arcs().size() == 9);
  CHECK(guided.corners == std::map<int, int>{{1, 4}, {3, 36}});
  CHECK(guided.signature.cones().empty());
  for (const auto& arc : guided.signature.arcs()) // straight across or around a corner of a hole
    CHECK(std::abs(arc.quarter_turns) <= 1);

  Mesh ring = annulus(3, 40, 8);
  const Guided round(ring);
  REQUIRE(round.signature.arcs().size() == 1);
  CHECK(round.signature.arcs()[0].quarter_turns == 0);
  CHECK(round.corners.empty());
  CHECK(round.signature.cones().empty());
}

TEST_CASE("corners that are given are taken, and judged", "[border]")
{
  Mesh mesh = disk(8);
  std::vector<Vertex> border;
  for (const Vertex v : mesh.vertices())
    if (mesh.is_border(v))
      border.push_back(v);
  const std::vector<std::pair<Vertex, int>> no_cones;
  const auto signature_with = [&](const std::vector<std::pair<std::size_t, int>>& numbers, Signature& signature) {
    std::vector<Signature::Corner> corners;
    for (const auto& [i, k] : numbers)
      corners.emplace_back(border[i], k);
    return T::holonomy_signature_of_cones(mesh, no_cones, signature,
                                          T::parameters::corners(std::make_optional(corners)));
  };
  Signature signature;
  CHECK(signature_with({{0, 1}, {12, 1}, {24, 1}, {36, 1}}, signature));
  CHECK(signature.corners().size() == 4);
  CHECK(signature.corner_quarter_turns(border[12]) == 1);
  CHECK(signature.corner_quarter_turns(border[13]) == 2);
  const auto too_few = signature_with({{0, 1}, {12, 1}, {24, 1}}, signature);
  CHECK(too_few.status == Status::GAUSS_BONNET_VIOLATED);
  CHECK(too_few.expected == 4);
  CHECK(too_few.actual == 3);
  CHECK(signature_with({{0, 1}, {12, 1}, {24, 1}, {36, 1}, {6, 0}, {7, 4}}, signature).status ==
        Status::NON_POSITIVE_CONE);

  Signature wrong;
  wrong.set_quarter_turns(border[0], 3);
  CHECK(T::check_holonomy_signature(mesh, wrong).status == Status::CONE_ON_BORDER);
  wrong.clear();
  wrong.set_corner_quarter_turns(*mesh.vertices().begin(), 3);
  CHECK(T::check_holonomy_signature(mesh, wrong).status == Status::CORNER_INSIDE);
}

TEST_CASE("arcs must be strips that join all curves of the border", "[border]")
{
  Mesh mesh = perforated_plate(2, 3);
  Signature signature = Guided(mesh).signature;
  REQUIRE(signature.arcs().size() == 4);
  const auto status_with = [&](std::vector<Signature::Arc> arcs) {
    Signature changed;
    for (const auto& corner : signature.corners())
      changed.set_corner_quarter_turns(corner.first, corner.second);
    for (const auto& arc : arcs)
      changed.add_arc(arc.halfedges, arc.quarter_turns);
    return T::check_holonomy_signature(mesh, changed).status;
  };
  std::vector<Signature::Arc> arcs = signature.arcs();
  CHECK(status_with(arcs) == Status::VALID);
  std::vector<Signature::Arc> changed(arcs.begin(), arcs.end() - 1);
  CHECK(status_with(changed) == Status::WRONG_NUMBER_OF_ARCS);
  changed.push_back(arcs[0]);
  CHECK(status_with(changed) == Status::DEPENDENT_ARCS);
  changed = arcs;
  changed[1].halfedges.pop_back();
  CHECK(status_with(changed) == Status::INVALID_ARC);
  changed = arcs;
  changed[2].halfedges[0] = Mesh::Halfedge_index(100000);
  CHECK(status_with(changed) == Status::FOREIGN_ARC);
}

TEST_CASE("the field has the corners that are given, or it is said where it has not", "[border]")
{
  using Corners = std::vector<Signature::Corner>;
  CGAL::Random random(5);
  for (const int n : {8, 40}) {
    Mesh mesh = plate(n, n / 2 + 1);
    const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
    const auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
    Corners at_corners, others;
    for (const Vertex v : mesh.vertices()) {
      const Point_3 p = mesh.point(v);
      if ((p.x() == 0 || p.x() == n) && (p.y() == 0 || p.y() == n / 2 + 1))
        at_corners.emplace_back(v, 1);
      if (p.x() == n / 2 && (p.y() == 0 || p.y() == n / 2 + 1))
        others.emplace_back(v, 1);
    }
    REQUIRE(at_corners.size() == 4);
    const Corners none, three(at_corners.begin(), at_corners.begin() + 3);
    Corners many;
    for (const auto h : mesh.halfedges())
      if (mesh.is_border(h) && random.get_int(0, 4) == 0)
        many.emplace_back(mesh.target(h), random.get_bool() ? 1 : random.get_int(3, 5));
    for (const Corners& corners : {none, three, others, at_corners, many}) {
      const auto np =
          T::parameters::halfedge_matching_map(matching, T::parameters::corners(std::optional<Corners>(corners)));
      Signature signature;
      REQUIRE(T::compute_smooth_cross_field(mesh, field, np));
      const auto report = T::holonomy_signature_of_cross_field(mesh, field, signature, np);
      INFO(describe(report, mesh));
      REQUIRE(report);
      CHECK(T::check_holonomy_signature(mesh, signature));
      CHECK(signature.corners().size() == corners.size());
      for (const auto& [v, k] : corners)
        CHECK(signature.corner_quarter_turns(v) == k);
    }
  }
  // Without an inner vertex there is none to make up for the difference.
  Mesh strip = plate(6, 1);
  const auto field = strip.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  Corners corners;
  for (const Vertex v : strip.vertices())
    if (strip.point(v).x() == 2 || strip.point(v).x() == 4)
      corners.emplace_back(v, 1);
  const auto np = T::parameters::corners(std::optional<Corners>(corners));
  REQUIRE(T::compute_smooth_cross_field(strip, field, np));
  Signature signature;
  const auto report = T::holonomy_signature_of_cross_field(strip, field, signature, np);
  CHECK(report.status == Status::CORNERS_NOT_MET);
  CHECK(report.actual != report.expected);
}

TEST_CASE("corners that cannot be are refused by all who take them, with their number", "[border]")
{
  Mesh mesh = plate(6, 6), other = plate(60, 60);
  const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  REQUIRE(T::compute_smooth_cross_field(mesh, field));
  const Vertex corner = *vertices(mesh).begin();
  REQUIRE(bool(is_border(corner, mesh)));
  const Vertex inner =
      *std::find_if(vertices(mesh).begin(), vertices(mesh).end(), [&](const Vertex v) { return !is_border(v, mesh); });
  using Corners = std::vector<Signature::Corner>;
  const auto refused = [&](const Corners& corners, const Status status, const char* words) {
    const auto np = T::parameters::corners(std::optional<Corners>(corners));
    Signature signature;
    const auto of_cones = T::holonomy_signature_of_cones(mesh, Corners(), signature, np);
    const auto of_field = T::holonomy_signature_of_cross_field(mesh, field, signature, np);
    const auto smooth = T::compute_smooth_cross_field(mesh, field, np);
    CHECK(of_cones.status == status);
    CHECK(of_field.status == status);
    CHECK(smooth.status == T::Smooth_cross_field_status::INVALID_CORNERS);
    CHECK(smooth.corners.status == status);
    for (const std::string& text : {describe(of_cones, mesh), describe(of_field, mesh), describe(smooth, mesh)})
      CHECK(text.find(words) != std::string::npos);
  };
  refused({{corner, 1}, {Mesh::null_vertex(), 1}}, Status::NULL_VERTEX, "no vertex: corner 1, counted from 0");
  refused({{*std::prev(vertices(other).end()), 1}}, Status::FOREIGN_VERTEX, "edited: corner 0, counted from 0");
  refused({{corner, 1}, {corner, 1}}, Status::DUPLICATE_CONE, "twice: vertex 0, counted from 0");
  refused({{corner, 0}}, Status::NON_POSITIVE_CONE, "vertex 0, counted from 0, has k = 0; it needs at least 1");
  refused({{inner, 1}}, Status::CORNER_INSIDE, "a corner is not on the border; make it a cone");
}

TEST_CASE("a triangle alone has no signature, two have one, and so has a triangle that is divided", "[border]")
{
  const auto refused = [](Mesh& mesh, const Mesh::Face_index triangle) {
    const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
    REQUIRE(T::compute_smooth_cross_field(mesh, field));
    Signature signature;
    for (const auto& report : {T::holonomy_signature_of_cross_field(mesh, field, signature),
                               T::holonomy_signature_of_cones(mesh, std::vector<Signature::Cone>(), signature),
                               T::check_holonomy_signature(mesh, Signature())}) {
      CHECK(report.status == Status::SINGLE_TRIANGLE);
      CHECK(report.face == triangle);
      CHECK(describe(report, mesh)
                .find(": face " + std::to_string(triangle.idx()) + ", counted from 0; remove it, or divide it") !=
            std::string::npos);
    }
  };
  const auto add_triangle = [](Mesh& mesh) {
    const Vertex a = mesh.add_vertex(Point_3(9, 0, 0)), b = mesh.add_vertex(Point_3(10, 0, 0)),
                 c = mesh.add_vertex(Point_3(9, 1, 0));
    return mesh.add_face(a, b, c);
  };
  Mesh alone, beside = plate(3, 3);
  refused(alone, add_triangle(alone));
  refused(beside, add_triangle(beside));

  Mesh square = plate(1, 1), divided;
  CGAL::Euler::add_center_vertex(divided.halfedge(add_triangle(divided)), divided);
  divided.point(*std::prev(vertices(divided).end())) = Point_3(9.3, 0.3, 0);
  CHECK(Guided(square).corners[1] == 4);
  CHECK(Guided(divided).signature.cones().size() == 1);
}

TEST_CASE("a field that does not follow the border is refused, with the edge and the angle", "[border]")
{
  Mesh mesh = plate(6, 6);
  const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  for (const auto f : mesh.faces())
    field[f] = Kernel::Vector_3(std::cos(0.6), std::sin(0.6), 0);
  Signature signature;
  const auto report = T::holonomy_signature_of_cross_field(mesh, field, signature);
  CHECK(report.status == Status::FIELD_NOT_ALIGNED);
  CHECK(report.deviation * 90 == Approx(0.6 * 180 / CGAL_PI));
  CHECK(mesh.is_border(mesh.opposite(report.halfedge)));
  CHECK(describe(report, mesh).find("34 degrees") != std::string::npos);
}

TEST_CASE("a field that does not follow the border can stand for one with the same cones that does", "[border]")
{
  const auto aligned = [](Mesh& mesh, Signature& signature) {
    const auto field = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
    for (const auto f : mesh.faces())
      field[f] = Kernel::Vector_3(std::cos(0.6), std::sin(0.6), 0); // no cones
    CHECK(T::holonomy_signature_of_cross_field(mesh, field, signature).status == Status::FIELD_NOT_ALIGNED);
    const auto report = T::holonomy_signature_of_cross_field(mesh, field, signature, T::parameters::align_border(true));
    CHECK(report.is_aligned);
    return report;
  };
  Mesh square = plate(6, 6), ring = annulus(3, 24, 6), round = disk(8), straight = plate(6, 6);
  Signature signature;
  REQUIRE(aligned(square, signature));
  CHECK(signature.cones().empty());
  CHECK(signature.corners().size() == 4);
  CHECK(T::check_holonomy_signature(square, signature));
  REQUIRE(aligned(ring, signature));
  CHECK(signature.cones().empty());
  CHECK(signature.corners().empty());
  CHECK(signature.arcs().size() == 1);
  CHECK(T::check_holonomy_signature(ring, signature));
  // The border of a disk has no corners, so there would have to be cones: those of the field are left.
  REQUIRE(aligned(round, signature));
  CHECK(signature.cones().empty());
  CHECK(signature.corners().size() == 4);
  for (const auto& corner : signature.corners())
    CHECK(corner.second == 1);
  CHECK(T::check_holonomy_signature(round, signature));
  const auto none = T::parameters::corners(std::optional(std::vector<Signature::Corner>()));
  const auto field_of_disk = round.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  const auto without_corners =
      T::holonomy_signature_of_cross_field(round, field_of_disk, signature, T::parameters::align_border(true, none));
  CHECK(without_corners.status == Status::GAUSS_BONNET_VIOLATED);
  CHECK(without_corners.actual - without_corners.expected == -4);

  // One that follows it is what it is.
  const auto field = straight.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:field").first;
  for (const auto f : straight.faces())
    field[f] = Kernel::Vector_3(1, 0, 0);
  Signature same;
  const auto report = T::holonomy_signature_of_cross_field(straight, field, same, T::parameters::align_border(true));
  CHECK(report);
  CHECK_FALSE(report.is_aligned);
}

} // namespace border_test
