// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_OBJ_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_OBJ_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Parses the polygons of an OBJ file with their texture coordinates; all other statements of the format are skipped.
///
/// Indices may be negative (relative to what has been defined so far) and may refer to vertices that are defined
/// further down; they are checked when the file has been read.
class Obj_parser {
public:
  Obj_parser(const std::string_view text, Polygon_soup& soup, Progress& progress)
    : m_scanner(text, Text_scanner::Backslash::CONTINUES_LINE),
      m_soup(soup),
      m_progress(progress)
  {
  }

  Mesh_reading_report parse()
  {
    Mesh_reading_report report;
    while (report.success() && m_scanner.next_line() && m_progress.go_on_after(work_per_line)) {
      std::string_view keyword;
      m_scanner.next_token(keyword);
      if (is_keyword(keyword, "v"))
        report = parse_vertex();
      else if (is_keyword(keyword, "vt"))
        report = parse_uv();
      else if (is_keyword(keyword, "f"))
        report = parse_face();
      else if (!skip_statement(keyword))
        report = report_syntax(m_scanner, "a statement is expected here", keyword);
    }
    return report.success() && !m_progress.is_interrupted() ? check_indices() : report;
  }

private:
  /// Passes over any statement that begins with a word: programs write more of them than the format knows.
  bool skip_statement(const std::string_view keyword)
  {
    std::string_view token;
    while (m_scanner.next_token(token)) {
    }
    return std::all_of(keyword.begin(), keyword.end(),
                       [](const char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }) &&
           std::isalpha(static_cast<unsigned char>(keyword.front()));
  }

  Mesh_reading_report parse_vertex()
  {
    std::array<double, 3> point;
    Mesh_reading_report report = read_coordinates(m_scanner, point.begin(), point.end());
    if (!report.success())
      report.vertex = m_soup.points.size();
    m_soup.points.push_back(point);
    m_soup.point_lines.push_back(m_scanner.line());
    return report;
  }

  Mesh_reading_report parse_uv()
  {
    std::array<double, 2> uv = {0, 0};
    const std::size_t n = std::min<std::size_t>(2, std::max<std::size_t>(1, m_scanner.count_tokens())); // v is optional
    m_soup.uvs.push_back(uv);
    return read_coordinates(m_scanner, m_soup.uvs.back().begin(), m_soup.uvs.back().begin() + n);
  }

  /// An index as it stands in the file to one that counts from 0. \return `false` if it cannot be one.
  static bool resolve(const std::string_view token, const std::size_t defined, std::size_t& index)
  {
    long long i = 0;
    if (!parse_integer(token, i) || i == 0)
      return false;
    if (i < 0 && static_cast<std::size_t>(-(i + 1)) >= defined)
      return false;
    index = i > 0 ? static_cast<std::size_t>(i - 1) : defined - static_cast<std::size_t>(-i);
    return true;
  }

  Mesh_reading_report parse_face()
  {
    std::string_view token;
    const std::size_t line = m_scanner.line();
    while (m_scanner.next_token(token)) {
      const std::size_t slash = token.find('/');
      std::size_t v = 0, uv = Polygon_soup::no_uv;
      bool valid = resolve(token.substr(0, slash), m_soup.points.size(), v);
      if (slash != std::string_view::npos) {
        std::string_view uv_token = token.substr(slash + 1);
        uv_token = uv_token.substr(0, uv_token.find('/'));
        if (!uv_token.empty())
          valid = resolve(uv_token, m_soup.uvs.size(), uv) && valid;
      }
      if (!valid)
        return report_at_corner(token);
      m_soup.corners.push_back(v);
      m_soup.uv_corners.push_back(uv);
    }
    m_soup.end_polygon();
    m_soup.polygon_lines.push_back(line);
    return Mesh_reading_report();
  }

  Mesh_reading_report report_at_corner(const std::string_view token) const
  {
    const bool is_number = token.find_first_not_of("+-/0123456789") == std::string_view::npos;
    Mesh_reading_report report = report_at(
        m_scanner, is_number ? Mesh_reading_status::INDEX_OUT_OF_RANGE : Mesh_reading_status::SYNTAX_ERROR, token);
    report.face = m_soup.number_of_polygons();
    return report;
  }

  Mesh_reading_report check_indices() const
  {
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
      for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c) {
        const std::size_t v = m_soup.corners[c], uv = m_soup.uv_corners[c];
        const bool is_uv_wrong = uv != Polygon_soup::no_uv && uv >= m_soup.uvs.size();
        if (v < m_soup.points.size() && !is_uv_wrong)
          continue;
        Mesh_reading_report report;
        report.status = Mesh_reading_status::INDEX_OUT_OF_RANGE;
        report.line = m_soup.line_of_polygon(f);
        report.face = f;
        report.text = is_uv_wrong ? "vt " + std::to_string(uv + 1) : "v " + std::to_string(v + 1);
        return report;
      }
    return Mesh_reading_report();
  }

  Text_scanner m_scanner;
  Polygon_soup& m_soup;
  Progress& m_progress;
};

/// Parses an OBJ file. \param progress if it is interrupted, the report means nothing
inline Mesh_reading_report parse_obj(const std::string_view text, Polygon_soup& soup, Progress& progress)
{
  return Obj_parser(text, soup, progress).parse();
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_OBJ_H
