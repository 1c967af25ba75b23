// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program does with open meshes, and with the corners that it is given.

#include "../IO/Soup.h"
#include "Map_run.h"
#include "Program_test.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace border_test {

namespace {

/// A rectangle of n x m squares. The vertex at (i, j) has the number j (n + 1) + i.
Soup plate(const std::size_t n, const std::size_t m)
{
  Soup soup;
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      soup.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t v = j * (n + 1) + i;
      soup.faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  return soup;
}

std::vector<std::array<double, 3>> vertices_of_obj(const std::string& file)
{
  std::vector<std::array<double, 3>> result;
  std::ifstream lines(file);
  std::string line, word;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::array<double, 3> p{};
    if (words >> word && word == "v" && words >> p[0] >> p[1] >> p[2])
      result.push_back(p);
  }
  return result;
}

std::string written(const Temporary_directory& directory, const std::string& text)
{
  const std::string name = directory.file("corners.bcones");
  std::ofstream(name) << text;
  return name;
}

} // namespace

TEST_CASE("a plate becomes a flat surface that ends where it ends, and meets its corners")
{
  const Temporary_directory directory;
  const std::string mesh = directory.file("plate.off"), output = directory.file("output");
  plate(8, 5).write(mesh);
  const Program_run run("'" + mesh + "' -o '" + output + "'");
  CAPTURE(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.output, "a border of 1 curve"));
  CHECK(contains(run.output, "0 cones, 4 corners (k = 1: 4)"));
  const std::vector<std::array<double, 3>> points = vertices_of_obj(output + "/t_spline.obj");
  REQUIRE(points.size() > 4);
  for (const auto& p : points) {
    REQUIRE(std::abs(p[2]) <= 1e-12);
    REQUIRE(std::max(std::abs(p[0] - 4) - 4, std::abs(p[1] - 2.5) - 2.5) <= 1e-9);
  }
  for (const std::array<double, 2>& corner : {std::array<double, 2>{0, 0}, {8, 0}, {8, 5}, {0, 5}})
    CHECK(std::any_of(points.begin(), points.end(), [&](const std::array<double, 3>& p) {
      return std::abs(p[0] - corner[0]) <= 1e-9 && std::abs(p[1] - corner[1]) <= 1e-9;
    }));
}

TEST_CASE("corners are found, given, or left out")
{
  const Map_run found(plate(8, 5), ".off", "");
  REQUIRE(found.run.exit_code == 0);
  CHECK(contains(found.run.output, "0 cones, 4 corners (k = 1: 4)"));
  const Map_run blunt(plate(8, 5), ".off", "--corner-angle 100");
  REQUIRE(blunt.run.exit_code == 0);
  CHECK_FALSE(contains(blunt.run.output, "corner"));
  const Map_run none(plate(8, 5), ".off", "--no-corners");
  REQUIRE(none.run.exit_code == 0);
  CHECK_FALSE(contains(none.run.output, "corner"));
  const Temporary_directory directory;
  const Map_run given(plate(8, 5), ".off", "--corners '" + written(directory, "0 1\n8 1\n53 1\n45 1\n") + "'");
  CAPTURE(given.run.errors);
  REQUIRE(given.run.exit_code == 0);
  CHECK(contains(given.run.output, "4 corners (k = 1: 4)"));
  for (const char* vertex : {"0", "8", "45", "53"})
    CHECK(contains(given.report(), std::string("\"vertex\": ") + vertex + ","));
  // At places where the border is straight.
  const Map_run elsewhere(plate(8, 5), ".off", "--corners '" + written(directory, "0 1\n8 1\n4 1\n53 1\n") + "'");
  CAPTURE(elsewhere.run.errors);
  REQUIRE(elsewhere.run.exit_code == 0);
  CHECK(contains(elsewhere.report(), "\"vertex\": 4,"));
}

