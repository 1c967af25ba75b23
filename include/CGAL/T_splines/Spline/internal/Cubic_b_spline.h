// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CUBIC_B_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CUBIC_B_SPLINE_H

#include <array>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Value, first and second derivative of a function of one variable.
template <typename FT>
using Univariate_jet = std::array<FT, 3>;

/// The cubic B-spline over five knots, as its polynomial pieces.
///
/// Knots may coincide, up to four of them. Each piece is kept as the Taylor polynomial at a knot, the last one at the
/// last knot, so that the function has no round-off where it vanishes and is not negative anywhere. Knots coincide at a
/// border only: there the function goes on beyond its end, where nothing is but round-off.
template <typename FT>
class Cubic_b_spline {
public:
  Cubic_b_spline() = default;

  /// \param t increasing, not all equal
  explicit Cubic_b_spline(const std::array<FT, 5>& t) : m_knots(t)
  {
    const FT zero(0), two(2);
    if (t[0] < t[1])
      m_pieces[0] = {zero, zero, zero, FT(1) / FT((t[1] - t[0]) * (t[2] - t[0]) * (t[3] - t[0]))};
    if (t[1] < t[2]) {
      const FT a = FT(1) / FT((t[3] - t[0]) * (t[2] - t[0]) * (t[2] - t[1])), // of (x - t0)^2 (t2 - x)
          b = FT(1) / FT((t[3] - t[0]) * (t[3] - t[1]) * (t[2] - t[1])),      // of (x - t0) (x - t1) (t3 - x)
          c = FT(1) / FT((t[4] - t[1]) * (t[3] - t[1]) * (t[2] - t[1]));      // of (x - t1)^2 (t4 - x)
      const FT p = t[1] - t[0], q = t[2] - t[1], r = t[3] - t[1], s = t[4] - t[1];
      m_pieces[1] = {FT(a * p * p * q), FT(a * p * (two * q - p) + b * p * r),
                     FT(a * (q - two * p) + b * (r - p) + c * s), FT(-(a + b + c))};
    }
    if (t[2] < t[3]) {
      const FT a = FT(1) / FT((t[4] - t[1]) * (t[4] - t[2]) * (t[3] - t[2])), // of (t4 - x)^2 (x - t2)
          b = FT(1) / FT((t[4] - t[1]) * (t[3] - t[1]) * (t[3] - t[2])),      // of (t4 - x) (t3 - x) (x - t1)
          c = FT(1) / FT((t[3] - t[0]) * (t[3] - t[1]) * (t[3] - t[2]));      // of (t3 - x)^2 (x - t0)
      const FT p = t[2] - t[0], q = t[2] - t[1], r = t[3] - t[2], s = t[4] - t[2];
      m_pieces[2] = {FT(b * s * r * q + c * r * r * p),
                     FT(a * s * s + b * (s * r - q * (s + r)) + c * r * (r - two * p)),
                     FT(-two * a * s + b * (q - s - r) + c * (p - two * r)), FT(a + b + c)};
    }
    if (t[3] < t[4])
      m_pieces[3] = {zero, zero, zero, FT(-1) / FT((t[4] - t[3]) * (t[4] - t[2]) * (t[4] - t[1]))};
  }

  /// The function times a factor.
  friend Cubic_b_spline operator*(const FT& factor, Cubic_b_spline b)
  {
    for (std::array<FT, 4>& piece : b.m_pieces)
      for (FT& c : piece)
        c *= factor;
    return b;
  }

  const std::array<FT, 5>& knots() const { return m_knots; }

  /// The largest i with t_i <= x of a piece that is not empty; before the first knot, the first such piece.
  int piece(const FT& x) const
  {
    int i = 3;
    while (i > 0 && (x < m_knots[i] || !(m_knots[i] < m_knots[i + 1])))
      --i;
    while (!(m_knots[i] < m_knots[i + 1]))
      ++i;
    return i;
  }

  bool vanishes_at(const FT& x) const
  {
    return (x < m_knots[0] && m_knots[0] < m_knots[1]) || (m_knots[4] < x && m_knots[3] < m_knots[4]);
  }

  FT value(const FT& x) const
  {
    if (vanishes_at(x))
      return FT(0);
    const int i = piece(x);
    const FT y = x - m_knots[anchor(i)];
    const std::array<FT, 4>& c = m_pieces[i];
    return FT(FT(FT(c[3] * y + c[2]) * y + c[1]) * y + c[0]);
  }

  Univariate_jet<FT> jet(const FT& x) const
  {
    if (vanishes_at(x))
      return {FT(0), FT(0), FT(0)};
    return jet_of_piece(piece(x), x);
  }

  /// The Bernstein coefficients on [a, b], which lies between two successive knots.
  std::array<FT, 4> bernstein_coefficients(const FT& a, const FT& b) const
  {
    const FT middle = (a + b) / FT(2), h = b - a;
    if (vanishes_at(middle))
      return {FT(0), FT(0), FT(0), FT(0)};
    const int i = piece(middle);
    const Univariate_jet<FT> j = jet_of_piece(i, a), k = jet_of_piece(i, b);
    return {j[0], FT(j[0] + h * j[1] / FT(3)), FT(k[0] - h * k[1] / FT(3)), k[0]};
  }

private:
  static int anchor(const int piece) { return piece < 3 ? piece : 4; }

  Univariate_jet<FT> jet_of_piece(const int i, const FT& x) const
  {
    const FT y = x - m_knots[anchor(i)];
    const std::array<FT, 4>& c = m_pieces[i];
    return {FT(FT(FT(c[3] * y + c[2]) * y + c[1]) * y + c[0]), FT(FT(FT(3) * c[3] * y + FT(2) * c[2]) * y + c[1]),
            FT(FT(6) * c[3] * y + FT(2) * c[2])};
  }

  std::array<FT, 5> m_knots{};
  std::array<std::array<FT, 4>, 4> m_pieces{};
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CUBIC_B_SPLINE_H
