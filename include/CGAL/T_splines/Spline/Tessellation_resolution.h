// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_TESSELLATION_RESOLUTION_H
#define CGAL_T_SPLINES_SPLINE_TESSELLATION_RESOLUTION_H

#include <CGAL/T_splines/defaults.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// How finely a surface is divided into triangles: the same everywhere, or as finely as its curvature asks for.
class Tessellation_resolution {
public:
  /// Each side of a face is divided into at least `n` parts, its inside into n x n cells. \pre `n` is at least 2
  Tessellation_resolution(const int n = default_tessellation_resolution) : m_number_of_parts(n)
  {
    CGAL_precondition_msg(n >= 2, "the resolution must be at least 2");
  }

  /// The triangles are not farther from the surface than `distance`, a length, as a rule. How long parts are follows from
  /// how far the Bezier patches bend: along an edge, of those beside it; inside of a face, of those in a column or a row.
  /// Each side of a face has at least `least_parts` and an edge at most `most_parts`. \pre `distance` is positive
  static Tessellation_resolution within(const double distance)
  {
    CGAL_precondition_msg(distance > 0, "the distance must be positive");
    Tessellation_resolution result;
    result.m_distance = distance;
    return result;
  }

  /// Every side of a face is divided into at least as many parts as this for the sake of a distance: with two, a side that
  /// ends where it begins would go there and back.
  static constexpr int least_parts = 3;
  /// Neither an edge nor the inside of a face is divided into more parts than this for the sake of a distance.
  static constexpr int most_parts = 128;

  /// returns whether the resolution follows from a distance.
  bool is_adaptive() const { return m_distance > 0; }
  /// returns the number of parts. \pre it is not adaptive
  int number_of_parts() const { return m_number_of_parts; }
  /// returns the distance. \pre it is adaptive
  double distance() const { return m_distance; }

private:
  int m_number_of_parts;
  double m_distance = 0;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_TESSELLATION_RESOLUTION_H
