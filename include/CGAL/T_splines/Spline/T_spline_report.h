// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_REPORT_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_REPORT_H

#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>
#include <CGAL/T_splines/internal/element_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Whether a T-spline surface is defined, and if not, why.
enum class T_spline_status {
  VALID,                    ///< the surface can be evaluated
  NOT_SPLINE_COMPATIBLE,    ///< the T-mesh carries no T-spline: see `compatibility`
  CONTROL_POINT_NOT_FINITE, ///< a coordinate or the weight of the control point of `vertex` is infinite or not a number
  WEIGHT_NOT_POSITIVE,      ///< the weight of the control point of `vertex` is zero or negative
  INTERRUPTED               ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_status status)
{
  switch (status) {
  case T_spline_status::VALID: return "the surface is valid";
  case T_spline_status::NOT_SPLINE_COMPATIBLE: return "the T-mesh is not spline compatible";
  case T_spline_status::CONTROL_POINT_NOT_FINITE:
    return "a control point has a coordinate or weight that is not finite";
  case T_spline_status::WEIGHT_NOT_POSITIVE: return "the weight of a control point is not positive";
  case T_spline_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// What is wrong with a T-spline surface, and where. Members that `status` does not mention have no meaning.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph>
struct T_spline_report {
  T_spline_status status = T_spline_status::VALID;  ///< whether the surface is defined
  Spline_compatibility_report<Graph> compatibility; ///< NOT_SPLINE_COMPATIBLE: which condition fails
  /// the vertex that `status` is about.
  typename boost::graph_traits<Graph>::vertex_descriptor vertex = boost::graph_traits<Graph>::null_vertex();

  /// returns whether `status` tells of success.
  bool success() const { return status == T_spline_status::VALID; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says and the numbers of the elements concerned; of a T-mesh that is not spline compatible,
/// which condition fails. Complexity: linear in the size of the T-mesh.
template <typename Graph>
std::string describe(const T_spline_report<Graph>& report, const Graph& graph)
{
  if (report.status == T_spline_status::NOT_SPLINE_COMPATIBLE)
    return describe(report.compatibility, graph);
  return message(report.status) +
         internal::numbered_elements(graph, report.vertex, boost::graph_traits<Graph>::null_face());
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_REPORT_H
