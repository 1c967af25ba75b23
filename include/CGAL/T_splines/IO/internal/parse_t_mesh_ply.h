// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H

#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Binary_scanner.h>
#include <CGAL/T_splines/IO/internal/Ply_header.h>
#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What a T-mesh file needs: numbers of the vertices, then lists of the faces.
enum class T_mesh_property { X, Y, Z, W, VERTEX_INDICES, HALFEDGE_KNOTS, CORNER, OPPOSITE, OTHER };

/// As the writer announces them.
inline std::string_view line_of(const T_mesh_property property)
{
  constexpr std::array<std::string_view, 8> lines = {"property double x",
                                                     "property double y",
                                                     "property double z",
                                                     "property double w",
                                                     "property list uchar int vertex_indices",
                                                     "property list uchar double halfedge_knots",
                                                     "property list uchar uchar corner",
                                                     "property list uchar int opposite"};
  return lines[static_cast<std::size_t>(property)];
}

inline T_mesh_property t_mesh_property(const Ply_element& element, const Ply_property& property)
{
  const bool is_list = property.size_type != Ply_type::NONE;
  const std::string_view name = property.name == "vertex_index" ? "vertex_indices" : property.name;
  for (int i = 0; i < static_cast<int>(T_mesh_property::OTHER); ++i) {
    const auto wanted = static_cast<T_mesh_property>(i);
    const bool is_of_face = wanted >= T_mesh_property::VERTEX_INDICES;
    const std::string_view line = line_of(wanted);
    if (element.name == (is_of_face ? "face" : "vertex") && is_list == is_of_face &&
        name == line.substr(line.find_last_of(' ') + 1))
      return wanted;
  }
  return T_mesh_property::OTHER;
}

/// Parses a T-mesh file, made of text or binary, with any other elements and properties, which are skipped. It checks
/// each row by itself; see `check_t_mesh_soup()` for the rest.
class T_mesh_ply_parser {
public:
  using Report = T_mesh_reading_report;
  using Status = T_mesh_reading_status;

  /// \param progress if it is interrupted, the report means nothing
  T_mesh_ply_parser(const std::string_view data, T_mesh_soup& soup, Progress& progress)
    : m_data(data),
      m_text(data),
      m_bytes(data, Byte_order::LITTLE),
      m_soup(soup),
      m_progress(progress)
  {
  }

  Report parse()
  {
    Report report = parse_header();
    for (const Ply_element& element : m_header.elements())
      for (std::size_t i = 0; report.success() && !element.properties.empty() && i < element.count; ++i) {
        if (!m_progress.go_on_after(work_per_line))
          return report;
        report = parse_row(element, i);
      }
    if (report.success() && m_header.is_text() && m_text.next_line())
      report = syntax_error("more lines than the header announces");
    else if (report.success() && !m_header.is_text() && m_bytes.remaining_bytes() > 1) // a last line feed is harmless
      report = syntax_error("more data than the header announces");
    report.number_of_vertices = m_number_of_vertices;
    report.number_of_faces = m_number_of_faces;
    return report;
  }

private:
  Report report_here(const Status status, const std::string_view text = {}) const
  {
    const Mesh_reading_report line = report_at(m_text, Mesh_reading_status::SYNTAX_ERROR, text);
    Report report;
    report.status = status;
    if (!m_is_in_rows || m_header.is_text())
      report.line = line.line;
    report.text = line.text;
    return report;
  }

  Report syntax_error(const std::string& detail, const std::string_view text = {}) const
  {
    Report report = report_here(Status::SYNTAX_ERROR, text);
    report.detail = detail;
    return report;
  }

  // --- the header

  Report parse_header()
  {
    const Mesh_reading_report header = m_header.parse(m_text, m_data);
    m_bytes = Binary_scanner(m_text.text_after_line(), m_header.byte_order());
    Report report = header.success() ? check_header() : converted(header);
    m_is_in_rows = true;
    return report;
  }

  static Report converted(const Mesh_reading_report& header)
  {
    Report report;
    report.status = header.status == Mesh_reading_status::EMPTY                 ? Status::EMPTY
                    : header.status == Mesh_reading_status::TRUNCATED           ? Status::TRUNCATED
                    : header.status == Mesh_reading_status::UNSUPPORTED_VARIANT ? Status::UNSUPPORTED_VARIANT
                                                                                : Status::SYNTAX_ERROR;
    if (report.status != Status::EMPTY)
      report.line = header.line;
    report.text = header.text;
    report.detail = header.detail;
    return report;
  }

