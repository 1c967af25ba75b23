// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_ADAPTIVE_FIT_REPORT_H
#define CGAL_T_SPLINES_SPLINE_ADAPTIVE_FIT_REPORT_H

#include <CGAL/T_splines/Spline/T_spline_fit_report.h>
#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Why an adaptive fit ended. With the first four values there is a surface.
enum class Adaptive_fit_status {
  WITHIN_TOLERANCE,    ///< neither is farther from the other than the tolerance, surface and mesh; and no folds
  CONTROL_POINT_LIMIT, ///< refinement would need more control points than allowed
  NO_IMPROVEMENT,      ///< eight refinements in turn, or three that doubled the control points, reduced neither errors
                       ///< nor folds by a tenth
  RESOLUTION_REACHED,  ///< the faces beyond the tolerance are so small that splitting them makes no sense
  INVALID_TOLERANCE,   ///< the tolerance is not a positive finite number
  NO_SURFACE,          ///< the surface has no triangles, or they do not cover the T-mesh
  LIMIT_TOO_LOW,       ///< the coarsest spline compatible T-mesh needs more control points than allowed: see `levels`
  INADMISSIBLE,        ///< the T-mesh is not admissible: see `fit.surface.compatibility`
  NOT_SPLINE_COMPATIBLE, ///< a T-mesh could not be made spline compatible, or not with as many splits as allowed
  FIT_FAILED,            ///< a fit failed: see `fit`
  INTERRUPTED            ///< the visitor stopped the work
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const Adaptive_fit_status status)
{
  switch (status) {
  case Adaptive_fit_status::WITHIN_TOLERANCE: return "the surface is within the tolerance";
  case Adaptive_fit_status::CONTROL_POINT_LIMIT: return "the allowed number of control points is reached";
  case Adaptive_fit_status::NO_IMPROVEMENT: return "refinement does not reduce the errors any more";
  case Adaptive_fit_status::RESOLUTION_REACHED: return "the faces beyond the tolerance are too small to be split";
  case Adaptive_fit_status::INVALID_TOLERANCE: return "the tolerance is not a positive finite number";
  case Adaptive_fit_status::NO_SURFACE: return "there is no surface under the T-mesh";
  case Adaptive_fit_status::LIMIT_TOO_LOW: return "the coarsest surface needs more control points than allowed";
  case Adaptive_fit_status::INADMISSIBLE: return "the halfedge knots are not admissible";
  case Adaptive_fit_status::NOT_SPLINE_COMPATIBLE: return "the T-mesh could not be made spline compatible";
  case Adaptive_fit_status::FIT_FAILED: return "a fit failed";
  case Adaptive_fit_status::INTERRUPTED: return "the fit was interrupted";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// One of the surfaces of an adaptive fit, from coarse to fine.
struct T_spline_fit_level {
  std::size_t number_of_control_points = 0, ///< of the surface
      number_of_faces = 0;                  ///< of its T-mesh
  std::size_t control_points_in_rings = 0;  ///< around extraordinary vertices
  std::size_t number_of_folded_faces = 0;   ///< with folds, or where the surface meets itself
  std::size_t number_of_doubtful_faces = 0; ///< others with doubtful places, as `Normal_deviation` says
  /// At samples; of a level that is within the tolerance at all samples, as `measure_T_spline_deviation()` measures it.
  T_spline_fit_error error;
};

/// \ingroup PkgTSplinesSpline
/// What `fit_adaptive_T_spline()` did. Members that `status` does not mention have no meaning.
/// \tparam Graph the given T-mesh
template <typename Graph>
struct Adaptive_fit_report {
  Adaptive_fit_status status = Adaptive_fit_status::WITHIN_TOLERANCE; ///< why it ended
  std::vector<T_spline_fit_level> levels;                             ///< always set
  std::size_t best_level = 0;                                         ///< of the surface that was written
  std::size_t number_of_samples = 0;                                  ///< of the last level
  T_spline_fit_report<Graph> fit;                                     ///< INADMISSIBLE, FIT_FAILED: why

  /// returns whether `status` tells of success.
  bool success() const { return status <= Adaptive_fit_status::RESOLUTION_REACHED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, with the numbers concerned. Complexity: linear in the size of the T-mesh.
template <typename Graph>
std::string describe(const Adaptive_fit_report<Graph>& report, const Graph& graph)
{
  switch (report.status) {
  case Adaptive_fit_status::INADMISSIBLE: return describe(report.fit.surface.compatibility, graph);
  case Adaptive_fit_status::FIT_FAILED: return describe(report.fit, graph);
  case Adaptive_fit_status::LIMIT_TOO_LOW:
    return message(report.status) + (": " + std::to_string(report.levels.front().number_of_control_points) + ", " +
                                     std::to_string(report.levels.front().control_points_in_rings) +
                                     " of them in the rings around extraordinary vertices");
  default: return message(report.status);
  }
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_ADAPTIVE_FIT_REPORT_H
