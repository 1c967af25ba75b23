// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_POLYGON_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_POLYGON_SOUP_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What stands in a mesh file, in the order of the file: points, and polygons as lists of point indices.
struct Polygon_soup {
  std::vector<std::array<double, 3>> points;
  std::vector<std::size_t> point_lines;        ///< per point: its line; empty if the file is binary
  std::vector<std::size_t> corners;            ///< the point indices of all polygons, one polygon after the other
  std::vector<std::size_t> first_corner = {0}; ///< per polygon: where it begins in `corners`, and the end
  std::vector<std::size_t> polygon_lines;      ///< per polygon: its line; empty if the file is binary
  std::vector<std::array<double, 2>> uvs;      ///< texture coordinates (OBJ)
  std::vector<std::size_t> uv_corners;         ///< per corner: index into `uvs`, or `no_uv`; empty if not OBJ
  std::size_t number_of_merged_points = 0;     ///< STL
  std::size_t number_of_trailing_bytes = 0;    ///< binary STL: behind the last facet

  /// Of a soup that was changed: the numbers that its points and polygons have in the file. Empty: they are as in the file.
  std::vector<std::size_t> point_numbers, polygon_numbers;

  static constexpr std::size_t no_uv = static_cast<std::size_t>(-1);

  std::size_t number_of_polygons() const { return first_corner.size() - 1; }
  std::size_t size_of_polygon(const std::size_t f) const { return first_corner[f + 1] - first_corner[f]; }
  std::size_t corner(const std::size_t f, const std::size_t i) const { return corners[first_corner[f] + i]; }

  /// The position in `corners` of the corner after `c` on the polygon `f`.
  std::size_t next_corner(const std::size_t f, const std::size_t c) const
  {
    return c + 1 == first_corner[f + 1] ? first_corner[f] : c + 1;
  }

  /// The polygon made of the corners that were appended since the last polygon.
  void end_polygon() { first_corner.push_back(corners.size()); }

  std::size_t number_of_point(const std::size_t v) const { return point_numbers.empty() ? v : point_numbers[v]; }
  std::size_t number_of_polygon(const std::size_t f) const { return polygon_numbers.empty() ? f : polygon_numbers[f]; }

  std::size_t line_of_point(const std::size_t v) const
  {
    return v < point_lines.size() ? point_lines[v] : Mesh_reading_report::none;
  }
  std::size_t line_of_polygon(const std::size_t f) const
  {
    return f < polygon_lines.size() ? polygon_lines[f] : Mesh_reading_report::none;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_POLYGON_SOUP_H
