// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_UV_SEAMS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_UV_SEAMS_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

using Uv_array = std::vector<std::array<double, 2>>;

inline double distance(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

inline double squared_distance(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  const double u = a[0] - b[0], v = a[1] - b[1];
  return u * u + v * v;
}

inline double largest_coordinate(const std::array<double, 2>& a)
{
  return std::max(std::abs(a[0]), std::abs(a[1]));
}

/// The angle in the plane of the corner at the target of `h`, in radians.
inline double uv_angle(const Triangulation_connectivity& mesh, const Uv_array& uv,
                       const Triangulation_connectivity::Index h)
{
  const std::array<double, 2>&p = uv[h], &q = uv[mesh.next(h)], &r = uv[mesh.previous(h)];
  const double a = q[0] - p[0], b = q[1] - p[1], c = r[0] - p[0], d = r[1] - p[1];
  return std::atan2(a * d - b * c, a * c + b * d);
}

/// The seams of a map: the inner edges whose two faces give different coordinates to one of their ends.
///
/// Where the coordinates differ by no more than a tolerance, in files in which each face has its own rounded
/// coordinates, an edge is welded: all corners of a sector between two seams get one value.
class Uv_seams {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param uv per halfedge the corner at its target; welded
  /// \param tolerance by the largest coordinate
  Uv_seams(const Triangulation_connectivity& mesh, Uv_array& uv, const double tolerance)
    : m_mesh(mesh),
      m_is_cut(mesh.number_of_edges(), 0)
  {
    std::vector<Index> welded;
    for (Index e = 0; e < mesh.number_of_edges(); ++e) {
      const auto [h, g] = halfedges_of_edge(e);
      if (mesh.face(h) == mesh.null || mesh.face(g) == mesh.null)
        continue;
      if (uv[h] == uv[mesh.previous(g)] && uv[g] == uv[mesh.previous(h)])
        continue;
      m_is_cut[e] = 1;
      if (is_nearly_identity(uv, h, tolerance))
        welded.push_back(e);
    }
    if (!welded.empty()) {
      open_up(uv, welded);
      weld(welded, uv);
    }
  }

  /// Per edge, 0 or 1.
  const std::vector<char>& cut_edges() const { return m_is_cut; }

private:
  bool is_cut(const Index edge) const { return m_is_cut[edge] == 1; }

  bool is_nearly_identity(const Uv_array& uv, const Index h, const double tolerance) const
  {
    const Index g = opposite(h), before = m_mesh.previous(h), behind = m_mesh.previous(g);
    double size = 0;
    for (const Index corner : {h, g, before, behind})
      size = std::max(size, largest_coordinate(uv[corner]));
    const double length = std::min(distance(uv[h], uv[before]), distance(uv[g], uv[behind]));
    const double allowed = std::min(tolerance * size, length * largest_rounding);
    return distance(uv[h], uv[behind]) <= allowed && distance(uv[g], uv[before]) <= allowed;
  }

  // Where a seam passes near the fixed point of its transition, its edges look as if they were to be welded. The rest
  // of the seam would end at a vertex that is no cone: edges at such vertices are cut again.
  void open_up(const Uv_array& uv, std::vector<Index>& welded)
  {
    std::vector<int> degree(m_mesh.number_of_vertices(), 0);
    for (const Index e : welded)
      m_is_cut[e] = 2;
    std::vector<Index> ends;
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_is_cut[edge_of(h)] == 1)
        ++degree[m_mesh.target(h)];
    const std::vector<Index> outgoing = m_mesh.outgoing_halfedges();
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (degree[v] == 1)
        ends.push_back(v);
    while (!ends.empty()) {
      const Index v = ends.back();
      ends.pop_back();
      if (degree[v] != 1 || !is_flat(uv, outgoing[v]))
        continue;
      for_each_outgoing(outgoing[v], [&](const Index h) {
        if (m_is_cut[edge_of(h)] != 2)
          return;
        m_is_cut[edge_of(h)] = 1;
        ++degree[v];
        if (++degree[m_mesh.target(h)] == 1)
          ends.push_back(m_mesh.target(h));
      });
    }
    welded.erase(std::remove_if(welded.begin(), welded.end(), [this](const Index e) { return m_is_cut[e] == 1; }),
                 welded.end());
  }

  // Whether the source of `out` is no border vertex and has an angle near a multiple of a full turn.
  bool is_flat(const Uv_array& uv, const Index out) const
  {
    double angle = 0;
    bool is_inner = true;
    for_each_outgoing(out, [&](const Index h) {
      if (m_mesh.face(opposite(h)) == m_mesh.null)
        is_inner = false;
      else
        angle += uv_angle(m_mesh, uv, opposite(h));
    });
    // Angles around vertices are multiples of a quarter turn: any number below 1 / 8 would do.
    constexpr double clearly_less_than_quarter = 0.1;
    const double turns = angle / (8 * std::atan(1.));
    return is_inner && std::abs(turns - std::round(turns)) < clearly_less_than_quarter;
  }

  void weld(const std::vector<Index>& welded, Uv_array& uv)
  {
    for (const Index e : welded)
      m_is_cut[e] = 0;
    std::vector<char> is_done(m_mesh.number_of_halfedges(), 0);
    for (const Index e : welded)
      for (const Index corner : halfedges_of_edge(e))
        if (!is_done[corner])
          weld_sector(corner, uv, is_done);
  }

  // Gives all corners at the target of `corner` up to the next seams the coordinates of the first of them.
  void weld_sector(const Index corner, Uv_array& uv, std::vector<char>& is_done) const
  {
    Index first = corner; // clockwise
    while (!is_cut(edge_of(first)) && m_mesh.face(opposite(first)) != m_mesh.null) {
      first = m_mesh.previous(opposite(first));
      if (first == corner)
        break;
    }
    const std::array<double, 2> value = uv[first];
    for (Index h = first; true;) {
      uv[h] = value;
      is_done[h] = 1;
      const Index out = m_mesh.next(h);
      if (is_cut(edge_of(out)) || m_mesh.face(opposite(out)) == m_mesh.null)
        break;
      h = opposite(out);
      if (h == first)
        break;
    }
  }

  template <typename Visit>
  void for_each_outgoing(const Index first, const Visit& visit) const
  {
    Index h = first; // on the border, `next` follows it: the halfedge before it around the vertex
    do {
      visit(h);
      h = m_mesh.next(opposite(h));
    } while (h != first);
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<char> m_is_cut; // per edge
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_UV_SEAMS_H
