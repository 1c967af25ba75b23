// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_MESH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_MESH_H

#include <CGAL/T_splines/Spline/internal/Mesh_normals.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <optional>
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
    if (triangles.has_only_data())
      return;
    Triangle_set data = triangles;
    data.triangles.resize(triangles.number_of_data());
    data_tree.emplace(data, progress);
  }
  Measured_mesh(const Measured_mesh&) = delete; // the normals refer to the triangles
  Measured_mesh& operator=(const Measured_mesh&) = delete;

  const Triangle_set triangles;
  const Triangle_tree tree;
  const Mesh_normals normals;
  std::optional<Triangle_tree> data_tree; ///< of the triangles that are data; none if all are

  /// The distance of a point from the data, beyond that from the mesh: 0 where the point is measured.
  /// \param foot of the point on the mesh; where data is as near, as on the edges between data and what closes a hole, it
  ///   becomes that on data
  double distance_beyond(const Triangle_set::Point_3& p, Triangle_tree::Foot& foot) const
  {
    constexpr double equal = 1 + same_point;
    if (triangles.is_data(foot.triangle))
      return 0;
    const Triangle_tree::Foot data_foot = data_tree->foot(p);
    if (data_foot.distance() > equal * foot.distance())
      return data_foot.distance() - foot.distance();
    foot = data_foot;
    return 0;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_MEASURED_MESH_H
