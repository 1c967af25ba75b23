// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_NORMAL_HULL_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_NORMAL_HULL_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A polynomial of two parameters in Bernstein form, of degree m x n, times the binomial coefficients: then products
/// are convolutions. Coefficient (i, j) is number (m + 1) j + i.
template <typename T>
struct Scaled_bernstein_form {
  int m = 0, n = 0;
  std::vector<T> coefficients;

  Scaled_bernstein_form() = default;
  Scaled_bernstein_form(const int m, const int n, const T& zero) : m(m), n(n), coefficients((m + 1) * (n + 1), zero) {}

  T& at(const int i, const int j) { return coefficients[(m + 1) * j + i]; }
  const T& at(const int i, const int j) const { return coefficients[(m + 1) * j + i]; }
};

/// Adds the product of two forms. \param times the product of two coefficients
template <typename A, typename B, typename T, typename Times>
void add_product(const Scaled_bernstein_form<A>& a, const Scaled_bernstein_form<B>& b, const Times& times,
                 Scaled_bernstein_form<T>& sum)
{
  for (int j = 0; j <= a.n; ++j)
    for (int i = 0; i <= a.m; ++i)
      for (int l = 0; l <= b.n; ++l)
        for (int k = 0; k <= b.m; ++k)
          sum.at(i + k, j + l) = sum.at(i + k, j + l) + times(a.at(i, j), b.at(k, l));
}

/// Vectors whose convex hull, as a cone, contains the normals S_s x S_t of a rational patch S = N / W: the Bernstein
/// coefficients, up to positive factors, of
///
///   W^3 S_s x S_t = W N_s x N_t + W_s N_t x N + W_t N x N_s.
///
/// \pre the weights are positive
inline std::vector<CGAL::Simple_cartesian<double>::Vector_3>
normal_hull(const Bezier_patch_3<CGAL::Simple_cartesian<double>>& patch)
{
  using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
  using Vectors = Scaled_bernstein_form<Vector_3>;
  using Numbers = Scaled_bernstein_form<double>;
  constexpr std::array<std::array<int, 4>, 2> binomials{{{1, 2, 1, 0}, {1, 3, 3, 1}}}; // of degrees 2 and 3
  const Vector_3 zero(0, 0, 0);
  const auto& c = patch.homogeneous_control_points();
  // Relative to the first control point: the normals are the same, and round-off is less.
  const double x = c[0][0] / c[0][3], y = c[0][1] / c[0][3], z = c[0][2] / c[0][3];
  std::array<Vector_3, 16> points;
  for (int k = 0; k < 16; ++k)
    points[k] = Vector_3(c[k][0] - x * c[k][3], c[k][1] - y * c[k][3], c[k][2] - z * c[k][3]);
  const auto has_equal_weights = std::all_of(c.begin(), c.end(), [&](const auto& h) { return h[3] == c[0][3]; });

  Vectors n(3, 3, zero), n_s(2, 3, zero), n_t(3, 2, zero);
  Numbers w(3, 3, 0), w_s(2, 3, 0), w_t(3, 2, 0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int k = 4 * j + i, b = binomials[1][i] * binomials[1][j];
      n.at(i, j) = b * points[k];
      w.at(i, j) = b * c[k][3];
      if (i < 3) {
        const int b_s = binomials[0][i] * binomials[1][j];
        n_s.at(i, j) = b_s * (points[k + 1] - points[k]);
        w_s.at(i, j) = b_s * (c[k + 1][3] - c[k][3]);
      }
      if (j < 3) {
        const int b_t = binomials[1][i] * binomials[0][j];
        n_t.at(i, j) = b_t * (points[k + 4] - points[k]);
        w_t.at(i, j) = b_t * (c[k + 4][3] - c[k][3]);
      }
    }
  const auto cross = [](const Vector_3& a, const Vector_3& b) { return CGAL::cross_product(a, b); };
  Vectors cross_st(5, 5, zero);
  add_product(n_s, n_t, cross, cross_st);
  if (has_equal_weights)
    return cross_st.coefficients;
  Vectors cross_t(6, 5, zero), cross_s(5, 6, zero), result(8, 8, zero);
  add_product(n_t, n, cross, cross_t);
  add_product(n, n_s, cross, cross_s);
  const auto scale = [](const double a, const Vector_3& b) { return a * b; };
  add_product(w, cross_st, scale, result);
  add_product(w_s, cross_t, scale, result);
  add_product(w_t, cross_s, scale, result);
  return result.coefficients;
}

/// A cone of directions around an axis.
struct Direction_cone {
  CGAL::Simple_cartesian<double>::Vector_3 axis; ///< unit
  double cosine;                                 ///< of the largest angle with the axis; -1 if that is not known
};

/// A cone that contains some directions, around their sum. It is not known if one of them is 0 up to round-off.
template <typename VectorRange>
Direction_cone cone_of(const VectorRange& directions)
{
  using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
  constexpr double round_off = 1e-26; // of squares: the lengths are some hundred units of rounding
  Vector_3 sum(0, 0, 0);
  double largest = 0;
  for (const Vector_3& x : directions) {
    sum = sum + x;
    largest = (std::max)(largest, x.squared_length());
  }
  const double length = std::sqrt(sum.squared_length());
  Direction_cone result{sum, -1};
  if (!(length > 0))
    return result;
  result.axis = sum / length;
  result.cosine = 1;
  for (const Vector_3& x : directions) {
    const double size = x.squared_length();
    result.cosine = (std::min)(result.cosine, size > round_off * largest ? (x * result.axis) / std::sqrt(size) : -1.);
  }
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_NORMAL_HULL_H
