// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_BASIS_SUPPORT_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_BASIS_SUPPORT_H

#include <CGAL/T_splines/T_mesh/internal/Ring_controls.h>
#include <CGAL/T_splines/T_mesh/support/Basis_knots.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A face of the support of a basis function, and the similarity from its frame to that of the vertex, tau of
/// [CZ17] 4.1.1.
template <typename FT>
struct Support_face {
  int face;
  Similarity_2<FT> to_vertex;
};

/// The axis-parallel rectangle [low[0], high[0]] x [low[1], high[1]].
template <typename FT>
struct Support_rectangle {
  std::array<FT, 2> low, high;

  static Support_rectangle image(const Similarity_2<FT>& s, const Support_rectangle& r)
  {
    const std::pair<FT, FT> p = s(r.low[0], r.low[1]), q = s(r.high[0], r.high[1]);
    return {{(std::min)(p.first, q.first), (std::min)(p.second, q.second)},
            {(std::max)(p.first, q.first), (std::max)(p.second, q.second)}};
  }

  Support_rectangle intersection(const Support_rectangle& r) const
  {
    Support_rectangle result;
    for (int axis = 0; axis < 2; ++axis) {
      result.low[axis] = (std::max)(low[axis], r.low[axis]);
      result.high[axis] = (std::min)(high[axis], r.high[axis]);
    }
    return result;
  }

  bool has_interior(const FT& eps) const { return high[0] - low[0] > eps && high[1] - low[1] > eps; }
};

/// The support of a basis function, found quarter by quarter ([CZ17] sections 4.1.1 and 4.1.3).
///
/// It is an immersed rectangle. The search visits pairs of a face and a similarity tau to the frame of the vertex: a
/// face that the rectangle covers on two ways around the surface is two pieces of the support, each with its own place
/// between the knots. As long as no extraordinary vertex lies inside, this is well defined: the pieces tile the
/// rectangle.
///
/// The search goes away from the vertex, pieces closer to it first. So all that it has seen before it comes to the
/// first face at an extraordinary vertex where the function may not act is free of other such vertices. There, and
/// where the support has no end, it stops.
///
/// The quarter that ends in a face at an extraordinary vertex, opposite to it, is left out: it has no other faces. In
/// faces at extraordinary vertices no basis function is evaluated, but the search passes through them.
template <typename FT>
class Basis_support {
  using Arrays = T_mesh_arrays<FT>;
  using Similarity = Similarity_2<FT>;
  using Rectangle = Support_rectangle<FT>;

public:
  static constexpr int none = -1;

  Basis_support(const Arrays& t_mesh, const Ring_controls<FT>& controls)
    : m_t_mesh(t_mesh),
      m_controls(controls),
      m_first_piece(t_mesh.number_of_faces(), none)
  {
  }

  /// Finds the support of a vertex with these knots, as far as it lies in these quarters, which are in order.
  template <typename Quarters>
  void find(const int v, const Quarters& quarters, const Basis_knots<FT>& knots)
  {
    for (const Support_face<FT>& face : m_faces)
      m_first_piece[face.face] = none;
    m_faces.clear();
    m_pieces.clear();
    m_vertex = v;
    m_reached_cone_face = m_endless_face = none;
    for (m_quarter = 0; m_quarter < static_cast<int>(quarters.size()) && !is_stopped(); ++m_quarter)
      if (!is_opposite_to_cone(quarters[m_quarter]))
        search(quarters[m_quarter], m_quarter % 4, knots);
  }

  /// The pieces, those in faces at extraordinary vertices among them. A support that was not found to its end has those
  /// seen until then.
  const std::vector<Support_face<FT>>& faces() const { return m_faces; }

  /// Whether a face has more than one piece.
  bool overlaps_itself() const
  {
    return std::any_of(m_pieces.begin(), m_pieces.end(), [](const Piece& piece) { return piece.next != none; });
  }

  /// The number of a piece in a face at an extraordinary vertex where the function may not act, the closest one; or
  /// `none`.
  int reached_cone_face() const { return m_reached_cone_face; }

  /// The number of a piece that shows that the support has no end, or `none`.
  ///
  /// Two pieces of one face differ by a similarity h, the holonomy of the way between them. If the scale of h is not 1,
  /// it has a fixed point p, and if p lay in the rectangle, and it were covered by a point of the surface, then the
  /// deck transformation that belongs to h would fix that point; but it moves all points. (The two are compared on the
  /// common part of the rectangle and its preimage under h, which is convex and has p and a part of the face.) So the
  /// pieces around p become smaller and smaller, and do not end. Conversely, if they do not end, they accumulate at a
  /// point of the rectangle, and pieces of some face come so close to it that the fixed points of their differences do.
  int endless_piece() const { return m_endless_face; }

