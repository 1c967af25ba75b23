// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_RULES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_RULES_H

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// computes cos(pi m / n), with the exact value where it is 0 or +-1, and the symmetries of the cosine exactly.
template <typename FT>
FT cosine_of_pi_times(std::int64_t m, const std::int64_t n)
{
  static_assert(std::is_floating_point<FT>::value, "cosines are not rational");
  m = ((m % (2 * n)) + 2 * n) % (2 * n);
  if (m > n)
    m = 2 * n - m;
  if (2 * m > n)
    return -cosine_of_pi_times<FT>(n - m, n);
  const FT pi = boost::math::constants::pi<FT>();
  return 4 * m > n ? std::sin(pi * FT(n - 2 * m) / FT(2 * n)) : std::cos(pi * FT(m) / FT(n));
}

/// computes sin(pi m / n), as exactly as `cosine_of_pi_times()`.
template <typename FT>
FT sine_of_pi_times(const std::int64_t m, const std::int64_t n)
{
  return cosine_of_pi_times<FT>(n - 2 * m, 2 * n);
}

/// computes the four segments of the uniform cubic B-spline, or their derivatives.
/// \param x in [0, 1], where all four values are sums of non-negative terms
/// \param derivative 0, 1, 2 or 3
template <typename FT>
std::array<FT, 4> uniform_cubic_segments(const FT& x, const int derivative)
{
  CGAL_precondition(derivative >= 0 && derivative <= 3);
  const FT y = FT(1) - x;
  switch (derivative) {
  case 0: {
    const FT a = FT(1) + x * y;
    return {FT(y * y * y / FT(6)), FT((FT(1) + FT(3) * y * a) / FT(6)), FT((FT(1) + FT(3) * x * a) / FT(6)),
            FT(x * x * x / FT(6))};
  }
  case 1:
    return {FT(-(y * y) / FT(2)), FT(x * (FT(3) * x - FT(4)) / FT(2)), FT(y * (FT(4) - FT(3) * y) / FT(2)),
            FT(x * x / FT(2))};
  case 2: return {y, FT(FT(3) * x - FT(2)), FT(FT(3) * y - FT(2)), x};
  default: return {FT(-1), FT(3), FT(-3), FT(1)};
  }
}

/// The monomials X^i Y^j, i, j <= 3, and their derivatives at a point of [0, 1]^2, where X and Y are the coordinates
/// relative to the center.
///
/// Derivatives of a bicubic patch from its centered coefficients lose no digits to differences of controls.
template <typename FT>
class Centered_monomials {
public:
  using Coefficients = std::array<FT, 16>; ///< 4j + i for X^i Y^j
  using Derivatives = std::array<FT, 6>;   ///< the value, d/dx, d/dy, d2/dx2, d2/dxdy and d2/dy2

  /// \param order of the highest derivatives, at most 2
  Centered_monomials(const FT x, const FT y, const int order)
    : m_order(order),
      m_x(univariate(x - FT(1) / 2)),
      m_y(univariate(y - FT(1) / 2))
  {
    CGAL_precondition(order >= 0 && order <= 2);
  }

  /// computes the centered coefficients from those of the uniform cubic B-splines.
  static Coefficients coefficients(const std::array<FT, 16>& controls)
  {
    Coefficients result{};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const std::array<FT, 4> a = uniform_cubic_segments(FT(1) / 2, i), b = uniform_cubic_segments(FT(1) / 2, j);
        for (int k = 0; k < 16; ++k)
          result[4 * j + i] += a[k % 4] * b[k / 4] * controls[k];
        result[4 * j + i] /= (i < 2 ? 1 : i == 2 ? 2 : 6) * (j < 2 ? 1 : j == 2 ? 2 : 6);
      }
    return result;
  }

  /// computes the derivatives up to the order; the others are 0.
  Derivatives derivatives(const Coefficients& coefficients) const
  {
    Derivatives result{};
    std::array<std::array<FT, 4>, 3> rows{};
    for (int d = 0; d <= m_order; ++d)
      for (int j = 0; j < 4; ++j)
        for (int i = d; i < 4; ++i)
          rows[d][j] += coefficients[4 * j + i] * m_x[d][i];
    for (int d = 0, k = 0; d <= m_order; ++d)
      for (int e = 0; e <= d; ++e, ++k)
        for (int j = e; j < 4; ++j)
          result[k] += rows[d - e][j] * m_y[e][j];
    return result;
  }

