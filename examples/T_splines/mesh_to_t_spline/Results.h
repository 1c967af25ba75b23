// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_RESULTS_H
#define MESH_TO_T_SPLINE_RESULTS_H

#include "Refined_map.h"
#include "Surface_drawing.h"
#include "Surface_t_mesh.h"

#include <CGAL/T_splines/Spline/Compiled_T_spline.h>

#include <optional>
#include <string>
#include <vector>

using Compiled_t_spline = CGAL::T_splines::Compiled_T_spline<Graph, Kernel>;

/// What the files are made of.
struct Results {
  Mesh input;           ///< empty if the map was given
  bool has_map = false; ///< whether the map was computed
  Refined_map refined;
  bool has_t_mesh = false;
  Surface_t_mesh t_mesh;
  T_mesh_drawing traced, regularized; ///< empty where there is none
  T_spline fitted;
  std::vector<std::string> levels;          ///< the files of the T-splines from coarse to fine, if asked for
  std::optional<Compiled_t_spline> surface; ///< of `fitted`
  int resolution = 8;                       ///< of the tessellation
  Surface_drawing surface_drawing;          ///< empty where there is none
};

#endif // MESH_TO_T_SPLINE_RESULTS_H
