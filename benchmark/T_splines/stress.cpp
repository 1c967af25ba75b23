// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The stress test of [CZ17] section 9.1: random cones.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace T_splines = CGAL::T_splines;
using Report = T_splines::Similarity_map_report<Mesh>;

static const char usage[] = "usage: stress MESH... [--seeds N] [--first-seed N] [--cones N] [--iterations N] [--policy "
                            "ideal|degeneracy|delaunay]\n"
                            "\n"
                            "Prescribes random cones with k in {2, 3, 5, 6} at random vertices, further ones with k = "
                            "3 or k = 5 until Gauss-Bonnet holds, and\n"
                            "the loops' numbers nearest to the metric. Runs the three flip policies on each of these "
                            "signatures and prints how each ends.\n"
                            "  --seeds N       (default 20)\n"
                            "  --first-seed N  (default 1)\n"
                            "  --cones N       (default 100)\n"
                            "  --iterations N  limit of Newton's iterations (default 300)\n"
                            "  --policy P      only this one: ideal (ideal Delaunay flips), degeneracy (the paper's), "
                            "delaunay (the paper's with the intrinsic\n"
                            "                  Delaunay pass of its Remark)\n";

/// Random cones that satisfy the Gauss-Bonnet theorem. The same seed gives the same cones everywhere.
static Cones random_cones(const Mesh& mesh, const int number_of_cones, const unsigned int seed)
{
  std::mt19937 random(seed); // distributions are not portable: remainders are
  const std::vector<Vertex> vertex(vertices(mesh).begin(), vertices(mesh).end());
  std::vector<char> is_cone(vertex.size(), 0);
  Cones cones;
  int excess = 8 * (1 - genus_of(mesh)); // of 4 - k that is still to be placed
  const auto add = [&](const int k) {
    std::size_t v;
    do
      v = random() % vertex.size();
    while (is_cone[v]);
    is_cone[v] = 1;
    cones.emplace_back(vertex[v], k);
    excess -= 4 - k;
  };
  const int choice[] = {2, 3, 5, 6};
  for (int i = 0; i < number_of_cones; ++i)
    add(choice[random() % 4]);
  while (excess != 0)
    add(excess > 0 ? 3 : 5);
  return cones;
}

struct Summary {
  int runs = 0, converged = 0, wide = 0, largest_iterations = 0;
  double seconds = 0, largest_residual = 0; // of those that converge
  std::size_t largest_flips = 0;

  void add(const Report& report, const double cpu)
  {
    ++runs;
    seconds += cpu;
    if (!report.success())
      return;
    ++converged;
    wide += report.mantissa_bits > 53;
    largest_iterations = std::max(largest_iterations, report.iterations);
    largest_flips = std::max(largest_flips, report.flips);
    largest_residual = std::max(largest_residual, report.residual);
  }

  void print(const std::string& mesh, const char* policy) const
  {
    std::printf("%-20s %-11s converged %d of %d (%d in a wider number type), at most %d iterations, %zu flips, "
                "residual %.1e; %.1f s\n\n",
                mesh.c_str(), policy, converged, runs, wide, largest_iterations, largest_flips, largest_residual,
                seconds);
  }
};

static void print_run(const std::string& mesh, const char* policy, const unsigned int seed, const Report& report,
                      const double seconds)
{
  std::printf("%-20s %-11s %4u %5d %8zu %5d %9.1e %5d %8.2f  ", mesh.c_str(), policy, seed, report.iterations,
              report.flips, report.halvings, report.residual, report.mantissa_bits, seconds);
  std::printf("%s", message(report.status));
  if (!report.success() && report.loop != Report::no_loop)
    std::printf(", at loop %zu", report.loop);
  else if (!report.success())
    std::printf(", at vertex %zu", static_cast<std::size_t>(report.vertex));
  if (report.hyperbolic_length > 0)
    std::printf("; period %.3g, hyperbolic length %.3g of the loop at its limit", report.scale_period,
                report.hyperbolic_length);
  std::printf("\n");
  std::fflush(stdout);
}

struct Setting {
  int first_seed, seeds, cones, iterations;
  std::string policy;
};

template <typename FlipPolicy>
static bool run_policy(const std::string& file, const Mesh& mesh, const char* name, const FlipPolicy& policy,
                       const Setting& setting)
{
  if (!setting.policy.empty() && setting.policy != name)
    return true;
  Summary summary;
  for (int i = 0; i < setting.seeds; ++i) {
    const unsigned int seed = static_cast<unsigned int>(setting.first_seed + i);
    Signature signature;
    if (!make_cone_signature(file, mesh, random_cones(mesh, setting.cones, seed), signature))
      return false;
    T_splines::Similarity_metric<Mesh> metric;
    const double start = cpu_seconds();
    const Report report = T_splines::compute_similarity_metric(
        mesh, signature, metric,
        T_splines::parameters::flip_policy(policy, CGAL::parameters::number_of_iterations(setting.iterations)));
    const double seconds = cpu_seconds() - start;
    summary.add(report, seconds);
    print_run(name_of(file), name, seed, report, seconds);
  }
  summary.print(name_of(file), name);
  return true;
}

static bool run(const std::string& file, const Setting& setting)
{
  Mesh mesh;
  if (!read_mesh(file, mesh))
    return false;
  if (static_cast<int>(mesh.number_of_vertices()) < 4 * setting.cones + 16 * genus_of(mesh)) {
    std::fprintf(stderr, "%s: too few vertices for so many cones\n", file.c_str());
    return false;
  }
  std::printf("%s: %zu faces, genus %d\n%-20s %-11s %4s %5s %8s %5s %9s %5s %8s  %s\n", name_of(file).c_str(),
              static_cast<std::size_t>(mesh.number_of_faces()), genus_of(mesh), "mesh", "policy", "seed", "iter.",
              "flips", "halv.", "residual", "bits", "CPU s", "end");
  return run_policy(file, mesh, "ideal", T_splines::Ideal_delaunay_flips(), setting) &&
         run_policy(file, mesh, "degeneracy", T_splines::Degeneracy_flips{false}, setting) &&
         run_policy(file, mesh, "delaunay", T_splines::Degeneracy_flips{true}, setting);
}

int main(const int argc, char** argv)
{
  Arguments arguments(usage, {}, {"--seeds", "--first-seed", "--cones", "--iterations", "--policy"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  const Setting setting{arguments.integer("--first-seed", 1), arguments.integer("--seeds", 20),
                        arguments.integer("--cones", 100), arguments.integer("--iterations", 300),
                        arguments.text("--policy", "")};
  bool is_complete = true;
  for (const std::string& file : arguments.files())
    is_complete = run(file, setting) && is_complete;
  return is_complete ? 0 : 2;
}
