// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FIT_PROGRESS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FIT_PROGRESS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How good a level of an adaptive fit is.
struct Fit_quality {
  std::size_t control_points;
  double maximum, rms; ///< of the distances, by the tolerance
  std::size_t folded_faces, doubtful_faces;
  double area_to_mend; ///< of the surface that is not as it should be

  bool is_within_tolerance() const { return maximum <= 1 && folded_faces == 0; }
};

/// Which level of an adaptive fit is the best one, and whether refinement still pays.
class Fit_progress {
public:
  /// \return whether this level is the best one so far; that it folds counts as a quarter of the tolerance
  bool add(const Fit_quality& level)
  {
    constexpr double enough = 0.9; // levels that take less than a tenth of an error away are not worth their points
    bool improves = false;
    const std::array<double, 5> figures = {level.maximum, level.rms, level.area_to_mend,
                                           static_cast<double>(level.folded_faces),
                                           static_cast<double>(level.doubtful_faces)};
    for (std::size_t i = 0; i < figures.size(); ++i) {
      improves = improves || figures[i] < enough * m_least[i];
      m_least[i] = (std::min)(m_least[i], figures[i]);
    }
    m_control_points = level.control_points;
    ++m_without_improvement;
    if (improves) {
      m_control_points_before = level.control_points;
      m_without_improvement = 0;
    }
    const auto rank = [](const Fit_quality& l) {
      return std::make_tuple((std::max)(l.maximum, 1.) + (l.folded_faces > 0 ? 0.25 : 0.), l.folded_faces,
                             l.doubtful_faces, l.maximum);
    };
    if (m_best && !(rank(level) < rank(*m_best)))
      return false;
    m_best = level;
    return true;
  }

  /// \pre there is a level
  const Fit_quality& best() const { return *m_best; }

  /// Three refinements have reduced no figure by a tenth though they doubled the control points; or eight have.
  bool has_stalled() const
  {
    const bool are_many = m_control_points >= 2 * m_control_points_before;
    return m_without_improvement >= (are_many ? 3 : 8);
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::max)();

  std::optional<Fit_quality> m_best;
  std::array<double, 5> m_least = {infinity, infinity, infinity, infinity, infinity};
  int m_without_improvement = 0;
  std::size_t m_control_points = 0,
              m_control_points_before = 0; // of the last level, and the last that improved something
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FIT_PROGRESS_H
