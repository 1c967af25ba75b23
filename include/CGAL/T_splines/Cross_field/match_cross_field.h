// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_MATCH_CROSS_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_MATCH_CROSS_FIELD_H

#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/write_cross_field.h>
#include <CGAL/T_splines/Cross_field/support/cross_angles.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// computes the matchings of a cross field by the closest rotation: those that `holonomy_signature_of_cross_field()` takes by
/// itself if it is given none.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `ReadablePropertyMap` from faces to three-dimensional vectors
/// \tparam HalfedgeMatchingMap a model of `WritablePropertyMap`, halfedge -> an integer
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands; it may have a border
/// \param cross_field one of the four directions of the cross in each face
/// \param matchings receives, for each halfedge, the number of quarter turns, from 0 to 3, such that the direction in the face
///   of its opposite corresponds to the one in its face turned counter-clockwise by them; 0 on the border
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return whether the field has a direction in all faces; otherwise nothing is written. Complexity: linear.
template <typename TriangleMesh, typename CrossFieldMap, typename HalfedgeMatchingMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool match_cross_field(const TriangleMesh& mesh, const CrossFieldMap& cross_field, HalfedgeMatchingMap matchings,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  std::vector<double> angle;
  if (internal::cross_angles(domain.m_indexing, domain.m_connectivity, domain.m_geometry, cross_field, angle) !=
      internal::Triangulation_connectivity::null)
    return false;
  const std::vector<double> rotation = internal::field_rotations(
      domain.m_connectivity, internal::angles_to_halfedges(domain.m_connectivity, domain.m_geometry, angle));
  internal::write_matchings(domain.m_indexing, domain.m_connectivity, domain.m_geometry, angle, rotation, matchings);
  return true;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_MATCH_CROSS_FIELD_H
