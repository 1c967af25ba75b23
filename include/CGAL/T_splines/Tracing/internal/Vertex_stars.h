// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_VERTEX_STARS_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_VERTEX_STARS_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// One of the isolines that leave a vertex.
struct Vertex_ray {
  int halfedge; ///< with the vertex as source: the ray lies in the corner of its face, between it and the next halfedge
                ///< around the vertex, or along it
  int direction; ///< in the chart of its face
  bool is_along; ///< along the halfedge
};

/// The isolines that leave the vertices of a seamless map, counter-clockwise: k of them at an inner vertex with k
/// quarter turns, k + 1 at a border vertex, where the last one runs along the border on the right of its halfedge's
/// opposite.
///
/// A vertex that nobody asked for costs four bytes.
template <typename FT, typename TracingTraits>
class Vertex_stars {
  using Layout = Seamless_layout<FT>;

public:
  static constexpr int none = -1;

  struct Star {
    int vertex;
    int first_ray;
    int number_of_rays;
    bool is_on_border;
  };

  Vertex_stars(const Layout& layout, const TracingTraits& traits)
    : m_layout(layout),
      m_traits(traits),
      m_outgoing(layout.mesh().outgoing_halfedges()),
      m_star_of_vertex(layout.mesh().number_of_vertices(), none)
  {
    const Triangulation_connectivity& mesh = layout.mesh();
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == none) // the opposite of a border halfedge is the first one, counter-clockwise
        m_outgoing[mesh.target(h)] = opposite(h);
  }

  /// The star of a vertex, made if it is new.
  int star_of_vertex(const int v)
  {
    if (m_star_of_vertex[v] == none)
      make_star(v);
    return m_star_of_vertex[v];
  }
  bool has_star(const int v) const { return m_star_of_vertex[v] != none; }
  int existing_star(const int v) const { return m_star_of_vertex[v]; }

  int number_of_stars() const { return static_cast<int>(m_stars.size()); }
  const Star& star(const int s) const { return m_stars[s]; }
  const Vertex_ray& ray(const int star, const int slot) const { return m_rays[m_stars[star].first_ray + slot]; }

  bool is_on_border(const int v) const { return m_layout.mesh().face(opposite(m_outgoing[v])) == none; }

  /// A halfedge that leaves v; on the border, the first one counter-clockwise.
  int outgoing(const int v) const { return m_outgoing[v]; }

  /// The slot of the ray in a corner. \param halfedge leaves the vertex; \param direction in the chart of its face
  int slot_in_corner(const int star, const int halfedge, const int direction) const
  {
    for (int slot = 0; slot < m_stars[star].number_of_rays; ++slot)
      if (ray(star, slot).halfedge == halfedge && ray(star, slot).direction == direction && !ray(star, slot).is_along)
        return slot;
    return none;
  }

  /// The slot of the ray along a halfedge that leaves the vertex.
  int slot_along(const int star, const int halfedge) const
  {
    for (int slot = 0; slot < m_stars[star].number_of_rays; ++slot)
      if (ray(star, slot).halfedge == halfedge && ray(star, slot).is_along)
        return slot;
    return none;
  }

  int next_slot_clockwise(const int star, const int slot) const
  {
    return slot == 0 ? m_stars[star].number_of_rays - 1 : slot - 1;
  }

  /// Calls a function with each scale but 1 of the transitions on the way from the chart of a ray to that of the next
  /// one, clockwise. \pre no border lies between
  template <typename Function>
  void for_each_scale_clockwise(const int star, const int slot, const Function& function) const
  {
    const Triangulation_connectivity& mesh = m_layout.mesh();
    const int target = ray(star, next_slot_clockwise(star, slot)).halfedge;
    int h = ray(star, slot).halfedge;
    if (mesh.face(h) == none)
      h = mesh.next(opposite(h));
    for (bool is_full_turn = slot == 0; is_full_turn || h != target; is_full_turn = false) {
      if (m_layout.is_cut(edge_of(h)) && m_layout.transition(h).scale() != 1)
        function(m_layout.transition(h).scale());
      h = mesh.next(opposite(h));
    }
  }

  /// The halfedge that points to the vertex in the face whose chart a ray refers to.
  int corner_of_ray(const int star, const int slot) const
  {
    const int h = ray(star, slot).halfedge;
    return m_layout.mesh().face(h) == none ? opposite(h) : m_layout.mesh().previous(h);
  }

private:
  // Sign of the coordinate on `axis` of the vector along h, in the chart of face f; h or its predecessor lies in f.
  CGAL::Sign sign_of_vector(const int from, const int to, const int axis) const
  {
    return static_cast<CGAL::Sign>(m_traits.compare(m_layout.coordinate(to, axis), m_layout.coordinate(from, axis)));
  }

  // Sign of the cross product of a vector with the unit vector of a direction.
  static CGAL::Sign cross(const CGAL::Sign u, const CGAL::Sign v, const int direction)
  {
    switch (direction) {
    case 0: return -v;
    case 1: return u;
    case 2: return v;
    default: return -u;
    }
  }

  // The rays in the corner of h, without those along the halfedge that follows it around the vertex.
  void add_rays_of_corner(const int h)
  {
    const Triangulation_connectivity& mesh = m_layout.mesh();
    const int last = mesh.previous(h), apex = mesh.next(h);
    const CGAL::Sign u1 = sign_of_vector(last, h, 0), v1 = sign_of_vector(last, h, 1);
    const CGAL::Sign u2 = sign_of_vector(last, apex, 0), v2 = sign_of_vector(last, apex, 1);
    const auto is_inside = [&](const int d) {
      return cross(u1, v1, d) != CGAL::NEGATIVE && cross(u2, v2, d) == CGAL::NEGATIVE;
    };
    int first = none;
    for (int d = 0; d < 4; ++d)
      if (is_inside(d) && !is_inside(turned(d, -1)))
        first = d;
    if (first == none)
      return;
    for (int d = first; is_inside(d); d = turned(d, 1))
      m_rays.push_back({h, d, cross(u1, v1, d) == CGAL::ZERO});
  }

  void make_star(const int v)
  {
    const Triangulation_connectivity& mesh = m_layout.mesh();
    Star star = {v, static_cast<int>(m_rays.size()), 0, is_on_border(v)};
    int h = m_outgoing[v];
    do {
      add_rays_of_corner(h);
      h = mesh.next_around_source(h);
    } while (h != m_outgoing[v] && mesh.face(h) != none);
    if (star.is_on_border) { // h is a border halfedge now: the last ray runs along it
      const int last_corner = mesh.next(opposite(h)), w = mesh.previous(last_corner), apex = mesh.next(last_corner);
      const CGAL::Sign u = sign_of_vector(w, apex, 0), v_sign = sign_of_vector(w, apex, 1);
      m_rays.push_back({h, u == CGAL::POSITIVE ? 0 : v_sign == CGAL::POSITIVE ? 1 : u == CGAL::NEGATIVE ? 2 : 3, true});
    }
    star.number_of_rays = static_cast<int>(m_rays.size()) - star.first_ray;
    m_star_of_vertex[v] = number_of_stars();
    m_stars.push_back(star);
  }

  const Layout& m_layout;
  const TracingTraits& m_traits;
  std::vector<int> m_outgoing;       // per vertex
  std::vector<int> m_star_of_vertex; // per vertex
  std::vector<Star> m_stars;
  std::vector<Vertex_ray> m_rays;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_VERTEX_STARS_H
