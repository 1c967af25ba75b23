// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The metric against the paper's own method, layout and subdivision against the metric, and memory per face.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"
#include "paper_method.h"

#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Solver/Cholmod_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>

namespace T_splines = CGAL::T_splines;
using Report = T_splines::Similarity_map_report<Mesh>;

static const char usage[] =
    "usage: metric_speed MESH... [--cones] [--repeats N] [--baseline-repeats N] [--no-baseline] [--baseline-memory]\n"
    "\n"
    "Computes the metric of each mesh by the package and by the method of the paper (|E| unknowns, SparseLU, "
    "degeneracy\n"
    "flips), in one process, and prints CPU seconds (best of the repeats) and the ratio; then the stages of the whole "
    "map\n"
    "and the peak memory, each in a process of its own.\n"
    "  --cones             take the signature from the .cones file beside the mesh, not from a smooth cross field\n"
    "  --repeats N         of everything but the baseline (default 5)\n"
    "  --baseline-repeats  of the baseline (default 1: it takes 10 to 60 s at 100 thousand faces)\n"
    "  --no-baseline       leave the baseline out\n"
    "  --baseline-memory   measure the memory of the baseline too, which runs it once more\n";

struct Setting {
  int repeats, baseline_repeats;
  bool measures_baseline_memory;
};

static void print_head()
{
  std::printf("  %-50s %5s %8s %9s %9s %8s\n", "method", "iter.", "flips", "residual", "CPU s", "ratio");
}

static void print_row(const char* method, const int iterations, const std::size_t flips, const double residual,
                      const double seconds, const double reference, const char* end)
{
  std::printf("  %-50s %5d %8zu %9.1e %9.3f ", method, iterations, flips, residual, seconds);
  if (reference > 0)
    std::printf("%7.2fx", reference / seconds);
  else
    std::printf("%8s", "");
  std::printf("  %s\n", end);
  std::fflush(stdout);
}

// Without a metric's checks and conversion from the face graph: what the paper's method is timed without.
template <typename Solver, typename FlipPolicy>
static Report metric(const Mesh& mesh, const Signature& signature, const Solver&, const FlipPolicy& policy,
                     const int repeats, double& seconds, double& seconds_with_checks)
{
  Report report;
  seconds = seconds_with_checks = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    Stage_times times;
    T_splines::Similarity_metric<Mesh> result;
    Solver solver;
    report = T_splines::compute_similarity_metric(
        mesh, signature, result,
        T_splines::parameters::flip_policy(policy, CGAL::parameters::sparse_linear_solver(std::ref(solver))
                                                       .visitor(Stage_clock(times))
                                                       .number_of_iterations(2000)));
    times.end();
    const double stage = times["similarity metric"];
    seconds = std::min(seconds, stage);
    seconds_with_checks = std::min(seconds_with_checks, stage + times[Stage_times::before_the_first]);
  }
  return report;
}

template <typename Solver, typename FlipPolicy>
static double print_metric(const char* method, const Mesh& mesh, const Signature& signature, const Solver& solver,
                           const FlipPolicy& policy, const int repeats, const double reference)
{
  double seconds, with_checks;
  const Report report = metric(mesh, signature, solver, policy, repeats, seconds, with_checks);
  print_row(method, report.iterations, report.flips + report.delaunay_flips, report.residual, seconds, reference,
            message(report.status));
  std::printf("  %50s %d factorizations, %d solves, %d halvings, %.3f s with the checks of the input\n", "",
              report.factorizations, report.linear_iterations, report.halvings, with_checks);
  return seconds;
}

static Paper_method::Report paper_method(const T_splines::internal::Metric_input& input, const bool delaunay)
{
  return Paper_method(input, delaunay).run(1e-12, 2000);
}

static double print_paper_method(const char* method, const T_splines::internal::Metric_input& input,
                                 const bool delaunay, const int repeats)
{
  Paper_method::Report report = paper_method(input, delaunay);
  for (int i = 1; i < repeats; ++i)
    report.seconds = std::min(report.seconds, paper_method(input, delaunay).seconds);
  print_row(method, report.iterations, report.flips + report.delaunay_flips, report.residual, report.seconds, 0.,
            message(report.end));
  return report.seconds;
}

template <typename Solver>
static Map_times map_times(const Mesh& mesh, const Signature& signature, const Solver&)
{
  Stage_times times;
  Mesh refined;
  auto uv = refined.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Solver solver;
  T_splines::compute_seamless_similarity_map(
      mesh, signature, refined, uv,
      CGAL::parameters::sparse_linear_solver(std::ref(solver)).visitor(Stage_clock(times)));
  times.end();
  return Map_times(times);
}

