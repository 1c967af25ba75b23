// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_OPTION_TABLE_H
#define MESH_TO_T_SPLINE_OPTION_TABLE_H

#include <CGAL/T_splines/defaults.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

/// What is said of an option, on one line; its default stands in parentheses.
struct Option_row {
  std::string name; ///< with its value, such as "--tolerance X"
  std::string text;
};

/// Options that belong together.
struct Option_group {
  std::string title;
  std::vector<Option_row> rows;
};

/// The shortest text that reads back as the same number.
inline std::string text_of(const double number)
{
  std::array<char, 32> digits;
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  const std::size_t zero = text.find("e-0"); // 1e-6, not 1e-06
  return zero == std::string::npos ? text : text.erase(zero + 2, 1);
}

/// All options of the program: the help, the README and the manual show these rows.
inline std::vector<Option_group> option_table()
{
  namespace T = CGAL::T_splines;
  return {
      {"",
       {{"--uv MAP",
         "a seamless map instead of a mesh: an OBJ file with uv (vt) at every corner. No option of the next "
         "five groups goes with it"}}},
      {"Mesh",
       {{"--merge DISTANCE",
         "how far apart vertices at boundary edges may be that are one vertex, by the longest side of "
         "the bounding box (" +
             text_of(T::default_merge_distance) + ": round-off of float numbers)"},
        {"--no-merge", "vertices are one vertex only if the file says so (STL: if their coordinates are equal)"},
        {"--repair",
         "removes degenerate and duplicate faces, flat triangles and isolated vertices, turns faces that are "
         "oriented against their neighbours, splits vertices and edges where sheets meet; holes stay"},
        {"--fill-holes N",
         "closes the holes with at most N edges; the surface is neither fitted to what closes them nor "
         "measured against it. The outer border counts as a hole, too, if it has no more edges"}}},
      {"Guidance (without any, a smooth cross field is computed, and its cones are merged)",
       {{"--field FILE", "a cross field: .rawfield, .crossfield, .rosy or .ffield; its cones are kept"},
        {"--cones FILE", "cones: .cones, one line \"vertex k\" per cone, vertices counted from 0; or .Th_hat, a total "
                         "angle per vertex"},
        {"--loops K1,K2,...", "turning numbers of the homology loops, in quarter turns; with --cones"}}},
      {"Border of an open mesh",
       {{"--corner-angle DEGREES", "the border has a corner where it turns by more than this within the surface (" +
                                       text_of(T::default_corner_angle) + ")"},
        {"--corners FILE",
         "the corners: .bcones, one line \"vertex k\" per corner, k quarter turns of the angle there; "
         "everywhere else the border is straight"},
        {"--no-corners", "the border is straight everywhere"},
        {"--align-boundary", "a field from a file that does not follow the border stands for one with the same cones "
                             "that does; else it is refused"}}},
      {"For the computed field",
       {{"--features FILE",
         "edges of the mesh along which the surface is sharp: pairs of vertices, counted from 0, one "
         "a line; a .sharp file of "
         "quadwild; or the lines (l) of an OBJ (those by angle)"},
        {"--feature-angle DEGREES",
         "the surface is sharp where the normals of the faces differ by more than this, and by more than around (" +
             text_of(T::default_feature_angle) +
             "; unless this is given, only where they divide the surface into sides, and if a surface without faults "
             "comes out)"},
        {"--no-features", "the surface is smooth everywhere"},
        {"--align-curvature X", "aligns it to principal curvatures: 0 not at all, 100 well (0)"},
        {"--cone-energy X", "cones are merged as long as a merge raises the energy of the map's scale by at most X, a "
                            "number without unit; 0 "
                            "merges only what is better merged (" +
                                text_of(T::default_energy_change(0)) + " on a component of genus 0, " +
                                text_of(T::default_energy_change(1)) + " of genus 1, " +
                                text_of(T::default_energy_change(2)) +
                                " on others; no merges beyond --max-cones, if that is given)"},
        {"--max-cones N", "cones are merged until at most N are left, whatever this costs (no limit)"},
        {"--all-cones", "the cones of the field are not merged"}}},
      {"Computation of the map",
       {{"--flips delaunay|degeneracy|degeneracy-only",
         "how the triangulation follows the metric: ideal Delaunay flips, or flips of degenerating triangles with or "
         "without the intrinsic Delaunay property (delaunay)"},
        {"--scale auto|as-is|unit|dyadic",
         "the scale factors of the map's transitions: those of the conformal map; 1, so that knots are the same on "
         "both sides "
         "of each edge; or powers of two (auto: 1 if there are features, else as is)"},
        {"--tolerance-residual X", "the largest deviation from the prescribed angles, in radians (" +
                                       text_of(T::default_residual_tolerance) + ")"},
        {"--max-iterations N", "the most Newton steps (" + std::to_string(T::default_number_of_newton_steps) + ")"},
        {"--precision double|extended|quad",
         "the number type to begin with; wider ones follow where it does not suffice (double)"}}},
      {"T-mesh", {{"--no-regularization", "the T-mesh as the motorcycles trace it"}, {"--map-only", "no T-mesh"}}},
      {"T-spline",
       {{"--tolerance X",
         "the largest distance allowed between mesh and surface, either way, by the longest side of the "
         "bounding box: 0.01 is 1 percent of it (" +
             text_of(T::default_tolerance) + ")"},
        {"--max-control-points N",
         "the most control points (" + std::to_string(T::always_allowed_control_points) +
             ", or if that is more, four times as many as the coarsest surface has, or half as "
             "many as the mesh has vertices)"},
        {"--fairness X", "the weight of the thin-plate energy against the squared distances, without unit; features "
                         "smaller than X^(1/4) times the distance between samples are smoothed away (" +
                             text_of(T::default_fairness) + ")"},
        {"--levels", "also writes level_0.ply, level_1.ply, ...: the T-splines from coarse to fine on the way"},
        {"--mesh-format obj|ply",
         "the format of the triangles: t_spline.obj, or t_spline_mesh.ply, binary and a third of "
         "the size (obj)"},
        {"--resolution N",
         "each side of a face is divided into at least N parts for the triangles (as finely as they are "
         "within a quarter of the tolerance from the surface)"},
        {"--no-spline", "the T-mesh alone, as it was traced and regularized"}}},
      {"All",
       {{"--solver ldlt|cholmod", "the sparse linear solver (ldlt)"},
        {"-o DIR", "where to write; made if it does not exist (.)"},
        {"--quiet", "no progress and no summary"},
        {"--version", "the version"},
        {"--help, --help=markdown", "this list, as text or as a table"}}}};
}

