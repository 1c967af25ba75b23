// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_VERTEX_QUARTERS_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_VERTEX_QUARTERS_H

#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A quarter of the surroundings of a vertex: a quarter turn within one face, counter-clockwise from its first
/// direction to its second one.
template <typename FT>
struct Vertex_quarter {
  int h;         ///< ends at the vertex, in the face of the quarter
  bool is_upper; ///< the second quarter of a face that goes straight on at the vertex: its first direction is inside
  FT unit;       ///< length of the face's unit, in that of the face of the first quarter
};

/// The quarters around a vertex, in their order counter-clockwise; at a border vertex, from border to border
/// ([CZ17] section 4.1.3).
template <typename FT>
class Vertex_quarters {
public:
  Vertex_quarters(const T_mesh_arrays<FT>& t_mesh, const int v)
  {
    m_quarters.reserve(4);
    FT unit(1);
    t_mesh.for_each_incoming(v, [&](const int h) {
      m_quarters.push_back({h, false, unit});
      if (!t_mesh.is_corner(h))
        m_quarters.push_back({h, true, unit});
      if (!t_mesh.is_border(T_mesh_arrays<FT>::opposite(h)))
        unit /= t_mesh.ratio(h);
    });
  }

  int size() const { return static_cast<int>(m_quarters.size()); }
  const Vertex_quarter<FT>& operator[](const int i) const { return m_quarters[i]; }
  auto begin() const { return m_quarters.begin(); }
  auto end() const { return m_quarters.end(); }

private:
  std::vector<Vertex_quarter<FT>> m_quarters;
};

/// The first direction of a quarter in the frame of its face: 0 to 3 for +u, +v, -u, -v.
template <typename FT>
int first_direction(const T_mesh_arrays<FT>& t_mesh, const Vertex_quarter<FT>& quarter)
{
  return (t_mesh.side(quarter.h) + (quarter.is_upper || t_mesh.is_corner(quarter.h) ? 1 : 0)) % 4;
}

/// The similarity from the frame of the face of a quarter to the frame of its vertex: the vertex is the origin, and the
/// first direction of the quarter is the direction number `direction`.
template <typename FT>
Similarity_2<FT> frame_of_quarter(const T_mesh_arrays<FT>& t_mesh, const Vertex_quarter<FT>& quarter,
                                  const int direction)
{
  const int turns = direction - first_direction(t_mesh, quarter);
  const auto p = t_mesh.target_point(quarter.h);
  const auto image = Similarity_2<FT>(turns, quarter.unit, FT(0), FT(0))(p.first, p.second);
  return Similarity_2<FT>(turns, quarter.unit, FT(-image.first), FT(-image.second));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_VERTEX_QUARTERS_H
