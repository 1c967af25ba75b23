// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The metric in a multiprecision number type.

#include "Arguments.h"
#include "benchmark_input.h"
#include "measurement.h"

#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstddef>
#include <cstdio>
#include <string>

namespace T_splines = CGAL::T_splines;

static const char usage[] = "usage: high_precision MESH... [--tolerance T]\n"
                            "\n"
                            "Computes the metric of each mesh in double and in "
                            "boost::multiprecision::cpp_bin_float_50, with the cones of the .cones file beside\n"
                            "the mesh or of a smooth cross field.\n"
                            "  --tolerance T  on the residual in cpp_bin_float_50 (default 1e-40)\n";

template <typename FT>
static bool measure(const char* name, const Mesh& mesh, const Signature& signature, const double tolerance)
{
  T_splines::Similarity_metric<Mesh, FT> metric;
  const double start = cpu_seconds();
  const auto report = T_splines::compute_similarity_metric(
      mesh, signature, metric,
      T_splines::parameters::number_type(FT(), T_splines::parameters::residual_tolerance(tolerance)));
  const double seconds = cpu_seconds() - start;
  std::printf("  %-18s tolerance %.0e: residual %.1e, %d iterations, %d solves, %zu flips, %.2f s: %s\n   ", name,
              tolerance, report.residual, report.iterations, report.linear_iterations, report.flips, seconds,
              message(report.status));
  for (const double residual : report.residual_history)
    std::printf(" %.1e", residual);
  std::printf("\n");
  std::fflush(stdout);
  return report.success();
}

int main(const int argc, char** argv)
{
  Arguments arguments(usage, {}, {"--tolerance"});
  if (!arguments.parse(argc, argv))
    return arguments.exit_code();
  int exit_code = 0;
  for (const std::string& file : arguments.files()) {
    Mesh mesh;
    Signature signature;
    if (!read_input(file, Signature_source::CONES_OR_FIELD, mesh, signature)) {
      exit_code = 2;
      continue;
    }
    std::printf("%s: %zu faces, %zu cones\n", name_of(file).c_str(), static_cast<std::size_t>(mesh.number_of_faces()),
                signature.cones().size());
    const bool in_double = measure<double>("double", mesh, signature, 1e-12);
    const bool in_50_digits = measure<boost::multiprecision::cpp_bin_float_50>("cpp_bin_float_50", mesh, signature,
                                                                               arguments.real("--tolerance", 1e-40));
    if (exit_code == 0 && !(in_double && in_50_digits))
      exit_code = 1;
  }
  return exit_code;
}
