// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_STRIP_TURNING_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_STRIP_TURNING_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// is true if `strip` is a closed strip of triangles as in `Holonomy_signature::Loop`: not empty, every halfedge has a face,
/// and that face is left to the next one across an edge other than the one it was entered by.
inline bool is_closed_strip(const Triangulation_connectivity& mesh, const std::vector<int>& strip)
{
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const int in = strip[i];
    const int out = opposite(strip[i + 1 < strip.size() ? i + 1 : 0]);
    if (mesh.face(in) == Triangulation_connectivity::null || mesh.face(out) != mesh.face(in) || in == out)
      return false;
  }
  return !strip.empty();
}

/// computes by how much a closed strip turns counter-clockwise in the metric of the triangles (kappa_tot of [CZ17] section
/// 2.1): the sum of the corner angles that it leaves on its left minus those that it leaves on its right.
/// \param corner_angle per halfedge: the angle of its face at its target
/// \pre `is_closed_strip(mesh, strip)`
template <typename FT>
FT strip_turning(const Triangulation_connectivity& mesh, const std::vector<int>& strip,
                 const std::vector<FT>& corner_angle)
{
  CGAL_precondition(is_closed_strip(mesh, strip));
  FT turning(0);
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const int in = strip[i];
    const int out = opposite(strip[i + 1 < strip.size() ? i + 1 : 0]);
    if (out == mesh.next(in))
      turning -= corner_angle[in]; // the strip's direction is the left normal of `in`: its target is on the right
    else
      turning += corner_angle[out];
  }
  return turning;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_STRIP_TURNING_H
