// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H
#define MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H

#include "t_mesh_figures.h"

#include <CGAL/T_splines/IO/internal/Json_writer.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Distances, by the longest side of the bounding box of the mesh: that of the cube which encloses it.
struct Relative_error {
  double rms = 0, maximum = 0;
};

/// The T-spline surface, and how it was fitted.
struct T_spline_figures {
  struct Level {
    std::size_t control_points = 0, faces = 0, control_points_in_rings = 0;
    Relative_error error; ///< at the samples
  };
  struct Deviation {
    Relative_error surface_to_mesh, mesh_to_surface;
  };

  T_mesh_figures t_mesh;
  double longest_side = 0; ///< what distances are divided by
  std::size_t samples = 0, faces_before_fit = 0;
  double tolerance = 0, fairness = 0; ///< the tolerance by the longest side
  std::string status;                 ///< why the fit ended
  bool is_within_tolerance = false;
  std::vector<Level> levels;  ///< from coarse to fine
  std::size_t best_level = 0; ///< the surface
  std::optional<Deviation> deviation;
  std::size_t patches = 0;
  std::map<int, std::size_t> valences; ///< of the extraordinary vertices
  int rings = 0;                       ///< of patches around extraordinary vertices
  double cap_deviation = 0;            ///< by the longest side
  std::size_t tessellation_triangles = 0;

  const Level& level() const { return levels[best_level]; }
  std::string ending() const { return is_within_tolerance ? status : "ended beyond the tolerance: " + status; }
};

inline void write_members(CGAL::T_splines::internal::Json_writer& json, const Relative_error& error)
{
  json.member("rms", error.rms).member("maximum", error.maximum);
}

inline void write_members(CGAL::T_splines::internal::Json_writer& json, const T_spline_figures::Level& level)
{
  json.member("control_points", level.control_points).member("faces", level.faces);
  json.member("control_points_in_rings", level.control_points_in_rings);
  write_members(json, level.error);
}

inline void write_fit_members(CGAL::T_splines::internal::Json_writer& json, const T_spline_figures& figures)
{
  json.member("status", figures.status).member("is_within_tolerance", figures.is_within_tolerance);
  json.member("tolerance", figures.tolerance).member("fairness", figures.fairness);
  json.member("longest_side", figures.longest_side).member("samples", figures.samples);
  json.member("faces_before_fit", figures.faces_before_fit);
  write_members(json, figures.level());
  json.key("levels").begin_array();
  for (const T_spline_figures::Level& level : figures.levels) {
    json.begin_object();
    write_members(json, level);
    json.end_object();
  }
  json.end_array();
  json.member("best_level", figures.best_level);
  if (figures.deviation) {
    json.key("deviation").begin_object();
    json.key("surface_to_mesh").begin_object();
    write_members(json, figures.deviation->surface_to_mesh);
    json.end_object();
    json.key("mesh_to_surface").begin_object();
    write_members(json, figures.deviation->mesh_to_surface);
    json.end_object();
    json.end_object();
  }
}

inline void write_t_spline_figures(CGAL::T_splines::internal::Json_writer& json, const T_spline_figures& figures)
{
  json.key("t_spline").begin_object();
  write_fit_members(json, figures);
  json.key("t_mesh").begin_object();
  write_t_mesh_members(json, figures.t_mesh);
  json.end_object();
  json.member("patches", figures.patches);
  std::size_t number = 0;
  for (const auto& valence : figures.valences)
    number += valence.second;
  json.member("extraordinary_vertices", number);
  json.key("valences").begin_object();
  for (const auto& [valence, count] : figures.valences)
    json.member(std::to_string(valence).c_str(), count);
  json.end_object();
  json.member("rings_of_patches", figures.rings).member("cap_deviation", figures.cap_deviation);
  json.member("tessellation_triangles", figures.tessellation_triangles);
  json.end_object();
}

#endif // MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H
