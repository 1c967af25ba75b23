// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_EXACT_MAP_STAGE_H
#define MESH_TO_T_SPLINE_EXACT_MAP_STAGE_H

#include "Figures.h"
#include "Refined_map.h"

#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>

using Exact_number = CGAL::Exact_rational;
using Exact_map = CGAL::T_splines::Seamless_map<Mesh, Exact_number>;
using Exact_report = CGAL::T_splines::Exact_map_report<Mesh>;

/// What the report names, as the files count: from 0.
inline std::string describe(const Exact_report& report, const Mesh& mesh)
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
inline std::string compute_exact_map(const Refined_map& refined, Exact_map& map, Exact_map_figures& figures)
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
  return {};
}

/// What a map that was read does not tell: its cut, its transitions, its cones.
inline void take_structure(const Exact_map& map, Refined_map& refined, Figures::Signature& figures)
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

#endif // MESH_TO_T_SPLINE_EXACT_MAP_STAGE_H
