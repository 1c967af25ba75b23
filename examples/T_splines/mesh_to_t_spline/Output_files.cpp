// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_files.h"

#include "Mapped_mesh_figures.h"
#include "report_page.h"

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/write_map_obj.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_spline_obj.h>
#include <CGAL/T_splines/IO/write_t_spline_ply.h>
#include <CGAL/T_splines/IO/write_t_spline_vtu.h>
#include <CGAL/T_splines/Spline/Tessellation_resolution.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <deque>
#include <fstream>
#include <ios>
#include <optional>
#include <ostream>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace {

/// Hands the report page to `sink`.
template <typename Sink>
void write_report_page(Sink& sink, const std::string& report, const Results& results, const bool is_map_computed)
{
  const Mapped& mapped = results.approximation->mapped_mesh();
  std::optional<Input_edge_finder> finder;
  if (is_map_computed)
    finder.emplace(results.input, mapped);
  const auto is_input_edge = [&finder](const Edge e) { return !finder || (*finder)(e); };
  const Page_frame frame(CGAL::Polygon_mesh_processing::bbox(mapped.mesh()));
  write_report_page(sink, report, frame, page_mesh(mapped, frame, is_input_edge), results.traced, results.regularized,
                    results.surface_drawing);
}

/// Whether a file has a name of those that the program writes.
bool is_name_of_output(const std::string& name)
{
  constexpr std::array<std::string_view, 7> fixed = {"map.obj",           "t_mesh.ply",  "t_spline.vtu", "t_spline.obj",
                                                     "t_spline_mesh.ply", "report.json", "report.html"};
  if (std::find(fixed.begin(), fixed.end(), name) != fixed.end())
    return true;
  constexpr std::string_view begin = "level_", end = ".ply";
  if (name.size() <= begin.size() + end.size() || name.compare(0, begin.size(), begin) != 0 ||
      name.compare(name.size() - end.size(), end.size(), end) != 0)
    return false;
  const std::string number = name.substr(begin.size(), name.size() - begin.size() - end.size());
  return number.find_first_not_of("0123456789") == std::string::npos && (number == "0" || number[0] != '0');
}

/// Whether a file begins as `report.json` does.
bool is_report_of_this_program(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string begin(100, '\0');
  file.read(&begin[0], static_cast<std::streamsize>(begin.size()));
  return begin.find("\"program\": \"mesh_to_t_spline\"") != std::string::npos;
}

/// Files that appear together.
class Output_files {
public:
  explicit Output_files(std::filesystem::path directory) : m_directory(std::move(directory)) {}

  /// Adds a file.
  /// \param format is called with a stream
  /// \param title what the list of names says of it; if this is empty, nothing
  template <typename Format>
  void add(const std::string& name, const Format& format, const std::string& title)
  {
    m_names.insert(name);
    format(m_files.emplace_back(m_directory / name).stream());
    if (!title.empty())
      m_titles.push_back(title);
  }
  template <typename Format>
  void add(const std::string& name, const Format& format)
  {
    add(name, format, name);
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

  bool has(const std::string& name) const { return m_names.count(name) > 0; }

  /// The names as a list in words.
  std::string names() const
  {
    std::string list;
    for (std::size_t i = 0; i < m_titles.size(); ++i)
      list += (i == 0 ? "" : i + 1 == m_titles.size() ? " and " : ", ") + m_titles[i];
    return list;
  }

private:
  using Atomic_file = CGAL::T_splines::Atomic_file;

  static std::string failure(const Atomic_file& file)
  {
    return "cannot write " + file.path().string() + ": " + std::generic_category().message(file.error());
  }

  std::filesystem::path m_directory;
  std::deque<Atomic_file> m_files;
  std::vector<std::string> m_titles;
  std::set<std::string> m_names;
};

/// Removes what has a name of this program's files, but is not of this run. \return what went wrong.
std::string remove_files_of_earlier_run(const std::filesystem::path& directory, const Output_files& files,
                                        const std::vector<std::string>& inputs)
{
  std::error_code error;
  std::vector<std::filesystem::path> old_files;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored; // of files that do not exist
    const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
      return !input.empty() && std::filesystem::equivalent(input, entry->path(), ignored);
    });
    if (is_name_of_output(name) && !files.has(name) && !is_input && entry->is_regular_file(ignored))
      old_files.push_back(entry->path());
  }
  for (const std::filesystem::path& path : old_files)
    if (!error && !std::filesystem::remove(path, error) && error)
      return "cannot remove " + path.string() + " of an earlier run: " + error.message();
  return error ? "cannot read " + directory.string() + ": " + error.message() : "";
}

