// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_FEATURE_ARCS_H
#define CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_FEATURE_ARCS_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The graph of the marked edges of a triangulation, as chains of edges.
///
/// A vertex with other than two marked edges is a node, and so is one on the border with any. An arc is a chain of marked
/// edges from node to node with no node between, or a closed one without any. Marked edges on the border do not count:
/// the border bounds by itself.
class Feature_arcs {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// A chain of halfedges, each from the target of the one before.
  struct Arc {
    std::vector<int> halfedges;
    bool is_closed = false; ///< whether it has no node
  };

  /// \param is_feature per edge
  Feature_arcs(const Triangulation_connectivity& mesh, const std::vector<char>& is_feature)
    : m_mesh(mesh),
      m_is_on_border(mesh.number_of_vertices(), 0),
      m_degree(mesh.number_of_vertices(), 0),
      m_outgoing(mesh.number_of_vertices(), {{null, null}}),
      m_is_done(mesh.number_of_edges(), 0)
  {
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == null) {
        m_is_on_border[mesh.target(h)] = 1;
        m_is_done[edge_of(h)] = 1;
      }
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      if (m_is_done[edge_of(h)] || !is_feature[edge_of(h)])
        continue;
      const Index v = mesh.source(h);
      if (m_degree[v] < 2)
        m_outgoing[v][m_degree[v]] = h;
      ++m_degree[v];
    }
    for (const bool is_closed : {false, true})
      for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
        if (is_feature[edge_of(h)] && !m_is_done[edge_of(h)] && (is_closed || is_node(mesh.source(h))))
          m_arcs.push_back(arc_from(h, is_closed));
  }

  /// Open ones first.
  const std::vector<Arc>& arcs() const { return m_arcs; }

  /// How many marked edges, not on the border, a vertex has.
  int degree(const int v) const { return m_degree[v]; }
  bool is_on_border(const int v) const { return m_is_on_border[v] != 0; }
  bool is_node(const int v) const { return m_degree[v] > 0 && (m_degree[v] != 2 || is_on_border(v)); }

  /// Whether the marked edges end at a vertex inside the surface.
  bool is_loose_end(const int v) const { return m_degree[v] == 1 && !is_on_border(v); }

  /// How many of the two ends of an arc are loose.
  int number_of_loose_ends(const Arc& arc) const
  {
    return (is_loose_end(m_mesh.source(arc.halfedges.front())) ? 1 : 0) +
           (is_loose_end(m_mesh.target(arc.halfedges.back())) ? 1 : 0);
  }

private:
  Arc arc_from(Index h, const bool is_closed)
  {
    Arc arc;
    arc.is_closed = is_closed;
    for (;;) {
      arc.halfedges.push_back(h);
      m_is_done[edge_of(h)] = 1;
      const Index v = m_mesh.target(h);
      if (is_node(v))
        return arc;
      h = m_outgoing[v][m_outgoing[v][0] == opposite(h) ? 1 : 0];
      if (m_is_done[edge_of(h)])
        return arc;
    }
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<char> m_is_on_border;             // per vertex
  std::vector<int> m_degree;                    // per vertex
  std::vector<std::array<Index, 2>> m_outgoing; // per vertex: of its marked edges, two at most
  std::vector<char> m_is_done;                  // per edge: it is in an arc, or on the border
  std::vector<Arc> m_arcs;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_FEATURE_ARCS_H
