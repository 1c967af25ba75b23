// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H
#define MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H

#include "Json_writer.h"
#include "t_mesh_figures.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Distances, by the longest side of the bounding box of the mesh: that of the cube which encloses it.
struct Relative_error {
  double rms = 0, maximum = 0;
};

/// How far surface and mesh are apart, as measured after the fit.
struct Deviation_figures {
  /// A place of the surface and the face of the mesh next to it, counted from 0.
  struct Place {
    std::array<double, 3> point = {};
    std::size_t t_mesh_face = 0;
    double u = 0, v = 0;
    std::size_t mesh_face = 0;
    std::optional<std::array<std::size_t, 2>> mesh_edge; ///< its vertices, if the place is on the border or a crease
  };
  struct One_way {
    Relative_error error;
    double upper_bound = 0; ///< proven
    double share_within_tolerance = 0, share_within_half = 0;
    Place worst;
  };
  struct Both_ways {
    One_way surface_to_mesh, mesh_to_surface;

    double rms() const { return std::max(surface_to_mesh.error.rms, mesh_to_surface.error.rms); }
    double maximum() const { return std::max(surface_to_mesh.error.maximum, mesh_to_surface.error.maximum); }
    double upper_bound() const { return std::max(surface_to_mesh.upper_bound, mesh_to_surface.upper_bound); }
    const Place& worst() const
    {
      return (surface_to_mesh.error.maximum > mesh_to_surface.error.maximum ? surface_to_mesh : mesh_to_surface).worst;
    }
  };
  /// The same of the borders or creases, with shares of their lengths.
  struct Of_curves : Both_ways {
    std::size_t corners = 0;            ///< of the surface
    double largest_corner_distance = 0; ///< from the vertex of the mesh closest to a corner
  };

  Both_ways of_surface;
  std::optional<Of_curves> free_edge; ///< if there is a border
  std::optional<Of_curves> crease;    ///< if there are creases
  double largest_angle = 0;           ///< between normals, in degrees
  Place worst_angle;
  std::size_t folded_patches = 0, doubtful_patches = 0, certified_patches = 0;
  std::size_t self_intersections = 0;             ///< pairs of triangles of t_spline.obj
  std::size_t self_intersections_of_mesh = 0;     ///< pairs of triangles of the mesh
  std::size_t self_intersections_beyond_mesh = 0; ///< pairs of t_spline.obj where the mesh has none
  std::array<double, 3> self_intersection = {};   ///< the place of one of them

  bool is_surface_within(const double tolerance) const { return of_surface.maximum() <= tolerance; }
  bool is_border_within(const double tolerance) const { return !free_edge || free_edge->maximum() <= tolerance; }
  bool are_creases_within(const double tolerance) const { return !crease || crease->maximum() <= tolerance; }
};

/// The T-spline surface, and how it was fitted.
struct T_spline_figures {
  struct Level {
    std::size_t control_points = 0, faces = 0, control_points_in_rings = 0, folded_faces = 0;
    Relative_error error; ///< at the samples
  };

  T_mesh_figures t_mesh;
  double longest_side = 0; ///< what distances are divided by
  std::size_t samples = 0, faces_before_fit = 0;
  double tolerance = 0, fairness = 0;   ///< the tolerance by the longest side
  std::string status;                   ///< why the fit ended
  bool fit_is_within_tolerance = false; ///< at the samples
  std::vector<Level> levels;            ///< from coarse to fine
  std::size_t best_level = 0;           ///< the surface
  std::optional<Deviation_figures> deviation;
  std::size_t patches = 0;
  std::map<int, std::size_t> valences; ///< of the extraordinary vertices
  std::map<int, std::size_t> corners;  ///< of the border, by quarter turns
  std::size_t creases = 0;             ///< edges of the T-mesh that are creases
  int rings = 0;                       ///< of patches around extraordinary vertices
  double cap_deviation = 0;            ///< by the longest side
  std::size_t tessellation_triangles = 0;

  const Level& level() const { return levels[best_level]; }
  std::string ending() const { return fit_is_within_tolerance ? status : "ended beyond the tolerance: " + status; }

  /// Whether the surface, its border and its creases are what was asked for, as measured: both ways, between the samples, too.
  bool is_within_tolerance() const
  {
    return deviation && deviation->is_surface_within(tolerance) && deviation->is_border_within(tolerance) &&
           deviation->are_creases_within(tolerance);
  }
  bool is_faultless() const
  {
    return is_within_tolerance() && deviation->folded_patches == 0 && deviation->self_intersections_beyond_mesh == 0;
  }
};

inline std::string counted(const std::size_t number, const char* one, const char* more)
{
  return std::to_string(number) + " " + (number == 1 ? one : more);
}

