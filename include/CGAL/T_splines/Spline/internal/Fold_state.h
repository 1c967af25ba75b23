// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FOLD_STATE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FOLD_STATE_H

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether the normals of a surface and of a mesh differ somewhere by a right angle or more; doubtful, if those of some
/// triangle within the tolerance do not. Ordered.
enum class Fold_state : char { NONE, DOUBTFUL, FOLDED };

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FOLD_STATE_H
