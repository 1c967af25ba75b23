// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Program_test.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/is_spline_compatible.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

using Surface = CGAL::T_splines::T_spline_surface<Mesh, decltype(Test_t_mesh::knots), decltype(Test_t_mesh::corners),
                                                  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>>;

/// All numbers that stand under a name in a report, in their order.
std::vector<double> numbers(const std::string& json, const std::string& name)
{
  const std::regex pattern("\"" + name + "\": ([-+.0-9e]+)");
  std::vector<double> result;
  for (std::sregex_iterator i(json.begin(), json.end(), pattern), end; i != end; ++i)
    result.push_back(std::stod((*i)[1]));
  return result;
}

double longest_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::max({box.x_span(), box.y_span(), box.z_span()});
}

/// The vertices of an OBJ file.
std::vector<Kernel::Point_3> obj_points(const std::string& name)
{
  std::istringstream file(file_content(name));
  std::vector<Kernel::Point_3> points;
  std::string line;
  double x, y, z;
  while (std::getline(file, line))
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3)
      points.emplace_back(x, y, z);
  return points;
}

/// Reads the surface of a run, and the mesh that it approximates.
struct Fitted {
  Mesh input;
  Test_t_mesh t_mesh;

  Fitted(const std::string& mesh_file, const std::string& t_mesh_file)
  {
    REQUIRE(CGAL::T_splines::read_triangle_mesh(mesh_file, input).success());
    REQUIRE(t_mesh.read(t_mesh_file).success());
  }
  Surface surface() const { return Surface(t_mesh.mesh, t_mesh.knots, t_mesh.corners, t_mesh.mesh.points()); }
};

} // namespace

TEST_CASE("the surface is within the tolerance, and its files tell the same surface")
{
  const Temporary_directory directory;
  const std::string mesh = directory.file("torus.obj"), output = directory.file("output");
  write_torus(mesh, 20, 0, 1);
  const double tolerance = 0.002;
  const Program_run run("'" + mesh + "' --tolerance 0.002 --samples 4000 --resolution 4 -o '" + output + "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "the surface is within the tolerance (0.2 %)"));
  CHECK_FALSE(contains(run.output, "beyond the tolerance"));

  Fitted fitted(mesh, output + "/t_mesh.ply");
  const Surface surface = fitted.surface();
  REQUIRE(surface.is_valid());
  const auto distance = fitted.input.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  REQUIRE(CGAL::T_splines::measure_T_spline_deviation(surface, fitted.input,
                                                      CGAL::T_splines::parameters::vertex_distance_map(distance)));
  const double largest_distance = *std::max_element(distance.begin(), distance.end());
  CHECK(largest_distance < 1.1 * tolerance * longest_side(fitted.input)); // the tessellation deviates, too
  const std::string report = file_content(output + "/report.json");
  CHECK(numbers(report, "tolerance").back() == tolerance);
  CHECK(contains(report, "\"is_within_tolerance\": true"));
  CHECK(contains(report, "\"surface_to_mesh\": {"));

  Mesh tessellation;
  CGAL::T_splines::tessellate_T_spline(CGAL::T_splines::compile_T_spline(surface), 4, tessellation);
  const std::vector<Kernel::Point_3> points = obj_points(output + "/t_spline.obj");
  REQUIRE(points.size() == tessellation.number_of_vertices());
  const CGAL::T_splines::Mesh_distance distance_from_surface(tessellation);
  double largest = 0;
  for (const Kernel::Point_3& p : points)
    largest = std::max(largest, distance_from_surface(p));
  CHECK(largest < 1e-12 * longest_side(fitted.input));
}

TEST_CASE("the levels are written, from coarse to fine, and the best is the surface")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run(tetrahedron + " --levels --samples 3000 -o '" + output + "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  const std::string report = file_content(output + "/report.json");
  std::vector<double> control_points = numbers(report, "control_points");
  REQUIRE(control_points.size() >= 3);
  const auto best = static_cast<std::size_t>(numbers(report, "best_level").at(0));
  const double of_surface = control_points.front();
  control_points.erase(control_points.begin());
  CHECK(control_points.at(best) == of_surface);
  CHECK(std::is_sorted(control_points.begin(), control_points.end()));
  for (std::size_t i = 0; i < control_points.size(); ++i) {
    Test_t_mesh level;
    REQUIRE(level.read(output + "/level_" + std::to_string(i) + ".ply").success());
    CHECK(static_cast<double>(level.mesh.number_of_vertices()) == control_points[i]);
    CHECK(CGAL::T_splines::is_spline_compatible(level.mesh, level.knots, level.corners).success());
  }
  CHECK_FALSE(std::filesystem::exists(output + "/level_" + std::to_string(control_points.size()) + ".ply"));
  CHECK(file_content(output + "/t_mesh.ply") == file_content(output + "/level_" + std::to_string(best) + ".ply"));
  CHECK(contains(run.output, "level_0.ply to level_" + std::to_string(control_points.size() - 1) + ".ply, "));
}

TEST_CASE("a limit on the control points is obeyed, and a surface beyond the tolerance is written and called so")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run(tetrahedron + " --tolerance 0.0001 --max-control-points 700 --samples 3000 -o '" + output +
                        "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "ended beyond the tolerance: the allowed number of control points is reached"));
  CHECK(contains(file_content(output + "/report.json"), "\"is_within_tolerance\": false"));
  Test_t_mesh t_mesh;
  REQUIRE(t_mesh.read(output + "/t_mesh.ply").success());
  CHECK(t_mesh.mesh.number_of_vertices() <= 700);
}

TEST_CASE("limits on control points and cones that cannot be kept are refused with exit code 2 and the numbers")
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--max-control-points 10",
       "--max-control-points 10: the coarsest surface needs more control points than allowed: "},
      {"--max-control-points 4000 --samples 3000",
       "--max-control-points 4000: more control points are allowed than there are samples: 30"},
      {"--samples 5", "the coarsest surface needs more control points than allowed: "},
      {"--max-cones 2", "--max-cones 2: the surface cannot do with so few cones; the fewest possible are 3"}};
  for (const auto& [arguments, message] : cases) {
    const Program_run run = failing_run(tetrahedron + " " + arguments);
    CAPTURE(arguments, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, message));
  }
}

