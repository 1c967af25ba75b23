// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_BASIS_SUPPORT_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_BASIS_SUPPORT_H

#include <CGAL/T_splines/T_mesh/internal/Basis_knots.h>
#include <CGAL/T_splines/T_mesh/internal/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/internal/Vertex_quarters.h>

#include <algorithm>
#include <array>
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

/// The supporting submesh of a basis function, found quarter by quarter ([CZ17] sections 4.1.1 and 4.1.3): the faces
/// that the support overlaps, each once; next to a vertex of valence 1 or 2, each with all of its transitions.
///
/// The quarter that ends in a face at an extraordinary vertex, opposite to it, is left out: it has no other faces. In
/// faces at extraordinary vertices no basis function is evaluated, but the search passes through them.
template <typename FT>
class Basis_support {
  using Arrays = T_mesh_arrays<FT>;
  using Similarity = Similarity_2<FT>;

  // [low[0], high[0]] x [low[1], high[1]]
  struct Rectangle {
    std::array<FT, 2> low, high;
  };

public:
  static constexpr int none = -1;

  /// \param corner_of_face per face: its halfedge that ends at an extraordinary vertex, or `none`
  /// \param may_be_overlapped_twice per face: it is in the rings of a vertex of valence 1 or 2, around which supports
  ///        come back
  Basis_support(const Arrays& t_mesh, const std::vector<int>& corner_of_face,
                const std::vector<char>& may_be_overlapped_twice)
    : m_t_mesh(t_mesh),
      m_corner_of_face(corner_of_face),
      m_may_be_overlapped_twice(may_be_overlapped_twice)
  {
  }

  /// Finds the support of the vertex with these quarters and knots.
  void find(const Vertex_quarters<FT>& quarters, const Basis_knots<FT>& knots)
  {
    m_faces.clear();
    m_cone_faces.clear();
    m_overlap = none;
    for (int q = 0; q < quarters.size(); ++q) {
      const int corner = m_corner_of_face[m_t_mesh.face(quarters[q].h)];
      if (corner == none || !is_opposite(corner, quarters[q]))
        search(quarters[q], q % 4, knots);
    }
  }

  const std::vector<Support_face<FT>>& faces() const { return m_faces; }

  /// Faces at extraordinary vertices that the support overlaps; possibly some of them twice.
  const std::vector<Support_face<FT>>& cone_faces() const { return m_cone_faces; }

  /// A face that the support overlaps with two different transitions, or `none`.
  int overlap() const { return m_overlap; }

  /// The similarity of the vertex's frame to itself on the way from one image of that face to the other. \pre there is
  /// one
  const Similarity_2<FT>& round_trip() const { return m_round_trip; }

private:
  // Whether the corner opposite to that of h is the vertex of the quarter, a corner itself.
  bool is_opposite(const int h, const Vertex_quarter<FT>& quarter) const
  {
    return m_t_mesh.is_corner(quarter.h) && (m_t_mesh.side(quarter.h) + 2) % 4 == m_t_mesh.side(h);
  }

  void search(const Vertex_quarter<FT>& quarter, const int q, const Basis_knots<FT>& knots)
  {
    const auto& u = knots.knots[0];
    const auto& v = knots.knots[1];
    const bool is_right = q == 0 || q == 3, is_upper = q < 2;
    const FT zero(0);
    const Rectangle rectangle{{is_right ? zero : u[0], is_upper ? zero : v[0]},
                              {is_right ? u[4] : zero, is_upper ? v[4] : zero}};
    m_queue.clear();
    add({m_t_mesh.face(quarter.h), frame_of_quarter(m_t_mesh, quarter, q)});
    for (std::size_t i = 0; i < m_queue.size() && m_overlap == none; ++i)
      cross_edges(m_queue[i], rectangle);
  }

