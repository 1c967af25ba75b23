// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_EDITOR_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_EDITOR_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_edit.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/T_mesh/internal/Line_shift.h>
#include <CGAL/T_splines/T_mesh/internal/T_mesh_surgery.h>
#include <CGAL/T_splines/T_mesh/internal/is_node_of_creases.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/assertions.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// Changes a T-mesh with halfedge knots; each operation keeps it admissible ([CZ17] section 8).
///
/// Lines of the T-mesh are inserted, removed and moved along the axes of the faces; extraordinary vertices never move
/// and keep all their edges, at least in part; the same holds for vertices where creases do not go straight
/// through. Creases are neither removed nor moved to their side; their parts are creases, too. An
/// operation that is not allowed does nothing and says why. The time that an operation takes is linear in the number of halfedges of the faces that it touches; a shift may need its
/// square.
///
/// With inexact knots, points whose distance is below 1e-11 of the sides they lie on count as one.
/// \tparam TMesh a `T_mesh_view`, which the constructor finds for any model of `TMesh` whose graph is one of
///         `MutableFaceGraph`
/// \tparam Observer a model of `TMeshObserver`; it is copied
/// \tparam VertexIsConstrainedMap a readable map, vertex -> `bool`: vertices that are treated as extraordinary ones
template <typename TMesh, typename Observer = T_mesh_observer,
          typename VertexIsConstrainedMap = CGAL::Static_boolean_property_map<typename TMesh::vertex_descriptor, false>>
class T_mesh_editor {
public:
  using Graph = typename TMesh::Graph;                                 ///< the T-mesh's graph
  using Coordinates = T_mesh_coordinates<Const_T_mesh_view_of<TMesh>>; ///< coordinates in the faces
  using FT = typename TMesh::FT;                                       ///< number type of the knots
  using vertex_descriptor = typename TMesh::vertex_descriptor;         ///< a vertex of the graph
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;     ///< a halfedge of the graph
  using face_descriptor = typename TMesh::face_descriptor;             ///< a face of the graph
  using Edit = T_mesh_edit<Graph>;                                     ///< the result of an operation
  using Overlap = T_mesh_overlap<Graph, FT>;                           ///< where two faces touch

  /// \pre the knots are admissible
  explicit T_mesh_editor(const TMesh& t_mesh, const Observer& observer = Observer(),
                         const VertexIsConstrainedMap vertex_is_constrained = VertexIsConstrainedMap())
    : m_surgery(t_mesh, observer),
      m_t_mesh(t_mesh),
      m_graph(t_mesh.graph()),
      m_vertex_is_constrained(vertex_is_constrained)
  {
  }

  /// returns the coordinates in the faces of the T-mesh, as it is now.
  const Coordinates& coordinates() const { return m_surgery.coordinates(); }

  /// returns whether operations must leave `v` where it is, with all its edges: it is extraordinary or constrained, or
  /// creases end or turn there.
  bool is_fixed(const vertex_descriptor v) const
  {
    return get(m_vertex_is_constrained, v) || is_extraordinary(v, m_t_mesh) ||
           internal::is_node_of_creases(v, m_t_mesh);
  }

  /// inserts a vertex into the edge of `h`, at the distance `x` from the source of `h` in the units of its face.
  /// \return the halfedge that ends at the new vertex, or OUTSIDE, NO_FACE
  Edit insert_vertex(const halfedge_descriptor h, const FT& x)
  {
    if (face(h, m_graph) == boost::graph_traits<Graph>::null_face())
      return {T_mesh_edit_status::NO_FACE};
    if (!is_inside(x, m_t_mesh.knot(h)))
      return {T_mesh_edit_status::OUTSIDE};
    return done(m_surgery.split_edge(h, x));
  }

  /// removes the vertex at which `h` ends, if it has two edges and is not fixed.
  /// \return `h`, which reaches to the end of the other edge then; or FIXED_VERTEX, NOT_REMOVABLE
  Edit remove_vertex(const halfedge_descriptor h)
  {
    if (is_fixed(target(h, m_graph)))
      return {T_mesh_edit_status::FIXED_VERTEX};
    if (!m_surgery.has_two_edges(h))
      return {T_mesh_edit_status::NOT_REMOVABLE};
    m_surgery.join_edges(h);
    return done(h);
  }

