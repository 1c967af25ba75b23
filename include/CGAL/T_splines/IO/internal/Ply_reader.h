// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PLY_READER_H
#define CGAL_T_SPLINES_IO_INTERNAL_PLY_READER_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Binary_scanner.h>
#include <CGAL/T_splines/IO/internal/Ply_header.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Reads a PLY file, ASCII or binary in either byte order, and hands its rows number by number to a parser that knows what
/// they mean. The parser has
/// - `Report`, a type with `success()`, `vertex` and `face`, which are set to the row where a report says what is wrong;
/// - `Report converted(const Mesh_reading_report&)`;
/// - `begin_row()`, and `Report end_row(const Ply_element&)`;
/// - `Report begin_list(const Ply_property&, std::size_t length)`;
/// - `Report take(const Ply_property&, double value)`, for each entry of a list, or a number that is none;
/// - `Report at_entry(const Ply_property&, std::size_t i, Report)`, which says where in a list something is wrong.
class Ply_reader {
public:
  /// Whether a row of a file made of text may go on over several lines. In either case it begins on a line of its own, and
  /// nothing follows it on its last one.
  enum class Rows { ARE_LINES, MAY_CONTINUE };

  Ply_reader(const std::string_view data, const Rows rows)
    : m_data(data),
      m_rows(rows),
      m_text(data),
      m_bytes(data, Byte_order::LITTLE)
  {
  }

  Mesh_reading_report read_header()
  {
    const Mesh_reading_report report = m_header.parse(m_text, m_data);
    m_bytes = Binary_scanner(m_text.text_after_line(), m_header.byte_order());
    return report;
  }

  Ply_header& header() { return m_header; }
  const Ply_header& header() const { return m_header; }

  /// \return the first report of a failure. If `progress` is interrupted, it means nothing.
  template <typename Parser>
  typename Parser::Report read_rows(Parser& parser, Progress& progress)
  {
    typename Parser::Report report;
    m_is_in_rows = true;
    for (const Ply_element& element : m_header.elements())
      for (std::size_t row = 0; report.success() && !element.properties.empty() && row < element.count; ++row) {
        if (!progress.go_on_after(work_per_line))
          return report;
        report = read_row(parser, element);
        if (!report.success() && element.name == "vertex")
          report.vertex = row;
        else if (!report.success() && element.name == "face")
          report.face = row;
      }
    return report.success() ? parser.converted(check_end()) : report;
  }

  /// The line where the row begins; `none` in binary files.
  std::size_t line_of_row() const { return m_header.is_text() ? m_line_of_row : Mesh_reading_report::none; }

  /// A report about this place: with its line, but in the rows of binary files.
  Mesh_reading_report report_here(const Mesh_reading_status status, const std::string_view text = {}) const
  {
    Mesh_reading_report report = report_at(m_text, status, text);
    if (m_is_in_rows && !m_header.is_text())
      report.line = Mesh_reading_report::none;
    return report;
  }

  Mesh_reading_report report_syntax(const std::string& detail, const std::string_view text = {}) const
  {
    Mesh_reading_report report = report_here(Mesh_reading_status::SYNTAX_ERROR, text);
    report.detail = detail;
    return report;
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

private:
  template <typename Parser>
  typename Parser::Report read_row(Parser& parser, const Ply_element& element)
  {
    if (m_header.is_text() && !m_text.next_line())
      return parser.converted(report_here(Mesh_reading_status::TRUNCATED));
    m_line_of_row = m_text.line();
    parser.begin_row();
    for (const Ply_property& property : element.properties) {
      const typename Parser::Report report =
          property.is_list() ? read_list(parser, property) : read_number(parser, property);
      if (!report.success())
        return report;
    }
    const Mesh_reading_report end = m_header.is_text() ? check_line_end() : Mesh_reading_report();
    return end.success() ? parser.end_row(element) : parser.converted(end);
  }

  template <typename Parser>
  typename Parser::Report read_number(Parser& parser, const Ply_property& property)
  {
    return read(property.type) ? parser.take(property, m_value) : parser.converted(m_failure);
  }

  template <typename Parser>
  typename Parser::Report read_list(Parser& parser, const Ply_property& property)
  {
    if (!read(property.size_type))
      return parser.converted(m_failure);
    if (!is_ply_index(m_value))
      return parser.converted(report_here(Mesh_reading_status::SYNTAX_ERROR, found()));
    const auto n = static_cast<std::size_t>(m_value);
    typename Parser::Report report = parser.begin_list(property, n);
    for (std::size_t i = 0; report.success() && i < n; ++i) {
      report = read_number(parser, property);
      if (!report.success())
        report = parser.at_entry(property, i, report);
    }
    return report;
  }

  /// Reads a number, finite or not. \return `false`, with `m_failure`, if there is none
  bool read(const Ply_type type)
  {
    if (!m_header.is_text()) {
      if (m_bytes.remaining_bytes() < size_of(type))
        return fail(report_here(Mesh_reading_status::TRUNCATED));
      m_value = read_binary(m_bytes, type);
      return true;
    }
    if (m_rows == Rows::ARE_LINES && !m_text.next_token(m_token))
      return fail(report_missing_token(m_text, missing_number));
    if (m_rows == Rows::MAY_CONTINUE && !m_text.next_token_over_lines(m_token))
      return fail(report_here(Mesh_reading_status::TRUNCATED));
    return parse_number(m_token, m_value) != Token_kind::NO_NUMBER ||
           fail(report_here(Mesh_reading_status::SYNTAX_ERROR, m_token));
  }

  bool fail(const Mesh_reading_report& report)
  {
    m_failure = report;
    return false;
  }

  Mesh_reading_report check_line_end()
  {
    std::string_view token;
    if (!m_text.next_token(token))
      return Mesh_reading_report();
    if (m_text.line() == m_line_of_row)
      return report_syntax("more numbers than the header and the lists announce", token);
    Mesh_reading_report report = report_syntax(missing_number); // it took one of the row that follows
    report.line = m_line_of_row;
    return report;
  }

  Mesh_reading_report check_end()
  {
    if (m_header.is_text() && m_text.next_line())
      return report_syntax("more lines than the header announces");
    if (!m_header.is_text() && m_bytes.remaining_bytes() > 1) // a last line feed is harmless
      return report_syntax("more data than the header announces");
    return Mesh_reading_report();
  }

  static constexpr const char* missing_number = "a number is missing";

  std::string_view m_data;
  Rows m_rows;
  Text_scanner m_text;
  Binary_scanner m_bytes;
  Ply_header m_header;
  bool m_is_in_rows = false;
  std::size_t m_line_of_row = 0;
  double m_value = 0;       // the last number
  std::string_view m_token; // likewise, in files made of text
  Mesh_reading_report m_failure;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PLY_READER_H
