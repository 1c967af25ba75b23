// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MAP_ARRAYS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MAP_ARRAYS_H

#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_basic.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The coordinates of a map, in doubles; 0 at border halfedges.
template <typename TriangleMesh, typename HalfedgeUVMap>
Uv_array uv_array(const Mesh_indexing<TriangleMesh>& indexing, const HalfedgeUVMap uv_map)
{
  Uv_array result(indexing.number_of_halfedges(), {{0, 0}});
  for (int i = 0; i < indexing.number_of_halfedges(); ++i) {
    if (is_border(indexing.halfedge(i), indexing.graph()))
      continue;
    const auto& p = get(uv_map, indexing.halfedge(i));
    result[i] = {{CGAL::to_double(p.x()), CGAL::to_double(p.y())}};
  }
  return result;
}

/// Per edge, or empty if the parameter is not given.
template <typename TriangleMesh, typename EdgeIsConstrainedMap>
std::vector<char> constrained_edges(const Mesh_indexing<TriangleMesh>& indexing,
                                    const EdgeIsConstrainedMap& edge_is_constrained_map)
{
  std::vector<char> result;
  if constexpr (!is_missing<EdgeIsConstrainedMap>)
    for (int e = 0; 2 * e < indexing.number_of_halfedges(); ++e)
      result.push_back(
          get(edge_is_constrained_map, edge(indexing.halfedge(halfedge_of_edge(e)), indexing.graph())) ? 1 : 0);
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MAP_ARRAYS_H