private:
  using Univariate = std::array<std::array<FT, 4>, 3>;

  static Univariate univariate(const FT x)
  {
    return {{{FT(1), x, x * x, x * x * x}, {FT(0), FT(1), 2 * x, 3 * x * x}, {FT(0), FT(0), FT(2), 6 * x}}};
  }

  int m_order;
  Univariate m_x, m_y;
};

/// The subdivision rules of Catmull and Clark around a quad face with one extraordinary vertex (Stam, Exact evaluation
/// of Catmull-Clark subdivision surfaces at arbitrary parameter values, 1998).
///
/// The face is [0, 1]^2 in coordinates (s, t), the extraordinary vertex is at (0, 0), its valence is n. The K = 2n + 8
/// controls are: 0, the extraordinary vertex; 1 + 2i, its neighbour e_i on spoke i; 2 + 2i, the vertex f_i opposite to
/// it in sector i between the spokes i and i + 1, for i = 0, ..., n - 1 counter-clockwise; and 2n + 1, ..., 2n + 7, the
/// outer vertices at (2,-1), (2,0), (2,1), (2,2), (1,2), (0,2), (-1,2). The face is sector 0, e_0 is at (1, 0), e_1 at
/// (0, 1); (2,-1) and (-1,2) lie over the neighbouring sectors.
///
/// At level k >= 1 the three regular parts of the face cover [0, 2^-(k-1)]^2 without [0, 2^-k]^2: part 0 has the larger
/// s, part 1 both the larger s and t, part 2 the larger t. The 16 controls of a part are ordered 4j + i for the
/// position (i - 1, j - 1) relative to its lower left vertex.
///
/// At vertices of valence 1 or 2 the vertex goes to the centre of the new face points instead. Then the limit surface
/// has a tangent plane at valence 2: the subdominant eigenvalue is 1/4, twice, with the eigenvectors e_0 - e_1 and f_0
/// - f_1, and all others are smaller. At valence 1 it is continuous.
/// \tparam FT a model of `Field`; with an exact type all weights are exact
template <typename FT_>
class Catmull_clark_subdivision {
public:
  using FT = FT_;

  struct Entry {
    int index; ///< of the control
    FT weight;
  };
  using Row = std::vector<Entry>; ///< an affine combination of controls, without zeros and without order

  static constexpr int number_of_parts = 3;

  /// computes the rules. Linear in the valence.
  /// \param valence n >= 1
  explicit Catmull_clark_subdivision(const int valence) : m_valence(valence)
  {
    CGAL_precondition(valence >= 1);
    m_step.reserve(static_cast<std::size_t>(number_of_controls()));
    m_step.push_back(vertex_row());
    for (int i = 0; i < valence; ++i) {
      m_step.push_back(edge_row(i));
      m_step.push_back(face_row(i));
    }
    for (const std::array<int, 2>& position : outer_positions())
      m_step.push_back(regular_row(position[0], position[1]));
    for (int part = 0; part < number_of_parts; ++part)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
          m_parts[part][4 * j + i] = refined_row(i - (part == 2), j - (part == 0));
  }

  int valence() const { return m_valence; }
  int number_of_controls() const { return 2 * m_valence + 8; }

  int spoke(const int i) const { return 1 + 2 * wrapped(i); }    ///< the index of e_i, for any integer i
  int diagonal(const int i) const { return 2 + 2 * wrapped(i); } ///< the index of f_i, for any integer i
  int outer(const int i) const { return 2 * m_valence + 1 + i; } ///< the index of the i-th outer vertex, from 0

