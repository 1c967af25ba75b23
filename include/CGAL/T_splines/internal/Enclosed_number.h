// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_ENCLOSED_NUMBER_H
#define CGAL_T_SPLINES_INTERNAL_ENCLOSED_NUMBER_H

#include <CGAL/enum.h>

#include <optional>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A number of which an enclosing interval is known, and, unless the interval is one double, a pointer to its value.
template <typename FT>
struct Enclosed_number {
  double lower = 0, upper = 0;
  const FT* exact = nullptr; ///< null if the number is the double `lower`, equal to `upper`

  FT value() const { return exact == nullptr ? FT(lower) : *exact; }
};

/// The order of two numbers, unless only their exact values tell it.
template <typename FT>
std::optional<CGAL::Comparison_result> filtered_comparison(const Enclosed_number<FT>& a, const Enclosed_number<FT>& b)
{
  if (a.upper < b.lower)
    return CGAL::SMALLER;
  if (a.lower > b.upper)
    return CGAL::LARGER;
  if (a.exact == b.exact && a.lower == b.lower)
    return CGAL::EQUAL; // the same double, or the same stored number
  return std::nullopt;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_ENCLOSED_NUMBER_H
