// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CORNER_PATCHES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CORNER_PATCHES_H

#include <CGAL/T_splines/Spline/internal/Catmull_clark_rules.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How the border turns inwards at a corner.
enum class Border_turn : char {
  CORNER, ///< its tangents on both sides are independent
  SLIT    ///< they are the same
};

/// The basis functions in the faces at a corner of the border that turns inwards: bicubic polynomials that depend on the
/// number k of its quarters alone.
///
/// Sector i, 0 <= i < k, is [0, 1]^2 in coordinates (s, t) along the spokes i and i + 1; spoke 0 and spoke k are on the
/// border, the corner is at (0, 0). The 6 k + 3 controls are those of the first two rings: 0, the corner; 1 + 2 i and
/// 2 + 2 i, the first and the second one along spoke i; then of each sector those at (1, 1), (2, 1), (1, 2), (2, 2).
///
/// All around, the surface is a uniform bicubic spline: its ends at the border are natural, which are those of the
/// subdivision of Catmull and Clark at a border (Biermann, Levin, Zorin, Piecewise smooth subdivision surfaces with
/// normal control, 2000), so that the border depends on its own control points only. A face at the corner goes on with
/// two derivatives from its neighbours on the two sides that are not spokes. This gives all of its Bezier coefficients
/// but one, and that is the corner's control point. So faces have the same curve along the spoke between them, and all
/// that is left is the tangent plane at the corner. There let the coefficients next to the corner on spoke i be p + t_i.
/// They are changed so that spokes are at the angles phi i in an affine image of a plane:
/// - at a corner, any angle between a half and a full turn, t_0 and t_k stay, and all others follow from them:
///   t_i = (sin (phi (k - i)) t_0 + sin (phi i) t_k) / sin (phi k). For k = 3, phi is a quarter turn: t_2 = -t_0 and
///   t_1 = -t_3, as in a plane without a quadrant; for k >= 4, phi k is seven eighths of a turn;
/// - at the end of a slit, as in a plane cut along a ray: phi = 2 pi / k, t_i = a cos (phi i) + b sin (phi i). The border
///   has the same tangent on both sides, the mean a of the two; b is the one closest to the t_i that there were.
///
/// Then faces shall join with a continuous tangent plane along spokes. Where phi is a quarter turn they do with equal
/// derivatives across, when the coefficients next to the corner on the diagonals are changed, too; of all changes that do
/// it is the smallest one. Elsewhere the derivatives across a spoke c(x) on both sides must have the sum l(x) c'(x),
/// where l = 2 cos phi at the corner; the face becomes 2 x 2 patches, l = (1 - x)^2 l(0) ends with the first one, and
/// c is quadratic there. Coefficients on and next to the other two sides stay: there the tangent planes stay continuous.
/// \tparam FT a model of `Field`; unless phi is a quarter turn, a floating point type
template <typename FT_>
class Corner_patches {
public:
  using FT = FT_;
  using Coefficients =
      std::array<FT, 16>; ///< of a bicubic Bezier patch, 4 j + i for Bernstein polynomials i, j in s, t

  /// Time O(k^2). \param number_of_sectors k >= 3
  Corner_patches(const int number_of_sectors, const Border_turn turn)
    : m_number_of_sectors(number_of_sectors),
      m_turn(turn),
      m_pieces(number_of_sectors == (turn == Border_turn::CORNER ? 3 : 4) ? 1 : 2)
  {
    CGAL_precondition(number_of_sectors >= 3);
    m_coefficients.resize(static_cast<std::size_t>(number_of_sectors) * m_pieces * m_pieces * number_of_controls());
    for (int control = 0; control < number_of_controls(); ++control)
      add_function(control);
  }

  int number_of_sectors() const { return m_number_of_sectors; }
  int number_of_controls() const { return 6 * m_number_of_sectors + 3; }

  /// 1 or 2: a face has so many patches in each direction, all of one size.
  int pieces_per_side() const { return m_pieces; }

  /// Which of them contains s or t.
  int piece(const FT& x) const { return m_pieces == 1 || FT(2) * x < FT(1) ? 0 : 1; }

