// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_EDITOR_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_EDITOR_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_edit.h>
#include <CGAL/T_splines/T_mesh/T_mesh_visitor.h>
#include <CGAL/T_splines/T_mesh/internal/Line_shift.h>
#include <CGAL/T_splines/T_mesh/internal/T_mesh_surgery.h>
#include <CGAL/T_splines/T_mesh/is_admissible.h>

#include <CGAL/assertions.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace T_splines {

/// Changes a T-mesh with halfedge knots; each operation keeps it admissible ([CZ17] section 8).
///
/// Lines of the T-mesh are inserted, removed and moved along the axes of the faces; extraordinary vertices never move
/// and keep all their edges, at least in part. An operation that is not allowed does nothing and says why. The time
/// that an operation takes is linear in the number of halfedges of the faces that it touches; a shift may need its
/// square.
///
/// With inexact knots, points whose distance is below 1e-11 of the sides they lie on count as one.
/// \tparam TMesh a model of `MutableFaceGraph`; it may be non-simple
/// \tparam HalfedgeKnotMap a read/write map, halfedge -> knot interval; its values may also be set at halfedges that
///         the graph has just added
/// \tparam HalfedgeCornerMap a read/write map, halfedge -> `bool`, likewise
/// \tparam Visitor a model of `TMeshVisitor`; it is copied
/// \tparam VertexIsConstrainedMap a readable map, vertex -> `bool`: vertices that are treated as extraordinary ones
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename Visitor = T_mesh_visitor,
          typename VertexIsConstrainedMap =
              CGAL::Static_boolean_property_map<typename boost::graph_traits<TMesh>::vertex_descriptor, false>>
class T_mesh_editor {
  using Traits = boost::graph_traits<TMesh>;

public:
  using Coordinates = T_mesh_coordinates<TMesh, HalfedgeKnotMap, HalfedgeCornerMap>;
  using FT = typename Coordinates::FT;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Edit = T_mesh_edit<TMesh>;
  using Overlap = T_mesh_overlap<TMesh, FT>;

  /// \pre the knots are admissible
  T_mesh_editor(TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                const Visitor& visitor = Visitor(),
                const VertexIsConstrainedMap vertex_is_constrained = VertexIsConstrainedMap())
    : m_surgery(t_mesh, knots, corners, visitor),
      m_t_mesh(t_mesh),
      m_knots(knots),
      m_corners(corners),
      m_vertex_is_constrained(vertex_is_constrained)
  {
  }

  const Coordinates& coordinates() const { return m_surgery.coordinates(); }

  /// returns whether operations must leave `v` where it is, with all its edges: it is extraordinary or constrained.
  bool is_fixed(const vertex_descriptor v) const
  {
    return get(m_vertex_is_constrained, v) || is_extraordinary(v, m_t_mesh, m_corners);
  }

  /// inserts a vertex into the edge of `h`, at the distance `x` from the source of `h` in the units of its face.
  /// \return the halfedge that ends at the new vertex, or OUTSIDE, NO_FACE
  Edit insert_vertex(const halfedge_descriptor h, const FT& x)
  {
    if (face(h, m_t_mesh) == Traits::null_face())
      return {T_mesh_edit_status::NO_FACE};
    if (!is_inside(x, get(m_knots, h)))
      return {T_mesh_edit_status::OUTSIDE};
    return done(m_surgery.split_edge(h, x));
  }

  /// removes the vertex at which `h` ends, if it has two edges and is not fixed.
  /// \return `h`, which reaches to the end of the other edge then; or FIXED_VERTEX, NOT_REMOVABLE
  Edit remove_vertex(const halfedge_descriptor h)
  {
    if (is_fixed(target(h, m_t_mesh)))
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
    const FT eps = tolerance(size);
    halfedge_descriptor from = halfedge_to(coordinates().first_of_side(a), x, eps);
    // The bottom may be glued to the top, so that each vertex inserted into one appears in the other.
    const halfedge_descriptor b_first = coordinates().first_of_side(b);
    const vertex_descriptor foot = target(from, m_t_mesh);
    const halfedge_descriptor to = halfedge_to(b_first, FT(coordinates().side_length(b_first) - x), eps);
    if (target(from, m_t_mesh) != foot)
      from = next(from, m_t_mesh);
    CGAL_assertion(target(from, m_t_mesh) == foot);
    const halfedge_descriptor n = m_surgery.cut_face(from, to, length);
    CGAL_assertion(is_admissible_at(n) && is_admissible_at(opposite(n, m_t_mesh)));
    return done(n);
  }

