// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_MAP_COMPUTATION_H
#define MESH_TO_T_SPLINE_MAP_COMPUTATION_H

#include "Chosen_spd_solver_traits.h"
#include "Failure.h"
#include "Figures.h"
#include "Options.h"
#include "Progress.h"
#include "Refined_map.h"
#include "guidance.h"

/// Computes the seamless similarity map with a signature.
Failure compute_map(const Options& options, const Mesh& mesh, const Signature& signature,
                    Chosen_spd_solver_traits& solver, Progress& progress, Refined_map& refined, Map_figures& figures);

#endif // MESH_TO_T_SPLINE_MAP_COMPUTATION_H
