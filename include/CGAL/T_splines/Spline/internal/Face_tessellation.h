// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_TESSELLATION_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_TESSELLATION_H

#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/Progress.h>

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
/// Each edge is divided evenly, so often that every side of a face has at least as many parts as the face asks for: m in
/// the direction of u, n in that of v. Inside, a face has (m - 1) x (n - 1) points, and between them and the sides strips
/// that are zipped together.
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

  /// Into how many parts the sides of a face are divided, at least: those along u, and those along v.
  using Divisions = std::array<int, 2>;

  /// \param divisions of each face, at least 2
  /// \param progress if it is interrupted, triangles are missing
  Face_tessellation(const Arrays& t_mesh, std::vector<Divisions> divisions, Progress& progress)
    : m_t_mesh(t_mesh),
      m_divisions(std::move(divisions))
  {
    if (has_tip())
      for (Divisions& n : m_divisions)
        n = {(std::max)(n[0], 3), (std::max)(n[1], 3)};
    add_vertices();
    add_edges();
    for (int f = 0; f < t_mesh.number_of_faces() && progress.go_on_after(work(f)); ++f) {
      add_face(f);
      m_faces.resize(m_triangles.size(), f);
    }
    if (has_tip())
      remove_tips();
  }

  const std::vector<Place>& places() const { return m_places; }
  const std::vector<std::array<Index, 3>>& triangles() const { return m_triangles; }

  /// The face in which each triangle lies.
  const std::vector<int>& faces() const { return m_faces; }

