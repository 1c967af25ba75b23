// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Ply_header.h>
#include <CGAL/T_splines/IO/internal/Ply_reader.h>
#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What stands in a T-mesh file: numbers of the vertices, then lists of the faces. All but creases are needed.
enum class T_mesh_property { X, Y, Z, W, VERTEX_INDICES, HALFEDGE_KNOTS, CORNER, OPPOSITE, CREASE, OTHER };

/// As the writer announces them.
inline std::string_view line_of(const T_mesh_property property)
{
  constexpr std::array<std::string_view, 9> lines = {"property double x",
                                                     "property double y",
                                                     "property double z",
                                                     "property double w",
                                                     "property list uchar int vertex_indices",
                                                     "property list uchar double halfedge_knots",
                                                     "property list uchar uchar corner",
                                                     "property list uchar int opposite",
                                                     "property list uchar uchar crease"};
  return lines[static_cast<std::size_t>(property)];
}

inline T_mesh_property t_mesh_property(const Ply_element& element, const Ply_property& property)
{
  const std::string_view name = property.name == "vertex_index" ? "vertex_indices" : property.name;
  for (int i = 0; i < static_cast<int>(T_mesh_property::OTHER); ++i) {
    const auto wanted = static_cast<T_mesh_property>(i);
    const bool is_of_face = wanted >= T_mesh_property::VERTEX_INDICES;
    const std::string_view line = line_of(wanted);
    if (element.name == (is_of_face ? "face" : "vertex") && property.is_list() == is_of_face &&
        name == line.substr(line.find_last_of(' ') + 1))
      return wanted;
  }
  return T_mesh_property::OTHER;
}

/// Parses a T-mesh file, with any other elements and properties, which are skipped. It checks each row by itself; see
/// `check_t_mesh_soup()` for the rest.
class T_mesh_ply_parser {
public:
  using Report = T_mesh_reading_report;
  using Status = T_mesh_reading_status;

  T_mesh_ply_parser(const std::string_view data, T_mesh_soup& soup)
    : m_reader(data, Ply_reader::Rows::ARE_LINES),
      m_soup(soup)
  {
  }

  /// \param progress if it is interrupted, the report means nothing
  Report parse(Progress& progress)
  {
    Report report = converted(m_reader.read_header());
    m_reader.header().set_roles(t_mesh_property);
    if (report.success())
      report = check_header();
    if (report.success())
      report = m_reader.read_rows(*this, progress);
    report.number_of_vertices = m_number_of_vertices;
    report.number_of_faces = m_number_of_faces;
    return report;
  }

  // What `Ply_reader` asks for.

  static Report converted(const Mesh_reading_report& found)
  {
    Report report;
    if (found.success())
      return report;
    report.status = found.status == Mesh_reading_status::EMPTY                 ? Status::EMPTY
                    : found.status == Mesh_reading_status::TRUNCATED           ? Status::TRUNCATED
                    : found.status == Mesh_reading_status::UNSUPPORTED_VARIANT ? Status::UNSUPPORTED_VARIANT
                                                                               : Status::SYNTAX_ERROR;
    if (report.status != Status::EMPTY)
      report.line = found.line;
    report.text = found.text;
    report.detail = found.detail;
    return report;
  }

  void begin_row() { m_lengths.fill(unknown); }

  Report begin_list(const Ply_property& property, const std::size_t length)
  {
    const auto role = static_cast<T_mesh_property>(property.role);
    if (role == T_mesh_property::OTHER)
      return Report();
    length_of(role) = length;
    return check_length(role);
  }

  Report take(const Ply_property& property, const double value)
  {
    const auto role = static_cast<T_mesh_property>(property.role);
    Report report;
    switch (role) {
    case T_mesh_property::X:
    case T_mesh_property::Y:
    case T_mesh_property::Z:
    case T_mesh_property::W:
      report = check_number(value, role == T_mesh_property::W, Status::NON_POSITIVE_WEIGHT);
      m_point[static_cast<std::size_t>(role)] = value;
      break;
    case T_mesh_property::VERTEX_INDICES:
      report = check_index(value, 0, static_cast<double>(m_number_of_vertices) - 1, Status::INDEX_OUT_OF_RANGE);
      if (report.success())
        m_soup.sources.push_back(static_cast<std::size_t>(value));
      break;
    case T_mesh_property::HALFEDGE_KNOTS:
      report = check_number(value, true, Status::NON_POSITIVE_KNOT);
      m_soup.knots.push_back(value);
      break;
    case T_mesh_property::CORNER:
      report = check_index(value, 0, 1, Status::SYNTAX_ERROR);
      m_soup.is_corner.push_back(value == 1);
      break;
    case T_mesh_property::OPPOSITE: {
      constexpr double largest = 9007199254740992.;
      report = check_index(value, -1, largest, Status::INDEX_OUT_OF_RANGE);
      if (report.success())
        m_soup.opposites.push_back(value >= 0 ? static_cast<std::size_t>(value) : T_mesh_soup::border);
      break;
    }
    case T_mesh_property::CREASE:
      report = check_index(value, 0, 1, Status::SYNTAX_ERROR);
      m_soup.is_crease.push_back(value == 1);
      break;
    case T_mesh_property::OTHER: break;
    }
    return report;
  }

