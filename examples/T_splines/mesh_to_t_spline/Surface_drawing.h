// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_SURFACE_DRAWING_H
#define MESH_TO_T_SPLINE_SURFACE_DRAWING_H

#include "Approximation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

/// What the page draws of a T-spline surface: a tessellation, and the control T-mesh. Empty where there is no surface.
///
/// Where normals differ from one side to the other, at creases, each side has points of its own, or the page could not show
/// it.
struct Surface_drawing {
  std::vector<Kernel::Point_3> points;        ///< of the tessellation
  std::vector<Kernel::Vector_3> normals;      ///< per point: of length 1
  std::vector<double> mean_curvature;         ///< per point: 1/r on a sphere of radius r whose normals point out of it;
                                              ///< NaN where undefined (at extraordinary points)
  std::vector<double> deviation;              ///< per point: its distance from the mesh, by the longest side of the box
  std::vector<std::uint32_t> triangles;       ///< 3 points per triangle
  std::vector<Kernel::Point_3> net_points;    ///< the edges of the control T-mesh as polylines, one after the other
  std::vector<std::uint32_t> net_sizes;       ///< per polyline: its number of points
  std::vector<Kernel::Point_3> edge_points;   ///< the images of the edges of the T-mesh on the surface, likewise
  std::vector<std::uint32_t> edge_sizes;      ///< per polyline: its number of points
  std::vector<Kernel::Point_3> border_points; ///< the border of the surface, likewise
  std::vector<std::uint32_t> border_sizes;    ///< per polyline: its number of points
  std::vector<Kernel::Point_3> crease_points; ///< the creases of the surface, likewise
  std::vector<std::uint32_t> crease_sizes;    ///< per polyline: its number of points
  std::vector<Kernel::Point_3> extraordinary_points; ///< on the surface, not on its border
  std::vector<Kernel::Point_3> corner_points;        ///< where the border has corners
  std::vector<std::uint32_t> corner_turns;           ///< per corner: its angle in quarter turns
};

/// Coordinates from -1 to 1 as multiples of 1/32767: 3 per vector. (8 bits would be seen in reflection lines.)
inline std::vector<std::int16_t> packed_directions(const std::vector<Kernel::Vector_3>& vectors)
{
  std::vector<std::int16_t> result;
  result.reserve(3 * vectors.size());
  for (const Kernel::Vector_3& vector : vectors)
    for (int i = 0; i < 3; ++i)
      result.push_back(static_cast<std::int16_t>(std::lround(32767 * std::clamp(vector[i], -1.0, 1.0))));
  return result;
}

#endif // MESH_TO_T_SPLINE_SURFACE_DRAWING_H
