// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_T_MESH_ARRAYS_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_T_MESH_ARRAYS_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/T_mesh/internal/face_frames.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// A halfedge of `T_mesh_arrays`.
template <typename FT>
struct T_mesh_halfedge {
  int next = -1, prev = -1, target = -1, face = -1, side = -1;
  bool is_corner = false, is_crease = false;
  FT knot = FT(0), begin = FT(0);
};

// All but sides and begins. The members of T_mesh_arrays would hide the graph's free functions.
template <typename FT, typename TMesh>
std::vector<T_mesh_halfedge<FT>> t_mesh_halfedges(const Mesh_indexing<typename TMesh::Graph>& indexing,
                                                  const TMesh& t_mesh)
{
  const auto& graph = indexing.graph();
  std::vector<T_mesh_halfedge<FT>> result(indexing.number_of_halfedges());
  for (int i = 0; i < indexing.number_of_halfedges(); ++i) {
    const auto h = indexing.halfedge(i);
    result[i].next = indexing.halfedge_index(next(h, graph));
    result[i].prev = indexing.halfedge_index(prev(h, graph));
    result[i].target = indexing.vertex_index(target(h, graph));
    if (face(h, graph) == boost::graph_traits<typename TMesh::Graph>::null_face())
      continue;
    const bool is_border_edge =
        face(opposite(h, graph), graph) == boost::graph_traits<typename TMesh::Graph>::null_face();
    result[i].is_crease = !is_border_edge && t_mesh.is_crease(h);
    result[i].face = indexing.face_index(face(h, graph));
    result[i].is_corner = t_mesh.is_corner(h);
    result[i].knot = converted_number<FT>(t_mesh.knot(h));
  }
  return result;
}

template <typename Graph>
int halfedge_index_of_face(const Mesh_indexing<Graph>& indexing, const int f)
{
  return indexing.halfedge_index(halfedge(indexing.face(f), indexing.graph()));
}

/// A T-mesh with halfedge knots in index arrays, for the algorithms that look at much of it and change nothing.
///
/// Halfedges 2e and 2e + 1 are opposite. A face is [0, width] x [0, height] in its own units; its sides have the
/// numbers 0 to 3 from the bottom, counter-clockwise, and so have the four directions +u, +v, -u, -v. At a border
/// halfedge only connectivity has a meaning.
///
/// Edges of the border are no creases. `cut_along_creases()` makes a T-mesh with the same faces in
/// which they are borders.
/// \tparam FT the number type of lengths
template <typename FT_>
class T_mesh_arrays {
public:
  using FT = FT_;
  using Point = std::pair<FT, FT>;
  static constexpr int none = -1;

  T_mesh_arrays() = default;

  /// \pre each face has four corners
  /// \tparam TMesh a `T_mesh_view`
  template <typename TMesh>
  T_mesh_arrays(const Mesh_indexing<typename TMesh::Graph>& indexing, const TMesh& t_mesh)
    : m_number_of_vertices(indexing.number_of_vertices()),
      m_number_of_originals(indexing.number_of_vertices()),
      m_number_of_original_halfedges(indexing.number_of_halfedges()),
      m_halfedges(t_mesh_halfedges<FT>(indexing, t_mesh)),
      m_faces(indexing.number_of_faces())
  {
    find_incoming();
    for (int f = 0; f < number_of_faces(); ++f)
      set_frame(f, halfedge_index_of_face(indexing, f));
  }

  bool has_creases() const
  {
    return std::any_of(m_halfedges.begin(), m_halfedges.end(), [](const Halfedge& h) { return h.is_crease; });
  }

  /// The T-mesh with a border on both sides of each crease. Faces keep their numbers, and so do vertices and halfedges,
  /// but for the copies that come after them: of a vertex one for each of the sectors between creases there, of an edge
  /// a second one, whose even halfedge is what the odd one was in its face.
  T_mesh_arrays cut_along_creases() const
  {
    T_mesh_arrays result(*this);
    for (int h = 0; h < number_of_halfedges(); h += 2)
      if (is_crease(h))
        result.cut_edge(h);
    result.divide_vertices();
    result.find_incoming();
    return result;
  }

