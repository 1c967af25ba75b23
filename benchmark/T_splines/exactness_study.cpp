// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Traces the motorcycle graph of each map twice, by the same code: in exact arithmetic, and in doubles. Tells how many
// of the T-meshes that come out of the doubles are wrong, and in what way.

#include <CGAL/T_splines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace T = CGAL::T_splines;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

// How the T-mesh in doubles compares with the exact one.
enum class Verdict { SAME, OTHER_GRAPH, OTHER_COUNTS, NOT_ADMISSIBLE, NO_T_MESH, NO_MAP };
constexpr std::array<const char*, 6> verdict_names = {
    {"the same", "other graph", "other counts", "not admissible", "no T-mesh", "no seamless map"}};
constexpr double knot_tolerance = 1e-6; // relative; far above what round-off alone explains

template <typename FT>
struct Traced {
  T::Exact_map_report<Mesh> map_report;
  T::Motorcycle_graph_report report;
  T::T_mesh<Kernel::Point_3, FT> t_mesh;

  Traced(const Mesh& mesh, const UV_map uv)
  {
    T::Seamless_map<Mesh, FT> map(mesh);
    map_report = T::make_exactly_seamless(mesh, uv, map);
    if (map_report.success()) // with FT = double, the default traits are Inexact_tracing_traits
      report = T::trace_motorcycle_graph(map, t_mesh);
  }
};

static bool is_same_graph(const Traced<CGAL::Exact_rational>& exact, const Traced<double>& rounded)
{
  const Mesh &a = exact.t_mesh.graph(), &b = rounded.t_mesh.graph();
  for (const Mesh::Halfedge_index h : halfedges(a)) {
    const double knot = CGAL::to_double(exact.t_mesh.knots()[h]);
    if (a.target(h) != b.target(h) || a.next(h) != b.next(h) ||
        exact.t_mesh.corners()[h] != rounded.t_mesh.corners()[h] ||
        std::abs(rounded.t_mesh.knots()[h] - knot) > knot_tolerance * knot)
      return false;
  }
  return true;
}

static Verdict compare(const Traced<CGAL::Exact_rational>& exact, const Traced<double>& rounded)
{
  if (!rounded.map_report.success())
    return Verdict::NO_MAP;
  if (!rounded.report.success())
    return Verdict::NO_T_MESH;
  if (!T::check_admissibility(rounded.t_mesh, T::parameters::relative_tolerance(knot_tolerance)))
    return Verdict::NOT_ADMISSIBLE;
  if (num_faces(exact.t_mesh.graph()) != num_faces(rounded.t_mesh.graph()) ||
      num_edges(exact.t_mesh.graph()) != num_edges(rounded.t_mesh.graph()) ||
      num_vertices(exact.t_mesh.graph()) != num_vertices(rounded.t_mesh.graph()))
    return Verdict::OTHER_COUNTS;
  return is_same_graph(exact, rounded) ? Verdict::SAME : Verdict::OTHER_GRAPH;
}

// What was found out so far.
struct Study {
  std::array<int, verdict_names.size()> count{};
  int maps = 0;

  void add(const std::string& name, const Mesh& mesh, const UV_map uv)
  {
    const Traced<CGAL::Exact_rational> exact(mesh, uv);
    if (!exact.map_report.success() || !exact.report.success()) {
      std::cout << name << ": "
                << (exact.map_report.success() ? message(exact.report.status) : message(exact.map_report.status))
                << "\n";
      return;
    }
    const Traced<double> rounded(mesh, uv);
    const Verdict verdict = compare(exact, rounded);
    ++maps;
    ++count[static_cast<std::size_t>(verdict)];
    std::printf("%-32s %8zu triangles, %4d cones: %6zu faces, %6zu T-joints; in doubles: %s", name.c_str(),
                static_cast<std::size_t>(num_faces(mesh)), exact.map_report.number_of_cones,
                static_cast<std::size_t>(num_faces(exact.t_mesh.graph())), exact.report.t_joints,
                verdict_names[static_cast<std::size_t>(verdict)]);
    if (verdict == Verdict::NO_MAP)
      std::printf(" (%s)", message(rounded.map_report.status));
    if (verdict == Verdict::NO_T_MESH)
      std::printf(" (%s)", message(rounded.report.status));
    std::printf("\n");
  }

  void print() const
  {
    std::printf("\n%d maps; in doubles", maps);
    for (std::size_t i = 0; i < count.size(); ++i)
      std::printf("%s %d %s", i == 0 ? "" : ",", count[i], verdict_names[i]);
    std::printf(": %d of %d wrong\n", maps - count[0], maps);
  }
};

