// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_TEXT_SCANNER_H
#define CGAL_T_SPLINES_IO_INTERNAL_TEXT_SCANNER_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How long the parsing of a line takes, about, in the units of `Progress::go_on_after()`.
constexpr std::size_t work_per_line = 10;

/// Reads a text line by line and each line token by token, and knows the number of the line.
///
/// Comments run from `#` to the end of the line. Lines end with LF, CR LF or CR. It copies nothing.
class Text_scanner {
public:
  /// Whether a backslash at the end of a line continues it on the next one.
  enum class Backslash { IS_TEXT, CONTINUES_LINE };

  explicit Text_scanner(const std::string_view text, const Backslash backslash = Backslash::IS_TEXT)
    : m_rest(text),
      m_has_carriage_returns(text.find('\r') != std::string_view::npos),
      m_has_continued_lines(backslash == Backslash::CONTINUES_LINE)
  {
  }

  /// moves to the next line that has a token; returns `false` at the end of the text.
  bool next_line()
  {
    while (!m_rest.empty()) {
      take_line();
      skip_blanks();
      if (!m_line_rest.empty())
        return true;
    }
    return false;
  }

  /// The next token of this line; `false` at its end.
  bool next_token(std::string_view& token)
  {
    skip_blanks();
    while (m_has_continued_lines && m_line_rest == "\\" && !m_rest.empty()) {
      take_line();
      skip_blanks();
    }
    if (m_line_rest.empty())
      return false;
    std::size_t length = 0;
    while (length < m_line_rest.size() && !is_blank(m_line_rest[length]))
      ++length;
    token = m_line_rest.substr(0, length);
    if (m_has_continued_lines && length > 1 && token.back() == '\\' && length == m_line_rest.size())
      token.remove_suffix(1);
    m_line_rest.remove_prefix(token.size());
    return true;
  }

  /// The next token of this line or, if it has none, of the lines that follow; `false` at the end of the text.
  bool next_token_over_lines(std::string_view& token)
  {
    return next_token(token) || (next_line() && next_token(token));
  }

  /// passes over what is left of this line.
  void skip_rest_of_line() { m_line_rest = {}; }

  /// Whether this line has another token.
  bool has_token() const
  {
    if (!m_has_continued_lines)
      return !m_line_rest.empty(); // it does not end with blanks
    Text_scanner copy(*this);
    std::string_view token;
    return copy.next_token(token);
  }

  /// Whether a token follows, in this line or in a later one, to which it moves.
  bool has_token_over_lines() { return has_token() || next_line(); }

  /// What follows this line, line feed excluded.
  std::string_view text_after_line() const { return m_rest; }

  /// counts the tokens of this line from here on.
  std::size_t count_tokens() const
  {
    Text_scanner copy(*this);
    std::string_view token;
    std::size_t n = 0;
    while (copy.next_token(token))
      ++n;
    return n;
  }

  /// The number of this line, from 1.
  std::size_t line() const { return m_line; }

  /// Whether only blank lines follow this line.
  bool is_last_line() const
  {
    Text_scanner copy(*this);
    return !copy.next_line();
  }

private:
  static bool is_blank(const char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  void skip_blanks()
  {
    while (!m_line_rest.empty() && is_blank(m_line_rest.front()))
      m_line_rest.remove_prefix(1);
  }

  // Searching for one character is several times as fast as for one of two.
  std::size_t end_of_line() const
  {
    std::size_t end = 0;
    if (!m_has_carriage_returns)
      end = m_rest.find('\n');
    else
      while (end < m_rest.size() && m_rest[end] != '\n' && m_rest[end] != '\r')
        ++end;
    return (std::min)(end, m_rest.size());
  }

  void take_line()
  {
    ++m_line;
    const std::size_t end = end_of_line();
    m_line_rest = m_rest.substr(0, end);
    const std::size_t length_of_end = m_rest.substr(end, 2) == "\r\n" ? 2 : 1;
    m_rest.remove_prefix((std::min)(m_rest.size(), end + length_of_end));
    m_line_rest = m_line_rest.substr(0, m_line_rest.find('#'));
    while (!m_line_rest.empty() && is_blank(m_line_rest.back()))
      m_line_rest.remove_suffix(1);
  }

  std::string_view m_rest, m_line_rest;
  std::size_t m_line = 0;
  bool m_has_carriage_returns, m_has_continued_lines;
};

/// Whether a token is a keyword, given in lower case, in upper or lower case.
inline bool is_keyword(const std::string_view token, const std::string_view keyword)
{
  const auto equals = [](const char a, const char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::equal(token.begin(), token.end(), keyword.begin(), keyword.end(), equals);
}

/// A text without the mark of UTF-8 with which some editors begin it.
inline std::string_view without_byte_order_mark(const std::string_view text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(text.substr(0, mark.size()) == mark ? mark.size() : 0);
}

/// Whether a text begins with the mark of UTF-16.
inline bool has_mark_of_utf_16(const std::string_view text)
{
  return text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF";
}

/// A number without the plus sign that `std::from_chars()` does not know.
inline std::string_view without_plus_sign(const std::string_view token)
{
  return token.substr(token.size() > 1 && token[0] == '+' && token[1] != '-' ? 1 : 0);
}

/// A whole token as integer. \return `false` if it is not one or exceeds the range of the type.
template <typename Integer>
bool parse_integer(const std::string_view token, Integer& value)
{
  const std::string_view digits = without_plus_sign(token);
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return result.ec == std::errc() && result.ptr == digits.data() + digits.size();
}

/// What a token is, where a number is expected.
enum class Token_kind { FINITE_NUMBER, NON_FINITE_NUMBER, NO_NUMBER };

/// A whole token as the nearest double, whatever the locale. NaN, infinity and what is beyond the range of double are not
/// finite; what underflows is rounded.
inline Token_kind parse_number(const std::string_view token, double& value)
{
  const std::string_view digits = without_plus_sign(token);
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (result.ptr != digits.data() + digits.size() || result.ec == std::errc::invalid_argument)
    return Token_kind::NO_NUMBER;
  if (result.ec == std::errc::result_out_of_range) { // too large or too small; that is all it says
    std::istringstream stream{std::string(digits)};
    stream.imbue(std::locale::classic());
    if (!(stream >> value))
      value = std::copysign(std::numeric_limits<double>::infinity(), value);
  }
  return std::isfinite(value) ? Token_kind::FINITE_NUMBER : Token_kind::NON_FINITE_NUMBER;
}

/// The beginning of a token, as a message can quote it.
inline std::string quotable(const std::string_view token)
{
  constexpr std::size_t longest = 40;
  std::string text;
  for (const char c : token.substr(0, longest))
    text += c >= ' ' && c <= '~' ? c : '?';
  return token.size() > longest ? text + "..." : text;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_TEXT_SCANNER_H
