// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_FIELD_FILE_PARSER_H
#define CGAL_T_SPLINES_IO_INTERNAL_FIELD_FILE_PARSER_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Reads a text token by token, knows the line of each, and keeps the report. After the first failure nothing succeeds.
///
/// Comments run from `#` to the end of the line.
class Field_file_parser {
public:
  /// \param progress asked now and then; it must outlive this
  Field_file_parser(std::istream& input, Progress& progress) : m_progress(progress)
  {
    if (!input.good() || input.rdbuf() == nullptr) {
      fail(Field_file_status::UNREADABLE);
      return;
    }
    // The buffer itself neither sets flags of the stream nor throws because of them.
    constexpr std::streamsize size_of_block = 1 << 16;
    std::streamsize number_read = 0;
    do {
      const std::size_t size = m_text.size();
      m_text.resize(size + size_of_block);
      number_read = input.rdbuf()->sgetn(&m_text[size], size_of_block);
      m_text.resize(size + static_cast<std::size_t>(number_read));
    } while (number_read == size_of_block && m_progress.go_on_after(size_of_block / 256));
    go_on();
  }

  bool success() const { return m_report.success(); }

  Progress& progress() { return m_progress; }

  /// \return whether the visitor has not stopped the work, which would be a failure.
  bool go_on() { return m_progress.go_on() || fail(Field_file_status::INTERRUPTED); }

  /// the report, with the line of the last token.
  const Field_file_report& report()
  {
    m_report.line = m_line;
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
    constexpr std::size_t longest = 40;
    if (success())
      for (const char c : text.substr(0, longest))
        m_report.text += c >= ' ' && c <= '~' ? c : '?';
    return fail(status);
  }

  /// names the element that the failure before is about. \return `false`
  bool at_index(const std::size_t index)
  {
    m_report.index = index;
    return false;
  }

  /// whether there is a further token.
  bool has_token()
  {
    skip_blanks();
    return success() && m_position < m_text.size();
  }

  bool read_token(std::string_view& token)
  {
    if (!m_progress.go_on_after(2))
      return fail(Field_file_status::INTERRUPTED);
    if (!has_token())
      return fail(Field_file_status::TRUNCATED);
    const std::size_t begin = m_position;
    while (m_position < m_text.size() && !is_blank(m_text[m_position]) && m_text[m_position] != '#')
      ++m_position;
    token = std::string_view(m_text).substr(begin, m_position - begin);
    return true;
  }

  bool read_number(double& value)
  {
    std::string_view token;
    if (!read_token(token))
      return false;
    const std::string_view digits = without_plus(token);
    const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ptr != digits.data() + digits.size() || result.ec == std::errc::invalid_argument)
      return fail_with_text(Field_file_status::SYNTAX_ERROR, token);
    if (result.ec == std::errc::result_out_of_range)
      value = std::strtod(std::string(digits).c_str(), nullptr); // what underflows is rounded
    return std::isfinite(value) || fail_with_text(Field_file_status::NON_FINITE_NUMBER, token);
  }

  bool read_integer(long long& value)
  {
    std::string_view token;
    if (!read_token(token))
      return false;
    const std::string_view digits = without_plus(token);
    const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return (result.ec == std::errc() && result.ptr == digits.data() + digits.size()) ||
           fail_with_text(Field_file_status::SYNTAX_ERROR, token);
  }

  /// moves to the end of the current line: the next token is of a later one.
  void skip_line()
  {
    while (m_position < m_text.size() && m_text[m_position] != '\n')
      ++m_position;
  }

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
  static bool is_blank(const char c)
  {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n';
  }

  static std::string_view without_plus(const std::string_view token)
  {
    return token.substr(token.size() > 1 && token[0] == '+' && token[1] != '-' ? 1 : 0);
  }

  void skip_blanks()
  {
    while (m_position < m_text.size() && (is_blank(m_text[m_position]) || m_text[m_position] == '#')) {
      if (m_text[m_position] == '#')
        skip_line();
      else {
        if (m_text[m_position] == '\n')
          ++m_line;
        ++m_position;
      }
    }
  }

  Progress& m_progress;
  std::string m_text;
  std::size_t m_position = 0;
  std::size_t m_line = 1;
  Field_file_report m_report;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_FIELD_FILE_PARSER_H
