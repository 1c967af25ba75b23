// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh, or a seamless map, to a T-spline surface: see mesh_to_t_spline/Options.h.

#include "mesh_to_t_spline/Failure.h"
#include "mesh_to_t_spline/Figures.h"
#include "mesh_to_t_spline/Option_table.h"
#include "mesh_to_t_spline/Options.h"
#include "mesh_to_t_spline/Options_parser.h"
#include "mesh_to_t_spline/Output_files.h"
#include "mesh_to_t_spline/Progress.h"
#include "mesh_to_t_spline/Mapped_mesh_figures.h"
#include "mesh_to_t_spline/Results.h"
#include "mesh_to_t_spline/Summary.h"
#include "mesh_to_t_spline/features.h"
#include "mesh_to_t_spline/guidance.h"
#include "mesh_to_t_spline/map_computation.h"
#include "mesh_to_t_spline/reading_advice.h"
#include "mesh_to_t_spline/t_mesh_stage.h"
#include "mesh_to_t_spline/t_spline_stage.h"

#include <CGAL/T_splines/IO/fill_holes.h>
#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace {

constexpr int exit_failure = 1, exit_bad_input = 2, exit_interrupted = 130;

/// How the run ends, if it ends before its time.
struct Outcome {
  int exit_code = EXIT_SUCCESS;
  std::string message;
};

/// What is known of a mesh that was read.
Figures::Input input_figures(Mesh& mesh, const std::string& path, const CGAL::T_splines::Mesh_reading_report& report)
{
  Figures::Input figures;
  figures.name = std::filesystem::path(path).filename().string();
  figures.path = path;
  figures.note = note(report);
  figures.merged_vertices = report.number_of_merged_vertices;
  figures.merged_distance = report.merged_distance;
  figures.repairs = report.repairs;
  figures.vertices = num_vertices(mesh);
  figures.edges = num_edges(mesh);
  figures.faces = num_faces(mesh);
  auto component = mesh.add_property_map<Face, std::size_t>("f:component").first;
  figures.components = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  mesh.remove_property_map(component);
  std::vector<Halfedge> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  figures.borders = borders.size();
  const long characteristic =
      static_cast<long>(figures.vertices) - static_cast<long>(figures.edges) + static_cast<long>(figures.faces);
  figures.genus = static_cast<long>(figures.components) - (characteristic + static_cast<long>(borders.size())) / 2;
  return figures;
}

/// The whole run, stage by stage. Each stage returns whether the run goes on.
class Run {
public:
  explicit Run(const Options& options) : m_options(options), m_progress(options.is_quiet), m_solver(options.solver)
  {
    m_figures.version = program_version;
  }

  /// Computes all there is to be written. \return whether there is something
  bool compute()
  {
    const bool has_map = m_options.uv.empty() ? read_mesh() && find_map() : read_map();
    return has_map && (m_options.is_map_only || make_t_mesh());
  }

  /// Whether features were looked for without being asked for, and the surface that is sharp there has faults.
  bool may_give_up_features() const
  {
    return interruption_flag == 0 && !m_options.asks_for_features() && m_figures.features &&
           (m_outcome.exit_code != EXIT_SUCCESS || (m_figures.t_spline && !m_figures.t_spline->is_faultless()));
  }

  /// Whether the surface of another run has fewer faults. \pre there is one
  bool is_worse_than(const Run& other) const
  {
    if (!m_figures.t_spline || m_outcome.exit_code != EXIT_SUCCESS)
      return true;
    const T_spline_figures &mine = *m_figures.t_spline, &others = *other.m_figures.t_spline;
    return others.is_faultless() || (others.is_within_tolerance() && !mine.is_within_tolerance());
  }

  /// Says that this is the surface without the features that another run has found.
  void replaces(const Run& other)
  {
    m_figures.features = other.m_figures.features;
    m_figures.features->given_up =
        other.m_figures.t_spline ? verdict(*other.m_figures.t_spline) : "not found: " + other.m_outcome.message;
  }