TEST_CASE("cones of the computed field are merged, to fewer if that is asked for, or not at all")
{
  const Temporary_directory directory;
  const std::string torus = directory.file("torus.obj"), output = directory.file("output");
  write_torus(torus, 20, 0, 1);
  const auto number_of_cones = [&](const std::string& arguments) {
    const Program_run run(arguments + " --map-only -o '" + output + "'");
    CAPTURE(arguments, run.errors);
    REQUIRE(run.exit_code == 0);
    return numbers(file_content(output + "/report.json"), "vertex").size();
  };
  const std::size_t all = number_of_cones("'" + torus + "' --all-cones");
  CHECK(all > 0);
  CHECK(number_of_cones("'" + torus + "' --cone-energy 0") <= all);
  CHECK(number_of_cones("'" + torus + "'") == 0);
  const std::string cube = "'" + data + "good_meshes/cube.obj'";
  CHECK(number_of_cones(cube) > 3);
  CHECK(number_of_cones(cube + " --max-cones 3") == 3);
}

TEST_CASE("a directory without permission to write is refused with exit code 2")
{
  const Temporary_directory directory;
  std::filesystem::permissions(directory.path(),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  // Whoever may do everything becomes no one.
  const std::string prefix = ::geteuid() == 0 ? "setpriv --reuid=65534 --clear-groups" : "";
  if (std::system((prefix + " test -x '" T_SPLINES_EXAMPLES_DIR "/mesh_to_t_spline'").c_str()) != 0) {
    WARN("this user cannot give up its rights: the permission was not tried");
    return;
  }
  const Program_run run(tetrahedron + " -o '" + directory.file("output") + "'", prefix);
  CAPTURE(run.errors);
  CHECK(run.exit_code == 2);
  CHECK(contains(run.errors, directory.path().string() + ": Permission denied"));
}

TEST_CASE("an interruption while the surface is fitted has exit code 130 and leaves nothing behind")
{
  const Temporary_directory directory;
  write_torus(directory.file("torus.obj"), 20, 0, 1);
  const std::string mesh = "'" + directory.file("torus.obj") + "'", samples = " --samples 200000";
  // What goes before the fit ends in less time than the run is given.
  const std::string prefix = "timeout --foreground --signal=INT --preserve-status 4";
  CHECK(Program_run(mesh + " --no-spline -o '" + directory.file("before") + "'", prefix).exit_code == 0);
  const Program_run run = failing_run(mesh + " --tolerance 1e-9 --levels" + samples, prefix);
  CAPTURE(run.errors);
  CHECK(run.exit_code == 130);
  CHECK(contains(run.errors, "interrupted"));
}
