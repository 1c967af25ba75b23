// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_REPAIR_POLYGON_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_REPAIR_POLYGON_SOUP_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Boundary_sides.h>
#include <CGAL/T_splines/IO/internal/check_polygon_soup.h>
#include <CGAL/T_splines/IO/internal/edit_polygon_soup.h>
#include <CGAL/T_splines/IO/internal/merge_boundaries.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Removes repeated corners, and spikes: corners between two occurrences of the same point.
inline void remove_repeated_corners(std::vector<std::size_t>& corners)
{
  for (std::size_t i = 0; i < corners.size() && corners.size() > 1;) {
    const std::size_t next = (i + 1) % corners.size(), after_next = (i + 2) % corners.size();
    if (corners[i] != corners[next] && corners[i] != corners[after_next]) {
      ++i;
      continue;
    }
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(next));
    i = 0;
  }
}

/// Removes polygons that have less than three different corners, and corners that are repeated.
inline void remove_degenerate_polygons(Polygon_soup& soup, Mesh_repairs& repairs)
{
  const auto edit = [&repairs](std::size_t, std::vector<std::size_t>& corners) {
    const std::size_t size = corners.size();
    remove_repeated_corners(corners);
    if (corners.size() < 3)
      corners.clear();
    repairs.shortened_faces += !corners.empty() && corners.size() < size;
  };
  repairs.degenerate_faces += edit_polygons(edit, soup);
}

/// Makes the ends of sides one point that are not longer than `distance`, in the units of the file.
inline Merged_boundaries collapse_short_sides(const double distance, Polygon_soup& soup)
{
  Merged_points merged(soup.points.size());
  const auto is_near = [&](const std::size_t v, const std::size_t w) {
    const auto &p = soup.points[v], &q = soup.points[w];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= distance;
  };
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    for (std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c) {
      const std::size_t v = soup.corners[c], w = soup.corners[soup.next_corner(f, c)];
      // The representatives, so that a chain of short sides does not become one point.
      if (v != w && is_near(v, w) && is_near(merged.representative(v), merged.representative(w)))
        merged.unite(v, w);
    }
  return merge_points(merged.representatives(), soup);
}

/// The first point that has the same coordinates, of each point.
inline std::vector<std::size_t> places_of_points(const Polygon_soup& soup)
{
  std::map<std::array<double, 3>, std::size_t> first;
  std::vector<std::size_t> place;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    place.push_back(first.emplace(soup.points[v], v).first->second);
  return place;
}

/// Removes polygons whose corners are at the places of those of an earlier one, in the same cyclic order.
///
/// The reversed ones remain: they are walls between bodies that touch. But where most polygons have one, the file has
/// a front and a back of the same surface, and the later ones are removed, too.
inline void remove_duplicate_polygons(Polygon_soup& soup, Mesh_repairs& repairs)
{
  const std::vector<std::size_t> place = places_of_points(soup);
  const auto normal_form = [&place](std::vector<std::size_t> corners) {
    for (std::size_t& v : corners)
      v = place[v];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
  };
  std::map<std::vector<std::size_t>, std::size_t> first_of_corners;
  std::vector<char> is_equal(soup.number_of_polygons(), 0), is_reversed(soup.number_of_polygons(), 0);
  std::size_t number_of_different = 0, number_of_reversed = 0;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    std::vector<std::size_t> corners(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first_corner[f]),
                                     soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first_corner[f + 1]));
    is_equal[f] = !first_of_corners.emplace(normal_form(corners), f).second;
    std::reverse(corners.begin(), corners.end());
    is_reversed[f] = !is_equal[f] && first_of_corners.count(normal_form(corners)) > 0;
    number_of_different += !is_equal[f];
    number_of_reversed += is_reversed[f];
  }
  const bool is_two_sided = 4 * number_of_reversed > number_of_different; // more than half of the fronts have a back
  const auto edit = [&](const std::size_t f, std::vector<std::size_t>& corners) {
    if (is_equal[f] || (is_two_sided && is_reversed[f]))
      corners.clear();
  };
  repairs.duplicate_faces += edit_polygons(edit, soup);
}

/// Hears which polygons are turned around.
struct Reversal_visitor : CGAL::Polygon_mesh_processing::Default_orientation_visitor {
  std::vector<char>* is_reversed;

  explicit Reversal_visitor(std::vector<char>& is_reversed_) : is_reversed(&is_reversed_) {}
  void polygon_orientation_reversed(const std::size_t f) const { (*is_reversed)[f] = !(*is_reversed)[f]; }
};

/// The component of each polygon by edges that belong to two polygons, as the least number of one of its polygons.
inline std::vector<std::size_t> polygon_components(const Polygon_soup& soup)
{
  std::vector<std::size_t> parent(soup.number_of_polygons());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&parent](std::size_t f) {
    while (parent[f] != f)
      f = parent[f] = parent[parent[f]];
    return f;
  };
  for_each_edge(soup, [&](const Polygon_side* first, const Polygon_side* last) {
    if (last - first == 2) {
      const std::size_t f = root(first[0].polygon), g = root(first[1].polygon);
      parent[std::max(f, g)] = std::min(f, g);
    }
  });
  for (std::size_t f = 0; f < parent.size(); ++f)
    parent[f] = root(f);
  return parent;
}

