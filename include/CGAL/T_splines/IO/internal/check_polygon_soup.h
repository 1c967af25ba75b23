// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_CHECK_POLYGON_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_CHECK_POLYGON_SOUP_H

#include <CGAL/T_splines/IO/internal/Polygon_soup.h>
#include <CGAL/T_splines/IO/internal/triangulate_polygon_soup.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Checks that the polygons of a soup form an oriented manifold, closed unless a boundary is admitted, and names the first
/// element of the file that is in the way. \pre All indices are in range.
class Polygon_soup_checker {
public:
  /// \param progress asked by `check()`; it must outlive this
  Polygon_soup_checker(const Polygon_soup& soup, const bool is_boundary_admitted, Progress& progress)
    : m_soup(soup),
      m_is_boundary_admitted(is_boundary_admitted),
      m_progress(progress)
  {
  }

  Mesh_reading_report check()
  {
    if (m_soup.number_of_polygons() == 0)
      return report_of(Mesh_reading_status::EMPTY);
    Mesh_reading_report report = check_polygons();
    const auto goes_on = [&] { return report.success() && m_progress.go_on(); };
    if (goes_on())
      report = check_duplicates();
    if (goes_on())
      report = check_edges();
    if (goes_on())
      report = check_vertices();
    return m_progress.go_on() ? report : report_of(Mesh_reading_status::INTERRUPTED);
  }

  /// The first edge with one polygon only that `check()` has met; a success if there is none.
  const Mesh_reading_report& boundary_report() const { return m_boundary_report; }

  /// The polygons alone: how many corners they have, and that these are different.
  Mesh_reading_report check_polygons() const
  {
    std::vector<std::size_t> last_polygon(m_soup.points.size(), none);
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f) {
      if (m_soup.size_of_polygon(f) < 3)
        return report_polygon(Mesh_reading_status::TOO_FEW_CORNERS, f);
      if (m_soup.size_of_polygon(f) > Polygon_triangulator::max_corners)
        return report_polygon(Mesh_reading_status::TOO_MANY_CORNERS, f);
      for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c) {
        std::size_t& last = last_polygon[m_soup.corners[c]];
        if (last == f)
          return report_polygon(Mesh_reading_status::REPEATED_VERTEX, f, m_soup.corners[c]);
        last = f;
      }
    }
    return Mesh_reading_report();
  }

