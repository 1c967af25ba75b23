// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FIELD_HOLONOMY_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FIELD_HOLONOMY_H

#include <CGAL/T_splines/Cross_field/internal/Border_guide.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/field_rotations.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How many quarter turns the counter-clockwise loop around each vertex makes relative to the field, or, on the border,
/// the way from the one edge on the border to the other: an integer up to round-off.
/// \param border_cross per edge on the border, the angle to the cross
inline std::vector<double> vertex_quarter_turns(const Triangulation_connectivity& mesh,
                                                const std::vector<double>& corner_angle,
                                                const std::vector<double>& rotation,
                                                const std::vector<double>& border_cross)
{
  std::vector<double> result(mesh.number_of_vertices(), 0.);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    result[mesh.target(h)] += corner_angle[h];
    result[mesh.source(h)] -= rotation_into(rotation, h);
    if (mesh.face(h) == Triangulation_connectivity::null) { // against the direction of the border
      result[mesh.source(h)] += border_cross[edge_of(h)];
      result[mesh.target(h)] -= border_cross[edge_of(h)];
    }
  }
  for (double& turns : result)
    turns /= quarter_turn;
  return result;
}

/// The angle, per edge on the border, from the direction of its halfedge with a face to the cross there that is next to the
/// direction in which the guide wants it.
///
/// In a face with two edges on the border, whose cross may be far from one of the two directions, the corner between
/// them has the quarter turns of the guide.
/// \param angle per halfedge: of the cross relative to the halfedge
/// \param worst receives the halfedge where the cross deviates most from the direction that is wanted, -1 without border
/// \param largest receives the angle of this deviation
inline std::vector<double> border_crosses(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                                          const Border_guide& guide, const std::vector<double>& angle, int& worst,
                                          double& largest)
{
  std::vector<double> result(mesh.number_of_edges(), 0.);
  worst = Triangulation_connectivity::null;
  largest = 0;
  const auto is_on_border = [&](const int h) { return mesh.face(opposite(h)) == Triangulation_connectivity::null; };
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    if (mesh.face(h) == Triangulation_connectivity::null || !is_on_border(h))
      continue;
    const double wanted = guide.deviations()[edge_of(h)], off = std::remainder(angle[h] - wanted, quarter_turn);
    result[edge_of(h)] = wanted + off;
    if (!is_on_border(mesh.previous(h)) && !is_on_border(mesh.next(h)) && std::abs(off) > largest) {
      largest = std::abs(off);
      worst = h;
    }
  }
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) != Triangulation_connectivity::null && is_on_border(h) && is_on_border(mesh.previous(h)))
      result[edge_of(h)] = result[edge_of(mesh.previous(h))] + geometry.m_corner_angle[mesh.previous(h)] -
                           guide.quarter_turns()[mesh.source(h)] * quarter_turn;
  return result;
}

/// How many quarter turns a strip makes relative to the field, closed or from border to border.
inline double strip_quarter_turns(const Triangulation_connectivity& mesh, const std::vector<int>& strip,
                                  const std::vector<double>& corner_angle, const std::vector<double>& rotation,
                                  const std::vector<double>& border_cross)
{
  double turning = strip_turning(mesh, strip, corner_angle);
  for (const int h : strip)
    turning -= rotation_into(rotation, h);
  if (mesh.face(strip.back()) == Triangulation_connectivity::null)
    turning += border_cross[edge_of(strip.back())] - border_cross[edge_of(strip.front())];
  return turning / quarter_turn;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FIELD_HOLONOMY_H
