// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_EDGE_DISTANCES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_EDGE_DISTANCES_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Shortest paths of edges on a triangulation, by Dijkstra's algorithm; one search after the other, each of
/// which costs as much as the part of the mesh that it reaches.
class Edge_distances {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param length per edge: not negative
  Edge_distances(const Triangulation_connectivity& mesh, const std::vector<double>& length)
    : m_mesh(mesh),
      m_length(length),
      m_outgoing(mesh.outgoing_halfedges()),
      m_distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity()),
      m_entry(mesh.number_of_vertices(), null)
  {
  }

  /// reaches the vertices by increasing distance from `source` and calls `go_on(v, distance)` for each, `source`
  /// included, until it returns `false`. Vertices at the same distance come in the order of their indices.
  template <typename Predicate>
  void search(const int source, Predicate&& go_on)
  {
    for (const int v : m_reached) {
      m_distance[v] = std::numeric_limits<double>::infinity();
      m_entry[v] = null;
    }
    m_reached.assign(1, source);
    m_distance[source] = 0;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.emplace(0., source);
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (distance > m_distance[v])
        continue;
      if (!go_on(v, distance))
        return;
      m_mesh.for_each_around_source(m_outgoing[v], [&, here = distance](const int h) {
        const int w = m_mesh.target(h);
        const double via_v = here + m_length[edge_of(h)];
        if (via_v < m_distance[w]) {
          if (m_distance[w] == std::numeric_limits<double>::infinity())
            m_reached.push_back(w);
          m_distance[w] = via_v;
          m_entry[w] = h;
          queue.emplace(via_v, w);
        }
      });
    }
  }

  /// The halfedges of the shortest path from the source of the last search to a vertex that it has reached.
  std::vector<int> path_to(const int target) const
  {
    std::vector<int> path;
    for (int v = target; m_entry[v] != null; v = m_mesh.source(path.back()))
      path.push_back(m_entry[v]);
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  const Triangulation_connectivity& m_mesh;
  const std::vector<double>& m_length;
  std::vector<int> m_outgoing;
  std::vector<double> m_distance; // per vertex: from the source of the last search, so far
  std::vector<int> m_entry;       // per vertex: the last halfedge of the path to it
  std::vector<int> m_reached;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_EDGE_DISTANCES_H