// A mesh of numbered triangles with uv per corner.
struct Corner_map {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<Kernel::Point_2, 3>> uv;

  void add(const std::array<int, 3>& triangle, const std::array<Kernel::Point_2, 3>& corners)
  {
    triangles.push_back(triangle);
    uv.push_back(corners);
  }

  // Only the map counts: the points in space are at random.
  void study(const std::string& name, Study& study) const
  {
    Mesh mesh;
    const UV_map uv_map = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    std::mt19937 random(1);
    std::map<int, Mesh::Vertex_index> vertex;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      std::array<Mesh::Vertex_index, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        if (vertex.count(triangles[t][i]) == 0) {
          const double x = random(), y = random(), z = random();
          vertex[triangles[t][i]] = mesh.add_vertex(Kernel::Point_3(x, y, z));
        }
        corners[i] = vertex[triangles[t][i]];
      }
      const Mesh::Face_index f = CGAL::Euler::add_face(corners, mesh);
      for (const Mesh::Halfedge_index h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
        for (std::size_t i = 0; i < 3; ++i)
          if (corners[i] == target(h, mesh))
            uv_map[h] = uv[t][i];
    }
    study.add(name, mesh, uv_map);
  }
};

// Four copies of a triangle folded to a tetrahedron; four cones of 180 degrees.
static void add_folded_triangle(const unsigned seed, Study& study)
{
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 2. * static_cast<double>(random()) / 4294967296. - 1; };
  Kernel::Vector_2 a(coordinate(), coordinate()), b(coordinate(), coordinate());
  if (a.x() * b.y() < a.y() * b.x())
    std::swap(a, b);
  const Kernel::Point_2 o(0, 0), p = o + a, q = o + b;
  Corner_map map;
  map.add({{0, 1, 2}}, {{o, p, q}});
  map.add({{1, 0, 3}}, {{p, p + a, p + b}});
  map.add({{2, 3, 0}}, {{q, q + a, q + b}});
  map.add({{1, 3, 2}}, {{p, p + b, q}});
  map.study("folded triangle " + std::to_string(seed), study);
}

// A cube whose sides are grids: isolines from the cones run along edges and through vertices.
static void add_cube(const int n, const double width, Study& study)
{
  Corner_map map;
  std::map<std::array<int, 3>, int> number;
  for (int side = 0; side < 6; ++side)
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y) {
        const int axis = side / 2, first = side % 2 ? (axis + 1) % 3 : (axis + 2) % 3, second = 3 - axis - first;
        std::array<int, 4> vertex;
        std::array<Kernel::Point_2, 4> uv;
        const std::array<std::array<int, 2>, 4> corners = {{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
        for (std::size_t i = 0; i < 4; ++i) {
          std::array<int, 3> p;
          p[axis] = side % 2 ? n : 0;
          p[first] = x + corners[i][0];
          p[second] = y + corners[i][1];
          vertex[i] = number.emplace(p, static_cast<int>(number.size())).first->second;
          uv[i] = {0.1 * side + width * p[first], 0.7 * side + width * p[second]};
        }
        map.add({{vertex[0], vertex[1], vertex[2]}}, {{uv[0], uv[1], uv[2]}});
        map.add({{vertex[0], vertex[2], vertex[3]}}, {{uv[0], uv[2], uv[3]}});
      }
  map.study("cube of " + std::to_string(n) + " x " + std::to_string(n) + " squares", study);
}

constexpr const char* usage = R"(exactness_study [MAP.obj ...]

How many motorcycle graphs traced in doubles are wrong, and in what way. Without maps it makes some: folded triangles in
general position, and grids, whose isolines run along edges.
)";

int main(int argc, char* argv[])
{
  if (argc > 1 && std::string(argv[1]) == "--help") {
    std::cout << usage;
    return EXIT_SUCCESS;
  }
  Study study;
  for (int i = 1; i < argc; ++i) {
    const std::string file = argv[i];
    Mesh mesh;
    const UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    const T::Mesh_reading_report reading = T::read_map_obj(file, mesh, uv);
    if (!reading.success()) {
      std::cerr << file << ": " << describe(reading) << "\n";
      return 2;
    }
    study.add(file.substr(file.find_last_of('/') + 1), mesh, uv);
  }
  if (argc == 1) {
    for (unsigned seed = 1; seed <= 20; ++seed)
      add_folded_triangle(seed, study);
    for (int n = 1; n <= 12; ++n)
      add_cube(n, 1. / 7, study);
  }
  study.print();
  return EXIT_SUCCESS;
}
