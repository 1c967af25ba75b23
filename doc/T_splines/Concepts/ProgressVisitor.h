// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `ProgressVisitor` describes what long computations tell the caller, and how the caller ends them early. A
model is passed by the named parameter `visitor`: to every function that takes more than a moment on a mesh of half a
million faces. (What follows the edits of a T-mesh is something else, `TMeshObserver`.)

Visitors are passed by value and copied freely: one with state keeps a pointer or a reference to it. All functions
are called on `const` objects, from the thread that called the algorithm, and should return quickly. They should not throw.

A class derived from `CGAL::T_splines::Progress_visitor` may define only the functions that it cares for: they are
not virtual, the algorithm calls those of the type that it was given.

Results do not depend on the visitor, unless it ends the computation.

These are the stages. What a function calls in its turn is a part of its own stages and begins none.

| function | stages |
|---|---|
| `read_triangle_mesh()`, `read_map_obj()`, `read_t_mesh()`, `read_cross_field()`, `read_rawfield()`, `read_rosy()`, `read_crossfield()`, `read_ffield()` | "reading" |
| `fill_holes()` | "hole filling" |
| `check_triangle_mesh()` | "mesh check" |
| `compute_smooth_cross_field()` | "cross field" |
| `detect_features()` | "features" |
| `refine_at_features()` | "refinement at features" |
| `compute_feature_aligned_cross_field()` | "cross field along features" |
| `check_feature_alignment()` | "feature check" |
| `holonomy_signature_of_cross_field()`, `holonomy_signature_of_cones()` | "holonomy signature" |
| `check_holonomy_signature()` | "signature check" |
| `reduce_cones()` | "cone reduction" |
| `compute_seamless_similarity_map()` | "similarity metric", "layout", "subdivision", "output" |
| `make_exactly_seamless()` | "exact map" |
| `trace_motorcycle_graph()` | "tracing", "T-mesh" |
| `carry_surface()` | "carried surface" |
| `sample_T_mesh()` | "sampling" |
| `regularize_T_mesh()` | "regularization" |
| `refine_T_mesh()` | "refinement" |
| `grade_T_mesh()` | "grading" |
| `place_T_mesh()` | "placement" |
| `check_admissibility()` | "admissibility" |
| `check_spline_compatibility()`, `make_spline_compatible()` | "spline compatibility" |
| `insert_knot_line()` | "knot insertion" |
| the constructors of `T_spline_surface` | "T-spline surface" |
| `fit_T_spline()`, `fit_adaptive_T_spline()` | "fit", in the latter once for each level |
| `compile_T_spline()` | "compilation" |
| `tessellate_T_spline()`, `tessellate_parameter_domain()` | "tessellation" |
| `measure_T_spline_deviation()` | "preparation", "surface to mesh", "mesh to surface", "free edge" |
| `check_T_spline_self_intersections()` | "self-intersections" |

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Progress_visitor}
\cgalHasModelsEnd
*/
class ProgressVisitor {
public:
  /// \name Operations
  /// @{

  /*!
  is called when a stage begins.
  \param name a string literal, one of those above
  */
  void begin_stage(const char* name) const;

  /*!
  is called from time to time within a stage.
  \param fraction in [0, 1]; it does not decrease within a stage. It may be 1 before the stage ends, and a stage may end
         before it is 1.
  */
  void progress(double fraction) const;

  /*!
  is asked several times a second, by functions that take as long as that: after pieces of work of about the same size,
  not by the clock. At least once in each function, however short. Not within the ordering and factorization of a matrix
  by the solver: one to three seconds for 400000 faces with Eigen's `SimplicialLDLT`.
  \return `false` to end the computation. Nothing more is called then, and the function returns with the status
          `INTERRUPTED`. Its outputs are as they were before; `carry_surface()`, `sample_T_mesh()` and
          `tessellate_parameter_domain()`, which have no status, return nothing. A T-mesh that a function edits in place
          keeps the edits so far: it is admissible, and its observers are up to date.
  */
  bool go_on() const;

  /// @}
};