/// What is to be said of the surface first: within the tolerance, or what is wrong.
inline std::string verdict(const T_spline_figures& figures)
{
  std::string text = figures.is_within_tolerance() ? "within the tolerance" : "beyond the tolerance";
  if (!figures.deviation)
    return text;
  if (figures.deviation->is_surface_within(figures.tolerance) && !figures.is_within_tolerance())
    text += figures.deviation->is_border_within(figures.tolerance) ? " along the creases" : " along the border";
  const char* separator = figures.is_within_tolerance() ? ", but " : ", ";
  if (figures.deviation->folded_patches > 0) {
    text += separator + counted(figures.deviation->folded_patches, "patch has a fold", "patches have folds");
    separator = ", ";
  }
  if (figures.deviation->self_intersections_beyond_mesh > 0)
    text += separator +
            counted(figures.deviation->self_intersections_beyond_mesh, "self-intersection", "self-intersections");
  return text;
}

inline void write_members(Json_writer& json, const Relative_error& error)
{
  json.member("rms", error.rms).member("maximum", error.maximum);
}

inline void write_members(Json_writer& json, const T_spline_figures::Level& level)
{
  json.member("control_points", level.control_points).member("faces", level.faces);
  json.member("control_points_in_rings", level.control_points_in_rings).member("folded_faces", level.folded_faces);
  write_members(json, level.error);
}

inline void write_place(Json_writer& json, const char* name, const Deviation_figures::Place& place)
{
  json.key(name).begin_object().array_member("point", place.point).member("t_mesh_face", place.t_mesh_face);
  json.member("u", place.u).member("v", place.v).member("mesh_face", place.mesh_face);
  if (place.mesh_edge)
    json.array_member("mesh_edge", *place.mesh_edge);
  json.end_object();
}

inline void write_one_way(Json_writer& json, const char* name, const Deviation_figures::One_way& way)
{
  json.key(name).begin_object();
  write_members(json, way.error);
  json.member("upper_bound", way.upper_bound).member("share_within_tolerance", way.share_within_tolerance);
  json.member("share_within_half", way.share_within_half);
  write_place(json, "worst", way.worst);
  json.end_object();
}

inline void write_both_ways(Json_writer& json, const Deviation_figures::Both_ways& both)
{
  json.member("maximum", both.maximum()).member("upper_bound", both.upper_bound());
  write_place(json, "worst", both.worst());
  write_one_way(json, "surface_to_mesh", both.surface_to_mesh);
  write_one_way(json, "mesh_to_surface", both.mesh_to_surface);
}

inline void write_of_curves(Json_writer& json, const char* name, const Deviation_figures::Of_curves& curves)
{
  json.key(name).begin_object();
  json.member("rms", curves.rms());
  write_both_ways(json, curves);
  json.member("corners", curves.corners).member("largest_corner_distance", curves.largest_corner_distance);
  json.end_object();
}

inline void write_deviation(Json_writer& json, const Deviation_figures& deviation)
{
  json.key("deviation").begin_object();
  write_both_ways(json, deviation.of_surface);
  json.member("largest_angle", deviation.largest_angle);
  write_place(json, "worst_angle", deviation.worst_angle);
  json.member("folded_patches", deviation.folded_patches).member("doubtful_patches", deviation.doubtful_patches);
  json.member("certified_patches", deviation.certified_patches);
  json.member("self_intersections", deviation.self_intersections);
  json.member("self_intersections_of_mesh", deviation.self_intersections_of_mesh);
  json.member("self_intersections_beyond_mesh", deviation.self_intersections_beyond_mesh);
  if (deviation.self_intersections_beyond_mesh > 0)
    json.array_member("self_intersection", deviation.self_intersection);
  if (deviation.free_edge)
    write_of_curves(json, "free_edge", *deviation.free_edge);
  if (deviation.crease)
    write_of_curves(json, "crease", *deviation.crease);
  json.end_object();
}

inline void write_fit_members(Json_writer& json, const T_spline_figures& figures)
{
  json.member("verdict", verdict(figures)).member("is_faultless", figures.is_faultless());
  json.member("is_within_tolerance", figures.is_within_tolerance());
  json.member("status", figures.status).member("fit_is_within_tolerance", figures.fit_is_within_tolerance);
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
  if (figures.deviation)
    write_deviation(json, *figures.deviation);
}

inline void write_t_spline_figures(Json_writer& json, const T_spline_figures& figures)
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
  const auto write_counts = [&](const char* name, const std::map<int, std::size_t>& counts) {
    json.key(name).begin_object();
    for (const auto& [key, count] : counts)
      json.member(std::to_string(key).c_str(), count);
    json.end_object();
  };
  write_counts("valences", figures.valences);
  write_counts("corners", figures.corners);
  json.member("creases", figures.creases);
  json.member("rings_of_patches", figures.rings).member("cap_deviation", figures.cap_deviation);
  json.member("tessellation_triangles", figures.tessellation_triangles);
  json.end_object();
}

#endif // MESH_TO_T_SPLINE_T_SPLINE_FIGURES_H