static void print_map_times(const Mesh& mesh, const Signature& signature, const int repeats)
{
  Map_times best = map_times(mesh, signature, T_splines::Eigen_spd_solver_traits<>());
  for (int i = 1; i < repeats; ++i) {
    const Map_times times = map_times(mesh, signature, T_splines::Eigen_spd_solver_traits<>());
    best.metric = std::min(best.metric, times.metric);
    best.layout = std::min(best.layout, times.layout);
    best.subdivision = std::min(best.subdivision, times.subdivision);
    best.output = std::min(best.output, times.output);
    best.whole = std::min(best.whole, times.whole);
  }
  std::printf("  whole map %.3f s: metric %.3f, layout %.3f, subdivision %.3f, output %.3f; "
              "(layout + subdivision) / metric = %.2f (goal <= 1)\n",
              best.whole, best.metric, best.layout, best.subdivision, best.output, best.after_metric() / best.metric);
}

static void print_memory(const char* what, const Memory& memory, const Mesh& mesh)
{
  const double faces = static_cast<double>(mesh.number_of_faces());
  std::printf("  memory, %-30s %7.1f MB at the peak, %7.1f MB before: %6.0f bytes per face, %6.0f without what was "
              "there before\n",
              what, memory.peak / 1e6, memory.before / 1e6, memory.peak / faces, (memory.peak - memory.before) / faces);
  std::fflush(stdout);
}

static void print_memories(const Mesh& mesh, const Signature& signature, const bool includes_baseline)
{
  const T_splines::Eigen_spd_solver_traits<> solver;
  print_memory("metric (goal 1500 per face):", memory_in_child([&] {
                 double seconds, with_checks;
                 metric(mesh, signature, solver, T_splines::Ideal_delaunay_flips(), 1, seconds, with_checks);
               }),
               mesh);
  print_memory("whole map:", memory_in_child([&] { map_times(mesh, signature, solver); }), mesh);
  if (includes_baseline)
    print_memory("paper's method:", memory_in_child([&] {
                   const T_splines::internal::Mesh_indexing<Mesh> indexing(mesh);
                   paper_method(T_splines::internal::Metric_input(indexing, signature, mesh.points()), false);
                 }),
                 mesh);
}

static bool measure(const std::string& file, const Signature_source source, const Setting& setting)
{
  Mesh mesh;
  Signature signature;
  const double start = cpu_seconds();
  if (!read_input(file, source, mesh, signature))
    return false;
  std::printf("%s: %zu faces, genus %d, %zu cones; reading and signature %.2f s\n", name_of(file).c_str(),
              static_cast<std::size_t>(mesh.number_of_faces()), genus_of(mesh), signature.cones().size(),
              cpu_seconds() - start);
  print_memories(mesh, signature, setting.measures_baseline_memory);
  print_map_times(mesh, signature, setting.repeats);
  print_head();
  double reference = 0;
  if (setting.baseline_repeats > 0) {
    const T_splines::internal::Mesh_indexing<Mesh> indexing(mesh);
    const T_splines::internal::Metric_input input(indexing, signature, mesh.points());
    reference = print_paper_method("paper, LU", input, false, setting.baseline_repeats);
    print_paper_method("paper, LU, intrinsic Delaunay", input, true, setting.baseline_repeats);
  }
  const T_splines::Eigen_spd_solver_traits<> ldlt;
  print_metric("degeneracy flips, SPD, LDLT", mesh, signature, ldlt, T_splines::Degeneracy_flips{false}, 1, reference);
  print_metric("degeneracy flips, intrinsic Delaunay, SPD, LDLT", mesh, signature, ldlt,
               T_splines::Degeneracy_flips{true}, 1, reference);
  print_metric("ours (ideal Delaunay flips), LDLT", mesh, signature, ldlt, T_splines::Ideal_delaunay_flips(),
               setting.repeats, reference);
#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
  print_metric("ours (ideal Delaunay flips), CHOLMOD", mesh, signature, T_splines::Cholmod_spd_solver_traits(),
               T_splines::Ideal_delaunay_flips(), setting.repeats, reference);
#endif
  return true;
}

int main(const int argc, char** argv)
{
  run_with_one_blas_thread(argv);
  Arguments arguments(usage, {"--cones", "--no-baseline", "--baseline-memory"}, {"--repeats", "--baseline-repeats"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  const Setting setting{arguments.integer("--repeats", 5),
                        arguments.has("--no-baseline") ? 0 : arguments.integer("--baseline-repeats", 1),
                        arguments.has("--baseline-memory")};
  const Signature_source source = arguments.has("--cones") ? Signature_source::CONES_OR_FIELD : Signature_source::FIELD;
  bool is_complete = true;
  for (const std::string& file : arguments.files())
    is_complete = measure(file, source, setting) && is_complete;
  return is_complete ? 0 : 2;
}
