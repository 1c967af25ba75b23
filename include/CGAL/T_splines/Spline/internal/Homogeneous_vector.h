// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_HOMOGENEOUS_VECTOR_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_HOMOGENEOUS_VECTOR_H

#include <array>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Four homogeneous coordinates (w x, w y, w z, w) that can be combined linearly.
template <typename FT>
struct Homogeneous_vector {
  std::array<FT, 4> values;

  friend Homogeneous_vector operator+(const Homogeneous_vector& a, const Homogeneous_vector& b)
  {
    return {{FT(a.values[0] + b.values[0]), FT(a.values[1] + b.values[1]), FT(a.values[2] + b.values[2]),
             FT(a.values[3] + b.values[3])}};
  }
  friend Homogeneous_vector operator*(const Homogeneous_vector& a, const FT& x)
  {
    return {{FT(a.values[0] * x), FT(a.values[1] * x), FT(a.values[2] * x), FT(a.values[3] * x)}};
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_HOMOGENEOUS_VECTOR_H