  /// splits the face of `h` by an edge from the target of `h`, where the face goes straight on: extends a T-joint.
  /// \return the halfedge of the new edge in the part with the smaller coordinates, or NO_FACE, NO_T_JOINT, OUTSIDE
  Edit extend(const halfedge_descriptor h)
  {
    if (face(h, m_t_mesh) == Traits::null_face())
      return {T_mesh_edit_status::NO_FACE};
    if (get(m_corners, h))
      return {T_mesh_edit_status::NO_T_JOINT};
    const int side = coordinates().side(h);
    const FT distance = m_surgery.distance_of_target(h);
    const FT x = side < 2 ? distance : FT(coordinates().side_length(h) - distance);
    return split_face(face(h, m_t_mesh), side % 2, x);
  }

  /// returns how the two faces of `h` touch along the edge of `h`: the maximal chain of edges that contains it.
  /// \pre neither halfedge of the edge is on the border
  Overlap overlap(const halfedge_descriptor h) const
  {
    Overlap result;
    result.first = result.last = h;
    while (!get(m_corners, prev(result.first, m_t_mesh)) && goes_on(prev(result.first, m_t_mesh)))
      result.first = prev(result.first, m_t_mesh);
    while (!get(m_corners, result.last) && goes_on(result.last))
      result.last = next(result.last, m_t_mesh);
    const halfedge_descriptor o = opposite(result.last, m_t_mesh);
    result.begin = coordinates().place(result.first).begin;
    result.end = m_surgery.distance_of_target(result.last);
    result.scale = FT(get(m_knots, h)) / FT(get(m_knots, opposite(h, m_t_mesh)));
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
    if (!(get(m_corners, prev(o.first, m_t_mesh)) && get(m_corners, o.last) &&
          get(m_corners, opposite(o.first, m_t_mesh)) && get(m_corners, prev(opposite(o.last, m_t_mesh), m_t_mesh))))
      return T_mesh_edit_status::NOT_A_FULL_SIDE;
    return can_remove(o, true, true);
  }

  /// removes the chain of edges between the faces of `h`, if it is a full side of both ([CZ17] Fig. 12 left).
  ///
  /// The face of `h` becomes the union, in its own units. Vertices that only the chain held vanish.
  /// \return a halfedge of the union, or NO_FACE, SAME_FACE, NOT_A_FULL_SIDE, FIXED_VERTEX
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
  /// \return a halfedge of the union, or NO_FACE, SAME_FACE, FIXED_VERTEX, OUTSIDE
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
  /// \return a halfedge of the union, or NO_FACE, SAME_FACE, FIXED_VERTEX, OUTSIDE
  Edit remove_partly(const halfedge_descriptor h, const FT& from, const FT& to)
  {
    T_mesh_edit_status status = have_two_faces(h);
    if (status != T_mesh_edit_status::DONE)
      return {status};
    const Overlap o = overlap(h);
    const FT eps = tolerance((std::max)(o.side_length, FT(o.scale * o.opposite_side_length)));
    const FT length = o.end - o.begin;
    const bool at_first = CGAL::abs(from) <= eps, at_last = CGAL::abs(FT(to - length)) <= eps;
    if (!(from >= FT(0) || at_first) || !(to <= length || at_last) || !(to - from > eps + eps) ||
        !can_be_extended(o, at_first, at_last, eps))
      return {T_mesh_edit_status::OUTSIDE};
    status = can_remove(o, at_first, at_last);
    if (status != T_mesh_edit_status::DONE)
      return {status};

    const halfedge_descriptor before = at_first ? prev(o.first, m_t_mesh) : halfedge_to(o.first, from, eps);
    const halfedge_descriptor last = at_last ? o.last : halfedge_to(next(before, m_t_mesh), FT(to - from), eps);
    const halfedge_descriptor first = next(before, m_t_mesh);
    extend_if_straight(before);
    extend_if_straight(opposite(first, m_t_mesh));
    extend_if_straight(last);
    extend_if_straight(prev(opposite(last, m_t_mesh), m_t_mesh));
    return merge(first, last);
  }

  /// moves the straight line of edges through `h` by `delta`, in the units of the face of `h`, away from this face if
  /// `delta` is positive ([CZ17] section 8, "parallel edge shifts").
  ///
  /// The line is the longest one that contains the edge. It must be closed, or end on both sides at T-joints of
  /// orthogonal lines; all its vertices move with it, and must not meet or pass others.
  /// \return `h`, or NO_FACE, FIXED_VERTEX, NO_FREE_LINE, LINE_MEETS_ITSELF, OUTSIDE
  Edit shift(const halfedge_descriptor h, const FT& delta)
  {
    internal::Line_shift<TMesh, HalfedgeKnotMap, HalfedgeCornerMap, Visitor> line(m_surgery);
    const T_mesh_edit_status status = line.shift(h, delta, [this](const vertex_descriptor v) { return is_fixed(v); });
    if (status != T_mesh_edit_status::DONE)
      return {status};
    CGAL_assertion(is_admissible_at(h) && is_admissible_at(opposite(h, m_t_mesh)));
    return done(h);
  }

private:
  static FT tolerance(const FT& size)
  {
    if constexpr (internal::is_exact_number_type<FT>)
      return FT(0);
    else
      return size * FT(1e-11);
  }

