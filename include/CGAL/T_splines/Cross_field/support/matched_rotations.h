// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_MATCHED_ROTATIONS_H
#define CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_MATCHED_ROTATIONS_H

#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The rotation of a field across each edge: by the matchings among the named parameters, or else the closest one.
/// \param angle per halfedge: of the direction of the field in its face, relative to the halfedge
template <typename FaceGraph, typename NamedParameters>
std::vector<double> matched_rotations(const Mesh_indexing<FaceGraph>& indexing, const Triangulation_connectivity& mesh,
                                      const std::vector<double>& angle, const NamedParameters& np)
{
  const auto matching_map = CGAL::parameters::get_parameter(np, np_tags::halfedge_matching_map);
  if constexpr (is_missing<decltype(matching_map)>)
    return field_rotations(mesh, angle);
  else {
    std::vector<int> matching;
    matching.reserve(mesh.number_of_edges());
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      matching.push_back(static_cast<int>(get(matching_map, indexing.halfedge(halfedge_of_edge(e)))));
    return field_rotations(mesh, angle, matching);
  }
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_MATCHED_ROTATIONS_H
