// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Program_test.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/Spline/Mesh_distance.h>
#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/measure_T_spline_deviation.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Random.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <unistd.h>

namespace fitting_test {

namespace {

using Surface = Test_t_mesh::Surface;

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
  Surface surface() const { return t_mesh.surface(); }
};

} // namespace

TEST_CASE("the surface is within the tolerance, and the files tell the same surface")
{
  const Temporary_directory directory;
  const std::string mesh = directory.file("torus.obj"), output = directory.file("output");
  write_torus(mesh, 20, 0, 1);
  const double tolerance = 0.002;
  const Program_run run("'" + mesh + "' --tolerance 0.002 --resolution 4 -o '" + output + "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "the surface is within the tolerance (0.2 %)"));

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
  CHECK(contains(report, "\"fit_is_within_tolerance\": true"));
  const bool is_within = numbers(report.substr(report.find("\"deviation\": {")), "maximum").at(0) <= tolerance;
  CHECK(contains(report, std::string("\"is_within_tolerance\": ") + (is_within ? "true" : "false")));
  CHECK(contains(run.output, std::string("deviation   ") + (is_within ? "within" : "beyond") + " the tolerance"));
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

TEST_CASE("random points find no larger distance than the report has")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output"), plate = directory.file("plate.off");
  std::ofstream(plate) << "OFF\n8 12 0\n0 0 0\n20 0 0\n20 20 0\n0 20 0\n0 0 2\n20 0 2\n20 20 2\n0 20 2\n"
                          "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n"
                          "3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n";
  for (const std::string& mesh : {plate, std::string(T_SPLINES_DEMO_DATA "/meshes/eight.off")}) {
    const Program_run run("'" + mesh + "' --max-control-points 1500 --quiet -o '" + output + "'");
    CAPTURE(mesh, run.errors);
    REQUIRE(run.exit_code == 0);
    const Fitted fitted(mesh, output + "/t_mesh.ply");
    const auto patches = CGAL::T_splines::compile_T_spline(fitted.surface());
    const CGAL::T_splines::Mesh_distance distance(fitted.input);
    const CGAL::T_splines::T_spline_closest_point<std::decay_t<decltype(patches)>> closest(patches);
    CGAL::Random random(3);
    double to_mesh = 0, to_surface = 0;
    for (std::size_t i = 0; i < patches.number_of_patches(); ++i)
      for (int k = 0; k < 20; ++k)
        to_mesh = std::max(to_mesh, distance(patches.patch(i).position(random.get_double(), random.get_double())));
    const std::size_t per_face = 1 + 20000 / fitted.input.number_of_faces();
    for (const Mesh::Face_index f : fitted.input.faces()) {
      std::vector<Kernel::Point_3> p;
      for (const Mesh::Vertex_index v : fitted.input.vertices_around_face(fitted.input.halfedge(f)))
        p.push_back(fitted.input.point(v));
      for (std::size_t k = 0; k < per_face; ++k) {
        const double a = random.get_double(), b = random.get_double();
        to_surface = std::max(
            to_surface, closest(p[0] + std::min(a, b) * (p[1] - p[0]) + (1 - std::max(a, b)) * (p[2] - p[0])).distance);
      }
    }
    const std::string report = file_content(output + "/report.json");
    const std::string deviation = report.substr(report.find("\"deviation\": {"));
    const std::vector<double> maxima = numbers(deviation, "maximum"), bounds = numbers(deviation, "upper_bound");
    REQUIRE(maxima.size() >= 3);    // both ways, surface to mesh, mesh to surface
    const double round_off = 1e-14; // of a plate, all that is left
    CHECK(to_mesh <= (1.02 * maxima[1] + round_off) * longest_side(fitted.input));
    CHECK(to_surface <= (1.02 * maxima[2] + round_off) * longest_side(fitted.input));
    CHECK(maxima[0] == std::max(maxima[1], maxima[2]));
    for (int i = 0; i < 3; ++i)
      CHECK(bounds[i] >= maxima[i]);
    CHECK(contains(report, "\"is_within_tolerance\": " + std::string(maxima[0] <= 0.005 ? "true" : "false")));
    std::filesystem::remove_all(output);
  }
}

TEST_CASE("the sides of a tetrahedron, one triangle each, are met though the surface folds at its vertices at first")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run("'" T_SPLINES_DEMO_DATA "/meshes/reference_tetrahedron.off' -o '" + output + "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(file_content(output + "/report.json"), "\"verdict\": \"within the tolerance\""));
}

TEST_CASE("the levels are written, and the best is the surface")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run(tetrahedron + " --no-features --levels -o '" + output + "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  const std::string report = file_content(output + "/report.json");
  std::vector<double> control_points = numbers(report, "control_points");
  REQUIRE(control_points.size() >= 3);
  const auto best = static_cast<std::size_t>(numbers(report, "best_level").at(0));
  const double of_surface = control_points.front();
  control_points.erase(control_points.begin());
  CHECK(control_points.at(best) == of_surface);
  CHECK(control_points.back() > control_points.front());
  for (std::size_t i = 0; i < control_points.size(); ++i) {
    Test_t_mesh level;
    REQUIRE(level.read(output + "/level_" + std::to_string(i) + ".ply").success());
    CHECK(static_cast<double>(level.graph().number_of_vertices()) == control_points[i]);
    CHECK(CGAL::T_splines::check_spline_compatibility(level).success());
  }
  CHECK_FALSE(std::filesystem::exists(output + "/level_" + std::to_string(control_points.size()) + ".ply"));
  CHECK(file_content(output + "/t_mesh.ply") == file_content(output + "/level_" + std::to_string(best) + ".ply"));
  CHECK(contains(run.output, "level_0.ply to level_" + std::to_string(control_points.size() - 1) + ".ply, "));
}

TEST_CASE("a limit on the control points is obeyed, and a surface beyond the tolerance is written and called so")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run(tetrahedron + " --no-features --tolerance 0.0001 --max-control-points 700 -o '" + output + "'");
  CAPTURE(run.errors, run.output);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "ended beyond the tolerance: more control points would be needed than are allowed"));
  CHECK(contains(file_content(output + "/report.json"), "\"is_within_tolerance\": false"));
  Test_t_mesh t_mesh;
  REQUIRE(t_mesh.read(output + "/t_mesh.ply").success());
  CHECK(t_mesh.graph().number_of_vertices() <= 700);
}

TEST_CASE("limits on control points and cones that cannot be kept are refused with exit code 2 and the numbers")
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--no-features --max-control-points 10",
       "--max-control-points 10: the coarsest surface needs more control points than allowed: "},
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
  CHECK(number_of_cones(cube) == 8);
  CHECK(number_of_cones(cube + " --max-cones 3") == 3); // although its edges need more
}

TEST_CASE("a directory without permission to write is refused with exit code 2")
{
  const Temporary_directory directory;
  std::filesystem::permissions(directory.path(),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  // The superuser may write everywhere: the program runs as a user without rights.
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
  const std::string mesh = "'" + directory.file("torus.obj") + "'";
  // What goes before the fit ends in less time than the run is given.
  const std::string prefix = "timeout --foreground --signal=INT --preserve-status 4";
  CHECK(Program_run(mesh + " --no-spline -o '" + directory.file("before") + "'", prefix).exit_code == 0);
  const Program_run run = failing_run(mesh + " --tolerance 1e-9 --max-control-points 1000000 --levels", prefix);
  CAPTURE(run.errors);
  CHECK(run.exit_code == 130);
  CHECK(contains(run.errors, "interrupted"));
}

} // namespace fitting_test