TEST_CASE("corners that cannot be are refused, with the file and the vertex")
{
  const Temporary_directory directory;
  const auto refusal = [&](const std::string& text) {
    const Map_run run(plate(8, 5), ".off", "--corners '" + written(directory, text) + "'");
    CHECK(run.run.exit_code == 2);
    CHECK(contains(run.run.errors, "corners.bcones: "));
    CHECK_FALSE(std::filesystem::exists(run.output));
    return run.run.errors;
  };
  CHECK(contains(refusal("0 1\n20 1\n"), "a corner is not on the border; make it a cone: vertex 20, counted from 0"));
  CHECK(contains(refusal("0 1\n0 1\n"), "corners.bcones: line 2"));
  CHECK(contains(refusal("0 0\n"), "corners.bcones: line 1"));
  CHECK(contains(refusal("99 1\n"), "corners.bcones: line 1"));
  CHECK(contains(refusal("0 1 8\n"), "corners.bcones"));
  CHECK(contains(failing_run("x.off --corners a.bcones --no-corners").errors, "--corners and --no-corners"));
  CHECK(contains(failing_run("x.off --corners a.bcones --corner-angle 30").errors, "--corners and --corner-angle"));
  CHECK(contains(failing_run("x.off --no-corners --corner-angle 30").errors, "--corner-angle and --no-corners"));
  CHECK(contains(failing_run("x.off --corner-angle 0").errors, "--corner-angle"));
}

namespace {

/// The rectangle [0, 24] x [0, 16] in steps of 1/2, with a notch from below, 0.8 deep and 0.08 wide, and its corners.
Soup notched_plate()
{
  Soup soup = plate(48, 32);
  for (std::size_t j = 0; j <= 32; ++j)
    for (std::size_t i = 0; i <= 48; ++i) {
      auto& p = soup.points[j * 49 + i];
      p = {i / 2., j / 2., 0};
      if (i == 24)
        p[1] += 0.8 * (1 - p[1] / 16);
      else if (j == 0 && (i == 23 || i == 25))
        p[0] = i == 23 ? 11.96 : 12.04;
    }
  return soup;
}

/// A run on it with its four corners, which must end well.
struct Notched_run {
  const Temporary_directory directory;
  const std::string output = directory.file("output");
  const Program_run run;
  const std::string report;

  explicit Notched_run(const std::string& options)
    : run(command(options)),
      report(file_content(output + "/report.json"))
  {
    CAPTURE(run.output, run.errors);
    REQUIRE(run.exit_code == 0);
  }

private:
  std::string command(const std::string& options) const
  {
    const std::string mesh = directory.file("notch.off");
    notched_plate().write(mesh);
    return "'" + mesh + "' --corners '" + written(directory, "0 1\n48 1\n1616 1\n1568 1\n") + "' " + options + " -o '" +
           output + "'";
  }
};

} // namespace

TEST_CASE("the distance between the borders is reported, drawn and within the tolerance")
{
  const Notched_run notched("--tolerance 0.01");
  CHECK(contains(notched.run.output, "deviation   within the tolerance"));
  CHECK(contains(notched.run.output, "free edge   max "));
  const std::string& report = notched.report;
  CHECK(contains(report, "\"is_within_tolerance\": true"));
  const std::string free_edge = "\"free_edge\": {";
  CHECK(number_after(report, free_edge, "maximum") <= 0.01);
  CHECK(number_after(report, free_edge, "upper_bound") >= number_after(report, free_edge, "maximum"));
  CHECK(number_after(report, free_edge, "rms") < number_after(report, free_edge, "maximum"));
  CHECK(number_after(report, free_edge, "corners") == 4);
  CHECK(number_after(report, free_edge, "largest_corner_distance") <= 1e-14);
  CHECK(contains(report.substr(report.find(free_edge)), "\"mesh_edge\": ["));
  const std::optional<std::string> page = page_in_browser(notched.output, "view=deviation&place=border");
  if (!page) {
    WARN("no chromium that runs: the page was not tried");
    return;
  }
  CHECK(contains(*page, "<h2>Free edge</h2>"));
  CHECK(contains(*page, "data-place=\"border\""));
  CHECK(contains(*page, "corners, k = 1, angle 90"));
  CHECK(contains(*page, "1 border, 4 corners"));
  CHECK(contains(*page, "<div id=\"place_mark\" aria-hidden=\"true\" style=\"left: "));
  CHECK(contains(*page, "<p id=\"message\" hidden=\"\"></p>"));
}

