// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_DEFAULTS_H
#define CGAL_T_SPLINES_DEFAULTS_H

namespace CGAL {
namespace T_splines {

// What is used where nothing else is asked for, each value in this place only. Distances are given by the longest side of
// the bounding box of the mesh.

/// \ingroup PkgTSplinesIO
/// How far apart ends of boundary edges may be that are one point: eight units in the last place of a coordinate of that
/// size in a file with `float` numbers, and far below what the tolerance of a surface is.
constexpr double default_merge_distance = 1e-6;

/// \ingroup PkgTSplinesCrossField
/// By how many degrees the border of a mesh turns, within the surface, where it has a corner.
///
/// Half of a quarter turn is the least that rounds to one; an octagon, which turns by as much, is a round hole.
constexpr double default_corner_angle = 50;

/// \ingroup PkgTSplinesCrossField
/// By how many degrees the normals of the two faces of a feature differ.
///
/// A hole of eight sides has features along it, one of ten sides has none.
constexpr double default_feature_angle = 40;

/// \ingroup PkgTSplinesCrossField
/// The angle between two features, in degrees, below which one of them goes soft rather than that the sector between them
/// becomes a quarter turn: a map would have to open it by more than nine times. Of 20 mechanical parts none has such a sector.
constexpr double default_smallest_sector_angle = 10;

/// \ingroup PkgTSplinesCrossField
/// By how many degrees a given field may be off the direction of a feature: vectors in files have six digits.
constexpr double default_feature_deviation = 1e-3;

/// \ingroup PkgTSplinesCrossField
/// How much a merge of cones may raise the energy of the map's scale, on a component of the given genus.
///
/// Each cone costs about fifty control points of a surface within 0.5 %, and each merge makes the map's scale vary more.
/// Of 3, 4, 5, 6 and 9, these limits led to the fewest control points on 25 meshes. A sphere keeps eight cones whatever the
/// limit is; on a torus higher limits take away the last cones, and thin parts are sheared.
constexpr double default_energy_change(const int genus)
{
  return genus == 0 ? 6 : genus == 1 ? 3 : 4;
}

/// \ingroup PkgTSplinesSimilarityMap
/// The largest deviation of a map from the prescribed angles, in radians.
constexpr double default_residual_tolerance = 1e-12;

/// \ingroup PkgTSplinesSimilarityMap
/// The most steps of Newton's method for the metric of a map.
constexpr int default_number_of_newton_steps = 100;

/// \ingroup PkgTSplinesSimilarityMap
/// The weight of distortion against alignment in an aligned map.
///
/// With 1 fields are followed by 7 to 25 % less, with 0.01 by 7 % more, and the most distorted triangles are distorted four times as much.
constexpr double default_distortion_weight = 0.1;

/// \ingroup PkgTSplinesTMesh
/// How far lengths of a T-mesh that are equal may differ, relative to the larger one: knots that are rounded to `double`s,
/// scaled and summed on different ways are off by some 1e-14, those that are written with ten digits by more.
constexpr double default_relative_tolerance = 1e-9;

/// \ingroup PkgTSplinesApproximation
/// The largest distance between mesh and surface.
constexpr double default_tolerance = 0.005;

/// \ingroup PkgTSplinesSpline
/// The weight of the thin-plate energy of a fit, without unit: it smooths over half of the distance between samples.
constexpr double default_fairness = 0.1;

/// \ingroup PkgTSplinesSpline
/// A fit may always have as many control points as this: as many as a surface may need that is worth having.
constexpr int always_allowed_control_points = 5000;

/// \ingroup PkgTSplinesSpline
/// Into how many parts a side of a face of the T-mesh is divided, at least, where a surface is tessellated.
constexpr int default_tessellation_resolution = 8;

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_DEFAULTS_H
