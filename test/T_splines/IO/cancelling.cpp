// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Counting_visitor.h"
#include "IO/T_mesh_with_maps.h"
#include "IO/Temporary_directory.h"

#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <string>

namespace cancelling_test {

namespace {

// A strip of squares around a tube of four sides, closed at both ends; with uv in OBJ.
std::string tube(const std::string& format, const int n)
{
  std::string vertices, faces;
  const bool is_obj = format == "obj";
  const auto corner = [&](const int i) { return std::to_string(is_obj ? i + 1 : i); };
  for (int i = 0; i <= n; ++i)
    for (const char* p : {"0 0 ", "1 0 ", "1 1 ", "0 1 "})
      vertices += (is_obj ? "v " : "") + (p + std::to_string(i)) + "\n";
  int number_of_faces = 0;
  const auto add = [&](const int a, const int b, const int c) {
    ++number_of_faces;
    faces += is_obj ? "f" : "3";
    for (const int i : {a, b, c})
      faces += " " + corner(i) + (is_obj ? "/1" : "");
    faces += "\n";
  };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 4; ++k) {
      const int a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      add(a, b, b + 4);
      add(a, b + 4, a + 4);
    }
  add(0, 3, 2);
  add(0, 2, 1);
  add(4 * n, 4 * n + 1, 4 * n + 2);
  add(4 * n, 4 * n + 2, 4 * n + 3);
  if (is_obj)
    return vertices + "vt 0 0\n" + faces;
  return "OFF\n" + std::to_string(4 * n + 4) + " " + std::to_string(number_of_faces) + " 0\n" + vertices + faces;
}

std::string written(const Temporary_directory& directory, const std::string& name, const std::string& content)
{
  std::ofstream(directory.file(name)) << content;
  return directory.file(name);
}

} // namespace

TEST_CASE("A mesh whose reading is cancelled stays what it was", "[cancel]")
{
  const Temporary_directory directory;
  for (const std::string format : {"off", "obj"})
    for (const bool is_repaired : {false, true}) {
      const std::string file = written(directory, "tube." + format, tube(format, 5000));
      check_cancelling([&](const auto& visitor) {
        Surface_mesh mesh;
        const auto report = T::read_triangle_mesh(file, mesh, T::parameters::repair(is_repaired).visitor(visitor));
        const bool is_interrupted = report.status == T::Mesh_reading_status::INTERRUPTED;
        CHECK((mesh.number_of_vertices() == 0) == is_interrupted);
        return is_interrupted;
      });
    }
}

TEST_CASE("A map whose reading is cancelled stays empty", "[cancel]")
{
  const Temporary_directory directory;
  const std::string file = written(directory, "map.obj", tube("obj", 1000));
  check_cancelling([&](const auto& visitor) {
    Surface_mesh mesh;
    const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    const auto report = T::read_map_obj(file, mesh, uv, CGAL::parameters::visitor(visitor));
    const bool is_interrupted = report.status == T::Mesh_reading_status::INTERRUPTED;
    CHECK((mesh.number_of_vertices() == 0) == is_interrupted);
    return is_interrupted;
  });
}

TEST_CASE("A T-mesh whose reading is cancelled stays empty", "[cancel]")
{
  const std::string file = std::string(T_SPLINES_TEST_DATA) + "/good_t_meshes/t_joints.ply";
  check_cancelling([&](const auto& visitor) {
    T_mesh_with_maps<Surface_mesh> t;
    const auto report =
        T::read_t_mesh(file, t.view(), T::parameters::vertex_weight_map(t.weight_map()).visitor(visitor));
    const bool is_interrupted = report.status == T::T_mesh_reading_status::INTERRUPTED;
    CHECK((t.graph.number_of_vertices() == 0) == is_interrupted);
    return is_interrupted;
  });
}

} // namespace cancelling_test
