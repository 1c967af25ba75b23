// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ARC_LINES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ARC_LINES_H

#include <CGAL/T_splines/Similarity_map/internal/Chart_line.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_arcs.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_search.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The isolines on which arcs lie, in the charts of the faces on their left.
class Arc_lines {
  using Index = Triangulation_connectivity::Index;

public:
  Arc_lines(const Cut_map& map, const Isoline_arcs& arcs) : m_map(map), m_arcs(arcs) {}

  Index first_halfedge(const int arc) const { return m_arcs.halfedge(arc, 0); }

  /// The two nodes of each arc lie on one line.
  std::vector<Isoline_coincidence> coincidences() const
  {
    std::vector<Isoline_coincidence> result;
    for (int a = 0; a < m_arcs.number_of_arcs(); ++a) {
      const int n = m_arcs.length(a);
      const Index first = m_arcs.halfedge(a, 0);
      Isoline_coincidence line{m_map.mesh.previous(first), m_arcs.halfedge(a, n - 1), axis(first), {}, 0};
      for (int i = 0; i + 1 < n; ++i)
        cross_cut_edges(a, i, [&line](const Index h) { line.crossed.push_back(h); });
      result.push_back(std::move(line));
    }
    return result;
  }

  /// Calls `place(h, line)` for the vertices within arcs: `h` points to the vertex, and the line is one of its chart.
  /// \param transition function object: halfedge -> transition from the chart of its face to that of its opposite's
  /// \param node_coordinate function object: a halfedge that points to a node, axis -> the coordinate of the node
  /// \return an arc whose end is not on the line of its start, or -1
  template <typename FT, typename Transition_of, typename Node_coordinate, typename Place>
  int follow(const Transition_of& transition, const Node_coordinate& node_coordinate, const Place& place) const
  {
    int open_arc = -1;
    for (int a = 0; a < m_arcs.number_of_arcs(); ++a) {
      const int n = m_arcs.length(a);
      const Index first = m_arcs.halfedge(a, 0);
      Chart_line<FT> line{axis(first), node_coordinate(m_map.mesh.previous(first), axis(first))};
      for (int i = 0; i + 1 < n; ++i) {
        place(m_arcs.halfedge(a, i), line);
        cross_cut_edges(a, i, [&](const Index h) { line = line.mapped(transition(h)); });
      }
      if (node_coordinate(m_arcs.halfedge(a, n - 1), line.axis) != line.value)
        open_arc = a;
    }
    return open_arc;
  }

private:
  int axis(const Index h) const { return constant_axis(m_map.mesh, m_map.uv, h); }

  // Calls `cross(h)` for the cut edges between the left sides of an edge and the next one of an arc, as halfedges of
  // the faces that are left.
  template <typename Cross>
  void cross_cut_edges(const int arc, const int i, const Cross& cross) const
  {
    const Index end = m_arcs.halfedge(arc, i + 1);
    for (Index out = m_map.mesh.next(m_arcs.halfedge(arc, i)); out != end; out = m_map.mesh.next(opposite(out)))
      if (m_map.is_cut[edge_of(out)])
        cross(out);
  }

  const Cut_map& m_map;
  const Isoline_arcs& m_arcs;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ARC_LINES_H
