// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_2_H
#define CGAL_T_SPLINES_SIMILARITY_2_H

#include <CGAL/assertions.h>

#include <utility>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// The similarity x -> s R^r x + t of the plane, R the counter-clockwise rotation by a quarter turn: the transition
/// between two charts of a seamless similarity map ([CZ17] section 2.1).
///
/// With an exact number type all its operations are exact.
/// \tparam FT a model of `Field`.
template <typename FT_>
class Similarity_2 {
public:
  using FT = FT_; ///< number type of the coefficients

  /// The identity.
  Similarity_2() : Similarity_2(0, FT(1), FT(0), FT(0)) {}

  /// \param quarter_turns any integer; taken modulo 4
  /// \param scale s > 0
  /// \param u, v the translation t
  Similarity_2(const int quarter_turns, FT scale, FT u, FT v)
    : m_quarter_turns(((quarter_turns % 4) + 4) % 4),
      m_scale(std::move(scale)),
      m_u(std::move(u)),
      m_v(std::move(v))
  {
    CGAL_precondition(m_scale > FT(0));
  }

  int quarter_turns() const { return m_quarter_turns; } ///< r in {0, 1, 2, 3}
  const FT& scale() const { return m_scale; }           ///< s
  const FT& u() const { return m_u; }                   ///< first coordinate of t
  const FT& v() const { return m_v; }                   ///< second coordinate of t

  /// applies the map to the point (u, v).
  std::pair<FT, FT> operator()(const FT& u, const FT& v) const
  {
    std::pair<FT, FT> image = linear(u, v);
    image.first += m_u;
    image.second += m_v;
    return image;
  }

  /// applies the map to a point with coordinates `x()` and `y()`.
  template <typename Point_2>
  Point_2 operator()(const Point_2& p) const
  {
    const std::pair<FT, FT> image = (*this)(FT(p.x()), FT(p.y()));
    return Point_2(image.first, image.second);
  }

  /// returns the inverse map.
  Similarity_2 inverse() const
  {
    Similarity_2 result(-m_quarter_turns, FT(1) / m_scale, FT(0), FT(0));
    const std::pair<FT, FT> t = result.linear(m_u, m_v);
    result.m_u = -t.first;
    result.m_v = -t.second;
    return result;
  }

  /// returns whether the map moves no point.
  bool is_identity() const { return m_quarter_turns == 0 && m_scale == FT(1) && m_u == FT(0) && m_v == FT(0); }

  /// returns whether both maps have equal coefficients.
  friend bool operator==(const Similarity_2& a, const Similarity_2& b)
  {
    return a.m_quarter_turns == b.m_quarter_turns && a.m_scale == b.m_scale && a.m_u == b.m_u && a.m_v == b.m_v;
  }
  /// returns whether a coefficient differs.
  friend bool operator!=(const Similarity_2& a, const Similarity_2& b) { return !(a == b); }

  /// returns the map "first `b`, then `a`".
  friend Similarity_2 compose(const Similarity_2& a, const Similarity_2& b)
  {
    const std::pair<FT, FT> t = a(b.m_u, b.m_v);
    return Similarity_2(a.m_quarter_turns + b.m_quarter_turns, a.m_scale * b.m_scale, t.first, t.second);
  }

private:
  std::pair<FT, FT> linear(const FT& u, const FT& v) const
  {
    switch (m_quarter_turns) {
    case 0: return {scaled(u), scaled(v)};
    case 1: return {-scaled(v), scaled(u)};
    case 2: return {-scaled(u), -scaled(v)};
    default: return {scaled(v), -scaled(u)};
    }
  }
  FT scaled(const FT& x) const { return m_scale == FT(1) ? x : FT(m_scale * x); } // exact numbers multiply slowly

  int m_quarter_turns;
  FT m_scale, m_u, m_v;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_2_H
