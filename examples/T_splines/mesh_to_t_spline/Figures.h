// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_FIGURES_H
#define MESH_TO_T_SPLINE_FIGURES_H

#include "Json_writer.h"
#include "t_mesh_figures.h"
#include "t_spline_figures.h"

#include <CGAL/T_splines/IO/Mesh_reading_report.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// How the map was computed.
struct Map_figures {
  std::string status, solver, flip_policy;
  bool converged = false;
  double residual = 0, tolerance = 0;
  std::vector<double> residual_history;
  int iterations = 0, halvings = 0, factorizations = 0, linear_iterations = 0, mantissa_bits = 53;
  std::size_t delaunay_flips = 0, flips = 0;
};

/// The T-mesh from the motorcycles on.
struct T_mesh_stage_figures {
  Tracing_figures tracing;
  T_mesh_figures traced;
  std::optional<Regularization_figures> regularization;
};

/// What became of the holes of the input.
struct Hole_figures {
  std::size_t filled = 0, faces = 0, larger = 0, failed = 0;
};

/// Every number of a run: what the summary, `report.json` and `report.html` show.
struct Figures {
  struct Input {
    std::string name, path, note;
    std::size_t merged_vertices = 0;
    double merged_distance = 0; ///< by the longest side of the bounding box
    CGAL::T_splines::Mesh_repairs repairs;
    std::size_t vertices = 0, edges = 0, faces = 0, components = 0,
                borders = 0; ///< closed curves of the border
    long genus = 0;          ///< of all components together
    std::optional<Hole_figures> holes;
  };
  /// What was done to the cones of a computed field.
  struct Cone_reduction {
    int cones_before = 0, cones = 0, loop_turns = 0, splits = 0, merges = 0;
    double energy_before = 0, energy = 0;
  };
  /// The features that were found or given.
  struct Features {
    std::string source;
    std::size_t edges = 0, arcs = 0, closed_arcs = 0, corners = 0, darts = 0;
    std::size_t added_faces = 0;                                 ///< by the refinement at features
    std::vector<std::pair<std::size_t, std::size_t>> soft_edges; ///< that the field does not follow: their vertices
    std::size_t edges_of_map = 0, edges_not_met = 0;             ///< of the refined mesh of the map
    std::string given_up; ///< what was wrong with the surface along them; empty if it is sharp there
  };
  /// What the alignment of the map did.
  struct Alignment {
    std::string status;
    bool is_aligned = false;
    double mean_before = 0, mean_rotated = 0, mean = 0; ///< of the angle between field and isolines, in degrees
    double most_before = 0, most_rotated = 0, most = 0; ///< that it exceeds on 5 % of the area
    double mean_distortion = 0, largest_distortion = 0;
    double largest_scale_before = 1, largest_scale = 1;
    int steps = 0;
  };
  struct Signature {
    std::string source;
    std::optional<Cone_reduction> reduction;
    std::vector<std::pair<std::size_t, int>> cones;   ///< vertex of the input, quarter turns
    std::vector<std::pair<std::size_t, int>> corners; ///< vertex of the input, quarter turns
    std::vector<int> loops, arcs;
  };
  struct Transition {
    int quarter_turns;
    double scale;
    std::size_t edges;
  };
  struct Refined {
    std::size_t vertices = 0, faces = 0, cut_edges = 0;
    double scale_range = 1; ///< largest over smallest length in the plane per length in space, over the triangles
    std::vector<Transition> transitions;
  };
  struct Stage {
    std::string name;
    double seconds;
    std::size_t peak_memory_bytes; ///< of the program until the stage's end; 0: not known
  };

  std::string version;
  Input input;
  Signature signature;
  std::optional<Features> features;   ///< none if there are none
  std::optional<Map_figures> map;     ///< none if a given map was read
  std::optional<Alignment> alignment; ///< none if the map is the conformal one
  Refined refined;
  std::optional<Exact_map_figures> exact_map;
  std::optional<T_mesh_stage_figures> t_mesh;
  std::optional<T_spline_figures> t_spline;
  std::vector<Stage> stages;
  double seconds = 0;
  std::size_t peak_memory_bytes = 0; ///< 0: not known
};

inline void write_input_members(Json_writer& json, const Figures::Input& input)
{
  json.member("name", input.name).member("path", input.path).member("note", input.note);
  json.member("merged_vertices", input.merged_vertices).member("merged_distance", input.merged_distance);
  json.key("repairs").begin_object();
  json.member("degenerate_faces", input.repairs.degenerate_faces);
  json.member("shortened_faces", input.repairs.shortened_faces);
  json.member("duplicate_faces", input.repairs.duplicate_faces);
  json.member("reversed_faces", input.repairs.reversed_faces);
  json.member("split_vertices", input.repairs.split_vertices);
  json.member("isolated_vertices", input.repairs.isolated_vertices);
  json.member("flat_triangles", input.repairs.flat_triangles);
  json.end_object();
  json.member("vertices", input.vertices).member("edges", input.edges).member("faces", input.faces);
  json.member("components", input.components).member("borders", input.borders).member("genus", input.genus);
  if (input.holes) {
    json.key("holes").begin_object();
    json.member("filled", input.holes->filled).member("faces", input.holes->faces);
    json.member("larger", input.holes->larger).member("failed", input.holes->failed);
    json.end_object();
  }
}

