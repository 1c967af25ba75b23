// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program does with features, and with the scale factors that it is asked for.

#include "../feature_meshes.h"
#include "Program_test.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace features_test {

namespace {

std::string written(const Temporary_directory& directory, const feature_meshes::Mesh& mesh)
{
  const std::string name = directory.file("mesh.off");
  REQUIRE(CGAL::IO::write_polygon_mesh(name, mesh, CGAL::parameters::stream_precision(17)));
  return name;
}

/// The numbers that the page has under a name.
template <typename Number>
std::vector<Number> page_data(const std::string& page, const std::string& name)
{
  const std::string start = "id=\"" + name + "\">",
                    digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::size_t i = page.find(start);
  REQUIRE(i != std::string::npos);
  std::string bytes;
  unsigned int bits = 0;
  int number_of_bits = 0;
  for (i += start.size(); page[i] != '=' && page[i] != '<'; ++i) {
    bits = (bits << 6 | static_cast<unsigned int>(digits.find(page[i]))) & 0xffff;
    number_of_bits += 6;
    if (number_of_bits >= 8) {
      number_of_bits -= 8;
      bytes.push_back(static_cast<char>(bits >> number_of_bits & 0xff));
    }
  }
  std::vector<Number> result(bytes.size() / sizeof(Number));
  std::memcpy(result.data(), bytes.data(),
              result.size() * sizeof(Number)); // this machine's numbers are little endian, too
  return result;
}

/// The least cosine of the angle between a triangle that the page draws and a normal at one of its corners.
double least_cosine_of_drawing(const std::string& page)
{
  const auto points = page_data<float>(page, "spline_points");
  const auto normals = page_data<std::int16_t>(page, "spline_normals");
  const auto triangles = page_data<std::uint32_t>(page, "spline_triangles");
  REQUIRE(points.size() == normals.size());
  REQUIRE(triangles.size() > 0);
  const auto point = [&](const std::size_t i) {
    return Kernel::Point_3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  };
  double result = 1;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const Kernel::Vector_3 n = CGAL::cross_product(point(triangles[t + 1]) - point(triangles[t]),
                                                   point(triangles[t + 2]) - point(triangles[t]));
    for (std::size_t k = t; k < t + 3; ++k) {
      const std::size_t i = 3 * triangles[k];
      const Kernel::Vector_3 m(normals[i], normals[i + 1], normals[i + 2]);
      result = (std::min)(result, n * m / std::sqrt(n.squared_length() * m.squared_length()));
    }
  }
  return result;
}

} // namespace

TEST_CASE("sharp edges become edges of the T-mesh, which is said, and the surface is within the tolerance")
{
  const Temporary_directory directory;
  const std::string mesh = written(directory, feature_meshes::bracket_with_hole(2)), output = directory.file("output");
  const Program_run run("'" + mesh + "' --feature-angle 40 -o '" + output + "'");
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "edges in the map lie on isolines, exactly"));
  CHECK(contains(run.output, "all scale factors are 1"));
  const std::string report = file_content(output + "/report.json");
  CHECK(contains(report, "\"edges_not_met\": 0"));
  CHECK(contains(report, "\"is_aligned\": true"));
  CHECK(contains(run.output, "within the tolerance"));
  CHECK(number_after(report, "\"t_spline\": {", "creases") > 0);
  CHECK(least_cosine_of_drawing(file_content(output + "/report.html")) > 0.9); // not the normal of the other side
  const std::optional<std::string> page = page_in_browser(output, "view=reflection&edges=1");
  if (!page) {
    WARN("no chromium that runs: the page was not tried");
    return;
  }
  CHECK(contains(*page, "<th scope=\"row\">creases (edges)</th>"));
  CHECK(contains(*page, "</span>creases: edges along which the surface is sharp</p>"));
  CHECK(contains(*page, "<label><input type=\"checkbox\">creases</label>"));
  CHECK(contains(*page, "<p id=\"message\" hidden=\"\"></p>"));
}

