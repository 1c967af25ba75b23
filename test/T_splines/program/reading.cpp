// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program says of meshes that it reads, merges, repairs and refuses; its lines of progress; what it leaves in
// the directory of an earlier run.

#include "../IO/Soup.h"
#include "Cube_map.h"
#include "Map_run.h"
#include "Program_test.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace reading_test {

namespace {

using Names = std::set<std::string>;

Soup box()
{
  Soup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  return soup;
}

} // namespace

TEST_CASE("merged vertices are told in the note and in the report")
{
  Soup soup = box().split();
  soup.points[0][0] += 1e-8;
  const Map_run merged(soup, ".ply", "");
  CAPTURE(merged.run.errors);
  REQUIRE(merged.run.exit_code == 0);
  CHECK(contains(merged.run.errors, "note: "));
  CHECK(contains(merged.run.errors, "16 vertices were merged into others, at most 1e-08 of the longest side apart"));
  CHECK(contains(merged.report(), "\"merged_vertices\": 16"));
  const std::string member = "\"merged_distance\": ", report = merged.report();
  REQUIRE(contains(report, member));
  CHECK(std::strtod(report.c_str() + report.find(member) + member.size(), nullptr) == Approx(1e-8));

  const Map_run refused(soup, ".ply", "--no-merge");
  CHECK(refused.run.exit_code == 2);
  CHECK(contains(refused.run.errors, "24 boundary edges in 6 loops, whose ends lie within 1e-08 of the longest side"));
  CHECK(contains(refused.run.errors, "; --merge 1e-08 closes it\n"));
  CHECK(Map_run(soup, ".ply", "--merge 1e-8").run.exit_code == 0);
  CHECK(Map_run(soup, ".ply", "--merge 9e-9").run.exit_code == 2);
}

TEST_CASE("a refusal names the option that helps, and that helps")
{
  Soup soup = box();
  soup.faces.push_back({0, 0, 1});
  const Map_run refused(soup, ".stl", "");
  CHECK(refused.run.exit_code == 2);
  CHECK(contains(refused.run.errors, "a face has the same vertex twice"));
  CHECK(contains(refused.run.errors, "; --repair mends it"));
  const Map_run repaired(soup, ".stl", "--repair");
  CAPTURE(repaired.run.errors);
  CHECK(repaired.run.exit_code == 0);
  CHECK(contains(repaired.run.errors, "repaired: 1 degenerate face removed"));
  CHECK(contains(repaired.report(), "\"degenerate_faces\": 1"));

  soup = box();
  soup.faces.pop_back();
  const Map_run open(soup, ".off", "");
  CHECK(open.run.exit_code == 0);
  CHECK(contains(open.run.errors, "note: "));
  CHECK(contains(open.run.errors, "the surface is open, with 4 boundary edges in 1 loop"));
  CHECK(contains(open.report(), "\"borders\": 1"));
}

TEST_CASE("every refusal of a file ends with what to do")
{
  for (const auto& entry : std::filesystem::directory_iterator(data + "bad_meshes")) {
    const Program_run run = failing_run("'" + entry.path().string() + "'");
    CAPTURE(entry.path(), run.errors);
    const std::size_t advice = run.errors.rfind("; ");
    REQUIRE(advice != std::string::npos);
    CHECK(run.errors.size() > advice + 10);
    if (contains(run.errors, "--repair")) {
      const Temporary_directory directory;
      const Program_run repaired("'" + entry.path().string() + "' --repair --map-only -o '" + directory.file("o") +
                                 "'");
      CAPTURE(repaired.errors);
      CHECK(repaired.exit_code == 0);
    }
  }
  CHECK(contains(failing_run("no_such_file.off").errors, "check the name of the file"));
}

TEST_CASE("where errors do not go to a terminal, there is a line per stage with its time")
{
  const Map_run map(box(), ".off", "");
  REQUIRE(map.run.exit_code == 0);
  CHECK_FALSE(contains(map.run.errors, "\r"));
  CHECK_FALSE(contains(map.run.errors, "\033"));
  std::istringstream lines(map.run.errors);
  std::size_t number_of_stages = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 2 && line.substr(line.size() - 2) == " s") {
      ++number_of_stages;
      CHECK(line.find_first_of("0123456789") != std::string::npos);
    }
  CHECK(number_of_stages >= 5);
  for (const char* stage : {"reading ", "cross field", "writing "})
    CHECK(contains(map.run.errors, stage));
}

TEST_CASE("files of an earlier run do not stay beside those of a new one")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output"),
                    arguments = "'" + data + "good_meshes/cube.obj' -o '" + output + "' ";
  const Names map_files = {"map.obj", "report.html", "report.json"};
  REQUIRE(Program_run(arguments + "--levels").exit_code == 0);
  REQUIRE(files_of(output).count("level_0.ply") == 1);
  const Names all_files = files_of(output);
  for (const char* name : {"level_12.ply", "level_07.ply", "level_x.ply", "level_1.obj", "notes.txt", "t_mesh.ply.bak"})
    std::ofstream(output + "/" + name) << "x";
  std::filesystem::create_directory(output + "/level_99.ply");

  REQUIRE(Program_run(arguments + "--max-iterations 1 --tolerance-residual 1e-300").exit_code == 1);
  for (const std::string& name : all_files) // a run that fails touches nothing
    CHECK(files_of(output).count(name) == 1);

  REQUIRE(Program_run(arguments + "--map-only").exit_code == 0);
  Names expected = map_files;
  for (const char* name : {"level_07.ply", "level_x.ply", "level_1.obj", "notes.txt", "t_mesh.ply.bak", "level_99.ply"})
    expected.insert(name);
  CHECK(files_of(output) == expected);
}

TEST_CASE("files in a directory without an earlier run, and input files, are not removed")
{
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  std::filesystem::create_directory(output);
  std::ofstream(output + "/t_spline.vtu") << "of someone else";
  Cube_map(2).write(output + "/map.obj");
  const std::string arguments = "--uv '" + output + "/map.obj' --no-spline -o '" + output + "'";
  REQUIRE(Program_run(arguments).exit_code == 0);
  CHECK(file_content(output + "/t_spline.vtu") == "of someone else");
  REQUIRE(Program_run(arguments).exit_code == 0); // now there is an earlier run
  CHECK(files_of(output) == Names{"map.obj", "report.html", "report.json", "t_mesh.ply"});
}

TEST_CASE("a run does not replace its own input")
{
  const Temporary_directory directory;
  const std::string folder = directory.path().string();
  for (const char* name : {"map.obj", "t_mesh.ply", "t_spline.obj", "level_3.ply"}) {
    box().write(folder + "/" + name);
    const std::string content = file_content(folder + "/" + name);
    const Program_run run("'" + folder + "/" + name + "' --levels -o '" + folder + "/.'");
    CAPTURE(name, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.errors, "the output would replace the input"));
    CHECK(file_content(folder + "/" + name) == content);
  }
  CHECK(Program_run("'" + folder + "/t_spline.obj' --map-only -o '" + folder + "'").exit_code == 0);
}

} // namespace reading_test
