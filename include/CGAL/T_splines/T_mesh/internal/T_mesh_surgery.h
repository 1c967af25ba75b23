// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_SURGERY_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_SURGERY_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The four changes that all operations on T-meshes are made of: a vertex comes into an edge or leaves it, a face is cut
// in two, two faces become one. Whether a change is allowed is decided by the caller. Only next, opposite, target and
// face are used, so the T-mesh may be non-simple.
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename Visitor>
class T_mesh_surgery {
  using Traits = boost::graph_traits<TMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Coordinates = T_mesh_coordinates<TMesh, HalfedgeKnotMap, HalfedgeCornerMap>;

public:
  using FT = typename Coordinates::FT;
  using Piece = T_mesh_piece<TMesh, FT>;

  T_mesh_surgery(TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners, const Visitor& visitor)
    : m_t_mesh(t_mesh),
      m_knots(knots),
      m_corners(corners),
      m_visitor(visitor),
      m_coordinates(t_mesh, knots, corners)
  {
  }

  // Inserts a vertex at the distance x from the source of h. Returns the halfedge that ends there; h begins there now,
  // and the opposite of h ends there.
  // pre: h is not a border halfedge, 0 < x < knot of h
  halfedge_descriptor split_edge(const halfedge_descriptor h, const FT& x)
  {
    const halfedge_descriptor o = opposite(h, m_t_mesh), p = prev(h, m_t_mesh), q = next(o, m_t_mesh);
    const vertex_descriptor source = target(o, m_t_mesh), v = add_vertex(m_t_mesh);
    const halfedge_descriptor n = halfedge(add_edge(m_t_mesh), m_t_mesh), m = opposite(n, m_t_mesh);
    set_target(n, v, m_t_mesh);
    set_target(m, source, m_t_mesh);
    set_target(o, v, m_t_mesh);
    set_next(n, h, m_t_mesh);
    set_next(o, m, m_t_mesh);
    if (q == h) // the source of h has no other edge
      set_next(m, n, m_t_mesh);
    else {
      set_next(p, n, m_t_mesh);
      set_next(m, q, m_t_mesh);
    }
    set_face(n, face(h, m_t_mesh), m_t_mesh);
    set_face(m, face(o, m_t_mesh), m_t_mesh);
    set_halfedge(v, n, m_t_mesh);
    if (halfedge(source, m_t_mesh) == o)
      set_halfedge(source, m, m_t_mesh);

    const FT knot = get(m_knots, h);
    put(m_knots, n, x);
    put(m_knots, h, FT(knot - x));
    put(m_corners, n, false);
    if (face(o, m_t_mesh) != Traits::null_face()) {
      const FT ratio = FT(get(m_knots, o)) / knot;
      put(m_knots, m, FT(ratio * x));
      put(m_knots, o, FT(ratio * FT(knot - x)));
      put(m_corners, m, bool(get(m_corners, o)));
      put(m_corners, o, false);
    }
    m_visitor.vertex_inserted(v, n);
    return n;
  }

  // Whether the target of h has two edges, two different ones.
  bool has_two_edges(const halfedge_descriptor h) const
  {
    const halfedge_descriptor n = next(h, m_t_mesh);
    return n != h && n != opposite(h, m_t_mesh) && next(opposite(n, m_t_mesh), m_t_mesh) == opposite(h, m_t_mesh);
  }

  // Removes the vertex at which h ends; h reaches over the next edge then.
  // pre: has_two_edges(h), both faces go straight on there
  void join_edges(const halfedge_descriptor h)
  {
    const halfedge_descriptor n = next(h, m_t_mesh), m = opposite(n, m_t_mesh), o = opposite(h, m_t_mesh);
    const vertex_descriptor v = target(h, m_t_mesh), w = target(n, m_t_mesh);
    m_visitor.vertex_removed(v, h);
    const halfedge_descriptor after = next(n, m_t_mesh), before = prev(m, m_t_mesh);
    set_target(h, w, m_t_mesh);
    if (after == m) // w has no other edge
      set_next(h, o, m_t_mesh);
    else {
      set_next(h, after, m_t_mesh);
      set_next(before, o, m_t_mesh);
    }
    if (halfedge(w, m_t_mesh) == n)
      set_halfedge(w, h, m_t_mesh);
    absorb(h, n);
    absorb(o, m);
    if (face(h, m_t_mesh) != Traits::null_face())
      put(m_corners, h, bool(get(m_corners, n)));
    remove_edge(edge(n, m_t_mesh), m_t_mesh);
    remove_vertex(v, m_t_mesh);
  }

  // Cuts the face of a and b from the target of a to that of b. The part to the left of the new edge keeps the
  // face. a lies on the bottom or on the right side, b on the side opposite to that of a.
  // pre: neither target is a corner of the face; length is the distance between the two sides
  halfedge_descriptor cut_face(const halfedge_descriptor a, const halfedge_descriptor b, const FT& length)
  {
    const face_descriptor f = face(a, m_t_mesh), g = add_face(m_t_mesh);
    const bool is_vertical = m_coordinates.side(a) == 0;
    const FT width = m_coordinates.width(f), height = m_coordinates.height(f);
    const halfedge_descriptor after_a = next(a, m_t_mesh), after_b = next(b, m_t_mesh);
    const halfedge_descriptor n = halfedge(add_edge(m_t_mesh), m_t_mesh), m = opposite(n, m_t_mesh);
    const FT x = distance_of_target(a);
    set_target(n, target(b, m_t_mesh), m_t_mesh);
    set_target(m, target(a, m_t_mesh), m_t_mesh);
    set_next(a, n, m_t_mesh);
    set_next(n, after_b, m_t_mesh);
    set_next(b, m, m_t_mesh);
    set_next(m, after_a, m_t_mesh);
    for (const halfedge_descriptor h : {a, b, n, m})
      put(m_corners, h, true);
    put(m_knots, n, length);
    put(m_knots, m, length);
    set_face(n, f, m_t_mesh);
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(m, m_t_mesh))
      set_face(h, g, m_t_mesh);
    if (is_vertical)
      set_halfedge(f, a, m_t_mesh);
    set_halfedge(g, is_vertical ? after_a : m, m_t_mesh);

