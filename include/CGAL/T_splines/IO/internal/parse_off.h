// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_OFF_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_OFF_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How the records of an OFF file stand in it.
enum class Off_layout {
  LINES,    ///< each vertex and each face begins on a line of its own, and what follows it there is not read
  FREE_FORM ///< any number of them on a line, with no more numbers than the keyword announces
};

/// Parses an OFF file that has one of the layouts.
class Off_parser {
public:
  Off_parser(const std::string_view text, const Off_layout layout, Polygon_soup& soup, Progress& progress)
    : m_scanner(text),
      m_is_free(layout == Off_layout::FREE_FORM),
      m_soup(soup),
      m_progress(progress)
  {
  }

  Mesh_reading_report parse()
  {
    Mesh_reading_report report = parse_header();
    m_soup.points.reserve(std::min(m_number_of_vertices, m_scanner.text_after_line().size()));
    for (std::size_t v = 0; report.success() && v < m_number_of_vertices && m_progress.go_on_after(work_per_line); ++v)
      report = parse_vertex();
    for (std::size_t f = 0; report.success() && f < m_number_of_faces && m_progress.go_on_after(work_per_line); ++f)
      report = parse_face();
    if (report.success() && (m_is_free ? m_scanner.has_token_over_lines() : m_scanner.next_line()))
      return report_syntax(m_scanner, "more lines than the header announces");
    return report;
  }

private:
  Mesh_reading_report parse_header()
  {
    if (!m_scanner.next_line())
      return report_at(m_scanner, Mesh_reading_status::EMPTY);
    std::string_view token;
    m_scanner.next_token(token);
    // Some files have the first count right behind the keyword.
    const std::string_view keyword = token.substr(0, token.find_last_not_of("0123456789") + 1);
    const std::string_view glued_count = token.substr(keyword.size());
    if (!take_keyword(keyword)) {
      const bool is_variant = keyword.size() > 3 && is_keyword(keyword.substr(keyword.size() - 3), "off");
      return is_variant ? report_at(m_scanner, Mesh_reading_status::UNSUPPORTED_VARIANT, keyword)
                        : report_syntax(m_scanner, "the keyword OFF is expected here", token);
    }
    return parse_counts(glued_count);
  }

  /// The keyword says what follows the coordinates of a vertex: a normal, a colour, texture coordinates.
  bool take_keyword(std::string_view keyword)
  {
    const auto take = [&keyword](const std::string_view part) {
      const bool has_part = is_keyword(keyword.substr(0, part.size()), part);
      keyword.remove_prefix(has_part ? part.size() : 0);
      return has_part;
    };
    m_numbers_per_vertex = 3 + (take("st") ? 2 : 0);
    m_numbers_per_vertex += take("c") ? 4 : 0;
    m_numbers_per_vertex += take("n") ? 3 : 0;
    return is_keyword(keyword, "off");
  }

