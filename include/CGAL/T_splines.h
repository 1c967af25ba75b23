// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_H
#define CGAL_T_SPLINES_H

/// \file
/// The whole package: every public header.

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Similarity_map/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/Solver/Cholmod_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/Solver/preconditioned_conjugate_gradients.h>
#include <CGAL/T_splines/named_parameters.h>

#endif // CGAL_T_SPLINES_H
