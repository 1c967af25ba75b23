// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_SUMMARY_H
#define MESH_TO_T_SPLINE_SUMMARY_H

#include "Figures.h"

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// How many vertices have each number of quarter turns, in parentheses.
inline void print_counts(std::ostream& out, const std::vector<std::pair<std::size_t, int>>& quarter_turns)
{
  std::map<int, std::size_t> counts;
  for (const auto& vertex_and_number : quarter_turns)
    ++counts[vertex_and_number.second];
  const char* separator = " (";
  for (const auto& [k, count] : counts) {
    out << separator << "k = " << k << ": " << count;
    separator = ", ";
  }
  out << (counts.empty() ? "" : ")");
}

inline void print_signature(std::ostream& out, const Figures::Signature& signature)
{
  out << "  signature   " << signature.source << ": ";
  const auto& reduction = signature.reduction;
  if (reduction && reduction->merges + reduction->splits > 0)
    out << reduction->cones_before
        << (reduction->cones < reduction->cones_before ? " cones reduced to " : " cones split to ") << reduction->cones;
  else
    out << signature.cones.size() << (signature.cones.size() == 1 ? " cone" : " cones");
  print_counts(out, signature.cones);
  if (!signature.corners.empty()) {
    out << ", " << signature.corners.size() << (signature.corners.size() == 1 ? " corner" : " corners");
    print_counts(out, signature.corners);
  }
  if (!signature.loops.empty()) {
    out << ", loops";
    for (const int k : signature.loops)
      out << " " << k;
  }
  if (!signature.arcs.empty()) {
    out << ", arcs";
    for (const int k : signature.arcs)
      out << " " << k;
  }
  out << "\n";
}

/// The scale factors of the transitions, or how many there are and how large.
inline void print_scales(std::ostream& out, const std::vector<Figures::Transition>& transitions)
{
  constexpr std::size_t most = 8;
  constexpr double tolerance = 1e-9;
  std::vector<double> scales;
  for (const Figures::Transition& t : transitions) // sorted by scale
    if (scales.empty() || t.scale > scales.back() * (1 + tolerance))
      scales.push_back(t.scale);
  out << "  scales      " << std::setprecision(8);
  if (scales.size() > most)
    out << scales.size() << " factors from " << scales.front() << " to " << scales.back();
  else if (scales.empty())
    out << "no cut";
  else
    for (const double& s : scales)
      out << (&s == &scales.front() ? "" : ", ") << s;
}

inline void print_t_mesh(std::ostream& out, const char* name, const T_mesh_figures& t_mesh)
{
  out << name << t_mesh.faces << " faces, " << t_mesh.vertices << " vertices, " << t_mesh.t_joints
      << " T-joints; aspect ratio at worst 1:" << std::setprecision(3) << t_mesh.worst_aspect_ratio
      << ", median 1:" << t_mesh.median_aspect_ratio << "\n";
}

inline void print_exact_map(std::ostream& out, const Exact_map_figures& exact)
{
  out << "  exact map   " << exact.cut_edges << " cut edges in " << exact.branches << " branches, "
      << exact.determined_corners << " corners that are no doubles, ";
  if (exact.is_isometric)
    out << "all scale factors are 1\n";
  else
    out << "scale factors of " << exact.scale_bits << " bits\n";
  if (exact.joined_lines + exact.lines_left_apart > 0)
    out << "              " << exact.joined_lines << " isolines from cone to cone joined exactly, "
        << exact.lines_left_apart << " not\n";
}

inline void print_tracing(std::ostream& out, const Tracing_figures& tracing)
{
  const double share = tracing.predicate_calls == 0 ? 100
                                                    : 100 - 100 * static_cast<double>(tracing.exact_predicate_calls) /
                                                                static_cast<double>(tracing.predicate_calls);
  out << "  tracing     " << tracing.motorcycles << " motorcycles, " << tracing.seeds << " seeds, "
      << tracing.crossed_faces << " crossed triangles; " << std::setprecision(6) << share << " % of "
      << tracing.predicate_calls << " predicate calls answered by the filter\n";
}

/// A share in percent, with `digits` digits.
inline std::string percent(const double share, const int digits = 3)
{
  std::ostringstream text;
  text << std::setprecision(digits) << 100 * share << " %";
  return text.str();
}

/// A share in percent with two decimals, rounded down: 100 % only if it is all.
inline std::string share_in_percent(const double share)
{
  std::ostringstream text;
  text << std::floor(1e4 * share) / 100 << " %";
  return text.str();
}

/// The levels of the fit, one line each.
inline void print_levels(std::ostream& out, const T_spline_figures& spline)
{
  out << "  fitting     level  control points  in rings   folded        rms        max  (faces; distances by the "
         "longest side)\n";
  for (std::size_t i = 0; i < spline.levels.size(); ++i) {
    const T_spline_figures::Level& level = spline.levels[i];
    out << std::setw(19) << i << std::setw(16) << level.control_points << std::setw(10) << level.control_points_in_rings
        << std::setw(9) << level.folded_faces << std::setw(11) << percent(level.error.rms) << std::setw(11)
        << percent(level.error.maximum)
        << (i == spline.best_level && i + 1 < spline.levels.size() ? "  the best\n" : "\n");
  }
}