    m_visitor.edge_inserted(n);
    const FT zero(0);
    if (is_vertical)
      report_pieces({Piece{f, f, Similarity_2<FT>(), x, height},
                     Piece{f, g, Similarity_2<FT>(0, FT(1), FT(-x), zero), FT(width - x), height}});
    else
      report_pieces({Piece{f, f, Similarity_2<FT>(), width, x},
                     Piece{f, g, Similarity_2<FT>(0, FT(1), zero, FT(-x)), width, FT(height - x)}});
    return n;
  }

  // Removes the edge of h; the face of h takes over the opposite one, in its own units.
  // pre: two different faces, of each of which the edge is a full side
  face_descriptor merge_faces(const halfedge_descriptor h)
  {
    const halfedge_descriptor o = opposite(h, m_t_mesh);
    const face_descriptor f = face(h, m_t_mesh), g = face(o, m_t_mesh);
    const std::vector<Piece> pieces = merged_pieces(h);
    if (m_coordinates.side(h) == 0)
      set_halfedge(f, m_coordinates.first_of_side(g, (m_coordinates.side(o) + 2) % 4), m_t_mesh);
    m_visitor.edge_removed(h);

    const FT scale = FT(get(m_knots, h)) / FT(get(m_knots, o));
    for (const halfedge_descriptor i : CGAL::halfedges_around_face(o, m_t_mesh)) {
      put(m_knots, i, FT(scale * FT(get(m_knots, i))));
      set_face(i, f, m_t_mesh);
    }
    const halfedge_descriptor p = prev(h, m_t_mesh), n = next(h, m_t_mesh);
    const halfedge_descriptor po = prev(o, m_t_mesh), no = next(o, m_t_mesh);
    const vertex_descriptor v = target(o, m_t_mesh), w = target(h, m_t_mesh);
    set_next(p, no, m_t_mesh);
    set_next(po, n, m_t_mesh);
    put(m_corners, p, false);
    put(m_corners, po, false);
    set_halfedge(v, p, m_t_mesh);
    set_halfedge(w, po, m_t_mesh);
    remove_edge(edge(h, m_t_mesh), m_t_mesh);
    report_pieces(pieces);
    remove_face(g, m_t_mesh);
    if (has_two_edges(p))
      join_edges(p);
    if (w != v && has_two_edges(po))
      join_edges(po);
    return f;
  }

  void report_pieces(const std::vector<Piece>& pieces) const { m_visitor.faces_replaced(pieces); }

  const Coordinates& coordinates() const { return m_coordinates; }
  TMesh& t_mesh() { return m_t_mesh; }
  const HalfedgeKnotMap& knots() const { return m_knots; }
  const HalfedgeCornerMap& corners() const { return m_corners; }
  const Visitor& visitor() const { return m_visitor; }

  FT distance_of_target(const halfedge_descriptor h) const
  {
    return m_coordinates.place(h).begin + FT(get(m_knots, h));
  }

private:
  // h takes over the knots and the references of n.
  void absorb(const halfedge_descriptor h, const halfedge_descriptor n)
  {
    const face_descriptor f = face(h, m_t_mesh);
    if (f == Traits::null_face())
      return;
    put(m_knots, h, FT(FT(get(m_knots, h)) + FT(get(m_knots, n))));
    if (halfedge(f, m_t_mesh) == n)
      set_halfedge(f, h, m_t_mesh);
  }

  // The frame of the face of h moves only if the other face lies to its left or below.
  std::vector<Piece> merged_pieces(const halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, m_t_mesh);
    const face_descriptor f = face(h, m_t_mesh), g = face(o, m_t_mesh);
    const Similarity_2<FT> g_to_f = m_coordinates.transition(o);
    const int side = m_coordinates.side(h), other_side = m_coordinates.side(o);
    const FT depth = g_to_f.scale() * (other_side % 2 == 0 ? FT(m_coordinates.height(g)) : FT(m_coordinates.width(g)));
    const FT zero(0);
    const Similarity_2<FT> move(0, FT(1), side == 3 ? depth : zero, side == 0 ? depth : zero);
    const FT width = m_coordinates.width(f) + (side % 2 == 1 ? depth : zero);
    const FT height = m_coordinates.height(f) + (side % 2 == 0 ? depth : zero);
    return {Piece{f, f, move, width, height}, Piece{g, f, compose(move, g_to_f), width, height}};
  }

  TMesh& m_t_mesh;
  HalfedgeKnotMap m_knots;
  HalfedgeCornerMap m_corners;
  Visitor m_visitor;
  Coordinates m_coordinates;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_SURGERY_H
