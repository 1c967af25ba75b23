// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_TESSELLATION_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_TESSELLATION_H

#include <CGAL/T_splines/Spline/internal/T_mesh_divisions.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

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

/// A triangulation of the faces of a T-mesh whose vertices on an edge are the same from both sides, T-joints included.
///
/// Inside, a face that is divided into m x n parts has (m - 1) x (n - 1) points, and between them and the sides strips that
/// are zipped together.
///
/// A point on a crease, at an end of one, too, has a place of its own in each face around, for what differs from side to
/// side: the corners of triangles there have these places as well.
template <typename FT>
class Face_tessellation {
  using Arrays = T_mesh_arrays<FT>;

public:
  using Index = std::size_t;

  /// A point in the frame of a face.
  struct Place {
    int face;
    FT u, v;
  };

  /// A corner of a triangle on a crease.
  struct Crease_corner {
    Index triangle;
    int corner;  ///< from 0 to 2
    Index place; ///< of `crease_places()`, in the face of the triangle
  };

  /// \param divisions with at least three parts in each direction if the T-mesh has a tip: see `has_tip()`
  /// \param progress if it is interrupted, triangles are missing
  Face_tessellation(const Arrays& t_mesh, T_mesh_divisions divisions, Progress& progress)
    : m_t_mesh(t_mesh),
      m_divisions(std::move(divisions))
  {
    add_vertices();
    add_edges();
    find_tips();
    find_points_on_creases();
    for (int f = 0; f < t_mesh.number_of_faces() && progress.go_on_after(work(f)); ++f) {
      add_face(f);
      m_faces.resize(m_triangles.size(), f);
    }
    if (has_tip(t_mesh))
      remove_tips();
  }

  const std::vector<Place>& places() const { return m_places; }
  const std::vector<std::array<Index, 3>>& triangles() const { return m_triangles; }

  /// The face in which each triangle lies.
  const std::vector<int>& faces() const { return m_faces; }

  /// Where points on creases are in the faces around: of each point one place for each time that the boundary of a face
  /// passes it.
  const std::vector<Place>& crease_places() const { return m_crease_places; }
  /// All corners of triangles on creases, by increasing triangle and corner.
  const std::vector<Crease_corner>& crease_corners() const { return m_crease_corners; }

  /// Whether a face has an edge twice, in succession: a tip is where it turns around.
  static bool has_tip(const Arrays& t_mesh)
  {
    for (int h = 0; h < t_mesh.number_of_halfedges(); ++h)
      if (!t_mesh.is_border(h) && is_after_tip(t_mesh, h))
        return true;
    return false;
  }

private:
  static constexpr Index none = static_cast<Index>(-1);

  // A point of a strip: where it is along the side, from 0 to 1. On creases it has a place in this face.
  struct Strip_point {
    double x;
    Index index;
    Index crease_place = none;
  };

  // Whether the face of h has a tip where h begins.
  static bool is_after_tip(const Arrays& t_mesh, const int h) { return t_mesh.prev(h) == Arrays::opposite(h); }

