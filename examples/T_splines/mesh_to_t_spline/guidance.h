// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_GUIDANCE_H
#define MESH_TO_T_SPLINE_GUIDANCE_H

#include "Chosen_spd_solver_traits.h"
#include "Failure.h"
#include "Figures.h"
#include "Options.h"
#include "Progress.h"
#include "Refined_map.h"

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>

using Signature = CGAL::T_splines::Holonomy_signature<Mesh>;

/// Finds the signature as the options say: from a file, or from a computed field, whose cones it reduces.
Failure find_signature(const Options& options, Mesh& mesh, Chosen_spd_solver_traits& solver, Progress& progress,
                       Signature& signature, Figures::Signature& figures);

#endif // MESH_TO_T_SPLINE_GUIDANCE_H
