// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_VERTEX_CAP_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_VERTEX_CAP_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/internal/Homogeneous_vector.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The Bezier patch of a uniform bicubic B-spline with 16 control points, number 4 j + i at (i - 1, j - 1), on [0,
/// 1]^2.
template <typename Kernel>
Bezier_patch_3<Kernel> bezier_of_uniform_b_spline(const std::vector<Homogeneous_vector<typename Kernel::FT>>& c)
{
  using FT = typename Kernel::FT;
  using Vector = Homogeneous_vector<FT>;
  const auto convert = [](const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    const FT third = FT(1) / FT(3), two_thirds = FT(2) / FT(3), sixth = FT(1) / FT(6);
    return std::array<Vector, 4>{a * sixth + b * two_thirds + c * sixth, b * two_thirds + c * third,
                                 b * third + c * two_thirds, b * sixth + c * two_thirds + d * sixth};
  };
  std::array<std::array<Vector, 4>, 4> rows;
  for (int j = 0; j < 4; ++j)
    rows[j] = convert(c[4 * j], c[4 * j + 1], c[4 * j + 2], c[4 * j + 3]);
  Bezier_patch_3<Kernel> result;
  for (int i = 0; i < 4; ++i) {
    const std::array<Vector, 4> column = convert(rows[0][i], rows[1][i], rows[2][i], rows[3][i]);
    for (int j = 0; j < 4; ++j)
      result.homogeneous_control_point(i, j) = column[j].values;
  }
  return result;
}

/// A bicubic patch for the surface around an extraordinary vertex, the corner (0, 0) of [0, 1]^2.
///
/// It takes over the position and the first derivatives from the last ring outside; it interpolates the surface at the
/// vertex, in the middles of the two sides there, and in its own middle. What lies on a side depends on that side
/// alone, so that the caps of neighbouring sectors meet.
/// \param limit the position of the vertex
/// \param outer the parts of the last ring, as `Catmull_clark_subdivision` numbers them
/// \param inner the parts of the ring that the cap takes the place of
template <typename Patch>
Patch vertex_cap(const typename Patch::Homogeneous& limit, const std::array<Patch, 3>& outer,
                 const std::array<Patch, 3>& inner)
{
  using FT = typename Patch::FT;
  using Vector = Homogeneous_vector<FT>;
  const auto point = [](const Patch& patch, const int i, const int j) {
    return Vector{patch.homogeneous_control_point(i, j)};
  };
  const auto reflected = [](const Vector& center, const Vector& p) { return center * FT(2) + p * FT(-1); };
  std::array<std::array<Vector, 4>, 4> b; // b[i][j], i along the first side
  for (int k = 0; k < 4; ++k) {
    b[k][3] = point(outer[2], k, 0);
    b[k][2] = reflected(b[k][3], point(outer[2], k, 1));
  }
  for (int k = 0; k < 4; ++k) {
    b[3][k] = point(outer[0], 0, k);
    b[2][k] = reflected(b[3][k], point(outer[0], 1, k));
  }
  b[0][0] = Vector{limit};
  const FT third = FT(1) / FT(3);
  const auto middle_control = [&](const Vector& q, const Vector& c2, const Vector& c3) {
    return (q * FT(8) + b[0][0] * FT(-1) + c2 * FT(-3) + c3 * FT(-1)) * third;
  };
  b[1][0] = middle_control(point(inner[0], 0, 0), b[2][0], b[3][0]);
  b[0][1] = middle_control(point(inner[2], 0, 0), b[0][2], b[0][3]);
  const std::array<int, 4> weights{1, 3, 3, 1};
  Vector rest = point(inner[1], 0, 0) * FT(64);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != 1 || j != 1)
        rest = rest + b[i][j] * FT(-weights[i] * weights[j]);
  b[1][1] = rest * (FT(1) / FT(9));
  Patch result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      result.homogeneous_control_point(i, j) = b[i][j].values;
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_VERTEX_CAP_H
