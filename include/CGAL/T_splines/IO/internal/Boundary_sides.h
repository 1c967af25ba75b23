// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_BOUNDARY_SIDES_H
#define CGAL_T_SPLINES_IO_INTERNAL_BOUNDARY_SIDES_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A side of a polygon, from the point `source` to the point `target`.
struct Polygon_side {
  std::size_t polygon, source, target;

  std::size_t low() const { return std::min(source, target); }
  std::size_t high() const { return std::max(source, target); }
};

/// Hands the sides of each edge, one edge after the other, to `visit(first, last)`. Sides whose ends are the same point
/// are left out.
template <typename Visit>
void for_each_edge(const Polygon_soup& soup, const Visit& visit)
{
  std::vector<Polygon_side> sides;
  sides.reserve(soup.corners.size());
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    for (std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c) {
      const Polygon_side side = {f, soup.corners[c], soup.corners[soup.next_corner(f, c)]};
      if (side.source != side.target)
        sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(), [](const Polygon_side& a, const Polygon_side& b) {
    return std::make_tuple(a.low(), a.high(), a.polygon) < std::make_tuple(b.low(), b.high(), b.polygon);
  });
  const Polygon_side* const end = sides.data() + sides.size();
  for (const Polygon_side* first = sides.data(); first != end;) {
    const Polygon_side* last = first;
    while (last != end && last->low() == first->low() && last->high() == first->high())
      ++last;
    visit(first, last);
    first = last;
  }
}

/// The sides that no other polygon has, in any direction.
inline std::vector<Polygon_side> boundary_sides(const Polygon_soup& soup)
{
  std::vector<Polygon_side> boundary;
  for_each_edge(soup, [&boundary](const Polygon_side* first, const Polygon_side* last) {
    if (last - first == 1)
      boundary.push_back(*first);
  });
  return boundary;
}

/// The directions at sides by which it is told which polygons follow each other around an edge.
class Side_directions {
public:
  explicit Side_directions(const Polygon_soup& soup) : m_soup(soup)
  {
    double volume = 0;
    for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
      volume += dot(difference(soup.corner(0, 0), soup.corner(f, 0)), normal(f));
    m_is_inside_out = volume < 0;
  }

  /// The angle, inside of the body, from the polygon of one side to that of another one which runs the other way.
  double angle_inside(const Polygon_side& a, const Polygon_side& b) const
  {
    const Vector n = normal(a.polygon), into_a = cross(n, difference(a.source, a.target));
    const Vector into_b = cross(normal(b.polygon), difference(b.source, b.target));
    const double length = std::sqrt(dot(difference(a.source, a.target), difference(a.source, a.target)));
    const double height = dot(into_b, n) * length * (m_is_inside_out ? 1 : -1);
    const double angle = std::atan2(height, dot(into_b, into_a)), full_turn = 8 * std::atan(1.);
    return angle < round_off ? angle + full_turn : angle; // the back of the same polygon comes last
  }

private:
  using Vector = std::array<double, 3>;

  static constexpr double round_off = 1e-6; // of an angle in radians, as of coordinates with six digits

  static Vector cross(const Vector& a, const Vector& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  Vector difference(const std::size_t v, const std::size_t w) const
  {
    const Vector &p = m_soup.points[v], &q = m_soup.points[w];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }

  /// As long as the area of the polygon, times two.
  Vector normal(const std::size_t f) const
  {
    Vector sum = {0, 0, 0};
    for (std::size_t i = 1; i + 1 < m_soup.size_of_polygon(f); ++i) {
      const Vector n = cross(difference(m_soup.corner(f, 0), m_soup.corner(f, i)),
                             difference(m_soup.corner(f, 0), m_soup.corner(f, i + 1)));
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += n[k];
    }
    return sum;
  }

  const Polygon_soup& m_soup;
  bool m_is_inside_out;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_BOUNDARY_SIDES_H
