// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_FACE_FRAMES_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_FACE_FRAMES_H

#include <CGAL/T_splines/Similarity_2.h>

#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

// The frames of faces, for T-meshes as graphs and as arrays: a face is [0, width] x [0, height], its sides have the
// numbers 0 to 3 from the bottom, counter-clockwise.

/// The point of side `side` of face `f` at a distance from the beginning of the side.
/// \tparam Frames has `width(f)` and `height(f)`; only those that are needed are asked for
template <typename Frames, typename Face, typename FT>
std::pair<FT, FT> point_of_side(const Frames& frames, const Face f, const int side, const FT& distance)
{
  switch (side) {
  case 0: return {distance, FT(0)};
  case 1: return {frames.width(f), distance};
  case 2: return {FT(frames.width(f) - distance), frames.height(f)};
  default: return {FT(0), FT(frames.height(f) - distance)};
  }
}

/// A side, and a point of it in the frame of its face.
template <typename FT>
struct Side_point {
  int side;
  std::pair<FT, FT> point;
};

/// The similarity from the frame of one face to that of another, tau of [CZ17] 4.1.1.
/// \param from, to one point on the common edge, in both faces
/// \param scale how many units of the second face are one of the first
template <typename FT>
Similarity_2<FT> transition_of_frames(const Side_point<FT>& from, const Side_point<FT>& to, const FT& scale)
{
  const int quarter_turns = to.side + 2 - from.side;
  const std::pair<FT, FT> image =
      Similarity_2<FT>(quarter_turns, scale, FT(0), FT(0))(from.point.first, from.point.second);
  return Similarity_2<FT>(quarter_turns, scale, FT(to.point.first - image.first), FT(to.point.second - image.second));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_FACE_FRAMES_H
