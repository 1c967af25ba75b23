// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_FIELD_ROTATIONS_H
#define CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_FIELD_ROTATIONS_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

constexpr double quarter_turn = CGAL_PI / 2;

/// The angles of a field, given in the frame of each face, relative to the direction of each halfedge in its face.
inline std::vector<double> angles_to_halfedges(const Triangulation_connectivity& mesh,
                                               const Triangle_geometry& geometry,
                                               const std::vector<double>& angle_in_face)
{
  std::vector<double> result(mesh.number_of_halfedges(), 0.);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) != Triangulation_connectivity::null)
      result[h] = angle_in_face[mesh.face(h)] - geometry.direction(mesh, h);
  return result;
}

/// The angle in [-pi/4, pi/4], per edge, by which the cross in the face of the even halfedge differs from the one
/// transported there across the edge, matched by the closest rotation. The odd halfedge has the negative angle.
/// \param angle per halfedge: of the cross relative to the halfedge; multiples of pi/2 do not matter
inline std::vector<double> field_rotations(const Triangulation_connectivity& mesh, const std::vector<double>& angle)
{
  std::vector<double> rotation(mesh.number_of_edges(), 0.);
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    const auto [h, g] = halfedges_of_edge(e);
    if (mesh.face(h) != Triangulation_connectivity::null && mesh.face(g) != Triangulation_connectivity::null)
      rotation[e] = std::remainder(angle[h] - angle[g], quarter_turn);
  }
  return rotation;
}

/// The same, in [-pi, pi], with given matchings: per edge the number m of quarter turns such that the direction transported
/// into the face of the even halfedge is matched with the direction there turned by m pi/2.
/// \param angle per halfedge: of *the* direction of its face; multiples of 2 pi do not matter
inline std::vector<double> field_rotations(const Triangulation_connectivity& mesh, const std::vector<double>& angle,
                                           const std::vector<int>& matching)
{
  std::vector<double> rotation(mesh.number_of_edges(), 0.);
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    const auto [h, g] = halfedges_of_edge(e);
    if (mesh.face(h) == Triangulation_connectivity::null || mesh.face(g) == Triangulation_connectivity::null)
      continue;
    rotation[e] = std::remainder(angle[h] + matching[e] * quarter_turn - angle[g] - CGAL_PI, 2 * CGAL_PI);
  }
  return rotation;
}

/// The rotation of the field on entering the face of `h`.
inline double rotation_into(const std::vector<double>& rotation, const int h)
{
  return is_along_edge(h) ? rotation[edge_of(h)] : -rotation[edge_of(h)];
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_FIELD_ROTATIONS_H