  void find_tips()
  {
    m_is_tip.assign(m_places.size(), false);
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h)
      if (!m_t_mesh.is_border(h) && is_after_tip(m_t_mesh, h))
        m_is_tip[m_vertex[m_t_mesh.source(h)]] = true;
  }

  // None without creases.
  void find_points_on_creases()
  {
    if (!m_t_mesh.has_creases())
      return;
    m_is_on_crease.assign(m_places.size(), false);
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h)
      if (m_t_mesh.is_crease(h)) {
        m_is_on_crease[m_vertex[m_t_mesh.target(h)]] = true;
        const auto first = m_is_on_crease.begin() + static_cast<std::ptrdiff_t>(m_first[edge_of(h)]);
        std::fill(first, first + (number_of_parts(edge_of(h)) - 1), true);
      }
  }

  // Takes away the two triangles at each tip, which lie on each other.
  void remove_tips()
  {
    m_is_tip.resize(m_places.size(), false);
    Index kept = 0;
    auto corner = m_crease_corners.begin(), kept_corner = corner;
    for (Index i = 0; i < m_triangles.size(); ++i) {
      const std::array<Index, 3> t = m_triangles[i];
      const bool is_kept = !m_is_tip[t[0]] && !m_is_tip[t[1]] && !m_is_tip[t[2]];
      for (; corner != m_crease_corners.end() && corner->triangle == i; ++corner)
        if (is_kept)
          *kept_corner++ = {kept, corner->corner, corner->place};
      if (!is_kept)
        continue;
      m_triangles[kept] = t;
      m_faces[kept++] = m_faces[i];
    }
    m_triangles.resize(kept);
    m_faces.resize(kept);
    m_crease_corners.erase(kept_corner, m_crease_corners.end());
    std::vector<Index> number(m_places.size());
    Index next = 0;
    for (Index i = 0; i < m_places.size(); ++i) {
      number[i] = next;
      if (!m_is_tip[i])
        m_places[next++] = m_places[i];
    }
    m_places.resize(next);
    for (std::array<Index, 3>& triangle : m_triangles)
      for (Index& i : triangle)
        i = number[i];
  }

  // Sums of knots on opposite sides may differ by round-off.
  Place place_in(const int f, const FT& u, const FT& v) const
  {
    const auto clamped = [](const FT& x, const FT& size) { return x < FT(0) ? FT(0) : size < x ? size : x; };
    return {f, clamped(u, m_t_mesh.width(f)), clamped(v, m_t_mesh.height(f))};
  }

  Index add(const int f, const FT& u, const FT& v)
  {
    m_places.push_back(place_in(f, u, v));
    return m_places.size() - 1;
  }

  void add_vertices()
  {
    m_vertex.assign(m_t_mesh.number_of_vertices(), 0);
    for (int v = 0; v < m_t_mesh.number_of_vertices(); ++v)
      if (m_t_mesh.incoming(v) >= 0) {
        const int h = m_t_mesh.incoming(v);
        const auto p = m_t_mesh.target_point(h);
        m_vertex[v] = add(m_t_mesh.face(h), p.first, p.second);
      }
  }

  void add_edges()
  {
    for (int e = 0; e < m_t_mesh.number_of_edges(); ++e) {
      m_first.push_back(m_places.size());
      const int along = halfedge_of_edge(e);
      const bool is_border = m_t_mesh.is_border(along);
      const int h = is_border ? opposite(along) : along;
      for (int i = 1; i < number_of_parts(e); ++i) {
        const FT x = FT(is_border ? 1 - m_divisions.edges[e][i] : m_divisions.edges[e][i]);
        const auto p =
            m_t_mesh.point_of_side(m_t_mesh.face(h), m_t_mesh.side(h), FT(m_t_mesh.begin(h) + x * m_t_mesh.knot(h)));
        add(m_t_mesh.face(h), p.first, p.second);
      }
    }
  }

  int number_of_parts(const int e) const { return static_cast<int>(m_divisions.edges[e].size()) - 1; }

  // The points inside of a halfedge. \param begin, length where it is along its side, from 0 to 1
  void append(const int h, const double begin, const double length)
  {
    const int e = edge_of(h), n = number_of_parts(e);
    for (int i = 1; i < n; ++i) {
      const int j = is_along_edge(h) ? i : n - i;
      const double end = m_divisions.edges[e][j], x = is_along_edge(h) ? end : 1 - end;
      const Index index = m_first[e] + j - 1;
      m_outer.push_back({begin + length * x, index, add_crease_place(index, h, x)});
    }
  }

  // A place for a point in the face of halfedge h. \param x where it is along h, from 0 to 1
  // \return its number; `none` if the point is on no crease
  Index add_crease_place(const Index index, const int h, const double x)
  {
    if (m_is_on_crease.empty() || !m_is_on_crease[index])
      return none;
    const int f = m_t_mesh.face(h);
    const auto p = m_t_mesh.point_of_side(f, m_t_mesh.side(h), FT(m_t_mesh.begin(h) + FT(x) * m_t_mesh.knot(h)));
    m_crease_places.push_back(place_in(f, p.first, p.second));
    return m_crease_places.size() - 1;
  }
  Index add_crease_place_of_source(const int h) { return add_crease_place(m_vertex[m_t_mesh.source(h)], h, 0); }

  void add_face(const int f)
  {
    // Columns from left to right, rows from bottom to top.
    const Index first = m_places.size();
    const T_mesh_divisions::Ends &u = m_divisions.faces[f][0], &v = m_divisions.faces[f][1];
    const Index m = u.size() - 1, n = v.size() - 1;
    for (Index j = 1; j < n; ++j)
      for (Index i = 1; i < m; ++i)
        add(f, FT(m_t_mesh.width(f) * FT(u[i])), FT(m_t_mesh.height(f) * FT(v[j])));
    const auto inner = [&](const Index i, const Index j) { return first + (m - 1) * (j - 1) + (i - 1); };
    for (Index j = 1; j + 1 < n; ++j)
      for (Index i = 1; i + 1 < m; ++i) {
        m_triangles.push_back({inner(i, j), inner(i + 1, j), inner(i + 1, j + 1)});
        m_triangles.push_back({inner(i, j), inner(i + 1, j + 1), inner(i, j + 1)});
      }
    std::array<Index, 4> corners; // on creases
    for (int side = 0; side < 4; ++side)
      corners[side] = add_crease_place_of_source(m_t_mesh.first_of_side(f, side));
    for (int side = 0; side < 4; ++side) {
      m_inner.clear();
      const Index number = side % 2 == 0 ? m : n;
      for (Index k = 1; k < number; ++k)
        m_inner.push_back({side == 0   ? u[k]
                           : side == 1 ? v[k]
                           : side == 2 ? 1 - u[m - k]
                                       : 1 - v[n - k],
                           side == 0   ? inner(k, 1)
                           : side == 1 ? inner(m - 1, k)
                           : side == 2 ? inner(m - k, n - 1)
                                       : inner(1, n - k)});
      find_outer(f, side, corners[side], corners[(side + 1) % 4]);
      zip();
    }
  }

  // \param first_place, last_place crease places of its ends
  void find_outer(const int f, const int side, const Index first_place, const Index last_place)
  {
    m_outer.clear();
    const double size = CGAL::to_double(m_t_mesh.side_length(f, side));
    const int first = m_t_mesh.first_of_side(f, side);
    for (int h = first;; h = m_t_mesh.next(h)) {
      const double begin = CGAL::to_double(m_t_mesh.begin(h)) / size;
      m_outer.push_back(
          {begin, m_vertex[m_t_mesh.source(h)], h == first ? first_place : add_crease_place_of_source(h)});
      append(h, begin, CGAL::to_double(m_t_mesh.knot(h)) / size);
      if (m_t_mesh.is_corner(h)) {
        m_outer.push_back({1, m_vertex[m_t_mesh.target(h)], last_place});
        return;
      }
    }
  }

  // Triangulates the strip between the outer points, along the side, and the inner ones to their left. A tip gets one inner
  // point, and the outer point after it another one: triangles on both sides of the edge would have the same corners.
  void zip()
  {
    std::size_t o = 0, i = 0;
    const std::size_t last_o = m_outer.size() - 1, last_i = m_inner.size() - 1;
    bool has_left_tip = false; // in the last step
    while (o < last_o || i < last_i) {
      const auto is_outer_point_first = [&] {
        if (m_is_tip[m_outer[o].index])
          return true;
        const bool is_before_last_tip = o + 1 == last_o && m_is_tip[m_outer[last_o].index];
        return !has_left_tip && !is_before_last_tip &&
               m_outer[o].x + m_outer[o + 1].x <= m_inner[i].x + m_inner[i + 1].x;
      };
      if (i == last_i || (o < last_o && is_outer_point_first())) {
        add_triangle(m_outer[o], m_outer[o + 1], m_inner[i]);
        has_left_tip = m_is_tip[m_outer[o].index];
        ++o;
      }
      else {
        add_triangle(m_outer[o], m_inner[i + 1], m_inner[i]);
        has_left_tip = false;
        ++i;
      }
    }
  }

  void add_triangle(const Strip_point& a, const Strip_point& b, const Strip_point& c)
  {
    int corner = 0;
    for (const Index place : {a.crease_place, b.crease_place, c.crease_place}) {
      if (place != none)
        m_crease_corners.push_back({m_triangles.size(), corner, place});
      ++corner;
    }
    m_triangles.push_back({a.index, b.index, c.index});
  }

  std::size_t work(const int f) const { return m_divisions.faces[f][0].size() * m_divisions.faces[f][1].size(); }

  const Arrays& m_t_mesh;
  T_mesh_divisions m_divisions;
  std::vector<Place> m_places;
  std::vector<std::array<Index, 3>> m_triangles;
  std::vector<int> m_faces;             // per triangle
  std::vector<Index> m_vertex, m_first; // per vertex, per edge
  std::vector<Strip_point> m_outer, m_inner;
  std::vector<char> m_is_tip;       // per place
  std::vector<char> m_is_on_crease; // per place of vertices and edges; empty without creases
  std::vector<Place> m_crease_places;
  std::vector<Crease_corner> m_crease_corners;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_TESSELLATION_H
