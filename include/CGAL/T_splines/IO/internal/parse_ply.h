// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_PARSE_PLY_H
#define CGAL_T_SPLINES_IO_INTERNAL_PARSE_PLY_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Ply_header.h>
#include <CGAL/T_splines/IO/internal/Ply_reader.h>
#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Parses a PLY file, with any other elements and properties, which are skipped.
class Ply_parser {
public:
  using Report = Mesh_reading_report;

  Ply_parser(const std::string_view data, Polygon_soup& soup)
    : m_reader(data, Ply_reader::Rows::MAY_CONTINUE),
      m_soup(soup)
  {
  }

  Report parse(Progress& progress)
  {
    Report report = m_reader.read_header();
    m_reader.header().set_roles(role_of);
    if (report.success() && !has_points_and_faces())
      report =
          m_reader.report_syntax("element vertex with x, y, z and element face with list vertex_indices are needed");
    if (report.success())
      report = m_reader.read_rows(*this, progress);
    return report.success() ? check_indices() : report;
  }

  // What `Ply_reader` asks for.

  static const Report& converted(const Report& report) { return report; }

  void begin_row() {}

  static Report begin_list(const Ply_property& /*property*/, const std::size_t /*length*/) { return Report(); }

  Report take(const Ply_property& property, const double value)
  {
    const auto role = static_cast<Role>(property.role);
    if (role == Role::OTHER)
      return Report();
    if (role == Role::CORNERS) {
      if (!is_ply_index(value))
        return m_reader.report_here(Mesh_reading_status::INDEX_OUT_OF_RANGE);
      m_soup.corners.push_back(static_cast<std::size_t>(value));
      return Report();
    }
    m_point[static_cast<std::size_t>(role)] = value;
    return std::isfinite(value) ? Report() : m_reader.report_here(Mesh_reading_status::NON_FINITE_COORDINATE);
  }

  static const Report& at_entry(const Ply_property& /*property*/, const std::size_t /*i*/, const Report& report)
  {
    return report;
  }

  Report end_row(const Ply_element& element)
  {
    const bool is_text = m_reader.header().is_text();
    if (element.name == "vertex") {
      m_soup.points.push_back(m_point);
      if (is_text)
        m_soup.point_lines.push_back(m_reader.line_of_row());
    }
    else if (element.name == "face") {
      m_soup.end_polygon();
      if (is_text)
        m_soup.polygon_lines.push_back(m_reader.line_of_row());
    }
    return Report();
  }

private:
  enum class Role { X, Y, Z, CORNERS, OTHER };

  static Role role_of(const Ply_element& element, const Ply_property& property)
  {
    if (element.name == "vertex" && !property.is_list() && property.name.size() == 1)
      return static_cast<Role>(std::min<std::size_t>(std::string_view("xyz").find(property.name), 4));
    const bool is_corners = element.name == "face" && property.is_list() &&
                            (property.name == "vertex_indices" || property.name == "vertex_index");
    return is_corners ? Role::CORNERS : Role::OTHER;
  }

  bool has_points_and_faces() const
  {
    std::size_t coordinates = 0, lists = 0;
    for (const Ply_element& element : m_reader.header().elements())
      for (const Ply_property& property : element.properties) {
        coordinates += property.role <= static_cast<int>(Role::Z);
        lists += property.role == static_cast<int>(Role::CORNERS);
      }
    return coordinates == 3 && lists == 1;
  }

  Mesh_reading_report check_indices() const
  {
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
      for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c)
        if (m_soup.corners[c] >= m_soup.points.size()) {
          Mesh_reading_report report;
          report.status = Mesh_reading_status::INDEX_OUT_OF_RANGE;
          report.line = m_soup.line_of_polygon(f);
          report.face = f;
          report.text = std::to_string(m_soup.corners[c]);
          return report;
        }
    return Mesh_reading_report();
  }

  Ply_reader m_reader;
  Polygon_soup& m_soup;
  std::array<double, 3> m_point = {{0, 0, 0}}; // of the row
};

/// Parses a PLY file. \param progress if it is interrupted, the report means nothing
inline Mesh_reading_report parse_ply(const std::string_view data, Polygon_soup& soup, Progress& progress)
{
  return Ply_parser(data, soup).parse(progress);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_PARSE_PLY_H
