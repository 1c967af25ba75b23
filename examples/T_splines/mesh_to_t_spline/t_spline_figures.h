// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H
#define MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H

#include "t_mesh_figures.h"

#include <CGAL/T_splines/IO/internal/Json_writer.h>

#include <cstddef>
#include <map>
#include <string>

/// The T-spline surface.
struct T_spline_figures {
  T_mesh_figures t_mesh; ///< refined and spline compatible
  std::size_t splits_for_size = 0;
  std::size_t splits_for_rings = 0, splits_at_border = 0, splits_for_supports = 0; ///< for spline compatibility
  std::size_t added_vertices = 0, vertices_in_rings = 0;                           ///< likewise
  std::size_t control_points = 0, patches = 0;
  std::map<int, std::size_t> valences; ///< of the extraordinary vertices
  int rings = 0;                       ///< of patches around extraordinary vertices
  double cap_deviation = 0;            ///< by the diagonal of the bounding box
  std::size_t tessellation_triangles = 0;
};

inline void write_t_spline_figures(CGAL::T_splines::internal::Json_writer& json, const T_spline_figures& figures)
{
  json.key("t_spline").begin_object();
  json.key("t_mesh").begin_object();
  write_t_mesh_members(json, figures.t_mesh);
  json.end_object();
  json.member("control_points", figures.control_points).member("patches", figures.patches);
  std::size_t number = 0;
  for (const auto& valence : figures.valences)
    number += valence.second;
  json.member("extraordinary_vertices", number);
  json.key("valences").begin_object();
  for (const auto& [valence, count] : figures.valences)
    json.member(std::to_string(valence).c_str(), count);
  json.end_object();
  json.member("splits_for_size", figures.splits_for_size).member("splits_for_rings", figures.splits_for_rings);
  json.member("splits_at_border", figures.splits_at_border).member("splits_for_supports", figures.splits_for_supports);
  json.member("added_vertices", figures.added_vertices).member("vertices_in_rings", figures.vertices_in_rings);
  json.member("rings_of_patches", figures.rings).member("cap_deviation", figures.cap_deviation);
  json.member("tessellation_triangles", figures.tessellation_triangles);
  json.end_object();
}

#endif // MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H
