// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_TRIANGLE_ANGLES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_TRIANGLE_ANGLES_H

#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The angles of a Euclidean triangle, given by the logarithms of its side lengths up to a common summand.
///
/// Angles are twice the arc tangents of half-angle tangents, from the products of Heron's formula with Kahan's
/// bracketing: they keep their relative accuracy in needles, where `acos` loses half of the digits.
/// \tparam FT a floating-point type, multiprecision or not.
template <typename FT>
struct Triangle_angles {
  std::array<FT, 3> angle;         ///< the angle opposite to side i
  std::array<double, 3> cotangent; ///< its cotangent
  bool is_triangle = true;         ///< strict triangle inequality; otherwise angles are 0 or pi, cotangents 0

  explicit Triangle_angles(const std::array<FT, 3>& log_length)
  {
    using std::atan2;
    using std::exp;
    using std::sqrt;
    int longest = log_length[0] >= log_length[1] ? 0 : 1;
    if (log_length[2] > log_length[longest])
      longest = 2;
    const int i = longest;
    int j = (i + 1) % 3, k = (i + 2) % 3;
    if (log_length[k] > log_length[j])
      std::swap(j, k);
    // a = 1 >= b >= c
    const FT b = exp(FT(log_length[j] - log_length[i]));
    const FT c = exp(FT(log_length[k] - log_length[i]));
    const FT perimeter = 1 + (b + c);
    const FT excess_a = c - (1 - b);
    const FT excess_b = c + (1 - b);
    const FT excess_c = 1 + (b - c);
    if (!(excess_a > 0)) {
      is_triangle = false;
      angle[i] = pi();
      angle[j] = angle[k] = FT(0);
      cotangent = {0., 0., 0.};
      return;
    }
    // tan(A / 2) = r / (s - a), with the inradius r = sqrt((s - a) (s - b) (s - c) / s)
    const FT diameter = sqrt(FT(excess_a * (excess_b * excess_c) / perimeter));
    angle[j] = 2 * atan2(diameter, excess_b);
    angle[k] = 2 * atan2(diameter, excess_c);
    angle[i] = pi() - (angle[j] + angle[k]); // at least pi / 3: no loss
    const double four_areas = static_cast<double>(FT(diameter * perimeter));
    const double bb = static_cast<double>(FT(b * b)), cc = static_cast<double>(FT(c * c));
    cotangent[i] = (bb + cc - 1) / four_areas;
    cotangent[j] = (1 + cc - bb) / four_areas;
    cotangent[k] = (1 + bb - cc) / four_areas;
  }

private:
  static const FT& pi()
  {
    static const FT value = [] {
      using std::atan2;
      return FT(4 * atan2(FT(1), FT(1)));
    }();
    return value;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_TRIANGLE_ANGLES_H
