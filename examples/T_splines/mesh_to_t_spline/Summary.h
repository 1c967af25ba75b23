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
  print_scales(out, figures.refined.transitions);
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