  /// returns the index of the control at (i, j) in the frame of the face, continued over the neighbouring sectors.
  /// \param i, j in {-1, 0, 1, 2}; both are -1 only if the valence is 4
  int control_at(const int i, const int j) const
  {
    CGAL_precondition(i >= -1 && i <= 2 && j >= -1 && j <= 2 && (i >= 0 || j >= 0 || m_valence == 4));
    if (i == 2)
      return outer(j + 1);
    if (j == 2)
      return outer(5 - i);
    if (i == 1)
      return j == 0 ? spoke(0) : diagonal(j == 1 ? 0 : -1);
    if (i == 0)
      return j == 0 ? 0 : spoke(j);
    return j == 0 ? spoke(2) : diagonal(j == 1 ? 1 : 2);
  }

  /// returns the rows of the matrix that maps the controls to those of the smaller face at the vertex.
  const std::vector<Row>& step() const { return m_step; }

  /// returns the rows of the matrix that maps the controls to those of a part at level 1.
  const std::array<Row, 16>& part(const int i) const { return m_parts[i]; }

  /// computes the combination of `values` that `row` stands for.
  /// \tparam Value has `+`, and `*` with an `FT` on the right
  template <typename Value>
  static Value combination(const Row& row, const std::vector<Value>& values)
  {
    Value sum = values[row.front().index] * row.front().weight;
    for (std::size_t i = 1; i < row.size(); ++i)
      sum = sum + values[row[i].index] * row[i].weight;
    return sum;
  }

  /// computes the controls of the smaller face [0, 1/2]^2. Linear in the valence.
  template <typename Value>
  std::vector<Value> subdivided(const std::vector<Value>& controls) const
  {
    CGAL_precondition(controls.size() == m_step.size());
    std::vector<Value> result;
    result.reserve(controls.size());
    for (const Row& row : m_step)
      result.push_back(combination(row, controls));
    return result;
  }

  /// computes the 16 uniform B-spline coefficients of a part of the face, by repeated subdivision: time O(K level).
  /// \param level k >= 1
  /// \param part in {0, 1, 2}
  template <typename Value>
  std::vector<Value> part_controls(std::vector<Value> controls, const int level, const int part) const
  {
    CGAL_precondition(level >= 1 && part >= 0 && part < number_of_parts);
    for (int k = 1; k < level; ++k)
      controls = subdivided(controls);
    std::vector<Value> result;
    result.reserve(16);
    for (const Row& row : m_parts[part])
      result.push_back(combination(row, controls));
    return result;
  }

  /// computes the weights of the controls in the limit position of the extraordinary vertex: the left eigenvector of
  /// the eigenvalue 1 (Halstead, Kass, DeRose, Efficient, fair interpolation using Catmull-Clark surfaces, 1993).
  std::vector<FT> limit_weights() const
  {
    const FT n(m_valence), sum = n * (n + FT(5));
    std::vector<FT> weights(m_step.size(), FT(0));
    if (m_valence < 3) {
      weights[0] = FT(5) / FT(16);
      for (int i = 0; i < m_valence; ++i) {
        weights[spoke(i)] = FT(1) / (FT(2) * n);
        weights[diagonal(i)] = FT(3) / (FT(16) * n);
      }
      return weights;
    }
    weights[0] = n * n / sum;
    for (int i = 0; i < m_valence; ++i) {
      weights[spoke(i)] = FT(4) / sum;
      weights[diagonal(i)] = FT(1) / sum;
    }
    return weights;
  }

