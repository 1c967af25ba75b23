// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_OPEN_VERTICES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_OPEN_VERTICES_H

#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The vertices of a mesh that is cut open: one per vertex off the cut, one per sector of a vertex on it. Each has its own
/// coordinates, the unknowns `2 v` and `2 v + 1` of what varies a map.
class Open_vertices {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param is_cut per edge
  Open_vertices(const Triangulation_connectivity& mesh, const std::vector<char>& is_cut, const Cut_sectors& sectors)
    : m_of_corner(mesh.number_of_halfedges(), none)
  {
    for (const Index sector : sectors.halfedge) {
      Cut_sectors::for_each_corner(mesh, is_cut, sector, [this](const Index h) { m_of_corner[h] = m_number; });
      ++m_number;
    }
    std::vector<int> of_vertex(mesh.number_of_vertices(), none);
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      if (mesh.face(h) == mesh.null || m_of_corner[h] != none)
        continue;
      int& vertex = of_vertex[mesh.target(h)];
      if (vertex == none)
        vertex = m_number++;
      m_of_corner[h] = vertex;
    }
  }

  int number() const { return m_number; }
  int number_of_unknowns() const { return 2 * m_number; }

  /// The vertex that the halfedge `h` points to in the chart of its face. \pre `h` is an inner halfedge
  int operator[](const Index h) const { return m_of_corner[h]; }

  /// The coordinates of a map, one after the other.
  std::vector<double> coordinates(const Uv_array& uv) const
  {
    std::vector<double> x(number_of_unknowns(), 0.);
    for (std::size_t h = 0; h < uv.size(); ++h)
      if (m_of_corner[h] != none)
        for (int axis = 0; axis < 2; ++axis)
          x[2 * m_of_corner[h] + axis] = uv[h][axis];
    return x;
  }

  /// The reverse: writes the coordinates of corners.
  void write(const std::vector<double>& x, Uv_array& uv) const
  {
    for (std::size_t h = 0; h < uv.size(); ++h)
      if (m_of_corner[h] != none)
        uv[h] = {{x[2 * m_of_corner[h]], x[2 * m_of_corner[h] + 1]}};
  }

private:
  static constexpr int none = -1;

  int m_number = 0;
  std::vector<int> m_of_corner; // per halfedge
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_OPEN_VERTICES_H
