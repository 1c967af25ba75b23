// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_MAP_H

#include <CGAL/T_splines/Similarity_map/internal/Border_lines.h>
#include <CGAL/T_splines/Similarity_map/internal/Branch_fit.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A map up to round-off, its cut and what was read off from it: what the exact coordinates are computed from.
struct Cut_map {
  using Index = Triangulation_connectivity::Index;
  static constexpr int none = -1;

  const Triangulation_connectivity& mesh;
  const Uv_array& uv;
  const std::vector<char>& is_cut; ///< per edge
  const Cut_sectors& sectors;
  const Border_lines& border;
  const Cut_graph& graph;
  const std::vector<Branch_fit>& fits;   ///< per branch
  const std::vector<int>& quarter_turns; ///< per cut vertex
  double size;                           ///< the largest coordinate

  /// Calls `visit(h)` for the halfedges that point to the `i`-th cut vertex inside its `k`-th sector.
  template <typename Visit>
  void for_each_corner(const int i, const int k, const Visit& visit) const
  {
    Cut_sectors::for_each_corner(mesh, is_cut, sectors.halfedge[sectors.first_sector[i] + k], visit);
  }

  /// The entry of a vertex in the list of cut vertices, or none.
  int entry_of_vertex(const Index v) const
  {
    const auto place = std::lower_bound(sectors.vertices.begin(), sectors.vertices.end(), v);
    return place == sectors.vertices.end() || *place != v ? none : static_cast<int>(place - sectors.vertices.begin());
  }

  /// The sector, of those of the `i`-th cut vertex, of a halfedge that points to the vertex.
  int sector_of_corner(const int i, const Index corner) const
  {
    Index h = mesh.next(corner); // clockwise to the first halfedge of the sector
    while (!is_cut[edge_of(h)] && mesh.face(opposite(h)) != mesh.null)
      h = mesh.next(opposite(h));
    const auto first = sectors.halfedge.begin() + sectors.first_sector[i];
    return static_cast<int>(std::find(first, first + sectors.number_of_sectors(i), h) - first);
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_MAP_H