  /// The fixed point p in the frame of the vertex. \pre `endless_piece()` is not `none`
  const std::pair<FT, FT>& centre() const { return m_centre; }

  /// Where a piece lies in the frame of the vertex.
  Rectangle rectangle_of(const Support_face<FT>& face) const
  {
    return Rectangle::image(face.to_vertex, {{FT(0), FT(0)}, {m_t_mesh.width(face.face), m_t_mesh.height(face.face)}});
  }

private:
  // Pieces of one face are linked. `quarter` is the last one whose search visited it.
  struct Piece {
    int next, quarter;
  };

  struct Queue_entry {
    double distance;
    int piece;
    friend bool operator<(const Queue_entry& a, const Queue_entry& b)
    {
      return a.distance != b.distance ? a.distance > b.distance : a.piece > b.piece;
    }
  };

  bool is_stopped() const { return m_reached_cone_face != none || m_endless_face != none; }

  // Whether the quarter lies in a face at an extraordinary vertex, at the corner opposite to this vertex.
  bool is_opposite_to_cone(const Vertex_quarter<FT>& quarter) const
  {
    const int f = m_t_mesh.face(quarter.h);
    if (!m_controls.is_cone_face(f) || !m_t_mesh.is_corner(quarter.h))
      return false;
    // The extraordinary vertex is the corner at which the side before the first axis ends.
    const int first_side = (4 - m_controls.to_unit_square(f).quarter_turns()) % 4;
    return m_t_mesh.side(quarter.h) == (first_side + 1) % 4;
  }

  void search(const Vertex_quarter<FT>& quarter, const int q, const Basis_knots<FT>& knots)
  {
    const Axis_knots<FT>&u = knots.axes[0], &v = knots.axes[1];
    const bool is_right = q == 0 || q == 3, is_upper = q < 2;
    const FT zero(0);
    m_rectangle = {{is_right ? zero : u.begin(), is_upper ? zero : v.begin()},
                   {is_right ? u.end() : zero, is_upper ? v.end() : zero}};
    m_queue.clear();
    add({m_t_mesh.face(quarter.h), frame_of_quarter(m_t_mesh, quarter, q)});
    while (!m_queue.empty()) {
      std::pop_heap(m_queue.begin(), m_queue.end());
      const int piece = m_queue.back().piece;
      m_queue.pop_back();
      const Support_face<FT> from = m_faces[piece];
      if (m_controls.is_cone_face(from.face) && !m_controls.contains(from.face, m_vertex, from.to_vertex)) {
        if (!overlaps(from))
          continue;
        m_reached_cone_face = piece;
        return;
      }
      cross_edges(from);
      if (m_endless_face != none)
        return;
    }
  }

  // Whether the rectangle overlaps a piece by more than round-off, which vertices of the second ring have, too.
  bool overlaps(const Support_face<FT>& face) const
  {
    const Rectangle r = rectangle_of(face);
    const FT eps = is_exact_number_type<FT> ? FT(0) : FT(FT(summed_round_off) * FT(r.high[0] - r.low[0]));
    return r.intersection(m_rectangle).has_interior(eps);
  }

  // Goes on over the edges that lie inside the rectangle, at least in part.
  void cross_edges(const Support_face<FT>& from)
  {
    const int f = from.face;
    for (int side = 0; side < 4; ++side) {
      const int first = m_t_mesh.first_of_side(f, side), axis = (side + from.to_vertex.quarter_turns()) % 2;
      const auto start = m_t_mesh.source_point(first);
      const std::array<FT, 2> begin = coordinates(from.to_vertex(start.first, start.second));
      const FT eps = round_off(1 - axis);
      if (!(begin[1 - axis] > m_rectangle.low[1 - axis] + eps && begin[1 - axis] < m_rectangle.high[1 - axis] - eps))
        continue;
      const bool is_forward = (side + from.to_vertex.quarter_turns()) % 4 < 2;
      const FT eps_along = round_off(axis);
      for (int h = first;; h = m_t_mesh.next(h)) {
        const FT a = from.to_vertex.scale() * m_t_mesh.begin(h), b = from.to_vertex.scale() * m_t_mesh.end(h);
        const FT low = is_forward ? FT(begin[axis] + a) : FT(begin[axis] - b),
                 high = is_forward ? FT(begin[axis] + b) : FT(begin[axis] - a);
        if (high > m_rectangle.low[axis] + eps_along && low < m_rectangle.high[axis] - eps_along &&
            !m_t_mesh.is_border(Arrays::opposite(h)))
          add({m_t_mesh.face(Arrays::opposite(h)), compose(from.to_vertex, m_t_mesh.transition(Arrays::opposite(h)))});
        if (m_t_mesh.is_corner(h))
          break;
      }
    }
  }

