// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_WRITE_CROSS_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_WRITE_CROSS_FIELD_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_config.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// \param angle per face: of the cross in the frame of the face
template <typename TriangleMesh, typename CrossFieldMap>
void write_cross_field(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& mesh,
                       const Triangle_geometry& geometry, const std::vector<double>& angle, CrossFieldMap& cross_field)
{
  using Vector_3 = typename boost::property_traits<CrossFieldMap>::value_type;
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const Triangle_geometry::Vector_3 v =
        std::cos(angle[f]) * geometry.x_axis(mesh, f) + std::sin(angle[f]) * geometry.y_axis(mesh, f);
    put(cross_field, indexing.face(f), Vector_3(v.x(), v.y(), v.z()));
  }
}

/// The matchings, as in `holonomy_signature_of_cross_field()`, that make the given rotations.
template <typename TriangleMesh, typename MatchingMap>
void write_matchings(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& mesh,
                     const Triangle_geometry& geometry, const std::vector<double>& angle,
                     const std::vector<double>& rotation, const MatchingMap& matchings)
{
  const std::vector<double> relative = angles_to_halfedges(mesh, geometry, angle);
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    const auto [h, g] = halfedges_of_edge(e);
    int matching = 0;
    if (mesh.face(h) != Triangulation_connectivity::null && mesh.face(g) != Triangulation_connectivity::null)
      matching = static_cast<int>(std::lround((rotation[e] - relative[h] + relative[g] + CGAL_PI) / quarter_turn));
    put(matchings, indexing.halfedge(h), (matching % 4 + 4) % 4);
    put(matchings, indexing.halfedge(g), (-matching % 4 + 4) % 4);
  }
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_WRITE_CROSS_FIELD_H
