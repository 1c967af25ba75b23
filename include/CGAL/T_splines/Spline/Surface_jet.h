// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_SURFACE_JET_H
#define CGAL_T_SPLINES_SPLINE_SURFACE_JET_H

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Curvatures of a surface at a point. The signs are those for the normal du x dv: a sphere whose normals point
/// outwards has negative ones.
/// \tparam Kernel a CGAL kernel whose `FT` has a square root
template <typename Kernel>
struct Surface_curvatures {
  using FT = typename Kernel::FT;             ///< number type
  using Vector_3 = typename Kernel::Vector_3; ///< a vector in space

  FT gaussian;                ///< product of the principal curvatures
  FT mean;                    ///< half of their sum
  FT minimal,                 ///< the smaller principal curvature
      maximal;                ///< the larger one
  Vector_3 minimal_direction; ///< unit tangent vectors; any orthogonal pair where the curvatures are equal
  Vector_3 maximal_direction; ///< orthogonal to the other
};

/// \ingroup PkgTSplinesSpline
/// A point of a surface with the derivatives up to order 2 with respect to the parameters of its face.
/// \tparam Kernel a CGAL kernel
template <typename Kernel>
struct Surface_jet {
  using FT = typename Kernel::FT;             ///< number type
  using Point_3 = typename Kernel::Point_3;   ///< a point in space
  using Vector_3 = typename Kernel::Vector_3; ///< a vector in space

  Point_3 position; ///< the point
  Vector_3 du,      ///< first derivative along u
      dv,           ///< first derivative along v
      duu,          ///< second derivative along u
      duv,          ///< mixed derivative
      dvv;          ///< second derivative along v

  /// returns du x dv, which points to the side from which the faces are seen counter-clockwise.
  Vector_3 normal() const { return CGAL::cross_product(du, dv); }

  /// returns the unit normal; the zero vector where du and dv are linearly dependent.
  Vector_3 unit_normal() const
  {
    using CGAL::sqrt;
    using std::sqrt;
    const Vector_3 n = normal();
    const FT length = sqrt(FT(n.squared_length()));
    return length > FT(0) ? Vector_3(n / length) : n;
  }

  /// returns the curvatures. \pre du and dv are linearly independent
  Surface_curvatures<Kernel> curvatures() const
  {
    using CGAL::sqrt;
    using std::sqrt;
    // Derivatives along the orthonormal frame a = du / |du|, b = n x a make the shape operator symmetric.
    const Vector_3 n = unit_normal();
    const FT length = sqrt(FT(du.squared_length()));
    const Vector_3 a = du / length, b = CGAL::cross_product(n, a);
    const FT p = dv * a, q = dv * b; // dv = p a + q b, q > 0
    const FT l = duu * n, m = duv * n, k = dvv * n;
    const FT aa = l / (length * length), ab = (m / length - p * aa) / q;
    const FT bb = (k - FT(2) * p * q * ab - p * p * aa) / (q * q);
    Surface_curvatures<Kernel> result;
    result.mean = (aa + bb) / FT(2);
    result.gaussian = aa * bb - ab * ab;
    const FT half = (aa - bb) / FT(2), radius = sqrt(FT(half * half + ab * ab));
    result.minimal = result.mean - radius;
    result.maximal = result.mean + radius;
    // The eigenvector of the larger curvature, from the row that does not cancel.
    FT x = half >= FT(0) ? FT(half + radius) : ab, y = half >= FT(0) ? ab : FT(radius - half);
    const FT norm = sqrt(FT(x * x + y * y));
    x = norm > FT(0) ? FT(x / norm) : FT(1);
    y = norm > FT(0) ? FT(y / norm) : FT(0);
    result.maximal_direction = x * a + y * b;
    result.minimal_direction = CGAL::cross_product(n, result.maximal_direction);
    return result;
  }
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_SURFACE_JET_H
