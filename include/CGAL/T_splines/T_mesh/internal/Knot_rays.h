// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_KNOT_RAYS_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_KNOT_RAYS_H

#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What a vertex does to rays that reach it: at a regular one they go on, or leave the surface.
struct Vertex_kind {
  bool is_extraordinary = false; ///< beyond it the knots are uniform
  bool is_beside_corner = false; ///< on the border in the first two rings of a corner that turns inwards
  bool is_natural = false;       ///< the border there is a natural end for lines across it
  bool ends_lines = false;       ///< lines along the border end there, although it may go straight on
  bool is_on_border = false;     ///< of the surface, not only of one of its parts between creases
};

/// Whether a line along an edge of the border has a natural end at a vertex where it ends: along a crease, so that it is
/// the same on both sides, except on the border of the surface; along this, where it ends at a crease.
template <typename FT>
bool ends_naturally(const T_mesh_arrays<FT>& t_mesh, const int edge, const Vertex_kind& end)
{
  return t_mesh.is_crease(edge) ? !end.is_on_border : end.is_natural && !end.ends_lines;
}

/// What a ray from a vertex meets: the distances of its first intersections with vertices and orthogonal edges.
template <typename FT>
struct Knot_ray {
  static constexpr int no_border = 4;

  std::array<FT, 3> distance{}; ///< the third one is only looked for if the T-mesh has a border
  int border = no_border;       ///< the ray leaves the surface at intersection number `border`; 0: at the vertex itself
  bool is_natural = false;      ///< the border is a natural end
  bool begins_line = false;     ///< it runs along the border, and its vertex is an end for lines there
  bool begins_naturally = false; ///< this end is natural
  /// Per interval the halfedge of a face along which it was measured, or from whose edge across its face; -1 beyond a
  /// border or an extraordinary vertex.
  std::array<int, 3> halfedge{-1, -1, -1};
  std::array<bool, 3> is_across{};
};

/// Follows rays through a T-mesh ([CZ17] section 4.1.2, after Sederberg et al. 2003). Beyond an extraordinary vertex a
/// ray goes on by steps of the same length: there the knots are uniform. Natural ends are those at creases, and those
/// next to corners of the border that turn inwards.
template <typename FT>
class Knot_ray_tracer {
  using Arrays = T_mesh_arrays<FT>;

public:
  /// \param kinds per vertex
  Knot_ray_tracer(const Arrays& t_mesh, const std::vector<Vertex_kind>& kinds, const bool has_border)
    : m_t_mesh(t_mesh),
      m_kinds(kinds),
      m_number_of_steps(has_border ? 3 : 2)
  {
  }

  /// The ray in the first direction of a quarter, in the unit of the quarters.
  Knot_ray<FT> trace_first(const Vertex_quarter<FT>& quarter) const
  {
    return quarter.is_upper ? trace({Position::INSIDE, quarter.h, m_t_mesh.end(quarter.h), quarter.unit})
                            : trace({Position::ALONG, m_t_mesh.next(quarter.h), FT(0), quarter.unit});
  }

  /// The ray in the second direction of a quarter, the last one at a border vertex.
  Knot_ray<FT> trace_second(const Vertex_quarter<FT>& quarter) const
  {
    if (!quarter.is_upper && !m_t_mesh.is_corner(quarter.h))
      return trace({Position::INSIDE, quarter.h, m_t_mesh.end(quarter.h), quarter.unit});
    const int g = Arrays::opposite(quarter.h);
    return trace({Position::ALONG, g, FT(0),
                  m_t_mesh.is_border(g) ? quarter.unit : FT(quarter.unit / m_t_mesh.ratio(quarter.h))});
  }

private:
  // Where a ray is: at the source of the halfedge h, about to go along it; or on the side of h at the distance x from
  // the side's begin, about to cross the face; or where uniform knots begin. One unit of the face is `unit` units of the
  // ray; of a border halfedge the opposite face counts.
  struct Position {
    enum Kind : char { ALONG, INSIDE, OUTSIDE, UNIFORM };
    Kind kind;
    int h;
    FT x, unit;
    bool is_natural = false; // an end OUTSIDE
  };

  Knot_ray<FT> trace(Position position) const
  {
    Knot_ray<FT> ray;
    FT distance(0);
    for (int i = 0; i < m_number_of_steps; ++i) {
      if (position.kind == Position::UNIFORM) {
        ray.distance[i] = i == 1 ? FT(FT(2) * distance) : FT(FT(2) * ray.distance[i - 1] - ray.distance[i - 2]);
        continue;
      }
      const int measured = position.kind == Position::ALONG && m_t_mesh.is_border(position.h)
                               ? Arrays::opposite(position.h)
                               : position.h;
      ray.halfedge[i] = measured;
      ray.is_across[i] = position.kind == Position::INSIDE;
      if (ray.is_across[i]) {
        distance += position.unit * m_t_mesh.side_length(m_t_mesh.face(measured), m_t_mesh.side(measured) + 1);
        position = after_face(position);
      }
      else {
        distance += position.unit * m_t_mesh.knot(measured);
        position = after_edge(position);
      }
      ray.distance[i] = distance;
      if (position.kind == Position::OUTSIDE) {
        ray.border = i + 1;
        ray.is_natural = position.is_natural;
        for (int k = i + 1; k < 3; ++k)
          ray.distance[k] = distance;
        return ray;
      }
    }
    return ray;
  }