private:
  // A point of a strip: where it is along the side, in parts of the side.
  struct Strip_point {
    double x;
    Index index;
  };

  // Whether the face of h has a tip where h begins.
  bool is_after_tip(const int h) const { return m_t_mesh.prev(h) == Arrays::opposite(h); }

  bool has_tip() const
  {
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h)
      if (!m_t_mesh.is_border(h) && is_after_tip(h))
        return true;
    return false;
  }

  void remove_tips()
  {
    std::vector<char> is_tip(m_places.size(), false);
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h)
      if (!m_t_mesh.is_border(h) && is_after_tip(h))
        is_tip[m_vertex[m_t_mesh.source(h)]] = true;
    Index kept = 0;
    for (Index i = 0; i < m_triangles.size(); ++i) {
      const std::array<Index, 3> t = m_triangles[i];
      if (is_tip[t[0]] || is_tip[t[1]] || is_tip[t[2]])
        continue;
      m_triangles[kept] = t;
      m_faces[kept++] = m_faces[i];
    }
    m_triangles.resize(kept);
    m_faces.resize(kept);
    std::vector<Index> number(m_places.size());
    Index next = 0;
    for (Index i = 0; i < m_places.size(); ++i) {
      number[i] = next;
      if (!is_tip[i])
        m_places[next++] = m_places[i];
    }
    m_places.resize(next);
    for (std::array<Index, 3>& triangle : m_triangles)
      for (Index& i : triangle)
        i = number[i];
  }

  // Sums of knots on opposite sides may differ by round-off.
  Index add(const int f, const FT& u, const FT& v)
  {
    const auto clamped = [](const FT& x, const FT& size) { return x < FT(0) ? FT(0) : size < x ? size : x; };
    m_places.push_back({f, clamped(u, m_t_mesh.width(f)), clamped(v, m_t_mesh.height(f))});
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
    const int number_of_edges = m_t_mesh.number_of_halfedges() / 2;
    m_parts.resize(number_of_edges);
    m_first.resize(number_of_edges);
    for (int e = 0; e < number_of_edges; ++e) {
      for (const int h : {2 * e, 2 * e + 1})
        if (!m_t_mesh.is_border(h)) {
          const FT side = m_t_mesh.side_length(m_t_mesh.face(h), m_t_mesh.side(h));
          const double parts =
              divisions_of_side(m_t_mesh.face(h), m_t_mesh.side(h)) * CGAL::to_double(FT(m_t_mesh.knot(h) / side));
          m_parts[e] = (std::max)(m_parts[e], static_cast<int>(std::ceil(parts - 1e-6)));
        }
      m_parts[e] = (std::max)(m_parts[e], 1);
      m_first[e] = m_places.size();
      const int h = m_t_mesh.is_border(2 * e) ? 2 * e + 1 : 2 * e;
      for (int i = 1; i < m_parts[e]; ++i) {
        // In the order of the halfedge 2e.
        const FT part = FT(h == 2 * e ? i : m_parts[e] - i) / FT(m_parts[e]);
        const auto p =
            m_t_mesh.point_of_side(m_t_mesh.face(h), m_t_mesh.side(h), FT(m_t_mesh.begin(h) + part * m_t_mesh.knot(h)));
        add(m_t_mesh.face(h), p.first, p.second);
      }
    }
  }

  // The points of a halfedge but for its target.
  void append(const int h, std::vector<Index>& points) const
  {
    const int e = h / 2;
    points.push_back(m_vertex[m_t_mesh.source(h)]);
    for (int i = 1; i < m_parts[e]; ++i)
      points.push_back(m_first[e] + (h % 2 == 0 ? i - 1 : m_parts[e] - i - 1));
  }

  void add_face(const int f)
  {
    // Columns from left to right, rows from bottom to top.
    const Index first = m_places.size();
    const int m = m_divisions[f][0], n = m_divisions[f][1];
    for (int j = 1; j < n; ++j)
      for (int i = 1; i < m; ++i)
        add(f, FT(m_t_mesh.width(f) * FT(i) / FT(m)), FT(m_t_mesh.height(f) * FT(j) / FT(n)));
    const auto inner = [&](const int i, const int j) { return first + (m - 1) * (j - 1) + (i - 1); };
    for (int j = 1; j + 1 < n; ++j)
      for (int i = 1; i + 1 < m; ++i) {
        m_triangles.push_back({inner(i, j), inner(i + 1, j), inner(i + 1, j + 1)});
        m_triangles.push_back({inner(i, j), inner(i + 1, j + 1), inner(i, j + 1)});
      }
    for (int side = 0; side < 4; ++side) {
      m_inner.clear();
      for (int k = 1; k < divisions_of_side(f, side); ++k)
        m_inner.push_back({static_cast<double>(k), side == 0   ? inner(k, 1)
                                                   : side == 1 ? inner(m - 1, k)
                                                   : side == 2 ? inner(m - k, n - 1)
                                                               : inner(1, n - k)});
      find_outer(f, side);
      zip();
    }
  }

  void find_outer(const int f, const int side)
  {
    m_outer.clear();
    const double size = CGAL::to_double(m_t_mesh.side_length(f, side)), parts = divisions_of_side(f, side);
    for (int h = m_t_mesh.first_of_side(f, side);; h = m_t_mesh.next(h)) {
      m_points.clear();
      append(h, m_points);
      const double begin = CGAL::to_double(m_t_mesh.begin(h)), knot = CGAL::to_double(m_t_mesh.knot(h));
      for (std::size_t i = 0; i < m_points.size(); ++i)
        m_outer.push_back(
            {parts * (begin + knot * static_cast<double>(i) / static_cast<double>(m_points.size())) / size,
             m_points[i]});
      if (m_t_mesh.is_corner(h)) {
        m_outer.push_back({parts, m_vertex[m_t_mesh.target(h)]});
        return;
      }
    }
  }

  // Triangulates the strip between the outer points, along the side, and the inner ones to their left.
  void zip()
  {
    std::size_t o = 0, i = 0;
    while (o + 1 < m_outer.size() || i + 1 < m_inner.size()) {
      const bool is_outer_step =
          i + 1 == m_inner.size() ||
          (o + 1 < m_outer.size() && m_outer[o].x + m_outer[o + 1].x <= m_inner[i].x + m_inner[i + 1].x);
      if (is_outer_step) {
        m_triangles.push_back({m_outer[o].index, m_outer[o + 1].index, m_inner[i].index});
        ++o;
      }
      else {
        m_triangles.push_back({m_outer[o].index, m_inner[i + 1].index, m_inner[i].index});
        ++i;
      }
    }
  }

  std::size_t work(const int f) const
  {
    return static_cast<std::size_t>(m_divisions[f][0]) * static_cast<std::size_t>(m_divisions[f][1]);
  }
  int divisions_of_side(const int f, const int side) const { return m_divisions[f][side % 2]; }

  const Arrays& m_t_mesh;
  std::vector<Divisions> m_divisions; // per face
  std::vector<Place> m_places;
  std::vector<std::array<Index, 3>> m_triangles;
  std::vector<int> m_faces;             // per triangle
  std::vector<Index> m_vertex, m_first; // per vertex, per edge
  std::vector<int> m_parts;             // per edge
  std::vector<Strip_point> m_outer, m_inner;
  std::vector<Index> m_points;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FACE_TESSELLATION_H
