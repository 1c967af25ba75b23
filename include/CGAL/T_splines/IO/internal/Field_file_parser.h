// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_FIELD_FILE_PARSER_H
#define CGAL_T_SPLINES_IO_INTERNAL_FIELD_FILE_PARSER_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/read_whole_file.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Reads a file with a field or with cones token by token, and keeps the report. After the first failure nothing succeeds.
class Field_file_parser {
public:
  /// \param progress asked now and then; it must outlive this
  Field_file_parser(std::istream& input, Progress& progress) : m_progress(progress)
  {
    begin(read_whole_stream(input, m_text));
  }

  Field_file_parser(const std::string& filename, Progress& progress) : m_progress(progress)
  {
    begin(read_whole_file(filename, m_text));
  }

  Field_file_parser(const Field_file_parser&) = delete; // the scanner refers to the text
  Field_file_parser& operator=(const Field_file_parser&) = delete;

  bool success() const { return m_report.success(); }

  Progress& progress() { return m_progress; }

  /// \return whether the visitor has not stopped the work, which would be a failure.
  bool go_on() { return m_progress.go_on() || fail(Field_file_status::INTERRUPTED); }

  /// the report, with the line of the last token.
  const Field_file_report& report()
  {
    const bool is_about_text =
        m_report.status != Field_file_status::UNREADABLE && m_report.status != Field_file_status::INVALID_MESH;
    m_report.line = is_about_text ? (std::max)(m_scanner.line(), first_line) : Field_file_report::none;
    return m_report;
  }

  /// reports a failure. \return `false`
  bool fail(const Field_file_status status, const std::size_t index = Field_file_report::none,
            const long long expected = 0, const long long actual = 0)
  {
    if (!success())
      return false;
    m_report.status = status;
    m_report.index = index;
    m_report.expected = expected;
    m_report.actual = actual;
    return false;
  }

  bool fail_with_text(const Field_file_status status, const std::string_view text)
  {
    if (success())
      m_report.text = quotable(text);
    return fail(status);
  }

  /// names the element that the failure before is about. \return `false`
  bool at_index(const std::size_t index)
  {
    m_report.index = index;
    return false;
  }

  /// whether there is a further token.
  bool has_token() { return success() && m_scanner.has_token_over_lines(); }

  bool read_token(std::string_view& token)
  {
    if (!m_progress.go_on_after(2))
      return fail(Field_file_status::INTERRUPTED);
    return (success() && m_scanner.next_token_over_lines(token)) || fail(Field_file_status::TRUNCATED);
  }

  bool read_number(double& value)
  {
    std::string_view token;
    if (!read_token(token))
      return false;
    const Token_kind kind = parse_number(token, value);
    return kind == Token_kind::FINITE_NUMBER ||
           fail_with_text(kind == Token_kind::NO_NUMBER ? Field_file_status::SYNTAX_ERROR
                                                        : Field_file_status::NON_FINITE_NUMBER,
                          token);
  }

  bool read_integer(long long& value)
  {
    std::string_view token;
    return read_token(token) && (parse_integer(token, value) || fail_with_text(Field_file_status::SYNTAX_ERROR, token));
  }

  /// passes over what is left of the line of the last token.
  void skip_rest_of_line() { m_scanner.skip_rest_of_line(); }

  /// takes the end of the file, with nothing more in front of it.
  bool read_end()
  {
    std::string_view token;
    if (!has_token())
      return success();
    read_token(token);
    return fail_with_text(Field_file_status::TRAILING_DATA, token);
  }

private:
  static constexpr std::size_t first_line = 1;

  void begin(const bool is_readable)
  {
    if (!is_readable)
      fail(Field_file_status::UNREADABLE);
    m_scanner = Text_scanner(without_byte_order_mark(m_text));
    go_on();
  }

  Progress& m_progress;
  std::string m_text;
  Text_scanner m_scanner{{}};
  Field_file_report m_report;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_FIELD_FILE_PARSER_H