  /// Whether creases end at a vertex: unless it is inside, and a single one goes straight on, seen from both sides.
  bool ends_creases(const int v) const
  {
    int number = 0, between = 0; // quarters between the first and the second one
    for_each_incoming(v, [&](const int h) {
      if (number == 1)
        between += is_corner(h) ? 1 : 2;
      number += is_crease(h) ? 1 : 0;
    });
    return number != 0 && (number != 2 || is_border_vertex(v) || extended_valence(v) != 4 || between != 2);
  }

  /// The vertex, before creases were cut, of which this is a copy.
  int original_vertex(const int v) const
  {
    return v < m_number_of_originals ? v : m_original_of_copy[v - m_number_of_originals];
  }
  int number_of_original_vertices() const { return m_number_of_originals; }
  /// The halfedge of the same face before creases were cut. \pre it is not a border halfedge
  int original_halfedge(const int h) const
  {
    return h < m_number_of_original_halfedges ? h : m_original_of_edge[(h - m_number_of_original_halfedges) / 2];
  }

  int number_of_vertices() const { return m_number_of_vertices; }
  int number_of_halfedges() const { return static_cast<int>(m_halfedges.size()); }
  int number_of_edges() const { return number_of_halfedges() / 2; }
  int number_of_faces() const { return static_cast<int>(m_faces.size()); }

  static int opposite(const int h) { return internal::opposite(h); }
  int next(const int h) const { return m_halfedges[h].next; }
  int prev(const int h) const { return m_halfedges[h].prev; }
  int target(const int h) const { return m_halfedges[h].target; }
  int source(const int h) const { return target(opposite(h)); }
  int face(const int h) const { return m_halfedges[h].face; }
  bool is_border(const int h) const { return face(h) == none; }
  bool is_corner(const int h) const { return m_halfedges[h].is_corner; } ///< the face turns at the target
  bool is_crease(const int h) const { return m_halfedges[h].is_crease; } ///< also of one that was cut
  int side(const int h) const { return m_halfedges[h].side; }
  const FT& knot(const int h) const { return m_halfedges[h].knot; }
  const FT& begin(const int h) const { return m_halfedges[h].begin; } ///< distance of the source from the side's begin
  FT end(const int h) const { return begin(h) + knot(h); }

  /// A halfedge that ends at `v`, not on the border; if `v` is a border vertex, the one of the first face of its fan
  /// counter-clockwise.
  int incoming(const int v) const { return m_incoming[v]; }

  /// The next halfedge that ends at the target of `h`, counter-clockwise; on the border where the fan ends.
  int counter_clockwise(const int h) const { return prev(opposite(h)); }
  int clockwise(const int h) const { return opposite(next(h)); }

  const FT& width(const int f) const { return m_faces[f].width; }
  const FT& height(const int f) const { return m_faces[f].height; }
  const FT& side_length(const int f, const int side) const { return side % 2 == 0 ? width(f) : height(f); }
  int first_of_side(const int f, const int side) const { return m_faces[f].first[side]; }
  bool is_whole_side(const int h) const { return is_corner(h) && is_corner(prev(h)); }

  /// The point of a side at a distance from its begin, in the frame of the face.
  Point point_of_side(const int f, const int side, const FT& distance) const
  {
    return internal::point_of_side(*this, f, side, distance);
  }
  Point source_point(const int h) const { return point_of_side(face(h), side(h), begin(h)); }
  Point target_point(const int h) const { return point_of_side(face(h), side(h), end(h)); }

  /// How many units of the face of `opposite(h)` are one unit of the face of `h`. \pre both are faces
  FT ratio(const int h) const { return knot(opposite(h)) / knot(h); }

  /// The similarity from the frame of the face of `h` to that of its opposite, tau of [CZ17] 4.1.1. \pre both are faces
  Similarity_2<FT> transition(const int h) const
  {
    const int o = opposite(h);
    return transition_of_frames<FT>({side(h), source_point(h)}, {side(o), target_point(o)}, ratio(h));
  }