  /// computes the weights of the controls in two vectors that span the tangent plane at the extraordinary vertex: left
  /// eigenvectors of the subdominant eigenvalue (Halstead, Kass, DeRose, 1993).
  ///
  /// The cross product of the first vector with the second one points to the side from which the sectors appear
  /// counter-clockwise.
  /// \pre `FT` is a floating point type
  std::pair<std::vector<FT>, std::vector<FT>> tangent_weights() const
  {
    const FT h = cosine_of_pi_times<FT>(1, m_valence), u = h + std::sqrt(h * h + FT(4));
    std::pair<std::vector<FT>, std::vector<FT>> weights;
    weights.first.assign(m_step.size(), FT(0));
    weights.second.assign(m_step.size(), FT(0));
    for (int i = 0; i < m_valence; ++i) {
      weights.first[spoke(i)] = u * cosine_of_pi_times<FT>(2 * i, m_valence);
      weights.second[spoke(i)] = u * sine_of_pi_times<FT>(2 * i, m_valence);
      weights.first[diagonal(i)] = cosine_of_pi_times<FT>(2 * i + 1, m_valence);
      weights.second[diagonal(i)] = sine_of_pi_times<FT>(2 * i + 1, m_valence);
    }
    return weights;
  }

private:
  static std::array<std::array<int, 2>, 7> outer_positions()
  {
    return {{{2, -1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {-1, 2}}};
  }

  int wrapped(const int i) const { return ((i % m_valence) + m_valence) % m_valence; }

  static FT fraction(const int numerator, const int denominator) { return FT(numerator) / FT(denominator); }

  // Of the valences 1 and 2, the rule of Catmull and Clark makes the weight of the vertex negative, or an eigenvalue of
  // the rotation-invariant modes as large as the subdominant one. The centre of the new face points does neither.
  Row vertex_row() const
  {
    const FT n(m_valence);
    if (m_valence < 3) {
      Row row{{0, FT(FT(1) / FT(4))}};
      for (int i = 0; i < m_valence; ++i) {
        row.push_back({spoke(i), FT(FT(1) / (FT(2) * n))});
        row.push_back({diagonal(i), FT(FT(1) / (FT(4) * n))});
      }
      return row;
    }
    Row row{{0, FT(FT(1) - FT(7) / (FT(4) * n))}};
    for (int i = 0; i < m_valence; ++i) {
      row.push_back({spoke(i), FT(FT(3) / (FT(2) * n * n))});
      row.push_back({diagonal(i), FT(FT(1) / (FT(4) * n * n))});
    }
    return row;
  }

  Row edge_row(const int i) const
  {
    const FT a = fraction(3, 8), b = fraction(1, 16);
    return {{0, a}, {spoke(i), a}, {spoke(i - 1), b}, {spoke(i + 1), b}, {diagonal(i - 1), b}, {diagonal(i), b}};
  }

  Row face_row(const int i) const
  {
    const FT a = fraction(1, 4);
    return {{0, a}, {spoke(i), a}, {spoke(i + 1), a}, {diagonal(i), a}};
  }

  /// The refined vertex at (i / 2, j / 2), where the mesh around it is regular.
  Row regular_row(const int i, const int j) const
  {
    Row row;
    for (const std::array<int, 2>& b : stencil(j))
      for (const std::array<int, 2>& a : stencil(i))
        if (a[1] * b[1] != 0)
          row.push_back({control_at(a[0], b[0]), fraction(a[1] * b[1], 64)});
    return row;
  }

  /// The positions and the weights, times 8, that refine uniform cubic B-splines at i / 2.
  static std::array<std::array<int, 2>, 3> stencil(const int i)
  {
    const int a = (i + 2) / 2 - 1; // i >= -2: rounded down
    if (i % 2 == 0)
      return {{{a - 1, 1}, {a, 6}, {a + 1, 1}}};
    return {{{a, 4}, {a + 1, 4}, {a, 0}}};
  }

  Row refined_row(const int i, const int j) const
  {
    return i <= 1 && j <= 1 ? m_step[control_at(i, j)] : regular_row(i, j);
  }

  int m_valence;
  std::vector<Row> m_step;
  std::array<std::array<Row, 16>, number_of_parts> m_parts;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CATMULL_CLARK_RULES_H
