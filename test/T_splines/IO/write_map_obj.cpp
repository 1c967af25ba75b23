// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Temporary_directory.h"

#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/write_map_obj.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace write_map_obj_test {

namespace {

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Status = T::Mesh_reading_status;

/// A tetrahedron with random points of widely different sizes, and a uv that differs between the faces of one edge only.
template <typename Mesh, typename UVMap>
void make_map(Mesh& mesh, const UVMap uv_map)
{
  CGAL::Random random(7);
  const auto number = [&random] { return random.uniform_real(-1.0, 1.0) * std::pow(10.0, random.get_int(-12, 13)); };
  const auto point = [&number] { return Point_3(number(), number(), number()); };
  const Point_3 p = point(), q = point(), r = point(), s = point();
  const auto seam = CGAL::make_tetrahedron(p, q, r, s, mesh);
  for (const auto v : CGAL::make_range(vertices(mesh))) {
    const Point_2 uv(number(), number());
    for (const auto h : CGAL::halfedges_around_target(v, mesh))
      put(uv_map, h, uv);
  }
  put(uv_map, seam, Point_2(-0.0, 5e-324));
}

bool has_leftovers(const std::filesystem::path& directory)
{
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.path().string().find(".part") != std::string::npos)
      return true;
  return false;
}

void write_file(const std::string& name, const std::string& content)
{
  std::ofstream(name) << content;
}

} // namespace

TEMPLATE_TEST_CASE("a map that is written and read is the same, bit by bit", "", Surface_mesh, Polyhedron)
{
  using Halfedge = typename boost::graph_traits<TestType>::halfedge_descriptor;
  using Edge = typename boost::graph_traits<TestType>::edge_descriptor;
  const Temporary_directory directory;
  std::map<Halfedge, Point_2> uv, read_uv;
  std::map<Edge, bool> cut;
  TestType mesh, read_mesh;
  make_map(mesh, boost::make_assoc_property_map(uv));
  const std::string name = directory.file("map.obj"), name_again = directory.file("map_again.obj");
  REQUIRE_FALSE(T::write_map_obj(name, mesh, boost::make_assoc_property_map(uv)));
  const auto np = T::parameters::edge_is_cut_map(boost::make_assoc_property_map(cut));
  REQUIRE(T::read_map_obj(name, read_mesh, boost::make_assoc_property_map(read_uv), np).success());

  const T::internal::Mesh_indexing<TestType> indexing(mesh), read_indexing(read_mesh);
  REQUIRE(indexing.number_of_vertices() == read_indexing.number_of_vertices());
  REQUIRE(indexing.number_of_faces() == read_indexing.number_of_faces());
  const auto points = get(CGAL::vertex_point, mesh);
  const auto read_points = get(CGAL::vertex_point, read_mesh);
  for (int v = 0; v < indexing.number_of_vertices(); ++v)
    CHECK(get(points, indexing.vertex(v)) == get(read_points, read_indexing.vertex(v)));
  for (int f = 0; f < indexing.number_of_faces(); ++f) {
    std::map<int, Point_2> corners, read_corners;
    for (const auto h : CGAL::halfedges_around_face(halfedge(indexing.face(f), mesh), mesh))
      corners[indexing.vertex_index(target(h, mesh))] = uv[h];
    for (const auto h : CGAL::halfedges_around_face(halfedge(read_indexing.face(f), read_mesh), read_mesh))
      read_corners[read_indexing.vertex_index(target(h, read_mesh))] = read_uv[h];
    CHECK(corners == read_corners);
  }

  // One corner was torn off: the two edges of its face there are seams.
  std::size_t seams = 0;
  for (const auto& [edge, is_cut] : cut)
    seams += is_cut;
  CHECK(cut.size() == 6);
  CHECK(seams == 2);

  // Written once more it is as long.
  REQUIRE_FALSE(T::write_map_obj(name_again, read_mesh, boost::make_assoc_property_map(read_uv)));
  CHECK(std::filesystem::file_size(name) == std::filesystem::file_size(name_again));
}

TEST_CASE("a file that cannot be written leaves nothing behind and leaves what was there")
{
  const Temporary_directory directory;
  Surface_mesh mesh;
  const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
  make_map(mesh, uv);
  CHECK(T::write_map_obj(directory.file("no_such_directory/map.obj"), mesh, uv) ==
        std::errc::no_such_file_or_directory);
  std::filesystem::create_directories(directory.file("is_a_directory.obj/inside"));
  CHECK(T::write_map_obj(directory.file("is_a_directory.obj"), mesh, uv));
  CHECK_FALSE(has_leftovers(directory.path()));

  write_file(directory.file("old.obj"), "old");
  {
    T::Atomic_file file(directory.file("old.obj"));
    file.write("new");
    CHECK(file.finish());
    CHECK(has_leftovers(directory.path()));
  }
  CHECK_FALSE(has_leftovers(directory.path()));
  CHECK(std::filesystem::file_size(directory.file("old.obj")) == 3);
  std::string content;
  std::ifstream(directory.file("old.obj")) >> content;
  CHECK(content == "old");
}

TEST_CASE("a mesh that is not empty receives no map")
{
  const Temporary_directory directory;
  const std::string name = directory.file("map.obj");
  write_file(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  Surface_mesh mesh;
  const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
  REQUIRE(T::read_map_obj(name, mesh, uv));
  CHECK(T::read_map_obj(name, mesh, uv).status == Status::OUTPUT_NOT_EMPTY);
  CHECK(mesh.number_of_faces() == 1);
}

TEST_CASE("a map without uv at a corner, or with bad uv, is refused")
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Temporary_directory directory;
  const std::string name = directory.file("map.obj");
  const auto status_of = [&name](const std::string& content) {
    write_file(name, content);
    Surface_mesh mesh;
    const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
    const T::Mesh_reading_report report = T::read_map_obj(name, mesh, uv);
    CHECK((report.success() || num_vertices(mesh) == 0));
    return report.status;
  };
  CHECK(status_of(points + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n") == Status::SUCCESS); // a boundary is accepted
  CHECK(status_of(points + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3\n") == Status::MISSING_UV);
  CHECK(status_of(points + "f 1 2 3\n") == Status::MISSING_UV);
  CHECK(status_of(points + "vt 0 0\nvt 1 nan\nvt 0 1\nf 1/1 2/2 3/3\n") == Status::NON_FINITE_COORDINATE);
  CHECK(status_of(points + "vt 0 0\nvt 1 0\nf 1/1 2/2 3/3\n") == Status::INDEX_OUT_OF_RANGE);
  CHECK(status_of("vt 0 0\n") == Status::EMPTY);
}

} // namespace write_map_obj_test
