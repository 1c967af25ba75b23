// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_OFF_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_OFF_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The header and the counts of an OFF file.
struct Off_header {
  std::size_t number_of_vertices = 0, number_of_faces = 0;
};

inline Mesh_reading_report parse_off_header(Text_scanner& scanner, Off_header& header)
{
  if (!scanner.next_line())
    return report_at(scanner, Mesh_reading_status::EMPTY);
  std::string_view token;
  scanner.next_token(token);
  constexpr std::array<std::string_view, 8> accepted = {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  if (std::find(accepted.begin(), accepted.end(), token) == accepted.end()) {
    const bool is_variant = token.size() > 3 && token.substr(token.size() - 3) == "OFF";
    return is_variant ? report_at(scanner, Mesh_reading_status::UNSUPPORTED_VARIANT, token)
                      : report_syntax(scanner, "the keyword OFF is expected here", token);
  }
  std::array<std::size_t, 3> counts = {0, 0, 0};
  std::size_t n = 0;
  while (n == 0) { // the counts stand on the line of the keyword or on the next one
    while (n < 3 && scanner.next_token(token)) {
      if (token == "BINARY")
        return report_at(scanner, Mesh_reading_status::UNSUPPORTED_VARIANT, "OFF BINARY");
      if (!parse_integer(token, counts[n++]))
        return report_at(scanner, Mesh_reading_status::SYNTAX_ERROR, token);
    }
    if (n == 0 && !scanner.next_line())
      return report_at(scanner, Mesh_reading_status::TRUNCATED);
  }
  if (n < 2) // the number of edges is left out by some programs
    return report_missing_token(scanner, "the number of faces is missing");
  if (scanner.next_token(token))
    return report_syntax(scanner, "three counts are expected here", token);
  header.number_of_vertices = counts[0];
  header.number_of_faces = counts[1];
  return Mesh_reading_report();
}

/// One polygon; what follows the corners on the line is a colour and is not read.
inline Mesh_reading_report parse_off_face(Text_scanner& scanner, Polygon_soup& soup)
{
  std::string_view token;
  std::size_t size = 0;
  const std::size_t face = soup.number_of_polygons();
  scanner.next_token(token);
  if (!parse_integer(token, size))
    return report_at(scanner, Mesh_reading_status::SYNTAX_ERROR, token);
  for (std::size_t i = 0; i < size; ++i) {
    std::size_t v = 0;
    if (!scanner.next_token(token)) {
      Mesh_reading_report report = report_missing_token(scanner, "a corner is missing");
      report.face = face;
      return report;
    }
    const bool is_index = parse_integer(token, v);
    if (!is_index || v >= soup.points.size()) {
      const bool is_number = is_index || token.find_first_not_of("-+0123456789") == std::string_view::npos;
      Mesh_reading_report report = report_at(
        scanner, is_number ? Mesh_reading_status::INDEX_OUT_OF_RANGE : Mesh_reading_status::SYNTAX_ERROR, token);
      report.face = face;
      return report;
    }
    soup.corners.push_back(v);
  }
  soup.end_polygon();
  soup.polygon_lines.push_back(scanner.line());
  return Mesh_reading_report();
}

/// Parses an OFF file (ASCII, also with normals, colours and texture coordinates, which are not read).
///
/// Every vertex and every face has a line of its own, as all known programs write it, so that a wrong count is found.
inline Mesh_reading_report parse_off(const std::string_view text, Polygon_soup& soup)
{
  Text_scanner scanner(text);
  Off_header header;
  Mesh_reading_report report = parse_off_header(scanner, header);
  soup.points.reserve(std::min(header.number_of_vertices, text.size()));
  for (std::size_t v = 0; report.success() && v < header.number_of_vertices; ++v) {
    if (!scanner.next_line())
      return report_at(scanner, Mesh_reading_status::TRUNCATED);
    std::array<double, 3> point;
    report = read_coordinates(scanner, point.begin(), point.end());
    if (!report.success())
      report.vertex = v;
    soup.points.push_back(point);
    soup.point_lines.push_back(scanner.line());
  }
  for (std::size_t f = 0; report.success() && f < header.number_of_faces; ++f) {
    if (!scanner.next_line())
      return report_at(scanner, Mesh_reading_status::TRUNCATED);
    report = parse_off_face(scanner, soup);
  }
  if (report.success() && scanner.next_line())
    return report_syntax(scanner, "more lines than the header announces");
  return report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_OFF_H
