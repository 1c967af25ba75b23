// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_PLY_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_PLY_H

#include <CGAL/T_splines/IO/internal/Binary_scanner.h>
#include <CGAL/T_splines/IO/internal/Ply_header.h>
#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Parses a PLY file: ASCII or binary in either byte order, with any other elements and properties, which are skipped.
class Ply_parser {
public:
  Ply_parser(const std::string_view data, Polygon_soup& soup, Progress& progress)
    : m_data(data),
      m_text(data),
      m_bytes(data, Byte_order::LITTLE),
      m_soup(soup),
      m_progress(progress)
  {
  }

  Mesh_reading_report parse()
  {
    Mesh_reading_report report = m_header.parse(m_text, m_data);
    m_bytes = Binary_scanner(m_text.text_after_line(), m_header.byte_order());
    if (report.success() && !has_points_and_faces())
      report =
          report_syntax(m_text, "element vertex with x, y, z and element face with list vertex_indices are needed");
    for (const Ply_element& element : m_header.elements())
      for (std::size_t i = 0; report.success() && !element.properties.empty() && i < element.count; ++i) {
        if (!m_progress.go_on_after(work_per_line))
          return report;
        report = parse_row(element, i);
      }
    if (report.success() && m_header.is_text() && m_text.next_line())
      report = report_syntax(m_text, "more lines than the header announces");
    else if (report.success() && !m_header.is_text() && m_bytes.remaining_bytes() > 1) { // a last line feed is harmless
      report.status = Mesh_reading_status::SYNTAX_ERROR;
      report.detail = "more data than the header announces";
    }
    return report.success() ? check_indices() : report;
  }

private:
  bool has_points_and_faces() const
  {
    std::size_t coordinates = 0, lists = 0;
    for (const Ply_element& element : m_header.elements())
      for (const Ply_property& property : element.properties) {
        coordinates += coordinate_index(element, property) < 3;
        lists += is_corner_list(element, property);
      }
    return coordinates == 3 && lists == 1;
  }

  static std::size_t coordinate_index(const Ply_element& element, const Ply_property& property)
  {
    if (element.name != "vertex" || property.size_type != Ply_type::NONE || property.name.size() != 1)
      return 3;
    return std::min<std::size_t>(3, std::string_view("xyz").find(property.name));
  }

  static bool is_corner_list(const Ply_element& element, const Ply_property& property)
  {
    return element.name == "face" && property.size_type != Ply_type::NONE &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  /// A row of text begins on a line of its own; it may go on over several lines, and nothing follows it there.
  Mesh_reading_report parse_row(const Ply_element& element, const std::size_t row)
  {
    Mesh_reading_report report;
    std::array<double, 3> point = {0, 0, 0};
    if (m_header.is_text() && !m_text.next_line())
      return report_at(m_text, Mesh_reading_status::TRUNCATED);
    m_line_of_row = m_text.line();
    for (const Ply_property& property : element.properties) {
      report = parse_property(element, property, point);
      if (!report.success())
        return name_row(element, row, report);
    }
    std::string_view token;
    if (m_header.is_text() && m_text.line() != m_line_of_row && m_text.has_token()) {
      report = report_syntax(m_text, "a number is missing");
      report.line = m_line_of_row;
      return name_row(element, row, report);
    }
    if (m_header.is_text() && m_text.next_token(token))
      return name_row(element, row, report_at(m_text, Mesh_reading_status::SYNTAX_ERROR, token));
    end_row(element, point);
    return report;
  }

  Mesh_reading_report parse_property(const Ply_element& element, const Ply_property& property,
                                     std::array<double, 3>& point)
  {
    double value = 1;
    Mesh_reading_report report;
    if (property.size_type != Ply_type::NONE)
      report = read_number(property.size_type, value);
    if (report.success() && !is_ply_index(value))
      report = report_here(Mesh_reading_status::SYNTAX_ERROR);
    const std::size_t coordinate = coordinate_index(element, property);
    const bool is_corner = is_corner_list(element, property);
    const std::size_t n = report.success() ? static_cast<std::size_t>(value) : 0;
    for (std::size_t i = 0; report.success() && i < n; ++i) {
      report = read_number(property.type, value);
      if (report.success() && coordinate < 3)
        report = take_coordinate(value, point[coordinate]);
      if (report.success() && is_corner)
        report = take_corner(value);
    }
    return report;
  }

  Mesh_reading_report take_coordinate(const double value, double& coordinate) const
  {
    coordinate = value;
    return std::isfinite(value) ? Mesh_reading_report() : report_here(Mesh_reading_status::NON_FINITE_COORDINATE);
  }

  Mesh_reading_report take_corner(const double value)
  {
    if (!is_ply_index(value))
      return report_here(Mesh_reading_status::INDEX_OUT_OF_RANGE);
    m_soup.corners.push_back(static_cast<std::size_t>(value));
    return Mesh_reading_report();
  }

  void end_row(const Ply_element& element, const std::array<double, 3>& point)
  {
    if (element.name == "vertex") {
      m_soup.points.push_back(point);
      if (m_header.is_text())
        m_soup.point_lines.push_back(m_line_of_row);
    }
    else if (element.name == "face") {
      m_soup.end_polygon();
      if (m_header.is_text())
        m_soup.polygon_lines.push_back(m_line_of_row);
    }
  }

  static Mesh_reading_report name_row(const Ply_element& element, const std::size_t row, Mesh_reading_report report)
  {
    if (element.name == "vertex")
      report.vertex = row;
    else if (element.name == "face")
      report.face = row;
    return report;
  }

  Mesh_reading_report report_here(const Mesh_reading_status status) const
  {
    Mesh_reading_report report;
    report.status = status;
    if (m_header.is_text())
      report.line = m_text.line();
    return report;
  }

  Mesh_reading_report read_number(const Ply_type type, double& value)
  {
    if (m_header.is_text()) {
      std::string_view token;
      if (!m_text.next_token_over_lines(token))
        return report_at(m_text, Mesh_reading_status::TRUNCATED);
      const bool is_number = parse_coordinate(token, value) != Mesh_reading_status::SYNTAX_ERROR;
      return is_number ? Mesh_reading_report() : report_at(m_text, Mesh_reading_status::SYNTAX_ERROR, token);
    }
    if (m_bytes.remaining_bytes() < size_of(type))
      return report_here(Mesh_reading_status::TRUNCATED);
    value = read_binary(m_bytes, type);
    return Mesh_reading_report();
  }

  Mesh_reading_report check_indices() const
  {
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
      for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c)
        if (m_soup.corners[c] >= m_soup.points.size()) {
          Mesh_reading_report report;
          report.status = Mesh_reading_status::INDEX_OUT_OF_RANGE;
          report.line = m_soup.line_of_polygon(f);
          report.face = f;
          report.text = std::to_string(m_soup.corners[c]);
          return report;
        }
    return Mesh_reading_report();
  }

  std::string_view m_data;
  Text_scanner m_text;
  Binary_scanner m_bytes;
  Polygon_soup& m_soup;
  Progress& m_progress;
  Ply_header m_header;
  std::size_t m_line_of_row = 0;
};

/// Parses a PLY file. \param progress if it is interrupted, the report means nothing
inline Mesh_reading_report parse_ply(const std::string_view data, Polygon_soup& soup, Progress& progress)
{
  return Ply_parser(data, soup, progress).parse();
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_PLY_H
