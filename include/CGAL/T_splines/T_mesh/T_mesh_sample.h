// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_SAMPLE_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_SAMPLE_H

#include <CGAL/T_splines/T_mesh/T_mesh_place.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>

#include <type_traits>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// A point of a surface, its place in a T-mesh, and the area that it stands for.
///
/// \cgalModels{TMeshSample}
///
/// \tparam Graph a model of `FaceGraph`
/// \tparam Kernel a model of CGAL's `Kernel` whose `FT` is a floating point type; samples that are carried along and not
///         fitted to may have any
template <typename Graph, typename Kernel>
struct T_mesh_sample {
  using FT = typename Kernel::FT;           ///< number type
  using Point_3 = typename Kernel::Point_3; ///< a point in space

  T_mesh_place<Graph, FT> place; ///< where it is in the T-mesh
  Point_3 point;                 ///< where it is in space
  FT weight = FT(0);             ///< in the units of the points, squared
};

namespace internal {

template <typename Kernel>
using Floating_point_kernel = std::conditional_t<std::is_floating_point<typename Kernel::FT>::value, Kernel,
                                                 CGAL::Exact_predicates_inexact_constructions_kernel>;

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// The samples of a mesh with points of the type `Point_3`, as `sample_T_mesh()` writes them: in the kernel of the points
/// if its `FT` is a floating point type, otherwise in `CGAL::Exact_predicates_inexact_constructions_kernel`.
/// \tparam Graph the T-mesh's graph
/// \tparam Point_3 a point of a CGAL kernel, the value type of the mesh's vertex point map
template <typename Graph, typename Point_3>
using T_mesh_sample_of =
    T_mesh_sample<Graph, internal::Floating_point_kernel<typename CGAL::Kernel_traits<Point_3>::Kernel>>;

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_SAMPLE_H
