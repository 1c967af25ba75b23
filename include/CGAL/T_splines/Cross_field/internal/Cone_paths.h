// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_PATHS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_PATHS_H

#include <CGAL/T_splines/Cross_field/internal/Edge_distances.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How often shortest paths of edges from cone to cone cross strips. Searches are only made when a path is asked for: the
/// first one from a cone goes as far as it has to, the second one everywhere. Between two cones there is one path,
/// whichever way it is asked for.
class Cone_paths {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param vertices per cone
  /// \param strips the strips
  /// \param progress asked by all searches; it must outlive this. If it is interrupted, what is found means nothing
  Cone_paths(const Triangulation_connectivity& mesh, const std::vector<double>& edge_length,
             const std::vector<int>& vertices, const std::vector<std::vector<int>>& strips, Progress& progress)
    : m_vertices(vertices),
      m_number_of_strips(strips.size()),
      m_distances(mesh, edge_length),
      m_cone_of_vertex(mesh.number_of_vertices(), null),
      m_number_of_searches(vertices.size(), 0),
      m_progress(progress)
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      m_cone_of_vertex[vertices[i]] = static_cast<int>(i);
    for (std::size_t l = 0; l < strips.size(); ++l)
      for (const int h : strips[l])
        m_passages[edge_of(h)].emplace_back(static_cast<int>(l), is_along_edge(h) ? 1 : -1);
  }

  /// For each strip, how often it enters faces by halfedges of the path, minus how often by their opposites.
  /// \pre The cones belong to the same component, are not forgotten, and there are strips.
  std::vector<int> crossings(const int from, const int to)
  {
    CGAL_precondition(m_number_of_strips > 0);
    if (from > to) {
      std::vector<int> result = crossings(to, from);
      for (int& number : result)
        number = -number;
      return result;
    }
    auto known = m_known.find({from, to});
    if (known == m_known.end()) {
      const bool is_first_search = m_number_of_searches[from]++ == 0;
      m_distances.search(m_vertices[from], [&](const int v, double) {
        record(from, v);
        return m_progress.go_on_after(10) && (m_cone_of_vertex[v] != to || !is_first_search);
      });
      known = m_known.find({from, to});
      if (known == m_known.end()) // interrupted
        return std::vector<int>(m_number_of_strips, 0);
    }
    return known->second;
  }

  /// The halfedges of the path between two cones. \pre The cones belong to the same component
  std::vector<int> path(const int from, const int to)
  {
    std::vector<int> result;
    if (from > to) {
      result = path(to, from);
      std::reverse(result.begin(), result.end());
      for (int& h : result)
        h = opposite(h);
      return result;
    }
    m_distances.search(m_vertices[from],
                       [&](const int v, double) { return m_progress.go_on_after(10) && v != m_vertices[to]; });
    return m_distances.path_to(m_vertices[to]);
  }

  /// computes the `number` cones that are nearest to `from`, by increasing distance, or fewer if there are no more.
  std::vector<int> nearest(const int from, const int number)
  {
    std::vector<int> result;
    m_distances.search(m_vertices[from], [&](const int v, double) {
      const int cone = m_cone_of_vertex[v];
      if (cone != null && cone != from) {
        result.push_back(cone);
        record(from, v);
      }
      return m_progress.go_on_after(10) && static_cast<int>(result.size()) < number;
    });
    return result;
  }

  /// takes a cone that has become regular out of all later searches.
  void forget(const int cone) { m_cone_of_vertex[m_vertices[cone]] = null; }

  /// gives up all that is known, and with it the memory.
  void restart()
  {
    m_known.clear();
    std::fill(m_number_of_searches.begin(), m_number_of_searches.end(), 0);
  }

private:
  // Notes the path to a vertex that the search from cone `from` has reached, if there is a cone and no path yet.
  void record(const int from, const int v)
  {
    const int cone = m_cone_of_vertex[v];
    if (cone == null || cone == from)
      return;
    std::vector<int>& crossings = m_known[std::minmax(from, cone)];
    if (!crossings.empty())
      return;
    crossings.assign(m_number_of_strips, 0);
    const int direction = from < cone ? 1 : -1;
    for (const int h : m_distances.path_to(v)) {
      const auto passages = m_passages.find(edge_of(h));
      if (passages == m_passages.end())
        continue;
      for (const auto& [strip, sign] : passages->second)
        crossings[strip] += is_along_edge(h) ? direction * sign : -direction * sign;
    }
  }

  const std::vector<int>& m_vertices;
  std::size_t m_number_of_strips;
  Edge_distances m_distances;
  std::vector<int> m_cone_of_vertex;
  std::unordered_map<int, std::vector<std::pair<int, int>>>
      m_passages;                                          // per edge: the strips through its even halfedge
  std::vector<int> m_number_of_searches;                   // per cone: that went as far as they had to
  std::map<std::pair<int, int>, std::vector<int>> m_known; // per pair of cones, the smaller index first
  Progress& m_progress;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_PATHS_H
