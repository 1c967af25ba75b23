// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_FLIP_POLICY_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_FLIP_POLICY_H

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// Flip policy of the similarity map: ideal Delaunay flips, the default.
///
/// After each trial step, edges are flipped until all are Delaunay in the scaled metric, with Ptolemy's formula on the
/// unscaled lengths. No triangle inequality blocks a step, and each step is a damped Newton step on a convex energy
/// (B. Springborn: Ideal hyperbolic polyhedra and discrete uniformization, 2020; M. Gillespie, B. Springborn, K. Crane:
/// Discrete conformal equivalence of polyhedral surfaces, 2021).
///
/// \cgalModels{FlipPolicy}
struct Ideal_delaunay_flips {};

/// \ingroup PkgTSplinesSimilarityMap
/// Flip policy of the similarity map: the degeneracy flips of [CZ17] section 7.3.
///
/// A step ends where the first triangle degenerates; the longest edge of each degenerate triangle is flipped there. The
/// iteration is not damped and can stall.
///
/// \cgalModels{FlipPolicy}
struct Degeneracy_flips {
  /// Whether the scaled metric's triangulation is made intrinsically Delaunay after each step ([CZ17] section 7.3.1,
  /// Remark).
  bool delaunay = false;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_FLIP_POLICY_H
