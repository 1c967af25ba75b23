// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_TRIANGULATE_POLYGON_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_TRIANGULATE_POLYGON_SOUP_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The triangles of a soup, in the order of its polygons; those of one polygon follow each other.
struct Triangle_soup {
  std::vector<std::array<std::size_t, 3>> triangles; ///< point indices
  std::vector<std::array<std::size_t, 3>> corners;   ///< positions in `Polygon_soup::corners`
  std::vector<std::size_t> polygon_of_triangle;
};

/// Splits polygons into triangles such that the worst triangle is as good as possible.
///
/// This is the classical dynamic programme over sub-polygons; on a quadrilateral it chooses the better diagonal. A triangle is judged by
/// its height over its longest edge, relative to that edge, taken negative if it faces away from the polygon's mean normal. A diagonal that is an
/// edge elsewhere is never chosen as long as there is another choice: it would become a non-manifold edge.
class Polygon_triangulator {
public:
  /// Time grows with the cube of the number of corners.
  static constexpr std::size_t max_corners = 1000;

  explicit Polygon_triangulator(const Polygon_soup& soup) : m_soup(soup)
  {
    for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
      for (std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c)
        m_edges.insert(edge(soup.corners[c], soup.corners[soup.next_corner(f, c)]));
  }

  /// \pre The polygon has at most `max_corners` corners.
  void triangulate(const std::size_t polygon, Triangle_soup& result)
  {
    m_first = m_soup.first_corner[polygon];
    m_size = m_soup.size_of_polygon(polygon);
    compute_normal();
    m_quality.assign(m_size * m_size, 0);
    m_apex.assign(m_size * m_size, 0);
    for (std::size_t i = 0; i + 1 < m_size; ++i)
      m_quality[i * m_size + i + 1] = std::numeric_limits<double>::infinity();
    for (std::size_t length = 2; length < m_size; ++length)
      for (std::size_t i = 0; i + length < m_size; ++i)
        choose_apex(i, i + length);
    emit(polygon, result);
  }

private:
  using Edge = std::pair<std::size_t, std::size_t>;
  using Vector = std::array<double, 3>;

  static Edge edge(const std::size_t v, const std::size_t w) { return std::minmax(v, w); }

  std::size_t vertex(const std::size_t i) const { return m_soup.corners[m_first + i]; }

  Vector difference(const std::size_t i, const std::size_t j) const
  {
    const Vector& p = m_soup.points[vertex(i)];
    const Vector& q = m_soup.points[vertex(j)];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }

  static Vector cross(const Vector& a, const Vector& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  void compute_normal()
  {
    m_normal = {0, 0, 0};
    for (std::size_t i = 1; i + 1 < m_size; ++i) {
      const Vector n = cross(difference(0, i), difference(0, i + 1));
      for (std::size_t k = 0; k < 3; ++k)
        m_normal[k] += n[k];
    }
  }

  double triangle_quality(const std::size_t i, const std::size_t j, const std::size_t k) const
  {
    const Vector a = difference(i, j), b = difference(j, k), c = difference(k, i);
    const Vector n = cross(a, b);
    const double longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
    return longest > 0 ? std::copysign(std::sqrt(dot(n, n)) / longest, dot(n, m_normal)) : -1;
  }

  /// A diagonal that is an edge already: two, more than any difference of qualities.
  double penalty(const std::size_t i, const std::size_t j) const
  {
    const bool is_diagonal = j - i > 1 && j - i + 1 < m_size;
    return is_diagonal && m_edges.count(edge(vertex(i), vertex(j))) > 0 ? 3 : 0;
  }

  void choose_apex(const std::size_t i, const std::size_t k)
  {
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t j = i + 1; j < k; ++j) {
      const double quality =
          std::min({m_quality[i * m_size + j], m_quality[j * m_size + k], triangle_quality(i, j, k) - penalty(i, k)});
      if (quality > best || j == i + 1) {
        best = quality;
        m_apex[i * m_size + k] = j;
      }
    }
    m_quality[i * m_size + k] = best;
  }

  void emit(const std::size_t polygon, Triangle_soup& result)
  {
    std::vector<std::pair<std::size_t, std::size_t>> pending = {{0, m_size - 1}};
    while (!pending.empty()) {
      const auto [i, k] = pending.back();
      pending.pop_back();
      if (k - i < 2)
        continue;
      const std::size_t j = m_apex[i * m_size + k];
      result.triangles.push_back({vertex(i), vertex(j), vertex(k)});
      result.corners.push_back({m_first + i, m_first + j, m_first + k});
      result.polygon_of_triangle.push_back(polygon);
      m_edges.insert(edge(vertex(i), vertex(k)));
      pending.emplace_back(j, k);
      pending.emplace_back(i, j);
    }
  }

  const Polygon_soup& m_soup;
  std::unordered_set<Edge, boost::hash<Edge>> m_edges;
  std::size_t m_first = 0, m_size = 0;
  Vector m_normal = {0, 0, 0};
  std::vector<double> m_quality;
  std::vector<std::size_t> m_apex;
};

/// The triangles of a soup. \pre No polygon has less than 3 or more than `Polygon_triangulator::max_corners` corners.
inline Triangle_soup triangulate_polygon_soup(const Polygon_soup& soup)
{
  Triangle_soup result;
  result.triangles.reserve(soup.corners.size() - 2 * soup.number_of_polygons());
  result.corners.reserve(result.triangles.capacity());
  result.polygon_of_triangle.reserve(result.triangles.capacity());
  if (soup.corners.size() == 3 * soup.number_of_polygons()) {
    for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
      const std::size_t c = 3 * f;
      result.triangles.push_back({soup.corners[c], soup.corners[c + 1], soup.corners[c + 2]});
      result.corners.push_back({c, c + 1, c + 2});
      result.polygon_of_triangle.push_back(f);
    }
    return result;
  }
  Polygon_triangulator triangulator(soup);
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    triangulator.triangulate(f, result);
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_TRIANGULATE_POLYGON_SOUP_H
