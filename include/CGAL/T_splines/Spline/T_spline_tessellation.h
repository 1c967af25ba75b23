// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_TESSELLATION_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_TESSELLATION_H

#include <CGAL/T_splines/T_mesh/T_mesh_place.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// A corner of a triangle on a crease: see `T_spline_tessellation`.
struct T_spline_crease_corner {
  std::size_t triangle; ///< the number of the triangle
  int corner;           ///< which one of its corners, from 0 to 2
  std::size_t place;    ///< number of a place, among those on creases
};

namespace internal {

/// Triangles that do not share points across creases. \tparam Corners a range of corners on creases
template <typename Corners>
std::vector<std::array<std::size_t, 3>> split_at_creases(std::vector<std::array<std::size_t, 3>> triangles,
                                                         const Corners& corners, const std::size_t number_of_places)
{
  for (const auto& c : corners)
    triangles[c.triangle][c.corner] = number_of_places + c.place;
  return triangles;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// A triangulation of the parameter domain of a T-spline surface: places, and triangles of three numbers of places,
/// seen counter-clockwise, with the faces in which they lie.
///
/// Triangles on both sides of a crease share its points, each of which has one place. There the surface has more than one
/// normal: what belongs to a side is found at the place that the point has in the triangle's own face.
/// \tparam Graph the T-mesh
template <typename Graph, typename FT>
struct T_spline_tessellation {
  std::vector<T_mesh_place<Graph, FT>> places;                             ///< the corners of the triangles
  std::vector<std::array<std::size_t, 3>> triangles;                       ///< numbers of three places each
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> faces; ///< of the T-mesh, per triangle
  /// the points on creases, their ends included, once more: in each face around. None without creases
  std::vector<T_mesh_place<Graph, FT>> crease_places;
  std::vector<T_spline_crease_corner> crease_corners; ///< all corners of triangles on creases, by increasing triangle

  /// returns the triangles as they are without the points that creases share: a number i from `places.size()` on stands
  /// for the place `crease_places[i - places.size()]`, which is in the triangle's face.
  std::vector<std::array<std::size_t, 3>> triangles_split_at_creases() const
  {
    return internal::split_at_creases(triangles, crease_corners, places.size());
  }
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_TESSELLATION_H
