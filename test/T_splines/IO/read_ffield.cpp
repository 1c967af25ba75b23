// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/read_ffield.h>

#include "Cross_field/test_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace read_ffield_test {

namespace ts = CGAL::T_splines;
namespace in = CGAL::T_splines::internal;
using Status = ts::Field_file_status;
using Mesh = test::Surface_mesh;

namespace {

// A field in the terms of the format: per face an angle relative to the halfedge that points to the first vertex, per halfedge
// a matching p such that angle + transport + p pi/2 is about the angle in the opposite face.
struct Facet_field {
  Mesh mesh;
  in::Mesh_indexing<Mesh> indexing;
  in::Triangulation_connectivity connectivity;
  std::vector<double> angle;
  std::vector<int> matching;

  explicit Facet_field(const test::Soup& soup)
    : mesh(test::to_mesh<Mesh>(soup)),
      indexing(mesh),
      connectivity(in::triangulation_connectivity(indexing)),
      angle(num_faces(mesh)),
      matching(connectivity.number_of_halfedges())
  {
    const in::Triangle_geometry geometry = in::triangle_geometry(indexing, connectivity, mesh.points());
    auto field = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
    ts::compute_smooth_cross_field(mesh, field);
    in::cross_angles(indexing, connectivity, geometry, field, angle);
    const std::vector<double> relative = in::angles_to_halfedges(connectivity, geometry, angle);
    for (int h = 0; h < connectivity.number_of_halfedges(); h += 2) {
      const double into_opposite = relative[h] + CGAL_PI - relative[h + 1];
      matching[h] = -static_cast<int>(std::lround(into_opposite / in::quarter_turn));
      matching[h + 1] = -matching[h];
    }
  }

  std::string text(const std::string& section, const int sign, const bool has_sharp) const
  {
    std::ostringstream out;
    out.precision(17);
    out << "# version 2\ntarget_frame\n" << angle.size() << "\nk1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n";
    for (std::size_t f = 0; f < angle.size(); ++f)
      out << "1 1 1 0 0 0 1 0\n";
    out << "crossfield_angles\n";
    for (const double a : angle)
      out << a << ' ';
    out << "\nfixed\n2 0 1\nfixed_vertices\n0\n" << section << '\n';
    for (std::size_t f = 0; f < angle.size(); ++f) {
      const int first = connectivity.halfedge_of_face(static_cast<int>(f));
      const int halfedges[] = {first, connectivity.next(first), connectivity.previous(first)};
      for (const int h : halfedges)
        out << connectivity.target(h) << ' ';
      for (const int h : halfedges)
        out << sign * matching[h] << ' ';
      out << (has_sharp ? "0 0 0\n" : "\n");
    }
    return out.str();
  }
};

} // namespace

TEST_CASE("matchings of a file determine the signature")
{
  Facet_field facet_field(test::plate(2, 3));
  Mesh& mesh = facet_field.mesh;
  auto field = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:field").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
  const auto np = ts::parameters::halfedge_matching_map(matching);
  ts::Holonomy_signature<Mesh> signature, closest;
  const auto check_equal = [&]() {
    for (const auto v : vertices(mesh))
      CHECK(signature.quarter_turns(v) == closest.quarter_turns(v));
    for (std::size_t l = 0; l < signature.loops().size(); ++l)
      CHECK(signature.loops()[l].quarter_turns == closest.loops()[l].quarter_turns);
  };
  for (const char* section : {"MI_matchings", "MI_matchings_and_sharp", "matchings", "matchings_and_sharp"}) {
    const std::string name = section;
    std::istringstream input(facet_field.text(name, name[0] == 'M' ? 1 : -1, name.find("sharp") != std::string::npos));
    const auto report = ts::read_ffield(input, mesh, field, matching);
    CAPTURE(name, message(report.status), report.line, report.text);
    REQUIRE(report.success());
    REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature, np).success());
    REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, closest).success());
    check_equal(); // the file has the matchings of the closest rotation
  }
  // Turning the direction in one face with its matchings changes nothing.
  const int f = 17;
  facet_field.angle[f] += in::quarter_turn;
  int h = facet_field.connectivity.halfedge_of_face(f);
  for (int corner = 0; corner < 3; ++corner, h = facet_field.connectivity.next(h)) {
    facet_field.matching[h] -= 1;
    facet_field.matching[h ^ 1] += 1;
  }
  std::istringstream turned(facet_field.text("MI_matchings", 1, false));
  REQUIRE(ts::read_ffield(turned, mesh, field, matching).success());
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature, np).success());
  check_equal();
  // Another matching on one edge moves a quarter turn from one of its ends to the other.
  facet_field.matching[100] += 1;
  facet_field.matching[101] -= 1;
  std::istringstream changed(facet_field.text("MI_matchings", 1, false));
  REQUIRE(ts::read_ffield(changed, mesh, field, matching).success());
  REQUIRE(ts::holonomy_signature_of_cross_field(mesh, field, signature, np).success());
  const auto e = facet_field.indexing.halfedge(100);
  CHECK(signature.quarter_turns(source(e, mesh)) == closest.quarter_turns(source(e, mesh)) - 1);
  CHECK(signature.quarter_turns(target(e, mesh)) == closest.quarter_turns(target(e, mesh)) + 1);
  CHECK(ts::check_holonomy_signature(mesh, signature).success());
}

TEST_CASE("bad ffield files are refused")
{
  Facet_field facet_field(test::torus(4, 3));
  Mesh& mesh = facet_field.mesh;
  auto field = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:field").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
  const std::string good = facet_field.text("MI_matchings", 1, false);
  const auto read = [&](const std::string& text) {
    std::istringstream input(text);
    return ts::read_ffield(input, mesh, field, matching);
  };
  const auto replaced = [&good](const std::string& what, const std::string& by) {
    std::string text = good;
    return text.replace(text.find(what), what.size(), by);
  };
  REQUIRE(read(good).success());
  CHECK(read("").status == Status::TRUNCATED);
  CHECK(read(replaced("target_frame", "frame")).status == Status::SYNTAX_ERROR);
  CHECK(read(replaced("\n24\n", "\n25\n")).status == Status::WRONG_COUNT);
  CHECK(read(replaced("MI_matchings", "garbage")).status == Status::SYNTAX_ERROR);
  CHECK(read(good.substr(0, good.find("MI_"))).status == Status::MISSING_SECTION);
  CHECK(read(good.substr(0, good.size() - 4)).status == Status::TRUNCATED);
  CHECK(read(good + "another_section\n1 2 3\n").success());
  const std::size_t angles = good.find("crossfield_angles"), fixed = good.find("fixed");
  CHECK(read(std::string(good).erase(angles, fixed - angles)).status == Status::MISSING_SECTION);
  facet_field.matching[0] += 1;
  CHECK(read(facet_field.text("MI_matchings", 1, false)).status == Status::INCONSISTENT_MATCHING);
  facet_field.connectivity.m_face_halfedge[3] = facet_field.connectivity.m_face_halfedge[4];
  const auto report = read(facet_field.text("MI_matchings", 1, false));
  CHECK(report.status == Status::WRONG_FACE);
  CHECK(report.index == 3);
}

} // namespace read_ffield_test
