// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_STL_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_STL_H

#include <CGAL/T_splines/IO/internal/Binary_scanner.h>
#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>
#include <CGAL/T_splines/IO/internal/report_at.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Gives corners with identical coordinates the same vertex, in the order of their first occurrence.
class Stl_soup_builder {
public:
  explicit Stl_soup_builder(Polygon_soup& soup) : m_soup(soup) {}

  /// \param line of the corner; `Mesh_reading_report::none` if the file is binary
  void add_corner(std::array<double, 3> point, const std::size_t line)
  {
    for (double& x : point)
      x += 0.0; // -0 and 0 are one point
    const auto [position, is_new] = m_vertex_of_point.emplace(point, m_soup.points.size());
    if (is_new) {
      m_soup.points.push_back(point);
      if (line != Mesh_reading_report::none)
        m_soup.point_lines.push_back(line);
    }
    else
      ++m_soup.number_of_merged_points;
    m_soup.corners.push_back(position->second);
  }

private:
  Polygon_soup& m_soup;
  std::unordered_map<std::array<double, 3>, std::size_t, boost::hash<std::array<double, 3>>> m_vertex_of_point;
};

inline Mesh_reading_report parse_binary_stl(const std::string_view data, Polygon_soup& soup, Progress& progress)
{
  constexpr std::size_t header_size = 80;
  Binary_scanner scanner(data.substr(header_size), Byte_order::LITTLE);
  const std::uint32_t n = scanner.read<std::uint32_t>();
  Stl_soup_builder builder(soup);
  Mesh_reading_report report;
  for (std::uint32_t f = 0; f < n && progress.go_on_after(work_per_line); ++f) {
    for (int i = 0; i < 3; ++i)
      scanner.read<float>(); // the normal
    for (int corner = 0; corner < 3; ++corner) {
      std::array<double, 3> point;
      for (double& x : point)
        x = scanner.read<float>();
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) {
        report.status = Mesh_reading_status::NON_FINITE_COORDINATE;
        report.face = f;
        return report;
      }
      builder.add_corner(point, Mesh_reading_report::none);
    }
    scanner.read<std::uint16_t>();
    soup.end_polygon();
  }
  return report;
}

/// Parses the facets of an ASCII file. Keywords may be in upper case, and lines do not count but behind the words "solid"
/// and "endsolid", which a name follows.
class Ascii_stl_parser {
public:
  Ascii_stl_parser(const std::string_view text, Polygon_soup& soup, Progress& progress)
    : m_scanner(text),
      m_soup(soup),
      m_progress(progress),
      m_builder(soup)
  {
  }

  Mesh_reading_report parse()
  {
    std::string_view token;
    Mesh_reading_report report;
    bool is_inside_solid = false;
    while (report.success() && m_scanner.next_token_over_lines(token) && m_progress.go_on_after(4 * work_per_line)) {
      if (is_keyword(token, is_inside_solid ? "endsolid" : "solid")) {
        is_inside_solid = !is_inside_solid;
        m_scanner.skip_rest_of_line();
      }
      else if (is_keyword(token, "facet") && is_inside_solid)
        report = parse_facet();
      else
        report = report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, token);
    }
    if (report.success() && is_inside_solid)
      report = report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    return report;
  }

private:
  Mesh_reading_report expect(const std::string_view keyword)
  {
    std::string_view token;
    if (!m_scanner.next_token_over_lines(token))
      return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    return is_keyword(token, keyword) ? Mesh_reading_report()
                                      : report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, token);
  }

  /// The normal is not read: there may be anything in its place.
  Mesh_reading_report skip_normal()
  {
    constexpr int number_of_words = 4;
    std::string_view token;
    for (int i = 0; i <= number_of_words; ++i) {
      if (!m_scanner.next_token_over_lines(token))
        return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
      if (is_keyword(token, "outer"))
        return Mesh_reading_report();
    }
    return report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, token);
  }

  Mesh_reading_report parse_corner()
  {
    Mesh_reading_report report = expect("vertex");
    const std::size_t line = m_scanner.line();
    std::array<double, 3> point = {0, 0, 0};
    std::string_view token;
    for (std::size_t i = 0; i < 3 && report.success(); ++i) {
      if (!m_scanner.next_token_over_lines(token))
        return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
      const Mesh_reading_status status = parse_coordinate(token, point[i]);
      if (status != Mesh_reading_status::SUCCESS)
        report = report_at(m_scanner, status, token);
    }
    if (report.success())
      m_builder.add_corner(point, line);
    return report;
  }

  Mesh_reading_report parse_facet()
  {
    m_soup.polygon_lines.push_back(m_scanner.line());
    Mesh_reading_report report = skip_normal();
    if (report.success())
      report = expect("loop");
    for (int corner = 0; corner < 3 && report.success(); ++corner)
      report = parse_corner();
    if (report.success())
      report = expect("endloop");
    if (report.success())
      report = expect("endfacet");
    if (!report.success())
      report.face = m_soup.number_of_polygons();
    m_soup.end_polygon();
    return report;
  }

  Text_scanner m_scanner;
  Polygon_soup& m_soup;
  Progress& m_progress;
  Stl_soup_builder m_builder;
};

/// Parses an STL file, binary or ASCII: a file is binary if it is as long as its count of facets says, or longer; some
/// programs append data of their own. (Many binary files begin with the word "solid". The count is in bytes 80 to 83:
/// where they are text, it stands for more than 7 gigabytes.)
/// \param progress if it is interrupted, the report means nothing
inline Mesh_reading_report parse_stl(const std::string_view data, Polygon_soup& soup, Progress& progress)
{
  constexpr std::size_t header_size = 84, facet_size = 50;
  std::uint64_t size_if_binary = 0;
  if (data.size() >= header_size)
    size_if_binary =
        header_size +
        facet_size * std::uint64_t(Binary_scanner(data.substr(80), Byte_order::LITTLE).read<std::uint32_t>());
  Mesh_reading_report report;
  if (data.size() >= header_size && data.size() >= size_if_binary) {
    soup.number_of_trailing_bytes = data.size() - static_cast<std::size_t>(size_if_binary);
    return parse_binary_stl(data, soup, progress);
  }
  const std::string_view text = without_byte_order_mark(data);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const bool has_zeros = data.substr(0, header_size).find('\0') != std::string_view::npos;
  if (begin == std::string_view::npos)
    report.status = Mesh_reading_status::EMPTY;
  else if (is_keyword(text.substr(begin, 5), "solid") && !has_zeros)
    report = Ascii_stl_parser(text, soup, progress).parse();
  else if (has_mark_of_utf_16(data)) {
    report.status = Mesh_reading_status::UNSUPPORTED_VARIANT;
    report.text = "UTF-16";
  }
  else if (data.size() < header_size || has_zeros)
    report.status = Mesh_reading_status::TRUNCATED;
  else {
    report.status = Mesh_reading_status::SYNTAX_ERROR;
    report.detail = "a text begins with the word solid, and a binary file has a count of facets that fits its size";
  }
  return report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_STL_H
