// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_RESULTS_H
#define MESH_TO_T_SPLINE_RESULTS_H

#include "Approximation.h"
#include "Surface_drawing.h"
#include "T_mesh_drawing.h"

#include <CGAL/T_splines/Spline/Compiled_T_spline.h>

#include <optional>
#include <string>
#include <vector>

using Compiled_t_spline = CGAL::T_splines::Compiled_T_spline<Graph, Kernel>;

/// What the files are made of.
struct Results {
  Mesh input;
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv;      ///< of the input, if the map is given
  std::optional<Mesh::Property_map<Face, bool>> is_data; ///< of the input, if holes were to be filled
  std::optional<Approximation> approximation;            ///< of the input, once it was read
  T_mesh_drawing traced, regularized;                    ///< empty where there is none
  T_spline fitted;                                       ///< empty if no T-spline is asked for
  std::vector<std::string> levels;          ///< the files of the T-splines from coarse to fine, if asked for
  std::optional<Compiled_t_spline> surface; ///< of `fitted`
  Surface_drawing surface_drawing;          ///< empty where there is none
};

#endif // MESH_TO_T_SPLINE_RESULTS_H
