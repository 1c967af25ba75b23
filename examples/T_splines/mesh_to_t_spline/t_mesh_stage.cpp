// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "t_mesh_stage.h"

#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>
#include <CGAL/T_splines/T_mesh/carry_surface.h>
#include <CGAL/T_splines/T_mesh/place_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/T_mesh/trace_motorcycle_graph.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Exact_map = CGAL::T_splines::Seamless_map<Mesh, Exact_number>;
using Exact_report = CGAL::T_splines::Exact_map_report<Mesh>;

/// What the report names, as the files count: from 0.
std::string describe(const Exact_report& report, const Mesh& mesh)
{
  using Status = CGAL::T_splines::Exact_map_status;
  constexpr std::size_t longest = 24; // of the list of faces
  if (report.status == Status::INVALID_MESH)
    return message(report.mesh.status);
  std::ostringstream text;
  text << message(report.status);
  if (!report.faces.empty()) {
    text << ": " << report.faces.size() << (report.faces.size() == 1 ? " face, " : " faces, ");
    for (std::size_t i = 0; i < std::min(longest, report.faces.size()); ++i)
      text << (i == 0 ? "" : " ") << static_cast<std::size_t>(report.faces[i]);
    text << (report.faces.size() > longest ? " ...; counted from 0" : "; counted from 0");
  }
  if (report.vertex != Mesh::null_vertex())
    text << ": vertex " << static_cast<std::size_t>(report.vertex) << ", counted from 0";
  if (report.halfedge != Mesh::null_halfedge())
    text << ": edge from vertex " << static_cast<std::size_t>(mesh.source(report.halfedge)) << " to vertex "
         << static_cast<std::size_t>(mesh.target(report.halfedge)) << " of face "
         << static_cast<std::size_t>(mesh.face(report.halfedge)) << ", counted from 0";
  if (report.deviation > 0 && report.faces.empty())
    text << " (off by " << report.deviation << ")";
  return text.str();
}

/// \return why there is no exactly seamless map; empty if there is one.
std::string compute_exact_map(const Refined_map& refined, Exact_map& map, Exact_map_figures& figures)
{
  const Exact_report report = CGAL::T_splines::make_exactly_seamless(refined.mesh, refined.uv, map);
  if (!report.success())
    return describe(report, refined.mesh);
  figures.status = message(report.status);
  figures.cut_edges = report.number_of_cut_edges;
  figures.branches = report.number_of_branches;
  figures.cones = report.number_of_cones;
  figures.determined_corners = report.number_of_determined_corners;
  figures.scale_bits = report.scale_bits;
  figures.is_isometric = report.is_isometric;
  figures.deviation = report.deviation;
  figures.largest_displacement = report.largest_displacement;
  figures.joined_lines = report.number_of_joined_lines;
  figures.lines_left_apart = report.number_of_lines_left_apart;
  figures.largest_gap = report.largest_gap;
  return {};
}

/// What a map that was read does not tell: its cut, its transitions, its cones.
void take_structure(const Exact_map& map, Refined_map& refined, Figures::Signature& figures)
{
  for (const Edge e : refined.mesh.edges()) {
    refined.is_cut[e] = map.is_cut(e);
    for (const Halfedge h : {refined.mesh.halfedge(e), refined.mesh.opposite(refined.mesh.halfedge(e))}) {
      const CGAL::T_splines::Similarity_2<Exact_number> t = map.transition(h);
      refined.transition[h] =
          Transition(t.quarter_turns(), CGAL::to_double(t.scale()), CGAL::to_double(t.u()), CGAL::to_double(t.v()));
    }
  }
  for (const Vertex v : refined.mesh.vertices())
    if (map.quarter_turns(v) != (refined.mesh.is_border(v) ? 2 : 4))
      figures.cones.emplace_back(static_cast<std::size_t>(v), map.quarter_turns(v));
}

/// \return why there is no T-mesh; empty if there is one.
std::string trace(const Options& options, const Exact_map& map, Progress& progress, Surface_t_mesh& t,
                  T_mesh_stage_figures& figures)
{
  namespace P = CGAL::T_splines::parameters;
  const auto np = P::edge_polyline_map(t.polylines, P::face_anchor_map(t.anchors)).visitor(Progress_handle(progress));
  const CGAL::T_splines::Motorcycle_graph_report report = CGAL::T_splines::trace_motorcycle_graph(map, t.t_mesh, np);
  progress.end_stage();
  if (!report.success())
    return message(report.status);
  figures.tracing.motorcycles = report.motorcycles;
  figures.tracing.seeds = report.seeds;
  figures.tracing.crossed_faces = report.crossed_faces;
  figures.tracing.predicate_calls = report.predicates.calls;
  figures.tracing.exact_predicate_calls = report.predicates.exact_calls;
  figures.traced = figures_of(t.t_mesh);
  if (options.has_spline)
    t.surface = CGAL::T_splines::carry_surface(map, t.t_mesh, t.anchors);
  return {};
}

/// Makes the faces of the motorcycle graph squarer, and finds where they lie then.
/// \return why that is not known; empty if it is.
std::string regularize(const Exact_map& map, Progress& progress, Surface_t_mesh& t, Regularization_figures& figures)
{
  progress.begin_stage("regularization");
  using Roots = CGAL::T_splines::T_mesh_roots<Mesh, Graph, Exact_number>;
  Roots roots(t.t_mesh.graph(), t.anchors);
  const CGAL::T_splines::T_mesh_visitor_pair visitor(roots, t.surface.visitor());
  const CGAL::T_splines::T_mesh_regularization_report report =
      CGAL::T_splines::regularize_T_mesh(t.t_mesh, CGAL::parameters::visitor(visitor));
  figures.operations = {{"removals", report.removals},
                        {"flips", report.flips},
                        {"partial_removals", report.partial_removals},
                        {"closed_gaps", report.closed_gaps}};
  figures.t_mesh = figures_of(t.t_mesh);
  progress.begin_stage("placing");
  const auto np = CGAL::T_splines::parameters::edge_polyline_map(t.polylines);
  const bool is_placed = CGAL::T_splines::place_T_mesh(map, t.t_mesh, roots, np);
  progress.end_stage();
  return is_placed ? "" : "the changed T-mesh does not fit on the surface";
}

} // namespace

Failure make_t_mesh(const Options& options, Progress& progress, Results& results, Figures& figures)
{
  progress.begin_stage("exact map");
  Exact_map map(results.refined.mesh);
  const bool is_given = !results.has_map;
  std::string failure = compute_exact_map(results.refined, map, figures.exact_map.emplace());
  if (!failure.empty())
    return {options.input_file() + ": " + failure, is_given};
  if (is_given)
    take_structure(map, results.refined, figures.signature);
  Surface_t_mesh& t = results.t_mesh;
  failure = trace(options, map, progress, t, figures.t_mesh.emplace());
  if (!failure.empty())
    return {options.input_file() + ": " + failure};
  results.traced = drawing_of(t);
  if (options.is_regularized) {
    failure = regularize(map, progress, t, figures.t_mesh->regularization.emplace());
    if (!failure.empty())
      return {options.input_file() + ": " + failure};
    results.regularized = drawing_of(t);
  }
  results.has_t_mesh = true;
  if (!options.has_spline)
    t.t_mesh.graph().collect_garbage(); // not where there is a surface: it names faces
  return {};
}
