// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_CONVERTED_SIMILARITY_H
#define CGAL_T_SPLINES_INTERNAL_CONVERTED_SIMILARITY_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/internal/converted_number.h>

namespace CGAL {
namespace T_splines {
namespace internal {

// A similarity with coefficients of another type.
template <typename To, typename From>
Similarity_2<To> converted_similarity(const Similarity_2<From>& s)
{
  return Similarity_2<To>(s.quarter_turns(), converted_number<To>(s.scale()), converted_number<To>(s.u()),
                          converted_number<To>(s.v()));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_CONVERTED_SIMILARITY_H
