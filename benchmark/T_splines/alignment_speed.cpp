// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The alignment of a map against its metric: how near isolines come to the field and the features, and at what cost.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Approximation/T_spline_approximation.h>
#include <CGAL/T_splines/Cross_field/detect_features.h>
#include <CGAL/T_splines/Cross_field/refine_at_features.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>

namespace T_splines = CGAL::T_splines;
using Approximation = T_splines::T_spline_approximation<Mesh>;

static const char usage[] =
    "usage: alignment_speed MESH... [--angle DEGREES] [--repeats N]\n"
    "\n"
    "Aligns the map of each mesh to its cross field, with its sharp edges on isolines and all scale factors 1 if there "
    "are\n"
    "sharp edges, and prints the angles between isolines and field (mean by area, and what 5 % of it exceeds, in "
    "degrees),\n"
    "of the conformal map, turned as a whole, and aligned; and CPU seconds, best of the repeats.\n"
    "  --angle DEGREES  of sharp edges (default 180: none)\n"
    "  --repeats N      (default 3)\n";

static bool measure(const std::string& file, const double angle, const int repeats)
{
  Mesh given;
  if (!read_mesh(file, given))
    return false;
  const auto sharp = given.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  if (angle < 180 && !T_splines::detect_features(given, sharp, T_splines::parameters::feature_angle(angle)).success())
    return false;
  Mesh mesh;
  const auto features = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if (!T_splines::refine_at_features(given, sharp, mesh, features).success())
    return false;
  double metric = std::numeric_limits<double>::infinity(), alignment = metric;
  Approximation approximation(mesh);
  approximation.set_features(features);
  for (int i = 0; i < repeats; ++i) {
    Stage_times times;
    const auto np = CGAL::parameters::visitor(Stage_clock(times));
    if (!approximation.compute_cross_field() || !approximation.compute_map(np) || !approximation.align_map(np)) {
      std::printf("  %-24s %s\n", name_of(file).c_str(), approximation.report().reason.c_str());
      return false;
    }
    times.end();
    metric = std::min(metric, times["similarity metric"]);
    alignment = std::min(alignment, times["alignment"]);
  }
  const auto& report = approximation.report().alignment;
  constexpr double degree = CGAL_PI / 180;
  std::printf("  %-24s %7zu %7zu %6zu %4zu %6.2f %6.2f %6.2f %6.1f %6.1f %6.1f %5d %6.2f %7.3f %8.3f %6.1f\n",
              name_of(file).c_str(), static_cast<std::size_t>(mesh.number_of_faces()),
              static_cast<std::size_t>(approximation.mapped_mesh().mesh().number_of_faces()),
              report.number_of_constrained_edges, report.edges_not_met.size(), report.before.mean / degree,
              report.rotated.mean / degree, report.after.mean / degree, report.before.quantile_95 / degree,
              report.rotated.quantile_95 / degree, report.after.quantile_95 / degree, report.number_of_steps,
              std::exp(report.largest_log_scale_before), metric, alignment, alignment / metric);
  std::fflush(stdout);
  return true;
}

int main(const int argc, char** argv)
{
  run_with_one_blas_thread(argv);
  Arguments arguments(usage, {}, {"--angle", "--repeats"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  std::printf("  %-24s %7s %7s %6s %4s %20s %20s %5s %6s %7s %8s %6s\n", "mesh", "faces", "refined", "edges", "off",
              "mean: as is, turned,", "95 %: aligned", "steps", "scale", "metric", "aligned", "ratio");
  bool is_complete = true;
  for (const std::string& file : arguments.files())
    is_complete = measure(file, arguments.integer("--angle", 180), arguments.integer("--repeats", 3)) && is_complete;
  return is_complete ? 0 : 2;
}
