// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_SURGERY_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_SURGERY_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The four changes that all operations on T-meshes are made of: a vertex comes into an edge or leaves it, a face is cut
// in two, two faces become one. Whether a change is allowed is decided by the caller. Only next, opposite, target and
// face are used, so the T-mesh may be non-simple.
// \tparam TMesh a `T_mesh_view`
template <typename TMesh, typename Observer>
class T_mesh_surgery {
  using Graph = typename TMesh::Graph;
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename TMesh::vertex_descriptor;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using face_descriptor = typename TMesh::face_descriptor;
  using Coordinates = T_mesh_coordinates<Const_T_mesh_view_of<TMesh>>;

public:
  using FT = typename TMesh::FT;
  using Piece = T_mesh_piece<Graph, FT>;

  T_mesh_surgery(const TMesh& t_mesh, const Observer& observer)
    : m_t_mesh(t_mesh),
      m_graph(t_mesh.graph()),
      m_observer(observer),
      m_coordinates(t_mesh)
  {
  }

  // Inserts a vertex at the distance x from the source of h. Returns the halfedge that ends there; h begins there now,
  // and the opposite of h ends there.
  // pre: h is not a border halfedge, 0 < x < knot of h
  halfedge_descriptor split_edge(const halfedge_descriptor h, const FT& x)
  {
    const halfedge_descriptor o = opposite(h, m_graph), p = prev(h, m_graph), q = next(o, m_graph);
    const vertex_descriptor source = target(o, m_graph), v = add_vertex(m_graph);
    const halfedge_descriptor n = halfedge(add_edge(m_graph), m_graph), m = opposite(n, m_graph);
    set_target(n, v, m_graph);
    set_target(m, source, m_graph);
    set_target(o, v, m_graph);
    set_next(n, h, m_graph);
    set_next(o, m, m_graph);
    if (q == h) // the source of h has no other edge
      set_next(m, n, m_graph);
    else {
      set_next(p, n, m_graph);
      set_next(m, q, m_graph);
    }
    set_face(n, face(h, m_graph), m_graph);
    set_face(m, face(o, m_graph), m_graph);
    set_halfedge(v, n, m_graph);
    if (halfedge(source, m_graph) == o)
      set_halfedge(source, m, m_graph);

    m_t_mesh.set_crease(n, m_t_mesh.is_crease(h));
    const FT knot = m_t_mesh.knot(h);
    m_t_mesh.set_knot(n, x);
    m_t_mesh.set_knot(h, FT(knot - x));
    m_t_mesh.set_corner(n, false);
    if (face(o, m_graph) != Traits::null_face()) {
      const FT ratio = FT(m_t_mesh.knot(o)) / knot;
      m_t_mesh.set_knot(m, FT(ratio * x));
      m_t_mesh.set_knot(o, FT(ratio * FT(knot - x)));
      m_t_mesh.set_corner(m, bool(m_t_mesh.is_corner(o)));
      m_t_mesh.set_corner(o, false);
    }
    m_observer.vertex_inserted(v, n);
    return n;
  }

  // Whether the target of h has two edges, two different ones.
  bool has_two_edges(const halfedge_descriptor h) const
  {
    const halfedge_descriptor n = next(h, m_graph);
    return n != h && n != opposite(h, m_graph) && next(opposite(n, m_graph), m_graph) == opposite(h, m_graph);
  }

  // Removes the vertex at which h ends; h reaches over the next edge then.
  // pre: has_two_edges(h), both faces go straight on there; both edges are creases or neither is
  void join_edges(const halfedge_descriptor h)
  {
    const halfedge_descriptor n = next(h, m_graph), m = opposite(n, m_graph), o = opposite(h, m_graph);
    const vertex_descriptor v = target(h, m_graph), w = target(n, m_graph);
    m_observer.vertex_removed(v, h);
    const halfedge_descriptor after = next(n, m_graph), before = prev(m, m_graph);
    set_target(h, w, m_graph);
    if (after == m) // w has no other edge
      set_next(h, o, m_graph);
    else {
      set_next(h, after, m_graph);
      set_next(before, o, m_graph);
    }
    if (halfedge(w, m_graph) == n)
      set_halfedge(w, h, m_graph);
    absorb(h, n);
    absorb(o, m);
    if (face(h, m_graph) != Traits::null_face())
      m_t_mesh.set_corner(h, bool(m_t_mesh.is_corner(n)));
    remove_edge(edge(n, m_graph), m_graph);
    remove_vertex(v, m_graph);
  }