  static Report at_entry(const Ply_property& property, const std::size_t i, Report report)
  {
    report.index = i;
    report.detail += report.detail.empty() ? "in the list " : " in the list ";
    report.detail += property.name;
    return report;
  }

  Report end_row(const Ply_element& element)
  {
    Report report;
    if (element.name == "vertex") {
      m_soup.points.push_back(m_point);
      m_soup.point_lines.push_back(m_reader.line_of_row());
    }
    else if (element.name == "face") {
      report = check_lengths();
      if (report.success())
        report = check_number_of_corners();
      m_soup.first_halfedge.push_back(m_soup.sources.size());
      m_soup.face_lines.push_back(m_reader.line_of_row());
    }
    return report;
  }

private:
  Report syntax_error(const std::string& detail, const std::string_view text = {}) const
  {
    return converted(m_reader.report_syntax(detail, text));
  }

  Report report_here(const Status status, const std::string_view text = {}) const
  {
    Report report = syntax_error("", text);
    report.status = status;
    return report;
  }

  Report check_header()
  {
    std::array<int, static_cast<std::size_t>(T_mesh_property::OTHER) + 1> number = {};
    std::size_t vertex_elements = 0, face_elements = 0;
    for (const Ply_element& element : m_reader.header().elements()) {
      for (const Ply_property& property : element.properties)
        ++number[static_cast<std::size_t>(property.role)];
      if (element.name == "vertex") {
        ++vertex_elements;
        m_number_of_vertices = element.count;
      }
      if (element.name == "face") {
        ++face_elements;
        m_number_of_faces = element.count;
      }
    }
    if (vertex_elements > 1 || face_elements > 1)
      return syntax_error("the elements vertex and face may occur once");
    for (int i = 0; i < static_cast<int>(T_mesh_property::OTHER); ++i) {
      const std::string line = "\"" + std::string(line_of(static_cast<T_mesh_property>(i))) + "\"";
      const char* element = i < static_cast<int>(T_mesh_property::VERTEX_INDICES) ? "vertex" : "face";
      if (number[i] == 0 && static_cast<T_mesh_property>(i) != T_mesh_property::CREASE)
        return syntax_error(line + " is needed in the element " + element);
      if (number[i] > 1)
        return syntax_error(line + " may occur once in the element " + element);
    }
    m_has_creases = number[static_cast<std::size_t>(T_mesh_property::CREASE)] > 0;
    return m_number_of_faces == 0 ? report_here(Status::EMPTY) : Report();
  }

  // --- numbers

  Report check_number(const double value, const bool is_positive, const Status bad) const
  {
    if (!std::isfinite(value))
      return report_here(Status::NON_FINITE_NUMBER, m_reader.found());
    return value > 0 || !is_positive ? Report() : report_here(bad, m_reader.found());
  }

  /// \param bad what it is called if it is an integer outside of [low, high]
  Report check_index(const double value, const double low, const double high, const Status bad) const
  {
    if (!std::isfinite(value) || value != std::floor(value))
      return report_here(Status::SYNTAX_ERROR, m_reader.found());
    return value >= low && value <= high ? Report() : report_here(bad, m_reader.found());
  }

  // --- checks of a row

  std::size_t& length_of(const T_mesh_property list)
  {
    return m_lengths[static_cast<std::size_t>(list) - static_cast<std::size_t>(T_mesh_property::VERTEX_INDICES)];
  }

  /// Whether a list is as long as that of the vertices, as far as that is known yet.
  Report check_length(const T_mesh_property list)
  {
    const std::size_t length = length_of(list), wanted = length_of(T_mesh_property::VERTEX_INDICES);
    if (wanted == unknown || length == wanted)
      return Report();
    Report report = report_here(Status::LIST_LENGTHS_DIFFER);
    const std::string_view line = line_of(list);
    report.detail = std::string(line.substr(line.find_last_of(' ') + 1)) + " has " + std::to_string(length) +
                    " entries, vertex_indices " + std::to_string(wanted);
    return report;
  }

  Report check_lengths()
  {
    Report report;
    for (const T_mesh_property list :
         {T_mesh_property::HALFEDGE_KNOTS, T_mesh_property::CORNER, T_mesh_property::OPPOSITE, T_mesh_property::CREASE})
      if (report.success() && (list != T_mesh_property::CREASE || m_has_creases))
        report = check_length(list);
    return report;
  }

  Report check_number_of_corners()
  {
    const auto length = static_cast<std::ptrdiff_t>(length_of(T_mesh_property::VERTEX_INDICES));
    const int corners = std::accumulate(m_soup.is_corner.end() - length, m_soup.is_corner.end(), 0);
    Report report;
    if (corners != 4) {
      report = report_here(Status::WRONG_NUMBER_OF_CORNERS);
      report.detail = "it has " + std::to_string(corners);
    }
    return report;
  }

  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  Ply_reader m_reader;
  T_mesh_soup& m_soup;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0;
  bool m_has_creases = false;                     // in the header
  std::array<double, 4> m_point = {{0, 0, 0, 0}}; // of the row
  std::array<std::size_t, 5> m_lengths = {};      // of the lists of the row
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_T_MESH_PLY_H