inline void print_one_way(std::ostream& out, const char* name, const Deviation_figures::One_way& way,
                          const char* measure = "area")
{
  out << "              " << name << ": rms " << percent(way.error.rms) << ", max " << percent(way.error.maximum)
      << " (proven: at most " << percent(way.upper_bound) << "); " << share_in_percent(way.share_within_tolerance)
      << " of the " << measure << " within the tolerance, " << share_in_percent(way.share_within_half)
      << " within half of it\n";
}

inline void print_place(std::ostream& out, const Deviation_figures::Place& place)
{
  out << std::setprecision(6) << "              worst at (" << place.point[0] << ", " << place.point[1] << ", "
      << place.point[2] << "): face " << place.t_mesh_face << " of the T-mesh at (" << place.u << ", " << place.v
      << "), ";
  if (place.mesh_edge)
    out << "edge from vertex " << (*place.mesh_edge)[0] << " to " << (*place.mesh_edge)[1] << " of the mesh\n";
  else
    out << "face " << place.mesh_face << " of the mesh\n";
}

/// How far the borders, or the creases, are apart.
/// \param title of ten characters
inline void print_of_curves(std::ostream& out, const char* title, const char* curves,
                            const Deviation_figures::Of_curves& distances)
{
  out << "  " << title << "  max " << percent(distances.maximum()) << ", rms " << percent(distances.rms())
      << " between the " << curves << ", both ways";
  if (distances.corners > 0)
    out << "; corners off by at most " << percent(distances.largest_corner_distance, 2);
  out << "\n";
  print_one_way(out, "surface to mesh", distances.surface_to_mesh, "length");
  print_one_way(out, "mesh to surface", distances.mesh_to_surface, "length");
  print_place(out, distances.worst());
}

/// How far surface and mesh are apart, what is wrong first.
inline void print_deviation(std::ostream& out, const T_spline_figures& spline, const Deviation_figures& deviation)
{
  out << "  deviation   " << verdict(spline) << ": max " << percent(deviation.of_surface.maximum())
      << " both ways, tolerance " << percent(spline.tolerance) << "\n";
  print_one_way(out, "surface to mesh", deviation.of_surface.surface_to_mesh);
  print_one_way(out, "mesh to surface", deviation.of_surface.mesh_to_surface);
  print_place(out, deviation.of_surface.worst());
  if (deviation.free_edge)
    print_of_curves(out, "free edge ", "borders", *deviation.free_edge);
  if (deviation.crease)
    print_of_curves(out, "creases   ", "creases and the features of the mesh", *deviation.crease);
  out << "  normals     differ by at most " << std::setprecision(3) << deviation.largest_angle << " degrees; "
      << deviation.folded_patches << " of " << spline.patches << " Bezier patches with folds, "
      << deviation.certified_patches << " certified without";
  if (deviation.doubtful_patches > 0)
    out << ", " << deviation.doubtful_patches << " where the mesh itself turns over within the tolerance";
  out << "\n";
  out << "  self-intersections: " << deviation.self_intersections_beyond_mesh << " where the mesh has none";
  if (deviation.self_intersections > 0 || deviation.self_intersections_of_mesh > 0)
    out << " (" << deviation.self_intersections << " in all; the mesh: " << deviation.self_intersections_of_mesh << ")";
  if (deviation.self_intersections_beyond_mesh > 0)
    out << std::setprecision(6) << ", one at (" << deviation.self_intersection[0] << ", "
        << deviation.self_intersection[1] << ", " << deviation.self_intersection[2] << ")";
  out << "\n";
}

inline void print_t_spline(std::ostream& out, const T_spline_figures& spline)
{
  print_levels(out, spline);
  out << "              at the samples: " << spline.ending() << " (" << percent(spline.tolerance) << ")\n";
  const T_spline_figures::Level& level = spline.level();
  out << "  T-spline    " << level.control_points << " control points, " << level.control_points_in_rings
      << " of them in the rings around extraordinary vertices; " << spline.t_mesh.faces << " faces, "
      << spline.t_mesh.t_joints << " T-joints\n";
  out << "  patches     " << spline.patches << " Bezier patches; caps at extraordinary vertices off by "
      << percent(spline.cap_deviation, 2) << "\n";
  if (spline.deviation)
    print_deviation(out, spline, *spline.deviation);
}

