// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIRST_SHEET_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIRST_SHEET_H

#include <CGAL/T_splines/Similarity_map/internal/Metric_input.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// completes the refinement of the first sheet of a double to that of the mesh with border: the vertices of the second
/// sheet are taken out, the border is connected and not cut.
///
/// The order of what is kept is kept. The vertices of the mesh are the first ones of the refinement, those of the second
/// sheet come next.
inline void complete_first_sheet(const Metric_input& input, Refined_triangulation& refined, std::vector<char>& is_cut)
{
  using Index = Triangulation_connectivity::Index;
  constexpr Index null = Triangulation_connectivity::null;
  Triangulation_connectivity& mesh = refined.mesh;
  std::vector<Index> new_vertex(mesh.number_of_vertices(), null);
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    new_vertex[mesh.target(h)] = 0; // in use
  Index vertices = 0;
  for (Index v = 0; v < mesh.number_of_vertices(); ++v)
    if (new_vertex[v] != null || v < input.number_of_vertices) {
      refined.point[vertices] = refined.point[v];
      refined.place[vertices] = refined.place[v];
      new_vertex[v] = vertices++;
    }
  refined.point.resize(vertices);
  refined.place.resize(vertices);
  mesh.m_number_of_vertices = vertices;
  for (Index& v : mesh.m_target)
    v = new_vertex[v];
  std::vector<Index> leaving(vertices, null); // the border halfedge with this source
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) == null) {
      leaving[mesh.source(h)] = h;
      is_cut[edge_of(h)] = 0;
    }
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) == null)
      mesh.m_next[h] = leaving[mesh.target(h)];
}

/// Turns the charts of each component such that its border becomes parallel to the axes.
class Border_alignment {
public:
  /// \param refined its border is straight between corners that turn by quarter turns
  explicit Border_alignment(Refined_triangulation& refined) : m_component(mesh_components(refined.mesh).of_vertex)
  {
    const Triangulation_connectivity& mesh = refined.mesh;
    for (const int c : m_component)
      if (c >= static_cast<int>(m_turn.size()))
        m_turn.resize(static_cast<std::size_t>(c) + 1, {0., 0.});
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) != mesh.null && mesh.face(opposite(h)) == mesh.null) {
        const std::array<double, 2>&p = refined.uv[mesh.previous(h)], &q = refined.uv[h];
        const std::complex<double> side(q[0] - p[0], q[1] - p[1]);
        m_turn[m_component[mesh.target(h)]] += std::polar(std::abs(side), 4 * std::arg(side));
      }
    for (std::complex<double>& turn : m_turn)
      turn = std::polar(1., -std::arg(turn) / 4); // 1 where there is no border
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      refined.uv[h] = turned(refined.uv[h], mesh.target(h));
  }

  /// \param v a vertex, for its component
  std::array<double, 2> turned(const std::array<double, 2>& p, const int v) const
  {
    const std::complex<double> q = m_turn[m_component[v]] * std::complex<double>(p[0], p[1]);
    return {{q.real(), q.imag()}};
  }

private:
  std::vector<int> m_component; // per vertex
  std::vector<std::complex<double>> m_turn;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FIRST_SHEET_H
