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
#include "Spline/sharp_cube.h"

#include <CGAL/Random.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <ios>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tessellate_T_spline_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<double>;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
namespace T = CGAL::T_splines;

template <typename SplineMesh>
typename SplineMesh::Surface prepared(SplineMesh& t)
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

// Whether each side of a triangle has one other triangle beside it.
template <typename Tessellation>
bool is_closed_without_cracks(const Tessellation& tessellation)
{
  std::map<std::pair<std::size_t, std::size_t>, int> count; // of each directed side of a triangle
  for (const auto& triangle : tessellation.triangles)
    for (int i = 0; i < 3; ++i)
      ++count[{triangle[i], triangle[(i + 1) % 3]}];
  return std::all_of(count.begin(), count.end(), [&](const auto& side) {
    return side.second == 1 && count.count({side.first.second, side.first.first}) == 1;
  });
}

// A crease, or an end of one.
template <typename Surface>
bool is_on_crease(const Surface& surface, const typename Surface::Place& place)
{
  const auto& t_mesh = surface.t_mesh_arrays();
  const auto is_at = [&](const std::pair<double, double>& p) {
    return std::abs(p.first - place.u) + std::abs(p.second - place.v) < 1e-9;
  };
  std::vector<char> has_crease(t_mesh.number_of_vertices(), 0);
  for (int h = 0; h < t_mesh.number_of_halfedges(); ++h)
    if (t_mesh.is_crease(h))
      has_crease[t_mesh.target(h)] = 1;
  const int f = surface.indexing().face_index(place.face);
  for (int h = 0; h < t_mesh.number_of_halfedges(); ++h) {
    if (t_mesh.face(h) != f)
      continue;
    const auto a = t_mesh.source_point(h), b = t_mesh.target_point(h);
    if (has_crease[t_mesh.target(h)] != 0 && is_at(b))
      return true;
    const double length = std::abs(b.first - a.first) + std::abs(b.second - a.second);
    const double x = (std::abs(place.u - a.first) + std::abs(place.v - a.second)) / length;
    if (t_mesh.is_crease(h) && x > 0 && x < 1 &&
        is_at({a.first + x * (b.first - a.first), a.second + x * (b.second - a.second)}))
      return true;
  }
  return false;
}

struct Obj_file {
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
  std::vector<std::array<std::pair<std::size_t, std::size_t>, 3>> faces; // points and normals, from 0
};

template <typename Surface>
Obj_file written_and_read(const Surface& surface, const int resolution)
{
  std::stringstream stream;
  REQUIRE_FALSE(T::write_t_spline_obj(stream, surface, resolution));
  Obj_file result;
  for (std::string word; stream >> word;) {
    double x = 0, y = 0, z = 0;
    if (word == "f") {
      result.faces.emplace_back();
      for (auto& [point, normal] : result.faces.back()) {
        char slash = 0;
        stream >> point >> slash >> slash >> normal;
        --point, --normal;
      }
      continue;
    }
    stream >> x >> y >> z;
    if (word == "v")
      result.points.emplace_back(x, y, z);
    else if (word == "vn")
      result.normals.emplace_back(x, y, z);
    else
      FAIL("unknown line: " << word);
  }
  return result;
}

// Of a triangle in space, a unit normal.
Kernel::Vector_3 normal_of(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c)
{
  const Kernel::Vector_3 n = CGAL::cross_product(b - a, c - a);
  return n / std::sqrt(n.squared_length());
}

