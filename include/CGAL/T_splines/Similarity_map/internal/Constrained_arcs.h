// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONSTRAINED_ARCS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONSTRAINED_ARCS_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The arcs that constrained edges make: they end where other than two constrained edges meet.
class Constrained_arcs {
  using Index = Triangulation_connectivity::Index;

public:
  static constexpr int none = -1;

  /// \param is_constrained per edge
  Constrained_arcs(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                   const std::vector<char>& is_constrained)
    : m_mesh(mesh),
      m_of_edge(mesh.number_of_edges(), none)
  {
    std::vector<std::vector<Index>> edges(mesh.number_of_vertices()); // constrained ones
    for (Index e = 0; e < mesh.number_of_edges(); ++e)
      if (is_constrained[e] != 0)
        for (const Index h : halfedges_of_edge(e))
          edges[mesh.target(h)].push_back(e);
    for (Index e = 0; e < mesh.number_of_edges(); ++e)
      if (is_constrained[e] != 0 && m_of_edge[e] == none)
        collect(e, edges, geometry);
  }

  int size() const { return static_cast<int>(m_weight.size()); }

  /// The arc of an edge, or `none`.
  int of_edge(const Index e) const { return m_of_edge[e]; }

  /// How sharp an arc is: the integral of the angle between the normals of the two sides. That of the border is infinite.
  double weight(const int arc) const { return m_weight[arc]; }

private:
  void collect(const Index first, const std::vector<std::vector<Index>>& edges, const Triangle_geometry& geometry)
  {
    std::vector<Index> queue{first};
    m_of_edge[first] = size();
    double weight = 0;
    while (!queue.empty()) {
      const Index e = queue.back();
      queue.pop_back();
      weight += geometry.m_edge_length[e] * dihedral_angle(e, geometry);
      for (const Index h : halfedges_of_edge(e)) {
        const std::vector<Index>& here = edges[m_mesh.target(h)];
        if (here.size() != 2)
          continue;
        const Index other = here[0] == e ? here[1] : here[0];
        if (m_of_edge[other] == none) {
          m_of_edge[other] = size();
          queue.push_back(other);
        }
      }
    }
    m_weight.push_back(weight);
  }

  double dihedral_angle(const Index e, const Triangle_geometry& geometry) const
  {
    const auto [h, g] = halfedges_of_edge(e);
    if (m_mesh.face(h) == m_mesh.null || m_mesh.face(g) == m_mesh.null)
      return std::numeric_limits<double>::infinity();
    const auto &m = geometry.m_normal[m_mesh.face(h)], &n = geometry.m_normal[m_mesh.face(g)];
    return std::atan2(CGAL::approximate_sqrt(CGAL::cross_product(m, n).squared_length()), m * n);
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<int> m_of_edge;   // per edge
  std::vector<double> m_weight; // per arc
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONSTRAINED_ARCS_H
