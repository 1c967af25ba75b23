// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_CREASED_TRIANGLES_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_CREASED_TRIANGLES_H

#include <CGAL/T_splines/Spline/internal/Triangle_stars.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/triangle_meets_rectangle.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The triangles of a carried surface, cut along the creases of the T-mesh on it: so the surface has a border on both
/// sides of each crease, as the spline has. Triangles keep their numbers; points do, but for the copies, which come last.
/// \tparam Graph the T-mesh's graph
template <typename Graph>
class Creased_triangles {
  using Carried = Carried_surface<Graph>;
  using Image = typename Carried::Image;

public:
  using Point_3 = typename Carried::Point_3;
  using Triangle = typename Carried::Triangle;

  /// \tparam TMesh a `T_mesh_view`
  template <typename TMesh>
  Creased_triangles(const TMesh& t_mesh, const Carried& surface)
    : m_points(surface.points()),
      m_triangles(surface.triangles())
  {
    const Mesh_indexing<Graph> indexing(t_mesh.graph());
    const T_mesh_arrays<double> arrays(indexing, t_mesh);
    if (!arrays.has_creases())
      return;
    find_walls(arrays, indexing, surface);
    divide_points();
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  // Sides of triangles along creases.
  void find_walls(const T_mesh_arrays<double>& t_mesh, const Mesh_indexing<Graph>& indexing, const Carried& surface)
  {
    m_is_wall.assign(m_triangles.size(), {});
    for (int h = 0; h < t_mesh.number_of_halfedges(); ++h)
      if (!t_mesh.is_border(h) && t_mesh.is_crease(h))
        for (const Image& image : surface.images(indexing.face(t_mesh.face(h))))
          for (std::size_t i = 0; i < 3; ++i)
            if (lies_on(image, i, h, t_mesh))
              m_is_wall[image.triangle][i] = true;
  }

  // Whether the side of a triangle, in the face of h, lies along h.
  static bool lies_on(const Image& image, const std::size_t i, const int h, const T_mesh_arrays<double>& t_mesh)
  {
    const int f = t_mesh.face(h), side = t_mesh.side(h), along = side % 2, across = 1 - along;
    const double length = t_mesh.side_length(f, side), depth = t_mesh.side_length(f, side + 1);
    const double line = side == 1 || side == 2 ? depth : 0;
    const auto& p = image.corners[i];
    const auto& q = image.corners[(i + 1) % 3];
    if (std::abs(p[across] - line) > same_point * depth || std::abs(q[across] - line) > same_point * depth)
      return false;
    const auto distance = [&](const double x) { return side < 2 ? x : length - x; };
    const double begin = (std::max)(distance(p[along]), t_mesh.begin(h)),
                 end = (std::min)(distance(q[along]), t_mesh.end(h));
    return end - begin > same_point * length &&
           triangle_covers_part_of_rectangle(image.corners, {t_mesh.width(f), t_mesh.height(f)}, same_point);
  }

  // Gives each fan of triangles between walls a point of its own.
  void divide_points()
  {
    const Triangle_stars stars(m_points.size(), m_triangles);
    std::vector<char> is_on_wall(m_points.size(), 0);
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        if (m_is_wall[t][i])
          is_on_wall[m_triangles[t][i]] = is_on_wall[m_triangles[t][(i + 1) % 3]] = 1;
    const std::vector<Triangle> uncut = m_triangles;
    for (std::size_t p = 0; p < is_on_wall.size(); ++p)
      if (is_on_wall[p] != 0)
        divide_point(p, uncut, stars);
  }

  void divide_point(const std::size_t p, const std::vector<Triangle>& uncut, const Triangle_stars& stars)
  {
    std::vector<std::size_t> rest, fan;
    stars.for_each_around(p, [&](const std::size_t t) { rest.push_back(t); });
    for (bool is_first = true; !rest.empty(); is_first = false) {
      fan.assign(1, rest.back());
      rest.pop_back();
      for (std::size_t i = 0; i < fan.size(); ++i)
        for (std::size_t k = rest.size(); k-- > 0;)
          if (are_joined(fan[i], rest[k], p, uncut)) {
            fan.push_back(rest[k]);
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
          }
      if (is_first)
        continue;
      for (const std::size_t t : fan)
        *std::find(m_triangles[t].begin(), m_triangles[t].end(), p) = m_points.size();
      m_points.push_back(m_points[p]);
    }
  }

  // Whether two triangles have an edge at p in common that is no wall.
  bool are_joined(const std::size_t t, const std::size_t other, const std::size_t p,
                  const std::vector<Triangle>& uncut) const
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t a = uncut[t][i], b = uncut[t][(i + 1) % 3];
        if (a == uncut[other][(j + 1) % 3] && b == uncut[other][j] && (a == p || b == p))
          return !m_is_wall[t][i] && !m_is_wall[other][j];
      }
    return false;
  }

  std::vector<Point_3> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<std::array<bool, 3>> m_is_wall; // per triangle: from corner i on
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_CREASED_TRIANGLES_H