double length_of(const Kernel::Vector_3& v)
{
  return std::sqrt(v.squared_length());
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
      CHECK(is_closed_without_cracks(tessellation));
      CHECK(tessellation.crease_places.empty());
      CHECK(tessellation.crease_corners.empty());
      CHECK(tessellation.triangles_split_at_creases() == tessellation.triangles);
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

TEST_CASE("triangles at creases share points, and have their own faces' normals", "[tessellate_T_spline]")
{
  Mesh t(test_t_meshes::cube<double>());
  make_sharp_cube(t);
  const Mesh::Surface spline = t.surface();
  REQUIRE(spline.is_valid());
  const auto patches = T::compile_T_spline(spline);
  for (const T::Tessellation_resolution& resolution :
       {T::Tessellation_resolution(2), T::Tessellation_resolution(5), T::Tessellation_resolution::within(0.01)}) {
    const auto tessellation = T::tessellate_parameter_domain(patches, resolution);
    CHECK(is_closed_without_cracks(tessellation));
    auto places = tessellation.places;
    places.insert(places.end(), tessellation.crease_places.begin(), tessellation.crease_places.end());
    const auto split = tessellation.triangles_split_at_creases();
    std::size_t corners_on_creases = 0;
    for (std::size_t i = 0; i < split.size(); ++i) {
      std::array<Kernel::Point_3, 3> points;
      for (int k = 0; k < 3; ++k) {
        const auto& place = places[split[i][k]];
        CHECK(place.face == tessellation.faces[i]);
        const auto& shared = places[tessellation.triangles[i][k]];
        points[k] = patches.position(shared.face, shared.u, shared.v);
        CHECK(CGAL::squared_distance(patches.position(place.face, place.u, place.v), points[k]) < 1e-28);
        corners_on_creases += split[i][k] != tessellation.triangles[i][k];
      }
      const Kernel::Vector_3 normal = normal_of(points[0], points[1], points[2]);
      for (const std::size_t k : split[i])
        CHECK(length_of(patches.unit_normal(places[k].face, places[k].u, places[k].v) - normal) < 1e-12);
    }
    CHECK(corners_on_creases == tessellation.crease_corners.size());
  }
}

TEST_CASE("corners of triangles on creases, and no others, have places in their own faces", "[tessellate_T_spline]")
{
  CGAL::Random random(1);
  for (const auto& [name, faces] : closed_surfaces<Rational>())
    for (const int one_in : {1, 12, 12}) {
      INFO(name << ", one edge in " << one_in);
      Spline_mesh<Rational> t(faces);
      for (const auto e : edges(t.mesh))
        put(t.creases(), e, random.get_int(0, one_in) == 0);
      const auto report = t.make_spline_compatible();
      INFO(message(report.status));
      REQUIRE(report);
      t.split_randomly(6, random);
      const auto spline = prepared(t);
      REQUIRE(spline.is_valid());
      const auto tessellation = T::tessellate_parameter_domain(spline, 3);
      CHECK(is_closed_without_cracks(tessellation));
      std::vector<char> is_crease_place(tessellation.places.size());
      for (std::size_t i = 0; i < tessellation.places.size(); ++i)
        is_crease_place[i] = is_on_crease(spline, tessellation.places[i]);
      const auto split = tessellation.triangles_split_at_creases();
      bool is_complete = true, is_inside = true, is_in_face = true;
      double distance = 0;
      for (std::size_t i = 0; i < split.size(); ++i)
        for (int k = 0; k < 3; ++k) {
          const std::size_t shared = tessellation.triangles[i][k], own = split[i][k];
          is_complete = is_complete && (own != shared) == (is_crease_place[shared] != 0);
          if (own == shared)
            continue;
          const auto &a = tessellation.places[shared],
                     &b = tessellation.crease_places[own - tessellation.places.size()];
          is_in_face = is_in_face && b.face == tessellation.faces[i];
          is_inside = is_inside && b.u >= 0 && b.v >= 0 && b.u <= spline.width(b.face) && b.v <= spline.height(b.face);
          distance = (std::max)(
              distance, CGAL::squared_distance(spline.position(a.face, a.u, a.v), spline.position(b.face, b.u, b.v)));
        }
      CHECK(is_complete);
      CHECK(is_in_face);
      CHECK(is_inside);
      CHECK(std::sqrt(distance) < 1e-12);
    }
}

TEST_CASE("halfedges receive the normals of their own triangles", "[tessellate_T_spline]")
{
  for (const bool is_sharp : {false, true}) {
    Mesh t(test_t_meshes::cube<double>());
    if (is_sharp)
      make_sharp_cube(t);
    const Mesh::Surface spline = is_sharp ? t.surface() : prepared(t);
    Triangles mesh;
    const auto of_vertices = mesh.add_property_map<Triangles::Vertex_index, Kernel::Vector_3>("v:normal").first;
    const auto of_corners = mesh.add_property_map<Triangles::Halfedge_index, Kernel::Vector_3>("h:normal").first;
    REQUIRE(T::tessellate_T_spline(
        spline, 4, mesh,
        T::parameters::halfedge_normal_map(of_corners, CGAL::parameters::vertex_normal_map(of_vertices))));
    int sharp_corners = 0;
    for (const auto h : mesh.halfedges()) {
      const auto a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)),
                 c = mesh.point(mesh.target(mesh.next(h)));
      if (is_sharp)
        CHECK(length_of(of_corners[h] - normal_of(a, b, c)) < 1e-12);
      else
        CHECK(of_corners[h] == of_vertices[mesh.target(h)]);
      sharp_corners += length_of(of_corners[h] - of_vertices[mesh.target(h)]) > 0.5;
    }
    CHECK((sharp_corners > 0) == is_sharp);
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

namespace {

// A narrow band of a cone, and beyond a crease the cone folded back, with waves: there a distance asks for many points on the
// crease, and between two points inside of the band the crease bends more than the triangles are wide.
// \return the number of triangles of the band
std::size_t triangles_of_band(const double width, const bool is_band_first)
{
  constexpr int columns = 12, rows = 6, middle = 3;
  Mesh t(test_t_meshes::rectangle<double>(columns, rows));
  for (int i = 0; i < columns; ++i)
    put(t.creases(), edge(t.halfedge_of(i + columns * middle, 0), t.mesh), true);
  const auto report = t.make_spline_compatible();
  REQUIRE(report);
  REQUIRE(report.vertices_after == (columns + 1) * (rows + 1));
  for (int f = 0; f < columns * rows; ++f)
    for (int k = 0; k < 4; ++k) {
      const int i = f % columns + (k == 1 || k == 2), j = f / columns + (k >= 2), from_crease = std::abs(j - middle);
      const bool is_of_band = (j < middle) == is_band_first;
      const double angle = i * std::acos(-1.) / 8, radius = 1 + from_crease * (is_of_band ? width : 0.5);
      const double wave = !is_of_band && from_crease >= 2 ? i % 2 : 0;
      t.set_control(source(t.halfedge_of(f, k), t.mesh),
                    Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle), (radius - 1) / 2 + wave), 1.);
    }
  const auto patches = T::compile_T_spline(t.surface());
  const auto tessellation = T::tessellate_parameter_domain(patches, T::Tessellation_resolution::within(1e-3));
  return std::count_if(tessellation.faces.begin(), tessellation.faces.end(), [&](const auto face) {
    const auto f = std::find(t.face_list.begin(), t.face_list.end(), face) - t.face_list.begin();
    return (f / columns < middle) == is_band_first;
  });
}

} // namespace

