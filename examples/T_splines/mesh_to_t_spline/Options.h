// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OPTIONS_H
#define MESH_TO_T_SPLINE_OPTIONS_H

#include <CGAL/T_splines/Similarity_map/Map_alignment_report.h>
#include <CGAL/T_splines/defaults.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

constexpr std::string_view program_version = "0.1.0";

/// What --help prints before the options.
constexpr std::string_view help_beginning =
    R"(Usage: mesh_to_t_spline MESH [OPTION...]
       mesh_to_t_spline --uv MAP [OPTION...]

Approximates a triangle mesh by a T-spline surface within a tolerance. A cross field guides a seamless similarity
map; from the map comes a T-mesh with halfedge knots; on this a T-spline surface is fitted to the mesh and refined where
it is too far from it. Or the map is given.

It writes map.obj (unless the map is given), t_mesh.ply (the T-spline: control points and T-mesh), t_spline.vtu (Bezier
patches), t_spline.obj (triangles), report.json (all figures) and report.html (figures and pictures).

MESH is an OFF, OBJ, PLY or STL file. Faces that are not triangles are triangulated. Edges that lie on each other are
one edge, as where vertices are split for normals or uv, or differ by round-off. What was changed is said.

Defaults stand in parentheses.
)";

/// And after them.
constexpr std::string_view help_end =
    R"(
A fit that ends beyond the tolerance, because more control points do not help or are not allowed, is written, too; the
summary and the report say so.

Exit code: 0 all was computed and written, 1 the computation or the writing failed, 2 bad usage or bad input,
130 interrupted. Files are written whole or not at all, and only when all has been computed; those of an earlier run that
this one does not write are removed then.
)";

enum class Solver_choice { LDLT, CHOLMOD };
enum class Flips_choice { DELAUNAY, DEGENERACY, DEGENERACY_ONLY };
enum class Precision_choice { DOUBLE, EXTENDED, QUAD };
enum class Mesh_format { OBJ, PLY };

struct Options {
  std::string mesh, uv, field, cones, corners, output_directory = ".";
  std::optional<double> merge_distance; ///< none: the default of the library
  bool is_merged = true, is_repaired = false;
  std::optional<std::size_t> largest_hole; ///< in edges; none: holes stay
  std::optional<std::vector<int>> loops;
  std::optional<double> corner_angle; ///< in degrees; none: the default of the library
  bool has_corners = true, is_border_aligned = false;
  std::string features;                ///< a file
  std::optional<double> feature_angle; ///< in degrees; none: the default of the library
  bool has_features = true;            ///< unless they are asked for, only where the surface is good with them
  CGAL::T_splines::Scale_policy scale_policy = CGAL::T_splines::Scale_policy::UNIT_IF_CONSTRAINED;
  double curvature_alignment = 0;
  std::optional<double> cone_energy; ///< none: the default, which depends on `largest_number_of_cones`
  std::optional<int> largest_number_of_cones;
  double residual_tolerance = CGAL::T_splines::default_residual_tolerance;
  int max_iterations = CGAL::T_splines::default_number_of_newton_steps;
  double tolerance = CGAL::T_splines::default_tolerance;
  double fairness = CGAL::T_splines::default_fairness;
  std::optional<std::size_t> largest_number_of_control_points;
  std::optional<int> resolution; ///< none: as the tolerance asks for
  Solver_choice solver = Solver_choice::LDLT;
  Flips_choice flips = Flips_choice::DELAUNAY;
  Precision_choice precision = Precision_choice::DOUBLE;
  Mesh_format mesh_format = Mesh_format::OBJ;
  bool are_cones_reduced = true, is_map_only = false, is_regularized = true, has_spline = true, has_levels = false;
  bool is_quiet = false, asks_help = false, asks_table = false, asks_version = false;

  bool asks_for_features() const { return !features.empty() || feature_angle; }
  bool looks_for_features() const
  {
    return asks_for_features() || (has_features && uv.empty() && field.empty() && cones.empty() && !largest_hole);
  }

  const std::string& input_file() const { return uv.empty() ? mesh : uv; }
};

#endif // MESH_TO_T_SPLINE_OPTIONS_H
