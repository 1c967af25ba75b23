// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_PRINCIPAL_CROSSES_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_PRINCIPAL_CROSSES_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_frames.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// computes, per vertex and in its frame, the cross of the principal curvature directions as a fourth power.
///
/// The tensor is that of Cohen-Steiner and Morvan (Restricted Delaunay triangulations and normal cycle, 2003), summed over
/// the edges of the vertex. Its deviator is a complex number of twice the angle; the cross has twice that, and the length of
/// the deviator, which is the difference of the principal curvatures: where they agree, there is no direction.
/// \param frames of the triangulation `mesh` itself
inline std::vector<std::complex<double>> principal_crosses(const Triangulation_connectivity& mesh,
                                                           const Triangle_geometry& geometry,
                                                           const Vertex_frames& frames)
{
  std::vector<double> area(mesh.number_of_vertices(), 0.);
  std::vector<std::complex<double>> crosses(mesh.number_of_vertices());
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    const double bend = 0.5 * dihedral_angle(mesh, geometry, edge_of(h)) * geometry.m_edge_length[edge_of(h)];
    crosses[mesh.source(h)] += bend * std::polar(1., 2 * frames.direction(h));
    if (mesh.face(h) != Triangulation_connectivity::null)
      area[mesh.target(h)] += geometry.m_area[mesh.face(h)] / 3;
  }
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    const double length = std::abs(crosses[v]);
    if (length > 0)
      crosses[v] *= crosses[v] / (length * area[v]);
  }
  return crosses;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_PRINCIPAL_CROSSES_H