TEST_CASE("a side of a crease is divided by its own normals, whichever side comes first", "[Tessellation_resolution]")
{
  for (const double width : {0.0003, 0.0006})
    CHECK(triangles_of_band(width, true) == triangles_of_band(width, false));
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

TEST_CASE("an OBJ file has the normals of all sides of creases, and shares the points", "[write_t_spline_obj]")
{
  Mesh t(test_t_meshes::cube<double>());
  make_sharp_cube(t);
  const Mesh::Surface spline = t.surface();
  const Obj_file file = written_and_read(spline, 4);
  CHECK(file.points.size() == T::tessellate_parameter_domain(spline, 4).places.size());
  std::map<std::size_t, std::set<std::vector<int>>> normals_of_point;
  for (const auto& face : file.faces) {
    for (const auto& [point, normal] : face)
      REQUIRE((point < file.points.size() && normal < file.normals.size()));
    const Kernel::Vector_3 expected =
        normal_of(file.points[face[0].first], file.points[face[1].first], file.points[face[2].first]);
    for (const auto& [point, normal] : face) {
      CHECK(length_of(file.normals[normal] - expected) < 1e-12);
      std::vector<int> rounded;
      for (int k = 0; k < 3; ++k)
        rounded.push_back(static_cast<int>(std::lround(file.normals[normal][k])));
      normals_of_point[point].insert(rounded);
    }
  }
  std::map<std::size_t, int> points_with_normals;
  for (const auto& [point, normals] : normals_of_point)
    ++points_with_normals[normals.size()];
  CHECK(points_with_normals == std::map<std::size_t, int>{{1, 6 * 9}, {2, 12 * 3}, {3, 8}});
}

TEST_CASE("without creases an OBJ file has one normal for each point", "[write_t_spline_obj]")
{
  Mesh t(test_t_meshes::cube<double>());
  const Obj_file file = written_and_read(prepared(t), 4);
  CHECK(file.normals.size() == file.points.size());
  for (const auto& face : file.faces)
    for (const auto& [point, normal] : face)
      CHECK(point == normal);
}

} // namespace tessellate_T_spline_test