  // Goes on over the edges that lie inside the rectangle, at least in part.
  void cross_edges(const Support_face<FT> from, const Rectangle& rectangle)
  {
    const int f = from.face;
    for (int side = 0; side < 4; ++side) {
      const int first = m_t_mesh.first_of_side(f, side), axis = (side + from.to_vertex.quarter_turns()) % 2;
      const auto start = m_t_mesh.source_point(first);
      const std::array<FT, 2> begin = coordinates(from.to_vertex(start.first, start.second));
      // Round-off alone: an axis must not swallow the narrow faces next to it, where the function does not vanish.
      const FT eps = Arrays::tolerance(FT(rectangle.high[1 - axis] - rectangle.low[1 - axis])) / FT(100);
      if (!(begin[1 - axis] > rectangle.low[1 - axis] + eps && begin[1 - axis] < rectangle.high[1 - axis] - eps))
        continue;
      const bool is_forward = (side + from.to_vertex.quarter_turns()) % 4 < 2;
      const FT eps_along = Arrays::tolerance(FT(rectangle.high[axis] - rectangle.low[axis])) / FT(100);
      for (int h = first;; h = m_t_mesh.next(h)) {
        const FT a = from.to_vertex.scale() * m_t_mesh.begin(h), b = from.to_vertex.scale() * m_t_mesh.end(h);
        const FT low = is_forward ? FT(begin[axis] + a) : FT(begin[axis] - b),
                 high = is_forward ? FT(begin[axis] + b) : FT(begin[axis] - a);
        if (high > rectangle.low[axis] + eps_along && low < rectangle.high[axis] - eps_along &&
            !m_t_mesh.is_border(Arrays::opposite(h)))
          add({m_t_mesh.face(Arrays::opposite(h)), compose(from.to_vertex, m_t_mesh.transition(Arrays::opposite(h)))});
        if (m_t_mesh.is_corner(h))
          break;
      }
    }
  }

  static std::array<FT, 2> coordinates(const std::pair<FT, FT>& p) { return {p.first, p.second}; }

  // The search ends with the first overlap. It may go around an extraordinary vertex up to four times.
  void add(const Support_face<FT>& face)
  {
    int count = 0;
    for (const Support_face<FT>& known : m_queue)
      if (known.face == face.face) {
        if (is_same(known, face))
          return;
        if (++count > 4)
          set_overlap(known, face);
      }
    m_queue.push_back(face);
    if (m_corner_of_face[face.face] != none) {
      m_cone_faces.push_back(face);
      return;
    }
    for (const Support_face<FT>& known : m_faces)
      if (known.face == face.face) {
        if (is_same(known, face))
          return;
        if (!m_may_be_overlapped_twice[face.face])
          set_overlap(known, face);
      }
    m_faces.push_back(face);
  }

  void set_overlap(const Support_face<FT>& a, const Support_face<FT>& b)
  {
    m_overlap = a.face;
    m_round_trip = compose(b.to_vertex, a.to_vertex.inverse());
  }

  // Two transitions of one face are equal, or far apart.
  bool is_same(const Support_face<FT>& a, const Support_face<FT>& b) const
  {
    if constexpr (is_exact_number_type<FT>)
      return a.to_vertex == b.to_vertex;
    else {
      const Similarity &s = a.to_vertex, &t = b.to_vertex;
      // The face may be long and narrow, and far away.
      const bool is_odd = s.quarter_turns() % 2 == 1;
      const FT width = s.scale() * m_t_mesh.width(a.face), height = s.scale() * m_t_mesh.height(a.face);
      const auto is_close = [](const FT& x, const FT& y, const FT& size) {
        return CGAL::abs(x - y) <= FT(1e-6) * size + FT(1e-13) * CGAL::abs(x);
      };
      return s.quarter_turns() == t.quarter_turns() && is_close(s.u(), t.u(), is_odd ? height : width) &&
             is_close(s.v(), t.v(), is_odd ? width : height);
    }
  }

  const Arrays& m_t_mesh;
  const std::vector<int>& m_corner_of_face;
  const std::vector<char>& m_may_be_overlapped_twice;
  std::vector<Support_face<FT>> m_faces, m_cone_faces, m_queue;
  int m_overlap = none;
  Similarity m_round_trip;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_BASIS_SUPPORT_H