  /// The coefficients of a basis function in one of the patches of a sector.
  const Coefficients& coefficients(const int sector, const int column, const int row, const int control) const
  {
    return m_coefficients[index(sector, column, row, control)];
  }

  /// Calls `f(control, jet)` for the functions that act in a sector: the value and derivatives up to `order` with respect
  /// to s and t, as `Function_jet` orders them.
  template <typename Function>
  void for_each_function(const int sector, const FT& s, const FT& t, const int order, const Function& f) const
  {
    const int column = piece(s), row = piece(t);
    const FT n(m_pieces);
    const Univariate a = bernstein(FT(n * s - FT(column)), n), b = bernstein(FT(n * t - FT(row)), n);
    for (int control = 0; control < number_of_controls(); ++control) {
      const Coefficients& c = coefficients(sector, column, row, control);
      std::array<FT, 6> jet{};
      for (int d = 0, k = 0; d <= order; ++d)
        for (int e = 0; e <= d; ++e, ++k)
          for (int j = 0; j < 4; ++j) {
            FT along(0);
            for (int i = 0; i < 4; ++i)
              along += a[d - e][i] * c[4 * j + i];
            jet[k] += b[e][j] * along;
          }
      f(control, jet);
    }
  }

private:
  using Univariate = std::array<std::array<FT, 4>, 3>; // Bernstein polynomials and their derivatives
  using Values = std::vector<FT>;                      // of all controls

  // Bezier coefficients of all patches of a face, those of common sides once: indices from 0 to 3 per piece.
  class Grid {
  public:
    explicit Grid(const int pieces) : m_size(3 * pieces + 1), m_values(m_size * m_size, FT(0)) {}
    FT& operator()(const int i, const int j) { return m_values[m_size * j + i]; }

  private:
    int m_size;
    std::vector<FT> m_values;
  };

  std::size_t index(const int sector, const int column, const int row, const int control) const
  {
    return static_cast<std::size_t>(((sector * m_pieces + row) * m_pieces + column) * number_of_controls() + control);
  }

  // With respect to a parameter that is `factor` times slower than x.
  static Univariate bernstein(const FT& x, const FT& factor)
  {
    const FT y = FT(1) - x, three = FT(3) * factor, six = FT(6) * factor * factor;
    return {{{FT(y * y * y), FT(FT(3) * x * y * y), FT(FT(3) * x * x * y), FT(x * x * x)},
             {FT(-three * y * y), FT(three * y * (y - FT(2) * x)), FT(three * x * (FT(2) * y - x)), FT(three * x * x)},
             {FT(six * y), FT(six * (x - FT(2) * y)), FT(six * (y - FT(2) * x)), FT(six * x)}}};
  }

  // All steps are linear in the values of the controls: one of them is 1.
  void add_function(const int control)
  {
    Values values(number_of_controls(), FT(0));
    values[control] = FT(1);
    std::vector<Grid> grids = continued(values);
    const std::vector<FT> shifts = tangent_shifts(grids);
    if (m_pieces == 2)
      for (Grid& grid : grids)
        grid = subdivided(grid);
    for (int spoke = 0; spoke <= m_number_of_sectors; ++spoke)
      shift_spoke(grids, spoke, FT(shifts[spoke] / FT(m_pieces)));
    shift_diagonals(grids);
    for (int sector = 0; sector < m_number_of_sectors; ++sector)
      for (int row = 0; row < m_pieces; ++row)
        for (int column = 0; column < m_pieces; ++column)
          for (int k = 0; k < 16; ++k)
            m_coefficients[index(sector, column, row, control)][k] = grids[sector](3 * column + k % 4, 3 * row + k / 4);
  }

