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
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Takes from the refinement of a double what belongs to the first sheet: the refinement of the mesh with border.
///
/// The order of what is kept is kept. The vertices of the mesh are the first ones of the refinement, those of the second
/// sheet come next.
class First_sheet {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  First_sheet(const Metric_input& input, const Refined_triangulation& both, const std::vector<char>& is_cut)
    : m_both(both),
      m_new_vertex(both.mesh.number_of_vertices(), null),
      m_new_edge(both.mesh.number_of_edges(), null),
      m_new_face(both.mesh.number_of_faces(), null)
  {
    number_elements(input);
    copy_vertices();
    copy_halfedges(is_cut);
    copy_faces();
    close_border();
  }

  Refined_triangulation& refined() { return m_sheet; }
  std::vector<char>& cut_edges() { return m_is_cut; }

private:
  Index new_halfedge(const Index h) const { return halfedges_of_edge(m_new_edge[edge_of(h)])[side_of_edge(h)]; }

  void number_elements(const Metric_input& input)
  {
    std::vector<char> is_used(m_both.mesh.number_of_vertices(), 0);
    Index faces = 0, edges = 0, vertices = 0;
    for (Index f = 0; f < m_both.mesh.number_of_faces(); ++f)
      if (m_both.input_face[f] < input.number_of_faces)
        m_new_face[f] = faces++;
    for (Index e = 0; e < m_both.mesh.number_of_edges(); ++e) {
      const auto [h, g] = halfedges_of_edge(e);
      if (m_new_face[m_both.mesh.face(h)] == null && m_new_face[m_both.mesh.face(g)] == null)
        continue;
      m_new_edge[e] = edges++;
      is_used[m_both.mesh.target(h)] = is_used[m_both.mesh.target(g)] = 1;
    }
    for (Index v = 0; v < m_both.mesh.number_of_vertices(); ++v)
      if (is_used[v] || v < input.number_of_vertices)
        m_new_vertex[v] = vertices++;
    m_sheet.mesh.m_number_of_vertices = vertices;
    m_sheet.mesh.m_face_halfedge.resize(faces);
    m_sheet.mesh.m_next.assign(2 * static_cast<std::size_t>(edges), null);
    m_sheet.mesh.m_target.assign(2 * static_cast<std::size_t>(edges), null);
    m_sheet.mesh.m_face.assign(2 * static_cast<std::size_t>(edges), null);
  }

  void copy_vertices()
  {
    for (Index v = 0; v < m_both.mesh.number_of_vertices(); ++v)
      if (m_new_vertex[v] != null) {
        m_sheet.point.push_back(m_both.point[v]);
        m_sheet.place.push_back(m_both.place[v]);
      }
  }

  void copy_halfedges(const std::vector<char>& is_cut)
  {
    for (Index e = 0; e < m_both.mesh.number_of_edges(); ++e) {
      if (m_new_edge[e] == null)
        continue;
      bool is_inner = true;
      for (const Index h : halfedges_of_edge(e)) {
        const Index f = m_new_face[m_both.mesh.face(h)], k = new_halfedge(h);
        is_inner = is_inner && f != null;
        m_sheet.mesh.m_target[k] = m_new_vertex[m_both.mesh.target(h)];
        m_sheet.mesh.m_face[k] = f;
        if (f != null)
          m_sheet.mesh.m_next[k] = new_halfedge(m_both.mesh.next(h));
        m_sheet.uv.push_back(f != null ? m_both.uv[h] : std::array<double, 2>{{0, 0}});
        m_sheet.input_halfedge.push_back(m_both.input_halfedge[h]);
        m_sheet.final_halfedge.push_back(m_both.final_halfedge[h]);
      }
      m_is_cut.push_back(is_inner && is_cut[e]);
    }
  }

  void copy_faces()
  {
    for (Index f = 0; f < m_both.mesh.number_of_faces(); ++f)
      if (m_new_face[f] != null) {
        m_sheet.mesh.m_face_halfedge[m_new_face[f]] = new_halfedge(m_both.mesh.halfedge_of_face(f));
        m_sheet.input_face.push_back(m_both.input_face[f]);
      }
  }

  void close_border()
  {
    Triangulation_connectivity& mesh = m_sheet.mesh;
    std::vector<Index> leaving(mesh.number_of_vertices(), null); // the border halfedge with this source
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == null)
        leaving[mesh.source(h)] = h;
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == null)
        mesh.m_next[h] = leaving[mesh.target(h)];
  }

  const Refined_triangulation& m_both;
  std::vector<Index> m_new_vertex, m_new_edge, m_new_face; // `null` for what is on the second sheet
  Refined_triangulation m_sheet;
  std::vector<char> m_is_cut;
};

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
