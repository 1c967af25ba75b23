// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_CELLS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_CELLS_H

#include <CGAL/T_splines/Spline/internal/T_spline_basis.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How a coordinate in the frame of a basis function depends on one in the frame of a face: coordinate number `axis`
/// there is factor * x + offset.
template <typename FT>
struct Frame_axis {
  int axis;
  FT factor, offset;
};

/// \param face_axis 0 for u, 1 for v
template <typename FT>
Frame_axis<FT> frame_axis(const Similarity_2<FT>& to_vertex, const int face_axis)
{
  const int turns = to_vertex.quarter_turns(), axis = (turns + face_axis) % 2;
  // +u goes to the direction number `turns`, +v to the next one.
  const bool is_reversed = (turns + face_axis) % 4 >= 2;
  return {axis, is_reversed ? FT(-to_vertex.scale()) : to_vertex.scale(), axis == 0 ? to_vertex.u() : to_vertex.v()};
}

/// The knot lines of the basis functions divide a face into cells, on each of which all of them are bicubic
/// polynomials.
///
/// Replaces `cuts` by the coordinates of the lines that cross the face along `face_axis`, increasing, with the face's
/// ends. \pre no extraordinary vertex inside is a corner of `face`
template <typename FT>
void find_cell_cuts(const T_spline_basis<FT>& basis, const int face, const int face_axis, std::vector<FT>& cuts)
{
  cuts.clear();
  const FT size = basis.t_mesh().side_length(face, face_axis);
  const FT eps = knot_tolerance_between_faces(size);
  if (const auto* const corner = basis.corner_face(face); corner != nullptr)
    for (int i = 1; i < corner->patches->pieces_per_side(); ++i)
      cuts.push_back(size * FT(i) / FT(corner->patches->pieces_per_side()));
  for (auto a = basis.actions_begin(face); a != basis.actions_end(face); ++a) {
    const Frame_axis<FT> axis = frame_axis(a->to_vertex, face_axis);
    for (const FT& knot : basis.factors(a->function)[axis.axis].knots()) {
      const FT x = (knot - axis.offset) / axis.factor;
      if (x > eps && x < size - eps)
        cuts.push_back(x);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [&](const FT& a, const FT& b) { return b - a <= eps; }), cuts.end());
  cuts.insert(cuts.begin(), FT(0));
  cuts.push_back(size);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_BEZIER_CELLS_H
