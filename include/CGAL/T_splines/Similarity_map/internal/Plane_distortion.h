// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PLANE_DISTORTION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PLANE_DISTORTION_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A linear map of the plane, by rows.
struct Plane_matrix {
  double a = 1, b = 0, c = 0, d = 1;

  double determinant() const { return a * d - b * c; }
  double squared_norm() const { return a * a + b * b + c * c + d * d; }
  Plane_matrix operator*(const Plane_matrix& o) const
  {
    return {a * o.a + b * o.c, a * o.b + b * o.d, c * o.a + d * o.c, c * o.b + d * o.d};
  }
  Plane_matrix inverse() const
  {
    const double f = 1 / determinant();
    return {d * f, -b * f, -c * f, a * f};
  }
  std::array<double, 4> entries() const { return {{a, b, c, d}}; }

  /// The angle of the rotation that is nearest.
  double rotation() const { return std::atan2(c - b, a + d); }

  static Plane_matrix rotation_by(const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c, -s, s, c};
  }
};

/// How a linear map F of the plane deviates from the identity: |F - I|^2 + w (|F|^2 + |F^-1|^2 - 4), the second part being
/// the symmetric Dirichlet energy, which grows beyond all bounds before F turns over.
struct Plane_distortion {
  double weight; ///< w

  /// Infinite if F turns the plane over.
  double value(const Plane_matrix& f) const
  {
    const double determinant = f.determinant();
    if (!(determinant > 0))
      return std::numeric_limits<double>::infinity();
    const double norm = f.squared_norm();
    return norm - 2 * (f.a + f.d) + 2 + weight * (norm * (1 + 1 / (determinant * determinant)) - 4);
  }

  /// The derivatives by the entries of F, and the second ones without their negative part: by the eigensystem in terms of
  /// the singular values (Smith, de Goes, Kim, Analytic eigensystems for isotropic distortion energies, 2019).
  /// \pre F does not turn the plane over
  void derivatives(const Plane_matrix& f, std::array<double, 4>& first,
                   std::array<std::array<double, 4>, 4>& second) const
  {
    // Blinn's singular values: F = R(left) diag(s, t) R(right).
    const double e = (f.a + f.d) / 2, g = (f.a - f.d) / 2, h = (f.c + f.b) / 2, k = (f.c - f.b) / 2;
    const double q = std::hypot(e, k), r = std::hypot(g, h), s = q + r, t = f.determinant() / s;
    const double angle = std::atan2(h, g), turn = std::atan2(k, e);
    const Plane_matrix left = Plane_matrix::rotation_by((turn + angle) / 2),
                       right = Plane_matrix::rotation_by((turn - angle) / 2);
    const auto in_frame = [&](const Plane_matrix& m) { return (left * m * right).entries(); };
    const double half = std::sqrt(0.5), st = s * t, cube = st * st * st;
    const std::array<std::array<double, 4>, 4> mode = {
        {in_frame({1, 0, 0, 0}), in_frame({0, 0, 0, 1}), in_frame({0, half, half, 0}), in_frame({0, -half, half, 0})}};
    const std::array<double, 4> curvature = {{2 + weight * (2 + 6 / (s * s * s * s)),
                                              2 + weight * (2 + 6 / (t * t * t * t)),
                                              2 + weight * (2 + 2 * (s * s + st + t * t) / cube),
                                              (std::max)(2 + weight * (2 - 2 * (s * s - st + t * t) / cube), 0.)}};
    const double by_s = weight * (2 * s - 2 / (s * s * s)), by_t = weight * (2 * t - 2 / (t * t * t));
    const std::array<double, 4> entries = f.entries(), identity = {{1, 0, 0, 1}};
    for (int i = 0; i < 4; ++i) {
      first[i] = 2 * (entries[i] - identity[i]) + by_s * mode[0][i] + by_t * mode[1][i];
      for (int j = 0; j < 4; ++j) {
        second[i][j] = 0;
        for (int m = 0; m < 4; ++m)
          second[i][j] += curvature[m] * mode[m][i] * mode[m][j];
      }
    }
  }

  /// The symmetric Dirichlet energy, less that of isometries: 0 for these.
  static double symmetric_dirichlet(const Plane_matrix& f)
  {
    const double determinant = f.determinant();
    return f.squared_norm() * (1 + 1 / (determinant * determinant)) - 4;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PLANE_DISTORTION_H
