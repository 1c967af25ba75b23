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

/// whether a strip may go on from the halfedge by which it entered a face to the one by which it enters the next: the face
/// is left across an edge other than the one it was entered by.
inline bool is_step_of_strip(const Triangulation_connectivity& mesh, const int in, const int next_in)
{
  const int out = opposite(next_in);
  return mesh.face(in) != Triangulation_connectivity::null && mesh.face(out) == mesh.face(in) && in != out;
}

/// whether `strip` is a closed strip of triangles as in `Holonomy_signature::Loop`.
inline bool is_closed_strip(const Triangulation_connectivity& mesh, const std::vector<int>& strip)
{
  for (std::size_t i = 0; i < strip.size(); ++i)
    if (!is_step_of_strip(mesh, strip[i], strip[i + 1 < strip.size() ? i + 1 : 0]))
      return false;
  return !strip.empty();
}

/// whether `strip` is a strip of triangles from border to border as in `Holonomy_signature::Arc`.
inline bool is_strip_across(const Triangulation_connectivity& mesh, const std::vector<int>& strip)
{
  constexpr int null = Triangulation_connectivity::null;
  for (std::size_t i = 0; i + 1 < strip.size(); ++i)
    if (!is_step_of_strip(mesh, strip[i], strip[i + 1]))
      return false;
  return strip.size() > 1 && mesh.face(opposite(strip.front())) == null && mesh.face(strip.back()) == null;
}

/// By how much a strip turns counter-clockwise in a face: it leaves a corner angle on its left, or one on its right.
template <typename FT>
FT turning_in_face(const Triangulation_connectivity& mesh, const int in, const int next_in,
                   const std::vector<FT>& corner_angle)
{
  const int out = opposite(next_in);
  // The strip's direction is the left normal of `in`, whose target is on the right.
  return out == mesh.next(in) ? FT(-corner_angle[in]) : corner_angle[out];
}

/// computes by how much a strip turns counter-clockwise in the metric of the triangles (kappa_tot of [CZ17] section
/// 2.1): the sum of the corner angles that it leaves on its left minus those that it leaves on its right.
/// \param corner_angle per halfedge: the angle of its face at its target
/// \pre `is_closed_strip(mesh, strip)` or `is_strip_across(mesh, strip)`
template <typename FT>
FT strip_turning(const Triangulation_connectivity& mesh, const std::vector<int>& strip,
                 const std::vector<FT>& corner_angle)
{
  CGAL_precondition(is_closed_strip(mesh, strip) || is_strip_across(mesh, strip));
  FT turning(0);
  for (std::size_t i = 0; i + 1 < strip.size(); ++i)
    turning += turning_in_face(mesh, strip[i], strip[i + 1], corner_angle);
  if (mesh.face(strip.back()) != Triangulation_connectivity::null)
    turning += turning_in_face(mesh, strip.back(), strip.front(), corner_angle);
  return turning;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_STRIP_TURNING_H
