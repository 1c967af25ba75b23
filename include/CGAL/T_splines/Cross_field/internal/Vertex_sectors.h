// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_VERTEX_SECTORS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_VERTEX_SECTORS_H

#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The sectors into which bounding edges divide the angles around the vertices of a triangulation. Edges on the border
/// bound in any case.
///
/// They are numbered in the order of their vertices. A vertex without bounding edges has one sector, all around. One with
/// a single bounding edge has one sector from this edge to itself.
class Vertex_sectors {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// \param is_bound per edge; empty if only the border bounds
  Vertex_sectors(const Triangulation_connectivity& mesh, const std::vector<char>& is_bound)
    : m_mesh(mesh),
      m_is_bound(is_bound),
      m_sector(mesh.number_of_halfedges(), null)
  {
    m_is_bound.resize(mesh.number_of_edges(), 0);
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == null)
        m_is_bound[edge_of(h)] = 1;
    const std::vector<Index> outgoing = mesh.outgoing_halfedges();
    for (Index v = 0; v < mesh.number_of_vertices(); ++v)
      if (outgoing[v] != null) {
        const std::size_t number_before = m_first.size();
        mesh.for_each_around_source(outgoing[v], [this](const Index h) {
          if (m_is_bound[edge_of(h)] && mesh_has_face(h))
            add_sector(h, true);
        });
        if (m_first.size() == number_before)
          add_sector(outgoing[v], false);
      }
  }

  int size() const { return static_cast<int>(m_first.size()); }
  int vertex(const int s) const { return m_mesh.source(m_first[s]); }
  bool is_bound(const int h) const { return m_is_bound[edge_of(h)] != 0; }

  /// The sector that begins at the halfedge `h` of a bounding edge, counter-clockwise of it, or that `h` lies in. `null` if
  /// `h` has no face.
  int sector(const int h) const { return m_sector[h]; }

  /// Whether a sector is not all there is around its vertex, or ends where it begins.
  bool has_bounds(const int s) const { return m_has_bounds[s] != 0; }

  /// Whether a sector begins and ends at the border.
  bool is_between_borders(const int s) const
  {
    return !mesh_has_face(opposite(m_first[s])) && !mesh_has_face(m_last[s]);
  }

  /// The halfedge that a sector begins with.
  int first(const int s) const { return m_first[s]; }

  /// The halfedge that a sector ends at; it may be the first one.
  int last(const int s) const { return m_last[s]; }

  /// calls `function(h)` for the halfedges from the vertex of a sector, counter-clockwise: the first one, those inside,
  /// and, of a sector with bounds, the last one.
  template <typename Function>
  void for_each_halfedge(const int s, const Function& function) const
  {
    Index h = m_first[s];
    do {
      function(h);
      h = m_mesh.next_around_source(h);
    } while (h != m_last[s]);
    if (has_bounds(s) && m_last[s] != m_first[s])
      function(h);
  }

  /// The sector at the other end of a halfedge of sector `s`, on the same side of it if it bounds.
  int sector_across(const int s, const int h) const
  {
    return has_bounds(s) && h == m_first[s] ? m_sector[m_mesh.next(h)] : m_sector[opposite(h)];
  }

  /// The angle of each sector, of the surface.
  std::vector<double> angles(const std::vector<double>& corner_angle) const
  {
    std::vector<double> result(m_first.size(), 0.);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (mesh_has_face(h))
        result[m_sector[h]] += corner_angle[m_mesh.previous(h)];
    return result;
  }

  /// How many quarter turns a field makes in each sector relative to the surface: an integer up to round-off, if it follows the
  /// bounding edges.
  /// \param rotation, border_cross as in `vertex_quarter_turns()`, of which these are parts
  std::vector<double> quarter_turns(const std::vector<double>& corner_angle, const std::vector<double>& rotation,
                                    const std::vector<double>& border_cross) const
  {
    std::vector<double> result = angles(corner_angle);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if (!mesh_has_face(h))
        continue;
      if (!is_bound(h))
        result[m_sector[h]] -= rotation_into(rotation, h);
      else if (!mesh_has_face(opposite(h))) {
        result[m_sector[h]] -= border_cross[edge_of(h)];
        result[m_sector[m_mesh.next(h)]] += border_cross[edge_of(h)];
      }
    }
    for (double& turns : result)
      turns /= quarter_turn;
    return result;
  }

private:
  bool mesh_has_face(const Index h) const { return m_mesh.face(h) != null; }

  void add_sector(const Index first, const bool has_bounds)
  {
    const int s = size();
    m_first.push_back(first);
    m_has_bounds.push_back(has_bounds ? 1 : 0);
    Index h = first;
    do {
      m_sector[h] = s;
      h = m_mesh.next_around_source(h);
    } while (h != first && !m_is_bound[edge_of(h)]);
    m_last.push_back(h);
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<char> m_is_bound; // per edge
  std::vector<int> m_sector;    // per halfedge
  std::vector<Index> m_first, m_last;
  std::vector<char> m_has_bounds;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_VERTEX_SECTORS_H
