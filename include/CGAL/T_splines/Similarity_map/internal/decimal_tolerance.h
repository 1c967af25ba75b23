// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DECIMAL_TOLERANCE_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DECIMAL_TOLERANCE_H

#include <array>
#include <charconv>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether a number is what some text with so many significant digits reads as.
inline bool has_few_digits(const double x, const int digits)
{
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits).ptr;
  double read = 0;
  std::from_chars(text.data(), end, read);
  return read == x;
}

/// The deviation from seamlessness that writing and reading explains, relative to the size of coordinates: files of
/// other programs often have six digits, which is what streams write. The first number with more ends the search.
inline double decimal_tolerance(const std::vector<std::array<double, 2>>& uv)
{
  // A number with six digits is off by up to 5e-6, one with seven by 5e-7, and a deviation is a sum of some.
  constexpr double tolerance_of_doubles = 1e-6, tolerance_of_six_digits = 2e-5, tolerance_of_seven_digits = 2e-6;
  int digits = 6;
  for (const std::array<double, 2>& p : uv)
    for (const double x : p)
      while (!has_few_digits(x, digits))
        if (++digits > 7)
          return tolerance_of_doubles;
  return digits == 6 ? tolerance_of_six_digits : tolerance_of_seven_digits;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DECIMAL_TOLERANCE_H
