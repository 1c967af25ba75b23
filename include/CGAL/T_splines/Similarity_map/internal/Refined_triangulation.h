// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_REFINED_TRIANGULATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_REFINED_TRIANGULATION_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A place on the input triangulation: on a vertex, inside an edge or inside a face.
struct Input_place {
  enum class Kind : char { VERTEX, EDGE, FACE };

  Kind kind = Kind::VERTEX;
  int index = 0; ///< of the vertex, of the edge e, or of the face
  /// EDGE: of source and target of halfedge 2e; FACE: of the targets of `halfedge_of_face` and its two successors.
  std::array<double, 3> weight{{1, 0, 0}};
};

/// The refined mesh in index arrays: what the common subdivision makes and the map is written from.
struct Refined_triangulation {
  static constexpr int none = -1;

  Triangulation_connectivity mesh;          ///< the input's vertices come first
  std::vector<std::array<double, 3>> point; ///< per vertex
  std::vector<Input_place> place;           ///< per vertex
  std::vector<std::array<double, 2>> uv;    ///< per halfedge: of its target in the chart of its face
  std::vector<int>
      input_halfedge; ///< per halfedge: the input halfedge on which it lies in the same direction, or `none`
  std::vector<int> final_halfedge; ///< per halfedge: the halfedge of the final triangulation, likewise
  std::vector<int> input_face;     ///< per face: the input face that contains it
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_REFINED_TRIANGULATION_H
