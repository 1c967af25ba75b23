// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_MOVE_PLACE_H
#define CGAL_T_SPLINES_T_MESH_MOVE_PLACE_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/internal/Closest_rectangle.h>
#include <CGAL/T_splines/internal/converted_similarity.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// moves a place to the face that covers it after a change of the T-mesh: what an observer does in `faces_replaced()` with
/// whatever lies in the faces.
///
/// A place goes by the first piece of its face that takes it into the closed rectangle of the new face. Round-off may
/// leave it outside of all of them by a little: it goes by the one that it misses by least, and then to the closest point
/// of the rectangle. Exact places in exact faces stay exactly where they are on the surface.
/// \tparam NT the number type of the place; knots are converted to it
/// \param place in an old face; it stays as it is if no piece is one of that face
/// \param pieces all of the change
/// \return the piece by which it went, or `nullptr`. Complexity: linear in the number of pieces.
template <typename Graph, typename NT, typename FT>
const T_mesh_piece<Graph, FT>* move_place(T_mesh_place<Graph, NT>& place,
                                          const std::vector<T_mesh_piece<Graph, FT>>& pieces)
{
  using internal::converted_number;
  const T_mesh_piece<Graph, FT>* best = nullptr;
  std::pair<NT, NT> image;
  internal::Closest_rectangle<NT> closest;
  for (const T_mesh_piece<Graph, FT>& piece : pieces) {
    if (piece.from != place.face)
      continue;
    std::pair<NT, NT> p = internal::converted_similarity<NT>(piece.transition)(place.u, place.v);
    if (!closest.offer(p.first, p.second, converted_number<NT>(piece.width), converted_number<NT>(piece.height)))
      continue;
    best = &piece;
    image = std::move(p);
    if (closest.contains_point())
      break;
  }
  if (best != nullptr) {
    place = {best->to, std::move(image.first), std::move(image.second)};
    internal::clamp_to_rectangle(place.u, place.v, converted_number<NT>(best->width),
                                 converted_number<NT>(best->height));
  }
  return best;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_MOVE_PLACE_H