  /// The extended valence ([CZ17] section 4).
  int extended_valence(const int v) const
  {
    int result = 0;
    for_each_incoming(v, [&](const int h) { result += is_corner(h) ? 1 : 2; });
    return result;
  }

  bool is_border_vertex(const int v) const { return is_border(opposite(next(m_incoming[v]))); }

  /// Calls `f(h)` for the halfedges, not on the border, that end at `v`, counter-clockwise.
  template <typename Function>
  void for_each_incoming(const int v, const Function& f) const
  {
    const int first = m_incoming[v];
    int h = first;
    do {
      f(h);
      h = counter_clockwise(h);
    } while (h != first && !is_border(h));
  }

private:
  using Halfedge = T_mesh_halfedge<FT>;

  struct Face {
    std::array<int, 4> first;
    FT width, height;
  };

  void find_incoming()
  {
    m_incoming.assign(m_number_of_vertices, none);
    for (int h = 0; h < number_of_halfedges(); ++h) {
      if (!is_border(h))
        m_incoming[target(h)] = h;
    }
    // The fan at a border vertex begins at the border.
    for (int h = 0; h < number_of_halfedges(); ++h)
      if (!is_border(h) && is_border(opposite(next(h))))
        m_incoming[target(h)] = h;
  }

  // Halfedge h keeps its place, its opposite becomes the border; what the opposite was in its face gets a new edge.
  void cut_edge(const int h)
  {
    const int o = opposite(h), moved = number_of_halfedges(), border = moved + 1;
    m_original_of_edge.push_back(o);
    m_halfedges.push_back(m_halfedges[o]);
    m_halfedges.emplace_back();
    m_halfedges[next(moved)].prev = moved;
    m_halfedges[prev(moved)].next = moved;
    m_halfedges[border].target = target(h);
    m_halfedges[border].is_crease = true;
    for (int& first : m_faces[face(moved)].first)
      if (first == o)
        first = moved;
    m_halfedges[o] = Halfedge();
    m_halfedges[o].target = target(moved);
    m_halfedges[o].is_crease = true;
  }

  // Gives each fan of faces at the end of a crease a vertex of its own, and joins the border halfedges there.
  void divide_vertices()
  {
    std::vector<char> has_crease(m_number_of_originals, 0), is_taken(m_number_of_originals, 0);
    for (int h = 0; h < number_of_halfedges(); ++h)
      if (is_crease(h))
        has_crease[target(h)] = 1;
    for (int h = 0; h < number_of_halfedges(); ++h) {
      const int in = opposite(next(h));
      if (is_border(h) || !is_border(in) || target(h) >= m_number_of_originals || has_crease[target(h)] == 0)
        continue;
      const int v = target(h);
      int copy = v;
      if (is_taken[v] != 0) {
        copy = m_number_of_vertices++;
        m_original_of_copy.push_back(v);
      }
      is_taken[v] = 1;
      int last = h;
      for (m_halfedges[last].target = copy; !is_border(opposite(last)); m_halfedges[last].target = copy)
        last = counter_clockwise(last);
      m_halfedges[in].target = copy;
      m_halfedges[in].next = opposite(last);
      m_halfedges[opposite(last)].prev = in;
    }
  }

  void set_frame(const int f, int h)
  {
    while (!is_corner(prev(h)))
      h = prev(h);
    std::array<FT, 4> length;
    for (int side = 0; side < 4; ++side) {
      m_faces[f].first[side] = h;
      length[side] = FT(0);
      bool is_last = false;
      while (!is_last) {
        m_halfedges[h].side = side;
        m_halfedges[h].begin = length[side];
        length[side] += knot(h);
        is_last = is_corner(h);
        h = next(h);
      }
    }
    m_faces[f].width = length[0];
    m_faces[f].height = length[1];
  }

  int m_number_of_vertices = 0, m_number_of_originals = 0, m_number_of_original_halfedges = 0;
  std::vector<int> m_original_of_copy, m_original_of_edge; // of those that cuts made
  std::vector<T_mesh_halfedge<FT>> m_halfedges;
  std::vector<int> m_incoming; // per vertex
  std::vector<Face> m_faces;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_T_MESH_ARRAYS_H
