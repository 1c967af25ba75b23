// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_H
#define CGAL_T_SPLINES_H

/// \file
/// The whole package: every public header.

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/IO/Field_file_report.h>
#include <CGAL/T_splines/Cross_field/IO/read_cone_angles.h>
#include <CGAL/T_splines/Cross_field/IO/read_cones.h>
#include <CGAL/T_splines/Cross_field/IO/read_crossfield.h>
#include <CGAL/T_splines/Cross_field/IO/read_ffield.h>
#include <CGAL/T_splines/Cross_field/IO/read_rawfield.h>
#include <CGAL/T_splines/Cross_field/IO/read_rosy.h>
#include <CGAL/T_splines/Cross_field/IO/write_cones.h>
#include <CGAL/T_splines/Cross_field/IO/write_rawfield.h>
#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>
#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cross_field.h>
#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/read_map_obj.h>
#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/IO/read_triangle_mesh.h>
#include <CGAL/T_splines/IO/write_map_obj.h>
#include <CGAL/T_splines/IO/write_t_mesh.h>
#include <CGAL/T_splines/IO/write_t_spline_obj.h>
#include <CGAL/T_splines/IO/write_t_spline_vtu.h>
#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Similarity_map/Exact_map_report.h>
#include <CGAL/T_splines/Similarity_map/Flip_policy.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/Similarity_map/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/Similarity_map/Similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/compute_seamless_similarity_map.h>
#include <CGAL/T_splines/Similarity_map/compute_similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/Solver/Cholmod_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/Solver/preconditioned_conjugate_gradients.h>
#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/Compiled_T_spline.h>
#include <CGAL/T_splines/Spline/Control_point_map.h>
#include <CGAL/T_splines/Spline/Knot_insertion_report.h>
#include <CGAL/T_splines/Spline/Surface_jet.h>
#include <CGAL/T_splines/Spline/T_spline_report.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/T_spline_closest_point.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/insert_knot_line.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>
#include <CGAL/T_splines/T_mesh/Admissibility_report.h>
#include <CGAL/T_splines/T_mesh/Carried_points.h>
#include <CGAL/T_splines/T_mesh/Motorcycle_graph_report.h>
#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_edit.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/T_mesh_roots.h>
#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>
#include <CGAL/T_splines/T_mesh/Tracing_traits.h>
#include <CGAL/T_splines/T_mesh/is_admissible.h>
#include <CGAL/T_splines/T_mesh/is_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>
#include <CGAL/T_splines/T_mesh/place_T_mesh.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>
#include <CGAL/T_splines/T_mesh/trace_motorcycle_graph.h>
#include <CGAL/T_splines/named_parameters.h>

#endif // CGAL_T_SPLINES_H
