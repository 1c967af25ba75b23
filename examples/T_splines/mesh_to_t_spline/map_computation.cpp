// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_computation.h"

#include <CGAL/T_splines/Similarity_map/Flip_policy.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/number_type_config.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <functional>
#include <optional>
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

namespace {

void set_alignment_figures(const CGAL::T_splines::Map_alignment_report<Mesh>& report, Figures::Alignment& figures)
{
  constexpr double degree = CGAL_PI / 180;
  figures.status = message(report.status);
  figures.is_aligned = report.success();
  figures.mean_before = report.before.mean / degree;
  figures.mean_rotated = report.rotated.mean / degree;
  figures.mean = report.after.mean / degree;
  figures.most_before = report.before.quantile_95 / degree;
  figures.most_rotated = report.rotated.quantile_95 / degree;
  figures.most = report.after.quantile_95 / degree;
  figures.mean_distortion = report.mean_distortion;
  figures.largest_distortion = report.largest_distortion;
  figures.largest_scale_before = std::exp(report.largest_log_scale_before);
  figures.largest_scale = std::exp(report.largest_log_scale_after);
  figures.steps = report.number_of_steps;
}

} // namespace

Failure align_map(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress,
                  Approximation& approximation, std::optional<Figures::Features>& features,
                  std::optional<Figures::Alignment>& figures)
{
  using Policy = CGAL::T_splines::Scale_policy;
  using Status = CGAL::T_splines::T_spline_approximation_status;
  const bool changes_scales = options.scale_policy == Policy::UNIT || options.scale_policy == Policy::DYADIC;
  if (!features && !changes_scales)
    return {};
  const bool is_aligned = approximation.align_map(CGAL::T_splines::parameters::scale_policy(options.scale_policy)
                                                      .visitor(Progress_handle(progress))
                                                      .sparse_linear_solver(std::ref(solver)));
  progress.end_stage();
  set_alignment_figures(approximation.report().alignment, figures.emplace());
  const Failure failure{options.mesh + ": " + approximation.report().reason, false};
  if (!is_aligned && (!features || approximation.report().status == Status::INTERRUPTED))
    return failure;
  const Mapped& mapped = approximation.mapped_mesh();
  if (!is_aligned) // the map stays what it was
    approximation.release_features();
  if (features) {
    features->edges_not_met = approximation.report().alignment.edges_not_met.size();
    for (const Edge e : mapped.mesh().edges())
      features->edges_of_map += is_aligned && mapped.constrained_edges()[e] ? 1 : 0;
    if (is_aligned)
      features->edges_of_map += features->edges_not_met;
  }
  return {};
}
