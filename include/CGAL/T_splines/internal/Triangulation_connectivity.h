// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_TRIANGULATION_CONNECTIVITY_H
#define CGAL_T_SPLINES_INTERNAL_TRIANGULATION_CONNECTIVITY_H

#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The connectivity of a closed oriented triangulated surface in index arrays.
///
/// Halfedges and edges are numbered as in `halfedge_indices.h`. The triangulation may be non-simple: an edge may join a
/// vertex to itself, two edges may join the same vertices, and a triangle may meet itself along an edge. Nothing is
/// looked up by vertex pairs, therefore, and every halfedge is named by its index.
struct Triangulation_connectivity {
  using Index = int;
  static constexpr Index null = -1;

  std::vector<Index> m_next;          ///< per halfedge: the next one around its face, counter-clockwise
  std::vector<Index> m_target;        ///< per halfedge: the vertex it points to
  std::vector<Index> m_face;          ///< per halfedge: the face on its left
  std::vector<Index> m_face_halfedge; ///< per face: one of its halfedges
  Index m_number_of_vertices = 0;

  Index next(const Index h) const { return m_next[h]; }
  Index previous(const Index h) const { return m_next[m_next[h]]; }
  Index target(const Index h) const { return m_target[h]; }
  Index source(const Index h) const { return m_target[opposite(h)]; }
  Index face(const Index h) const { return m_face[h]; }
  Index halfedge_of_face(const Index f) const { return m_face_halfedge[f]; }

  /// The next halfedge with the same source, counter-clockwise. \pre `h` has a face.
  Index next_around_source(const Index h) const { return opposite(previous(h)); }

  /// calls `function(g)` for each halfedge with the source of `h`, which may be on the border: for `h` and what follows
  /// counter-clockwise, and for what is clockwise of `h` up to a border.
  template <typename Function>
  void for_each_around_source(const Index h, const Function& function) const
  {
    Index g = h;
    for (;;) {
      function(g);
      if (face(g) == null)
        break;
      g = next_around_source(g);
      if (g == h)
        return;
    }
    for (g = opposite(h); face(g) != null; g = opposite(next(g)))
      function(next(g));
  }

  Index number_of_vertices() const { return m_number_of_vertices; }
  Index number_of_halfedges() const { return static_cast<Index>(m_next.size()); }
  Index number_of_edges() const { return number_of_halfedges() / 2; }
  Index number_of_faces() const { return static_cast<Index>(m_face_halfedge.size()); }

  /// One outgoing halfedge per vertex; `null` for isolated vertices.
  std::vector<Index> outgoing_halfedges() const
  {
    std::vector<Index> outgoing(m_number_of_vertices, null);
    for (Index h = number_of_halfedges() - 1; h >= 0; --h)
      outgoing[source(h)] = h;
    return outgoing;
  }

  /// Replaces the edge of `h` by the other diagonal of the quadrilateral of its two triangles.
  ///
  /// Afterwards `h` points from the apex of the triangle that was on its right to the apex of the one on its left:
  /// it has been turned counter-clockwise. \pre The two triangles are different faces.
  void flip(const Index h)
  {
    const Index g = opposite(h);
    const Index h1 = m_next[h], h2 = m_next[h1], g1 = m_next[g], g2 = m_next[g1];
    const Index f = m_face[h], k = m_face[g];
    CGAL_precondition(f != k);
    m_target[h] = m_target[h1];
    m_target[g] = m_target[g1];
    m_next[h] = h2;
    m_next[h2] = g1;
    m_next[g1] = h;
    m_next[g] = g2;
    m_next[g2] = h1;
    m_next[h1] = g;
    m_face[g1] = f;
    m_face[h1] = k;
    m_face_halfedge[f] = h;
    m_face_halfedge[k] = g;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_TRIANGULATION_CONNECTIVITY_H
