// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FIT_PROGRESS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FIT_PROGRESS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Which level of an adaptive fit is the best one, and whether refinement still pays.
class Fit_progress {
public:
  /// \param maximum, rms of the distances, by the tolerance
  /// \param area_to_mend of the surface that is not as it should be
  /// \return whether this level is the best one so far; that it folds counts as a quarter of the tolerance
  bool add(const std::size_t control_points, const double maximum, const double rms, const std::size_t folds,
           const double area_to_mend)
  {
    constexpr double enough = 0.9;
    bool improves = false;
    const std::array<double, 4> figures = {maximum, rms, area_to_mend, static_cast<double>(folds)};
    for (std::size_t i = 0; i < figures.size(); ++i) {
      improves = improves || figures[i] < enough * m_least[i];
      m_least[i] = (std::min)(m_least[i], figures[i]);
    }
    if (improves) {
      m_control_points = control_points;
      m_without_improvement = m_without_more_control_points = 0;
    }
    else
      ++(control_points > m_control_points ? m_without_improvement : m_without_more_control_points);
    const std::tuple<double, std::size_t, double> rank((std::max)(maximum, 1.) + (folds > 0 ? 0.25 : 0.), folds,
                                                       maximum);
    if (!(rank < m_best))
      return false;
    m_best = rank;
    return true;
  }

  /// Three refinements have reduced no figure by a tenth since the last one that did. Those do not count that have left
  /// no more control points, because faces became regular; but many of them end the work, too.
  bool has_stalled() const { return m_without_improvement == 3 || m_without_more_control_points == 8; }

private:
  static constexpr double infinity = (std::numeric_limits<double>::max)();

  std::tuple<double, std::size_t, double> m_best = {infinity, 0, 0};
  std::array<double, 4> m_least = {infinity, infinity, infinity, infinity};
  int m_without_improvement = 0, m_without_more_control_points = 0;
  std::size_t m_control_points = 0; // of the last level that improved something
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FIT_PROGRESS_H
