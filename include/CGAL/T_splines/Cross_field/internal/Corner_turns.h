// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CORNER_TURNS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CORNER_TURNS_H

#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Gives the vertices on the border the quarter turns that are wanted there.
///
/// Where a border is straight and the mesh coarse, no field that turns by less than an eighth between neighbours has a corner.
/// So whole quarter turns are carried from inner vertices to those on the border, or back, across the edges of a shortest
/// path: the rotations of the field across them change by a quarter turn. The sum over all vertices stays, and so do the
/// turns of strips relative to each other.
class Corner_turns {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param turns per vertex: those of the field
  /// \param rotation per edge; changed by `carry()`
  Corner_turns(const Triangulation_connectivity& mesh, const std::vector<double>& turns, std::vector<double>& rotation)
    : m_mesh(mesh),
      m_outgoing(mesh.outgoing_halfedges()),
      m_is_on_border(mesh.number_of_vertices(), 0),
      m_mark(mesh.number_of_vertices(), null),
      m_rotation(rotation)
  {
    for (const double k : turns)
      m_turns.push_back(static_cast<int>(std::lround(k)));
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == null)
        m_is_on_border[mesh.target(h)] = 1;
  }

  /// Carries quarter turns until all vertices on the border have those that are wanted, or no inner vertex is left that could
  /// give or take one: each keeps one at least.
  /// \param wanted per vertex; only those on the border matter
  void carry(const std::vector<int>& wanted, Progress& progress)
  {
    for (int v = 0; v < m_mesh.number_of_vertices() && progress.go_on_after(1); ++v)
      while (m_is_on_border[v] != 0 && m_turns[v] != wanted[v] && carry_to(v, m_turns[v] < wanted[v] ? 1 : -1) &&
             progress.go_on_after(100))
        ;
  }

private:
  struct Reached {
    int vertex, halfedge, distance; // the halfedge by which it was reached
    std::size_t parent;
  };

  // Of the nearest inner vertices, the one gives `change` that is most regular afterwards.
  bool carry_to(const int v, const int change)
  {
    std::vector<Reached> reached(1, {v, null, 0, 0});
    m_mark[v] = ++m_number_of_searches;
    std::size_t best = 0;
    for (std::size_t i = 0; i < reached.size() && (best == 0 || reached[i].distance < reached[best].distance); ++i)
      m_mesh.for_each_around_source(m_outgoing[reached[i].vertex], [&](const int h) {
        const int w = m_mesh.target(h);
        if (m_mark[w] == m_number_of_searches || m_mesh.face(h) == null || m_mesh.face(opposite(h)) == null)
          return;
        m_mark[w] = m_number_of_searches;
        reached.push_back({w, h, reached[i].distance + 1, i});
        if (m_is_on_border[w] == 0 && m_turns[w] - change >= 1 &&
            (best == 0 || irregularity(w, change) < irregularity(reached[best].vertex, change)))
          best = reached.size() - 1;
      });
    if (best == 0)
      return false;
    m_turns[reached[best].vertex] -= change;
    m_turns[v] += change;
    for (std::size_t i = best; i != 0; i = reached[i].parent)
      m_rotation[edge_of(reached[i].halfedge)] -=
          (is_along_edge(reached[i].halfedge) ? change : -change) * quarter_turn;
    return true;
  }

  int irregularity(const int v, const int change) const { return std::abs(m_turns[v] - change - 4); }

  const Triangulation_connectivity& m_mesh;
  std::vector<int> m_outgoing, m_turns;
  std::vector<char> m_is_on_border;
  std::vector<int> m_mark; // per vertex: the last search that reached it
  int m_number_of_searches = 0;
  std::vector<double>& m_rotation;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CORNER_TURNS_H