/// Orients neighbours consistently, in each component as most of its polygons are, and splits points so that no edge has
/// more than two polygons and no point more than one fan.
inline void orient_polygons(Polygon_soup& soup, Mesh_repairs& repairs)
{
  std::vector<std::vector<std::size_t>> polygons(soup.number_of_polygons());
  for (std::size_t f = 0; f < polygons.size(); ++f)
    polygons[f].assign(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first_corner[f]),
                       soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.first_corner[f + 1]));
  std::vector<std::size_t> origins(soup.points.size()); // stand for the points
  std::iota(origins.begin(), origins.end(), std::size_t(0));
  std::vector<char> is_reversed(polygons.size(), 0);
  const Reversal_visitor visitor(is_reversed);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(origins, polygons, CGAL::parameters::visitor(visitor));

  if (soup.point_numbers.empty()) {
    soup.point_numbers.resize(soup.points.size());
    std::iota(soup.point_numbers.begin(), soup.point_numbers.end(), std::size_t(0));
  }
  for (std::size_t v = soup.points.size(); v < origins.size(); ++v) {
    soup.points.push_back(soup.points[origins[v]]);
    soup.point_numbers.push_back(soup.point_numbers[origins[v]]);
    if (!soup.point_lines.empty())
      soup.point_lines.push_back(soup.point_lines[origins[v]]);
  }
  edit_polygons([&polygons](const std::size_t f, std::vector<std::size_t>& corners) { corners = polygons[f]; }, soup);

  const std::vector<std::size_t> component = polygon_components(soup);
  std::vector<std::size_t> size(polygons.size(), 0), number_of_reversed(polygons.size(), 0);
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    ++size[component[f]];
    number_of_reversed[component[f]] += static_cast<std::size_t>(is_reversed[f]);
  }
  const auto is_turned_back = [&](const std::size_t f) {
    return 2 * number_of_reversed[component[f]] > size[component[f]];
  };
  const auto turn_back = [&](const std::size_t f, std::vector<std::size_t>& corners) {
    if (is_turned_back(f))
      std::reverse(corners.begin(), corners.end());
  };
  edit_polygons(turn_back, soup);
  for (std::size_t f = 0; f < polygons.size(); ++f)
    repairs.reversed_faces += (is_reversed[f] != 0) != is_turned_back(f);
}

/// Removes points that no polygon has.
inline void remove_isolated_points(Polygon_soup& soup, Mesh_repairs& repairs)
{
  const std::vector<char> is_used = used_points(soup);
  repairs.isolated_vertices += remove_points([&is_used](const std::size_t v) { return is_used[v] != 0; }, soup);
}

/// Repairs what can be repaired without points at new places. Ends of boundary edges are merged as by `merge_boundaries()`,
/// those of sides that are not longer than the distance, too.
/// \param progress if it is interrupted, the repair is not complete
inline Merged_boundaries repair_polygon_soup(const double distance, const double round_off, Polygon_soup& soup,
                                             Mesh_repairs& repairs, Progress& progress)
{
  const std::size_t number_of_points = soup.points.size();
  const Merged_boundaries collapsed = collapse_short_sides(distance, soup);
  remove_degenerate_polygons(soup, repairs);
  if (!progress.go_on())
    return collapsed;
  remove_duplicate_polygons(soup, repairs);
  if (!progress.go_on())
    return collapsed;
  Merged_boundaries result = merge_boundaries(distance, round_off, Merge_conflicts::ADMITTED, soup);
  if (!progress.go_on())
    return result;
  remove_degenerate_polygons(soup, repairs);
  remove_duplicate_polygons(soup, repairs);
  if (!progress.go_on())
    return result;
  if (Polygon_soup_checker(soup, true, progress)
          .check_polygons()
          .success()) // else some are no simple cycles, and are refused
    orient_polygons(soup, repairs);
  if (!progress.go_on())
    return result;
  const Merged_boundaries second = merge_boundaries(distance, round_off, Merge_conflicts::AVOIDED, soup);
  remove_isolated_points(soup, repairs);

  // Some points may have been split and merged again.
  const std::set<std::size_t> numbers(soup.point_numbers.begin(), soup.point_numbers.end());
  repairs.split_vertices = soup.points.size() - numbers.size();
  result.number_of_points = number_of_points - numbers.size() - repairs.isolated_vertices;
  result.largest_distance = std::max({collapsed.largest_distance, result.largest_distance, second.largest_distance});
  result.closing_distance = std::max(result.closing_distance, second.closing_distance);
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_REPAIR_POLYGON_SOUP_H
