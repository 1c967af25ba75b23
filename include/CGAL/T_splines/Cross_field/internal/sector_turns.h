// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SECTOR_TURNS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SECTOR_TURNS_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_sectors.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// writes the quarter turns of sectors to the halfedges that they begin with, and 0 to all others.
/// \param turns per sector
template <typename TriangleMesh, typename HalfedgeTurnsMap>
void put_sector_turns(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& mesh,
                      const Vertex_sectors& sectors, const std::vector<int>& turns, const HalfedgeTurnsMap& map)
{
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    put(map, indexing.halfedge(h),
        mesh.face(h) != Triangulation_connectivity::null && sectors.is_bound(h) ? turns[sectors.sector(h)] : 0);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SECTOR_TURNS_H
