// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/IO/write_t_spline_obj.h>
#include <CGAL/T_splines/IO/write_t_spline_ply.h>
#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>

#include "IO/Temporary_directory.h"
#include "Spline/Spline_mesh.h"

#include <CGAL/Random.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <ios>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace tessellate_T_spline_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<double>;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
namespace T = CGAL::T_splines;

Mesh::Surface prepared(Mesh& t)
{
  CGAL::Random random(1);
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  return t.surface();
}

int euler_characteristic(const Triangles& mesh)
{
  return static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) + static_cast<int>(num_faces(mesh));
}

} // namespace

TEST_CASE("triangles cover each face once and share the points of its sides", "[tessellate_T_spline]")
{
  for (const auto& surface : closed_surfaces<double>()) {
    Mesh t(surface.second);
    const Mesh::Surface spline = prepared(t);
    for (const int n : {3, 5}) { // in two parts, a side that ends where it begins would go there and back
      INFO(surface.first << ", " << n);
      const auto tessellation = T::tessellate_parameter_domain(spline, n);
      CHECK(tessellation.faces.size() == tessellation.triangles.size());
      for (std::size_t i = 0; i < tessellation.triangles.size(); ++i)
        for (const std::size_t p : tessellation.triangles[i]) {
          // Points inside of a face belong to it; others may be given in the frame of a neighbour.
          const auto& place = tessellation.places[p];
          const bool is_inside = place.u > 0 && place.v > 0 && place.u < spline.width(place.face) * (1 - 1e-9) &&
                                 place.v < spline.height(place.face) * (1 - 1e-9);
          if (is_inside && place.face != tessellation.faces[i])
            FAIL("a triangle has a point inside of another face");
        }
      std::map<std::pair<std::size_t, std::size_t>, int> count; // of each directed side of a triangle
      for (const auto& triangle : tessellation.triangles)
        for (int i = 0; i < 3; ++i)
          ++count[{triangle[i], triangle[(i + 1) % 3]}];
      bool is_closed = true;
      for (const auto& [side, number] : count)
        is_closed = is_closed && number == 1 && count.count({side.second, side.first}) == 1;
      CHECK(is_closed);
      for (const auto& place : tessellation.places) {
        REQUIRE(place.u >= 0);
        REQUIRE(place.u <= spline.width(place.face));
        REQUIRE(place.v >= 0);
        REQUIRE(place.v <= spline.height(place.face));
      }
    }
  }
}

TEST_CASE("the mesh has the topology of the surface, its points, normals and places", "[tessellate_T_spline]")
{
  for (const auto& [faces, characteristic] :
       {std::pair(test_t_meshes::cube<double>(), 2), std::pair(test_t_meshes::genus_two<double>(), -2),
        std::pair(test_t_meshes::pillow<double>(), 2), std::pair(test_t_meshes::rectangle<double>(4, 3), 1)}) {
    Mesh t(faces);
    const Mesh::Surface spline = prepared(t);
    Triangles mesh;
    const auto normals = mesh.add_property_map<Triangles::Vertex_index, Kernel::Vector_3>("v:normal").first;
    const auto made = T::tessellate_T_spline(spline, 3, mesh, CGAL::parameters::vertex_normal_map(normals));
    REQUIRE(made);
    CHECK(describe(made) == "the surface was tessellated");
    const auto number_of_faces = mesh.number_of_faces();
    const auto refused = T::tessellate_T_spline(spline, 3, mesh); // it is not empty any more
    CHECK_FALSE(refused);
    CHECK(describe(refused) == "the mesh that is to receive the triangles is not empty; give a new one");
    CHECK(mesh.number_of_faces() == number_of_faces);
    CHECK(euler_characteristic(mesh) == characteristic);
    CHECK(CGAL::is_closed(mesh) == (characteristic != 1));
    CHECK(CGAL::is_triangle_mesh(mesh));
    Triangles other;
    const auto places = other.add_property_map<Triangles::Vertex_index, Mesh::Surface::Place>("v:place").first;
    T::tessellate_T_spline(T::compile_T_spline(spline), 3, other, T::parameters::vertex_place_map(places));
    for (const auto v : vertices(other)) {
      const auto place = places[v];
      CHECK(mesh.point(v) == spline.position(place.face, place.u, place.v));
      CHECK(normals[v] == spline.unit_normal(place.face, place.u, place.v));
    }
  }
}

