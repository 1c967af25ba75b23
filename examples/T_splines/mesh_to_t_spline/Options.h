// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OPTIONS_H
#define MESH_TO_T_SPLINE_OPTIONS_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

constexpr std::string_view program_version = "0.1.0";

/// What --help prints, but for the default of the fairness.
constexpr std::string_view help_text =
    R"(Usage: mesh_to_t_spline MESH [OPTION...]
       mesh_to_t_spline --uv MAP [OPTION...]

Approximates a closed triangle mesh by a T-spline surface within a tolerance. A cross field guides a seamless similarity
map; from the map comes a T-mesh with halfedge knots; on this a T-spline surface is fitted to the mesh and refined where
it is too far from it. Or the map is given.

It writes map.obj (unless the map is given), t_mesh.ply (the T-spline: control points and T-mesh), t_spline.vtu (Bezier
patches), t_spline.obj (triangles), report.json (all figures) and report.html (figures and pictures).

MESH is an OFF, OBJ, PLY or STL file. Faces that are not triangles are triangulated. Edges that lie on each other are
one edge, as where vertices are split for normals or uv, or differ by round-off. What was changed is said.

Defaults stand in parentheses.
  --uv MAP                  a seamless map: an OBJ file with uv (vt) at every corner; nothing of the next three
                            groups of options goes with it
Mesh:
  --merge DISTANCE          how far apart vertices at boundary edges may be that are one vertex, by the longest side of
                            the bounding box (1e-6: round-off of float numbers)
  --no-merge                vertices are one vertex only if the file says so (STL: if their coordinates are equal)
  --repair                  removes degenerate and duplicate faces, flat triangles and isolated vertices, turns faces
                            that are oriented against their neighbours, splits vertices and edges where sheets meet
Guidance (without any, a smooth cross field is computed, and its cones are reduced):
  --field FILE              a cross field: .rawfield, .crossfield, .rosy or .ffield; its cones are kept
  --cones FILE              cones: .cones, or total angles: .Th_hat
  --loops K1,K2,...         turning numbers of the homology loops, in quarter turns; with --cones
For the computed field:
  --align-curvature X       aligns it to principal curvatures: 0 not at all, 100 well (0)
  --cone-energy X           cones are merged as long as a merge raises the energy of the map's scale by at most X, a
                            number without unit; 0 merges only what is better merged (6 on a component of genus 0,
                            3 of genus 1, 4 on others; no merges beyond --max-cones, if that is given)
  --max-cones N             cones are merged until at most N are left, whatever this costs (no limit)
  --all-cones               the cones of the field are not merged
Computation of the map:
  --flips delaunay|degeneracy|degeneracy-only
                            how the triangulation follows the metric: ideal Delaunay flips, or flips of degenerating
                            triangles with or without the intrinsic Delaunay property (delaunay)
  --tolerance-residual X    the largest deviation from the prescribed angles, in radians (1e-12)
  --max-iterations N        the most Newton steps (100)
  --precision double|extended|quad
                            the number type to begin with; wider ones follow where it does not suffice (double)
T-mesh:
  --no-regularization       the T-mesh as the motorcycles trace it
  --map-only                no T-mesh
T-spline:
  --tolerance X             the largest distance allowed between mesh and surface, either way, by the longest side of
                            the bounding box: 0.01 is 1 percent of it (0.005)
  --max-control-points N    the most control points (5000, or if that is more, four times as many as the coarsest
                            surface has, or half as many as the mesh has vertices)
  --fairness X              the weight of the thin-plate energy against the squared distances, without unit; features
                            smaller than X^(1/4) times the distance between samples are smoothed away (@fairness@)
  --levels                  also writes level_0.ply, level_1.ply, ...: the T-splines from coarse to fine on the way
  --resolution N            each side of a face is divided into at least N parts in t_spline.obj (8)
  --no-spline               the T-mesh alone, as it was traced and regularized
All:
  --solver ldlt|cholmod     the sparse linear solver (ldlt)
  -o DIR                    where to write; made if it does not exist (.)
  --quiet                   no progress and no summary
  --version, --help

A fit that ends beyond the tolerance, because more control points do not help or are not allowed, is written, too; the
summary and the report say so.

Exit code: 0 all was computed and written, 1 the computation or the writing failed, 2 bad usage or bad input,
130 interrupted. Files are written whole or not at all, and only when all has been computed; those of an earlier run that
this one does not write are removed then.
)";

enum class Solver_choice { LDLT, CHOLMOD };
enum class Flips_choice { DELAUNAY, DEGENERACY, DEGENERACY_ONLY };
enum class Precision_choice { DOUBLE, EXTENDED, QUAD };

struct Options {
  std::string mesh, uv, field, cones, output_directory = ".";
  std::optional<double> merge_distance; ///< none: the default of the library
  bool is_merged = true, is_repaired = false;
  std::optional<std::vector<int>> loops;
  double curvature_alignment = 0;
  std::optional<double> cone_energy; ///< none: the default, which depends on `largest_number_of_cones`
  std::optional<int> largest_number_of_cones;
  double residual_tolerance = 1e-12;
  int max_iterations = 100;
  double tolerance = 0.005;
  std::optional<double> fairness; ///< none: the default of the library
  std::optional<std::size_t> largest_number_of_control_points;
  int resolution = 8;
  Solver_choice solver = Solver_choice::LDLT;
  Flips_choice flips = Flips_choice::DELAUNAY;
  Precision_choice precision = Precision_choice::DOUBLE;
  bool are_cones_reduced = true, is_map_only = false, is_regularized = true, has_spline = true, has_levels = false;
  bool is_quiet = false, asks_help = false, asks_version = false;

  const std::string& input_file() const { return uv.empty() ? mesh : uv; }
};

#endif // MESH_TO_T_SPLINE_OPTIONS_H
