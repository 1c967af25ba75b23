// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_MOTORCYCLE_GRAPH_REPORT_H
#define CGAL_T_SPLINES_TRACING_MOTORCYCLE_GRAPH_REPORT_H

#include <CGAL/T_splines/Tracing/Tracing_traits.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTracing
/// How the tracing of a motorcycle graph ended.
enum class Motorcycle_graph_status {
  SUCCESS,           ///< the T-mesh was written
  EMPTY_MAP,         ///< the map has no faces
  OUTPUT_NOT_EMPTY,  ///< the T-mesh to write has elements, or removed ones; nothing was traced
  INTERRUPTED,       ///< the visitor asked to stop
  TRACE_LOST,        ///< a trace leaves a triangle nowhere: the map is not seamless, or the predicates are not exact
  TRACE_WITHOUT_END, ///< a trace does not end in spite of the seeds set in its way: the same
  NO_T_MESH          ///< a face of the graph is no rectangle: the same
};

/// \ingroup PkgTSplinesTracing
/// returns a sentence that tells the status.
inline const char* message(const Motorcycle_graph_status status)
{
  switch (status) {
  case Motorcycle_graph_status::SUCCESS: return "the motorcycle graph is a T-mesh";
  case Motorcycle_graph_status::EMPTY_MAP: return "the map has no faces";
  case Motorcycle_graph_status::OUTPUT_NOT_EMPTY:
    return "the T-mesh that receives the motorcycle graph is not empty; give a new one";
  case Motorcycle_graph_status::INTERRUPTED: return "interrupted";
  case Motorcycle_graph_status::TRACE_LOST: return "a trace enters a triangle and leaves it nowhere";
  case Motorcycle_graph_status::TRACE_WITHOUT_END: return "a trace does not end";
  case Motorcycle_graph_status::NO_T_MESH: return "a face of the motorcycle graph is not a rectangle";
  }
  return "";
}

/// \ingroup PkgTSplinesTracing
/// What `trace_motorcycle_graph()` did.
struct Motorcycle_graph_report {
  Motorcycle_graph_status status = Motorcycle_graph_status::SUCCESS; ///< how it ended
  std::size_t motorcycles = 0; ///< rays that left cones, corners, ends of walls, seeds
  std::size_t seeds = 0; ///< starts at regular places: without cones, on closed walls, and where a trace would spiral
  std::size_t crossed_faces = 0;   ///< triangles crossed by traces, counted once per crossing
  std::size_t t_joints = 0;        ///< vertices of the T-mesh where a face goes straight on
  Predicate_statistics predicates; ///< how often the predicates were asked

  /// returns whether `status` tells of success.
  bool success() const { return status == Motorcycle_graph_status::SUCCESS; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesTracing
/// returns what `report` says; of a trace that went wrong, after how much work, and what can be done.
inline std::string describe(const Motorcycle_graph_report& report)
{
  switch (report.status) {
  case Motorcycle_graph_status::TRACE_LOST:
  case Motorcycle_graph_status::TRACE_WITHOUT_END:
  case Motorcycle_graph_status::NO_T_MESH:
    return message(report.status) + (" (" + std::to_string(report.motorcycles) + " motorcycles, ") +
           std::to_string(report.crossed_faces) +
           " crossed triangles); use the exact predicates of Exact_tracing_traits";
  default: return message(report.status);
  }
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_MOTORCYCLE_GRAPH_REPORT_H