  /// splits a face by a new edge, along u = `x` if `axis` is 0, along v = `x` if it is 1.
  ///
  /// The edge ends at vertices of the face where there are any; otherwise vertices are inserted, T-joints of the
  /// neighbours. The part with the smaller coordinates keeps the descriptor and the frame.
  /// \return the halfedge of the new edge in `f`, or OUTSIDE
  Edit split_face(const face_descriptor f, const int axis, const FT& x)
  {
    CGAL_precondition(axis == 0 || axis == 1);
    const halfedge_descriptor a = coordinates().first_of_side(f, axis);
    const halfedge_descriptor b = coordinates().first_of_side(f, axis + 2);
    const FT size = coordinates().side_length(a);
    if (!is_inside(x, size))
      return {T_mesh_edit_status::OUTSIDE};
    const FT length = coordinates().side_length(coordinates().first_of_side(f, 1 - axis));
    const FT eps = internal::knot_tolerance(size);
    halfedge_descriptor from = halfedge_to(coordinates().first_of_side(a), x, eps);
    // The bottom may be glued to the top, so that each vertex inserted into one appears in the other.
    const halfedge_descriptor b_first = coordinates().first_of_side(b);
    const vertex_descriptor foot = target(from, m_graph);
    const halfedge_descriptor to = halfedge_to(b_first, FT(coordinates().side_length(b_first) - x), eps);
    if (target(from, m_graph) != foot)
      from = next(from, m_graph);
    CGAL_assertion(target(from, m_graph) == foot);
    const halfedge_descriptor n = m_surgery.cut_face(from, to, length);
    CGAL_assertion(is_admissible_at(n) && is_admissible_at(opposite(n, m_graph)));
    return done(n);
  }

  /// splits the face of `h` by an edge from the target of `h`, where the face goes straight on: extends a T-joint.
  /// \return the halfedge of the new edge in the part with the smaller coordinates, or NO_FACE, NO_T_JOINT, OUTSIDE
  Edit extend(const halfedge_descriptor h)
  {
    if (face(h, m_graph) == boost::graph_traits<Graph>::null_face())
      return {T_mesh_edit_status::NO_FACE};
    if (m_t_mesh.is_corner(h))
      return {T_mesh_edit_status::NO_T_JOINT};
    const int side = coordinates().side(h);
    const FT distance = m_surgery.distance_of_target(h);
    const FT x = side < 2 ? distance : FT(coordinates().side_length(h) - distance);
    return split_face(face(h, m_graph), side % 2, x);
  }

  /// returns how the two faces of `h` touch along the edge of `h`: the maximal chain of edges that contains it.
  /// \pre neither halfedge of the edge is on the border
  Overlap overlap(const halfedge_descriptor h) const
  {
    Overlap result;
    result.first = result.last = h;
    while (!m_t_mesh.is_corner(prev(result.first, m_graph)) && goes_on(prev(result.first, m_graph)))
      result.first = prev(result.first, m_graph);
    while (!m_t_mesh.is_corner(result.last) && goes_on(result.last))
      result.last = next(result.last, m_graph);
    const halfedge_descriptor o = opposite(result.last, m_graph);
    result.begin = coordinates().place(result.first).begin;
    result.end = m_surgery.distance_of_target(result.last);
    result.scale = FT(m_t_mesh.knot(h)) / FT(m_t_mesh.knot(opposite(h, m_graph)));
    result.opposite_begin = coordinates().place(o).begin;
    result.side_length = coordinates().side_length(h);
    result.opposite_side_length = coordinates().side_length(o);
    return result;
  }

  /// returns DONE if `remove_edge(h)` would remove the edge, else why not.
  T_mesh_edit_status can_remove(const halfedge_descriptor h) const
  {
    const T_mesh_edit_status status = have_two_faces(h);
    if (status != T_mesh_edit_status::DONE)
      return status;
    const Overlap o = overlap(h);
    if (!(m_t_mesh.is_corner(prev(o.first, m_graph)) && m_t_mesh.is_corner(o.last) &&
          m_t_mesh.is_corner(opposite(o.first, m_graph)) &&
          m_t_mesh.is_corner(prev(opposite(o.last, m_graph), m_graph))))
      return T_mesh_edit_status::NOT_A_FULL_SIDE;
    return can_remove(o, true, true);
  }

  /// removes the chain of edges between the faces of `h`, if it is a full side of both ([CZ17] Fig. 12 left).
  ///
  /// The face of `h` becomes the union, in its own units. Vertices that only the chain held vanish.
  /// \return a halfedge of the union, or NO_FACE, SAME_FACE, NOT_A_FULL_SIDE, FIXED_VERTEX, CREASE
  Edit remove_edge(const halfedge_descriptor h)
  {
    const T_mesh_edit_status status = can_remove(h);
    if (status != T_mesh_edit_status::DONE)
      return {status};
    const Overlap o = overlap(h);
    return merge(o.first, o.last);
  }

