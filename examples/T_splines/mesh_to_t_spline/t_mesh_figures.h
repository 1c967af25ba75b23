// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_MESH_FIGURES_H
#define MESH_TO_T_SPLINE_T_MESH_FIGURES_H

#include "Json_writer.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// What was done to make the map exactly seamless.
struct Exact_map_figures {
  std::string status;
  int cut_edges = 0, branches = 0, cones = 0, determined_corners = 0, scale_bits = 0;
  bool is_isometric = true;
  double deviation = 0, largest_displacement = 0;
  int joined_lines = 0, lines_left_apart = 0; ///< isolines that connect cones up to round-off: made exact, or not
  double largest_gap = 0;
};

/// The motorcycles.
struct Tracing_figures {
  std::size_t motorcycles = 0, seeds = 0, crossed_faces = 0, predicate_calls = 0, exact_predicate_calls = 0;
};

/// A T-mesh as it is at some time.
struct T_mesh_figures {
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t t_joints = 0; ///< vertices where a face goes straight on
  double worst_aspect_ratio = 1, median_aspect_ratio = 1;
  std::vector<std::size_t> aspect_histogram; ///< entry i: number of faces with a ratio from 2^i to 2^(i + 1)
};

/// What regularization did: the number of operations of each kind.
struct Regularization_figures {
  std::vector<std::pair<std::string, std::size_t>> operations;
  T_mesh_figures t_mesh;
};

inline void write_exact_map_figures(Json_writer& json, const Exact_map_figures& figures)
{
  json.key("exact_map").begin_object();
  json.member("status", figures.status).member("deviation", figures.deviation);
  json.member("largest_displacement", figures.largest_displacement);
  json.member("cut_edges", figures.cut_edges).member("branches", figures.branches).member("cones", figures.cones);
  json.member("determined_corners", figures.determined_corners);
  json.member("joined_lines", figures.joined_lines).member("lines_left_apart", figures.lines_left_apart);
  json.member("largest_gap", figures.largest_gap);
  json.member("is_isometric", figures.is_isometric).member("scale_bits", figures.scale_bits);
  json.end_object();
}

inline void write_t_mesh_members(Json_writer& json, const T_mesh_figures& figures)
{
  json.member("vertices", figures.vertices).member("edges", figures.edges).member("faces", figures.faces);
  json.member("t_joints", figures.t_joints);
  json.member("worst_aspect_ratio", figures.worst_aspect_ratio);
  json.member("median_aspect_ratio", figures.median_aspect_ratio);
  json.array_member("aspect_histogram", figures.aspect_histogram);
}

inline void write_tracing_figures(Json_writer& json, const Tracing_figures& figures)
{
  json.key("tracing").begin_object();
  json.member("motorcycles", figures.motorcycles).member("seeds", figures.seeds);
  json.member("crossed_faces", figures.crossed_faces).member("predicate_calls", figures.predicate_calls);
  json.member("exact_predicate_calls", figures.exact_predicate_calls);
  json.end_object();
}

inline void write_regularization_figures(Json_writer& json, const Regularization_figures& figures)
{
  json.key("regularized").begin_object();
  write_t_mesh_members(json, figures.t_mesh);
  json.key("operations").begin_object();
  for (const auto& [name, count] : figures.operations)
    json.member(name.c_str(), count);
  json.end_object();
  json.end_object();
}

#endif // MESH_TO_T_SPLINE_T_MESH_FIGURES_H
