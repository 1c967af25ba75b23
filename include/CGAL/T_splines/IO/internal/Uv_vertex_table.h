// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_UV_VERTEX_TABLE_H
#define CGAL_T_SPLINES_IO_INTERNAL_UV_VERTEX_TABLE_H

#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_basic.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The distinct pairs of a vertex and one of its uv, numbered vertex by vertex: the vertices of the surface after it has
/// been cut open along its seams.
class Uv_vertex_table {
public:
  template <typename FaceGraph, typename HalfedgeUVMap>
  Uv_vertex_table(const Mesh_indexing<FaceGraph>& indexing, const HalfedgeUVMap uv_map)
    : m_uv_vertex_of_halfedge(indexing.number_of_halfedges(), 0)
  {
    const FaceGraph& mesh = indexing.graph();
    for (int v = 0; v < indexing.number_of_vertices(); ++v) {
      const std::size_t first = m_uvs.size();
      const auto start = halfedge(indexing.vertex(v), mesh);
      if (start == boost::graph_traits<FaceGraph>::null_halfedge())
        continue;
      for (const auto h : CGAL::halfedges_around_target(start, mesh)) {
        if (is_border(h, mesh))
          continue;
        const auto& point = get(uv_map, h);
        const std::array<double, 2> uv = {CGAL::to_double(point.x()), CGAL::to_double(point.y())};
        std::size_t i = first;
        while (i < m_uvs.size() && m_uvs[i] != uv)
          ++i;
        if (i == m_uvs.size()) {
          m_uvs.push_back(uv);
          m_vertices.push_back(v);
        }
        m_uv_vertex_of_halfedge[indexing.halfedge_index(h)] = i;
      }
    }
  }

  std::size_t size() const { return m_uvs.size(); }
  const std::array<double, 2>& uv(const std::size_t i) const { return m_uvs[i]; }
  int vertex(const std::size_t i) const { return m_vertices[i]; }

  /// The pair at the target of a halfedge (index) on its face.
  std::size_t of_halfedge(const int h) const { return m_uv_vertex_of_halfedge[h]; }

private:
  std::vector<std::array<double, 2>> m_uvs;
  std::vector<int> m_vertices;
  std::vector<std::size_t> m_uv_vertex_of_halfedge;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_UV_VERTEX_TABLE_H
