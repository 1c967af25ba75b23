// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_SELF_INTERSECTION_REPORT_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_SELF_INTERSECTION_REPORT_H

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <sstream>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// How `check_T_spline_self_intersections()` ended.
enum class T_spline_self_intersection_status {
  CHECKED,    ///< the numbers are known
  INTERRUPTED ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_self_intersection_status status)
{
  switch (status) {
  case T_spline_self_intersection_status::CHECKED: return "the surface was checked for self-intersections";
  case T_spline_self_intersection_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// What `check_T_spline_self_intersections()` found.
struct T_spline_self_intersection_report {
  T_spline_self_intersection_status status = T_spline_self_intersection_status::CHECKED; ///< how it ended
  std::size_t number_of_triangles = 0;                                                   ///< of the tessellation
  std::size_t number_of_intersections = 0;                   ///< pairs of triangles of the tessellation that intersect
  std::size_t number_of_mesh_intersections = 0;              ///< pairs of triangles of the mesh that intersect
  std::size_t number_of_new_intersections = 0;               ///< those of the tessellation where the mesh has none
  CGAL::Simple_cartesian<double>::Point_3 place = {0, 0, 0}; ///< next to the first new intersection, if there is any

  /// returns whether the surface passes through itself nowhere but where the mesh does, as far as that was checked.
  bool success() const
  {
    return status == T_spline_self_intersection_status::CHECKED && number_of_new_intersections == 0;
  }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, and where.
inline std::string describe(const T_spline_self_intersection_report& report)
{
  if (report.status == T_spline_self_intersection_status::INTERRUPTED)
    return message(report.status);
  if (report.success())
    return "the surface passes through itself nowhere but where the mesh does";
  std::ostringstream text;
  text << "the surface passes through itself where the mesh does not: " << report.number_of_new_intersections
       << " pairs of triangles of its tessellation, the first at (" << report.place << ")";
  return text.str();
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_SELF_INTERSECTION_REPORT_H
