// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the time grows with the size of the mesh: Loop subdivisions of one mesh with the same cones.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Solver/Cholmod_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace T_splines = CGAL::T_splines;
using Report = T_splines::Similarity_map_report<Mesh>;

static const char usage[] = "usage: scaling MESH... [--levels N] [--repeats N]\n"
                            "\n"
                            "Computes the metric and the whole map of each mesh and its Loop subdivisions. The cones, "
                            "from the .cones file beside the\n"
                            "mesh or of a smooth cross field, stay at the vertices of the first level; the loops are "
                            "computed anew. Prints CPU seconds\n"
                            "per level and solver, and the exponent p of the fit c n^p (goal 1.3, aim 1.15); peak "
                            "memory of the metric beyond the meshes.\n"
                            "  --levels N   (default 4: three subdivisions)\n"
                            "  --repeats N  the best of so many is taken (default 3)\n";

#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
/// CHOLMOD with the order of nested dissection.
struct Nested_dissection_solver_traits : T_splines::Cholmod_spd_solver_traits {
  Nested_dissection_solver_traits() { parameters().method[0].ordering = CHOLMOD_METIS; }
};
#endif

struct Level {
  Mesh mesh;
  Signature signature;

  double faces() const { return static_cast<double>(mesh.number_of_faces()); }
};

struct Times {
  double metric, map, rest; // rest: layout and subdivision
  Memory memory;
  Report report;
};

template <typename Solver>
static Map_times compute_map(const Level& level, Report& report)
{
  Stage_times times;
  Mesh refined;
  auto uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Solver solver;
  report = T_splines::compute_seamless_similarity_map(
      level.mesh, level.signature, refined, uv,
      CGAL::parameters::sparse_linear_solver(std::ref(solver)).visitor(Stage_clock(times)));
  times.end();
  return Map_times(times);
}

template <typename Solver>
static Times measure(const Level& level, const int repeats)
{
  Times times;
  const auto compute_metric = [&] {
    T_splines::Similarity_metric<Mesh> metric;
    Solver solver;
    times.report = T_splines::compute_similarity_metric(level.mesh, level.signature, metric,
                                                        CGAL::parameters::sparse_linear_solver(std::ref(solver)));
  };
  times.memory = memory_in_child(compute_metric);
  times.metric = best_cpu_seconds(repeats, compute_metric);
  Report report;
  Map_times map = compute_map<Solver>(level, report);
  times.map = map.whole;
  times.rest = map.after_metric();
  for (int i = 1; i < repeats; ++i) {
    map = compute_map<Solver>(level, report);
    times.map = std::min(times.map, map.whole);
    times.rest = std::min(times.rest, map.after_metric());
  }
  if (!report.success())
    times.report = report;
  return times;
}

template <typename Solver>
static void print_solver(const char* name, const std::vector<Level>& levels, const int repeats)
{
  std::printf("  %-28s %8s %6s %9s %9s %12s %9s %9s %12s\n", name, "faces", "iter.", "residual", "metric s", "exponent",
              "rest s", "map s", "bytes/face");
  std::vector<std::pair<double, double>> metric, map;
  for (const Level& level : levels) {
    const Times times = measure<Solver>(level, repeats);
    metric.emplace_back(level.faces(), times.metric);
    map.emplace_back(level.faces(), times.map);
    std::printf("  %-28s %8.0f %6d %9.1e %9.3f ", "", level.faces(), times.report.iterations, times.report.residual,
                times.metric);
    if (metric.size() > 1)
      std::printf("%12.2f", fitted_exponent({metric[metric.size() - 2], metric.back()}));
    else
      std::printf("%12s", "");
    std::printf(" %9.3f %9.3f %12.0f  %s\n", times.rest, times.map,
                (times.memory.peak - times.memory.before) / level.faces(), message(times.report.status));
    std::fflush(stdout);
  }
  if (metric.size() > 1)
    std::printf("  %-28s fitted exponent: metric %.3f, whole map %.3f\n", "", fitted_exponent(metric),
                fitted_exponent(map));
}

// Loop's subdivision keeps the vertices, ahead of the new ones.
static bool subdivide(const std::string& file, const Level& coarse, Level& fine)
{
  fine.mesh = coarse.mesh;
  CGAL::Subdivision_method_3::Loop_subdivision(fine.mesh, CGAL::parameters::number_of_iterations(1));
  for (const Vertex v : vertices(coarse.mesh))
    if (degree(v, coarse.mesh) != degree(v, fine.mesh)) {
      std::fprintf(stderr, "the subdivision has renumbered the vertices\n");
      return false;
    }
  return make_cone_signature(file, fine.mesh, coarse.signature.cones(), fine.signature);
}

static bool measure(const std::string& file, const int number_of_levels, const int repeats)
{
  std::vector<Level> levels(static_cast<std::size_t>(number_of_levels));
  if (!read_input(file, Signature_source::CONES_OR_FIELD, levels[0].mesh, levels[0].signature))
    return false;
  const Cones cones = levels[0].signature.cones(); // the first level's loops, too, are those nearest to the metric
  if (!make_cone_signature(file, levels[0].mesh, cones, levels[0].signature))
    return false;
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (!subdivide(file, levels[i - 1], levels[i]))
      return false;
  std::printf("%s: genus %d, %zu cones\n", name_of(file).c_str(), genus_of(levels[0].mesh), cones.size());
  print_solver<T_splines::Eigen_spd_solver_traits<>>("LDLT", levels, repeats);
#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
  print_solver<T_splines::Cholmod_spd_solver_traits>("CHOLMOD, minimum degree", levels, repeats);
  print_solver<Nested_dissection_solver_traits>("CHOLMOD, nested dissection", levels, repeats);
#endif
  return true;
}

int main(const int argc, char** argv)
{
  run_with_one_blas_thread(argv);
  Arguments arguments(usage, {}, {"--levels", "--repeats"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  bool is_complete = true;
  for (const std::string& file : arguments.files())
    is_complete =
        measure(file, std::max(1, arguments.integer("--levels", 4)), arguments.integer("--repeats", 3)) && is_complete;
  return is_complete ? 0 : 2;
}