  Report check_header()
  {
    std::array<int, static_cast<std::size_t>(T_mesh_property::OTHER) + 1> number = {};
    std::size_t vertex_elements = 0, face_elements = 0;
    for (const Ply_element& element : m_header.elements()) {
      for (const Ply_property& property : element.properties)
        ++number[static_cast<std::size_t>(t_mesh_property(element, property))];
      if (element.name == "vertex") {
        ++vertex_elements;
        m_number_of_vertices = element.count;
      }
      if (element.name == "face") {
        ++face_elements;
        m_number_of_faces = element.count;
      }
    }
    if (vertex_elements > 1 || face_elements > 1)
      return syntax_error("the elements vertex and face may occur once");
    for (int i = 0; i < static_cast<int>(T_mesh_property::OTHER); ++i) {
      const std::string line = "\"" + std::string(line_of(static_cast<T_mesh_property>(i))) + "\"";
      const char* element = i < static_cast<int>(T_mesh_property::VERTEX_INDICES) ? "vertex" : "face";
      if (number[i] == 0)
        return syntax_error(line + " is needed in the element " + element);
      if (number[i] > 1)
        return syntax_error(line + " may occur once in the element " + element);
    }
    return m_number_of_faces == 0 ? report_here(Status::EMPTY) : Report();
  }

  // --- rows

  Report parse_row(const Ply_element& element, const std::size_t row)
  {
    if (m_header.is_text() && !m_text.next_line())
      return report_here(Status::TRUNCATED);
    Report report;
    m_lengths.fill(unknown);
    for (const Ply_property& property : element.properties)
      if (report.success())
        report = parse_property(property, t_mesh_property(element, property));
    if (report.success() && m_header.is_text())
      report = check_line_end();
    if (element.name == "vertex") {
      m_soup.points.push_back(m_point);
      m_soup.point_lines.push_back(line_of_row());
      report.vertex = report.success() ? report.none : row;
    }
    if (element.name == "face") {
      if (report.success())
        report = check_lengths();
      if (report.success())
        report = check_number_of_corners();
      m_soup.first_halfedge.push_back(m_soup.sources.size());
      m_soup.face_lines.push_back(line_of_row());
      report.face = report.success() ? report.none : row;
    }
    return report;
  }

  std::size_t line_of_row() const { return m_header.is_text() ? m_text.line() : T_mesh_reading_report::none; }

  Report parse_property(const Ply_property& property, const T_mesh_property meaning)
  {
    if (property.size_type == Ply_type::NONE)
      return parse_entry(property.type, meaning);
    constexpr double longest = 4294967295.;
    Report report = read_index(property.size_type, 0, longest, Status::SYNTAX_ERROR);
    const std::size_t n = report.success() ? static_cast<std::size_t>(m_value) : 0;
    if (report.success() && meaning != T_mesh_property::OTHER) {
      length_of(meaning) = n;
      report = check_length(meaning);
    }
    for (std::size_t i = 0; report.success() && i < n; ++i) {
      report = parse_entry(property.type, meaning);
      if (!report.success()) {
        report.index = i;
        report.detail = (report.detail.empty() ? "in the list " : report.detail + " in the list ");
        report.detail += property.name;
      }
    }
    return report;
  }

  Report parse_entry(const Ply_type type, const T_mesh_property meaning)
  {
    Report report;
    switch (meaning) {
    case T_mesh_property::X:
    case T_mesh_property::Y:
    case T_mesh_property::Z:
    case T_mesh_property::W:
      report = read_number(type);
      m_point[static_cast<std::size_t>(meaning)] = m_value;
      if (report.success() && meaning == T_mesh_property::W && !(m_value > 0))
        report = report_here(Status::NON_POSITIVE_WEIGHT, found());
      break;
    case T_mesh_property::VERTEX_INDICES:
      report = read_index(type, 0, static_cast<double>(m_number_of_vertices) - 1, Status::INDEX_OUT_OF_RANGE);
      m_soup.sources.push_back(report.success() ? static_cast<std::size_t>(m_value) : 0);
      break;
    case T_mesh_property::HALFEDGE_KNOTS:
      report = read_number(type);
      m_soup.knots.push_back(m_value);
      if (report.success() && !(m_value > 0))
        report = report_here(Status::NON_POSITIVE_KNOT, found());
      break;
    case T_mesh_property::CORNER:
      report = read_index(type, 0, 1, Status::SYNTAX_ERROR);
      m_soup.is_corner.push_back(m_value == 1);
      break;
    case T_mesh_property::OPPOSITE: {
      constexpr double largest = 9007199254740992.;
      report = read_index(type, -1, largest, Status::INDEX_OUT_OF_RANGE);
      m_soup.opposites.push_back(report.success() && m_value >= 0 ? static_cast<std::size_t>(m_value)
                                                                  : T_mesh_soup::border);
      break;
    }
    case T_mesh_property::OTHER: report = skip_number(type); break;
    }
    return report;
  }

