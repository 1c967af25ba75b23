// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_STL_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_STL_H

#include <CGAL/T_splines/IO/internal/Binary_scanner.h>
#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>

#include <boost/container_hash/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <unordered_map>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Gives corners with identical coordinates the same vertex, in the order of their first occurrence.
class Stl_soup_builder {
public:
  explicit Stl_soup_builder(Polygon_soup& soup) : m_soup(soup) {}

  void add_corner(std::array<double, 3> point)
  {
    for (double& x : point)
      x += 0.0; // -0 and 0 are one point
    const auto [position, is_new] = m_vertex_of_point.emplace(point, m_soup.points.size());
    if (is_new)
      m_soup.points.push_back(point);
    else
      ++m_soup.number_of_merged_points;
    m_soup.corners.push_back(position->second);
  }

private:
  Polygon_soup& m_soup;
  std::unordered_map<std::array<double, 3>, std::size_t, boost::hash<std::array<double, 3>>> m_vertex_of_point;
};

inline Mesh_reading_report parse_binary_stl(const std::string_view data, Polygon_soup& soup)
{
  constexpr std::size_t header_size = 80;
  Binary_scanner scanner(data.substr(header_size), Byte_order::LITTLE);
  const std::uint32_t n = scanner.read<std::uint32_t>();
  Stl_soup_builder builder(soup);
  Mesh_reading_report report;
  for (std::uint32_t f = 0; f < n; ++f) {
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
      builder.add_corner(point);
    }
    scanner.read<std::uint16_t>();
    soup.end_polygon();
  }
  return report;
}

/// Parses the facets of an ASCII file.
class Ascii_stl_parser {
public:
  Ascii_stl_parser(const std::string_view text, Polygon_soup& soup) : m_scanner(text), m_soup(soup), m_builder(soup) {}

  Mesh_reading_report parse()
  {
    std::string_view keyword;
    Mesh_reading_report report;
    bool is_inside_solid = false;
    while (report.success() && m_scanner.next_line()) {
      m_scanner.next_token(keyword);
      if (keyword == "solid" && !is_inside_solid)
        is_inside_solid = true;
      else if (keyword == "endsolid" && is_inside_solid)
        is_inside_solid = false;
      else if (keyword == "facet" && is_inside_solid)
        report = parse_facet();
      else
        report = report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, keyword);
    }
    if (report.success() && is_inside_solid)
      report = report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    return report;
  }

private:
  /// The words with which the next line begins.
  Mesh_reading_report expect(const std::initializer_list<std::string_view> keywords)
  {
    std::string_view token;
    if (!m_scanner.next_line())
      return report_at(m_scanner, Mesh_reading_status::TRUNCATED);
    for (const std::string_view keyword : keywords) {
      if (!m_scanner.next_token(token))
        return report_missing_token(m_scanner, "a keyword is missing");
      if (token != keyword)
        return report_at(m_scanner, Mesh_reading_status::SYNTAX_ERROR, token);
    }
    return Mesh_reading_report();
  }

  Mesh_reading_report parse_facet()
  {
    Mesh_reading_report report;
    m_soup.polygon_lines.push_back(m_scanner.line()); // the normal on this line is not read
    report = expect({"outer", "loop"});
    for (int corner = 0; corner < 3 && report.success(); ++corner) {
      std::array<double, 3> point;
      report = expect({"vertex"});
      if (report.success())
        report = read_coordinates(m_scanner, point.begin(), point.end());
      if (report.success())
        m_builder.add_corner(point);
    }
    if (report.success())
      report = expect({"endloop"});
    if (report.success())
      report = expect({"endfacet"});
    if (!report.success())
      report.face = m_soup.number_of_polygons();
    m_soup.end_polygon();
    return report;
  }

  Text_scanner m_scanner;
  Polygon_soup& m_soup;
  Stl_soup_builder m_builder;
};

/// Parses an STL file, binary or ASCII: a file is binary if its size is what its count of facets says (many binary files
/// begin with the word "solid").
inline Mesh_reading_report parse_stl(const std::string_view data, Polygon_soup& soup)
{
  constexpr std::size_t header_size = 84, facet_size = 50;
  std::uint64_t size_if_binary = 0;
  if (data.size() >= header_size)
    size_if_binary =
      header_size + facet_size * std::uint64_t(Binary_scanner(data.substr(80), Byte_order::LITTLE).read<std::uint32_t>());
  if (data.size() >= header_size && data.size() == size_if_binary)
    return parse_binary_stl(data, soup);
  const std::size_t begin = data.find_first_not_of(" \t\r\n");
  if (begin != std::string_view::npos && data.substr(begin, 5) == "solid")
    return Ascii_stl_parser(data, soup).parse();
  Mesh_reading_report report;
  if (begin == std::string_view::npos)
    report.status = Mesh_reading_status::EMPTY;
  else if (data.size() < header_size || data.size() < size_if_binary)
    report.status = Mesh_reading_status::TRUNCATED;
  else {
    report.status = Mesh_reading_status::SYNTAX_ERROR;
    report.detail = "more data than the count of facets announces";
  }
  return report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_STL_H
