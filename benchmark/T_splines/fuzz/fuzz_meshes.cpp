// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed meshes made of random numbers: what people bring, and worse. run_fuzz.sh runs mesh_to_t_spline over them.

#include "../Arguments.h"
#include "Random.h"
#include "Triangles.h"
#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using Mesh = CGAL::Surface_mesh<fuzz::Point>;

static const char usage[] =
    "usage: fuzz_meshes DIRECTORY [--meshes N] [--seed N] [--only I]\n"
    "       fuzz_meshes --check FILE.off...\n"
    "\n"
    "Writes closed triangle meshes into DIRECTORY, which is made: NNN_kind.off, and list.tsv, which says how each was\n"
    "made. The kinds take turns: boxes, plates to 1:1000, prisms, cylinders, tori, profiles and plates with holes "
    "with\n"
    "needle triangles as Boolean operations leave them, spheres, blobs, blocks of cubes. Some have noise up to 2 % of\n"
    "the longest side, are subdivided, large, small, or far from the origin; all are turned at random. Each is a "
    "closed\n"
    "manifold without self-intersections and degenerate triangles, faces outwards; one that is not is made anew.\n"
    "With --check, files are read again and that is verified: it ends with 1 if it does not hold for one of them.\n"
    "  --meshes N  (default 500)\n"
    "  --seed N    (default 1)\n"
    "  --only I    the mesh number I alone\n";

struct Kind {
  const char* name;
  fuzz::Triangles (*make)(fuzz::Random&);
};

static const Kind kinds[] = {{"box", fuzz::box},
                             {"plate", fuzz::plate},
                             {"prism", fuzz::prism},
                             {"cylinder", fuzz::cylinder},
                             {"torus", fuzz::torus},
                             {"profile", fuzz::profile},
                             {"holed_plate", fuzz::holed_plate},
                             {"sphere", fuzz::sphere},
                             {"blob", fuzz::blob},
                             {"blocks", fuzz::blocks}};

/// \return what a closed surface must not have, or an empty text.
static std::string defect(const fuzz::Triangles& triangles)
{
  if (triangles.faces.empty() || !PMP::is_polygon_soup_a_polygon_mesh(triangles.faces))
    return "no manifold";
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(triangles.points, triangles.faces, mesh);
  if (!CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_closed(mesh))
    return "not closed";
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.is_isolated(v))
      return "an isolated vertex";
  for (const Mesh::Face_index f : mesh.faces())
    if (PMP::is_degenerate_triangle_face(f, mesh))
      return "a degenerate triangle";
  if (PMP::does_self_intersect(mesh))
    return "a self-intersection";
  return PMP::is_outward_oriented(mesh) ? "" : "faces inwards";
}

struct Fuzz_mesh {
  fuzz::Triangles triangles;
  double noise = 0, scale = 1, distance = 0; // noise by the longest side, distance from the origin by the longest side
  int subdivisions = 0;
};

/// makes one mesh, which may be invalid.
static Fuzz_mesh make(const Kind& kind, fuzz::Random& random)
{
  Fuzz_mesh mesh;
  mesh.triangles = kind.make(random);
  if (random.chance(0.4))
    for (int n = random.integer(1, 3); n > 0 && mesh.triangles.faces.size() < 5000; --n, ++mesh.subdivisions)
      subdivide(mesh.triangles);
  if (random.chance(0.3)) {
    mesh.noise = random.log_uniform(1e-5, 2e-2);
    const double side = longest_side(mesh.triangles);
    fuzz::Triangles noisy = mesh.triangles;
    add_noise(noisy, mesh.noise * side, random);
    for (; !defect(noisy).empty() && mesh.noise > 1e-8; mesh.noise /= 2) {
      noisy = mesh.triangles;
      add_noise(noisy, mesh.noise / 2 * side, random);
    }
    mesh.triangles = noisy;
  }
  if (random.chance(0.3))
    mesh.scale = random.log_uniform(1e-4, 1e5);
  if (random.chance(0.2))
    mesh.distance = random.log_uniform(1, 1e5);
  const double far = mesh.distance * longest_side(mesh.triangles) * mesh.scale;
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
  place(mesh.triangles, mesh.scale, far * fuzz::Vector(x, y, z), random);
  return mesh;
}

/// The number of a mesh and the seed decide on it: each can be made alone.
static Fuzz_mesh make_valid(const std::uint64_t seed, const std::size_t number)
{
  fuzz::Random random(seed * 1000003 + number);
  for (;;) {
    Fuzz_mesh mesh = make(kinds[number % std::size(kinds)], random);
    if (defect(mesh.triangles).empty())
      return mesh;
  }
}

static bool write_off(const std::string& file, const fuzz::Triangles& mesh)
{
  std::ofstream out(file);
  out.precision(17);
  out << "OFF\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const fuzz::Point& p : mesh.points)
    out << p << '\n';
  for (const auto& [a, b, c] : mesh.faces)
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
  return static_cast<bool>(out.flush());
}

static bool read_off(const std::string& file, fuzz::Triangles& mesh)
{
  std::ifstream in(file);
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0, corners = 3;
  if (!(in >> word >> points >> faces >> edges) || word != "OFF")
    return false;
  mesh.points.resize(points);
  mesh.faces.resize(faces);
  for (fuzz::Point& p : mesh.points)
    in >> p;
  for (auto& [a, b, c] : mesh.faces)
    if (!(in >> corners >> a >> b >> c) || corners != 3 || std::max({a, b, c}) >= points)
      return false;
  return true;
}

static int check(const std::vector<std::string>& files)
{
  std::size_t bad = 0;
  for (const std::string& file : files) {
    fuzz::Triangles mesh;
    const std::string what = read_off(file, mesh) ? defect(mesh) : "no OFF file of triangles";
    if (!what.empty()) {
      std::cerr << file << ": " << what << '\n';
      ++bad;
    }
  }
  std::printf("%zu files, %zu of them not as they should be\n", files.size(), bad);
  return bad == 0 ? 0 : 1;
}

int main(const int argc, char** argv)
{
  Arguments arguments(usage, {"--check"}, {"--meshes", "--seed", "--only"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  if (arguments.has("--check"))
    return check(arguments.files());
  const std::filesystem::path directory = arguments.files()[0];
  const auto seed = static_cast<std::uint64_t>(arguments.integer("--seed", 1));
  const int only = arguments.integer("--only", -1), meshes = only >= 0 ? only + 1 : arguments.integer("--meshes", 500);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  std::ofstream list(directory / "list.tsv");
  list << "file\ttriangles\tsubdivisions\tnoise\tscale\tdistance\n";
  for (int i = std::max(only, 0); i < meshes; ++i) {
    const auto number = static_cast<std::size_t>(i);
    const Fuzz_mesh mesh = make_valid(seed, number);
    char name[64];
    std::snprintf(name, sizeof name, "%03zu_%s.off", number, kinds[number % std::size(kinds)].name);
    list << name << '\t' << mesh.triangles.faces.size() << '\t' << mesh.subdivisions << '\t' << mesh.noise << '\t'
         << mesh.scale << '\t' << mesh.distance << '\n';
    if (!write_off((directory / name).string(), mesh.triangles) || !list.flush()) {
      std::cerr << "cannot write to " << directory << '\n';
      return 2;
    }
  }
}
