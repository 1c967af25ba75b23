// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_ANDERSON_ACCELERATION_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_ANDERSON_ACCELERATION_H

#include <Eigen/Dense>

#include <algorithm>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Makes the iteration x <- g(x) converge faster (Anderson, Iterative procedures for nonlinear integral equations,
/// 1965; for geometric problems: Peng et al., Anderson acceleration for geometry optimization and physics simulation,
/// 2018). Of the last iterates it takes the combination for which g(x) - x would be least if g were affine.
template <typename FT>
class Anderson_acceleration {
public:
  using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;

  /// The next iterate. \param g of x
  Vector next(const Vector& x, const Vector& g)
  {
    const Vector step = g - x;
    Vector result = g;
    if (m_is_started) {
      const Eigen::Index column = m_number_of_steps++ % window;
      if (m_steps.rows() != x.size()) {
        m_steps.resize(x.size(), window);
        m_images.resize(x.size(), window);
      }
      m_steps.col(column) = step - m_last_step;
      m_images.col(column) = g - m_last_image;
      const Eigen::Index n = (std::min)(m_number_of_steps, Eigen::Index(window));
      const auto steps = m_steps.leftCols(n);
      const auto images = m_images.leftCols(n);
      const Vector factors = steps.colPivHouseholderQr().solve(step);
      if (factors.allFinite())
        result -= images * factors;
    }
    m_is_started = true;
    m_last_step = step;
    m_last_image = g;
    return result;
  }

  /// Forgets the iterates.
  void reset()
  {
    m_is_started = false;
    m_number_of_steps = 0;
  }

private:
  static constexpr int window = 5;

  using Matrix = Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic>;

  bool m_is_started = false;
  Eigen::Index m_number_of_steps = 0;
  Vector m_last_step, m_last_image;
  Matrix m_steps, m_images; // the differences of successive ones
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_ANDERSON_ACCELERATION_H
