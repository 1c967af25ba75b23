// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters of this package, one line each. No include guard: the list is read more than once, each time
// with another meaning of the macro. Each function documents the parameters that it takes.

#ifdef CGAL_T_SPLINES_NAMED_PARAMETER

// Cross_field
CGAL_T_SPLINES_NAMED_PARAMETER(loop_turning_numbers)
CGAL_T_SPLINES_NAMED_PARAMETER(curvature_alignment)
CGAL_T_SPLINES_NAMED_PARAMETER(border_is_allowed)
CGAL_T_SPLINES_NAMED_PARAMETER(halfedge_matching_map)
CGAL_T_SPLINES_NAMED_PARAMETER(maximum_energy_change)
CGAL_T_SPLINES_NAMED_PARAMETER(maximum_number_of_cones)

// Similarity_map
CGAL_T_SPLINES_NAMED_PARAMETER(residual_tolerance)
CGAL_T_SPLINES_NAMED_PARAMETER(flip_policy)
CGAL_T_SPLINES_NAMED_PARAMETER(number_type)
CGAL_T_SPLINES_NAMED_PARAMETER(output_vertex_point_map)
CGAL_T_SPLINES_NAMED_PARAMETER(vertex_location_map)
CGAL_T_SPLINES_NAMED_PARAMETER(edge_is_cut_map)
CGAL_T_SPLINES_NAMED_PARAMETER(halfedge_transition_map)
CGAL_T_SPLINES_NAMED_PARAMETER(transition_tolerance)

// T_mesh
CGAL_T_SPLINES_NAMED_PARAMETER(tracing_traits)
CGAL_T_SPLINES_NAMED_PARAMETER(vertex_origin_map)
CGAL_T_SPLINES_NAMED_PARAMETER(vertex_place_map)
CGAL_T_SPLINES_NAMED_PARAMETER(face_anchor_map)
CGAL_T_SPLINES_NAMED_PARAMETER(edge_polyline_map)
CGAL_T_SPLINES_NAMED_PARAMETER(relative_tolerance)
CGAL_T_SPLINES_NAMED_PARAMETER(number_of_samples)

// Spline
CGAL_T_SPLINES_NAMED_PARAMETER(number_of_rings)
CGAL_T_SPLINES_NAMED_PARAMETER(fairness)
CGAL_T_SPLINES_NAMED_PARAMETER(maximum_number_of_control_points)
CGAL_T_SPLINES_NAMED_PARAMETER(tessellation_resolution)
CGAL_T_SPLINES_NAMED_PARAMETER(vertex_distance_map)
CGAL_T_SPLINES_NAMED_PARAMETER(tolerance)
CGAL_T_SPLINES_NAMED_PARAMETER(face_deviation_map)
CGAL_T_SPLINES_NAMED_PARAMETER(face_is_folded_map)

// IO
CGAL_T_SPLINES_NAMED_PARAMETER(vertex_weight_map)

#endif // CGAL_T_SPLINES_NAMED_PARAMETER
