// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guidance.h"

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/IO/read_cone_angles.h>
#include <CGAL/T_splines/IO/read_cones.h>
#include <CGAL/T_splines/IO/read_cross_field.h>
#include <CGAL/T_splines/named_parameters.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace {

using Signature_report = CGAL::T_splines::Holonomy_signature_report<Mesh>;

/// Where the border has corners, as the options say.
struct Border_corners {
  std::optional<std::vector<Approximation::Signature::Corner>> given;
  double angle = CGAL::T_splines::default_corner_angle;

  /// Adds them to named parameters.
  template <typename NamedParameters>
  auto added_to(const NamedParameters& np) const
  {
    return CGAL::T_splines::parameters::corners(given, CGAL::T_splines::parameters::corner_angle(angle, np));
  }
};

/// Reads the file of corners, if there is one.
Failure find_corners(const Options& options, const Mesh& mesh, Border_corners& corners)
{
  corners.angle = options.corner_angle.value_or(corners.angle);
  if (!options.corners.empty() || !options.has_corners)
    corners.given.emplace();
  if (options.corners.empty())
    return {};
  const auto report = CGAL::T_splines::read_cones(options.corners, mesh, *corners.given);
  return report.success() ? Failure() : Failure{options.corners + ": " + describe(report), true};
}

/// Why the last stage of guidance failed.
/// \param source what the stage was about, unless it is the corners that are refused
Failure failure_of(const Options& options, const std::string& source, const Approximation& approximation)
{
  using Status = CGAL::T_splines::T_spline_approximation_status;
  const auto& report = approximation.report();
  const bool is_about_signature = report.status == Status::INVALID_SIGNATURE;
  const bool is_about_corners =
      is_about_signature && !options.corners.empty() &&
      (report.signature.is_corner ||
       report.signature.status == CGAL::T_splines::Holonomy_signature_status::CORNERS_NOT_MET);
  return {(is_about_corners ? options.corners : source) + ": " + report.reason,
          is_about_signature || report.status == Status::INVALID_MESH};
}

/// Merges cones as the options say.
Failure reduce_cones(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress,
                     Approximation& approximation, Figures::Signature& figures)
{
  namespace P = CGAL::T_splines::parameters;
  using Status = CGAL::T_splines::Cone_reduction_status;
  const auto np =
      P::maximum_energy_change(options.cone_energy, P::maximum_number_of_cones(options.largest_number_of_cones))
          .visitor(Progress_handle(progress))
          .sparse_linear_solver(std::ref(solver));
  const bool is_reduced = approximation.reduce_cones(np);
  const auto& report = approximation.report().cone_reduction;
  if (report.status == Status::LIMIT_UNREACHABLE)
    return {"--max-cones " + std::to_string(*options.largest_number_of_cones) +
                ": the surface cannot do with so few cones; the fewest possible are " +
                std::to_string(report.number_of_cones),
            true};
  if (!is_reduced)
    return failure_of(options, options.mesh + ": cone reduction", approximation);
  Figures::Cone_reduction& reduction = figures.reduction.emplace();
  reduction.cones_before = report.number_of_cones_before;
  reduction.cones = report.number_of_cones;
  reduction.loop_turns = report.number_of_loop_turns;
  reduction.splits = report.number_of_splits;
  reduction.merges = report.number_of_merges;
  reduction.energy_before = report.energy_before;
  reduction.energy = report.energy;
  return {};
}