  // The value at a node of the spline around a sector, beyond natural ends, too. -1 <= a, b <= 2, not both are -1
  FT node(const Values& values, const int sector, const int a, const int b) const
  {
    if (b < 0)
      return sector > 0 ? node(values, sector - 1, 1, a)
                        : FT(FT(2) * node(values, sector, a, 0) - node(values, sector, a, 1));
    if (a < 0)
      return sector + 1 < m_number_of_sectors ? node(values, sector + 1, b, 1)
                                              : FT(FT(2) * node(values, sector, 0, b) - node(values, sector, 1, b));
    if (a == 0 && b == 0)
      return values[0];
    if (a == 0 || b == 0)
      return values[a == 0 ? 2 + 2 * sector + b : 2 * sector + a];
    return values[3 + 2 * m_number_of_sectors + 4 * sector + 2 * (b - 1) + a - 1];
  }

  // The faces as they go on from their neighbours. For all but the corner this is the Bezier form of the spline.
  std::vector<Grid> continued(const Values& values) const
  {
    constexpr std::array<std::array<int, 4>, 4> weights{{{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}}};
    std::vector<Grid> result(m_number_of_sectors, Grid(1));
    for (int sector = 0; sector < m_number_of_sectors; ++sector) {
      Grid& grid = result[sector];
      grid(0, 0) = values[0];
      for (int k = 1; k < 16; ++k) {
        const int i = k % 4, j = k / 4;
        FT sum(0);
        for (int b = 0; b < 4; ++b)
          for (int a = 0; a < 4; ++a)
            if (const int weight = weights[i][a] * weights[j][b]; weight != 0)
              sum += FT(weight) * node(values, sector, a - 1, b - 1);
        grid(i, j) = sum / FT(36);
      }
    }
    return result;
  }

  // The coefficient on a spoke next to the corner, relative to this, is changed by so much.
  std::vector<FT> tangent_shifts(std::vector<Grid>& grids) const
  {
    const int k = m_number_of_sectors;
    std::vector<FT> tangents;
    for (int spoke = 0; spoke <= k; ++spoke)
      tangents.push_back(on_spoke(grids, spoke, 1) - grids[0](0, 0));
    std::vector<FT> result(k + 1, FT(0));
    if (m_turn == Border_turn::CORNER) {
      for (int spoke = 1; spoke < k; ++spoke)
        result[spoke] = (sine(k - spoke) * tangents[0] + sine(spoke) * tangents[k]) / sine(k) - tangents[spoke];
      return result;
    }
    const FT a = (tangents[0] + tangents[k]) / FT(2);
    FT b(0);
    for (int spoke = 1; spoke < k; ++spoke)
      b += tangents[spoke] * sine(spoke) * FT(2) / FT(k);
    for (int spoke = 0; spoke <= k; ++spoke)
      result[spoke] = a * cosine(spoke) + b * sine(spoke) - tangents[spoke];
    return result;
  }

  // Of phi i.
  FT cosine(const int i) const
  {
    if (m_pieces == 1)
      return FT(i % 2 == 1 ? 0 : i % 4 == 0 ? 1 : -1);
    return trigonometric(i, true);
  }
  FT sine(const int i) const
  {
    if (m_pieces == 1)
      return FT(i % 2 == 0 ? 0 : i % 4 == 1 ? 1 : -1);
    return trigonometric(i, false);
  }
  FT trigonometric(const int i, const bool is_cosine) const
  {
    const int m = m_turn == Border_turn::SLIT ? 2 * i : 7 * i,
              n = m_turn == Border_turn::SLIT ? m_number_of_sectors : 4 * m_number_of_sectors;
    if constexpr (std::is_floating_point<FT>::value)
      return is_cosine ? cosine_of_pi_times<FT>(m, n) : sine_of_pi_times<FT>(m, n);
    else
      CGAL_error_msg("corners of more than four quarters need a floating point type");
  }

  // Coefficient number j from the corner on.
  FT& on_spoke(std::vector<Grid>& grids, const int spoke, const int j) const
  {
    return spoke < m_number_of_sectors ? grids[spoke](j, 0) : grids[spoke - 1](0, j);
  }

  void set_on_spoke(std::vector<Grid>& grids, const int spoke, const int j, const FT& x) const
  {
    if (spoke < m_number_of_sectors)
      grids[spoke](j, 0) = x;
    if (spoke > 0)
      grids[spoke - 1](0, j) = x;
  }