  /// \pre `compute()` has returned `true`
  bool write()
  {
    m_progress.begin_stage("writing");
    m_figures.refined = refined_figures(m_results.approximation->mapped_mesh());
    m_figures.stages = m_progress.stages();
    m_figures.seconds = m_progress.seconds();
    m_figures.peak_memory_bytes = peak_memory_bytes();
    std::string names;
    const std::string failure = write_output_files(m_options, m_results, m_figures, names);
    m_progress.end_stage();
    if (!failure.empty())
      return fail(exit_failure, failure);
    if (!m_options.is_quiet) {
      m_figures.stages = m_progress.stages();
      m_figures.seconds = m_progress.seconds();
      print_summary(std::cout, m_figures);
      std::cout << "  written     " << names << " in " << m_options.output_directory << std::endl;
    }
    return true;
  }

  Outcome outcome() const
  {
    if (interruption_flag != 0 && m_outcome.exit_code != EXIT_SUCCESS)
      return {exit_interrupted, "interrupted"};
    return m_outcome;
  }

private:
  bool fail(const int exit_code, const std::string& message)
  {
    m_outcome = {exit_code, message};
    return false;
  }

  bool goes_on(const Failure& failure)
  {
    if (interruption_flag != 0)
      return fail(exit_interrupted, "interrupted");
    return !failure || fail(failure.is_bad_input ? exit_bad_input : exit_failure, failure.message);
  }

  bool end_reading(const CGAL::T_splines::Mesh_reading_report& report)
  {
    m_progress.end_stage();
    if (!report.success())
      return fail(exit_bad_input, m_options.input_file() + ": " + describe(report) + "; " + advice(report));
    say(note(report));
    std::optional<Hole_figures> holes;
    if (m_options.largest_hole && !fill_holes(holes.emplace()))
      return false;
    m_figures.input = input_figures(m_results.input, m_options.input_file(), report);
    if (m_options.looks_for_features() &&
        !goes_on(find_features(m_options, m_progress, m_results.input, m_figures.features)))
      return false;
    m_results.approximation.emplace(m_results.input);
    if (m_figures.features)
      m_results.approximation->set_features(features_of(m_results.input));
    if (m_results.is_data)
      m_results.approximation->set_data(*m_results.is_data);
    m_figures.input.holes = holes;
    return true;
  }

  void say(const std::string& note)
  {
    if (!note.empty() && !m_options.is_quiet)
      std::cerr << m_options.input_file() << ": note: " << note << "\n";
  }

  bool fill_holes(Hole_figures& figures)
  {
    m_results.is_data = m_results.input.add_property_map<Face, bool>("f:is_data").first;
    const auto np = CGAL::T_splines::parameters::face_is_data_map(*m_results.is_data);
    const auto report =
        CGAL::T_splines::fill_holes(m_results.input, *m_options.largest_hole, np.visitor(Progress_handle(m_progress)));
    m_progress.end_stage();
    if (!goes_on(report.success() ? Failure()
                                  : Failure{m_options.mesh + ": " + describe(report, m_results.input), true}))
      return false;
    say(describe(report, m_results.input));
    m_results.input.collect_garbage(); // of holes that could not be filled
    figures = {report.number_of_filled_holes, report.number_of_faces, report.number_of_larger_holes,
               report.number_of_failed_holes};
    return true;
  }

  bool read_mesh()
  {
    namespace P = CGAL::T_splines::parameters;
    const double distance = m_options.merge_distance.value_or(CGAL::T_splines::default_merge_distance);
    const auto np = P::merge_distance(m_options.is_merged ? distance : -1, P::repair(m_options.is_repaired))
                        .visitor(Progress_handle(m_progress));
    return end_reading(CGAL::T_splines::read_triangle_mesh(m_options.mesh, m_results.input, np));
  }

  bool read_map()
  {
    m_figures.signature.source = "map " + std::filesystem::path(m_options.uv).filename().string();
    m_results.uv = m_results.input.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
    return end_reading(CGAL::T_splines::read_map_obj(m_options.uv, m_results.input, m_results.uv,
                                                     CGAL::parameters::visitor(Progress_handle(m_progress))));
  }