inline void write_map_figures(Json_writer& json, const Map_figures& map)
{
  json.key("map").begin_object();
  json.member("status", map.status).member("converged", map.converged);
  json.member("residual", map.residual).member("tolerance", map.tolerance);
  json.array_member("residual_history", map.residual_history);
  json.member("iterations", map.iterations).member("halvings", map.halvings);
  json.member("factorizations", map.factorizations).member("linear_iterations", map.linear_iterations);
  json.member("delaunay_flips", map.delaunay_flips).member("flips", map.flips);
  json.member("mantissa_bits", map.mantissa_bits);
  json.member("solver", map.solver).member("flip_policy", map.flip_policy);
  json.end_object();
}

inline void write_features_figures(Json_writer& json, const Figures::Features& features)
{
  json.key("features").begin_object();
  json.member("source", features.source).member("edges", features.edges).member("arcs", features.arcs);
  json.member("closed_arcs", features.closed_arcs).member("corners", features.corners).member("darts", features.darts);
  json.member("added_faces", features.added_faces);
  json.key("soft_edges").begin_array();
  for (const auto& [from, to] : features.soft_edges)
    json.begin_object().member("from", from).member("to", to).end_object();
  json.end_array();
  json.member("edges_of_map", features.edges_of_map).member("edges_not_met", features.edges_not_met);
  if (!features.given_up.empty())
    json.member("given_up", features.given_up);
  json.end_object();
}

inline void write_alignment_figures(Json_writer& json, const Figures::Alignment& alignment)
{
  json.key("alignment").begin_object();
  json.member("status", alignment.status).member("is_aligned", alignment.is_aligned);
  json.member("mean_before", alignment.mean_before).member("mean_rotated", alignment.mean_rotated);
  json.member("mean", alignment.mean).member("quantile_95_before", alignment.most_before);
  json.member("quantile_95_rotated", alignment.most_rotated).member("quantile_95", alignment.most);
  json.member("mean_distortion", alignment.mean_distortion);
  json.member("largest_distortion", alignment.largest_distortion);
  json.member("largest_scale_before", alignment.largest_scale_before);
  json.member("largest_scale", alignment.largest_scale).member("steps", alignment.steps);
  json.end_object();
}

inline void write_signature_figures(Json_writer& json, const Figures::Signature& signature)
{
  json.key("signature").begin_object();
  json.member("source", signature.source);
  if (signature.reduction) {
    const Figures::Cone_reduction& reduction = *signature.reduction;
    json.key("cone_reduction").begin_object();
    json.member("cones_before", reduction.cones_before).member("cones", reduction.cones);
    json.member("loop_turns", reduction.loop_turns).member("splits", reduction.splits);
    json.member("merges", reduction.merges);
    json.member("energy_before", reduction.energy_before).member("energy", reduction.energy);
    json.end_object();
  }
  json.key("cones").begin_array();
  for (const auto& [vertex, k] : signature.cones)
    json.begin_object().member("vertex", vertex).member("quarter_turns", k).end_object();
  json.end_array();
  json.key("corners").begin_array();
  for (const auto& [vertex, k] : signature.corners)
    json.begin_object().member("vertex", vertex).member("quarter_turns", k).end_object();
  json.end_array();
  json.array_member("loops", signature.loops).array_member("arcs", signature.arcs);
  json.end_object();
}

inline void write_refined_figures(Json_writer& json, const Figures::Refined& refined)
{
  json.key("refined").begin_object();
  json.member("vertices", refined.vertices).member("faces", refined.faces).member("cut_edges", refined.cut_edges);
  json.member("scale_range", refined.scale_range);
  json.key("transitions").begin_array();
  for (const Figures::Transition& transition : refined.transitions)
    json.begin_object()
        .member("quarter_turns", transition.quarter_turns)
        .member("scale", transition.scale)
        .member("edges", transition.edges)
        .end_object();
  json.end_array();
  json.end_object();
}

inline void write_t_mesh_figures(Json_writer& json, const T_mesh_stage_figures& figures)
{
  json.key("t_mesh").begin_object();
  write_tracing_figures(json, figures.tracing);
  json.key("traced").begin_object();
  write_t_mesh_members(json, figures.traced);
  json.end_object();
  if (figures.regularization)
    write_regularization_figures(json, *figures.regularization);
  json.end_object();
}

/// The content of `report.json`.
inline std::string figures_as_json(const Figures& figures)
{
  Json_writer json;
  json.begin_object();
  json.member("program", "mesh_to_t_spline").member("version", figures.version);
  json.key("input").begin_object();
  write_input_members(json, figures.input);
  json.end_object();
  if (figures.features)
    write_features_figures(json, *figures.features);
  write_signature_figures(json, figures.signature);
  if (figures.map)
    write_map_figures(json, *figures.map);
  if (figures.alignment)
    write_alignment_figures(json, *figures.alignment);
  write_refined_figures(json, figures.refined);
  if (figures.exact_map)
    write_exact_map_figures(json, *figures.exact_map);
  if (figures.t_mesh)
    write_t_mesh_figures(json, *figures.t_mesh);
  if (figures.t_spline)
    write_t_spline_figures(json, *figures.t_spline);
  json.key("stages").begin_array();
  for (const Figures::Stage& stage : figures.stages)
    json.begin_object()
        .member("name", stage.name)
        .member("seconds", stage.seconds)
        .member("peak_memory_bytes", stage.peak_memory_bytes)
        .end_object();
  json.end_array();
  json.member("seconds", figures.seconds).member("peak_memory_bytes", figures.peak_memory_bytes);
  json.end_object();
  return json.text() + "\n";
}

#endif // MESH_TO_T_SPLINE_FIGURES_H
