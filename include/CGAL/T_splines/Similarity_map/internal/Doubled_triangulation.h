// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DOUBLED_TRIANGULATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DOUBLED_TRIANGULATION_H

#include <CGAL/T_splines/Similarity_map/internal/Mirror_pairs.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A triangulation and the mirror images of its components with border, glued to them along the border: a closed
/// triangulation. Components without border are taken once.
///
/// The elements of the triangulation keep their numbers; those of the second sheet come after them. What is symmetric
/// on the double stays so: a metric that is determined by numbers that the reflection respects has straight borders.
class Doubled_triangulation {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  Doubled_triangulation(const Triangulation_connectivity& mesh, const Mesh_components& components)
    : m_mesh(mesh),
      m_mirrored_vertex(mesh.number_of_vertices(), null),
      m_mirrored_edge(mesh.number_of_edges(), null),
      m_mirrored_face(mesh.number_of_faces(), null)
  {
    number_second_sheet(components);
    connect_second_sheet();
  }

  const Triangulation_connectivity& closed() const { return m_closed; }

  /// Per vertex of the second sheet, the one that it is the image of.
  const std::vector<Index>& originals() const { return m_original; }

  /// The faces that are images of each other.
  Mirror_pairs pairs() const
  {
    std::vector<Index> image_of_face(m_closed.number_of_faces(), null), image_of_edge(m_closed.number_of_edges(), null);
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (m_mirrored_face[f] != null) {
        image_of_face[f] = m_mirrored_face[f];
        image_of_face[m_mirrored_face[f]] = f;
      }
    for (Index e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_mirrored_edge[e] != null) {
        const Index h = halfedge_of_edge(e), g = mirrored_halfedge(h);
        image_of_edge[e] = g;
        image_of_edge[edge_of(g)] = is_along_edge(g) ? h : opposite(h);
      }
    return Mirror_pairs(std::move(image_of_face), std::move(image_of_edge), m_mesh.number_of_faces());
  }

  /// The image of a closed strip of faces, which turns by the opposite angle.
  std::vector<Index> mirrored(const std::vector<Index>& strip) const
  {
    std::vector<Index> result;
    for (const Index h : strip)
      result.push_back(mirrored_halfedge(h));
    return result;
  }

  /// The loop of an arc from border to border and of its image, which turns by twice the angle of the arc.
  std::vector<Index> doubled(const std::vector<Index>& arc) const
  {
    std::vector<Index> result = arc;
    for (std::size_t i = arc.size() - 1; i-- > 1;)
      result.push_back(mirrored_halfedge(opposite(arc[i])));
    return result;
  }

private:
  Index mirrored_halfedge(const Index h) const
  {
    return halfedges_of_edge(m_mirrored_edge[edge_of(h)])[1 - side_of_edge(h)];
  }

  void number_second_sheet(const Mesh_components& components)
  {
    m_closed.m_number_of_vertices = m_mesh.number_of_vertices();
    Index edges = m_mesh.number_of_edges(), faces = m_mesh.number_of_faces();
    for (Index e = 0; e < m_mesh.number_of_edges(); ++e) {
      const auto [h, g] = halfedges_of_edge(e);
      if (!components.has_border(components.of_vertex[m_mesh.target(h)]))
        continue;
      const bool is_on_border = m_mesh.face(h) == null || m_mesh.face(g) == null;
      m_mirrored_edge[e] = is_on_border ? e : edges++;
      if (is_on_border)
        for (const Index k : {h, g})
          m_mirrored_vertex[m_mesh.target(k)] = m_mesh.target(k);
    }
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v) {
      const int c = components.of_vertex[v];
      if (c == null || !components.has_border(c) || m_mirrored_vertex[v] != null)
        continue;
      m_mirrored_vertex[v] = m_closed.m_number_of_vertices++;
      m_original.push_back(v);
    }
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (components.has_border(components.of_face[f]))
        m_mirrored_face[f] = faces++;
    m_closed.m_next.resize(2 * static_cast<std::size_t>(edges), null);
    m_closed.m_target.resize(2 * static_cast<std::size_t>(edges), null);
    m_closed.m_face.resize(2 * static_cast<std::size_t>(edges), null);
    m_closed.m_face_halfedge.resize(faces, null);
  }

  void connect_second_sheet()
  {
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      const Index f = m_mesh.face(h);
      if (f == null)
        continue;
      m_closed.m_next[h] = m_mesh.next(h);
      m_closed.m_target[h] = m_mesh.target(h);
      m_closed.m_face[h] = f;
      if (m_mirrored_face[f] == null)
        continue;
      const Index g = mirrored_halfedge(h);
      m_closed.m_next[g] = mirrored_halfedge(m_mesh.previous(h));
      m_closed.m_target[g] = m_mirrored_vertex[m_mesh.source(h)];
      m_closed.m_face[g] = m_mirrored_face[f];
    }
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f) {
      m_closed.m_face_halfedge[f] = m_mesh.halfedge_of_face(f);
      if (m_mirrored_face[f] != null)
        m_closed.m_face_halfedge[m_mirrored_face[f]] = mirrored_halfedge(m_mesh.halfedge_of_face(f));
    }
  }

  const Triangulation_connectivity& m_mesh;
  Triangulation_connectivity m_closed;
  std::vector<Index> m_mirrored_vertex, m_mirrored_edge, m_mirrored_face; // `null` in components without border
  std::vector<Index> m_original;
};

/// The strip of faces along a curve of the border, which it leaves on its right: closed, it turns as often as the
/// corners of the curve say. Faces with two edges on the border it passes by, as it would have to turn back there.
/// \param curve as of `border_curves()`
inline std::vector<int> strip_along_border(const Triangulation_connectivity& mesh, const std::vector<int>& curve)
{
  std::vector<int> strip;
  for (auto border = curve.rbegin(); border != curve.rend(); ++border)
    for (int g = opposite(mesh.next(opposite(*border))); mesh.face(g) != Triangulation_connectivity::null;
         g = opposite(mesh.next(g))) {
      if (!strip.empty() && strip.back() == opposite(g))
        strip.pop_back();
      else
        strip.push_back(g);
    }
  std::size_t begin = 0, end = strip.size();
  for (; begin + 1 < end && strip[begin] == opposite(strip[end - 1]); --end)
    ++begin;
  return std::vector<int>(strip.begin() + static_cast<std::ptrdiff_t>(begin),
                          strip.begin() + static_cast<std::ptrdiff_t>(end));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DOUBLED_TRIANGULATION_H
