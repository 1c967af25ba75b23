// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_MAP_COMPUTATION_H
#define MESH_TO_T_SPLINE_MAP_COMPUTATION_H

#include "Approximation.h"
#include "Chosen_spd_solver_traits.h"
#include "Failure.h"
#include "Figures.h"
#include "Options.h"
#include "Progress.h"

/// Computes the seamless similarity map with the signature of `approximation`.
Failure compute_map(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress,
                    Approximation& approximation, Map_figures& figures);

/// Aligns the map to its cross field, if there are features, or changes its scale factors, if the options say so.
/// \param features receives how many are met, if there are any
Failure align_map(const Options& options, Chosen_spd_solver_traits& solver, Progress& progress,
                  Approximation& approximation, std::optional<Figures::Features>& features,
                  std::optional<Figures::Alignment>& figures);

#endif // MESH_TO_T_SPLINE_MAP_COMPUTATION_H
