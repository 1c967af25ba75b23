// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONVEX_CELL_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONVEX_CELL_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A cell of the common subdivision: convex in its input face and in the plane of the map, possibly with straight
/// corners.
class Convex_cell {
public:
  struct Corner {
    int node = 0;
    std::array<double, 3> point{};
    std::array<double, 2> uv{};
    int input_halfedge = -1, final_halfedge = -1; ///< of the side from this corner to the next one
  };

  void clear() { m_corners.clear(); }
  void add(const Corner& corner) { m_corners.push_back(corner); }

  /// gives the input face, whose normal orients the cell.
  void set_plane(const std::array<double, 3>& p, const std::array<double, 3>& q, const std::array<double, 3>& r)
  {
    m_normal = cross(p, q, r);
  }

  /// calls `visit(p, q, r)` for the triangles of a triangulation without new vertices. Diagonals have the halfedges -1.
  ///
  /// The ears with the best shape in both geometries are cut first: straight corners are left to the base of other
  /// ears.
  template <typename Visitor>
  void triangulate(Visitor&& visit)
  {
    while (m_corners.size() > 3) {
      const std::size_t n = m_corners.size();
      std::size_t best = 0;
      double best_shape = -2;
      for (std::size_t i = 0; i < n; ++i) {
        const double shape = ear_shape(i);
        if (shape > best_shape) {
          best_shape = shape;
          best = i;
        }
      }
      Corner p = m_corners[(best + n - 1) % n];
      const Corner q = m_corners[best];
      Corner r = m_corners[(best + 1) % n];
      r.input_halfedge = r.final_halfedge = -1;
      visit(p, q, r);
      m_corners[(best + n - 1) % n].input_halfedge = -1;
      m_corners[(best + n - 1) % n].final_halfedge = -1;
      m_corners.erase(m_corners.begin() + static_cast<std::ptrdiff_t>(best));
    }
    visit(m_corners[0], m_corners[1], m_corners[2]);
  }

private:
  static std::array<double, 3> cross(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                     const std::array<double, 3>& r)
  {
    const double a0 = q[0] - p[0], a1 = q[1] - p[1], a2 = q[2] - p[2];
    const double b0 = r[0] - p[0], b1 = r[1] - p[1], b2 = r[2] - p[2];
    return {{a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0}};
  }

  template <std::size_t N>
  static double longest_square(const std::array<double, N>& p, const std::array<double, N>& q,
                               const std::array<double, N>& r)
  {
    double pq = 0, qr = 0, rp = 0;
    for (std::size_t k = 0; k < N; ++k) {
      pq += (q[k] - p[k]) * (q[k] - p[k]);
      qr += (r[k] - q[k]) * (r[k] - q[k]);
      rp += (p[k] - r[k]) * (p[k] - r[k]);
    }
    return std::max(pq, std::max(qr, rp));
  }

  // Twice the signed area by the square of the longest side, the smaller of both geometries; of what is left over
  // without the ear, if that is a triangle, too.
  double ear_shape(const std::size_t i) const
  {
    const std::size_t n = m_corners.size();
    double result = shape(m_corners[(i + n - 1) % n], m_corners[i], m_corners[(i + 1) % n]);
    if (n == 4)
      result = std::min(result, shape(m_corners[(i + 3) % n], m_corners[(i + 1) % n], m_corners[(i + 2) % n]));
    return result;
  }

  double shape(const Corner& p, const Corner& q, const Corner& r) const
  {
    const std::array<double, 3> normal = cross(p.point, q.point, r.point);
    const double length = std::sqrt(m_normal[0] * m_normal[0] + m_normal[1] * m_normal[1] + m_normal[2] * m_normal[2]);
    const double area = (normal[0] * m_normal[0] + normal[1] * m_normal[1] + normal[2] * m_normal[2]) / length;
    const double uv_area = (q.uv[0] - p.uv[0]) * (r.uv[1] - p.uv[1]) - (q.uv[1] - p.uv[1]) * (r.uv[0] - p.uv[0]);
    const double scale = longest_square(p.point, q.point, r.point), uv_scale = longest_square(p.uv, q.uv, r.uv);
    return scale > 0 && uv_scale > 0 ? std::min(area / scale, uv_area / uv_scale) : -1;
  }

  std::vector<Corner> m_corners;
  std::array<double, 3> m_normal{};
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONVEX_CELL_H
