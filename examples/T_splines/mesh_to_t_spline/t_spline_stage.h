// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_T_SPLINE_STAGE_H
#define MESH_TO_T_SPLINE_T_SPLINE_STAGE_H

#include "Chosen_spd_solver_traits.h"
#include "Failure.h"
#include "Options.h"
#include "Progress.h"
#include "Results.h"
#include "t_spline_figures.h"

/// Fits a T-spline surface to the mesh, refines it until it is within the tolerance, and draws it.
Failure make_t_spline(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress, Results& results,
                      T_spline_figures& figures);

#endif // MESH_TO_T_SPLINE_T_SPLINE_STAGE_H
