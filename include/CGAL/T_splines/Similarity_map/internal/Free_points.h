// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FREE_POINTS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FREE_POINTS_H

#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>

#include <unordered_map>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Vertices whose place decides about isolines, and which the transitions do not determine: cones around which nothing
/// turns, corners of the border, and nodes of arcs that are to lie on isolines.
class Free_points {
  using Index = Triangulation_connectivity::Index;

public:
  static constexpr int none = -1;

  struct Point {
    Index vertex;
    int entry;    ///< in the list of cut vertices, or none
    int sector;   ///< whose chart the coordinates refer to
    Index corner; ///< a halfedge that points to the vertex in this sector
    int quarter_turns;
  };

  /// A point on the cut or on the border.
  void add(const Cut_map& map, const int entry, const int sector)
  {
    const Index h = map.sectors.halfedge[map.sectors.first_sector[entry] + sector];
    add({map.sectors.vertices[entry], entry, sector, map.mesh.previous(h), map.quarter_turns[entry]});
  }

  /// A point off the cut. \param corner points to it
  void add_off_cut(const Cut_map& map, const Index corner, const int quarter_turns)
  {
    add({map.mesh.target(corner), none, none, corner, quarter_turns});
  }

  int size() const { return static_cast<int>(m_points.size()); }
  const Point& operator[](const int i) const { return m_points[i]; }

  /// The number of the point at a vertex, or none.
  int at_vertex(const Index v) const
  {
    const auto place = m_number.find(v);
    return place == m_number.end() ? none : place->second;
  }

private:
  void add(const Point& point)
  {
    m_number.emplace(point.vertex, size());
    m_points.push_back(point);
  }

  std::vector<Point> m_points;
  std::unordered_map<Index, int> m_number;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FREE_POINTS_H
