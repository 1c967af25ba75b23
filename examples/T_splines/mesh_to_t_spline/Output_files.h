// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OUTPUT_FILES_H
#define MESH_TO_T_SPLINE_OUTPUT_FILES_H

#include "Figures.h"
#include "Refined_map.h"
#include "Surface_drawing.h"
#include "Surface_t_mesh.h"
#include "report_page.h"
#include "t_spline_stage.h"

#include <CGAL/T_splines/IO/internal/Atomic_file.h>
#include <CGAL/T_splines/IO/write_map_obj.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_spline_obj.h>
#include <CGAL/T_splines/IO/write_t_spline_vtu.h>

#include <CGAL/Named_function_parameters.h>

#include <cerrno>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

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

/// What the files are made of.
struct Results {
  Mesh input;           ///< empty if the map was given
  bool has_map = false; ///< whether the map was computed
  Refined_map refined;
  bool has_t_mesh = false;
  Surface_t_mesh t_mesh;
  T_mesh_drawing traced, regularized; ///< empty where there is none
  std::optional<Compiled_t_spline> t_spline;
  int resolution = 8;      ///< of the tessellation
  Surface_drawing surface; ///< empty where there is none
};

/// Hands the report page to `sink`.
template <typename Sink>
void write_report_page(Sink& sink, const std::string& report, const Results& results)
{
  const Refined_map& refined = results.refined;
  std::optional<Input_edge_finder> finder;
  if (results.has_map)
    finder.emplace(results.input, refined);
  const auto is_input_edge = [&finder](const Edge e) { return !finder || (*finder)(e); };
  const auto is_cut = [&refined](const Edge e) { return refined.is_cut[e]; };
  const Page_frame frame = page_frame(refined.mesh, refined.mesh.points());
  write_report_page(sink, report, frame,
                    page_mesh(refined.mesh, refined.mesh.points(), refined.uv, frame, is_input_edge, is_cut),
                    results.traced, results.regularized, results.surface);
}

/// Files that appear together.
class Output_files {
public:
  explicit Output_files(std::filesystem::path directory) : m_directory(std::move(directory)) {}

  /// Adds a file. \param format is called with a function object that takes pieces of the content
  template <typename Format>
  void add(const char* name, const Format& format)
  {
    Atomic_file& file = m_files.emplace_back(m_directory / name);
    const auto sink = [&file](const std::string_view text) { file.write(text); };
    format(sink);
    m_names.push_back(name);
  }

  /// Publishes the files. \return what went wrong; empty if nothing did.
  std::string commit()
  {
    for (Atomic_file& file : m_files)
      if (!file.finish())
        return failure(file);
    for (Atomic_file& file : m_files)
      if (!file.commit())
        return failure(file);
    return {};
  }

  /// The names as a list in words.
  std::string names() const
  {
    std::string list;
    for (std::size_t i = 0; i < m_names.size(); ++i)
      list += (i == 0 ? "" : i + 1 == m_names.size() ? " and " : ", ") + m_names[i];
    return list;
  }

private:
  using Atomic_file = CGAL::T_splines::internal::Atomic_file;

  static std::string failure(const Atomic_file& file)
  {
    return "cannot write " + file.path().string() + ": " + std::generic_category().message(file.error());
  }

  std::filesystem::path m_directory;
  std::deque<Atomic_file> m_files;
  std::vector<std::string> m_names;
};

/// Writes all files of the run, or none.
/// \param names receives the names of the files
/// \return what went wrong; empty if nothing did.
inline std::string write_output_files(const std::filesystem::path& directory, const Results& results,
                                      const Figures& figures, std::string& names)
{
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return "cannot make " + directory.string() + ": " + error.message();

  Output_files files(directory);
  if (results.has_map)
    files.add("map.obj", [&](auto& sink) {
      const Refined_map& refined = results.refined;
      CGAL::T_splines::internal::format_map_obj(sink, refined.mesh, refined.uv, refined.mesh.points());
    });
  if (results.has_t_mesh)
    files.add("t_mesh.ply", [&](auto& sink) {
      const Surface_t_mesh& t = results.t_mesh;
      CGAL::T_splines::internal::format_t_mesh(sink, t.mesh, t.knots, t.corners, CGAL::parameters::default_values());
    });
  if (results.t_spline) {
    files.add("t_spline.vtu",
              [&](auto& sink) { CGAL::T_splines::internal::format_t_spline_vtu(sink, *results.t_spline); });
    files.add("t_spline.obj", [&](auto& sink) {
      CGAL::T_splines::internal::format_t_spline_obj(sink, *results.t_spline, results.resolution);
    });
  }
  const std::string report = figures_as_json(figures);
  files.add("report.json", [&report](auto& sink) { sink(report); });
  files.add("report.html", [&](auto& sink) { write_report_page(sink, report, results); });
  names = files.names();
  return files.commit();
}

#endif // MESH_TO_T_SPLINE_OUTPUT_FILES_H
