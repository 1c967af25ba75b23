// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_MESH_STAGE_H
#define MESH_TO_T_SPLINE_T_MESH_STAGE_H

#include "Figures.h"
#include "Progress.h"
#include "Surface_t_mesh.h"
#include "exact_map_stage.h"

#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>
#include <CGAL/T_splines/T_mesh/place_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/T_mesh/trace_motorcycle_graph.h>
#include <CGAL/T_splines/named_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <string>
#include <vector>

/// \return why there is no T-mesh; empty if there is one.
inline std::string trace_t_mesh(const Exact_map& map, Progress& progress, Surface_t_mesh& t,
                                T_mesh_stage_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  using Place = CGAL::T_splines::T_mesh_place<T_mesh, double>;
  std::vector<Place> places(map.mesh().number_of_vertices());
  const auto place_map = boost::make_iterator_property_map(places.begin(), get(boost::vertex_index, map.mesh()));
  const auto np = P::edge_polyline_map(t.polylines, P::face_anchor_map(t.anchors, P::vertex_place_map(place_map)))
                      .visitor(Progress_handle(progress));
  const CGAL::T_splines::Motorcycle_graph_report report =
      CGAL::T_splines::trace_motorcycle_graph(map, t.mesh, t.knots, t.corners, np);
  progress.end_stage();
  if (!report.success())
    return message(report.status);
  t.roots.emplace(t.mesh, t.anchors);
  for (const Vertex v : map.mesh().vertices())
    t.samples.add(places[v].face, places[v].u, places[v].v, map.mesh().point(v));
  figures.tracing.motorcycles = report.motorcycles;
  figures.tracing.seeds = report.seeds;
  figures.tracing.crossed_faces = report.crossed_faces;
  figures.tracing.predicate_calls = report.predicates.calls;
  figures.tracing.exact_predicate_calls = report.predicates.exact_calls;
  figures.traced = figures_of(t);
  return {};
}

/// Finds where a T-mesh lies that operations have changed. \return why that is not known; empty if it is.
inline std::string place(const Exact_map& map, Progress& progress, Surface_t_mesh& t)
{
  progress.begin_stage("placing");
  const auto np = CGAL::T_splines::parameters::edge_polyline_map(t.polylines);
  const bool is_placed = CGAL::T_splines::place_T_mesh(map, t.mesh, t.knots, t.corners, *t.roots, np);
  progress.end_stage();
  return is_placed ? "" : "the changed T-mesh does not fit on the surface";
}

/// Makes the faces of the motorcycle graph squarer, and finds where they lie then.
/// \return why that is not known; empty if it is.
inline std::string regularize(const Exact_map& map, Progress& progress, Surface_t_mesh& t,
                              Regularization_figures& figures)
{
  progress.begin_stage("regularization");
  const CGAL::T_splines::T_mesh_visitor_pair<Roots, Samples::Visitor> visitor(*t.roots, t.samples.visitor());
  const CGAL::T_splines::T_mesh_regularization_report report =
      CGAL::T_splines::regularize_T_mesh(t.mesh, t.knots, t.corners, CGAL::parameters::visitor(visitor));
  figures.operations = {
      {"removals", report.removals}, {"flips", report.flips}, {"partial_removals", report.partial_removals}};
  figures.t_mesh = figures_of(t);
  return place(map, progress, t);
}

#endif // MESH_TO_T_SPLINE_T_MESH_STAGE_H