  // Cuts the face of a and b from the target of a to that of b. The part to the left of the new edge keeps the
  // face. a lies on the bottom or on the right side, b on the side opposite to that of a.
  // pre: neither target is a corner of the face; length is the distance between the two sides
  halfedge_descriptor cut_face(const halfedge_descriptor a, const halfedge_descriptor b, const FT& length)
  {
    const face_descriptor f = face(a, m_graph), g = add_face(m_graph);
    const bool is_vertical = m_coordinates.side(a) == 0;
    const FT width = m_coordinates.width(f), height = m_coordinates.height(f);
    const halfedge_descriptor after_a = next(a, m_graph), after_b = next(b, m_graph);
    const halfedge_descriptor n = halfedge(add_edge(m_graph), m_graph), m = opposite(n, m_graph);
    const FT x = distance_of_target(a);
    set_target(n, target(b, m_graph), m_graph);
    set_target(m, target(a, m_graph), m_graph);
    set_next(a, n, m_graph);
    set_next(n, after_b, m_graph);
    set_next(b, m, m_graph);
    set_next(m, after_a, m_graph);
    for (const halfedge_descriptor h : {a, b, n, m})
      m_t_mesh.set_corner(h, true);
    m_t_mesh.set_knot(n, length);
    m_t_mesh.set_knot(m, length);
    m_t_mesh.set_crease(n, false);
    set_face(n, f, m_graph);
    for (const halfedge_descriptor h : CGAL::halfedges_around_face(m, m_graph))
      set_face(h, g, m_graph);
    if (is_vertical)
      set_halfedge(f, a, m_graph);
    set_halfedge(g, is_vertical ? after_a : m, m_graph);

    m_observer.edge_inserted(n);
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
    const halfedge_descriptor o = opposite(h, m_graph);
    const face_descriptor f = face(h, m_graph), g = face(o, m_graph);
    const std::vector<Piece> pieces = merged_pieces(h);
    if (m_coordinates.side(h) == 0)
      set_halfedge(f, m_coordinates.first_of_side(g, (m_coordinates.side(o) + 2) % 4), m_graph);
    m_observer.edge_removed(h);

    const FT scale = FT(m_t_mesh.knot(h)) / FT(m_t_mesh.knot(o));
    for (const halfedge_descriptor i : CGAL::halfedges_around_face(o, m_graph)) {
      m_t_mesh.set_knot(i, FT(scale * FT(m_t_mesh.knot(i))));
      set_face(i, f, m_graph);
    }
    const halfedge_descriptor p = prev(h, m_graph), n = next(h, m_graph);
    const halfedge_descriptor po = prev(o, m_graph), no = next(o, m_graph);
    const vertex_descriptor v = target(o, m_graph), w = target(h, m_graph);
    set_next(p, no, m_graph);
    set_next(po, n, m_graph);
    m_t_mesh.set_corner(p, false);
    m_t_mesh.set_corner(po, false);
    set_halfedge(v, p, m_graph);
    set_halfedge(w, po, m_graph);
    remove_edge(edge(h, m_graph), m_graph);
    report_pieces(pieces);
    remove_face(g, m_graph);
    if (has_two_edges(p))
      join_edges(p);
    if (w != v && has_two_edges(po))
      join_edges(po);
    return f;
  }

  void report_pieces(const std::vector<Piece>& pieces) const { m_observer.faces_replaced(pieces); }

  const Coordinates& coordinates() const { return m_coordinates; }
  const TMesh& t_mesh() const { return m_t_mesh; }
  const Observer& observer() const { return m_observer; }

  FT distance_of_target(const halfedge_descriptor h) const
  {
    return m_coordinates.place(h).begin + FT(m_t_mesh.knot(h));
  }

private:
  // h takes over the knots and the references of n.
  void absorb(const halfedge_descriptor h, const halfedge_descriptor n)
  {
    const face_descriptor f = face(h, m_graph);
    if (f == Traits::null_face())
      return;
    m_t_mesh.set_knot(h, FT(FT(m_t_mesh.knot(h)) + FT(m_t_mesh.knot(n))));
    if (halfedge(f, m_graph) == n)
      set_halfedge(f, h, m_graph);
  }

  // The frame of the face of h moves only if the other face lies to its left or below.
  std::vector<Piece> merged_pieces(const halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, m_graph);
    const face_descriptor f = face(h, m_graph), g = face(o, m_graph);
    const Similarity_2<FT> g_to_f = m_coordinates.transition(o);
    const int side = m_coordinates.side(h), other_side = m_coordinates.side(o);
    const FT depth = g_to_f.scale() * (other_side % 2 == 0 ? FT(m_coordinates.height(g)) : FT(m_coordinates.width(g)));
    const FT zero(0);
    const Similarity_2<FT> move(0, FT(1), side == 3 ? depth : zero, side == 0 ? depth : zero);
    const FT width = m_coordinates.width(f) + (side % 2 == 1 ? depth : zero);
    const FT height = m_coordinates.height(f) + (side % 2 == 0 ? depth : zero);
    return {Piece{f, f, move, width, height}, Piece{g, f, compose(move, g_to_f), width, height}};
  }

  TMesh m_t_mesh;
  Graph& m_graph;
  Observer m_observer;
  Coordinates m_coordinates;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_T_MESH_SURGERY_H
