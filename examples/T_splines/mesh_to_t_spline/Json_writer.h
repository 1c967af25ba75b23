// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_JSON_WRITER_H
#define MESH_TO_T_SPLINE_JSON_WRITER_H

#include <CGAL/assertions.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Puts a JSON text together, indented by nesting.
///
/// Numbers are written in the shortest way that reads back as the same; what JSON has no number for (NaN, infinity) becomes null. `<` is
/// escaped, so that the text can stand inside a script element of an HTML page; bytes that are not UTF-8 are replaced.
class Json_writer {
public:
  Json_writer& begin_object() { return open('{'); }
  Json_writer& end_object() { return close('}'); }
  Json_writer& begin_array() { return open('['); }
  Json_writer& end_array() { return close(']'); }

  Json_writer& key(const std::string_view name)
  {
    separate();
    append_string(name);
    m_text += ": ";
    m_has_key = true;
    return *this;
  }

  Json_writer& value(const std::string_view text)
  {
    separate();
    append_string(text);
    return *this;
  }
  Json_writer& value(const char* text) { return value(std::string_view(text)); }

  template <typename Number>
  std::enable_if_t<std::is_arithmetic<Number>::value, Json_writer&> value(const Number number)
  {
    separate();
    if constexpr (std::is_same<Number, bool>::value)
      m_text += number ? "true" : "false";
    else {
      if constexpr (std::is_floating_point<Number>::value)
        if (!std::isfinite(number)) {
          m_text += "null";
          return *this;
        }
      std::array<char, 64> digits;
      m_text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
    }
    return *this;
  }

  template <typename Value>
  Json_writer& member(const std::string_view name, const Value& content)
  {
    return key(name).value(content);
  }

  template <typename Range>
  Json_writer& array_member(const std::string_view name, const Range& range)
  {
    key(name).begin_array();
    for (const auto& item : range)
      value(item);
    return end_array();
  }

  /// The text. \pre Everything that was begun has been ended.
  const std::string& text() const
  {
    CGAL_precondition(m_is_empty.empty());
    return m_text;
  }

private:
  Json_writer& open(const char bracket)
  {
    separate();
    m_text += bracket;
    m_is_empty.push_back(true);
    return *this;
  }

  Json_writer& close(const char bracket)
  {
    CGAL_precondition(!m_is_empty.empty());
    const bool is_empty = m_is_empty.back();
    m_is_empty.pop_back();
    if (!is_empty)
      break_line();
    m_text += bracket;
    return *this;
  }

  void separate()
  {
    if (m_has_key) {
      m_has_key = false;
      return;
    }
    if (m_is_empty.empty())
      return;
    if (!m_is_empty.back())
      m_text += ',';
    m_is_empty.back() = false;
    break_line();
  }

  void break_line()
  {
    m_text += '\n';
    m_text.append(2 * m_is_empty.size(), ' ');
  }

  void append_string(const std::string_view text)
  {
    m_text += '"';
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t length = utf8_length(text.substr(i));
      const char c = text[i];
      if (length == 0)
        m_text += "\\ufffd";
      else if (c == '"' || c == '\\')
        m_text.append({'\\', c});
      else if (static_cast<unsigned char>(c) < 0x20 || c == '<' || c == 0x7f)
        append_escape(static_cast<unsigned char>(c));
      else
        m_text += text.substr(i, length);
      i += length == 0 ? 1 : length;
    }
    m_text += '"';
  }

  void append_escape(const unsigned char c)
  {
    constexpr std::string_view digits = "0123456789abcdef";
    m_text.append({'\\', 'u', '0', '0', digits[c / 16], digits[c % 16]});
  }

  /// The number of bytes of the character with which the text begins; 0 if it is not well-formed.
  static std::size_t utf8_length(const std::string_view text)
  {
    const auto byte = [&text](const std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80)
      return 1;
    const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length)
      return 0;
    for (std::size_t i = 1; i < length; ++i)
      if (byte(i) < 0x80 || byte(i) > 0xbf)
        return 0;
    const bool is_overlong = (byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xf0 && byte(1) < 0x90);
    const bool is_no_character = (byte(0) == 0xed && byte(1) > 0x9f) || (byte(0) == 0xf4 && byte(1) > 0x8f);
    return is_overlong || is_no_character ? 0 : length;
  }

  std::string m_text;
  std::vector<bool> m_is_empty; ///< per open bracket
  bool m_has_key = false;
};

#endif // MESH_TO_T_SPLINE_JSON_WRITER_H
