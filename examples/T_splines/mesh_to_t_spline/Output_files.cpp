// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_files.h"

#include "report_page.h"

#include <CGAL/T_splines/IO/internal/Atomic_file.h>
#include <CGAL/T_splines/IO/write_map_obj.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_spline_obj.h>
#include <CGAL/T_splines/IO/write_t_spline_vtu.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <deque>
#include <fstream>
#include <ios>
#include <optional>
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
                    results.traced, results.regularized, results.surface_drawing);
}

/// Whether a file has a name of those that the program writes.
bool is_name_of_output(const std::string& name)
{
  constexpr std::array<std::string_view, 6> fixed = {"map.obj",      "t_mesh.ply",  "t_spline.vtu",
                                                     "t_spline.obj", "report.json", "report.html"};
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
  /// \param format is called with a function object that takes pieces of the content
  /// \param title what the list of names says of it; if this is empty, nothing
  template <typename Format>
  void add(const std::string& name, const Format& format, const std::string& title)
  {
    m_names.insert(name);
    Atomic_file& file = m_files.emplace_back(m_directory / name);
    const auto sink = [&file](const std::string_view text) { file.write(text); };
    format(sink);
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
  using Atomic_file = CGAL::T_splines::internal::Atomic_file;

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

template <typename Sink, typename TMesh>
void format_t_mesh(Sink& sink, const TMesh& t_mesh)
{
  CGAL::T_splines::internal::format_t_mesh(sink, t_mesh, CGAL::parameters::default_values());
}

void add_t_spline(const Results& results, Output_files& files)
{
  files.add("t_mesh.ply", [&](auto& sink) { format_t_mesh(sink, results.fitted); });
  const auto level_name = [](const std::size_t i) { return "level_" + std::to_string(i) + ".ply"; };
  const std::size_t number = results.levels.size();
  const std::string title = number < 2 ? level_name(0) : level_name(0) + " to " + level_name(number - 1);
  for (std::size_t i = 0; i < number; ++i)
    files.add(
        level_name(i), [&](auto& sink) { sink(results.levels[i]); }, i == 0 ? title : "");
  files.add("t_spline.vtu",
            [&](auto& sink) { CGAL::T_splines::internal::format_t_spline_vtu(sink, *results.surface); });
  files.add("t_spline.obj", [&](auto& sink) {
    CGAL::T_splines::internal::format_t_spline_obj(sink, *results.surface, results.resolution);
  });
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
  const bool is_written =
      name == "map.obj"                                  ? options.uv.empty()
      : name == "t_mesh.ply"                             ? !options.is_map_only
      : name == "t_spline.vtu" || name == "t_spline.obj" ? options.has_spline && !options.is_map_only
      : name == "report.json" || name == "report.html"   ? true
                                                         : options.has_levels && is_name_of_output(name);
  std::error_code error; // if one of them does not exist
  const std::filesystem::path output = std::filesystem::path(options.output_directory) / name;
  if (!is_written || !std::filesystem::equivalent(input, output, error))
    return {};
  return "the output would replace the input " + input.string() + "; choose another directory with -o";
}

std::string write_output_files(const std::filesystem::path& directory, const std::vector<std::string>& inputs,
                               const Results& results, const Figures& figures, std::string& names)
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
  if (results.surface)
    add_t_spline(results, files);
  else if (results.has_t_mesh)
    files.add("t_mesh.ply", [&](auto& sink) { format_t_mesh(sink, results.t_mesh.t_mesh); });
  const std::string report = figures_as_json(figures);
  files.add("report.json", [&report](auto& sink) { sink(report); });
  files.add("report.html", [&](auto& sink) { write_report_page(sink, report, results); });
  names = files.names();
  const bool has_earlier_run = is_report_of_this_program(directory / "report.json");
  const std::string failure = files.commit();
  return failure.empty() && has_earlier_run ? remove_files_of_earlier_run(directory, files, inputs) : failure;
}
