// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_SQUARED_DISTANCE_FORM_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_SQUARED_DISTANCE_FORM_H

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The polynomial |N - W p|^2 - d^2 W^2 of a rational bicubic patch N / W, in Bernstein form, of degree 6 in either
/// parameter: it is negative where the patch is closer to the point p than d.
///
/// Its coefficients bound it, with an error that falls with the square of the size of the part it is restricted to;
/// so do their differences its derivatives. Weights need not be positive for that. Where the distance is nearly
/// constant, as from the center of a sphere, the coefficients are, too: no bound by control points has that.
/// \tparam FT a floating point type
template <typename FT>
class Squared_distance_form {
  static constexpr int size = 7;
  static constexpr int stride = 8;

public:
  using Cubic = std::array<FT, 16>; ///< Bernstein coefficients of a bicubic polynomial, 4 j + i

  /// \param differences the three coordinates of N - W p
  Squared_distance_form(const std::array<Cubic, 3>& differences, const Cubic& weights, const bool has_equal_weights,
                        const FT squared_distance)
    : m_coefficients()
  {
    for (const Cubic& x : differences)
      add_square(scaled(x), FT(1));
    if (!has_equal_weights && squared_distance != FT(0))
      add_square(scaled(weights), -squared_distance);
    const FT constant = has_equal_weights ? squared_distance * weights[0] * weights[0] : FT(0);
    const std::array<FT, size> binomials{1, 6, 15, 20, 15, 6, 1};
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        at(i, j) = at(i, j) / (binomials[i] * binomials[j]) - constant;
  }

  FT minimum() const
  {
    FT result = at(0, 0);
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        result = at(i, j) < result ? at(i, j) : result;
    return result;
  }

  FT maximum() const
  {
    FT result = at(0, 0);
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        result = at(i, j) > result ? at(i, j) : result;
    return result;
  }

  /// The place of the smallest coefficient, in [0, 1]^2: near a minimum.
  std::pair<FT, FT> place_of_minimum() const
  {
    int k = 0, l = 0;
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        if (at(i, j) < at(k, l))
          k = i, l = j;
    return {FT(k) / FT(size - 1), FT(l) / FT(size - 1)};
  }

  /// The value at a corner, i and j in {0, 1}.
  FT corner(const int i, const int j) const { return at((size - 1) * i, (size - 1) * j); }

  /// 1 or -1 if the polynomial increases or decreases with parameter number `axis` everywhere, else 0.
  /// \param noise a positive bound of the round-off in differences of coefficients
  int direction(const int axis, const FT noise) const
  {
    const int di = axis == 0, dj = axis == 1;
    FT low = at(di, dj) - at(0, 0), high = low;
    for (int j = 0; j < size - dj; ++j)
      for (int i = 0; i < size - di; ++i) {
        const FT x = at(i + di, j + dj) - at(i, j);
        low = x < low ? x : low;
        high = x > high ? x : high;
      }
    return low > noise ? 1 : high < -noise ? -1 : 0;
  }

  /// Whether the polynomial is certainly convex; in the parameters only in which it is not constant.
  bool is_convex(const bool is_constant_in_s, const bool is_constant_in_t) const
  {
    const FT ss = is_constant_in_s ? FT(0) : smallest_second_difference(0);
    const FT tt = is_constant_in_t ? FT(0) : smallest_second_difference(1);
    if (is_constant_in_s || is_constant_in_t)
      return (is_constant_in_s || ss > FT(0)) && (is_constant_in_t || tt > FT(0));
    if (!(ss > FT(0)) || !(tt > FT(0)))
      return false;
    FT st(0);
    for (int j = 0; j + 1 < size; ++j)
      for (int i = 0; i + 1 < size; ++i) {
        const FT x = std::abs((at(i + 1, j + 1) - at(i, j + 1)) - (at(i + 1, j) - at(i, j)));
        st = x > st ? x : st;
      }
    // The derivatives are 30 ss, 36 st and 30 tt.
    return FT(25) * ss * tt > FT(36) * st * st;
  }

  /// Restricts it to a half of the interval of a parameter, and `other` to the other, upper half.
  void split(const int axis, Squared_distance_form& other)
  {
    const int step = axis == 0 ? 1 : stride, across = axis == 0 ? stride : 1;
    FT* const lower = m_coefficients.data();
    FT* const upper = other.m_coefficients.data();
    for (int k = size - 1; k >= 0; --k) {
      for (int j = 0; j < size; ++j)
        upper[k * step + j * across] = lower[(size - 1) * step + j * across];
      for (int i = size - 1; i >= size - k; --i)
        for (int j = 0; j < size; ++j)
          lower[i * step + j * across] = (lower[i * step + j * across] + lower[(i - 1) * step + j * across]) * FT(0.5);
    }
  }

  /// Replaces it by its values on a side: where parameter number `axis` is 0 or, if `is_end`, 1.
  void restrict_to_side(const int axis, const bool is_end)
  {
    const int side = is_end ? size - 1 : 0;
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        at(i, j) = axis == 0 ? at(side, j) : at(i, side);
  }

private:
  FT& at(const int i, const int j) { return m_coefficients[stride * j + i]; }
  const FT& at(const int i, const int j) const { return m_coefficients[stride * j + i]; }

  // With the binomial coefficients as factors products of Bernstein polynomials become convolutions.
  static Cubic scaled(const Cubic& x)
  {
    Cubic result;
    for (int k = 0; k < 16; ++k)
      result[k] = x[k] * FT((k % 4 % 3 == 0 ? 1 : 3) * (k / 4 % 3 == 0 ? 1 : 3));
    return result;
  }

  void add_square(const Cubic& x, const FT factor)
  {
    for (int a = 0; a < 4; ++a)
      for (int b = a; b < 4; ++b) {
        FT* const row = &at(0, a + b);
        const FT y = a == b ? factor : FT(2) * factor;
        for (int i = 0; i < 4; ++i)
          for (int k = 0; k < 4; ++k)
            row[i + k] += y * x[4 * a + i] * x[4 * b + k];
      }
  }

  FT smallest_second_difference(const int axis) const
  {
    const int di = axis == 0, dj = axis == 1;
    FT result = (at(2 * di, 2 * dj) - at(di, dj)) - (at(di, dj) - at(0, 0));
    for (int j = 0; j < size - 2 * dj; ++j)
      for (int i = 0; i < size - 2 * di; ++i) {
        const FT x = (at(i + 2 * di, j + 2 * dj) - at(i + di, j + dj)) - (at(i + di, j + dj) - at(i, j));
        result = x < result ? x : result;
      }
    return result;
  }

  std::array<FT, size * stride> m_coefficients; // (i, j) is number stride * j + i
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_SQUARED_DISTANCE_FORM_H