  static Grid subdivided(Grid& grid)
  {
    const auto halves = [](const std::array<FT, 4>& c) {
      const FT two(2), x = (c[0] + c[1]) / two, y = (c[1] + c[2]) / two, z = (c[2] + c[3]) / two, p = (x + y) / two,
                       q = (y + z) / two;
      return std::array<FT, 7>{c[0], x, p, FT((p + q) / two), q, z, c[3]};
    };
    std::array<std::array<FT, 7>, 4> rows;
    for (int j = 0; j < 4; ++j)
      rows[j] = halves({grid(0, j), grid(1, j), grid(2, j), grid(3, j)});
    Grid result(2);
    for (int i = 0; i < 7; ++i) {
      const std::array<FT, 7> column = halves({rows[0][i], rows[1][i], rows[2][i], rows[3][i]});
      for (int j = 0; j < 7; ++j)
        result(i, j) = column[j];
    }
    return result;
  }

  void shift_spoke(std::vector<Grid>& grids, const int spoke, const FT& shift) const
  {
    const bool is_inside = spoke > 0 && spoke < m_number_of_sectors;
    if (m_pieces == 2 && is_inside)
      make_quadratic(grids, spoke, shift);
    set_on_spoke(grids, spoke, 1, FT(on_spoke(grids, spoke, 1) + shift));
    if (m_pieces == 1 || !is_inside)
      return;
    for (int j = 2; j <= 4; ++j) { // equal derivatives across
      FT &after = grids[spoke](j, 1), &before = grids[spoke - 1](1, j);
      const FT change = on_spoke(grids, spoke, j) - (after + before) / FT(2);
      after += change;
      before += change;
    }
  }

  // Moves coefficients 2, 3, and 4 so that the first piece of a spoke is quadratic when coefficient 1 is shifted, the
  // second piece goes on with the same derivative, and the sum of squares of the moves is smallest.
  void make_quadratic(std::vector<Grid>& grids, const int spoke, const FT& shift) const
  {
    std::array<FT, 5> q;
    for (int j = 0; j < 5; ++j)
      q[j] = on_spoke(grids, spoke, j);
    const FT third_difference = q[3] - FT(3) * q[2] + FT(3) * q[1] - q[0];
    const FT move = FT(13) / FT(35) * (FT(3) * shift + third_difference);
    q[2] += move;
    q[3] = FT(3) * (q[2] - q[1] - shift) + q[0];
    q[4] = FT(2) * q[3] - q[2];
    for (int j = 2; j < 5; ++j)
      set_on_spoke(grids, spoke, j, q[j]);
  }

  // The coefficients (1, 1), so that derivatives across each spoke fit together there.
  void shift_diagonals(std::vector<Grid>& grids) const
  {
    std::vector<FT> shifts(m_number_of_sectors, FT(0));
    FT excess(0); // along 1, -1, 1, ..., which changes nothing
    for (int spoke = 1; spoke < m_number_of_sectors; ++spoke) {
      const FT q0 = on_spoke(grids, spoke, 0), q1 = on_spoke(grids, spoke, 1), q3 = on_spoke(grids, spoke, 3);
      FT sum = FT(2) * q1;
      if (m_pieces == 2)
        sum += FT(2) * cosine(1) * (FT(2) * q3 - FT(3) * q1 + q0) / FT(9);
      shifts[spoke] = sum - grids[spoke](1, 1) - grids[spoke - 1](1, 1) - shifts[spoke - 1];
      excess += spoke % 2 == 0 ? shifts[spoke] : FT(-shifts[spoke]);
    }
    for (int sector = 0; sector < m_number_of_sectors; ++sector)
      grids[sector](1, 1) += shifts[sector] - (sector % 2 == 0 ? excess : FT(-excess)) / FT(m_number_of_sectors);
  }

  int m_number_of_sectors;
  Border_turn m_turn;
  int m_pieces;
  std::vector<Coefficients> m_coefficients;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CORNER_PATCHES_H
