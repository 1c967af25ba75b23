// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_SUMMARY_H
#define MESH_TO_T_SPLINE_SUMMARY_H

#include "Figures.h"

#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <vector>

inline void print_cones(std::ostream& out, const Figures::Signature& signature)
{
  std::map<int, std::size_t> counts;
  for (const auto& cone : signature.cones)
    ++counts[cone.second];
  out << "  signature   " << signature.source << ": " << signature.cones.size() << " cones";
  const char* separator = " (";
  for (const auto& [k, count] : counts) {
    out << separator << "k = " << k << ": " << count;
    separator = ", ";
  }
  out << (counts.empty() ? "" : ")");
  if (!signature.loops.empty()) {
    out << ", loops";
    for (const int k : signature.loops)
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

inline void print_t_spline(std::ostream& out, const T_spline_figures& spline)
{
  out << "  T-spline    " << spline.control_points << " control points, " << spline.t_mesh.faces << " faces, "
      << spline.t_mesh.t_joints << " T-joints; " << spline.vertices_in_rings
      << " control points in the rings around extraordinary vertices\n"
      << "  patches     " << spline.patches << " Bezier patches; caps at extraordinary vertices off by "
      << std::setprecision(2) << spline.cap_deviation << " of the diagonal\n";
}

/// What the user reads at the end.
inline void print_summary(std::ostream& out, const Figures& figures)
{
  out << figures.input.name << ": " << figures.input.vertices << " vertices, " << figures.input.faces
      << " faces, genus " << figures.input.genus;
  if (figures.input.components > 1)
    out << ", " << figures.input.components << " components";
  out << "\n";
  print_cones(out, figures.signature);
  if (figures.map) {
    const Map_figures& map = *figures.map;
    out << "  map         " << map.status << ": residual " << std::setprecision(3) << map.residual << " after "
        << map.iterations << " iterations (" << map.halvings << " halved steps, " << map.flips << " flips, "
        << map.mantissa_bits << " bits)\n";
    out << "  refinement  " << figures.refined.vertices << " vertices, " << figures.refined.faces << " faces, "
        << figures.refined.cut_edges << " cut edges\n";
  }
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
  out << "  time        " << std::fixed << std::setprecision(2) << figures.seconds << " s";
  const char* separator = " (";
  for (const Figures::Stage& stage : figures.stages) {
    out << separator << stage.name << " " << stage.seconds;
    separator = ", ";
  }
  out << ")";
  if (figures.peak_memory_bytes > 0)
    out << ", " << std::setprecision(0) << static_cast<double>(figures.peak_memory_bytes) / (1 << 20) << " MB";
  out << "\n";
}

#endif // MESH_TO_T_SPLINE_SUMMARY_H
