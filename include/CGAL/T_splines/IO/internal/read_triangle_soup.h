// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_READ_TRIANGLE_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_READ_TRIANGLE_SOUP_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Boundary_sides.h>
#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/check_polygon_soup.h>
#include <CGAL/T_splines/IO/internal/lowercase_extension.h>
#include <CGAL/T_splines/IO/internal/merge_boundaries.h>
#include <CGAL/T_splines/IO/internal/parse_obj.h>
#include <CGAL/T_splines/IO/internal/parse_off.h>
#include <CGAL/T_splines/IO/internal/parse_ply.h>
#include <CGAL/T_splines/IO/internal/parse_stl.h>
#include <CGAL/T_splines/IO/internal/read_whole_file.h>
#include <CGAL/T_splines/IO/internal/remove_degenerate_triangles.h>
#include <CGAL/T_splines/IO/internal/repair_polygon_soup.h>
#include <CGAL/T_splines/IO/internal/triangulate_polygon_soup.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The report if the visitor stopped the work.
inline Mesh_reading_report interrupted_reading()
{
  Mesh_reading_report report;
  report.status = Mesh_reading_status::INTERRUPTED;
  return report;
}

/// Reads what stands in a file, by the parser of its extension.
inline Mesh_reading_report parse_mesh_file(const std::string& filename, Polygon_soup& soup, Progress& progress)
{
  using Parser = Mesh_reading_report (*)(std::string_view, Polygon_soup&, Progress&);
  const std::string extension = lowercase_extension(filename);
  const Parser parser = extension == ".off"   ? Parser(parse_off)
                        : extension == ".obj" ? Parser(parse_obj)
                        : extension == ".ply" ? Parser(parse_ply)
                        : extension == ".stl" ? Parser(parse_stl)
                                              : Parser(nullptr);
  Mesh_reading_report report;
  std::string content;
  if (parser == nullptr)
    report.status = Mesh_reading_status::UNKNOWN_FORMAT;
  else if (!read_whole_file(filename, content))
    report.status = Mesh_reading_status::CANNOT_OPEN;
  else if (content.find_first_not_of(" \t\r\n") == std::string::npos)
    report.status = Mesh_reading_status::EMPTY;
  else if (extension == ".stl") // binary or text
    report = parse_stl(content, soup, progress);
  else if (has_mark_of_utf_16(content)) {
    report.status = Mesh_reading_status::UNSUPPORTED_VARIANT;
    report.text = "UTF-16";
  }
  else
    report = parser(without_byte_order_mark(content), soup, progress);
  return progress.go_on() ? report : interrupted_reading();
}

/// Counts the boundary edges and the loops that they form.
inline void count_boundary(const Polygon_soup& soup, Mesh_reading_report& report)
{
  const std::vector<Polygon_side> sides = boundary_sides(soup);
  Merged_points loops(soup.points.size());
  std::set<std::size_t> numbers;
  for (const Polygon_side& side : sides)
    loops.unite(side.source, side.target);
  for (const Polygon_side& side : sides)
    numbers.insert(loops.representative(side.source));
  report.number_of_boundary_edges = sides.size();
  report.number_of_boundary_loops = numbers.size();
}

/// What the public readers ask for.
struct Mesh_reading_options {
  bool is_boundary_admitted = false;
  bool are_cracks_admitted = true; ///< boundaries that vanish when what is near is merged
  double merge_distance = -1;      ///< relative to the longest side of the bounding box; negative: nothing is merged
  bool is_repaired = false;
};

/// Counts what stands in the file, before anything is changed.
inline void count_elements(const Polygon_soup& soup, Mesh_reading_report& report)
{
  report.number_of_vertices = soup.points.size();
  report.number_of_faces = soup.number_of_polygons();
  report.number_of_merged_points = soup.number_of_merged_points;
  report.number_of_trailing_bytes = soup.number_of_trailing_bytes;
  report.number_of_triangulated_faces = 0;
  for (std::size_t f = soup.number_of_polygons(); f-- > 0;)
    if (soup.size_of_polygon(f) > 3) {
      ++report.number_of_triangulated_faces;
      report.first_triangulated_face = f;
    }
}

/// Merges or repairs as asked for, checks, and triangulates.
class Soup_triangulation {
public:
  Soup_triangulation(const Mesh_reading_options& options, Polygon_soup& soup, Triangle_soup& triangles,
                     Progress& progress)
    : m_options(options),
      m_soup(soup),
      m_triangles(triangles),
      m_progress(progress)
  {
  }

  /// The elements of the report are those of the file.
  Mesh_reading_report compute()
  {
    Mesh_reading_report counts;
    count_elements(m_soup, counts);
    Mesh_reading_report report = prepare(counts.repairs);
    if (report.success()) {
      counts.number_of_merged_vertices = m_merged.number_of_points;
      counts.merged_distance = relative(m_merged.largest_distance);
      return counts;
    }
    return in_numbers_of_file(report);
  }

  /// Of a mesh that was accepted: how it would have been refused if it may not be open; a success if it is closed.
  Mesh_reading_report boundary_report() const { return in_numbers_of_file(m_boundary_report); }

  /// The largest distance between ends of sides that were made one edge, relative to the longest side of the bounding box.
  double closing_distance() const { return relative(m_merged.closing_distance); }

private:
  Mesh_reading_report in_numbers_of_file(Mesh_reading_report report) const
  {
    if (report.vertex != Mesh_reading_report::none)
      report.vertex = m_soup.number_of_point(report.vertex);
    if (report.other_vertex != Mesh_reading_report::none)
      report.other_vertex = m_soup.number_of_point(report.other_vertex);
    if (report.face != Mesh_reading_report::none)
      report.face = m_soup.number_of_polygon(report.face);
    if (report.other_face != Mesh_reading_report::none)
      report.other_face = m_soup.number_of_polygon(report.other_face);
    return report;
  }