/// Computes the smoothest field, takes its signature, and reduces its cones.
Failure signature_of_computed_field(const Options& options, const Border_corners& corners,
                                    Chosen_spd_solver_traits& solver, Progress& progress, Approximation& approximation,
                                    Figures::Signature& figures)
{
  const auto np =
      CGAL::T_splines::parameters::curvature_alignment(options.curvature_alignment).visitor(Progress_handle(progress));
  if (!approximation.compute_cross_field(corners.added_to(np)))
    return failure_of(options, options.mesh + ": cross field", approximation);
  return options.are_cones_reduced ? reduce_cones(options, solver, progress, approximation, figures) : Failure();
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Reads a field file and takes the signature.
Failure signature_of_field_file(const Options& options, const Border_corners& corners, Mesh& mesh, Progress& progress,
                                Approximation& approximation)
{
  namespace T = CGAL::T_splines;
  const std::string& filename = options.field;
  const auto field = mesh.add_property_map<Face, Kernel::Vector_3>("f:cross").first;
  const auto matching = mesh.add_property_map<Halfedge, int>("h:matching", 0).first;
  const auto np = T::parameters::halfedge_matching_map(matching).visitor(Progress_handle(progress));
  const auto report = T::read_cross_field(filename, mesh, field, np);
  if (!report.success())
    return {filename + ": " + describe(report), true};
  if (approximation.use_cross_field(field,
                                    corners.added_to(T::parameters::align_border(options.is_border_aligned, np))))
    return {};
  Failure failure = failure_of(options, filename, approximation);
  if (approximation.report().signature.status == T::Holonomy_signature_status::FIELD_NOT_ALIGNED)
    failure.message += " (--align-boundary takes its cones for such a field)";
  return failure;
}

/// Reads a cone file, by the parser of its name, and completes the signature.
Failure signature_of_cone_file(const Options& options, const Border_corners& corners, Approximation& approximation)
{
  namespace T = CGAL::T_splines;
  const std::string& filename = options.cones;
  std::vector<Approximation::Signature::Cone> cones;
  T::Field_file_report file_report;
  if (ends_with(filename, ".cones"))
    file_report = T::read_cones(filename, approximation.mesh(), cones);
  else if (ends_with(filename, "Th_hat"))
    file_report = T::read_cone_angles(filename, approximation.mesh(), cones);
  else
    return {filename + ": the file format is not known; cones are read from .cones and .Th_hat", true};
  if (!file_report.success())
    return {filename + ": " + describe(file_report), true};
  const auto np = corners.added_to(CGAL::parameters::default_values());
  const bool has_signature =
      options.loops ? approximation.use_cones(cones, T::parameters::loop_turning_numbers(*options.loops, np))
                    : approximation.use_cones(cones, np);
  if (has_signature)
    return {};
  const bool is_about_loops =
      approximation.report().signature.status == T::Holonomy_signature_status::WRONG_NUMBER_OF_TURNS;
  return failure_of(options, is_about_loops ? "--loops" : filename, approximation);
}

} // namespace

Failure find_signature(const Options& options, Mesh& mesh, Chosen_spd_solver_traits& solver, Progress& progress,
                       Approximation& approximation, Figures::Signature& figures)
{
  Border_corners corners;
  Failure result = find_corners(options, mesh, corners);
  if (result)
    return result;
  if (!options.cones.empty())
    progress.begin_stage("signature");
  if (!options.field.empty()) {
    result = signature_of_field_file(options, corners, mesh, progress, approximation);
    figures.source = "cross field " + std::filesystem::path(options.field).filename().string();
    if (approximation.report().signature.is_aligned)
      figures.source += ", aligned with the border";
  }
  else if (!options.cones.empty()) {
    result = signature_of_cone_file(options, corners, approximation);
    figures.source = "cones " + std::filesystem::path(options.cones).filename().string();
  }
  else {
    result = signature_of_computed_field(options, corners, solver, progress, approximation, figures);
    figures.source = "computed cross field";
  }
  progress.end_stage();
  if (result)
    return result;
  for (const auto& cone : approximation.signature().cones())
    figures.cones.emplace_back(static_cast<std::size_t>(cone.first), cone.second);
  for (const auto& corner : approximation.signature().corners())
    figures.corners.emplace_back(static_cast<std::size_t>(corner.first), corner.second);
  for (const auto& loop : approximation.signature().loops())
    figures.loops.push_back(loop.quarter_turns);
  for (const auto& arc : approximation.signature().arcs())
    figures.arcs.push_back(arc.quarter_turns);
  return result;
}
