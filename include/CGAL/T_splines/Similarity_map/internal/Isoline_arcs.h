// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_ARCS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_ARCS_H

#include <CGAL/T_splines/Similarity_map/internal/Chart_line.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The inner edges of a map that are to lie on isolines, as arcs between nodes.
///
/// A vertex is a node unless two such edges go straight through it: with two quarter turns on either side. Cones are
/// nodes, therefore, and so is each vertex of the border. An arc that closes up without one gets one.
class Isoline_arcs {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param is_constrained per edge; empty for none. Those on the border do not count
  Isoline_arcs(const Triangulation_connectivity& mesh, const Uv_array& uv, std::vector<char> is_constrained)
    : m_mesh(mesh),
      m_uv(uv),
      m_is_constrained(std::move(is_constrained))
  {
    for (Index e = 0; e < static_cast<Index>(m_is_constrained.size()); ++e)
      for (const Index h : halfedges_of_edge(e))
        if (m_mesh.face(h) == Triangulation_connectivity::null)
          m_is_constrained[e] = 0;
    if (std::find(m_is_constrained.begin(), m_is_constrained.end(), 1) == m_is_constrained.end())
      m_is_constrained.clear();
    else
      collect_arcs();
  }

  bool is_empty() const { return m_is_constrained.empty(); }
  bool is_constrained(const Index edge) const { return !is_empty() && m_is_constrained[edge] != 0; }
  /// Per edge, or empty.
  const std::vector<char>& constrained_edges() const { return m_is_constrained; }

  int number_of_arcs() const { return static_cast<int>(m_begin.size()) - 1; }
  int length(const int arc) const { return m_begin[arc + 1] - m_begin[arc]; }
  /// The halfedges of an arc, from node to node.
  Index halfedge(const int arc, const int i) const { return m_path[m_begin[arc] + i]; }

  /// Per node, a halfedge that points to it in the face of which it is.
  const std::vector<Index>& corners_of_nodes() const { return m_nodes; }

  /// The first edge, as a halfedge, that is off the axes by more than `tolerance` explains; and by how much.
  std::pair<Index, double> first_oblique_edge(const double tolerance) const
  {
    for (const Index path_halfedge : m_path)
      for (const Index h : halfedges_of_edge(edge_of(path_halfedge))) {
        const auto [angle, is_oblique] = obliqueness(m_mesh, m_uv, h, tolerance);
        if (is_oblique)
          return {h, angle};
      }
    return {Triangulation_connectivity::null, 0};
  }

private:
  void collect_arcs()
  {
    m_is_node.assign(m_mesh.number_of_vertices(), 0);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.face(h) == Triangulation_connectivity::null)
        m_is_node[m_mesh.target(h)] = 1;
    std::vector<char> is_listed(m_mesh.number_of_vertices(), 0);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      const Index v = m_mesh.source(h);
      if (m_is_constrained[edge_of(h)] == 0 || is_listed[v] != 0)
        continue;
      is_listed[v] = 1;
      if (m_is_node[v] != 0 || !goes_straight(h))
        add_node(h);
    }
    std::vector<char> is_done(m_mesh.number_of_edges(), 0);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_is_constrained[edge_of(h)] != 0 && m_is_node[m_mesh.source(h)] != 0 && is_done[edge_of(h)] == 0)
        follow(h, is_done);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) // what is left are closed arcs
      if (m_is_constrained[edge_of(h)] != 0 && is_done[edge_of(h)] == 0) {
        add_node(h);
        follow(h, is_done);
      }
  }

  void add_node(const Index outgoing)
  {
    m_is_node[m_mesh.source(outgoing)] = 1;
    m_nodes.push_back(m_mesh.previous(outgoing));
  }

  void follow(Index h, std::vector<char>& is_done)
  {
    for (;; h = next_constrained(opposite(h))) {
      m_path.push_back(h);
      is_done[edge_of(h)] = 1;
      if (m_is_node[m_mesh.target(h)] != 0)
        break;
    }
    m_begin.push_back(static_cast<int>(m_path.size()));
  }

  // The next one with the same source, counter-clockwise.
  Index next_constrained(const Index h) const
  {
    Index g = m_mesh.next_around_source(h);
    while (m_is_constrained[edge_of(g)] == 0)
      g = m_mesh.next_around_source(g);
    return g;
  }

  // The angle between an edge and the next one in quarter turns.
  int quarter_turns_before_next(const Index h) const
  {
    double angle = 0;
    Index g = h;
    do {
      angle += uv_angle(m_mesh, m_uv, m_mesh.previous(g));
      g = m_mesh.next_around_source(g);
    } while (m_is_constrained[edge_of(g)] == 0);
    return static_cast<int>(std::round(angle / (2 * std::atan(1.))));
  }

  bool goes_straight(const Index h) const
  {
    const Index g = next_constrained(h);
    return g != h && next_constrained(g) == h && quarter_turns_before_next(h) == 2 && quarter_turns_before_next(g) == 2;
  }

  const Triangulation_connectivity& m_mesh;
  const Uv_array& m_uv;
  std::vector<char> m_is_constrained; // per edge
  std::vector<char> m_is_node;        // per vertex
  std::vector<Index> m_nodes;
  std::vector<Index> m_path;
  std::vector<int> m_begin = {0};
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_ARCS_H