  bool find_map()
  {
    if (!find_map(m_options))
      return false;
    const auto& reduction = m_figures.signature.reduction;
    if (!m_figures.features || m_figures.features->edges_not_met == 0 || !reduction || reduction->merges == 0)
      return true;
    Options all_cones = m_options; // with which more features can be met
    all_cones.are_cones_reduced = false;
    m_figures.signature = {};
    m_figures.features->edges_of_map = 0;
    return find_map(all_cones);
  }

  bool find_map(const Options& options)
  {
    if (!goes_on(find_signature(options, m_results.input, m_solver, m_progress, *m_results.approximation,
                                m_figures.signature)))
      return false;
    if (m_figures.features) {
      m_figures.features->soft_edges.clear();
      for (const auto& soft : m_results.approximation->report().feature_field.soft_edges)
        m_figures.features->soft_edges.emplace_back(static_cast<std::size_t>(source(soft.halfedge, m_results.input)),
                                                    static_cast<std::size_t>(target(soft.halfedge, m_results.input)));
    }
    return goes_on(compute_map(options, m_solver, m_progress, *m_results.approximation, m_figures.map.emplace())) &&
           goes_on(align_map(options, m_solver, m_progress, *m_results.approximation, m_figures.features,
                             m_figures.alignment));
  }

  bool make_t_mesh()
  {
    return goes_on(::make_t_mesh(m_options, m_progress, m_results, m_figures)) &&
           (!m_options.has_spline ||
            goes_on(make_t_spline(m_options, m_solver, m_progress, m_results, m_figures.t_spline.emplace())));
  }

  const Options& m_options;
  Outcome m_outcome;
  Figures m_figures;
  Progress m_progress;
  Chosen_spd_solver_traits m_solver;
  Results m_results;
};

/// Runs; once more without features, if these were not asked for and make a surface with faults.
Outcome run(const Options& options)
{
  Run run(options);
  const bool is_computed = run.compute();
  if (run.may_give_up_features()) {
    Options without_features = options;
    without_features.has_features = false;
    Run other(without_features);
    if (other.compute() && run.is_worse_than(other)) {
      other.replaces(run);
      other.write();
      return other.outcome();
    }
    if (!is_computed || interruption_flag != 0)
      return other.outcome();
  }
  if (is_computed)
    run.write();
  return run.outcome();
}

void print_help(const Options& options, std::ostream& out)
{
  if (options.asks_table)
    out << option_table_as_markdown();
  else
    out << help_beginning << option_table_as_text() << help_end;
}

} // namespace

int main(const int argc, char** argv)
{
  Options options;
  std::string error = Options_parser(argc, argv).parse(options);
  if (error.empty() && options.asks_help) {
    print_help(options, std::cout);
    return EXIT_SUCCESS;
  }
  if (error.empty() && options.asks_version) {
    std::cout << "mesh_to_t_spline " << program_version << "\n";
    return EXIT_SUCCESS;
  }
  if (error.empty() && options.solver == Solver_choice::CHOLMOD && !is_cholmod_available)
    error = "--solver cholmod: this program was built without CHOLMOD";
  if (error.empty())
    error = check_output_directory(options.output_directory);
  if (error.empty())
    error = check_input_stays(options);
  if (!error.empty()) {
    std::cerr << "mesh_to_t_spline: " << error << "\nmesh_to_t_spline --help tells the usage.\n";
    return exit_bad_input;
  }

  std::signal(SIGINT, request_interruption);
  std::signal(SIGTERM, request_interruption);
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error of writing like any other
#endif
  try {
    const Outcome outcome = run(options);
    if (!outcome.message.empty())
      std::cerr << "mesh_to_t_spline: " << outcome.message << "\n";
    return outcome.exit_code;
  }
  catch (const std::bad_alloc&) {
    std::cerr << "mesh_to_t_spline: the memory does not suffice\n";
    return exit_failure;
  }
}