TEST_CASE("triangles are as close to the surface as asked for, the more the closer", "[Tessellation_resolution]")
{
  for (const auto& surface : closed_surfaces<double>()) {
    Mesh t(surface.second);
    const auto patches = T::compile_T_spline(prepared(t));
    std::size_t last = 0;
    for (const double distance : {0.2, 0.02, 0.002}) {
      INFO(surface.first << ", " << distance);
      const auto resolution = T::Tessellation_resolution::within(distance);
      CHECK(resolution.is_adaptive());
      Triangles triangles;
      REQUIRE(T::tessellate_T_spline(patches, resolution, triangles).success());
      CHECK(CGAL::is_closed(triangles));
      CHECK(triangles.number_of_faces() > last);
      last = triangles.number_of_faces();
      const T::Mesh_distance to_triangles(triangles);
      double largest = 0;
      for (std::size_t i = 0; i < patches.number_of_patches(); ++i)
        for (int k = 0; k < 100; ++k)
          largest =
              (std::max)(largest, to_triangles(patches.patch(i).position((k % 10 + 0.5) / 10, (k / 10 + 0.5) / 10)));
      CHECK(largest < 1.5 * distance);
    }
  }
}

TEST_CASE("a PLY file has the points and triangles bit by bit, and the normals", "[write_t_spline_ply]")
{
  Mesh t(test_t_meshes::cube<double>());
  const Mesh::Surface spline = prepared(t);
  const Temporary_directory directory;
  REQUIRE_FALSE(T::write_t_spline_ply(directory.file("cube.ply"), spline, 4));
  Triangles expected, triangles;
  REQUIRE(T::tessellate_T_spline(spline, 4, expected).success());
  REQUIRE(T::read_triangle_mesh(directory.file("cube.ply"), triangles).success());
  REQUIRE(triangles.number_of_vertices() == expected.number_of_vertices());
  REQUIRE(triangles.number_of_faces() == expected.number_of_faces());
  for (const auto v : expected.vertices())
    CHECK(triangles.point(v) == expected.point(v));
  std::ostringstream content;
  content << std::ifstream(directory.file("cube.ply"), std::ios::binary).rdbuf();
  const std::string text = content.str(), end = "end_header\n";
  const std::size_t header = text.find(end) + end.size();
  CHECK(text.size() == header + 36 * expected.number_of_vertices() + 13 * expected.number_of_faces());
  const auto place = T::tessellate_parameter_domain(spline, 4).places.front();
  float normal[3];
  std::memcpy(normal, text.data() + header + 24, sizeof(normal)); // this machine's numbers are little endian, too
  for (int k = 0; k < 3; ++k)
    CHECK(normal[k] == static_cast<float>(spline.unit_normal(place.face, place.u, place.v)[k]));
  CHECK(T::write_t_spline_ply(directory.file("no/cube.ply"), spline, 4));
}

TEST_CASE("an OBJ file has the triangles and unit normals, or is not there", "[write_t_spline_obj]")
{
  const Temporary_directory directory;
  Mesh t(test_t_meshes::cube<double>());
  const Mesh::Surface spline = prepared(t);
  REQUIRE_FALSE(T::write_t_spline_obj(directory.file("cube.obj"), spline, 4));
  Triangles mesh;
  REQUIRE(CGAL::IO::read_OBJ(directory.file("cube.obj"), mesh));
  CHECK(CGAL::is_closed(mesh));
  CHECK(euler_characteristic(mesh) == 2);
  std::ifstream file(directory.file("cube.obj"));
  std::size_t normals = 0;
  for (std::string word; file >> word;)
    if (word == "vn") {
      double x, y, z;
      file >> x >> y >> z;
      CHECK(std::abs(x * x + y * y + z * z - 1) < 1e-12);
      ++normals;
    }
  CHECK(normals == num_vertices(mesh));
  CHECK(T::write_t_spline_obj(directory.file("no/cube.obj"), spline, 4));
}

} // namespace tessellate_T_spline_test