  /// removes the chain of edges between the faces of `h`, after edges orthogonal to it have been inserted at its ends
  /// where a face goes on beyond ([CZ17] Fig. 12 right).
  /// \return a halfedge of the union, or NO_FACE, SAME_FACE, FIXED_VERTEX, CREASE, OUTSIDE
  Edit flip_edge(const halfedge_descriptor h)
  {
    const T_mesh_edit_status status = have_two_faces(h);
    if (status != T_mesh_edit_status::DONE)
      return {status};
    const Overlap o = overlap(h);
    return remove_partly(h, FT(0), FT(o.end - o.begin));
  }

  /// removes a part of the chain of edges between the faces of `h`, between the distances `from` and `to` from its
  /// beginning in the units of the face of `h`; edges orthogonal to it are inserted at the ends of this part, through
  /// both faces within the chain ([CZ17] Fig. 13).
  ///
  /// Only an end of the chain that stays may be an extraordinary vertex.
  /// \return a halfedge of the union, or NO_FACE, SAME_FACE, FIXED_VERTEX, CREASE, OUTSIDE
  Edit remove_partly(const halfedge_descriptor h, const FT& from, const FT& to)
  {
    T_mesh_edit_status status = have_two_faces(h);
    if (status != T_mesh_edit_status::DONE)
      return {status};
    const Overlap o = overlap(h);
    const FT eps = internal::knot_tolerance((std::max)(o.side_length, FT(o.scale * o.opposite_side_length)));
    const FT length = o.end - o.begin;
    const bool at_first = CGAL::abs(from) <= eps, at_last = CGAL::abs(FT(to - length)) <= eps;
    if (!(from >= FT(0) || at_first) || !(to <= length || at_last) || !(to - from > eps + eps) ||
        !can_be_extended(o, at_first, at_last, eps))
      return {T_mesh_edit_status::OUTSIDE};
    status = can_remove(o, at_first, at_last);
    if (status != T_mesh_edit_status::DONE)
      return {status};

    const halfedge_descriptor before = at_first ? prev(o.first, m_graph) : halfedge_to(o.first, from, eps);
    const halfedge_descriptor last = at_last ? o.last : halfedge_to(next(before, m_graph), FT(to - from), eps);
    const halfedge_descriptor first = next(before, m_graph);
    extend_if_straight(before);
    extend_if_straight(opposite(first, m_graph));
    extend_if_straight(last);
    extend_if_straight(prev(opposite(last, m_graph), m_graph));
    return merge(first, last);
  }

  /// moves the straight line of edges through `h` by `delta`, in the units of the face of `h`, away from this face if
  /// `delta` is positive ([CZ17] section 8, "parallel edge shifts").
  ///
  /// The line is the longest one that contains the edge. It must be closed, or end on both sides at T-joints of
  /// orthogonal lines; all its vertices move with it, and must not meet or pass others.
  /// \return `h`, or NO_FACE, FIXED_VERTEX, CREASE, NO_FREE_LINE, LINE_MEETS_ITSELF, OUTSIDE
  Edit shift(const halfedge_descriptor h, const FT& delta)
  {
    internal::Line_shift<TMesh, Observer> line(m_surgery);
    const T_mesh_edit_status status = line.shift(h, delta, [this](const vertex_descriptor v) { return is_fixed(v); });
    if (status != T_mesh_edit_status::DONE)
      return {status};
    CGAL_assertion(is_admissible_at(h) && is_admissible_at(opposite(h, m_graph)));
    return done(h);
  }

private:
  static bool is_inside(const FT& x, const FT& size)
  {
    const FT eps = internal::knot_tolerance(size);
    return x > eps && x < size - eps;
  }

  static Edit done(const halfedge_descriptor h) { return {T_mesh_edit_status::DONE, h}; }

  // The halfedge that ends at the distance x > 0 from the source of h, on the side that contains h. A vertex is
  // inserted there if there is none.
  halfedge_descriptor halfedge_to(halfedge_descriptor h, FT x, const FT& eps)
  {
    while (!m_t_mesh.is_corner(h) && x > FT(m_t_mesh.knot(h)) + eps) {
      x -= m_t_mesh.knot(h);
      h = next(h, m_graph);
    }
    if (!m_t_mesh.is_corner(h) && x >= FT(m_t_mesh.knot(h)) - eps)
      return h;
    CGAL_assertion(FT(0) < x && x < FT(m_t_mesh.knot(h)));
    return m_surgery.split_edge(h, x);
  }