private:
  static constexpr std::size_t none = Mesh_reading_report::none;

  /// A side of a polygon: from the corner to the next one.
  struct Side {
    std::size_t low, high, corner, polygon;
    bool is_forward; ///< from `low` to `high`
  };

  static Mesh_reading_report report_of(const Mesh_reading_status status)
  {
    Mesh_reading_report report;
    report.status = status;
    return report;
  }

  Mesh_reading_report report_polygon(const Mesh_reading_status status, const std::size_t f,
                                     const std::size_t v = none) const
  {
    Mesh_reading_report report = report_of(status);
    report.face = f;
    report.vertex = v;
    report.line = m_soup.line_of_polygon(f);
    return report;
  }

  Mesh_reading_report report_side(const Mesh_reading_status status, const Side& side,
                                  const std::size_t other_polygon = none) const
  {
    Mesh_reading_report report = report_polygon(status, side.polygon, side.is_forward ? side.low : side.high);
    report.other_vertex = side.is_forward ? side.high : side.low;
    report.other_face = other_polygon;
    return report;
  }

  /// Two polygons with the same vertices share their least vertex: they are compared there.
  Mesh_reading_report check_duplicates() const
  {
    const auto begin = m_soup.corners.begin();
    std::vector<std::vector<std::size_t>> polygons_of_least_vertex(m_soup.points.size());
    std::vector<std::size_t> a, b;
    const auto sorted_corners = [&](const std::size_t f, std::vector<std::size_t>& result) {
      result.assign(begin + m_soup.first_corner[f], begin + m_soup.first_corner[f + 1]);
      std::sort(result.begin(), result.end());
    };
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f) {
      if (!m_progress.go_on_after(5))
        return Mesh_reading_report();
      sorted_corners(f, a);
      for (const std::size_t other : polygons_of_least_vertex[a.front()]) {
        sorted_corners(other, b);
        if (a == b) {
          Mesh_reading_report report = report_polygon(Mesh_reading_status::DUPLICATE_FACE, f);
          report.other_face = other;
          return report;
        }
      }
      polygons_of_least_vertex[a.front()].push_back(f);
    }
    return Mesh_reading_report();
  }

  void collect_sides()
  {
    m_sides.reserve(m_soup.corners.size());
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
      for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c) {
        const std::size_t v = m_soup.corners[c], w = m_soup.corners[m_soup.next_corner(f, c)];
        m_sides.push_back({std::min(v, w), std::max(v, w), c, f, v < w});
      }
    std::sort(m_sides.begin(), m_sides.end(), [](const Side& a, const Side& b) {
      return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
    });
  }

  Mesh_reading_report check_edges()
  {
    collect_sides();
    m_opposite.assign(m_soup.corners.size(), none);
    const Side* boundary = nullptr;
    const Side* inconsistent = nullptr;
    for (std::size_t i = 0, end = 0; i < m_sides.size(); i = end) {
      const Side& side = m_sides[i];
      end = i + 1;
      while (end < m_sides.size() && m_sides[end].low == side.low && m_sides[end].high == side.high)
        ++end;
      if (end - i > 2)
        return report_side(Mesh_reading_status::NON_MANIFOLD_EDGE, side, m_sides[end - 1].polygon);
      if (end - i == 1 && boundary == nullptr)
        boundary = &side;
      if (end - i == 2) {
        m_opposite[side.corner] = m_sides[i + 1].corner;
        m_opposite[m_sides[i + 1].corner] = side.corner;
        if (side.is_forward == m_sides[i + 1].is_forward && inconsistent == nullptr)
          inconsistent = &side;
      }
    }
    if (inconsistent != nullptr)
      return report_orientation(*inconsistent);
    if (boundary != nullptr)
      m_boundary_report = report_side(Mesh_reading_status::BOUNDARY, *boundary);
    return m_is_boundary_admitted ? Mesh_reading_report() : m_boundary_report;
  }

  /// Whether some choice of orientations is consistent decides between the two messages.
  Mesh_reading_report report_orientation(const Side& inconsistent) const
  {
    std::vector<std::size_t> polygon_of_corner(m_soup.corners.size());
    std::vector<char> is_forward(m_soup.corners.size());
    for (const Side& side : m_sides) {
      polygon_of_corner[side.corner] = side.polygon;
      is_forward[side.corner] = side.is_forward;
    }
    std::vector<signed char> sign(m_soup.number_of_polygons(), 0);
    std::vector<std::size_t> pending;
    for (std::size_t seed = 0; seed < sign.size(); ++seed) {
      if (sign[seed] != 0)
        continue;
      sign[seed] = 1;
      pending.push_back(seed);
      while (!pending.empty()) {
        const std::size_t f = pending.back();
        pending.pop_back();
        for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c) {
          if (m_opposite[c] == none)
            continue;
          const std::size_t g = polygon_of_corner[m_opposite[c]];
          const signed char wanted = is_forward[c] != is_forward[m_opposite[c]] ? sign[f] : -sign[f];
          if (sign[g] == 0) {
            sign[g] = wanted;
            pending.push_back(g);
          }
          else if (sign[g] != wanted)
            return report_side(Mesh_reading_status::NON_ORIENTABLE, side_of(c, f), g);
        }
      }
    }
    return report_side(Mesh_reading_status::INCONSISTENT_ORIENTATION, inconsistent,
                       polygon_of_corner[m_opposite[inconsistent.corner]]);
  }

  Side side_of(const std::size_t c, const std::size_t f) const
  {
    const std::size_t v = m_soup.corners[c], w = m_soup.corners[m_soup.next_corner(f, c)];
    return {std::min(v, w), std::max(v, w), c, f, v < w};
  }

  /// Every vertex has exactly one fan: walk one fan per vertex and count the corners.
  Mesh_reading_report check_vertices() const
  {
    std::vector<std::size_t> next(m_soup.corners.size()), previous(m_soup.corners.size()),
        polygon(m_soup.corners.size());
    std::vector<std::size_t> number_of_corners(m_soup.points.size(), 0), some_corner(m_soup.points.size(), none);
    for (std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
      for (std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c) {
        next[c] = m_soup.next_corner(f, c);
        previous[next[c]] = c;
        polygon[c] = f;
        ++number_of_corners[m_soup.corners[c]];
        some_corner[m_soup.corners[c]] = c;
      }
    for (std::size_t v = 0; v < m_soup.points.size(); ++v) {
      if (some_corner[v] == none)
        return report_vertex(Mesh_reading_status::ISOLATED_VERTEX, v);
      std::size_t visited = 1, c = m_opposite[previous[some_corner[v]]]; // counter-clockwise
      for (; c != none && c != some_corner[v]; c = m_opposite[previous[c]])
        ++visited;
      if (c == none) // a boundary: the other way, too
        for (c = m_opposite[some_corner[v]]; c != none; c = m_opposite[next[c]])
          ++visited;
      if (visited != number_of_corners[v]) {
        Mesh_reading_report report = report_vertex(Mesh_reading_status::NON_MANIFOLD_VERTEX, v);
        report.face = polygon[some_corner[v]];
        return report;
      }
    }
    return Mesh_reading_report();
  }

  Mesh_reading_report report_vertex(const Mesh_reading_status status, const std::size_t v) const
  {
    Mesh_reading_report report = report_of(status);
    report.vertex = v;
    report.line = m_soup.line_of_point(v);
    return report;
  }

  const Polygon_soup& m_soup;
  const bool m_is_boundary_admitted;
  Progress& m_progress;
  Mesh_reading_report m_boundary_report;
  std::vector<Side> m_sides;
  std::vector<std::size_t> m_opposite; ///< per corner: the corner at which the opposite side begins
};

/// Checks that no edge has length zero and that no triangle has area zero, exactly.
inline Mesh_reading_report check_triangle_geometry(const Polygon_soup& soup, const Triangle_soup& triangles,
                                                   Progress& progress)
{
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto point = [&soup](const std::size_t v) {
    return Point_3(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
  };
  for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
    const std::array<std::size_t, 3>& triangle = triangles.triangles[t];
    Mesh_reading_report report;
    if (!progress.go_on_after(3)) {
      report.status = Mesh_reading_status::INTERRUPTED;
      return report;
    }
    report.face = triangles.polygon_of_triangle[t];
    report.line = soup.line_of_polygon(report.face);
    for (std::size_t i = 0; i < 3; ++i)
      if (soup.points[triangle[i]] == soup.points[triangle[(i + 1) % 3]]) {
        report.status = Mesh_reading_status::ZERO_LENGTH_EDGE;
        report.vertex = triangle[i];
        report.other_vertex = triangle[(i + 1) % 3];
        return report;
      }
    if (CGAL::collinear(point(triangle[0]), point(triangle[1]), point(triangle[2]))) {
      report.status = Mesh_reading_status::ZERO_AREA_TRIANGLE;
      return report;
    }
  }
  return Mesh_reading_report();
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_CHECK_POLYGON_SOUP_H
