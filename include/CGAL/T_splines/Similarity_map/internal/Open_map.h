// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_OPEN_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_OPEN_MAP_H

#include <CGAL/T_splines/Similarity_map/internal/Border_lines.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_forest.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_arcs.h>
#include <CGAL/T_splines/Similarity_map/internal/Open_vertices.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A map that is seamless up to round-off, as a map of the mesh that is cut open along its seams, and the similarities of
/// these.
class Open_map {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param uv per halfedge the corner at its target; sides of seams that differ by rounding alone are welded
  /// \param tolerance by the largest coordinate
  Open_map(Triangulation_connectivity mesh, Uv_array uv, const double tolerance)
    : m_mesh(std::move(mesh)),
      m_uv(std::move(uv)),
      m_seams(m_mesh, m_uv, tolerance),
      m_sectors(m_mesh, m_seams.cut_edges()),
      m_border(m_mesh, m_uv, m_sectors, Isoline_arcs(m_mesh, m_uv, {})),
      m_graph(m_mesh, m_sectors, nodes(), m_border.loops()),
      m_open(m_mesh, m_seams.cut_edges(), m_sectors)
  {
    for (int b = 0; b < m_graph.number_of_branches(); ++b)
      m_fits.emplace_back(m_mesh, m_uv, m_graph, b);
  }
  Open_map(const Open_map&) = delete; // parts refer to each other
  Open_map& operator=(const Open_map&) = delete;

  const Triangulation_connectivity& mesh() const { return m_mesh; }
  const Uv_array& uv() const { return m_uv; }
  const Cut_graph& graph() const { return m_graph; }
  const Open_vertices& open() const { return m_open; }
  /// The similarity of each branch.
  const std::vector<Branch_fit>& fits() const { return m_fits; }

  /// The halfedge of a seam that is farthest from its similarity, and by how much, relative to the coordinates.
  std::pair<Index, double> worst_fit() const
  {
    std::pair<Index, double> worst{m_mesh.null, 0};
    for (const Branch_fit& fit : m_fits)
      if (!(fit.deviation() <= worst.second))
        worst = {fit.worst_halfedge(), fit.deviation()};
    return worst;
  }

  /// Scale factors of the branches that are powers of two and multiply to 1 around all nodes, next to those of the map.
  std::vector<double> dyadic_scales() const
  {
    std::vector<char> is_ground(m_graph.number_of_nodes(), 0);
    for (std::size_t loop = 0; loop < m_border.loops().size(); ++loop)
      is_ground[loop] = 1;
    std::vector<double> uncertainty, exponent;
    for (const Branch_fit& fit : m_fits) {
      uncertainty.push_back(std::abs(std::log(fit.scale()))); // scales near 1 stay outside the forest
      exponent.push_back(std::round(std::log2(fit.scale())));
    }
    const Cut_forest forest(m_graph, is_ground, uncertainty);
    for (auto node = forest.order().rbegin(); node != forest.order().rend(); ++node) {
      const int parent = forest.parent_branch(*node);
      if (parent == Cut_forest::none)
        continue;
      double sum = 0, sign = 1;
      for (int i = 0; i < m_graph.number_of_ends(*node); ++i) {
        const Cut_graph::End& end = m_graph.end(*node, i);
        (end.branch == parent ? sign : sum) = end.branch == parent
                                                  ? (end.is_outgoing ? 1. : -1.)
                                                  : sum + (end.is_outgoing ? -1 : 1) * exponent[end.branch];
      }
      exponent[parent] = sign * sum;
    }
    std::vector<double> result;
    for (const double e : exponent)
      result.push_back(std::exp2(e));
    return result;
  }

private:
  std::vector<char> nodes() const
  {
    std::vector<char> result;
    for (int i = 0; i < m_sectors.number_of_vertices(); ++i)
      result.push_back(m_sectors.is_on_border[i] || m_sectors.degree(i) != 2 || is_cone(i));
    return result;
  }

  // Whether the angle around a cut vertex is not a full turn.
  bool is_cone(const int i) const
  {
    constexpr double clearly_less_than_quarter = 0.1;
    double angle = 0;
    for (int k = m_sectors.first_sector[i]; k < m_sectors.first_sector[i + 1]; ++k)
      Cut_sectors::for_each_corner(m_mesh, m_seams.cut_edges(), m_sectors.halfedge[k],
                                   [&](const Index h) { angle += uv_angle(m_mesh, m_uv, h); });
    return std::abs(angle / (8 * std::atan(1.)) - 1) > clearly_less_than_quarter;
  }

  Triangulation_connectivity m_mesh;
  Uv_array m_uv;
  Uv_seams m_seams;
  Cut_sectors m_sectors;
  Border_lines m_border;
  Cut_graph m_graph;
  Open_vertices m_open;
  std::vector<Branch_fit> m_fits;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_OPEN_MAP_H
