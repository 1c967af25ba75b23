// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SCALE_CYCLES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SCALE_CYCLES_H

#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_scales.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_search.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The scale factors, as products of those of the branches, along closed chains of lines.
///
/// Each line joins a coordinate of one point to a coordinate of another. Where such lines close up, the equation that
/// is left for a coordinate has no solution near it if the product of the scale factors is 1, or nearly so.
class Scale_cycles {
  using Index = Triangulation_connectivity::Index;

  struct Coordinate {
    int axis;
    Exponents scale; ///< by which it is multiplied on the way here
  };

public:
  /// \param lines that are to hold
  Scale_cycles(const Cut_map& map, const std::vector<Isoline_coincidence>& lines) : m_map(map)
  {
    for (const Isoline_coincidence& line : lines)
      add(line);
  }

  /// Exponents by branches.
  const std::vector<Exponents>& cycles() const { return m_cycles; }

private:
  static constexpr int none = -1;

  void cross(const Index h, Coordinate& coordinate) const
  {
    const int b = m_map.graph.branch_of_edge(edge_of(h));
    coordinate.axis ^= m_map.fits[b].quarter_turns() & 1;
    add_to(coordinate.scale, b, m_map.graph.is_along(h) ? 1 : -1);
  }

  // From the chart of a corner to that of the first sector of its vertex.
  void carry_to_first_sector(const Index corner, Coordinate& coordinate) const
  {
    const int i = m_map.entry_of_vertex(m_map.mesh.target(corner));
    if (i == Cut_map::none)
      return;
    for (int k = m_map.sector_of_corner(i, corner); k > 0; --k)
      cross(m_map.sectors.halfedge[m_map.sectors.first_sector[i] + k], coordinate);
  }

  void add(const Isoline_coincidence& line)
  {
    Coordinate start{line.axis, {}}, end{line.axis, {}};
    carry_to_first_sector(line.start, start);
    for (const Index h : line.crossed)
      cross(h, end);
    carry_to_first_sector(line.end, end);
    add_to(end.scale, start.scale, -1);
    int a = node(m_map.mesh.target(line.start), start.axis), b = node(m_map.mesh.target(line.end), end.axis);
    Exponents scale = std::move(end.scale); // from a to b; then between the roots of their trees
    for (; m_parent[b] != none; b = m_parent[b])
      add_to(scale, m_to_parent[b], 1);
    for (; m_parent[a] != none; a = m_parent[a])
      add_to(scale, m_to_parent[a], -1);
    if (a != b) {
      m_parent[a] = b;
      m_to_parent[a] = std::move(scale);
    }
    else if (!scale.empty())
      m_cycles.push_back(std::move(scale));
  }

  int node(const Index vertex, const int axis)
  {
    const auto inserted = m_node.emplace(std::make_pair(vertex, axis), static_cast<int>(m_parent.size()));
    if (inserted.second) {
      m_parent.push_back(none);
      m_to_parent.emplace_back();
    }
    return inserted.first->second;
  }

  const Cut_map& m_map;
  std::map<std::pair<Index, int>, int> m_node; // of a vertex and an axis in its first sector
  std::vector<int> m_parent;                   // trees of coordinates that lines join
  std::vector<Exponents> m_to_parent;
  std::vector<Exponents> m_cycles;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SCALE_CYCLES_H
