// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_BEZIER_PATCH_3_H
#define CGAL_T_SPLINES_SPLINE_BEZIER_PATCH_3_H

#include <CGAL/T_splines/Spline/Surface_jet.h>
#include <CGAL/T_splines/Spline/internal/rational_jet.h>

#include <array>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// A rational bicubic Bezier patch over [0, 1]^2.
///
/// Its 16 control points are homogeneous, (w x, w y, w z, w); number 4 j + i is the i-th one along the first parameter
/// and the j-th one along the second.
/// \tparam Kernel_ a CGAL kernel
template <typename Kernel_>
class Bezier_patch_3 {
public:
  using Kernel = Kernel_;                       ///< the kernel
  using FT = typename Kernel::FT;               ///< number type
  using Point_3 = typename Kernel::Point_3;     ///< a point in space
  using Homogeneous = std::array<FT, 4>;        ///< (w x, w y, w z, w)
  using Controls = std::array<Homogeneous, 16>; ///< the control points, see above

  Bezier_patch_3() : m_controls() {}
  /// makes the patch with these homogeneous control points.
  explicit Bezier_patch_3(const Controls& controls) : m_controls(controls) {}

  /// returns all homogeneous control points.
  const Controls& homogeneous_control_points() const { return m_controls; }
  /// returns control point (i, j), homogeneous.
  Homogeneous& homogeneous_control_point(const int i, const int j) { return m_controls[4 * j + i]; }
  /// returns control point (i, j), homogeneous.
  const Homogeneous& homogeneous_control_point(const int i, const int j) const { return m_controls[4 * j + i]; }

  /// returns control point (i, j), euclidean.
  Point_3 control_point(const int i, const int j) const
  {
    return internal::projected_point<Kernel>(homogeneous_control_point(i, j));
  }
  /// returns the weight of control point (i, j).
  const FT& weight(const int i, const int j) const { return homogeneous_control_point(i, j)[3]; }

  /// returns the point at (s, t).
  Point_3 position(const FT& s, const FT& t) const
  {
    return internal::projected_point<Kernel>(homogeneous_jet<0>(s, t)[0]);
  }

  /// returns the point at (s, t) with the first and second derivatives with respect to s and t.
  Surface_jet<Kernel> jet(const FT& s, const FT& t) const
  {
    return internal::rational_jet<Kernel>(homogeneous_jet<2>(s, t));
  }

  /// returns the homogeneous coordinates and their derivatives up to `Order` (0, 1 or 2): value, d/ds, d/dt, d2/ds2,
  /// d2/dsdt, d2/dt2; those of higher order are not set.
  template <int Order>
  std::array<Homogeneous, 6> homogeneous_jet(const FT& s, const FT& t) const
  {
    const std::array<std::array<FT, 4>, 3> a = bernstein<Order>(s), b = bernstein<Order>(t);
    std::array<Homogeneous, 6> result;
    for (int j = 0; j < 4; ++j) {
      std::array<Homogeneous, Order + 1> row;
      for (int d = 0; d <= Order; ++d)
        row[d] = combination(m_controls.data() + 4 * j, a[d]);
      const bool is_first = j == 0;
      add(is_first, result[0], row[0], b[0][j]);
      if constexpr (Order > 0) {
        add(is_first, result[1], row[1], b[0][j]);
        add(is_first, result[2], row[0], b[1][j]);
      }
      if constexpr (Order > 1) {
        add(is_first, result[3], row[2], b[0][j]);
        add(is_first, result[4], row[1], b[1][j]);
        add(is_first, result[5], row[0], b[2][j]);
      }
    }
    return result;
  }

private:
  static Homogeneous combination(const Homogeneous* const h, const std::array<FT, 4>& x)
  {
    Homogeneous sum;
    for (int k = 0; k < 4; ++k)
      sum[k] = x[0] * h[0][k] + x[1] * h[1][k] + (x[2] * h[2][k] + x[3] * h[3][k]);
    return sum;
  }

  // Adds to the sum, or begins it.
  static void add(const bool is_first, Homogeneous& sum, const Homogeneous& h, const FT& x)
  {
    for (int k = 0; k < 4; ++k) {
      if (is_first)
        sum[k] = x * h[k];
      else
        sum[k] += x * h[k];
    }
  }

  // The cubic Bernstein polynomials and their derivatives up to `Order`.
  template <int Order>
  static std::array<std::array<FT, 4>, 3> bernstein(const FT& x)
  {
    const FT y = FT(1) - x, xx = x * x, yy = y * y, three(3), six(6);
    std::array<std::array<FT, 4>, 3> result;
    result[0] = {FT(yy * y), FT(three * x * yy), FT(three * xx * y), FT(xx * x)};
    if constexpr (Order > 0)
      result[1] = {FT(-(three * yy)), FT(three * yy - six * x * y), FT(six * x * y - three * xx), FT(three * xx)};
    if constexpr (Order > 1)
      result[2] = {FT(six * y), FT(six * x - FT(12) * y), FT(six * y - FT(12) * x), FT(six * x)};
    return result;
  }

  Controls m_controls;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_BEZIER_PATCH_3_H