  Mesh_reading_report check()
  {
    Polygon_soup_checker checker(m_soup, m_options.is_boundary_admitted, m_progress);
    const Mesh_reading_report report = checker.check();
    m_boundary_report = checker.boundary_report();
    return report;
  }

  Mesh_reading_report prepare(Mesh_repairs& repairs)
  {
    Mesh_reading_report report;
    if (!m_options.is_repaired)
      report = Polygon_soup_checker(m_soup, true, m_progress).check_polygons();
    if (!report.success())
      return report;
    if (!m_progress.go_on())
      return interrupted_reading();
    merge(repairs);
    m_progress.progress(0.6);
    report = check();
    if (!report.success())
      return report;
    m_triangles = triangulate_polygon_soup(m_soup);
    m_progress.progress(0.9);
    if (m_progress.go_on() && m_options.is_repaired && remove_degenerate_triangles(m_soup, m_triangles, repairs))
      report = check();
    return report.success() ? check_triangle_geometry(m_soup, m_triangles, m_progress) : report;
  }

  void merge(Mesh_repairs& repairs)
  {
    const double side = longest_side(m_soup);
    m_longest_side = std::isfinite(side) ? side : 0; // beyond the range of double, nothing is near
    const double distance = std::max(0., m_options.merge_distance) * m_longest_side;
    const double round_off = default_merge_distance * m_longest_side;
    if (m_options.is_repaired)
      m_merged = repair_polygon_soup(distance, round_off, m_soup, repairs, m_progress);
    else if (m_options.merge_distance >= 0)
      m_merged = merge_boundaries(distance, round_off, Merge_conflicts::AVOIDED, m_soup);
  }

  double relative(const double length) const { return m_longest_side > 0 ? length / m_longest_side : 0; }

  const Mesh_reading_options m_options;
  Polygon_soup& m_soup;
  Triangle_soup& m_triangles;
  Progress& m_progress;
  double m_longest_side = 0;
  Mesh_reading_report m_boundary_report;
  Merged_boundaries m_merged;
};

/// Beyond this distance, merging would change what one sees.
inline constexpr double largest_advised_merge_distance = 1e-3;

/// Whether the whole boundary vanishes when ends of sides that are near each other are merged.
inline bool has_only_cracks(Polygon_soup soup)
{
  const double side = longest_side(soup);
  merge_boundaries(largest_advised_merge_distance * side, default_merge_distance * side, Merge_conflicts::AVOIDED,
                   soup);
  return boundary_sides(soup).empty();
}

/// A number that is not less and has two decimal digits.
inline double rounded_up(const double x)
{
  for (double larger = x;; larger *= 1.01) {
    std::ostringstream text;
    text.precision(2);
    text << larger;
    const double rounded = std::strtod(text.str().c_str(), nullptr);
    if (rounded >= x)
      return rounded;
  }
}

/// Tries what would help against a refusal.
inline void find_remedies(const std::string& filename, const Mesh_reading_options& options, Progress& progress,
                          Mesh_reading_report& report)
{
  Polygon_soup original;
  if (!parse_mesh_file(filename, original, progress).success())
    return;
  double closing_distance = 0;
  const auto succeeds = [&original, &closing_distance, &progress](const Mesh_reading_options& changed) {
    Polygon_soup soup = original;
    Triangle_soup triangles;
    Soup_triangulation triangulation(changed, soup, triangles, progress);
    const bool has_succeeded = triangulation.compute().success();
    closing_distance = triangulation.closing_distance();
    return has_succeeded;
  };
  Mesh_reading_options repairing = options;
  repairing.is_repaired = true;
  report.is_repairable = !options.is_repaired && succeeds(repairing);
  if (report.status != Mesh_reading_status::BOUNDARY)
    return;
  Mesh_reading_options merging = options;
  merging.merge_distance = largest_advised_merge_distance;
  if (!succeeds(merging))
    return;
  merging.merge_distance = rounded_up(closing_distance);
  if (succeeds(merging))
    report.closing_distance = merging.merge_distance;
}

/// Reads a file, checks everything and triangulates: what the public readers have in common.
inline Mesh_reading_report read_triangle_soup(const std::string& filename, const Mesh_reading_options& options,
                                              Polygon_soup& soup, Triangle_soup& triangles, Progress& progress)
{
  if (!progress.go_on())
    return interrupted_reading();
  Mesh_reading_report report = parse_mesh_file(filename, soup, progress);
  if (!report.success())
    return report;
  progress.progress(0.4);
  Soup_triangulation triangulation(options, soup, triangles, progress);
  report = triangulation.compute();
  progress.progress(1);
  if (!progress.go_on())
    return interrupted_reading();
  Mesh_reading_options checked = options;
  if (report.success()) {
    const Mesh_reading_report refusal = triangulation.boundary_report();
    if (refusal.success())
      return report;
    count_boundary(soup, report);
    if (options.are_cracks_admitted || !has_only_cracks(soup))
      return report;
    checked.is_boundary_admitted = false;
    report = refusal;
  }
  if (report.status == Mesh_reading_status::BOUNDARY)
    count_boundary(soup, report);
  if (!options.is_boundary_admitted || !options.are_cracks_admitted)
    find_remedies(filename, checked, progress, report);
  return progress.is_interrupted() ? interrupted_reading() : report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_READ_TRIANGLE_SOUP_H
