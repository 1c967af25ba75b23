// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_CHECK_T_MESH_KNOTS_H
#define CGAL_T_SPLINES_IO_INTERNAL_CHECK_T_MESH_KNOTS_H

#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>
#include <CGAL/T_splines/IO/internal/build_t_mesh.h>
#include <CGAL/T_splines/IO/internal/check_t_mesh_soup.h>
#include <CGAL/T_splines/T_mesh/Admissibility_report.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The counterpart of `status` among the endings of the reader.
inline T_mesh_reading_status reading_status(const Admissibility_status status)
{
  switch (status) {
  case Admissibility_status::ADMISSIBLE: return T_mesh_reading_status::SUCCESS;
  case Admissibility_status::NON_POSITIVE_KNOT: return T_mesh_reading_status::NON_POSITIVE_KNOT;
  case Admissibility_status::KNOT_NOT_FINITE: return T_mesh_reading_status::NON_FINITE_NUMBER;
  case Admissibility_status::WRONG_CORNER_COUNT: return T_mesh_reading_status::WRONG_NUMBER_OF_CORNERS;
  case Admissibility_status::OPPOSITE_SIDES_DIFFER: return T_mesh_reading_status::UNEQUAL_SIDES;
  case Admissibility_status::CYCLE_CONDITION_VIOLATED: return T_mesh_reading_status::CYCLE_CONDITION;
  case Admissibility_status::INTERRUPTED: return T_mesh_reading_status::INTERRUPTED;
  }
  return T_mesh_reading_status::SUCCESS;
}

/// Whether the knots of a soup are admissible. It is asked on a graph of its own, so that the caller's graph is
/// touched only if all is well.
/// \pre `check_t_mesh_soup()` found nothing.
inline T_mesh_reading_report check_t_mesh_knots(const T_mesh_soup& soup, const double relative_tolerance,
                                                Progress& progress)
{
  T_mesh<std::array<double, 3>> t_mesh;
  T_mesh_builder(soup, T_mesh_view_of<decltype(t_mesh)>(t_mesh));
  const auto admissibility = admissibility_report(t_mesh, parameters::relative_tolerance(relative_tolerance), progress);
  if (admissibility.success() || progress.is_interrupted())
    return T_mesh_reading_report();
  const bool is_about_vertex = admissibility.status == Admissibility_status::CYCLE_CONDITION_VIOLATED;
  T_mesh_reading_report report =
      is_about_vertex
          ? report_of_vertex(soup, reading_status(admissibility.status), static_cast<std::size_t>(admissibility.vertex))
          : report_of_face(soup, reading_status(admissibility.status), static_cast<std::size_t>(admissibility.face));
  report.defect = admissibility.defect;
  return report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_CHECK_T_MESH_KNOTS_H
