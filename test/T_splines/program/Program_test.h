// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_PROGRAM_PROGRAM_TEST_H
#define T_SPLINES_TEST_PROGRAM_PROGRAM_TEST_H

#include "Program_run.h"

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/Spline/T_spline.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <set>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline const std::string data = T_SPLINES_TEST_DATA "/";
inline const std::string tetrahedron = data + "good_meshes/tetrahedron.off";

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// The first number of the name after a text.
inline double number_after(const std::string& json, const std::string& text, const std::string& name)
{
  const std::size_t begin = json.find(text);
  REQUIRE(begin != std::string::npos);
  const std::string key = "\"" + name + "\": ";
  const std::size_t place = json.find(key, begin);
  REQUIRE(place != std::string::npos);
  return std::stod(json.substr(place + key.size()));
}

/// Runs the program into a directory that does not exist before, and checks that it does not exist afterwards.
inline Program_run failing_run(const std::string& arguments, const std::string& prefix = "")
{
  const Temporary_directory directory;
  const Program_run run(arguments + " -o '" + directory.file("output") + "'", prefix);
  CAPTURE(arguments, run.errors);
  CHECK(run.exit_code != 0);
  CHECK(run.output.empty());
  CHECK(contains(run.errors, "mesh_to_t_spline: "));
  CHECK_FALSE(std::filesystem::exists(directory.file("output")));
  return run;
}

/// A torus of quadrilaterals with two triangles each, moved and scaled, with all digits.
inline void write_torus(const std::string& name, const int n, const double offset, const double scale)
{
  std::ofstream file(name);
  file.precision(17);
  const double tau = 2 * std::acos(-1.);
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = tau * i / (2 * n), b = tau * (j + 0.3 * i) / n, r = 2 + 0.7 * std::cos(b);
      file << "v " << offset + scale * r * std::cos(a) << " " << offset + scale * r * std::sin(a) << " "
           << offset + scale * 0.7 * std::sin(b) * (1 + 0.2 * std::cos(a)) << "\n";
    }
  // one turn around adds 0.6 n to j
  const auto vertex = [n](const int i, const int j) { return i < 2 * n ? i * n + j % n : (j + 6 * n / 10) % n; };
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = vertex(i, j) + 1, b = vertex(i + 1, j) + 1, c = vertex(i + 1, j + 1) + 1, d = vertex(i, j + 1) + 1;
      file << "f " << a << " " << b << " " << c << "\nf " << a << " " << c << " " << d << "\n";
    }
}

/// The page of a run as a browser leaves it; none if no browser runs.
/// \param address what follows `#`
inline std::optional<std::string> page_in_browser(const std::string& output, const std::string& address)
{
  const Temporary_directory directory;
  const std::string page = directory.file("page");
  const std::string browser =
      "timeout 100 chromium --headless --no-sandbox --no-first-run --disable-background-networking"
      " --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --virtual-time-budget=3000"
      " --user-data-dir='" +
      directory.file("profile") + "' --dump-dom 'file://" + output + "/report.html#" + address + "' >'" + page +
      "' 2>/dev/null";
  return std::system(browser.c_str()) == 0 ? std::optional<std::string>(file_content(page)) : std::nullopt;
}

inline std::set<std::string> files_of(const std::string& directory)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  return names;
}

/// A T-mesh that the program wrote.
struct Test_t_mesh : CGAL::T_splines::T_spline<Kernel> {
  CGAL::T_splines::T_mesh_reading_report read(const std::string& name)
  {
    return CGAL::T_splines::read_t_mesh(name, *this);
  }
  long euler_characteristic() const
  {
    return static_cast<long>(graph().number_of_vertices()) - static_cast<long>(graph().number_of_edges()) +
           static_cast<long>(graph().number_of_faces());
  }
};

#endif // T_SPLINES_TEST_PROGRAM_PROGRAM_TEST_H
