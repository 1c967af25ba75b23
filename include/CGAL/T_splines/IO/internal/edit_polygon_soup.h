// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_EDIT_POLYGON_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_EDIT_POLYGON_SOUP_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The longest side of the bounding box of the points: what distances are relative to.
inline double longest_side(const Polygon_soup& soup)
{
  Axis_parallel_box<double> box;
  for (const std::array<double, 3>& p : soup.points)
    box.extend(p);
  return box.extent();
}

/// Replaces each corner by the representative of its point. The points that are replaced remain, without a polygon.
inline void replace_points(const std::vector<std::size_t>& representative, Polygon_soup& soup)
{
  for (std::size_t& v : soup.corners)
    v = representative[v];
}

/// Removes the points for which `is_kept` is `false`. \pre They have no polygon.
template <typename IsKept>
std::size_t remove_points(const IsKept& is_kept, Polygon_soup& soup)
{
  std::vector<std::size_t> new_index(soup.points.size(), 0);
  if (soup.point_numbers.empty()) {
    soup.point_numbers.resize(soup.points.size());
    std::iota(soup.point_numbers.begin(), soup.point_numbers.end(), std::size_t(0));
  }
  std::size_t n = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (!is_kept(v))
      continue;
    new_index[v] = n;
    soup.points[n] = soup.points[v];
    soup.point_numbers[n] = soup.point_numbers[v];
    if (!soup.point_lines.empty())
      soup.point_lines[n] = soup.point_lines[v];
    ++n;
  }
  const std::size_t number_of_removed = soup.points.size() - n;
  soup.points.resize(n);
  soup.point_numbers.resize(n);
  soup.point_lines.resize(std::min(n, soup.point_lines.size()));
  for (std::size_t& v : soup.corners)
    v = new_index[v];
  return number_of_removed;
}

/// Which points are corners of polygons.
inline std::vector<char> used_points(const Polygon_soup& soup)
{
  std::vector<char> is_used(soup.points.size(), 0);
  for (const std::size_t v : soup.corners)
    is_used[v] = 1;
  return is_used;
}

/// Writes a soup anew, polygon by polygon. Texture coordinates are lost.
/// \param edit is called with the number of a polygon and its corners, which it may change; what it leaves without
///   corners is removed
/// \return how many were removed.
template <typename Edit>
std::size_t edit_polygons(const Edit& edit, Polygon_soup& soup)
{
  Polygon_soup result;
  std::vector<std::size_t> corners;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    corners.assign(soup.corners.begin() + soup.first_corner[f], soup.corners.begin() + soup.first_corner[f + 1]);
    edit(f, corners);
    if (corners.empty())
      continue;
    result.corners.insert(result.corners.end(), corners.begin(), corners.end());
    result.end_polygon();
    result.polygon_numbers.push_back(soup.number_of_polygon(f));
    if (!soup.polygon_lines.empty())
      result.polygon_lines.push_back(soup.polygon_lines[f]);
  }
  const std::size_t number_of_removed = soup.number_of_polygons() - result.number_of_polygons();
  soup.corners = std::move(result.corners);
  soup.first_corner = std::move(result.first_corner);
  soup.polygon_numbers = std::move(result.polygon_numbers);
  soup.polygon_lines = std::move(result.polygon_lines);
  soup.uvs.clear();
  soup.uv_corners.clear();
  return number_of_removed;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_EDIT_POLYGON_SOUP_H