  static bool is_inside(const FT& x, const FT& size)
  {
    const FT eps = tolerance(size);
    return x > eps && x < size - eps;
  }

  static Edit done(const halfedge_descriptor h) { return {T_mesh_edit_status::DONE, h}; }

  // The halfedge that ends at the distance x > 0 from the source of h, on the side that contains h. A vertex is
  // inserted there if there is none.
  halfedge_descriptor halfedge_to(halfedge_descriptor h, FT x, const FT& eps)
  {
    while (!get(m_corners, h) && x > FT(get(m_knots, h)) + eps) {
      x -= get(m_knots, h);
      h = next(h, m_t_mesh);
    }
    if (!get(m_corners, h) && x >= FT(get(m_knots, h)) - eps)
      return h;
    CGAL_assertion(FT(0) < x && x < FT(get(m_knots, h)));
    return m_surgery.split_edge(h, x);
  }

  // Whether the chain between the two faces of h goes on at the target of h, where the face of h goes straight on.
  bool goes_on(const halfedge_descriptor h) const
  {
    const halfedge_descriptor p = prev(opposite(h, m_t_mesh), m_t_mesh);
    return p == opposite(next(h, m_t_mesh), m_t_mesh) && !get(m_corners, p);
  }

  T_mesh_edit_status have_two_faces(const halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_t_mesh), g = face(opposite(h, m_t_mesh), m_t_mesh);
    if (f == Traits::null_face() || g == Traits::null_face())
      return T_mesh_edit_status::NO_FACE;
    return f == g ? T_mesh_edit_status::SAME_FACE : T_mesh_edit_status::DONE;
  }

  // Whether no vertex that is removed or loses an edge is fixed.
  T_mesh_edit_status can_remove(const Overlap& o, const bool at_first, const bool at_last) const
  {
    if ((at_first && is_fixed(target(opposite(o.first, m_t_mesh), m_t_mesh))) ||
        (at_last && is_fixed(target(o.last, m_t_mesh))))
      return T_mesh_edit_status::FIXED_VERTEX;
    for (halfedge_descriptor h = o.first; h != o.last; h = next(h, m_t_mesh)) {
      if (is_fixed(target(h, m_t_mesh)))
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
        is_far(get(m_corners, prev(o.first, m_t_mesh)), o.begin) &&
        is_far(get(m_corners, opposite(o.first, m_t_mesh)), FT(o.scale * FT(o.opposite_side_length - opposite_end)));
    const bool last_is_far =
        is_far(get(m_corners, o.last), FT(o.side_length - o.end)) &&
        is_far(get(m_corners, prev(opposite(o.last, m_t_mesh), m_t_mesh)), FT(o.scale * o.opposite_begin));
    return (!at_first || first_is_far) && (!at_last || last_is_far);
  }

  void extend_if_straight(const halfedge_descriptor h)
  {
    if (get(m_corners, h))
      return;
    const Edit edit = extend(h);
    CGAL_assertion(bool(edit));
    CGAL_USE(edit);
  }

  Edit merge(const halfedge_descriptor first, const halfedge_descriptor last)
  {
    while (!get(m_corners, first)) {
      CGAL_assertion(first != last);
      m_surgery.join_edges(first);
    }
    CGAL_USE(last);
    const halfedge_descriptor h = halfedge(m_surgery.merge_faces(first), m_t_mesh);
    CGAL_assertion(is_admissible_at(h));
    return done(h);
  }

  // Whether the face of h and the vertices on its boundary fulfil their conditions.
  bool is_admissible_at(const halfedge_descriptor h) const
  {
    const internal::Admissibility_check<TMesh, HalfedgeKnotMap, HalfedgeCornerMap> check(m_t_mesh, m_knots, m_corners,
                                                                                         1e-6);
    Admissibility_report<TMesh> report;
    bool result = face(h, m_t_mesh) == Traits::null_face() || check.check_face(face(h, m_t_mesh), report);
    for (const halfedge_descriptor i : CGAL::halfedges_around_face(h, m_t_mesh))
      result = result && check.check_vertex(target(i, m_t_mesh), report);
    return result;
  }

  internal::T_mesh_surgery<TMesh, HalfedgeKnotMap, HalfedgeCornerMap, Visitor> m_surgery;
  TMesh& m_t_mesh;
  HalfedgeKnotMap m_knots;
  HalfedgeCornerMap m_corners;
  VertexIsConstrainedMap m_vertex_is_constrained;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_EDITOR_H
