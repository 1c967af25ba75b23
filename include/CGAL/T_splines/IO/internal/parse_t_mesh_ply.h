// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H

#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The lines of the header between the counts, with the names that the types have: those of the writer come first.
struct T_mesh_ply_header {
  using Words = std::vector<std::vector<std::string_view>>;

  static std::vector<Words> vertex_properties()
  {
    const std::vector<std::string_view> number = {"double", "float64"};
    return {{{"property"}, number, {"x"}},
            {{"property"}, number, {"y"}},
            {{"property"}, number, {"z"}},
            {{"property"}, number, {"w"}}};
  }

  static std::vector<Words> face_properties()
  {
    const std::vector<std::string_view> count = {"int", "int32", "uint", "uint32", "uchar", "uint8"};
    return {{{"property"}, {"list"}, count, {"int", "int32"}, {"vertex_indices"}},
            {{"property"}, {"list"}, count, {"double", "float64"}, {"halfedge_knots"}},
            {{"property"}, {"list"}, count, {"uchar", "uint8"}, {"corner"}},
            {{"property"}, {"list"}, count, {"int", "int32"}, {"opposite"}}};
  }
};

/// Parses a T-mesh file. It checks each line by itself; see `check_t_mesh_soup()` for the rest.
class T_mesh_ply_parser {
public:
  using Report = T_mesh_reading_report;
  using Status = T_mesh_reading_status;

  T_mesh_ply_parser(const std::string_view data, T_mesh_soup& soup) : m_text(data), m_soup(soup) {}

