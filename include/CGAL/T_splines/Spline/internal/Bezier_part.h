// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_PART_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_PART_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A part [s_begin, s_end] x [t_begin, t_end] of the domain [0, 1]^2 of a patch.
struct Patch_rectangle {
  double s_begin = 0, s_end = 1, t_begin = 0, t_end = 1;

  double width() const { return s_end - s_begin; }
  double height() const { return t_end - t_begin; }
  double middle_s() const { return s_begin + width() / 2; }
  double middle_t() const { return t_begin + height() / 2; }

  /// The two rectangles into which the middle of parameter number `axis` cuts it.
  std::array<Patch_rectangle, 2> bisected(const int axis) const
  {
    std::array<Patch_rectangle, 2> result{*this, *this};
    if (axis == 0)
      result[0].s_end = result[1].s_begin = middle_s();
    else
      result[0].t_end = result[1].t_begin = middle_t();
    return result;
  }
};

/// The control points of a part of a patch, from blossoms.
inline Bezier_patch_3<CGAL::Simple_cartesian<double>>
restricted(const Bezier_patch_3<CGAL::Simple_cartesian<double>>& patch, const Patch_rectangle& r)
{
  using Controls = Bezier_patch_3<CGAL::Simple_cartesian<double>>::Controls;
  // Row k of the matrix: the blossom of a cubic at k times `end` and 3 - k times `begin`, in its coefficients.
  const auto matrix = [](const double begin, const double end) {
    std::array<std::array<double, 4>, 4> result{};
    for (int k = 0; k < 4; ++k) {
      std::array<double, 4>& row = result[k];
      row[0] = 1;
      for (int level = 1; level <= 3; ++level) {
        const double x = level <= k ? end : begin;
        for (int i = level; i >= 0; --i)
          row[i] = (1 - x) * (i < level ? row[i] : 0) + x * (i > 0 ? row[i - 1] : 0);
      }
    }
    return result;
  };
  const auto a = matrix(r.s_begin, r.s_end), b = matrix(r.t_begin, r.t_end);
  const Controls& c = patch.homogeneous_control_points();
  Controls rows{}, result{};
  for (int j = 0; j < 4; ++j)
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i)
        for (int x = 0; x < 4; ++x)
          rows[4 * j + k][x] += a[k][i] * c[4 * j + i][x];
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        for (int x = 0; x < 4; ++x)
          result[4 * k + i][x] += b[k][j] * rows[4 * j + i][x];
  return Bezier_patch_3<CGAL::Simple_cartesian<double>>(result);
}

/// Bounds of the derivatives of a patch with respect to its two parameters; infinite unless all weights are positive.
struct Derivative_bounds {
  double s, t, ss, st, tt;

  /// How far a part reaches from its middle, at most.
  double radius(const Patch_rectangle& r) const { return 0.5 * (s * r.width() + t * r.height()); }

  /// How far the surface is, at most, from the linear interpolation between three of its points, whose parameters
  /// differ by at most `ds` and `dt`: half of the variance of the parameters times the second derivatives.
  double chord_error(const double ds, const double dt) const
  {
    return (ss * ds * ds + 2 * st * ds * dt + tt * dt * dt) / 8;
  }
};

/// With N / W relative to the middle of the control points: (N / W)' = (N' - W' N / W) / W, and so on.
inline Derivative_bounds derivative_bounds(const Bezier_patch_3<CGAL::Simple_cartesian<double>>& patch)
{
  using Vector = std::array<double, 4>;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto& c = patch.homogeneous_control_points();
  double smallest_weight = c[0][3];
  Vector middle{};
  for (const Vector& h : c) {
    smallest_weight = (std::min)(smallest_weight, h[3]);
    for (int x = 0; x < 4; ++x)
      middle[x] += h[x];
  }
  if (!(smallest_weight > 0))
    return {infinite, infinite, infinite, infinite, infinite};
  std::array<Vector, 16> d;
  double radius = 0;
  for (int k = 0; k < 16; ++k) {
    d[k] = c[k];
    for (int x = 0; x < 3; ++x)
      d[k][x] -= c[k][3] * (middle[x] / middle[3]);
    radius = (std::max)(radius, std::hypot(d[k][0], d[k][1], d[k][2]) / d[k][3]);
  }
  // Bounds of |N| and |W| of a difference of control points, of order (i, j).
  const auto bound = [&](const int order_s, const int order_t) {
    std::array<double, 2> largest{0, 0};
    for (int j = 0; j + order_t < 4; ++j)
      for (int i = 0; i + order_s < 4; ++i) {
        Vector sum{};
        for (int b = 0; b <= order_t; ++b)
          for (int a = 0; a <= order_s; ++a) {
            const std::array<std::array<int, 3>, 3> binomial{{{1, 0, 0}, {-1, 1, 0}, {1, -2, 1}}};
            for (int x = 0; x < 4; ++x)
              sum[x] += binomial[order_s][a] * binomial[order_t][b] * d[4 * (j + b) + i + a][x];
          }
        largest[0] = (std::max)(largest[0], std::hypot(sum[0], sum[1], sum[2]));
        largest[1] = (std::max)(largest[1], std::abs(sum[3]));
      }
    const std::array<double, 3> degrees{1, 3, 6};
    for (double& x : largest)
      x *= degrees[order_s] * degrees[order_t] / smallest_weight;
    return largest;
  };
  const auto n_s = bound(1, 0), n_t = bound(0, 1), n_ss = bound(2, 0), n_st = bound(1, 1), n_tt = bound(0, 2);
  Derivative_bounds result;
  result.s = n_s[0] + n_s[1] * radius;
  result.t = n_t[0] + n_t[1] * radius;
  result.ss = n_ss[0] + 2 * n_s[1] * result.s + n_ss[1] * radius;
  result.st = n_st[0] + n_s[1] * result.t + n_t[1] * result.s + n_st[1] * radius;
  result.tt = n_tt[0] + 2 * n_t[1] * result.t + n_tt[1] * radius;
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_PART_H