  // --- numbers

  // Where a token is missing the last line of a file was cut off; another line is wrong.
  Report missing_number() const
  {
    return m_text.is_last_line() ? report_here(Status::TRUNCATED) : syntax_error("a number is missing");
  }

  Report read_number(const Ply_type type)
  {
    if (!m_header.is_text()) {
      if (m_bytes.remaining_bytes() < size_of(type))
        return report_here(Status::TRUNCATED);
      m_value = read_binary(m_bytes, type);
      return std::isfinite(m_value) ? Report() : report_here(Status::NON_FINITE_NUMBER, found());
    }
    if (!m_text.next_token(m_token))
      return missing_number();
    const Mesh_reading_status status = parse_coordinate(m_token, m_value);
    if (status == Mesh_reading_status::SUCCESS)
      return Report();
    return report_here(status == Mesh_reading_status::SYNTAX_ERROR ? Status::SYNTAX_ERROR : Status::NON_FINITE_NUMBER,
                       m_token);
  }

  /// \param bad what it is called if it is an integer outside of [low, high]
  Report read_index(const Ply_type type, const double low, const double high, const Status bad)
  {
    const Report report = read_number(type);
    if (report.status == Status::NON_FINITE_NUMBER || (report.success() && m_value != std::floor(m_value)))
      return report_here(Status::SYNTAX_ERROR, found());
    if (!report.success())
      return report;
    return m_value >= low && m_value <= high ? Report() : report_here(bad, found());
  }

  Report skip_number(const Ply_type type)
  {
    if (m_header.is_text())
      return m_text.next_token(m_token) ? Report() : missing_number();
    if (m_bytes.remaining_bytes() < size_of(type))
      return report_here(Status::TRUNCATED);
    read_binary(m_bytes, type);
    return Report();
  }

  /// The last number as it stands in the file, or in a shortest form.
  std::string found() const
  {
    if (m_header.is_text())
      return std::string(m_token);
    std::array<char, 32> digits;
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), m_value);
    return std::string(digits.data(), end.ptr);
  }

  // --- checks of a row

  Report check_line_end() const
  {
    Text_scanner rest(m_text);
    std::string_view token;
    return rest.next_token(token) ? syntax_error("more numbers than the lists announce", token) : Report();
  }

  std::size_t& length_of(const T_mesh_property list)
  {
    return m_lengths[static_cast<std::size_t>(list) - static_cast<std::size_t>(T_mesh_property::VERTEX_INDICES)];
  }

  /// Whether a list is as long as that of the vertices, as far as that is known yet.
  Report check_length(const T_mesh_property list)
  {
    const std::size_t length = length_of(list), wanted = length_of(T_mesh_property::VERTEX_INDICES);
    if (wanted == unknown || length == wanted)
      return Report();
    Report report = report_here(Status::LIST_LENGTHS_DIFFER);
    const std::string_view line = line_of(list);
    report.detail = std::string(line.substr(line.find_last_of(' ') + 1)) + " has " + std::to_string(length) +
                    " entries, vertex_indices " + std::to_string(wanted);
    return report;
  }

  Report check_lengths()
  {
    Report report;
    for (const T_mesh_property list :
         {T_mesh_property::HALFEDGE_KNOTS, T_mesh_property::CORNER, T_mesh_property::OPPOSITE})
      if (report.success())
        report = check_length(list);
    return report;
  }

  Report check_number_of_corners()
  {
    const auto length = static_cast<std::ptrdiff_t>(length_of(T_mesh_property::VERTEX_INDICES));
    const int corners = std::accumulate(m_soup.is_corner.end() - length, m_soup.is_corner.end(), 0);
    Report report;
    if (corners != 4) {
      report = report_here(Status::WRONG_NUMBER_OF_CORNERS);
      report.detail = "it has " + std::to_string(corners);
    }
    return report;
  }

  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  std::string_view m_data;
  Text_scanner m_text;
  Binary_scanner m_bytes;
  T_mesh_soup& m_soup;
  Ply_header m_header;
  Progress& m_progress;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0;
  bool m_is_in_rows = false;
  std::array<double, 4> m_point = {{0, 0, 0, 0}}; // of the row
  std::array<std::size_t, 4> m_lengths = {};      // of the lists of the row
  double m_value = 0;                             // the last number
  std::string_view m_token;                       // likewise, in files made of text
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H
