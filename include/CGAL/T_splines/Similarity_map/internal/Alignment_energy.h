// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ALIGNMENT_ENERGY_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ALIGNMENT_ENERGY_H

#include <CGAL/T_splines/Similarity_map/internal/Linear_parameters.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_distortion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A linear function of the unknowns that is to become 0, and its share in a penalty.
struct Penalty_row {
  Linear_parameters::Row row; ///< without a length: coefficients are divided by one
  double weight;              ///< of its square; those of one kind sum to 1
};

/// What the aligned map minimizes: the distortion of each triangle against its reference, and penalties.
///
/// The energy is sum_f a_f E(J_f R_f^-1) + sum mu w (row . x)^2, with J_f the triangle in the map and R_f the same triangle where it
/// should be: turned to the field, and scaled ([CZ17] 7.4). Transitions turn and scale J_f and R_f alike, so that it does not
/// depend on the charts.
class Alignment_energy {
public:
  /// Coordinates of a triangle: its corners' vertices of the mesh that is cut open.
  using Triangle = std::array<int, 3>;

  /// \param triangles their open vertices, counter-clockwise
  /// \param reference per triangle the two edges from its first corner, as columns; positively oriented
  /// \param area per triangle: its weight; they sum to 1
  Alignment_energy(std::vector<Triangle> triangles, const std::vector<Plane_matrix>& reference,
                   std::vector<double> area, const double distortion_weight)
    : m_triangles(std::move(triangles)),
      m_weight(std::move(area)),
      m_distortion{distortion_weight}
  {
    m_inverse.reserve(reference.size());
    for (const Plane_matrix& r : reference)
      m_inverse.push_back(r.inverse());
  }

  int number_of_triangles() const { return static_cast<int>(m_triangles.size()); }

  /// The six unknowns of a triangle: u and v of each corner.
  std::array<int, 6> unknowns(const int f) const
  {
    const Triangle& t = m_triangles[f];
    return {{2 * t[0], 2 * t[0] + 1, 2 * t[1], 2 * t[1] + 1, 2 * t[2], 2 * t[2] + 1}};
  }

  /// The map of a triangle against its reference; the identity is best.
  Plane_matrix deformation(const int f, const std::vector<double>& x) const
  {
    const Triangle& t = m_triangles[f];
    const double u = x[2 * t[0]], v = x[2 * t[0] + 1];
    return Plane_matrix{x[2 * t[1]] - u, x[2 * t[2]] - u, x[2 * t[1] + 1] - v, x[2 * t[2] + 1] - v} * m_inverse[f];
  }

  double weight(const int f) const { return m_weight[f]; }

  /// Penalties: `factor` times the weighted squares of rows.
  void set_penalties(const std::vector<std::pair<const std::vector<Penalty_row>*, double>>& penalties)
  {
    m_penalties = penalties;
  }

  /// Calls `visit(row, weight)` for the rows of penalties; the penalty is the sum of weight times square.
  template <typename Visit>
  void for_each_penalty(const Visit& visit) const
  {
    for (const auto& [rows, factor] : m_penalties)
      for (const Penalty_row& row : *rows)
        visit(row.row, factor * row.weight);
  }

  static double value(const Linear_parameters::Row& row, const std::vector<double>& x)
  {
    double sum = 0;
    for (const auto& [unknown, coefficient] : row)
      sum += coefficient * x[unknown];
    return sum;
  }

  /// Infinite if a triangle is turned over.
  double value(const std::vector<double>& x) const
  {
    double sum = 0;
    for (int f = 0; f < number_of_triangles(); ++f)
      sum += m_weight[f] * m_distortion.value(deformation(f, x));
    for_each_penalty([&](const Linear_parameters::Row& row, const double weight) {
      const double r = value(row, x);
      sum += weight * r * r;
    });
    return sum;
  }

  /// The derivatives of the part of a triangle by its six unknowns, the second ones without their negative part.
  void derivatives(const int f, const std::vector<double>& x, std::array<double, 6>& first,
                   std::array<std::array<double, 6>, 6>& second) const
  {
    std::array<double, 4> by_entry;
    std::array<std::array<double, 4>, 4> second_by_entry;
    m_distortion.derivatives(deformation(f, x), by_entry, second_by_entry);
    // Entry (i, j) of the deformation is the sum over the corners of coordinate i times slope[corner][j].
    const Plane_matrix& r = m_inverse[f];
    const std::array<std::array<double, 2>, 3> slope = {{{{-r.a - r.c, -r.b - r.d}}, {{r.a, r.b}}, {{r.c, r.d}}}};
    for (int p = 0; p < 3; ++p)
      for (int i = 0; i < 2; ++i) {
        first[2 * p + i] = m_weight[f] * (slope[p][0] * by_entry[2 * i] + slope[p][1] * by_entry[2 * i + 1]);
        for (int q = 0; q < 3; ++q)
          for (int j = 0; j < 2; ++j) {
            double sum = 0;
            for (int k = 0; k < 2; ++k)
              for (int l = 0; l < 2; ++l)
                sum += slope[p][k] * slope[q][l] * second_by_entry[2 * i + k][2 * j + l];
            second[2 * p + i][2 * q + j] = m_weight[f] * sum;
          }
      }
  }

  /// The largest t such that no triangle of x + s d, 0 <= s < t, is degenerate: the smallest positive root of a
  /// determinant (Smith, Schaefer, Bijective parameterization with free boundaries, 2015).
  double first_degeneracy(const std::vector<double>& x, const std::vector<double>& d) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (int f = 0; f < number_of_triangles(); ++f) {
      const Plane_matrix m = deformation(f, x), n = deformation(f, d);
      const double a = n.determinant(), b = m.a * n.d + n.a * m.d - m.b * n.c - n.b * m.c, c = m.determinant();
      const double discriminant = b * b - 4 * a * c;
      if (discriminant < 0)
        continue;
      const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
      for (const double root : {q / a, c / q}) // infinite or not a number where there is none
        if (root > 0)
          result = (std::min)(result, root);
    }
    return result;
  }

private:
  std::vector<Triangle> m_triangles;
  std::vector<double> m_weight;
  std::vector<Plane_matrix> m_inverse; // of the reference
  Plane_distortion m_distortion;
  std::vector<std::pair<const std::vector<Penalty_row>*, double>> m_penalties;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ALIGNMENT_ENERGY_H
