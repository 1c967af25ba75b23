// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_RATIONAL_JET_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_RATIONAL_JET_H

#include <CGAL/T_splines/Spline/Surface_jet.h>

#include <array>

namespace CGAL {
namespace T_splines {
namespace internal {

// The point of homogeneous coordinates (w x, w y, w z, w).
template <typename Kernel>
typename Kernel::Point_3 projected_point(const std::array<typename Kernel::FT, 4>& h)
{
  using FT = typename Kernel::FT;
  return typename Kernel::Point_3(FT(h[0] / h[3]), FT(h[1] / h[3]), FT(h[2] / h[3]));
}

/// The derivatives of a point of which those of the homogeneous coordinates are known: value, d/du, d/dv, d2/du2,
/// d2/dudv, d2/dv2.
template <typename Kernel>
Surface_jet<Kernel> rational_jet(const std::array<std::array<typename Kernel::FT, 4>, 6>& h)
{
  using FT = typename Kernel::FT;
  using Vector_3 = typename Kernel::Vector_3;
  const FT w = h[0][3];
  const auto part = [&](const int i) { return Vector_3(h[i][0], h[i][1], h[i][2]); };
  Surface_jet<Kernel> jet;
  jet.position = projected_point<Kernel>(h[0]);
  const Vector_3 p(jet.position.x(), jet.position.y(), jet.position.z());
  jet.du = (part(1) - h[1][3] * p) / w;
  jet.dv = (part(2) - h[2][3] * p) / w;
  jet.duu = (part(3) - FT(FT(2) * h[1][3]) * jet.du - h[3][3] * p) / w;
  jet.duv = (part(4) - h[1][3] * jet.dv - h[2][3] * jet.du - h[4][3] * p) / w;
  jet.dvv = (part(5) - FT(FT(2) * h[2][3]) * jet.dv - h[5][3] * p) / w;
  return jet;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_RATIONAL_JET_H
