// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OUTPUT_FILES_H
#define MESH_TO_T_SPLINE_OUTPUT_FILES_H

#include "Figures.h"
#include "Refined_map.h"
#include "report_page.h"

#include <CGAL/T_splines/IO/internal/Atomic_file.h>
#include <CGAL/T_splines/IO/write_map_obj.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

/// \return why nothing can be written to the directory, as far as this can be told beforehand; empty if all seems well.
inline std::string check_output_directory(const std::filesystem::path& directory)
{
  std::error_code error;
  std::filesystem::path existing = std::filesystem::absolute(directory, error).lexically_normal();
  if (existing.filename().empty())
    existing = existing.parent_path();
  while (!std::filesystem::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  if (!std::filesystem::is_directory(existing, error))
    return existing.string() + " is not a directory";
#if defined(__unix__) || defined(__APPLE__)
  if (::access(existing.c_str(), W_OK | X_OK) != 0)
    return existing.string() + ": " + std::generic_category().message(errno);
#endif
  return {};
}

/// Writes all files of the run, or none.
/// \return what went wrong; empty if nothing did.
inline std::string write_output_files(const std::filesystem::path& directory, const Mesh& input, const Refined_map& refined,
                                      const Figures& figures)
{
  using CGAL::T_splines::internal::Atomic_file;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return "cannot make " + directory.string() + ": " + error.message();

  Atomic_file map_file(directory / "map.obj"), json_file(directory / "report.json"), page_file(directory / "report.html");
  const auto map_sink = [&map_file](const std::string_view text) { map_file.write(text); };
  const auto page_sink = [&page_file](const std::string_view text) { page_file.write(text); };
  CGAL::T_splines::internal::format_map_obj(map_sink, refined.mesh, refined.uv, refined.mesh.points());
  const std::string report = figures_as_json(figures);
  json_file.write(report);
  const auto is_cut = [&refined](const Edge e) { return refined.is_cut[e]; };
  write_report_page(page_sink, report,
                    page_mesh(refined.mesh, refined.mesh.points(), refined.uv, Input_edge_finder(input, refined), is_cut));
  const auto failure = [](const Atomic_file& file) {
    return "cannot write " + file.path().string() + ": " + std::generic_category().message(file.error());
  };
  for (Atomic_file* file : {&map_file, &json_file, &page_file})
    if (!file->finish())
      return failure(*file);
  for (Atomic_file* file : {&map_file, &json_file, &page_file})
    if (!file->commit())
      return failure(*file);
  return {};
}

#endif // MESH_TO_T_SPLINE_OUTPUT_FILES_H
