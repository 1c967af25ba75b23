// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_MESH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_MESH_H

#include <CGAL/T_splines/Spline/internal/Mesh_normals.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A mesh that surfaces are measured against, with what the measurements need of it.
struct Measured_mesh {
  /// \param progress if it is interrupted, nothing may be measured
  Measured_mesh(Triangle_set set, Progress& progress)
    : triangles(std::move(set)),
      tree(triangles, progress),
      normals(triangles)
  {
  }
  Measured_mesh(const Measured_mesh&) = delete; // the normals refer to the triangles
  Measured_mesh& operator=(const Measured_mesh&) = delete;

  const Triangle_set triangles;
  const Triangle_tree tree;
  const Mesh_normals normals;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_MESH_H
