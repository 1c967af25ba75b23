// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_REFINEMENT_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_REFINEMENT_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Splits a triangulation such that no triangle has two edges that are features or on the border.
///
/// Each edge that is neither, but joins two vertices of such edges, is split in its middle; then each triangle with three
/// such edges at its centre. New vertices are on no feature, and each new edge ends at one: what had to be split is
/// split in one pass. A triangle with two such edges had a third one that joins two vertices of them.
class Feature_refinement {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// \param is_feature per edge
  Feature_refinement(const Triangulation_connectivity& mesh, const std::vector<char>& is_feature)
    : m_mesh(mesh),
      m_is_feature(is_feature)
  {
    const int number_of_edges = mesh.number_of_edges(), number_of_faces = mesh.number_of_faces();
    std::vector<char> is_bound(number_of_edges, 0), has_bound(mesh.number_of_vertices(), 0);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (m_is_feature[edge_of(h)] || mesh.face(h) == null || mesh.face(opposite(h)) == null) {
        is_bound[edge_of(h)] = 1;
        has_bound[mesh.target(h)] = 1;
      }
    std::vector<Index> whole_faces;
    for (Index f = 0; f < number_of_faces; ++f) {
      const Index h = mesh.halfedge_of_face(f);
      if (is_bound[edge_of(h)] && is_bound[edge_of(mesh.next(h))] && is_bound[edge_of(mesh.previous(h))])
        whole_faces.push_back(f);
    }
    for (Index e = 0; e < number_of_edges; ++e) {
      const Index h = halfedge_of_edge(e);
      if (!is_bound[e] && has_bound[mesh.source(h)] && has_bound[mesh.target(h)])
        split_edge(h);
    }
    for (const Index f : whole_faces)
      split_face(f);
    m_mesh.m_number_of_vertices += static_cast<Index>(m_split_halfedges.size() + m_split_faces.size());
  }

  /// The result. Vertices, edges and faces of the input keep their indices; of one that was split, a part does.
  const Triangulation_connectivity& mesh() const { return m_mesh; }

  /// Per edge of the result.
  const std::vector<char>& is_feature() const { return m_is_feature; }

  /// The halfedges of the input in whose middles the first new vertices lie, in their order.
  const std::vector<int>& split_halfedges() const { return m_split_halfedges; }

  /// The faces of the input at whose centres the other new vertices lie.
  const std::vector<int>& split_faces() const { return m_split_faces; }

private:
  Index number_of_vertices() const
  {
    return m_mesh.m_number_of_vertices + static_cast<Index>(m_split_halfedges.size() + m_split_faces.size());
  }

  Index new_edge(const Index target, const Index target_of_opposite)
  {
    const Index h = m_mesh.number_of_halfedges();
    m_mesh.m_next.resize(h + 2, null);
    m_mesh.m_face.resize(h + 2, null);
    m_mesh.m_target.push_back(target);
    m_mesh.m_target.push_back(target_of_opposite);
    m_is_feature.push_back(0);
    return h;
  }

  void set_face(const Index f, const Index a, const Index b, const Index c)
  {
    m_mesh.m_next[a] = b;
    m_mesh.m_next[b] = c;
    m_mesh.m_next[c] = a;
    m_mesh.m_face[a] = m_mesh.m_face[b] = m_mesh.m_face[c] = f;
    m_mesh.m_face_halfedge[f] = a;
  }

  Index new_face()
  {
    m_mesh.m_face_halfedge.push_back(null);
    return m_mesh.number_of_faces() - 1;
  }

  // Of the edge of h, from a to b, the part from a to the middle stays; the triangles on both sides are cut in two.
  void split_edge(const Index h)
  {
    const Index g = opposite(h), middle = number_of_vertices(), target = m_mesh.target(h);
    m_split_halfedges.push_back(h);
    const Index h_next = m_mesh.next(h), h_previous = m_mesh.previous(h);
    const Index g_next = m_mesh.next(g), g_previous = m_mesh.previous(g);
    const Index ahead = new_edge(target, middle);
    const Index left = new_edge(m_mesh.target(h_next), middle), right = new_edge(m_mesh.target(g_next), middle);
    m_mesh.m_target[h] = middle;
    const Index f = m_mesh.face(h), k = m_mesh.face(g), ahead_left = new_face(), ahead_right = new_face();
    set_face(f, h, left, h_previous);
    set_face(ahead_left, ahead, h_next, opposite(left));
    set_face(k, g, g_next, opposite(right));
    set_face(ahead_right, opposite(ahead), right, g_previous);
  }

  void split_face(const Index f)
  {
    const Index centre = number_of_vertices();
    m_split_faces.push_back(f);
    const Index a = m_mesh.halfedge_of_face(f), b = m_mesh.next(a), c = m_mesh.next(b);
    const Index from_a = new_edge(centre, m_mesh.target(a)), from_b = new_edge(centre, m_mesh.target(b)),
                from_c = new_edge(centre, m_mesh.target(c));
    set_face(f, a, from_a, opposite(from_c));
    set_face(new_face(), b, from_b, opposite(from_a));
    set_face(new_face(), c, from_c, opposite(from_b));
  }

  Triangulation_connectivity m_mesh; // its number of vertices is that of the input until all is split
  std::vector<char> m_is_feature;    // per edge
  std::vector<int> m_split_halfedges, m_split_faces;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_REFINEMENT_H
