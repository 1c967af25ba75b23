// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The map of a mesh with border against that of a closed mesh with as many faces.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>

#include <CGAL/Polygon_mesh_processing/border.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace T_splines = CGAL::T_splines;
using Report = T_splines::Similarity_map_report<Mesh>;
using Point_3 = Kernel::Point_3;

static const char usage[] =
    "usage: border_speed [OPEN CLOSED]... [--faces N] [--repeats N]\n"
    "\n"
    "Computes the maps of pairs of meshes, one with border and one without, in one process, and prints CPU seconds "
    "(best of\n"
    "the repeats, which alternate), microseconds per face and their ratio. Signatures come from smooth cross fields. "
    "Without\n"
    "files, on three surfaces with bumps, each whole and with a part cut away, with as many faces.\n"
    "  --faces N    of the surfaces that are made, about (default 50000)\n"
    "  --repeats N  (default 5)\n";

struct Named_mesh {
  std::string name;
  Mesh mesh;
};

// Bumps of several sizes: a factor of lengths at a place.
static double bumps(const double x, const double y, const double z)
{
  return 1 + 0.08 * std::sin(3 * x + 1) * std::sin(4 * y) + 0.04 * std::sin(9 * y + 2) * std::cos(8 * z) +
         0.01 * std::sin(31 * x) * std::sin(29 * z + 1);
}

