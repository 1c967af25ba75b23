// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_INTERNAL_IS_FINITE_H
#define CGAL_T_SPLINES_SOLVER_INTERNAL_IS_FINITE_H

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether no number of `numbers` is infinite or NaN.
template <typename FT>
bool is_finite(const std::vector<FT>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](const FT& number) {
    using std::isfinite;
    return isfinite(number);
  });
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_INTERNAL_IS_FINITE_H
