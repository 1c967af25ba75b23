// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_KNOT_INSERTION_REPORT_H
#define CGAL_T_SPLINES_SPLINE_KNOT_INSERTION_REPORT_H

#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>
#include <CGAL/T_splines/internal/element_numbers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// Whether a line was inserted into a T-spline surface, and if not, why.
enum class Knot_insertion_status {
  INSERTED,                ///< the line is inserted, the surface is the same
  NOT_SPLINE_COMPATIBLE,   ///< the T-mesh carries no T-spline: see `compatibility`
  WEIGHT_NOT_POSITIVE,     ///< the weight of the control point of `vertex` is not a positive finite number
  OUTSIDE,                 ///< the line does not pass inside the face, or passes too close to its sides
  NOT_CONFORMING,          ///< `face`, in one of the three columns of the line, has a vertex inside a side
  AT_EXTRAORDINARY_VERTEX, ///< the line would change the rings of the extraordinary vertex `vertex`
  NEAR_CREASE,             ///< at `vertex` beside the line, a line along a crease or the border ends at another crease
  LINE_MEETS_ITSELF,       ///< the line comes back to one of its three columns at `face`
  INTERRUPTED              ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const Knot_insertion_status status)
{
  switch (status) {
  case Knot_insertion_status::INSERTED: return "the line is inserted";
  case Knot_insertion_status::NOT_SPLINE_COMPATIBLE: return "the T-mesh is not spline compatible";
  case Knot_insertion_status::WEIGHT_NOT_POSITIVE:
    return "the weight of a control point is not a positive finite number";
  case Knot_insertion_status::OUTSIDE: return "the line does not pass inside the face";
  case Knot_insertion_status::NOT_CONFORMING:
    return "a T-joint lies on a side of a face in the three columns of the line";
  case Knot_insertion_status::AT_EXTRAORDINARY_VERTEX:
    return "the line runs through the rings of an extraordinary vertex";
  case Knot_insertion_status::NEAR_CREASE:
    return "beside the line, a line along a crease or the border ends at another crease";
  case Knot_insertion_status::LINE_MEETS_ITSELF: return "the line comes back to one of its three columns";
  case Knot_insertion_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// The result of `insert_knot_line()`. It converts to `true` if the line was inserted. Members that `status` does not
/// mention have no meaning.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph>
struct Knot_insertion_report {
  using Traits = boost::graph_traits<Graph>;

  Knot_insertion_status status = Knot_insertion_status::INSERTED;    ///< how it ended
  Spline_compatibility_report<Graph> compatibility;                  ///< NOT_SPLINE_COMPATIBLE: which condition fails
  typename Traits::vertex_descriptor vertex = Traits::null_vertex(); ///< the vertex that `status` is about
  typename Traits::face_descriptor face = Traits::null_face();       ///< the face that `status` is about
  std::size_t inserted_vertices = 0;                                 ///< 0 unless INSERTED

  /// returns whether `status` tells of success.
  bool success() const { return status == Knot_insertion_status::INSERTED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesSpline
/// returns what `report` says, with the numbers of the elements concerned, counted from 0. Complexity: linear in the
/// size of the T-mesh.
template <typename Graph>
std::string describe(const Knot_insertion_report<Graph>& report, const Graph& graph)
{
  if (report.status == Knot_insertion_status::NOT_SPLINE_COMPATIBLE)
    return describe(report.compatibility, graph);
  return message(report.status) + internal::numbered_elements(graph, report.vertex, report.face);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_KNOT_INSERTION_REPORT_H
