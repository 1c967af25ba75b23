// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_TRIANGLE_SAMPLES_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_TRIANGLE_SAMPLES_H

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Chooses points inside of triangles, of a given density on the whole surface.
///
/// A triangle of area A gets A / spacing^2 points, rounded down or up in such a way that fans and strips of many
/// needles get their share, and none at all if its corners are close enough to each other already. It is cut into as
/// many pieces of equal area, again and again through the longest edge: so the pieces become round, whatever the
/// triangle is. Each gives its centroid; or if it is still long, which is so where the triangle is thinner than the
/// spacing, a point that differs from triangle to triangle: the centroids of a fan of needles would all lie on one
/// circle.
class Triangle_samples {
public:
  using Barycentric_coordinates = std::array<double, 3>;

  /// \param spacing the side of the square that a point stands for; 0 for no points
  explicit Triangle_samples(const double spacing) : m_squared_spacing(spacing * spacing) {}

  /// Finds the points of the next triangle. \param squared_lengths of the edges opposite to its corners
  const std::vector<Barycentric_coordinates>& points(const std::array<double, 3>& squared_lengths, const double area)
  {
    m_points.clear();
    m_squared_lengths = squared_lengths;
    constexpr double close_enough = 1.5;
    if (!(longest(squared_lengths) > close_enough * close_enough * m_squared_spacing && m_squared_spacing > 0))
      return m_points;
    const double rounding = element_of_sequence(++m_large_triangles)[0];
    const std::size_t number = static_cast<std::size_t>(area / m_squared_spacing + rounding);
    m_points.reserve(number);
    if (number > 0)
      cut({{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}, number);
    return m_points;
  }

private:
  using Piece = std::array<Barycentric_coordinates, 3>;

  static double longest(const std::array<double, 3>& lengths) { return lengths[longest_index(lengths)]; }
  static int longest_index(const std::array<double, 3>& lengths)
  {
    const int i = lengths[0] < lengths[1] ? 1 : 0;
    return lengths[i] < lengths[2] ? 2 : i;
  }

  double squared_distance(const Barycentric_coordinates& a, const Barycentric_coordinates& b) const
  {
    const std::array<double, 3> d = {{b[0] - a[0], b[1] - a[1], b[2] - a[2]}};
    return -(d[1] * d[2] * m_squared_lengths[0] + d[2] * d[0] * m_squared_lengths[1] +
             d[0] * d[1] * m_squared_lengths[2]);
  }

  static Barycentric_coordinates combination(const Piece& piece, const std::array<double, 3>& weights)
  {
    Barycentric_coordinates result;
    for (int i = 0; i < 3; ++i)
      result[i] = weights[0] * piece[0][i] + weights[1] * piece[1][i] + weights[2] * piece[2][i];
    return result;
  }

  /// Cuts a piece until each part has one point.
  void cut(const Piece& piece, const std::size_t number)
  {
    const std::array<double, 3> lengths = {{squared_distance(piece[1], piece[2]), squared_distance(piece[2], piece[0]),
                                            squared_distance(piece[0], piece[1])}};
    const int opposite = longest_index(lengths), from = (opposite + 1) % 3, to = (opposite + 2) % 3;
    if (number == 1) {
      m_points.push_back(point_of(piece, lengths[opposite]));
      return;
    }
    const std::size_t first = number / 2;
    std::array<double, 3> weights = {{0, 0, 0}};
    weights[to] = static_cast<double>(first) / static_cast<double>(number);
    weights[from] = 1 - weights[to];
    Piece before = piece, after = piece;
    before[to] = after[from] = combination(piece, weights);
    cut(before, first);
    cut(after, number - first);
  }

  Barycentric_coordinates point_of(const Piece& piece, const double squared_length)
  {
    constexpr double is_long = 3;
    if (squared_length <= is_long * is_long * m_squared_spacing)
      return combination(piece, {{1. / 3, 1. / 3, 1. / 3}});
    const std::array<double, 3> x = element_of_sequence(++m_long_pieces);
    const bool is_inside = x[1] + x[2] <= 1; // else the other half of the parallelogram is turned onto the triangle
    const double b = is_inside ? x[1] : 1 - x[1], c = is_inside ? x[2] : 1 - x[2];
    return combination(piece, {{1 - b - c, b, c}});
  }

  /// A sequence in the unit cube without clusters: multiples of the powers of 1 / g, where g^4 = g + 1, modulo 1.
  static std::array<double, 3> element_of_sequence(const double number)
  {
    std::array<double, 3> result;
    double step = 1;
    for (double& x : result) {
      step /= 1.2207440846057596;
      x = number * step - std::floor(number * step);
    }
    return result;
  }

  double m_squared_spacing;
  double m_large_triangles = 0, m_long_pieces = 0; // so far
  std::array<double, 3> m_squared_lengths{};
  std::vector<Barycentric_coordinates> m_points;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_TRIANGLE_SAMPLES_H