TEST_CASE("a surface that is near everywhere but along its border is beyond the tolerance")
{
  const Notched_run notched("--max-control-points 20");
  CHECK(contains(notched.run.output, "deviation   beyond the tolerance along the border"));
  const std::string& report = notched.report;
  CHECK(contains(report, "\"is_within_tolerance\": false"));
  CHECK(contains(report, "\"is_faultless\": false"));
  CHECK(number_after(report, "\"deviation\": {", "maximum") <= 0.005);
  CHECK(number_after(report, "\"free_edge\": {", "maximum") == Approx(0.8 / 24).epsilon(1e-3));
}

TEST_CASE("corners that fit the border but not the given cones are refused, with what would fit")
{
  const Temporary_directory directory;
  const std::string cones = directory.file("none.cones");
  std::ofstream(cones) << "";
  const auto run = [&](const std::string& text) {
    return Map_run(plate(8, 5), ".off", "--cones '" + cones + "' --corners '" + written(directory, text) + "'").run;
  };
  CHECK(run("0 1\n8 1\n53 1\n45 1\n").exit_code == 0);
  const Program_run too_few = run("0 1\n8 1\n53 1\n"), inside = run("0 1\n20 1\n");
  CHECK(too_few.exit_code == 2);
  CHECK(contains(too_few.errors, "is 3 instead of 4 (off by -1); lower its numbers k by 1 in all"));
  CHECK(inside.exit_code == 2);
  CHECK(contains(inside.errors, "corners.bcones: a corner is not on the border; make it a cone: vertex 20"));
}

TEST_CASE("a border that touches itself is refused, and repaired when asked for, which is said")
{
  Soup soup = plate(8, 5); // without two squares that meet in vertex 30
  soup.faces.erase(soup.faces.begin() + 3 * 8 + 3);
  soup.faces.erase(soup.faces.begin() + 2 * 8 + 2);
  const Map_run refused(soup, ".off", "");
  CHECK(refused.run.exit_code == 2);
  CHECK(contains(refused.run.errors, "a vertex is not manifold: its faces form more than one fan (vertex 30, "));
  CHECK(contains(refused.run.errors, "--repair mends it"));
  CHECK_FALSE(std::filesystem::exists(refused.output));
  const Map_run repaired(soup, ".off", "--repair");
  CAPTURE(repaired.run.errors);
  CHECK(repaired.run.exit_code == 0);
  CHECK(contains(repaired.run.errors, "1 vertex split off"));
  CHECK(contains(repaired.run.output, "a border of 2 curves")); // the two holes have become one
}

TEST_CASE("small holes are filled when asked for, and counted")
{
  Soup soup = plate(8, 5); // with holes of four and eight edges in a border of 26
  for (const std::size_t face : {3 * 8 + 6, 2 * 8 + 3, 2 * 8 + 2, 1 * 8 + 2})
    soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(face));
  const Temporary_directory directory;
  const std::string mesh = directory.file("plate.off"), output = directory.file("output");
  soup.write(mesh);
  const auto run_with = [&](const std::string& options) {
    return Program_run("'" + mesh + "' " + options + " -o '" + output + "'");
  };
  const auto has_holes = [&](const int filled, const int faces, const int larger) {
    const std::string report = file_content(output + "/report.json");
    const std::size_t begin = report.find("\"holes\"");
    REQUIRE(begin != std::string::npos);
    const std::string holes = report.substr(begin, report.find('}', begin) - begin);
    CHECK(contains(holes, "\"filled\": " + std::to_string(filled) + ","));
    CHECK(contains(holes, "\"faces\": " + std::to_string(faces) + ","));
    CHECK(contains(holes, "\"larger\": " + std::to_string(larger) + ","));
    CHECK(contains(holes, "\"failed\": 0"));
  };
  const Program_run small = run_with("--map-only --fill-holes 4");
  CAPTURE(small.errors);
  REQUIRE(small.exit_code == 0);
  CHECK(contains(small.output, "1 filled with 2 faces that are no data; 2 larger ones left"));
  CHECK(contains(small.output, "a border of 2 curves"));
  has_holes(1, 2, 2);
  const Program_run both = run_with("--fill-holes 25");
  CAPTURE(both.errors);
  REQUIRE(both.exit_code == 0);
  CHECK(contains(both.errors, "plate.off: note: 2 holes filled with 8 faces; 1 larger one left"));
  CHECK(contains(both.output, "a border of 1 curve"));
  has_holes(2, 8, 1);
  for (const auto& p : vertices_of_obj(output + "/t_spline.obj"))
    REQUIRE(std::abs(p[2]) <= 1e-12);
  CHECK(contains(failing_run("'" + mesh + "' --fill-holes 0").errors, "--fill-holes needs an integer of at least 1"));
  CHECK(contains(failing_run("x.off --fill-holes 5 --field f.rawfield").errors, "--fill-holes and --field"));
  CHECK(contains(failing_run("--uv x.obj --fill-holes 5").errors, "--fill-holes does not go with --uv"));
}

