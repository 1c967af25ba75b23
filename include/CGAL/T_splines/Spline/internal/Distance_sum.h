// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCE_SUM_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCE_SUM_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Means of distances, weighted by area.
class Distance_sum {
public:
  explicit Distance_sum(const double tolerance) : m_tolerance(tolerance) {}

  void add(const double area, const double distance)
  {
    m_area += area;
    m_squares += area * distance * distance;
    m_within += distance <= m_tolerance ? area : 0;
    m_within_half += 2 * distance <= m_tolerance ? area : 0;
    ++m_number;
  }

  void add_to(One_way_deviation& result) const
  {
    result.number_of_samples = m_number;
    // Without area nothing has a mean.
    result.rms = m_area > 0 ? std::sqrt(m_squares / m_area) : 0;
    result.share_within_tolerance = m_area > 0 ? m_within / m_area : 1;
    result.share_within_half = m_area > 0 ? m_within_half / m_area : 1;
  }

private:
  double m_tolerance, m_area = 0, m_squares = 0, m_within = 0, m_within_half = 0;
  std::size_t m_number = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_DISTANCE_SUM_H
