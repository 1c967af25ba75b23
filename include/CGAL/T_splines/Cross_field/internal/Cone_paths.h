// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_PATHS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_PATHS_H

#include <CGAL/T_splines/Cross_field/internal/Edge_distances.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How often shortest paths of edges from cone to cone cross loops. Searches are only made when a path is asked for:
/// the first one from a cone goes as far as it has to, the second one everywhere.
class Cone_paths {
public:
  /// \param vertices per cone
  /// \param strips the loops
  Cone_paths(const Triangulation_connectivity& mesh, const std::vector<double>& edge_length,
             const std::vector<int>& vertices, const std::vector<std::vector<int>>& strips)
    : m_mesh(mesh),
      m_vertices(vertices),
      m_number_of_loops(strips.size()),
      m_distances(mesh, edge_length),
      m_cone_of_vertex(mesh.number_of_vertices(), Triangulation_connectivity::null),
      m_crossings(vertices.size())
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      m_cone_of_vertex[vertices[i]] = static_cast<int>(i);
    for (std::size_t l = 0; l < strips.size(); ++l)
      for (const int h : strips[l])
        m_passages[mesh.edge(h)].emplace_back(static_cast<int>(l), h % 2 == 0 ? 1 : -1);
  }

  /// For each loop, how often it enters faces by halfedges of the path, minus how often by their opposites.
  /// \pre The cones belong to the same component, and there are loops.
  const std::vector<int>& crossings(const int from, const int to)
  {
    CGAL_precondition(m_number_of_loops > 0);
    std::vector<std::vector<int>>& known = m_crossings[from];
    const bool is_first_search = known.empty();
    known.resize(m_vertices.size());
    if (known[to].empty()) {
      m_distances.search(m_vertices[from], [&](const int v, double) {
        const int cone = m_cone_of_vertex[v];
        if (cone != Triangulation_connectivity::null && known[cone].empty())
          known[cone] = crossings_of_path_to(v);
        return cone != to || !is_first_search;
      });
    }
    return known[to];
  }

private:
  std::vector<int> crossings_of_path_to(const int v) const
  {
    std::vector<int> result(m_number_of_loops, 0);
    for (const int h : m_distances.path_to(v)) {
      const auto passages = m_passages.find(m_mesh.edge(h));
      if (passages == m_passages.end())
        continue;
      for (const auto& [loop, sign] : passages->second)
        result[loop] += h % 2 == 0 ? sign : -sign;
    }
    return result;
  }

  const Triangulation_connectivity& m_mesh;
  const std::vector<int>& m_vertices;
  std::size_t m_number_of_loops;
  Edge_distances m_distances;
  std::vector<int> m_cone_of_vertex;
  std::unordered_map<int, std::vector<std::pair<int, int>>> m_passages; // per edge: the loops through its even halfedge
  std::vector<std::vector<std::vector<int>>> m_crossings;               // per pair of cones; empty if not known
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_PATHS_H