void add_t_spline(const Options& options, const Results& results, Output_files& files)
{
  namespace T = CGAL::T_splines;
  files.add("t_mesh.ply", [&](std::ostream& out) { T::write_t_mesh(out, results.fitted); });
  const auto level_name = [](const std::size_t i) { return "level_" + std::to_string(i) + ".ply"; };
  const std::size_t number = results.levels.size();
  const std::string title = number < 2 ? level_name(0) : level_name(0) + " to " + level_name(number - 1);
  for (std::size_t i = 0; i < number; ++i)
    files.add(
        level_name(i), [&](std::ostream& out) { out << results.levels[i]; }, i == 0 ? title : "");
  files.add("t_spline.vtu", [&](std::ostream& out) { T::write_t_spline_vtu(out, *results.surface); });
  const T::Tessellation_resolution resolution =
      options.resolution
          ? T::Tessellation_resolution(*options.resolution)
          : T::Tessellation_resolution::within(0.25 * options.tolerance * longest_side_of(*results.approximation));
  if (options.mesh_format == Mesh_format::PLY)
    files.add("t_spline_mesh.ply",
              [&](std::ostream& out) { T::write_t_spline_ply(out, *results.surface, resolution); });
  else
    files.add("t_spline.obj", [&](std::ostream& out) { T::write_t_spline_obj(out, *results.surface, resolution); });
}

} // namespace

std::string check_output_directory(const std::filesystem::path& directory)
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

std::string check_input_stays(const Options& options)
{
  const std::filesystem::path input = options.input_file();
  const std::string name = input.filename().string();
  const bool has_spline = options.has_spline && !options.is_map_only, is_ply = options.mesh_format == Mesh_format::PLY;
  const bool is_written = name == "map.obj"             ? options.uv.empty()
                          : name == "t_mesh.ply"        ? !options.is_map_only
                          : name == "t_spline.vtu"      ? has_spline
                          : name == "t_spline.obj"      ? has_spline && !is_ply
                          : name == "t_spline_mesh.ply" ? has_spline && is_ply
                          : name == "report.json" || name == "report.html"
                              ? true
                              : options.has_levels && is_name_of_output(name);
  std::error_code error; // if one of them does not exist
  const std::filesystem::path output = std::filesystem::path(options.output_directory) / name;
  if (!is_written || !std::filesystem::equivalent(input, output, error))
    return {};
  return "the output would replace the input " + input.string() + "; choose another directory with -o";
}

std::string write_output_files(const Options& options, const Results& results, const Figures& figures,
                               std::string& names)
{
  const std::filesystem::path directory = options.output_directory;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return "cannot make " + directory.string() + ": " + error.message();

  Output_files files(directory);
  const Approximation& approximation = *results.approximation;
  const bool is_map_computed = options.uv.empty();
  if (is_map_computed)
    files.add("map.obj", [&](std::ostream& out) {
      const Mapped& mapped = approximation.mapped_mesh();
      CGAL::T_splines::write_map_obj(out, mapped.mesh(), mapped.uv());
    });
  if (results.surface)
    add_t_spline(options, results, files);
  else if (approximation.has_T_mesh())
    files.add("t_mesh.ply",
              [&](std::ostream& out) { CGAL::T_splines::write_t_mesh(out, approximation.t_mesh().t_mesh()); });
  const std::string report = figures_as_json(figures);
  files.add("report.json", [&report](std::ostream& out) { out << report; });
  files.add("report.html", [&](std::ostream& out) {
    const auto sink = [&out](const std::string_view text) { out << text; };
    write_report_page(sink, report, results, is_map_computed);
  });
  names = files.names();
  const bool has_earlier_run = is_report_of_this_program(directory / "report.json");
  const std::string failure = files.commit();
  if (!failure.empty() || !has_earlier_run)
    return failure;
  return remove_files_of_earlier_run(directory, files, {options.mesh, options.uv, options.field, options.cones});
}