TEST_CASE("a triangle alone is bad input")
{
  Soup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.faces = {{0, 1, 2}};
  Soup beside = plate(4, 4);
  beside.points.insert(beside.points.end(), {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}});
  beside.faces.push_back({25, 26, 27});
  for (const Soup& soup : {triangle, beside})
    for (const std::string options : {"", "--no-corners"}) {
      const Map_run run(soup, ".off", options);
      CAPTURE(run.run.errors);
      CHECK(run.run.exit_code == 2);
      CHECK(contains(run.run.errors, "a component is a single triangle"));
      CHECK(contains(run.run.errors, "face " + std::to_string(soup.faces.size() == 1 ? 0 : 32) + ", counted from 0"));
      CHECK_FALSE(std::filesystem::exists(run.output));
    }
}

TEST_CASE("a field that does not follow the border is refused, unless its cones are to be taken")
{
  const Temporary_directory directory;
  const std::string field = directory.file("field.rawfield");
  {
    std::ofstream file(field);
    file << "4 80\n";
    for (int f = 0; f < 80; ++f)
      file << "0.8 0.6 0 -0.6 0.8 0 -0.8 -0.6 0 0.6 -0.8 0\n";
  }
  const Map_run refused(plate(8, 5), ".off", "--field '" + field + "'");
  CHECK(refused.run.exit_code == 2);
  CHECK(contains(refused.run.errors, "field.rawfield: the field does not follow the border: it is off by 37 degrees"));
  CHECK(contains(refused.run.errors, "--align-boundary"));
  CHECK_FALSE(std::filesystem::exists(refused.output));
  const Map_run aligned(plate(8, 5), ".off", "--align-boundary --field '" + field + "'");
  CAPTURE(aligned.run.errors);
  CHECK(aligned.run.exit_code == 0);
  CHECK(contains(aligned.run.output, "field.rawfield, aligned with the border: 0 cones, 4 corners (k = 1: 4)"));
  CHECK(contains(failing_run("x.off --align-boundary").errors, "--align-boundary goes with --field"));
}

TEST_CASE("a surface whose border turns inwards")
{
  Soup l_shape;
  for (std::size_t i = 0; i < 9; ++i)
    l_shape.points.push_back({static_cast<double>(i % 3), static_cast<double>(i / 3), 0});
  l_shape.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}};
  l_shape.points.pop_back();
  const Map_run map(l_shape, ".off", "");
  CAPTURE(map.run.errors);
  REQUIRE(map.run.exit_code == 0);
  CHECK(contains(map.run.output, "6 corners (k = 1: 5, k = 3: 1)"));
  const Temporary_directory directory;
  const std::string mesh = directory.file("l.off"), output = directory.file("output");
  l_shape.write(mesh);
  const Program_run run("'" + mesh + "' -o '" + output + "'");
  CAPTURE(run.errors);
  CHECK(run.exit_code == 0);
  CHECK(contains(run.output, "within the tolerance"));
}

} // namespace border_test