  // Whether the chain between the two faces of h goes on at the target of h, where the face of h goes straight on.
  bool goes_on(const halfedge_descriptor h) const
  {
    const halfedge_descriptor p = prev(opposite(h, m_graph), m_graph);
    return p == opposite(next(h, m_graph), m_graph) && !m_t_mesh.is_corner(p);
  }

  T_mesh_edit_status have_two_faces(const halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_graph), g = face(opposite(h, m_graph), m_graph);
    if (f == boost::graph_traits<Graph>::null_face() || g == boost::graph_traits<Graph>::null_face())
      return T_mesh_edit_status::NO_FACE;
    return f == g ? T_mesh_edit_status::SAME_FACE : T_mesh_edit_status::DONE;
  }

  // Whether no edge is a crease, and no vertex that is removed or loses an edge is fixed.
  T_mesh_edit_status can_remove(const Overlap& o, const bool at_first, const bool at_last) const
  {
    if (m_t_mesh.is_crease(o.last))
      return T_mesh_edit_status::CREASE;
    if ((at_first && is_fixed(target(opposite(o.first, m_graph), m_graph))) ||
        (at_last && is_fixed(target(o.last, m_graph))))
      return T_mesh_edit_status::FIXED_VERTEX;
    for (halfedge_descriptor h = o.first; h != o.last; h = next(h, m_graph)) {
      if (m_t_mesh.is_crease(h))
        return T_mesh_edit_status::CREASE;
      if (is_fixed(target(h, m_graph)))
        return T_mesh_edit_status::FIXED_VERTEX;
    }
    return T_mesh_edit_status::DONE;
  }

  // Whether the edges to be inserted at the ends of the overlap keep away from the corners of the faces.
  bool can_be_extended(const Overlap& o, const bool at_first, const bool at_last, const FT& eps) const
  {
    const auto is_far = [&](const bool is_corner, const FT& distance) { return is_corner || distance > eps; };
    const FT opposite_end = o.opposite_begin + FT(o.end - o.begin) / o.scale;
    const bool first_is_far =
        is_far(m_t_mesh.is_corner(prev(o.first, m_graph)), o.begin) &&
        is_far(m_t_mesh.is_corner(opposite(o.first, m_graph)), FT(o.scale * FT(o.opposite_side_length - opposite_end)));
    const bool last_is_far =
        is_far(m_t_mesh.is_corner(o.last), FT(o.side_length - o.end)) &&
        is_far(m_t_mesh.is_corner(prev(opposite(o.last, m_graph), m_graph)), FT(o.scale * o.opposite_begin));
    return (!at_first || first_is_far) && (!at_last || last_is_far);
  }

  void extend_if_straight(const halfedge_descriptor h)
  {
    if (m_t_mesh.is_corner(h))
      return;
    const Edit edit = extend(h);
    CGAL_assertion(bool(edit));
    CGAL_USE(edit);
  }

  Edit merge(const halfedge_descriptor first, const halfedge_descriptor last)
  {
    while (!m_t_mesh.is_corner(first)) {
      CGAL_assertion(first != last);
      m_surgery.join_edges(first);
    }
    CGAL_USE(last);
    const halfedge_descriptor h = halfedge(m_surgery.merge_faces(first), m_graph);
    CGAL_assertion(is_admissible_at(h));
    return done(h);
  }

  // Whether the face of h and the vertices on its boundary fulfil their conditions.
  bool is_admissible_at(const halfedge_descriptor h) const
  {
    const internal::Admissibility_check check(m_t_mesh, internal::summed_round_off);
    Admissibility_report<Graph> report;
    bool result =
        face(h, m_graph) == boost::graph_traits<Graph>::null_face() || check.check_face(face(h, m_graph), report);
    for (const halfedge_descriptor i : CGAL::halfedges_around_face(h, m_graph))
      result = result && check.check_vertex(target(i, m_graph), report);
    return result;
  }

  internal::T_mesh_surgery<TMesh, Observer> m_surgery;
  TMesh m_t_mesh;
  Graph& m_graph;
  VertexIsConstrainedMap m_vertex_is_constrained;
};

/// \cond INTERNAL
template <typename TMesh>
T_mesh_editor(TMesh&&) -> T_mesh_editor<T_mesh_view_of<TMesh>>;

template <typename TMesh, typename Observer>
T_mesh_editor(TMesh&&, const Observer&) -> T_mesh_editor<T_mesh_view_of<TMesh>, Observer>;

template <typename TMesh, typename Observer, typename VertexIsConstrainedMap>
T_mesh_editor(TMesh&&, const Observer&, VertexIsConstrainedMap)
    -> T_mesh_editor<T_mesh_view_of<TMesh>, Observer, VertexIsConstrainedMap>;
/// \endcond

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_EDITOR_H
