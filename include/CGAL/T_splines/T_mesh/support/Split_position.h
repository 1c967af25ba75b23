// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_SPLIT_POSITION_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_SPLIT_POSITION_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Where to split a face of a T-mesh in two: at a vertex of the two sides that are cut, if there is one near the place
/// that is asked for, so that lines do not run close to each other.
/// \tparam TMesh a `T_mesh_view` of a `const` graph, which the constructor finds for any model of `TMesh`
template <typename TMesh>
class Split_position {
  using Coordinates = T_mesh_coordinates<TMesh>;
  using halfedge_descriptor = typename Coordinates::halfedge_descriptor;
  using face_descriptor = typename Coordinates::face_descriptor;

public:
  using FT = typename Coordinates::FT;

  explicit Split_position(const TMesh& t_mesh) : m_t_mesh(t_mesh), m_coordinates(t_mesh) {}

  /// The middle, or a vertex in the middle third. A new knot so keeps a distance of a sixth of the face from the old
  /// ones.
  /// \param axis 0 for a cut along u = const, 1 for v = const
  /// \return the distance from the side that is parallel to the cut
  FT operator()(const face_descriptor f, const int axis) const
  {
    const FT size = m_coordinates.side_length(m_coordinates.first_of_side(f, axis));
    return near(f, axis, FT(size / FT(3)), FT(size / FT(2)), FT(size * FT(2) / FT(3)));
  }

  /// The distance `target`, or that of the vertex closest to it between `low` and `high`; one that both sides have, if
  /// there is one.
  FT near(const face_descriptor f, const int axis, const FT& low, const FT& target, const FT& high) const
  {
    const halfedge_descriptor first = m_coordinates.first_of_side(f, axis);
    const FT size = m_coordinates.side_length(first);
    const std::vector<FT> near = inner_knots(first), far = inner_knots(m_coordinates.first_of_side(f, axis + 2));
    FT best = target, best_distance = size;
    bool is_best_met_twice = false;
    const auto consider = [&](const FT& x, const bool is_met_twice) {
      if (x < low || x > high || (is_best_met_twice && !is_met_twice))
        return;
      const FT distance = CGAL::abs(FT(x - target));
      if (distance < best_distance || (is_met_twice && !is_best_met_twice)) {
        best = x;
        best_distance = distance;
        is_best_met_twice = is_met_twice;
      }
    };
    // Both lists are merged; the far side runs backwards.
    std::size_t i = 0, j = far.size();
    while (i < near.size() || j > 0) {
      const bool has_near = i<near.size(), has_far = j> 0;
      const FT x = has_near ? near[i] : size, y = has_far ? FT(size - far[j - 1]) : size;
      const bool is_met_twice = has_near && has_far && CGAL::abs(FT(x - y)) <= knot_tolerance(size);
      consider((std::min)(x, y), is_met_twice);
      if (has_near && (is_met_twice || !has_far || x < y))
        ++i;
      if (has_far && (is_met_twice || !has_near || !(x < y)))
        --j;
    }
    return best;
  }

private:
  // Distances of the vertices on a side, corners excepted, from its beginning.
  std::vector<FT> inner_knots(halfedge_descriptor h) const
  {
    std::vector<FT> result;
    FT distance(0);
    while (!m_t_mesh.is_corner(h)) {
      distance += m_t_mesh.knot(h);
      result.push_back(distance);
      h = next(h, m_t_mesh.graph());
    }
    return result;
  }

  TMesh m_t_mesh;
  Coordinates m_coordinates;
};

template <typename TMesh>
Split_position(const TMesh&) -> Split_position<Const_T_mesh_view_of<TMesh>>;

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_SPLIT_POSITION_H
