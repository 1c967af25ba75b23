// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_SAMPLE_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_SAMPLE_H

#include <CGAL/T_splines/T_mesh/T_mesh_place.h>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// A point of a surface, its place in a T-mesh, and the area that it stands for.
///
/// \cgalModels{TMeshSample}
///
/// \tparam Graph a model of `FaceGraph`
/// \tparam Kernel a model of CGAL's `Kernel` whose `FT` is a floating point type
template <typename Graph, typename Kernel>
struct T_mesh_sample {
  using FT = typename Kernel::FT;           ///< number type
  using Point_3 = typename Kernel::Point_3; ///< a point in space

  T_mesh_place<Graph, FT> place; ///< where it is in the T-mesh
  Point_3 point;                 ///< where it is in space
  FT weight = FT(0);             ///< in the units of the points, squared
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_SAMPLE_H
