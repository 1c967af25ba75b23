// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_ADMISSIBILITY_REPORT_H
#define CGAL_T_SPLINES_T_MESH_ADMISSIBILITY_REPORT_H

#include <CGAL/T_splines/internal/element_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <sstream>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// Whether halfedge knots are admissible on a T-mesh, and if not, why.
enum class Admissibility_status {
  ADMISSIBLE,               ///< all conditions hold
  NON_POSITIVE_KNOT,        ///< the knot interval of `halfedge`, of `face`, is `defect`, not positive
  KNOT_NOT_FINITE,          ///< the knot interval of `halfedge`, of `face`, is infinite or not a number
  WRONG_CORNER_COUNT,       ///< `face` has `number_of_corners` corners instead of four
  OPPOSITE_SIDES_DIFFER,    ///< two opposite sides of `face` differ; `halfedge` begins the one that `defect` is about
  CYCLE_CONDITION_VIOLATED, ///< the product of the knot ratios around `vertex` is `1 + defect`
  INTERRUPTED               ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesTMesh
/// returns one sentence that explains `status`.
inline const char* message(const Admissibility_status status)
{
  switch (status) {
  case Admissibility_status::ADMISSIBLE: return "the halfedge knots are admissible";
  case Admissibility_status::NON_POSITIVE_KNOT: return "a knot interval is not positive";
  case Admissibility_status::KNOT_NOT_FINITE: return "a knot interval is not a finite number";
  case Admissibility_status::WRONG_CORNER_COUNT: return "a face has not exactly four corners";
  case Admissibility_status::OPPOSITE_SIDES_DIFFER: return "two opposite sides of a face have different lengths";
  case Admissibility_status::CYCLE_CONDITION_VIOLATED:
    return "the product of the ratios of opposite knot intervals around a vertex is not 1";
  case Admissibility_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesTMesh
/// The result of `check_admissibility()`: what is wrong, where, and how much. Members that `status` does not mention have no
/// meaning.
/// \tparam Graph a model of `FaceGraph`.
template <typename Graph>
struct Admissibility_report {
  using Traits = boost::graph_traits<Graph>;

  Admissibility_status status = Admissibility_status::ADMISSIBLE;          ///< whether the knots are admissible
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();       ///< the vertex that `status` is about
  typename Traits::halfedge_descriptor halfedge = Traits::null_halfedge(); ///< the halfedge that `status` is about
  typename Traits::face_descriptor face = Traits::null_face();             ///< the face that `status` is about
  int number_of_corners = 4;                                               ///< of `face`
  double defect = 0; ///< of OPPOSITE_SIDES_DIFFER: (length - opposite length) / opposite length

  /// returns whether `status` tells of success.
  bool success() const { return status == Admissibility_status::ADMISSIBLE; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTMesh
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the T-mesh.
template <typename Graph>
std::string describe(const Admissibility_report<Graph>& report, const Graph& graph)
{
  using Status = Admissibility_status;
  std::ostringstream text;
  text << message(report.status);
  switch (report.status) {
  case Status::ADMISSIBLE:
  case Status::INTERRUPTED: break;
  case Status::NON_POSITIVE_KNOT:
  case Status::KNOT_NOT_FINITE:
    text << ": " << internal::edge_in_words(report.halfedge, graph) << " of "
         << internal::face_in_words(report.face, graph) << ", counted from 0";
    if (report.status == Status::NON_POSITIVE_KNOT)
      text << ", has " << report.defect;
    break;
  case Status::WRONG_CORNER_COUNT:
    text << ": " << internal::face_in_words(report.face, graph) << ", counted from 0, has " << report.number_of_corners;
    break;
  case Status::OPPOSITE_SIDES_DIFFER:
    text << ": " << internal::face_in_words(report.face, graph) << ", counted from 0 (off by " << report.defect << ")";
    break;
  case Status::CYCLE_CONDITION_VIOLATED:
    text << ": " << internal::vertex_in_words(report.vertex, graph) << ", counted from 0 (off by " << report.defect
         << ")";
    break;
  }
  return text.str();
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_ADMISSIBILITY_REPORT_H
