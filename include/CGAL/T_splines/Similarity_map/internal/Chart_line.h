// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CHART_LINE_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CHART_LINE_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// An isoline of a chart. Points on it have the coordinate `value` along `axis`: 0 for u, 1 for v.
template <typename FT>
struct Chart_line {
  int axis;
  FT value;

  Chart_line mapped(const Similarity_2<FT>& transition) const
  {
    const std::pair<FT, FT> image = axis == 0 ? transition(value, FT(0)) : transition(FT(0), value);
    const int image_axis = axis ^ (transition.quarter_turns() & 1);
    return {image_axis, image_axis == 0 ? image.first : image.second};
  }
};

/// The axis along which an edge that lies on an isoline, but for round-off, has one coordinate.
inline int constant_axis(const Triangulation_connectivity& mesh, const Uv_array& uv,
                         const Triangulation_connectivity::Index h)
{
  const std::array<double, 2>&p = uv[mesh.previous(h)], &q = uv[h];
  return std::abs(p[0] - q[0]) < std::abs(p[1] - q[1]) ? 0 : 1;
}

/// The angle by which an edge is off the axes, in radians; and whether that is more than `tolerance` and what an error
/// of `tolerance`, relative to the coordinates, makes of it.
inline std::pair<double, bool> obliqueness(const Triangulation_connectivity& mesh, const Uv_array& uv,
                                           const Triangulation_connectivity::Index h, const double tolerance)
{
  const std::array<double, 2>&p = uv[mesh.previous(h)], &q = uv[h];
  const double du = std::abs(p[0] - q[0]), dv = std::abs(p[1] - q[1]);
  const double angle = std::atan2(std::min(du, dv), std::max(du, dv));
  const double size = std::max(largest_coordinate(p), largest_coordinate(q));
  const double allowed = tolerance * (1 + size / distance(p, q));
  return {angle, !(angle <= std::min(allowed, largest_uncertainty))};
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CHART_LINE_H
