// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// T-spline surfaces: evaluation, compiled and not, against the plain definition; construction and compilation.

#include "measurement.h"

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using T_spline = CGAL::T_splines::T_spline<Kernel>;
using Graph = T_spline::Graph;
using Face = Graph::Face_index;
using Surface = T_spline::Surface;
using Place = CGAL::T_splines::T_mesh_place<Graph, double>;

const char* const usage =
    "Usage: t_spline_speed [T_MESH.ply...]\n\n"
    "Prints, for tori of 70 x 70 and 220 x 220 faces of which every eighth is split again and for the given T-meshes: "
    "CPU\n"
    "seconds of the construction of the surface and of its compilation, and million points per CPU second of "
    "position() and\n"
    "of position_and_normal() of the compiled surface, at random places and at places sorted by faces; and, as the "
    "baseline,\n"
    "of the definition: the sum of all basis functions that act in the face by the recursion of Cox and de Boor.\n";

void put_at_random(Graph& mesh, CGAL::Random& random)
{
  for (const auto v : mesh.vertices())
    mesh.point(v) = Point_3(random.get_double(), random.get_double(), random.get_double());
}

/// n x n faces, of which every eighth one is split in two, along its two axes in turn.
void make_torus(const int n, T_spline& t)
{
  Graph& graph = t.graph();
  std::vector<Graph::Vertex_index> v;
  for (int i = 0; i < n * n; ++i)
    v.push_back(graph.add_vertex(Point_3(0, 0, 0)));
  const auto at = [&](const int i, const int j) { return v[n * (i % n) + j % n]; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      graph.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  for (const auto h : graph.halfedges()) {
    put(t.knots(), h, 1);
    put(t.corners(), h, true);
  }
  CGAL::T_splines::T_mesh_editor editor(t);
  for (std::size_t f = 0; f < static_cast<std::size_t>(n) * n; f += 8)
    editor.split_face(Face(static_cast<Graph::size_type>(f)), static_cast<int>(f / 8 % 2), 0.5);
}

/// The B-spline of the given degree over the knots from t[i] on, by the recursion.
double cox_de_boor(const std::array<double, 5>& t, const int i, const int degree, const double x)
{
  if (degree == 0)
    return t[i] <= x && x < t[i + 1] ? 1 : 0;
  double result = 0;
  if (t[i + degree] > t[i])
    result += (x - t[i]) / (t[i + degree] - t[i]) * cox_de_boor(t, i, degree - 1, x);
  if (t[i + degree + 1] > t[i + 1])
    result += (t[i + degree + 1] - x) / (t[i + degree + 1] - t[i + 1]) * cox_de_boor(t, i + 1, degree - 1, x);
  return result;
}

/// A point by the definition, equation (1).
Point_3 point_by_definition(const Surface& surface, const Place& place)
{
  const auto& basis = surface.basis();
  const int f = surface.indexing().face_index(place.face);
  std::array<double, 4> sum{};
  for (auto a = basis.actions_begin(f); a != basis.actions_end(f); ++a) {
    const std::pair<double, double> p = a->to_vertex(place.u, place.v);
    const auto& b = basis.functions(a->vertex);
    const double value = cox_de_boor(b[0].knots(), 0, 3, p.first) * cox_de_boor(b[1].knots(), 0, 3, p.second);
    for (int k = 0; k < 4; ++k)
      sum[k] += value * surface.homogeneous_control_points()[a->vertex][k];
  }
  return Point_3(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]);
}

std::vector<Place> random_places(const Surface& surface, const std::size_t number, CGAL::Random& random)
{
  std::vector<Face> faces;
  for (const Face f : surface.graph().faces())
    if (!surface.is_at_extraordinary_vertex(f))
      faces.push_back(f);
  std::vector<Place> places;
  for (std::size_t i = 0; i < number; ++i) {
    const Face f = faces[random.get_int(0, static_cast<int>(faces.size()))];
    places.push_back({f, random.get_double() * surface.width(f), random.get_double() * surface.height(f)});
  }
  return places;
}

double million_per_second(const std::size_t number, const double seconds)
{
  return 1e-6 * static_cast<double>(number) / seconds;
}

void measure(const std::string& name, T_spline& t)
{
  CGAL::Random random(1);
  put_at_random(t.graph(), random);
  const double construction = best_cpu_seconds(3, [&] { t.surface(); });
  const Surface surface = t.surface();
  if (!surface.is_valid()) {
    std::cerr << name << ": " << describe(surface.report(), t.graph()) << '\n';
    return;
  }
  const double compilation = best_cpu_seconds(3, [&] { CGAL::T_splines::compile_T_spline(surface); });
  const auto compiled = CGAL::T_splines::compile_T_spline(surface);

  const std::size_t number = 1000000;
  std::vector<Place> places = random_places(surface, number, random);
  std::vector<Point_3> points(number);
  std::vector<std::pair<Point_3, Kernel::Vector_3>> points_and_normals(number);
  const double position = best_cpu_seconds(3, [&] { surface.positions(places, points.begin()); });
  const double definition = best_cpu_seconds(3, [&] {
    for (std::size_t i = 0; i < number / 10; ++i)
      points[i] = point_by_definition(surface, places[i]);
  });
  const double scattered =
      best_cpu_seconds(5, [&] { compiled.positions_and_normals(places, points_and_normals.begin()); });
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.face < b.face; });
  const double sorted =
      best_cpu_seconds(5, [&] { compiled.positions_and_normals(places, points_and_normals.begin()); });

  const double baseline = million_per_second(number / 10, definition);
  std::printf("%-20s %8zu %8zu %8zu   %7.3f %7.3f   %7.2f %7.2f %7.2f %7.2f   %6.1f %6.1f %6.1f\n", name.c_str(),
              surface.number_of_control_points(), static_cast<std::size_t>(t.graph().number_of_faces()),
              compiled.number_of_patches(), construction, compilation, baseline, million_per_second(number, position),
              million_per_second(number, scattered), million_per_second(number, sorted),
              million_per_second(number, position) / baseline, million_per_second(number, scattered) / baseline,
              million_per_second(number, sorted) / baseline);
}

} // namespace

int main(const int argc, char** argv)
{
  std::vector<std::string> files(argv + 1, argv + argc);
  for (const std::string& file : files)
    if (file[0] == '-') {
      std::cout << usage;
      return file == "--help" ? EXIT_SUCCESS : 2;
    }
  std::printf(
      "%-20s %8s %8s %8s   %7s %7s   %31s   %20s\n%-20s %8s %8s %8s   %7s %7s   %7s %7s %7s %7s   %6s %6s %6s\n", "",
      "control", "", "", "seconds", "", "million points per second", "ratio to definition", "T-mesh", "points", "faces",
      "patches", "surface", "compile", "defin.", "posit.", "random", "sorted", "posit.", "random", "sorted");
  for (const int n : {70, 220}) {
    T_spline t;
    make_torus(n, t);
    measure("torus " + std::to_string(n) + " x " + std::to_string(n), t);
  }
  for (const std::string& file : files) {
    T_spline t;
    const auto report = CGAL::T_splines::read_t_mesh(file, t);
    if (!report.success()) {
      std::cerr << file << ": " << describe(report) << '\n';
      return 2;
    }
    const auto refinement = CGAL::T_splines::make_spline_compatible(t);
    if (!refinement.success()) {
      std::cerr << file << ": " << message(refinement.status) << '\n';
      return 2;
    }
    t.graph().collect_garbage();
    measure(file, t);
  }
  return EXIT_SUCCESS;
}
