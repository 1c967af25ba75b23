// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_OWN_WEIGHTS_H
#define CGAL_T_SPLINES_IO_INTERNAL_OWN_WEIGHTS_H

#include <CGAL/property_map.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename TMesh, typename = void>
constexpr bool has_own_weights = false;

template <typename TMesh>
constexpr bool has_own_weights<TMesh, std::void_t<decltype(std::declval<const TMesh&>().weights())>> = true;

/// The weights of the control points that a T-mesh has itself, as a `T_spline` does; 1 for others.
template <typename TMesh>
auto own_weights(const TMesh& t_mesh)
{
  if constexpr (has_own_weights<TMesh>)
    return t_mesh.weights();
  else
    return CGAL::Constant_property_map<typename TMesh::vertex_descriptor, double>(1.);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_OWN_WEIGHTS_H
