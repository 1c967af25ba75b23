// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_MESH_STAGE_H
#define MESH_TO_T_SPLINE_T_MESH_STAGE_H

#include "Figures.h"
#include "Progress.h"
#include "Surface_t_mesh.h"
#include "exact_map_stage.h"

#include <CGAL/T_splines/T_mesh/T_mesh_roots.h>
#include <CGAL/T_splines/T_mesh/place_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/T_mesh/trace_motorcycle_graph.h>
#include <CGAL/T_splines/named_parameters.h>

#include <string>

/// \return why there is no T-mesh; empty if there is one.
inline std::string trace_t_mesh(const Exact_map& map, Progress& progress, Surface_t_mesh& t,
                                T_mesh_stage_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  const auto np = P::edge_polyline_map(t.polylines, P::face_anchor_map(t.anchors)).visitor(Progress_handle(progress));
  const CGAL::T_splines::Motorcycle_graph_report report =
      CGAL::T_splines::trace_motorcycle_graph(map, t.mesh, t.knots, t.corners, np);
  progress.end_stage();
  if (!report.success())
    return message(report.status);
  figures.tracing.motorcycles = report.motorcycles;
  figures.tracing.seeds = report.seeds;
  figures.tracing.crossed_faces = report.crossed_faces;
  figures.tracing.predicate_calls = report.predicates.calls;
  figures.tracing.exact_predicate_calls = report.predicates.exact_calls;
  figures.traced = figures_of(t);
  return {};
}

/// Makes the faces of the motorcycle graph squarer, and finds where they lie then.
/// \return why that is not known; empty if it is.
inline std::string regularize(const Exact_map& map, Progress& progress, Surface_t_mesh& t,
                              Regularization_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  progress.begin_stage("regularization");
  const CGAL::T_splines::T_mesh_roots<Mesh, T_mesh, Exact_number> roots(t.mesh, t.anchors);
  const CGAL::T_splines::T_mesh_regularization_report report =
      CGAL::T_splines::regularize_T_mesh(t.mesh, t.knots, t.corners, CGAL::parameters::visitor(roots));
  progress.begin_stage("placing");
  if (!CGAL::T_splines::place_T_mesh(map, t.mesh, t.knots, t.corners, roots, P::edge_polyline_map(t.polylines)))
    return "the regularized T-mesh does not fit on the surface";
  t.mesh.collect_garbage(); // not before: the roots name faces
  figures.operations = {
      {"removals", report.removals}, {"flips", report.flips}, {"partial_removals", report.partial_removals}};
  figures.t_mesh = figures_of(t);
  progress.end_stage();
  return {};
}

#endif // MESH_TO_T_SPLINE_T_MESH_STAGE_H