  // Round-off alone: an axis must not swallow the narrow faces next to it, where the function does not vanish.
  FT round_off(const int axis) const
  {
    return knot_tolerance(FT(m_rectangle.high[axis] - m_rectangle.low[axis])) / FT(100);
  }

  static std::array<FT, 2> coordinates(const std::pair<FT, FT>& p) { return {p.first, p.second}; }

  void add(const Support_face<FT>& face)
  {
    int last = none;
    for (int i = m_first_piece[face.face]; i != none; last = i, i = m_pieces[i].next)
      if (is_same(m_faces[i], face)) {
        if (m_pieces[i].quarter != m_quarter)
          push(i);
        return;
      }
    const int piece = static_cast<int>(m_faces.size());
    m_faces.push_back(face);
    m_pieces.push_back({none, none});
    (last == none ? m_first_piece[face.face] : m_pieces[last].next) = piece;
    push(piece);
    for (int i = m_first_piece[face.face]; i != piece && m_endless_face == none; i = m_pieces[i].next)
      if (has_no_end(m_faces[i], face))
        m_endless_face = piece;
  }

  void push(const int piece)
  {
    m_pieces[piece].quarter = m_quarter;
    const Rectangle r = rectangle_of(m_faces[piece]);
    double distance = 0;
    for (int axis = 0; axis < 2; ++axis)
      distance = (std::max)({distance, CGAL::to_double(r.low[axis]), -CGAL::to_double(r.high[axis])});
    m_queue.push_back({distance, piece});
    std::push_heap(m_queue.begin(), m_queue.end());
  }

  // Different pieces of a face do not overlap: round-off is much smaller than what lies between them.
  bool is_same(const Support_face<FT>& a, const Support_face<FT>& b) const
  {
    if constexpr (is_exact_number_type<FT>)
      return a.to_vertex == b.to_vertex;
    else {
      if (a.to_vertex.quarter_turns() != b.to_vertex.quarter_turns())
        return false;
      const Rectangle p = rectangle_of(a), q = rectangle_of(b);
      for (int axis = 0; axis < 2; ++axis) {
        const FT eps = FT(same_image) * FT(p.high[axis] - p.low[axis]);
        if (!(CGAL::abs(p.low[axis] - q.low[axis]) <= eps && CGAL::abs(p.high[axis] - q.high[axis]) <= eps))
          return false;
      }
      return true;
    }
  }

  bool has_no_end(const Support_face<FT>& a, const Support_face<FT>& b)
  {
    const Similarity h = compose(b.to_vertex, a.to_vertex.inverse());
    if (is_same_unit(h.scale()))
      return false;
    // p = t / (1 - s i^r), in complex numbers.
    const int r = h.quarter_turns();
    const FT x = FT(1) - (r == 0 ? h.scale() : r == 2 ? FT(-h.scale()) : FT(0));
    const FT y = r == 1 ? FT(-h.scale()) : r == 3 ? h.scale() : FT(0);
    const FT norm = x * x + y * y;
    const std::pair<FT, FT> p(FT(FT(h.u() * x + h.v() * y) / norm), FT(FT(h.v() * x - h.u() * y) / norm));
    const FT eps = (std::max)(round_off(0), round_off(1)) * FT(1000);
    if (!(p.first >= m_rectangle.low[0] - eps && p.first <= m_rectangle.high[0] + eps &&
          p.second >= m_rectangle.low[1] - eps && p.second <= m_rectangle.high[1] + eps))
      return false;
    m_centre = p;
    return rectangle_of(a)
        .intersection(m_rectangle)
        .intersection(Rectangle::image(h.inverse(), m_rectangle))
        .has_interior(eps);
  }

  const Arrays& m_t_mesh;
  const Ring_controls<FT>& m_controls;
  std::vector<int> m_first_piece; // per face
  std::vector<Support_face<FT>> m_faces;
  std::vector<Piece> m_pieces; // of the same numbers
  std::vector<Queue_entry> m_queue;
  Rectangle m_rectangle;
  int m_vertex = none, m_quarter = 0, m_reached_cone_face = none, m_endless_face = none;
  std::pair<FT, FT> m_centre;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_BASIS_SUPPORT_H
