// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_MESH_STAGE_H
#define MESH_TO_T_SPLINE_T_MESH_STAGE_H

#include "Failure.h"
#include "Figures.h"
#include "Options.h"
#include "Progress.h"
#include "Results.h"

/// Makes the map exactly seamless, traces the T-mesh and regularizes it; if there will be a T-spline, it takes samples
/// of the mesh and refines the T-mesh, too.
Failure make_t_mesh(const Options& options, Progress& progress, Results& results, Figures& figures);

#endif // MESH_TO_T_SPLINE_T_MESH_STAGE_H