/// The time in all, and that of the stages that take a while.
inline void print_time(std::ostream& out, const Figures& figures)
{
  constexpr double a_while = 0.02; // as a share of all
  out << "  time        " << std::fixed << std::setprecision(2) << figures.seconds << " s";
  const char* separator = " (";
  for (const Figures::Stage& stage : figures.stages) {
    if (stage.seconds < a_while * figures.seconds)
      continue;
    out << separator << stage.name << " " << stage.seconds;
    separator = ", ";
  }
  out << (*separator == ',' ? ")" : "");
  if (figures.peak_memory_bytes > 0)
    out << ", " << std::setprecision(0) << static_cast<double>(figures.peak_memory_bytes) / (1 << 20) << " MB";
  out << "\n";
}

/// What became of the holes.
inline void print_holes(std::ostream& out, const Hole_figures& holes)
{
  out << "  holes       " << holes.filled << " filled";
  if (holes.filled > 0)
    out << " with " << holes.faces << " faces that are no data";
  if (holes.larger > 0)
    out << "; " << holes.larger << (holes.larger == 1 ? " larger one left" : " larger ones left");
  if (holes.failed > 0)
    out << "; " << holes.failed << " left because nothing fills " << (holes.failed == 1 ? "it" : "them");
  out << "\n";
}

/// The features, and what became of them.
inline void print_features(std::ostream& out, const Figures::Features& features)
{
  out << "  features    " << features.edges << " edges " << features.source << " in " << features.arcs
      << (features.arcs == 1 ? " arc" : " arcs");
  if (features.closed_arcs > 0)
    out << " (" << features.closed_arcs << " closed)";
  out << ", " << features.corners << (features.corners == 1 ? " corner" : " corners");
  if (features.added_faces > 0)
    out << "; " << features.added_faces << " more faces at them";
  if (!features.soft_edges.empty())
    out << "; " << features.soft_edges.size() << " edges that the field cannot follow, the first one from vertex "
        << features.soft_edges.front().first << " to " << features.soft_edges.front().second;
  out << "\n";
  if (!features.given_up.empty()) {
    out << "              given up: the surface that is sharp there is " << features.given_up << "\n";
    return;
  }
  if (features.edges_of_map > 0 && features.edges_not_met > 0)
    out << "              " << features.edges_not_met << " of " << features.edges_of_map
        << " edges in the map are not met: no isolines without turning triangles over\n";
  else if (features.edges_of_map > 0)
    out << "              all " << features.edges_of_map << " edges in the map lie on isolines, exactly\n";
  else
    out << "              not met: the map could not be aligned\n";
}

/// How the map was aligned.
inline void print_alignment(std::ostream& out, const Figures::Alignment& alignment)
{
  out << std::setprecision(3) << "  alignment   ";
  if (!alignment.is_aligned) {
    out << alignment.status << "\n";
    return;
  }
  out << "isolines are off the field by " << alignment.mean << " degrees in the mean (before " << alignment.mean_before
      << ", rotated " << alignment.mean_rotated << "), by " << alignment.most << " on 5 % of the area; "
      << alignment.steps << " steps, distortion " << alignment.mean_distortion << " in the mean, "
      << alignment.largest_distortion << " at most\n";
}

/// What the user reads at the end.
inline void print_summary(std::ostream& out, const Figures& figures)
{
  out << figures.input.name << ": " << figures.input.vertices << " vertices, " << figures.input.faces
      << " faces, genus " << figures.input.genus;
  if (figures.input.components > 1)
    out << ", " << figures.input.components << " components";
  if (figures.input.borders > 0)
    out << ", a border of " << figures.input.borders << (figures.input.borders == 1 ? " curve" : " curves");
  out << "\n";
  if (figures.input.holes)
    print_holes(out, *figures.input.holes);
  if (figures.features)
    print_features(out, *figures.features);
  print_signature(out, figures.signature);
  if (figures.map) {
    const Map_figures& map = *figures.map;
    out << "  map         " << map.status << ": residual " << std::setprecision(3) << map.residual << " after "
        << map.iterations << " iterations (" << map.halvings << " halved steps, " << map.flips << " flips, "
        << map.mantissa_bits << " bits)\n";
    out << "  refinement  " << figures.refined.vertices << " vertices, " << figures.refined.faces << " faces, "
        << figures.refined.cut_edges << " cut edges\n";
  }
  if (figures.alignment)
    print_alignment(out, *figures.alignment);
  print_scales(out, figures.refined.transitions);
  out << "\n";
  if (figures.exact_map)
    print_exact_map(out, *figures.exact_map);
  if (figures.t_mesh) {
    print_tracing(out, figures.t_mesh->tracing);
    print_t_mesh(out, "  T-mesh      ", figures.t_mesh->traced);
    if (figures.t_mesh->regularization)
      print_t_mesh(out, "  regularized ", figures.t_mesh->regularization->t_mesh);
  }
  if (figures.t_spline)
    print_t_spline(out, *figures.t_spline);
  print_time(out, figures);
}

#endif // MESH_TO_T_SPLINE_SUMMARY_H
