// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_CHECK_T_MESH_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_CHECK_T_MESH_SOUP_H

#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

inline T_mesh_reading_report report_of_vertex(const T_mesh_soup& soup, const T_mesh_reading_status status,
                                              const std::size_t v)
{
  T_mesh_reading_report report;
  report.status = status;
  report.vertex = v;
  report.line = soup.point_lines[v];
  return report;
}

inline T_mesh_reading_report report_of_face(const T_mesh_soup& soup, const T_mesh_reading_status status,
                                            const std::size_t f)
{
  T_mesh_reading_report report;
  report.status = status;
  report.face = f;
  report.line = soup.face_lines[f];
  return report;
}

inline T_mesh_reading_report report_of_halfedge(const T_mesh_soup& soup, const T_mesh_links& links,
                                                const T_mesh_reading_status status, const std::size_t h,
                                                const std::string& detail)
{
  T_mesh_reading_report report = report_of_face(soup, status, links.face(h));
  report.index = links.index_in_face(h);
  report.detail = detail;
  return report;
}

/// Whether `opposite` is an involution without fixed points on the inner halfedges, and its ends match.
inline T_mesh_reading_report check_opposites(const T_mesh_soup& soup, const T_mesh_links& links)
{
  using Status = T_mesh_reading_status;
  const auto number = [](const std::size_t i) { return i == T_mesh_soup::border ? "-1" : std::to_string(i); };
  for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h)
    if (soup.opposites[h] != T_mesh_soup::border && soup.opposites[h] >= soup.number_of_halfedges())
      return report_of_halfedge(soup, links, Status::INDEX_OUT_OF_RANGE, h,
                                "opposite is " + number(soup.opposites[h]) + ", and there are " +
                                    number(soup.number_of_halfedges()) + " halfedges");
  for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h) {
    const std::size_t g = soup.opposites[h];
    if (g == T_mesh_soup::border)
      continue;
    if (g == h || soup.opposites[g] != h)
      return report_of_halfedge(soup, links, Status::OPPOSITE_NOT_MUTUAL, h,
                                "halfedge " + number(h) + " has the opposite " + number(g) + ", and that has " +
                                    number(soup.opposites[g]));
    if (links.source(h) != links.target(g) || links.target(h) != links.source(g))
      return report_of_halfedge(soup, links, Status::OPPOSITE_ENDS_DIFFER, h,
                                "halfedge " + number(h) + " runs from vertex " + number(links.source(h)) + " to " +
                                    number(links.target(h)) + ", its opposite " + number(g) + " from " +
                                    number(links.source(g)) + " to " + number(links.target(g)));
  }
  return T_mesh_reading_report();
}

/// Whether the halfedges that leave each vertex form one fan. \pre `check_opposites()` found nothing.
inline T_mesh_reading_report check_fans(const T_mesh_soup& soup, const T_mesh_links& links)
{
  constexpr std::size_t none = T_mesh_soup::border;
  std::vector<char> is_visited(soup.number_of_halfedges(), 0), has_fan(soup.number_of_vertices(), 0);
  for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h) {
    if (is_visited[h])
      continue;
    if (has_fan[links.source(h)])
      return report_of_vertex(soup, T_mesh_reading_status::NON_MANIFOLD_VERTEX, links.source(h));
    has_fan[links.source(h)] = 1;
    std::size_t g = h;
    for (; g != none && !is_visited[g]; g = links.counter_clockwise(g))
      is_visited[g] = 1;
    if (g == none) // a fan that ends at the border
      for (g = links.clockwise(h); g != none; g = links.clockwise(g))
        is_visited[g] = 1;
  }
  for (std::size_t v = 0; v < soup.number_of_vertices(); ++v)
    if (!has_fan[v])
      return report_of_vertex(soup, T_mesh_reading_status::ISOLATED_VERTEX, v);
  return T_mesh_reading_report();
}

/// Whether the faces on both sides of each edge agree whether it is a crease. \pre `check_opposites()` found nothing.
inline T_mesh_reading_report check_creases(const T_mesh_soup& soup, const T_mesh_links& links)
{
  for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h)
    if (links.is_crease(h) && !links.is_crease(soup.opposites[h]))
      return report_of_halfedge(soup, links, T_mesh_reading_status::CREASE_NOT_MUTUAL, h,
                                "halfedge " + std::to_string(h) + " is a crease, and its opposite " +
                                    std::to_string(soup.opposites[h]) + " is none");
  return T_mesh_reading_report();
}

/// Finds the first reason why a soup is not an oriented 2-manifold with or without border, or its creases are none.
inline T_mesh_reading_report check_t_mesh_soup(const T_mesh_soup& soup)
{
  const T_mesh_links links(soup);
  T_mesh_reading_report report = check_opposites(soup, links);
  if (report.success())
    report = check_creases(soup, links);
  return report.success() ? check_fans(soup, links) : report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_CHECK_T_MESH_SOUP_H