  Report parse()
  {
    Report report = parse_header();
    for (std::size_t v = 0; report.success() && v < m_number_of_vertices; ++v)
      report = parse_vertex(v);
    for (std::size_t f = 0; report.success() && f < m_number_of_faces; ++f)
      report = parse_face(f);
    if (report.success() && m_text.next_line())
      report = syntax_error("more lines than the header announces");
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

  // Where a token is missing the last line of a file was cut off; another line is wrong.
  Report missing_token(const std::string& detail) const
  {
    return m_text.is_last_line() ? report_here(Status::TRUNCATED) : syntax_error(detail);
  }

  Report parse_header()
  {
    std::string_view word;
    if (!m_text.next_line()) {
      Report report;
      report.status = Status::EMPTY;
      return report;
    }
    m_text.next_token(word);
    if (word != "ply" || m_text.next_token(word))
      return syntax_error("the first line must be \"ply\"", word);
    Report report = parse_format();
    if (report.success())
      report = parse_count("vertex", m_number_of_vertices);
    for (const T_mesh_ply_header::Words& words : T_mesh_ply_header::vertex_properties())
      if (report.success())
        report = expect(words);
    if (report.success())
      report = parse_count("face", m_number_of_faces);
    for (const T_mesh_ply_header::Words& words : T_mesh_ply_header::face_properties())
      if (report.success())
        report = expect(words);
    if (report.success())
      report = expect({{"end_header"}});
    if (report.success() && m_number_of_faces == 0)
      report.status = Status::EMPTY;
    return report;
  }

  /// Moves to the next line of the header that is no comment, and takes its words.
  bool next_header_line(std::vector<std::string_view>& words)
  {
    do {
      words.clear();
      if (!m_text.next_line())
        return false;
      for (std::string_view word; m_text.next_token(word);)
        words.push_back(word);
    } while (words.front() == "comment" || words.front() == "obj_info");
    return true;
  }

  Report parse_format()
  {
    std::vector<std::string_view> words;
    if (!next_header_line(words))
      return report_here(Status::TRUNCATED);
    if (words.size() == 3 && words[0] == "format" && words[1] != "ascii") {
      Report report = report_here(Status::UNSUPPORTED_VARIANT, words[1]);
      report.detail = "T-meshes are read from PLY files made of text, \"format ascii 1.0\"";
      return report;
    }
    const bool is_text = words.size() == 3 && words[0] == "format" && words[2] == "1.0";
    return is_text ? Report() : syntax_error("\"format ascii 1.0\" is needed here", words.front());
  }

  Report parse_count(const std::string_view element, std::size_t& count)
  {
    std::vector<std::string_view> words;
    if (!next_header_line(words))
      return report_here(Status::TRUNCATED);
    const std::string needed = "\"element " + std::string(element) + "\" and its number are needed here";
    if (words.front() != "element")
      return syntax_error(needed, words.front());
    if (words.size() > 1 && words[1] != element)
      return other_element(words[1], needed);
    if (words.size() != 3 || !parse_integer(words[2], count))
      return syntax_error(needed, words.back());
    return Report();
  }

  Report other_element(const std::string_view name, const std::string& needed) const
  {
    Report report = report_here(Status::UNSUPPORTED_VARIANT, name);
    report.detail = needed + "; a T-mesh has no other elements";
    return report;
  }

  Report expect(const T_mesh_ply_header::Words& expected)
  {
    std::vector<std::string_view> words;
    if (!next_header_line(words))
      return report_here(Status::TRUNCATED);
    std::string line;
    for (const std::vector<std::string_view>& choices : expected)
      line += (line.empty() ? "" : " ") + std::string(choices.front());
    const std::string needed = "\"" + line + "\" is needed here";
    if (words.front() == "element" && words.size() > 1 && words[1] != "vertex" && words[1] != "face")
      return other_element(words[1], needed);
    for (std::size_t i = 0; i < std::max(words.size(), expected.size()); ++i)
      if (i >= words.size() || i >= expected.size() ||
          std::find(expected[i].begin(), expected[i].end(), words[i]) == expected[i].end())
        return syntax_error(needed, i < words.size() ? words[i] : words.back());
    return Report();
  }

  Report parse_number(double& value, std::string_view& token)
  {
    if (!m_text.next_token(token))
      return missing_token("a number is missing");
    const Mesh_reading_status status = parse_coordinate(token, value);
    if (status == Mesh_reading_status::SUCCESS)
      return Report();
    return report_here(status == Mesh_reading_status::SYNTAX_ERROR ? Status::SYNTAX_ERROR : Status::NON_FINITE_NUMBER,
                       token);
  }

  /// \param bad what it is called if it is an integer outside of [low, high]
  Report parse_index(const long long low, const long long high, const Status bad, long long& value)
  {
    std::string_view token;
    if (!m_text.next_token(token))
      return missing_token("a number is missing");
    if (!parse_integer(token, value))
      return report_here(Status::SYNTAX_ERROR, token);
    return value >= low && value <= high ? Report() : report_here(bad, token);
  }

  Report check_line_end() const
  {
    Text_scanner rest(m_text);
    std::string_view token;
    return rest.next_token(token) ? syntax_error("more numbers than the lists announce", token) : Report();
  }

  Report parse_vertex(const std::size_t v)
  {
    if (!m_text.next_line())
      return report_here(Status::TRUNCATED);
    std::array<double, 4> point = {0, 0, 0, 0};
    std::string_view token;
    Report report;
    for (double& x : point)
      if (report.success())
        report = parse_number(x, token);
    if (report.success() && !(point[3] > 0))
      report = report_here(Status::NON_POSITIVE_WEIGHT, token);
    if (report.success())
      report = check_line_end();
    if (!report.success())
      report.vertex = v;
    m_soup.points.push_back(point);
    m_soup.point_lines.push_back(m_text.line());
    return report;
  }

  Report parse_face(const std::size_t f)
  {
    if (!m_text.next_line())
      return report_here(Status::TRUNCATED);
    Report report;
    std::size_t length = 0;
    for (const std::string_view list : {"vertex_indices", "halfedge_knots", "corner", "opposite"})
      if (report.success())
        report = parse_list(list, length);
    if (report.success())
      report = check_line_end();
    if (report.success())
      report = check_number_of_corners(length);
    if (!report.success())
      report.face = f;
    m_soup.first_halfedge.push_back(m_soup.sources.size());
    m_soup.face_lines.push_back(m_text.line());
    return report;
  }

  /// \param length set by the first list, asked of the others
  Report parse_list(const std::string_view list, std::size_t& length)
  {
    constexpr long long longest = std::numeric_limits<long long>::max();
    long long number = 0;
    const bool is_first = list == "vertex_indices";
    Report report = parse_index(0, longest, Status::SYNTAX_ERROR, number);
    if (report.success() && !is_first && static_cast<std::size_t>(number) != length) {
      report = report_here(Status::LIST_LENGTHS_DIFFER);
      report.detail =
          std::string(list) + " has " + std::to_string(number) + " entries, vertex_indices " + std::to_string(length);
    }
    length = static_cast<std::size_t>(number);
    for (std::size_t i = 0; report.success() && i < length; ++i) {
      report = parse_entry(list);
      if (!report.success()) {
        report.index = i;
        report.detail = (report.detail.empty() ? "in the list " : report.detail + " in the list ") + std::string(list);
      }
    }
    return report;
  }

  Report parse_entry(const std::string_view list)
  {
    constexpr long long largest = std::numeric_limits<long long>::max();
    long long number = 0;
    Report report;
    if (list == "vertex_indices") {
      report = parse_index(0, static_cast<long long>(m_number_of_vertices) - 1, Status::INDEX_OUT_OF_RANGE, number);
      m_soup.sources.push_back(static_cast<std::size_t>(number));
    }
    else if (list == "halfedge_knots") {
      std::string_view token;
      m_soup.knots.push_back(0);
      report = parse_number(m_soup.knots.back(), token);
      if (report.success() && !(m_soup.knots.back() > 0))
        report = report_here(Status::NON_POSITIVE_KNOT, token);
    }
    else if (list == "corner") {
      report = parse_index(0, 1, Status::SYNTAX_ERROR, number);
      m_soup.is_corner.push_back(number == 1);
    }
    else {
      report = parse_index(-1, largest, Status::INDEX_OUT_OF_RANGE, number);
      m_soup.opposites.push_back(number < 0 ? T_mesh_soup::border : static_cast<std::size_t>(number));
    }
    return report;
  }

  Report check_number_of_corners(const std::size_t length) const
  {
    const int corners =
        std::accumulate(m_soup.is_corner.end() - static_cast<std::ptrdiff_t>(length), m_soup.is_corner.end(), 0);
    Report report;
    if (corners != 4) {
      report = report_here(Status::WRONG_NUMBER_OF_CORNERS);
      report.detail = "it has " + std::to_string(corners);
    }
    return report;
  }

  Text_scanner m_text;
  T_mesh_soup& m_soup;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H
