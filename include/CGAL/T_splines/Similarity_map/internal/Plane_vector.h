// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PLANE_VECTOR_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PLANE_VECTOR_H

namespace CGAL {
namespace T_splines {
namespace internal {

/// A point or vector of the plane with few operations and no kernel, over any field; also the complex number u + i v,
/// of which the linear parts of similarities are made.
template <typename FT>
struct Plane_vector {
  FT u = FT(0), v = FT(0);

  Plane_vector operator+(const Plane_vector& o) const { return {FT(u + o.u), FT(v + o.v)}; }
  Plane_vector operator-(const Plane_vector& o) const { return {FT(u - o.u), FT(v - o.v)}; }
  Plane_vector operator-() const { return {FT(-u), FT(-v)}; }
  Plane_vector operator*(const FT& s) const { return {FT(u * s), FT(v * s)}; }
  FT cross(const Plane_vector& o) const { return u * o.v - v * o.u; }
  FT dot(const Plane_vector& o) const { return u * o.u + v * o.v; }
  bool is_zero() const { return u == FT(0) && v == FT(0); }

  /// The vector turned counter-clockwise by `r` quarter turns, r in {0, 1, 2, 3}: the product with i^r.
  Plane_vector turned(const int r) const
  {
    switch (r) {
    case 0: return *this;
    case 1: return {FT(-v), u};
    case 2: return {FT(-u), FT(-v)};
    default: return {v, FT(-u)};
    }
  }

  /// The product of complex numbers.
  Plane_vector operator*(const Plane_vector& o) const { return {FT(u * o.u - v * o.v), FT(u * o.v + v * o.u)}; }
  Plane_vector conjugate() const { return {u, FT(-v)}; }
  FT squared_norm() const { return dot(*this); }

  /// \pre The number is not zero.
  Plane_vector inverse() const { return conjugate() * FT(FT(1) / squared_norm()); }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PLANE_VECTOR_H
