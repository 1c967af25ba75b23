// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_APPROXIMATION_H
#define MESH_TO_T_SPLINE_APPROXIMATION_H

#include <CGAL/T_splines/Approximation/T_spline_approximation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

using Approximation = CGAL::T_splines::T_spline_approximation<Mesh>;
using Mapped = Approximation::Mapped;
using Placed_t_mesh = Approximation::Placed_T_mesh;
using T_spline = Approximation::Spline;
using Location = Mapped::Location;
using Transition = CGAL::T_splines::Similarity_2<double>;
using Graph = T_spline::Graph; // of the T-mesh, too

#endif // MESH_TO_T_SPLINE_APPROXIMATION_H