/// The rows as a table of Markdown.
inline std::string option_table_as_markdown()
{
  std::string text = "| option | |\n|---|---|\n";
  for (const Option_group& group : option_table())
    for (const Option_row& row : group.rows) {
      text += "| `";
      for (const char c : row.name)
        text += c == '|' ? std::string("\\|") : std::string(1, c);
      text += "` | " + row.text + " |\n";
    }
  return text;
}

/// The rows in two columns, wrapped.
inline std::string option_table_as_text()
{
  constexpr std::size_t indent = 28, width = 120;
  std::string text;
  for (const Option_group& group : option_table()) {
    text += group.title.empty() ? "" : group.title + ":\n";
    for (const Option_row& row : group.rows) {
      std::string line = "  " + row.name;
      if (line.size() + 2 > indent) {
        text += line + "\n";
        line.clear();
      }
      line.resize(indent, ' ');
      std::istringstream words(row.text);
      bool is_first = true;
      for (std::string word; words >> word; is_first = false) {
        if (!is_first && line.size() + 1 + word.size() > width) {
          text += line + "\n";
          line.assign(indent, ' ');
        }
        else if (!is_first)
          line += ' ';
        line += word;
      }
      text += line + "\n";
    }
  }
  return text;
}

#endif // MESH_TO_T_SPLINE_OPTION_TABLE_H
