// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_GUIDANCE_H
#define MESH_TO_T_SPLINE_GUIDANCE_H

#include "Approximation.h"
#include "Chosen_spd_solver_traits.h"
#include "Failure.h"
#include "Figures.h"
#include "Options.h"
#include "Progress.h"

/// Finds the signature as the options say: from a file, or from a computed field, whose cones it reduces.
/// \param mesh that of `approximation`; it receives a property map
Failure find_signature(const Options& options, Mesh& mesh, Chosen_spd_solver_traits& solver, Progress& progress,
                       Approximation& approximation, Figures::Signature& figures);

#endif // MESH_TO_T_SPLINE_GUIDANCE_H
