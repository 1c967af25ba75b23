// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guidance.h"

#include <CGAL/T_splines/Cross_field/IO/read_cone_angles.h>
#include <CGAL/T_splines/Cross_field/IO/read_cones.h>
#include <CGAL/T_splines/Cross_field/IO/read_crossfield.h>
#include <CGAL/T_splines/Cross_field/IO/read_ffield.h>
#include <CGAL/T_splines/Cross_field/IO/read_rawfield.h>
#include <CGAL/T_splines/Cross_field/IO/read_rosy.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/Cross_field/reduce_cones.h>
#include <CGAL/T_splines/named_parameters.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <string>
#include <vector>

namespace {

using Signature_report = CGAL::T_splines::Holonomy_signature_report<Mesh>;
using Cross_field = Mesh::Property_map<Face, Kernel::Vector_3>;

/// What the report names, as the files count: from 0.
std::string describe(const Signature_report& report)
{
  using Status = CGAL::T_splines::Holonomy_signature_status;
  std::string text = message(report.status);
  const std::string numbers = " is " + std::to_string(report.actual) + " instead of " + std::to_string(report.expected);
  const auto index_of = [](const auto descriptor) { return std::to_string(static_cast<std::size_t>(descriptor)); };
  switch (report.status) {
  case Status::VALID: break;
  case Status::INVALID_MESH: text = message(report.mesh.status); break;
  case Status::INVALID_FIELD: text += ": face " + index_of(report.face); break;
  case Status::NULL_VERTEX: text += ": cone " + std::to_string(report.index); break;
  case Status::DUPLICATE_CONE: text += ": vertex " + index_of(report.vertex); break;
  case Status::NON_POSITIVE_CONE:
    text += ": vertex " + index_of(report.vertex) + " has k = " + std::to_string(report.actual);
    break;
  case Status::GAUSS_BONNET_VIOLATED:
    text += ": the sum over component " + std::to_string(report.component) + numbers + " (off by " +
            std::to_string(report.actual - report.expected) + ")";
    break;
  case Status::WRONG_NUMBER_OF_LOOPS:
    text += ": the number in component " + std::to_string(report.component) + numbers;
    break;
  case Status::WRONG_NUMBER_OF_TURNS: text += ": the number of turning numbers" + numbers; break;
  case Status::INVALID_LOOP:
  case Status::LOOP_NOT_INTEGER: text += ": loop " + std::to_string(report.index); break;
  case Status::DEPENDENT_LOOPS: text += ": component " + std::to_string(report.component); break;
  case Status::VERTEX_NOT_INTEGER: text += ": vertex " + index_of(report.vertex); break;
  }
  return text;
}

/// What the report of a field or cone file says, with the line and the element, counted from 0.
std::string describe(const CGAL::T_splines::Field_file_report& report)
{
  using Status = CGAL::T_splines::Field_file_status;
  constexpr std::size_t none = CGAL::T_splines::Field_file_report::none;
  std::string text = report.line == none ? "" : "line " + std::to_string(report.line) + ": ";
  text += message(report.status);
  switch (report.status) {
  case Status::SUCCESS:
  case Status::UNREADABLE:
  case Status::INVALID_MESH: break;
  case Status::WRONG_SYMMETRY:
  case Status::WRONG_COUNT:
    text += " (" + std::to_string(report.actual) + " instead of " + std::to_string(report.expected) + ")";
    break;
  case Status::INDEX_OUT_OF_RANGE:
    text +=
        " (vertex " + std::to_string(report.actual) + ", counted from 0, of " + std::to_string(report.expected) + ")";
    break;
  case Status::DUPLICATE_CONE:
  case Status::NOT_A_QUARTER_TURN: text += " (vertex " + std::to_string(report.index) + ", counted from 0)"; break;
  case Status::NON_POSITIVE_CONE:
    text +=
        " (vertex " + std::to_string(report.index) + ", counted from 0, has k = " + std::to_string(report.actual) + ")";
    break;
  case Status::ZERO_VECTOR:
  case Status::NOT_TANGENT:
  case Status::NOT_A_CROSS:
  case Status::WRONG_FACE:
  case Status::INCONSISTENT_MATCHING: text += " (face " + std::to_string(report.index) + ", counted from 0)"; break;
  case Status::TRUNCATED:
  case Status::SYNTAX_ERROR:
  case Status::NON_FINITE_NUMBER:
  case Status::TRAILING_DATA:
  case Status::MISSING_SECTION:
    if (report.index != none)
      text += " (element " + std::to_string(report.index) + ", counted from 0)";
    break;
  }
  return report.text.empty() ? text : text + ": \"" + report.text + "\"";
}

/// Takes the signature of a field.
template <typename NamedParameters>
Failure take_signature(const std::string& source, const Mesh& mesh, const Cross_field field, const bool is_file,
                       const NamedParameters& np, Signature& signature)
{
  const Signature_report report = CGAL::T_splines::holonomy_signature_of_cross_field(mesh, field, signature, np);
  return report.success() ? Failure() : Failure{source + ": " + describe(report), is_file};
}

/// Merges cones as the options say.
Failure reduce_cones(const Options& options, const Mesh& mesh, Chosen_spd_solver_traits& solver, Progress& progress,
                     Signature& signature, Figures::Signature& figures)
{
  using Status = CGAL::T_splines::Cone_reduction_status;
  const auto np =
      CGAL::T_splines::parameters::maximum_energy_change(
          options.cone_energy, CGAL::T_splines::parameters::maximum_number_of_cones(options.largest_number_of_cones))
          .visitor(Progress_handle(progress))
          .sparse_linear_solver(std::ref(solver));
  const auto report = CGAL::T_splines::reduce_cones(mesh, signature, np);
  if (report.status == Status::LIMIT_UNREACHABLE)
    return {"--max-cones " + std::to_string(*options.largest_number_of_cones) +
                ": the surface cannot do with so few cones; the fewest possible are " +
                std::to_string(report.number_of_cones),
            true};
  if (!report.success())
    return {options.mesh + ": cone reduction: " + message(report.status), false};
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
Failure signature_of_computed_field(const Options& options, Mesh& mesh, Chosen_spd_solver_traits& solver,
                                    Progress& progress, Signature& signature, Figures::Signature& figures)
{
  const Cross_field field = mesh.add_property_map<Face, Kernel::Vector_3>("f:cross").first;
  const auto matchings = mesh.add_property_map<Halfedge, int>("h:matching", 0).first;
  const auto np = CGAL::T_splines::parameters::curvature_alignment(
                      options.curvature_alignment, CGAL::T_splines::parameters::halfedge_matching_map(matchings))
                      .visitor(Progress_handle(progress));
  const auto report = CGAL::T_splines::compute_smooth_cross_field(mesh, field, np);
  if (!report.success())
    return {options.mesh + ": cross field: " + message(report.status), false};
  const Failure failure = take_signature(options.mesh + ": computed cross field", mesh, field, false,
                                         CGAL::T_splines::parameters::halfedge_matching_map(matchings), signature);
  if (failure || !options.are_cones_reduced)
    return failure;
  return reduce_cones(options, mesh, solver, progress, signature, figures);
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Reads a field file, by the parser of its extension, and takes the signature.
Failure signature_of_field_file(const std::string& filename, Mesh& mesh, Signature& signature)
{
  namespace T = CGAL::T_splines;
  const Cross_field field = mesh.add_property_map<Face, Kernel::Vector_3>("f:cross").first;
  auto matching = mesh.add_property_map<Halfedge, int>("h:matching", 0).first;
  std::ifstream input(filename, std::ios::binary);
  T::Field_file_report report;
  if (ends_with(filename, ".rawfield"))
    report = T::read_rawfield(input, mesh, field);
  else if (ends_with(filename, ".crossfield"))
    report = T::read_crossfield(input, mesh, field);
  else if (ends_with(filename, ".rosy"))
    report = T::read_rosy(input, mesh, field);
  else if (ends_with(filename, ".ffield"))
    report = T::read_ffield(input, mesh, field, matching);
  else
    return {filename + ": the file format is not known; fields are read from .rawfield, .crossfield, .rosy and .ffield",
            true};
  if (!report.success())
    return {filename + ": " + describe(report), true};
  if (ends_with(filename, ".ffield"))
    return take_signature(filename, mesh, field, true, T::parameters::halfedge_matching_map(matching), signature);
  return take_signature(filename, mesh, field, true, CGAL::parameters::default_values(), signature);
}

/// Reads a cone file, by the parser of its name, and completes the signature.
Failure signature_of_cone_file(const Options& options, const Mesh& mesh, Signature& signature)
{
  namespace T = CGAL::T_splines;
  const std::string& filename = options.cones;
  std::ifstream input(filename, std::ios::binary);
  std::vector<Signature::Cone> cones;
  T::Field_file_report file_report;
  if (ends_with(filename, ".cones"))
    file_report = T::read_cones(input, mesh, cones);
  else if (ends_with(filename, "Th_hat"))
    file_report = T::read_cone_angles(input, mesh, cones);
  else
    return {filename + ": the file format is not known; cones are read from .cones and .Th_hat", true};
  if (!file_report.success())
    return {filename + ": " + describe(file_report), true};
  const Signature_report report =
      options.loops
          ? T::holonomy_signature_of_cones(mesh, cones, signature, T::parameters::loop_turning_numbers(*options.loops))
          : T::holonomy_signature_of_cones(mesh, cones, signature);
  if (report.success())
    return {};
  const bool is_about_loops = report.status == T::Holonomy_signature_status::WRONG_NUMBER_OF_TURNS;
  return {(is_about_loops ? "--loops" : filename) + ": " + describe(report), true};
}

} // namespace

Failure find_signature(const Options& options, Mesh& mesh, Chosen_spd_solver_traits& solver, Progress& progress,
                       Signature& signature, Figures::Signature& figures)
{
  Failure result;
  if (!options.field.empty() || !options.cones.empty())
    progress.begin_stage("signature");
  if (!options.field.empty()) {
    result = signature_of_field_file(options.field, mesh, signature);
    figures.source = "cross field " + std::filesystem::path(options.field).filename().string();
  }
  else if (!options.cones.empty()) {
    result = signature_of_cone_file(options, mesh, signature);
    figures.source = "cones " + std::filesystem::path(options.cones).filename().string();
  }
  else {
    result = signature_of_computed_field(options, mesh, solver, progress, signature, figures);
    figures.source = "computed cross field";
  }
  progress.end_stage();
  for (const Signature::Cone& cone : signature.cones())
    figures.cones.emplace_back(static_cast<std::size_t>(cone.first), cone.second);
  for (const Signature::Loop& loop : signature.loops())
    figures.loops.push_back(loop.quarter_turns);
  return result;
}
