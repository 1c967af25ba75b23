// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_GAUSSIAN_NUMBER_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_GAUSSIAN_NUMBER_H

namespace CGAL {
namespace T_splines {
namespace internal {

/// The complex number re + i im over any field, for points of the plane and the linear parts of similarities.
template <typename FT>
struct Gaussian_number {
  FT re = FT(0), im = FT(0);

  Gaussian_number operator+(const Gaussian_number& o) const { return {FT(re + o.re), FT(im + o.im)}; }
  Gaussian_number operator-(const Gaussian_number& o) const { return {FT(re - o.re), FT(im - o.im)}; }
  Gaussian_number operator-() const { return {FT(-re), FT(-im)}; }
  Gaussian_number operator*(const FT& s) const { return {FT(re * s), FT(im * s)}; }
  Gaussian_number operator*(const Gaussian_number& o) const
  {
    return {FT(re * o.re - im * o.im), FT(re * o.im + im * o.re)};
  }
  Gaussian_number conjugate() const { return {re, FT(-im)}; }
  FT squared_norm() const { return FT(re * re + im * im); }

  /// \pre The number is not zero.
  Gaussian_number inverse() const { return conjugate() * FT(FT(1) / squared_norm()); }

  /// The product with i^r, r in {0, 1, 2, 3}.
  Gaussian_number turned(const int r) const
  {
    switch (r) {
    case 0: return *this;
    case 1: return {FT(-im), re};
    case 2: return {FT(-re), FT(-im)};
    default: return {im, FT(-re)};
    }
  }

  bool is_zero() const { return re == FT(0) && im == FT(0); }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_GAUSSIAN_NUMBER_H
