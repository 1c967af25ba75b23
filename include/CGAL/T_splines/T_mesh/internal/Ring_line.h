// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_RING_LINE_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_RING_LINE_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>

#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Extends lines of the rings around an extraordinary vertex beyond the third ring, face by face ([CZ17] section 8.2,
/// condition B).
/// \tparam Splits `Counted_splits`
template <typename Splits>
class Ring_line {
  using halfedge_descriptor = typename Splits::halfedge_descriptor;

public:
  explicit Ring_line(Splits& splits) : m_splits(splits) {}

  /// Extends the line x = 2 upwards if `axis` is 0, or the line y = 2 to the right if it is 1, in the sector of the
  /// regular rings whose inner cell has the corner at which `corner` ends.
  /// \param distance how far from the extraordinary vertex the line shall reach, in the unit of the rings
  /// \return whether anything was split; nothing is if the vertex at (2, 2) is extraordinary
  bool extend(const halfedge_descriptor corner, const int axis, const double distance)
  {
    const halfedge_descriptor bottom = above(above(right_of(next(corner, m_splits.t_mesh()))));
    return !ends_extraordinary(bottom) &&
           extend_from(axis == 0 ? next(bottom, m_splits.t_mesh()) : right_of(bottom), distance);
  }

  /// Extends the first spoke of a sector likewise, unless the vertex at (2, 0) is extraordinary.
  bool extend_spoke(const halfedge_descriptor corner, const double distance)
  {
    const halfedge_descriptor bottom = right_of(next(corner, m_splits.t_mesh()));
    return !ends_extraordinary(bottom) && extend_from(right_of(bottom), distance);
  }

private:
  // From the end of h, an edge of the third ring, straight on.
  bool extend_from(halfedge_descriptor h, const double distance)
  {
    const auto& t_mesh = m_splits.t_mesh();
    const double enough = distance * (1 - 1e-9);
    bool is_changed = false;
    for (double x = 3, unit = 1 / knot(h); x < enough; x += unit * knot(h)) {
      if (!is_corner(h)) {
        h = next(h, t_mesh);
        continue;
      }
      const halfedge_descriptor o = opposite(next(h, t_mesh), t_mesh);
      if (face(o, t_mesh) == boost::graph_traits<typename Splits::Graph>::null_face() || ends_extraordinary(h))
        return is_changed;
      unit *= knot(next(h, t_mesh)) / knot(o);
      if (!is_corner(o)) {
        if (!m_splits.extend(o))
          return is_changed;
        is_changed = true;
      }
      h = next(o, t_mesh);
    }
    return is_changed;
  }

  double knot(const halfedge_descriptor h) const { return CGAL::to_double(get(m_splits.knots(), h)); }
  bool is_corner(const halfedge_descriptor h) const { return get(m_splits.corners(), h); }

  bool ends_extraordinary(const halfedge_descriptor h) const
  {
    return is_extraordinary(target(h, m_splits.t_mesh()), m_splits.t_mesh(), m_splits.corners());
  }

  // From the bottom of one cell to that of the next.
  halfedge_descriptor right_of(const halfedge_descriptor bottom) const
  {
    const auto& t_mesh = m_splits.t_mesh();
    return next(opposite(next(bottom, t_mesh), t_mesh), t_mesh);
  }
  halfedge_descriptor above(const halfedge_descriptor bottom) const
  {
    const auto& t_mesh = m_splits.t_mesh();
    return opposite(next(next(bottom, t_mesh), t_mesh), t_mesh);
  }

  Splits& m_splits;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_RING_LINE_H
