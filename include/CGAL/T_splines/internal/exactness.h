// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_EXACTNESS_H
#define CGAL_T_SPLINES_INTERNAL_EXACTNESS_H

#include <CGAL/Algebraic_structure_traits.h>

namespace CGAL {
namespace T_splines {
namespace internal {

// Whether equality means something for computed numbers of this type.
template <typename FT>
inline constexpr bool is_exact_number_type = CGAL::Algebraic_structure_traits<FT>::Is_exact::value;

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_EXACTNESS_H
