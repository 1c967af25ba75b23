// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_FIT_REPORT_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_FIT_REPORT_H

#include <CGAL/T_splines/Spline/T_spline_report.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Whether a T-spline surface was fitted, and if not, why.
enum class T_spline_fit_status {
  FITTED,           ///< the control points are set
  INVALID_SURFACE,  ///< the T-mesh carries no T-spline, or a weight is not positive: see `surface`
  NO_SAMPLES,       ///< there is no sample with a positive weight
  INVALID_SAMPLE,   ///< a number of `sample` is not finite, its weight is negative, its face is not one of the
                    ///< T-mesh, or not any more, or its place is not in its face, up to round-off
  INVALID_FAIRNESS, ///< the fairness is negative or not finite
  UNDERDETERMINED,  ///< the samples do not determine all control points: there are too few for a fairness of zero
  INTERRUPTED       ///< the visitor stopped the work
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_fit_status status)
{
  switch (status) {
  case T_spline_fit_status::FITTED: return "the surface is fitted";
  case T_spline_fit_status::INVALID_SURFACE: return "the T-mesh carries no T-spline surface";
  case T_spline_fit_status::NO_SAMPLES: return "there are no samples with a positive weight";
  case T_spline_fit_status::INVALID_SAMPLE:
    return "a sample is not finite, has a negative weight, lies outside of its face, or has a face that the T-mesh "
           "does not have";
  case T_spline_fit_status::INVALID_FAIRNESS: return "the fairness is negative or not finite";
  case T_spline_fit_status::UNDERDETERMINED: return "the samples do not determine all control points";
  case T_spline_fit_status::INTERRUPTED: return "the fit was interrupted";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// How far a surface is from samples: distances between the samples' points and the points of the surface at their
/// places.
struct T_spline_fit_error {
  double rms = 0;     ///< root of the mean of the squared distances, weighted as the samples
  double maximum = 0; ///< the largest distance
  double extent = 0;  ///< the longest side of the bounding box of the samples: that of the cube which encloses them

  /// returns the root mean square by the longest side of the box.
  double relative_rms() const { return extent > 0 ? rms / extent : 0; }
  /// returns the maximum by the longest side of the box.
  double relative_maximum() const { return extent > 0 ? maximum / extent : 0; }
};

/// \ingroup PkgTSplinesSpline
/// What `fit_T_spline()` did. Members that `status` does not mention have no meaning.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph>
struct T_spline_fit_report {
  T_spline_fit_status status = T_spline_fit_status::FITTED; ///< how it ended
  T_spline_report<Graph> surface;                           ///< INVALID_SURFACE: what is wrong
  std::size_t sample = 0;                   ///< the first invalid one; if FITTED, the one at the largest distance
  std::size_t number_of_control_points = 0, ///< of the surface
      number_of_samples = 0;                ///< that were given
  T_spline_fit_error error;                 ///< of the fitted surface, at the samples' last places
  T_spline_fit_error first_error;           ///< the same before the samples were moved
  int number_of_corrections = 0;            ///< how often the samples were moved

  /// returns whether `status` tells of success.
  bool success() const { return status == T_spline_fit_status::FITTED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the T-mesh.
template <typename Graph>
std::string describe(const T_spline_fit_report<Graph>& report, const Graph& graph)
{
  if (report.status == T_spline_fit_status::INVALID_SURFACE)
    return describe(report.surface, graph);
  std::string text = message(report.status);
  if (report.status == T_spline_fit_status::INVALID_SAMPLE)
    text += ": sample " + std::to_string(report.sample);
  return text;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_FIT_REPORT_H