TEST_CASE("features are looked for where they divide the surface into sides, unless that is not wanted")
{
  const Temporary_directory directory;
  const std::string part = written(directory, feature_meshes::bracket_with_hole(2)), output = directory.file("output"),
                    animal = std::string(T_SPLINES_DEMO_DATA) + "/meshes/cow.off"; // 14 ridges
  const auto has_features = [&](const std::string& mesh, const std::string& options) {
    const Program_run run("'" + mesh + "' --no-spline " + options + " -o '" + output + "'");
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    const bool result = contains(run.output, "  features    ");
    CHECK(contains(file_content(output + "/report.json"), "\"features\": {") == result);
    return result;
  };
  CHECK(has_features(part, ""));
  CHECK_FALSE(has_features(part, "--no-features"));
  CHECK_FALSE(has_features(animal, ""));
  CHECK(has_features(animal, "--feature-angle 40"));
}

TEST_CASE("features come from a file")
{
  const Temporary_directory directory;
  const feature_meshes::Mesh cube = feature_meshes::cube(4);
  const std::string mesh = written(directory, cube), features = directory.file("features.txt"),
                    output = directory.file("output");
  {
    std::ofstream file(features);
    for (const auto e : cube.edges())
      if (feature_meshes::is_dart_of_cube(cube, e))
        file << static_cast<int>(source(e, cube)) << " " << static_cast<int>(target(e, cube)) << "\n";
  }
  const Program_run run("'" + mesh + "' --features '" + features + "' --no-spline -o '" + output + "'");
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "edges from features.txt in 1 arc,"));
}

TEST_CASE("features that are refused are named, with the file, and nothing is written")
{
  const Temporary_directory directory;
  const std::string mesh = written(directory, feature_meshes::cube(2)), features = directory.file("features.txt"),
                    output = directory.file("output");
  const auto refused = [&](const std::string& options, const std::string& reason) {
    const Program_run run("'" + mesh + "' " + options + " -o '" + output + "'");
    CAPTURE(options, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, reason));
    CHECK_FALSE(std::filesystem::exists(output + "/report.json"));
  };
  const auto of_file = [&](const std::string& content, const std::string& reason) {
    std::ofstream(features) << content;
    refused("--features '" + features + "'", features + ": " + reason);
  };
  of_file("0 99999\n", "line 1");
  of_file("0 1 2\n", "line 1");
  refused("--features '" + directory.file("none.txt") + "'", "none.txt");
  refused("--features '" + features + "' --feature-angle 40", "exclude each other");
  refused("--feature-angle 0", "--feature-angle needs a positive number");
  refused("--feature-angle 40 --fill-holes 8", "exclude each other");
  refused("--feature-angle 40 --cones x.cones", "is for the computed field");
  refused("--feature-angle 40 --no-features", "exclude each other");
  refused("--scale large", "--scale needs one of auto, as-is, unit, dyadic");
}

TEST_CASE("scale factors become 1 where that is asked for, and it is said where there is no such map")
{
  const Temporary_directory directory;
  const std::string meshes = std::string(T_SPLINES_DEMO_DATA) + "/meshes/", output = directory.file("output");
  const Program_run unit("'" + meshes + "eight.off' --scale unit --no-spline -o '" + output + "'");
  INFO(unit.errors);
  REQUIRE(unit.exit_code == 0);
  CHECK(contains(unit.output, "all scale factors are 1"));
  // A torus without cones whose loops turn.
  const Program_run none("'" + meshes + "torus_quad.off' --scale unit --no-spline -o '" + output + "'");
  CHECK((none.exit_code == 1 || contains(none.output, "all scale factors are 1")));
  if (none.exit_code == 1)
    CHECK(contains(none.errors, "no map with the scale factors that were asked for was found"));
}

} // namespace features_test
