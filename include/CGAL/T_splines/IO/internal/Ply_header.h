// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PLY_HEADER_H
#define CGAL_T_SPLINES_IO_INTERNAL_PLY_HEADER_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Binary_scanner.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

enum class Ply_type { NONE, INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

struct Ply_property {
  std::string_view name;
  Ply_type type = Ply_type::NONE;
  Ply_type size_type = Ply_type::NONE; ///< of a list; NONE: no list
  int role = 0;                        ///< what the parser of the rows takes it for

  bool is_list() const { return size_type != Ply_type::NONE; }
};

struct Ply_element {
  std::string_view name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

inline Ply_type ply_type(const std::string_view name)
{
  constexpr std::array<std::array<std::string_view, 2>, 8> names = {{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i][0] || name == names[i][1])
      return static_cast<Ply_type>(i + 1);
  return Ply_type::NONE;
}

inline std::size_t size_of(const Ply_type type)
{
  constexpr std::array<std::size_t, 9> sizes = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

inline double read_binary(Binary_scanner& bytes, const Ply_type type)
{
  switch (type) {
  case Ply_type::NONE: return 0;
  case Ply_type::INT8: return bytes.read<std::int8_t>();
  case Ply_type::UINT8: return bytes.read<std::uint8_t>();
  case Ply_type::INT16: return bytes.read<std::int16_t>();
  case Ply_type::UINT16: return bytes.read<std::uint16_t>();
  case Ply_type::INT32: return bytes.read<std::int32_t>();
  case Ply_type::UINT32: return bytes.read<std::uint32_t>();
  case Ply_type::FLOAT32: return static_cast<double>(bytes.read<float>());
  case Ply_type::FLOAT64: return bytes.read<double>();
  }
  return 0;
}

/// Whether a number can be the number of entries of a list, or the number of an element.
inline bool is_ply_index(const double value)
{
  return value >= 0 && value <= 4294967295.0 && value == std::floor(value);
}

/// The header of a PLY file, made of text or binary in either byte order: what follows it, with any names.
class Ply_header {
public:
  /// Parses it. \param text at the beginning of `data`; afterwards at the last line of the header
  Mesh_reading_report parse(Text_scanner& text, const std::string_view data)
  {
    constexpr std::string_view first_keyword = "ply", last_keyword = "end_header";
    std::string_view keyword;
    if (!text.next_line())
      return report_at(text, Mesh_reading_status::EMPTY);
    text.next_token(keyword);
    if (!is_keyword(keyword, first_keyword))
      return report_syntax(text, "the keyword ply is expected here", keyword);
    if (data.find(last_keyword) == std::string_view::npos) // so that binary data is not scanned
      return report_at(text, Mesh_reading_status::TRUNCATED);
    Mesh_reading_report report;
    while (report.success() && text.next_line()) {
      text.next_token(keyword);
      if (keyword == last_keyword)
        return report;
      report = parse_line(text, keyword);
    }
    return report.success() ? report_at(text, Mesh_reading_status::TRUNCATED) : report;
  }

  const std::vector<Ply_element>& elements() const { return m_elements; }

  /// \param role_of a function of the element and the property
  template <typename RoleOf>
  void set_roles(const RoleOf& role_of)
  {
    for (Ply_element& element : m_elements)
      for (Ply_property& property : element.properties)
        property.role = static_cast<int>(role_of(element, property));
  }

  bool is_text() const { return m_is_text; }
  Byte_order byte_order() const { return m_order; }

private:
  Mesh_reading_report parse_line(Text_scanner& text, const std::string_view keyword)
  {
    std::array<std::string_view, 4> words;
    for (std::string_view& word : words)
      text.next_token(word);
    const auto error = [&text](const std::string_view word) {
      return report_at(text, Mesh_reading_status::SYNTAX_ERROR, word);
    };
    if (keyword == "comment" || keyword == "obj_info")
      return Mesh_reading_report();
    if (keyword == "format") {
      const bool is_binary = words[0] == "binary_little_endian" || words[0] == "binary_big_endian";
      if (words[0] != "ascii" && !is_binary)
        return report_at(text, Mesh_reading_status::UNSUPPORTED_VARIANT, words[0]);
      if (!words[1].empty() && words[1] != "1.0")
        return report_at(text, Mesh_reading_status::UNSUPPORTED_VARIANT, words[1]);
      m_is_text = !is_binary;
      m_order = words[0] == "binary_big_endian" ? Byte_order::BIG : Byte_order::LITTLE;
      return Mesh_reading_report();
    }
    if (keyword == "element") {
      m_elements.push_back({words[0], 0, {}});
      return parse_integer(words[1], m_elements.back().count) ? Mesh_reading_report() : error(words[1]);
    }
    if (keyword != "property" || m_elements.empty())
      return error(keyword);
    const bool is_list = words[0] == "list";
    const Ply_property property = is_list ? Ply_property{words[3], ply_type(words[2]), ply_type(words[1])}
                                          : Ply_property{words[1], ply_type(words[0]), Ply_type::NONE};
    if (property.type == Ply_type::NONE || (is_list && property.size_type == Ply_type::NONE) || property.name.empty())
      return error(is_list ? words[2] : words[0]);
    m_elements.back().properties.push_back(property);
    return Mesh_reading_report();
  }

  std::vector<Ply_element> m_elements;
  bool m_is_text = true;
  Byte_order m_order = Byte_order::LITTLE;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PLY_HEADER_H
