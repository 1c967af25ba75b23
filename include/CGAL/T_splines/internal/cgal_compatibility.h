// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_CGAL_COMPATIBILITY_H
#define CGAL_T_SPLINES_INTERNAL_CGAL_COMPATIBILITY_H

// Everything that reads differently on CGAL 5.5 and CGAL 6 stands here.

#include <CGAL/version_macros.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h> // deprecated in CGAL 6
#endif

namespace CGAL {
namespace T_splines {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <typename Kernel, typename Primitive>
using AABB_traits_for_3 = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
template <typename Kernel, typename Primitive>
using AABB_traits_for_3 = CGAL::AABB_traits<Kernel, Primitive>;
#endif

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_CGAL_COMPATIBILITY_H
