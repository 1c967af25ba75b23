// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program does with features, and with the scale factors that it is asked for.

#include "../feature_meshes.h"
#include "Program_test.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
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