  // The ray has reached the end of position.h.
  Position after_edge(const Position& position) const
  {
    const int g = position.h, w = m_t_mesh.target(g);
    if (m_kinds[w].is_extraordinary)
      return {Position::UNIFORM, g, FT(0), position.unit};
    const bool is_along_border = m_t_mesh.is_border(g) || m_t_mesh.is_border(Arrays::opposite(g));
    if (is_along_border && m_kinds[w].ends_lines)
      return end_of_line(g, w, position.unit);
    if (m_t_mesh.is_border(g))
      return after_border_edge(position);
    const int n = m_t_mesh.next(g);
    if (!m_t_mesh.is_corner(g))
      return {Position::ALONG, n, FT(0), position.unit};
    if (is_along_border && m_t_mesh.is_border(Arrays::opposite(n)))
      return end_of_line(g, w, position.unit);
    return clockwise_of(n, position.unit);
  }

  Position end_of_line(const int edge, const int end, const FT& unit) const
  {
    return {Position::OUTSIDE, edge, FT(0), unit, ends_naturally(m_t_mesh, edge, m_kinds[end])};
  }

  // The position behind the halfedge n, whose source the ray has reached: n points to the left of the ray. The unit is
  // that of the face of n.
  Position clockwise_of(const int n, const FT& unit) const
  {
    const int o = Arrays::opposite(n);
    if (m_t_mesh.is_border(o))
      return {Position::OUTSIDE, n, FT(0), unit, m_kinds[m_t_mesh.source(n)].is_natural};
    const FT unit_behind = unit / m_t_mesh.ratio(n);
    if (m_t_mesh.is_corner(o))
      return {Position::ALONG, m_t_mesh.next(o), FT(0), unit_behind};
    return {Position::INSIDE, o, m_t_mesh.end(o), unit_behind};
  }

  // As after_edge(), with the surface to the right of the ray.
  Position after_border_edge(const Position& position) const
  {
    const int i = m_t_mesh.prev(Arrays::opposite(position.h));
    if (!m_t_mesh.is_corner(i))
      return along_opposite(i, position.unit);
    const int o = Arrays::opposite(i);
    if (m_t_mesh.is_border(o))
      return end_of_line(position.h, m_t_mesh.target(position.h), position.unit);
    const FT unit = position.unit / m_t_mesh.ratio(i);
    const int j = m_t_mesh.prev(o);
    if (m_t_mesh.is_corner(j))
      return along_opposite(j, unit);
    return {Position::INSIDE, j, m_t_mesh.end(j), unit};
  }

  Position along_opposite(const int i, const FT& unit) const
  {
    const int o = Arrays::opposite(i);
    return {Position::ALONG, o, FT(0), m_t_mesh.is_border(o) ? unit : FT(unit / m_t_mesh.ratio(i))};
  }

  // The ray has crossed the face of position.h.
  Position after_face(const Position& position) const
  {
    const int f = m_t_mesh.face(position.h), side = m_t_mesh.side(position.h);
    const FT size = m_t_mesh.side_length(f, side), x = size - position.x, eps = knot_tolerance(size);
    int e = m_t_mesh.first_of_side(f, (side + 2) % 4);
    while (!m_t_mesh.is_corner(e) && x > m_t_mesh.end(e) + eps)
      e = m_t_mesh.next(e);
    if (!m_t_mesh.is_corner(e) && x >= m_t_mesh.end(e) - eps) { // a vertex
      if (m_kinds[m_t_mesh.target(e)].is_extraordinary)
        return {Position::UNIFORM, e, FT(0), position.unit};
      return clockwise_of(m_t_mesh.next(e), position.unit);
    }
    const int o = Arrays::opposite(e);
    if (m_t_mesh.is_border(o)) {
      const bool is_natural = m_t_mesh.is_crease(e) || m_kinds[m_t_mesh.source(e)].is_beside_corner ||
                              m_kinds[m_t_mesh.target(e)].is_beside_corner;
      return {Position::OUTSIDE, e, FT(0), position.unit, is_natural};
    }
    const FT ratio = m_t_mesh.ratio(e);
    return {Position::INSIDE, o, FT(m_t_mesh.begin(o) + FT(m_t_mesh.end(e) - x) * ratio), FT(position.unit / ratio)};
  }

  const Arrays& m_t_mesh;
  const std::vector<Vertex_kind>& m_kinds;
  int m_number_of_steps;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_KNOT_RAYS_H
