// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "t_mesh_stage.h"

#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/Tracing/Motorcycle_graph_report.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>

namespace {

using Exact_report = CGAL::T_splines::Exact_map_report<Mesh>;

void set_exact_map_figures(const Exact_report& report, Exact_map_figures& figures)
{
  figures.status = message(report.status);
  figures.cut_edges = report.number_of_cut_edges;
  figures.branches = report.number_of_branches;
  figures.cones = report.number_of_cones;
  figures.determined_corners = report.number_of_determined_corners;
  figures.scale_bits = report.scale_bits;
  figures.is_isometric = report.is_isometric;
  figures.deviation = report.deviation;
  figures.largest_displacement = report.largest_displacement;
  figures.joined_lines = report.number_of_joined_lines;
  figures.lines_left_apart = report.number_of_lines_left_apart;
  figures.largest_gap = report.largest_gap;
}

void set_tracing_figures(const CGAL::T_splines::Motorcycle_graph_report& report, Tracing_figures& figures)
{
  figures.motorcycles = report.motorcycles;
  figures.seeds = report.seeds;
  figures.crossed_faces = report.crossed_faces;
  figures.predicate_calls = report.predicates.calls;
  figures.exact_predicate_calls = report.predicates.exact_calls;
}

/// The cones of a map that was given.
void take_cones(const Mapped& mapped, Figures::Signature& figures)
{
  const Mesh& mesh = mapped.mesh();
  for (const Vertex v : mesh.vertices())
    if (mapped.map().quarter_turns(v) != (mesh.is_border(v) ? 2 : 4))
      figures.cones.emplace_back(static_cast<std::size_t>(v), mapped.map().quarter_turns(v));
}

/// Makes the faces of the motorcycle graph squarer, and finds where they lie then.
bool regularize(Approximation& approximation, Progress& progress, Regularization_figures& figures)
{
  if (!approximation.regularize_T_mesh(CGAL::parameters::visitor(Progress_handle(progress))))
    return false;
  const CGAL::T_splines::T_mesh_regularization_report& report = approximation.report().regularization;
  figures.operations = {{"removals", report.removals},
                        {"flips", report.flips},
                        {"partial_removals", report.partial_removals},
                        {"closed_gaps", report.closed_gaps}};
  figures.t_mesh = figures_of(approximation.t_mesh().t_mesh());
  const bool is_placed = approximation.place_T_mesh(CGAL::parameters::visitor(Progress_handle(progress)));
  progress.end_stage();
  return is_placed;
}

} // namespace

Failure make_t_mesh(const Options& options, Progress& progress, Results& results, Figures& figures)
{
  Approximation& approximation = *results.approximation;
  const auto failure = [&](const bool is_bad_input) {
    return Failure{options.input_file() + ": " + approximation.report().reason, is_bad_input};
  };
  const bool is_given = !options.uv.empty();
  const auto np = CGAL::parameters::visitor(Progress_handle(progress));
  if (!(is_given ? approximation.use_map(results.uv, np) : approximation.make_map_exact(np)))
    return failure(is_given);
  set_exact_map_figures(approximation.report().exact_map, figures.exact_map.emplace());
  if (is_given)
    take_cones(approximation.mapped_mesh(), figures.signature);
  if (!approximation.trace_T_mesh(np))
    return failure(false);
  progress.end_stage();
  T_mesh_stage_figures& of_t_mesh = figures.t_mesh.emplace();
  set_tracing_figures(approximation.report().motorcycle_graph, of_t_mesh.tracing);
  of_t_mesh.traced = figures_of(approximation.t_mesh().t_mesh());
  results.traced = drawing_of(approximation.t_mesh());
  if (options.is_regularized) {
    if (!regularize(approximation, progress, of_t_mesh.regularization.emplace()))
      return failure(false);
    results.regularized = drawing_of(approximation.t_mesh());
  }
  return {};
}