// Two triangles for each cell (i, j), at `point(i, j)`, that `is_in(i, j)`. Corners at the same place are one vertex.
template <typename IsIn, typename PointAt>
static void add_cells(const int n, const int m, const IsIn& is_in, const PointAt& point,
                      std::map<std::array<long, 3>, Vertex>& vertices, Mesh& mesh)
{
  const auto vertex = [&](const int i, const int j) {
    const Point_3 p = point(i, j);
    const auto rounded = [](const double x) { return std::lround(1e7 * x); };
    const auto inserted =
        vertices.emplace(std::array<long, 3>{{rounded(p.x()), rounded(p.y()), rounded(p.z())}}, Vertex());
    if (inserted.second)
      inserted.first->second = mesh.add_vertex(p);
    return inserted.first->second;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      if (is_in(i, j)) {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
}

// A sphere with bumps, over the sides of a cube; without the sixth side, it has a border.
static Mesh sphere(const int sides, const int faces)
{
  Mesh mesh;
  std::map<std::array<long, 3>, Vertex> vertices;
  const int n = static_cast<int>(std::lround(std::sqrt(faces / (2. * sides))));
  for (int side = 0; side < sides; ++side) {
    const auto point = [&](const int i, const int j) {
      std::array<double, 3> p;
      const int axis = side / 2;
      p[axis] = side % 2 == 0 ? 1 : -1;
      p[(axis + (side % 2 == 0 ? 1 : 2)) % 3] = std::tan(CGAL_PI / 4 * (2. * i / n - 1));
      p[(axis + (side % 2 == 0 ? 2 : 1)) % 3] = std::tan(CGAL_PI / 4 * (2. * j / n - 1));
      const double length = std::hypot(p[0], p[1], p[2]),
                   factor = bumps(p[0] / length, p[1] / length, p[2] / length) / length;
      return Point_3(factor * p[0], factor * p[1], factor * p[2]);
    };
    add_cells(
        n, n, [](int, int) { return true; }, point, vertices, mesh);
  }
  return mesh;
}

// A torus with bumps, of which the cells are taken that `is_in(x, y)`, the two angles in turns: a `share` of them.
template <typename IsIn>
static Mesh torus(const double share, const int faces, const IsIn& is_in)
{
  Mesh mesh;
  std::map<std::array<long, 3>, Vertex> vertices;
  const int m = static_cast<int>(std::lround(std::sqrt(faces / (4 * share)))),
            n = 10 * static_cast<int>(std::lround(faces / (20 * m * share)));
  const auto point = [&](const int i, const int j) {
    const double u = 2 * CGAL_PI * (i % n) / n, v = 2 * CGAL_PI * (j % m) / m;
    const double tube = 0.8 * bumps(std::cos(u), std::sin(u), std::cos(v)), radius = 2 + tube * std::cos(v);
    return Point_3(radius * std::cos(u), radius * std::sin(u), tube * std::sin(v));
  };
  add_cells(
      n, m, [&](const int i, const int j) { return is_in((i + 0.5) / n, (j + 0.5) / m); }, point, vertices, mesh);
  return mesh;
}

static std::vector<std::pair<Named_mesh, Named_mesh>> made_pairs(const int faces)
{
  const Named_mesh whole_torus{"torus", torus(1, faces, [](double, double) { return true; })};
  const auto is_between_holes = [](const double x, const double y) {
    return std::fmod(10 * x, 1) < 0.5 || std::fmod(5 * y, 1) < 0.6;
  };
  return {{{"sphere without a side", sphere(5, faces)}, {"sphere", sphere(6, faces)}},
          {{"four fifths of a torus", torus(0.8, faces, [](const double x, double) { return x < 0.8; })}, whole_torus},
          {{"torus with 50 holes", torus(0.8, faces, is_between_holes)}, whole_torus}};
}

struct Measured {
  Signature signature;
  Report report;
  Map_times best = Map_times(Stage_times());
  std::size_t refined_faces = 0;
};

static void measure_once(const Mesh& mesh, Measured& measured)
{
  Stage_times times;
  Mesh refined;
  auto uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  measured.report = T_splines::compute_seamless_similarity_map(mesh, measured.signature, refined, uv,
                                                               CGAL::parameters::visitor(Stage_clock(times)));
  times.end();
  const Map_times map_times(times);
  if (measured.refined_faces == 0 || map_times.whole < measured.best.whole)
    measured.best = map_times;
  measured.refined_faces = refined.number_of_faces();
}

static double print_row(const Named_mesh& named, const Measured& measured)
{
  std::vector<Halfedge> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(named.mesh, std::back_inserter(borders));
  const double per_face = 1e6 * measured.best.whole / static_cast<double>(named.mesh.number_of_faces());
  std::printf("  %-24s %7zu %7zu %5zu %7zu %5d %6zu %8zu %7.3f %7.3f %7.3f %7.3f %8.3f  %s\n", named.name.c_str(),
              static_cast<std::size_t>(named.mesh.number_of_faces()), borders.size(), measured.signature.cones().size(),
              measured.signature.corners().size(), measured.report.iterations,
              measured.report.flips + measured.report.delaunay_flips, measured.refined_faces, measured.best.metric,
              measured.best.layout, measured.best.subdivision, measured.best.whole, per_face,
              message(measured.report.status));
  return per_face;
}

static bool measure(std::pair<Named_mesh, Named_mesh>& pair, const int repeats)
{
  Measured open, closed;
  if (!make_field_signature(pair.first.name, pair.first.mesh, open.signature) ||
      !make_field_signature(pair.second.name, pair.second.mesh, closed.signature))
    return false;
  for (int i = 0; i < repeats; ++i) {
    measure_once(pair.first.mesh, open);
    measure_once(pair.second.mesh, closed);
  }
  const double of_open = print_row(pair.first, open), of_closed = print_row(pair.second, closed);
  std::printf("  ratio per face %.2f (goal <= 1.4)\n", of_open / of_closed);
  std::fflush(stdout);
  return open.report.success() && closed.report.success();
}

int main(const int argc, char** argv)
{
  Arguments arguments(usage, {}, {"--faces", "--repeats"});
  arguments.allow_no_files();
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  std::vector<std::pair<Named_mesh, Named_mesh>> pairs;
  const std::vector<std::string>& files = arguments.files();
  if (files.size() % 2 != 0) {
    std::fprintf(stderr, "meshes come in pairs: one with border and one without\n\n%s", usage);
    return 2;
  }
  for (std::size_t i = 0; i < files.size(); i += 2) {
    pairs.emplace_back(Named_mesh{name_of(files[i]), {}}, Named_mesh{name_of(files[i + 1]), {}});
    if (!read_mesh(files[i], pairs.back().first.mesh) || !read_mesh(files[i + 1], pairs.back().second.mesh))
      return 2;
  }
  if (files.empty())
    pairs = made_pairs(arguments.integer("--faces", 50000));
  std::printf("  %-24s %7s %7s %5s %7s %5s %6s %8s %7s %7s %7s %7s %8s\n", "mesh", "faces", "borders", "cones",
              "corners", "iter.", "flips", "refined", "metric", "layout", "subdiv.", "CPU s", "us/face");
  bool is_complete = true;
  for (auto& pair : pairs)
    is_complete = measure(pair, arguments.integer("--repeats", 5)) && is_complete;
  return is_complete ? 0 : 2;
}
