// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_computation.h"

#include <CGAL/T_splines/Similarity_map/Flip_policy.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/named_parameters.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <functional>
#include <string>

namespace {

using Map_report = CGAL::T_splines::Similarity_map_report<Mesh>;

/// Calls the computation with the flip policy and the number type of the options.
template <typename Compute>
bool with_chosen_types(const Options& options, const Compute& compute)
{
  const auto with_number_type = [&](const auto policy) {
    switch (options.precision) {
    case Precision_choice::DOUBLE: return compute(policy, 0.);
    case Precision_choice::EXTENDED: return compute(policy, 0.L);
    case Precision_choice::QUAD: return compute(policy, boost::multiprecision::cpp_bin_float_quad(0));
    }
    return false;
  };
  if (options.flips == Flips_choice::DELAUNAY)
    return with_number_type(CGAL::T_splines::Ideal_delaunay_flips());
  CGAL::T_splines::Degeneracy_flips policy;
  policy.delaunay = options.flips == Flips_choice::DEGENERACY;
  return with_number_type(policy);
}

} // namespace

Failure compute_map(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress,
                    Approximation& approximation, Map_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  with_chosen_types(options, [&](const auto policy, const auto zero) {
    return approximation.compute_map(
        P::flip_policy(policy, P::number_type(zero, P::residual_tolerance(options.residual_tolerance)))
            .visitor(Progress_handle(progress))
            .number_of_iterations(options.max_iterations)
            .sparse_linear_solver(std::ref(solver)));
  });
  progress.end_stage();

  const Map_report& report = approximation.report().map;
  figures.status = message(report.status);
  figures.converged = report.success();
  figures.residual = report.residual;
  figures.tolerance = options.residual_tolerance;
  figures.residual_history = report.residual_history;
  figures.iterations = report.iterations;
  figures.halvings = report.halvings;
  figures.factorizations = report.factorizations;
  figures.linear_iterations = report.linear_iterations;
  figures.delaunay_flips = report.delaunay_flips;
  figures.flips = report.flips;
  figures.mantissa_bits = report.mantissa_bits;
  figures.solver = options.solver == Solver_choice::LDLT ? "ldlt" : "cholmod";
  figures.flip_policy = options.flips == Flips_choice::DELAUNAY     ? "delaunay"
                        : options.flips == Flips_choice::DEGENERACY ? "degeneracy"
                                                                    : "degeneracy-only";
  if (report.success())
    return {};
  return {options.mesh + ": " + approximation.report().reason};
}
