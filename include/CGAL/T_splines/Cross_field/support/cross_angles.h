// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_CROSS_ANGLES_H
#define CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_CROSS_ANGLES_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// projects a vector to a face: its coordinates in the frame of the face, in units of its largest coordinate, so that
/// nothing overflows. \return `false` if it is zero or not finite.
template <typename Vector>
bool project_to_face(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry, const int f,
                     const Vector& vector, double& x, double& y, double& normal)
{
  using Vector_3 = Triangle_geometry::Vector_3;
  const double a = CGAL::to_double(vector.x()), b = CGAL::to_double(vector.y()), c = CGAL::to_double(vector.z());
  const double largest = (std::max)({std::abs(a), std::abs(b), std::abs(c)});
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c) || largest == 0)
    return false;
  const Vector_3 scaled(a / largest, b / largest, c / largest);
  x = scaled * geometry.x_axis(mesh, f);
  y = scaled * geometry.y_axis(mesh, f);
  normal = scaled * geometry.m_normal[f];
  return true;
}

/// computes the angle of a direction field in the frame of each face.
/// \return the first face where the field has no direction, or `Triangulation_connectivity::null`.
template <typename FaceGraph, typename CrossFieldMap>
int cross_angles(const Mesh_indexing<FaceGraph>& indexing, const Triangulation_connectivity& mesh,
                 const Triangle_geometry& geometry, const CrossFieldMap& cross_field, std::vector<double>& angle)
{
  // A vector that is so close to the normal has its direction in the face from round-off.
  constexpr double smallest_tangent = 1e-6;
  angle.resize(mesh.number_of_faces());
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    double x = 0, y = 0, normal = 0;
    if (!project_to_face(mesh, geometry, f, get(cross_field, indexing.face(f)), x, y, normal) ||
        x * x + y * y < smallest_tangent * smallest_tangent)
      return f;
    angle[f] = std::atan2(y, x);
  }
  return Triangulation_connectivity::null;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_SUPPORT_CROSS_ANGLES_H
