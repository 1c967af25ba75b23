// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_SUMMARY_H
#define MESH_TO_T_SPLINE_SUMMARY_H

#include "Figures.h"

#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>

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

/// What the user reads at the end.
inline void print_summary(std::ostream& out, const Figures& figures)
{
  const Figures::Map& map = figures.map;
  out << figures.input.name << ": " << figures.input.vertices << " vertices, " << figures.input.faces << " faces, genus "
      << figures.input.genus;
  if (figures.input.components > 1)
    out << ", " << figures.input.components << " components";
  out << "\n";
  print_cones(out, figures.signature);
  out << "  map         " << map.status << ": residual " << std::setprecision(3) << map.residual << " after " << map.iterations
      << " iterations (" << map.halvings << " halved steps, " << map.flips << " flips, " << map.mantissa_bits << " bits)\n";
  out << "  refinement  " << figures.refined.vertices << " vertices, " << figures.refined.faces << " faces, "
      << figures.refined.cut_edges << " cut edges\n";
  out << "  scales      " << (figures.refined.transitions.empty() ? "no cut" : "");
  double previous = 0;
  for (const Figures::Transition& t : figures.refined.transitions) { // sorted by scale
    if (t.scale > previous * (1 + 1e-9))
      out << (previous == 0 ? "" : ", ") << std::setprecision(8) << t.scale;
    previous = t.scale;
  }
  out << "\n  time        " << std::fixed << std::setprecision(2) << figures.seconds << " s";
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