  /// The counts stand on the line of the keyword or on the next one; some programs leave out the number of edges.
  Mesh_reading_report parse_counts(const std::string_view glued_count)
  {
    std::array<std::size_t, 3> counts = {0, 0, 0};
    std::size_t n = glued_count.empty() ? 0 : 1;
    if (n == 1 && !parse_integer(glued_count, counts[0]))
      return report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, glued_count);
    std::string_view token;
    while (n < 3) {
      const bool is_over_lines = m_is_free || n == 0;
      if (!(is_over_lines ? m_scanner.next_token_over_lines(token) : m_scanner.next_token(token)))
        break;
      if (is_keyword(token, "binary"))
        return report_at(m_scanner, Mesh_reading_status::UNSUPPORTED_VARIANT, "OFF BINARY");
      if (!parse_integer(token, counts[n++]))
        return report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, token);
    }
    if (n == 0)
      return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    if (n < (m_is_free ? 3 : 2))
      return report_missing_token(m_scanner, "the number of faces is missing");
    if (!m_is_free && m_scanner.next_token(token))
      return report_syntax(m_scanner, "three counts are expected here", token);
    m_number_of_vertices = counts[0];
    m_number_of_faces = counts[1];
    return Mesh_reading_report();
  }

  /// \return `false` if the file ends before the record begins.
  bool begin_record()
  {
    const bool has_record = m_is_free ? m_scanner.has_token_over_lines() : m_scanner.next_line();
    m_first_line = m_scanner.line();
    return has_record;
  }

  /// What follows a record is a colour if it stands on the line on which the record begins. Behind a record that goes
  /// on over lines it could as well be the rest of the next one, where this one is too short.
  Mesh_reading_report end_record(const char* detail)
  {
    Mesh_reading_report report;
    if (!m_is_free && m_scanner.line() != m_first_line && m_scanner.has_token()) {
      report = report_syntax(m_scanner, detail);
      report.line = m_first_line;
    }
    return report;
  }

  Mesh_reading_report parse_vertex()
  {
    if (!begin_record())
      return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    std::array<double, 3> point = {0, 0, 0};
    Mesh_reading_report report;
    std::string_view token;
    for (std::size_t i = 0; i < (m_is_free ? m_numbers_per_vertex : 3) && report.success(); ++i) {
      double other = 0;
      Mesh_reading_status status = Mesh_reading_status::TRUNCATED;
      if (m_scanner.next_token_over_lines(token))
        status = parse_coordinate(token, i < 3 ? point[i] : other);
      else
        token = {};
      if (status != Mesh_reading_status::SUCCESS)
        report = report_at(m_scanner, status, token);
    }
    if (report.success())
      report = end_record("a coordinate is missing");
    if (!report.success())
      report.vertex = m_soup.points.size();
    m_soup.points.push_back(point);
    m_soup.point_lines.push_back(m_first_line);
    return report;
  }

  Mesh_reading_report parse_face()
  {
    if (!begin_record())
      return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    std::string_view token;
    std::size_t size = 0;
    m_scanner.next_token(token);
    if (!parse_integer(token, size))
      return report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, token);
    Mesh_reading_report report;
    for (std::size_t i = 0; i < size && report.success(); ++i)
      report = parse_corner();
    if (report.success())
      report = end_record("a corner is missing");
    if (!report.success())
      report.face = m_soup.number_of_polygons();
    m_soup.end_polygon();
    m_soup.polygon_lines.push_back(m_first_line);
    return report;
  }

  Mesh_reading_report parse_corner()
  {
    std::string_view token;
    if (!m_scanner.next_token_over_lines(token))
      return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    std::size_t v = 0;
    const bool is_index = parse_integer(token, v);
    if (!is_index || v >= m_soup.points.size()) {
      const bool is_number = is_index || token.find_first_not_of("-+0123456789") == std::string_view::npos;
      return report_at(m_scanner,
                       is_number ? Mesh_reading_status::INDEX_OUT_OF_RANGE : Mesh_reading_status::SYNTAX_ERROR, token);
    }
    m_soup.corners.push_back(v);
    return Mesh_reading_report();
  }

  Text_scanner m_scanner;
  bool m_is_free;
  Polygon_soup& m_soup;
  Progress& m_progress;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0, m_numbers_per_vertex = 3;
  std::size_t m_first_line = 0; ///< of the record
};

/// Parses an OFF file (ASCII, also with normals, colours and texture coordinates, which are not read).
///
/// Records may go on over several lines. A file whose lines do not fit is tried in free form; if this does not fit
/// either, to the last number, the report is that of the lines, where most programs put their records.
/// \param progress if it is interrupted, the report means nothing
inline Mesh_reading_report parse_off(const std::string_view text, Polygon_soup& soup, Progress& progress)
{
  const Mesh_reading_report report = Off_parser(text, Off_layout::LINES, soup, progress).parse();
  if (report.success() || progress.is_interrupted())
    return report;
  Polygon_soup free_soup;
  const Mesh_reading_report free_report = Off_parser(text, Off_layout::FREE_FORM, free_soup, progress).parse();
  if (!free_report.success())
    return report;
  soup = std::move(free_soup);
  return free_report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_OFF_H
