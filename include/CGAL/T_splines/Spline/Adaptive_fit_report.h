// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_ADAPTIVE_FIT_REPORT_H
#define CGAL_T_SPLINES_SPLINE_ADAPTIVE_FIT_REPORT_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/T_spline_fit_report.h>
#include <CGAL/T_splines/Spline/T_spline_self_intersection_report.h>
#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Why an adaptive fit ended. With the first four values there is a surface.
enum class Adaptive_fit_status {
  WITHIN_TOLERANCE,    ///< measured: neither is farther from the other than the tolerance, surface and mesh, or their
                       ///< borders; the surface has no folds and passes through itself nowhere but where the mesh does
  CONTROL_POINT_LIMIT, ///< refinement would need more control points than `limit`
  NO_IMPROVEMENT,      ///< eight refinements in turn, or three that doubled the control points, reduced neither errors
                       ///< nor folds by a tenth
  RESOLUTION_REACHED,  ///< the faces beyond the tolerance are so small that splitting them makes no sense, or no finer
                       ///< T-mesh could be made spline compatible
  INVALID_TOLERANCE,   ///< the tolerance is not a positive finite number
  NOT_MEASURABLE,      ///< the mesh, or the surface, cannot be measured: see `deviation`
  NO_SURFACE,          ///< the surface has no triangles, or they do not cover the T-mesh
  LIMIT_TOO_LOW,       ///< the coarsest spline compatible T-mesh needs more control points than `limit`: see `levels`
  INADMISSIBLE,        ///< the T-mesh is not admissible: see `fit.surface.compatibility`
  NOT_SPLINE_COMPATIBLE, ///< the T-mesh could not be made spline compatible, or not with as many splits as allowed
  FIT_FAILED,            ///< a fit failed: see `fit`
  INTERRUPTED            ///< the visitor stopped the work
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const Adaptive_fit_status status)
{
  switch (status) {
  case Adaptive_fit_status::WITHIN_TOLERANCE: return "the surface is within the tolerance";
  case Adaptive_fit_status::CONTROL_POINT_LIMIT: return "more control points would be needed than are allowed";
  case Adaptive_fit_status::NO_IMPROVEMENT: return "refinement does not reduce the errors any more";
  case Adaptive_fit_status::RESOLUTION_REACHED: return "the faces beyond the tolerance cannot be split any more";
  case Adaptive_fit_status::INVALID_TOLERANCE: return "the tolerance is not a positive finite number";
  case Adaptive_fit_status::NOT_MEASURABLE: return "the distance from the mesh cannot be measured";
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
/// \tparam Graph the graph of the given T-mesh
/// \tparam SplineGraph that of the T-spline
/// \tparam TriangleMesh the mesh that the surface was measured against
template <typename Graph, typename SplineGraph, typename TriangleMesh>
struct Adaptive_fit_report {
  Adaptive_fit_status status = Adaptive_fit_status::WITHIN_TOLERANCE; ///< why it ended
  std::vector<T_spline_fit_level> levels;                             ///< always set
  std::size_t best_level = 0;                                         ///< of the surface that was written
  std::size_t number_of_samples = 0;                                  ///< of the last level
  std::size_t limit = 0;                                              ///< of the number of control points
  bool is_limit_default = false;                                      ///< whether nobody asked for that limit
  T_spline_fit_report<Graph> fit;                                     ///< INADMISSIBLE, FIT_FAILED: why
  /// NOT_SPLINE_COMPATIBLE: which condition could not be met.
  Spline_compatibility_status incompatibility = Spline_compatibility_status::SPLINE_COMPATIBLE;
  /// Of the surface that was written, as `measure_T_spline_deviation()` finds it, with the tolerance as a length.
  T_spline_deviation_report<SplineGraph, TriangleMesh> deviation;
  /// Of the surface that was written, as `check_T_spline_self_intersections()` finds them.
  T_spline_self_intersection_report self_intersections;

  /// returns whether a surface was written. It may be beyond the tolerance.
  bool success() const { return status <= Adaptive_fit_status::RESOLUTION_REACHED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }

  /// returns whether the surface that was written is what was asked for: within the tolerance both ways, as is its
  /// border, without folds, and without self-intersections where the mesh has none.
  bool within_tolerance() const { return status == Adaptive_fit_status::WITHIN_TOLERANCE; }
};

namespace internal {

/// How the surface of a fit is, in words; lengths are given by the longest side of the bounding box.
template <typename Graph, typename SplineGraph, typename TriangleMesh>
std::string described_quality(const Adaptive_fit_report<Graph, SplineGraph, TriangleMesh>& report)
{
  const double extent = report.deviation.mesh_to_surface.extent;
  const auto relative = [&](const double length) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g", extent > 0 ? length / extent : 0.);
    return std::string(text);
  };
  std::string text = "distance " + relative(report.deviation.maximum());
  if (report.deviation.free_edge)
    text += ", of the borders " + relative(report.deviation.free_edge->maximum());
  if (report.deviation.crease)
    text += ", of the creases " + relative(report.deviation.crease->maximum());
  text += ", tolerance " + relative(report.deviation.tolerance) + " of the longest side";
  if (report.deviation.has_folds())
    text += ", " + std::to_string(report.deviation.normals.number_of_folded_patches) + " patches with folds";
  if (!report.self_intersections.success())
    text += ", " + std::to_string(report.self_intersections.number_of_new_intersections) + " self-intersections";
  return text;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, with the figures concerned and what may help. Complexity: linear in the size of the
/// T-mesh.
template <typename Graph, typename SplineGraph, typename TriangleMesh>
std::string describe(const Adaptive_fit_report<Graph, SplineGraph, TriangleMesh>& report, const Graph& graph)
{
  using Status = Adaptive_fit_status;
  const std::string limit =
      std::to_string(report.limit) + (report.is_limit_default ? ", the default, which can be raised" : "");
  switch (report.status) {
  case Status::INADMISSIBLE: return describe(report.fit.surface.compatibility, graph);
  case Status::FIT_FAILED: return describe(report.fit, graph);
  case Status::NOT_SPLINE_COMPATIBLE:
    return message(report.status) + std::string(": ") + message(report.incompatibility);
  case Status::NOT_MEASURABLE: return message(report.status) + std::string(": ") + message(report.deviation.status);
  case Status::LIMIT_TOO_LOW:
    return message(report.status) + (": " + std::to_string(report.levels.front().number_of_control_points) + ", " +
                                     std::to_string(report.levels.front().control_points_in_rings) +
                                     " of them in the rings around extraordinary vertices; allowed are " + limit);
  case Status::CONTROL_POINT_LIMIT:
    return message(report.status) + (" (" + limit + "): ") + internal::described_quality(report);
  case Status::WITHIN_TOLERANCE:
  case Status::NO_IMPROVEMENT:
  case Status::RESOLUTION_REACHED:
    return message(report.status) + std::string(": ") + internal::described_quality(report);
  default: return message(report.status);
  }
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_ADAPTIVE_FIT_REPORT_H
