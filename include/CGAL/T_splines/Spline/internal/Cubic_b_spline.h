// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CUBIC_B_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CUBIC_B_SPLINE_H

#include <CGAL/T_splines/T_mesh/support/Basis_knots.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <array>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Value, first and second derivative of a function of one variable.
template <typename FT>
using Univariate_jet = std::array<FT, 3>;

/// The cubic B-spline over five knots, as its polynomial pieces; at natural ends with the functions beyond.
///
/// Knots may coincide, up to four of them. Each piece is kept as the Taylor polynomial at a knot, the last one at the
/// last knot, so that the function has no round-off where it vanishes and is not negative anywhere. Knots coincide at a
/// border only: there the function goes on beyond its end, where nothing is but round-off; unless it is zero at the end.
///
/// Natural ends: with B_j the B-splines of the knots and their mirror images, and c_{-1} = 2 c_0 - c_1 at one where the
/// last vertex has the number 0, the functions of c_0 and c_1 are B_0 + 2 B_{-1} and B_1 - B_{-1}. The mirror makes the
/// first one 1, the second one 0 there. Between two natural ends with no vertex between them, both are linear.
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

  explicit Cubic_b_spline(const Axis_knots<FT>& knots) : Cubic_b_spline(knots.t)
  {
    const std::array<FT, 5>& t = knots.t;
    if (knots.is_peak) {
      const Cubic_b_spline left(knots.left_half()), right(knots.right_half());
      *this = left;
      for (int i = 2; i < 4; ++i) {
        m_pieces[i] = right.m_pieces[i];
        m_anchors[i] = right.m_anchors[i];
      }
      m_knots[3] = right.m_knots[3];
      m_knots[4] = right.m_knots[4];
      m_vanishes_after = right.m_vanishes_after;
      return;
    }
    if (knots.before == Natural_end::AT_VERTEX)
      end_before_vertex(t);
    if (knots.after == Natural_end::AT_VERTEX)
      end_after_vertex(t);
    if (knots.before == Natural_end::AT_NEXT_KNOT)
      end_before_next(t, knots.after == Natural_end::AT_VERTEX);
    if (knots.after == Natural_end::AT_NEXT_KNOT)
      end_after_next(t, knots.before == Natural_end::AT_VERTEX);
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
    const auto round_off = [this] { return knot_tolerance_between_faces(FT(m_knots[4] - m_knots[0])); };
    if (x < m_knots[0])
      return m_knots[0] < m_knots[1] || (m_vanishes_before && x < m_knots[0] - round_off());
    return m_knots[4] < x && (m_knots[3] < m_knots[4] || (m_vanishes_after && x > m_knots[4] + round_off()));
  }

  FT value(const FT& x) const
  {
    if (vanishes_at(x))
      return FT(0);
    const int i = piece(x);
    const FT y = x - m_knots[m_anchors[i]];
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
  // A natural end that is anchor number `anchor` of a piece: there the second derivative is zero.
  void set_piece_at_end(const int piece, const int anchor, const FT& value, const FT& slope, const FT& third)
  {
    m_pieces[piece] = {value, slope, FT(0), third};
    m_anchors[piece] = anchor;
  }

  void end_before_vertex(const std::array<FT, 5>& t)
  {
    const FT h = t[3] - t[2], square = FT(t[3] - t[0]) * FT(t[3] - t[1]);
    m_knots[0] = m_knots[1] = t[2];
    set_piece_at_end(2, 2, FT(1), FT(FT(-6) * h / square), FT(m_pieces[2][3] - FT(2) / FT(square * h)));
  }

  void end_after_vertex(const std::array<FT, 5>& t)
  {
    const FT h = t[2] - t[1], square = FT(t[3] - t[1]) * FT(t[4] - t[1]);
    m_knots[3] = m_knots[4] = t[2];
    set_piece_at_end(1, 2, FT(1), FT(FT(6) * h / square), FT(m_pieces[1][3] + FT(2) / FT(square * h)));
  }

  void end_before_next(const std::array<FT, 5>& t, const bool is_linear)
  {
    const FT h = t[2] - t[1], square = FT(t[2] - t[0]) * FT(h + FT(t[3] - t[1]));
    m_knots[0] = t[1];
    m_vanishes_before = true;
    if (is_linear)
      set_piece_at_end(1, 1, FT(0), FT(FT(1) / h), FT(0));
    else
      set_piece_at_end(1, 1, FT(0),
                       FT(FT(3) * FT(t[1] - t[0]) / FT(FT(t[2] - t[0]) * FT(t[3] - t[0])) + FT(3) * h / square),
                       FT(m_pieces[1][3] + FT(1) / FT(square * h)));
  }

  void end_after_next(const std::array<FT, 5>& t, const bool is_linear)
  {
    const FT h = t[3] - t[2], square = FT(t[4] - t[2]) * FT(h + FT(t[3] - t[1]));
    m_knots[4] = t[3];
    m_vanishes_after = true;
    if (is_linear)
      set_piece_at_end(2, 3, FT(0), FT(FT(-1) / h), FT(0));
    else
      set_piece_at_end(2, 3, FT(0),
                       FT(FT(-3) * FT(t[4] - t[3]) / FT(FT(t[4] - t[2]) * FT(t[4] - t[1])) - FT(3) * h / square),
                       FT(m_pieces[2][3] - FT(1) / FT(square * h)));
  }

  Univariate_jet<FT> jet_of_piece(const int i, const FT& x) const
  {
    const FT y = x - m_knots[m_anchors[i]];
    const std::array<FT, 4>& c = m_pieces[i];
    return {FT(FT(FT(c[3] * y + c[2]) * y + c[1]) * y + c[0]), FT(FT(FT(3) * c[3] * y + FT(2) * c[2]) * y + c[1]),
            FT(FT(6) * c[3] * y + FT(2) * c[2])};
  }

  std::array<FT, 5> m_knots{};
  std::array<std::array<FT, 4>, 4> m_pieces{};
  std::array<int, 4> m_anchors{{0, 1, 2, 4}};
  bool m_vanishes_before = false,
       m_vanishes_after = false; // beyond an end where it is zero, and there may be a surface
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CUBIC_B_SPLINE_H
