// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_MERGE_BOUNDARIES_H
#define CGAL_T_SPLINES_IO_INTERNAL_MERGE_BOUNDARIES_H

#include <CGAL/T_splines/IO/internal/Side_pairing.h>
#include <CGAL/T_splines/IO/internal/edit_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What merging did.
struct Merged_boundaries {
  std::size_t number_of_points = 0; ///< that were replaced by another one
  double largest_distance = 0;      ///< between a point and the one that replaced it, in the units of the file
  double closing_distance = 0;      ///< between ends of two sides that were made one edge; likewise
};

/// The points that pairs of sides make one: a union-find structure whose representatives are the first of their points.
class Merged_points {
public:
  explicit Merged_points(const std::size_t number_of_points) : m_parent(number_of_points)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  std::size_t representative(std::size_t v) const
  {
    while (m_parent[v] != v)
      v = m_parent[v];
    return v;
  }

  void unite(const Side_pair& pair)
  {
    unite(pair.first.source, pair.is_opposite ? pair.second.target : pair.second.source);
    unite(pair.first.target, pair.is_opposite ? pair.second.source : pair.second.target);
  }

  void unite(const std::size_t v, const std::size_t w)
  {
    const std::size_t a = shortened(v), b = shortened(w);
    m_parent[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::size_t> representatives()
  {
    for (std::size_t v = 0; v < m_parent.size(); ++v) // parents come before their children
      m_parent[v] = m_parent[m_parent[v]];
    return m_parent;
  }

private:
  std::size_t shortened(std::size_t v)
  {
    const std::size_t root = representative(v);
    while (m_parent[v] != root) {
      const std::size_t next = m_parent[v];
      m_parent[v] = root;
      v = next;
    }
    return root;
  }

  std::vector<std::size_t> m_parent;
};

/// Replaces points by their representatives.
inline Merged_boundaries merge_points(const std::vector<std::size_t>& representative, Polygon_soup& soup)
{
  Merged_boundaries result;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const auto &p = soup.points[v], &q = soup.points[representative[v]];
    result.largest_distance = std::max(result.largest_distance, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  replace_points(representative, soup);
  result.number_of_points = remove_points([&](const std::size_t v) { return representative[v] == v; }, soup);
  return result;
}

/// Marks the points whose merging would give a polygon the same point twice, or an edge a third side.
inline std::vector<char> points_in_conflict(const Polygon_soup& soup, const std::vector<std::size_t>& representative)
{
  std::vector<char> is_in_conflict(soup.points.size(), 0);
  std::vector<std::size_t> last_polygon(soup.points.size(), Mesh_reading_report::none);
  Polygon_soup merged;
  merged.first_corner = soup.first_corner;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    for (std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c) {
      const std::size_t v = representative[soup.corners[c]];
      merged.corners.push_back(v);
      if (last_polygon[v] == f)
        is_in_conflict[v] = 1;
      last_polygon[v] = f;
    }
  for_each_edge(merged, [&is_in_conflict](const Polygon_side* first, const Polygon_side* last) {
    if (last - first > 2)
      is_in_conflict[first->source] = is_in_conflict[first->target] = 1;
  });
  return is_in_conflict;
}

/// Whether a merge may give a polygon the same point twice and an edge more than two sides; it can be repaired.
enum class Merge_conflicts { AVOIDED, ADMITTED };

/// The representative of each point once the pairs are glued. Removes the pairs that are in conflict.
inline std::vector<std::size_t> merged_points(const Polygon_soup& soup, const Merge_conflicts conflicts,
                                              std::vector<Side_pair>& pairs)
{
  while (true) {
    Merged_points merged(soup.points.size());
    for (const Side_pair& pair : pairs)
      merged.unite(pair);
    const std::vector<std::size_t> representative = merged.representatives();
    if (conflicts == Merge_conflicts::ADMITTED)
      return representative;
    const std::vector<char> is_in_conflict = points_in_conflict(soup, representative);
    const auto end = std::remove_if(pairs.begin(), pairs.end(), [&](const Side_pair& pair) {
      return is_in_conflict[representative[pair.first.source]] || is_in_conflict[representative[pair.first.target]];
    });
    if (end == pairs.end())
      return representative;
    pairs.erase(end, pairs.end());
  }
}

/// Merges the ends of boundary edges that coincide up to a distance, in the units of the file: exactly coincident ones
/// first, then the nearest. The point that comes first in the file stays. \pre No polygon has less than three corners.
inline Merged_boundaries merge_boundaries(const double distance, const double round_off,
                                          const Merge_conflicts conflicts, Polygon_soup& soup)
{
  Merged_boundaries result;
  std::vector<Polygon_side> sides = boundary_sides(soup);
  if (sides.empty())
    return result;
  std::vector<Side_pair> pairs;
  Side_pairing pairing(soup);
  pairing.pair_coincident(sides, pairs);
  if (distance > 0)
    pairing.pair_near(distance, std::min(distance, round_off), sides, pairs);

  const std::vector<std::size_t> representative = merged_points(soup, conflicts, pairs);
  if (pairs.empty())
    return result;
  for (const Side_pair& pair : pairs)
    result.closing_distance = std::max(result.closing_distance, pairing.distance(pair));
  const Merged_boundaries merged = merge_points(representative, soup);
  result.number_of_points = merged.number_of_points;
  result.largest_distance = merged.largest_distance;
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_MERGE_BOUNDARIES_H
