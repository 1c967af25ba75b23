// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a seamless similarity map of a mesh and writes it with a report: see help_text in mesh_to_t_spline/Options.h.

#include "mesh_to_t_spline/Figures.h"
#include "mesh_to_t_spline/Options.h"
#include "mesh_to_t_spline/Output_files.h"
#include "mesh_to_t_spline/Progress.h"
#include "mesh_to_t_spline/Refined_map.h"
#include "mesh_to_t_spline/Summary.h"
#include "mesh_to_t_spline/guidance.h"
#include "mesh_to_t_spline/map_computation.h"

#include <CGAL/T_splines/IO/read_triangle_mesh.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

namespace {

constexpr int exit_failure = 1, exit_bad_input = 2, exit_interrupted = 130;

/// How the run ends, if it ends before its time.
struct Outcome {
  int exit_code = EXIT_SUCCESS;
  std::string message;
};

bool read_mesh(const Options& options, Mesh& mesh, Figures::Input& figures, Outcome& outcome)
{
  const CGAL::T_splines::Mesh_reading_report report = CGAL::T_splines::read_triangle_mesh(options.mesh, mesh);
  if (!report.success()) {
    outcome = {exit_bad_input, options.mesh + ": " + describe(report)};
    return false;
  }
  figures.name = std::filesystem::path(options.mesh).filename().string();
  figures.path = options.mesh;
  figures.note = note(report);
  figures.vertices = num_vertices(mesh);
  figures.edges = num_edges(mesh);
  figures.faces = num_faces(mesh);
  auto component = mesh.add_property_map<Face, std::size_t>("f:component").first;
  figures.components = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  mesh.remove_property_map(component);
  const long characteristic =
    static_cast<long>(figures.vertices) - static_cast<long>(figures.edges) + static_cast<long>(figures.faces);
  figures.genus = static_cast<long>(figures.components) - characteristic / 2;
  return true;
}

/// Everything from the mesh to the files.
Outcome run(const Options& options)
{
  Outcome outcome;
  Figures figures;
  Progress progress(options.is_quiet);
  Chosen_spd_solver_traits solver(options.solver);
  figures.version = program_version;

  progress.begin_stage("reading");
  Mesh mesh;
  const bool is_read = read_mesh(options, mesh, figures.input, outcome);
  progress.end_stage();
  if (!is_read)
    return outcome;
  if (!figures.input.note.empty() && !options.is_quiet)
    std::cerr << options.mesh << ": note: " << figures.input.note << "\n";

  Signature signature;
  const Guidance_result guidance = find_signature(options, mesh, solver, progress, signature, figures.signature);
  if (interruption_flag != 0)
    return {exit_interrupted, "interrupted"};
  if (!guidance.message.empty())
    return {guidance.is_bad_input ? exit_bad_input : exit_failure, guidance.message};

  Refined_map refined;
  const std::string failure = compute_map(options, mesh, signature, solver, progress, refined, figures.map);
  if (interruption_flag != 0)
    return {exit_interrupted, "interrupted"};
  if (!failure.empty())
    return {exit_failure, options.mesh + ": " + failure};

  progress.begin_stage("writing");
  figures.refined = refined_figures(refined);
  figures.stages = progress.stages();
  figures.seconds = progress.seconds();
  figures.peak_memory_bytes = peak_memory_bytes();
  outcome.message = write_output_files(options.output_directory, mesh, refined, figures);
  progress.end_stage();
  if (!outcome.message.empty())
    outcome.exit_code = exit_failure;
  else if (!options.is_quiet) {
    figures.stages = progress.stages();
    figures.seconds = progress.seconds();
    print_summary(std::cout, figures);
    std::cout << "  written     map.obj, report.json and report.html in " << options.output_directory << std::endl;
  }
  return outcome;
}

} // namespace

int main(const int argc, char** argv)
{
  Options options;
  std::string error = Options_parser(argc, argv).parse(options);
  if (error.empty() && options.asks_help) {
    std::cout << help_text;
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
