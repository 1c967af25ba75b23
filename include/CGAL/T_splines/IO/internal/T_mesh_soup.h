// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_T_MESH_SOUP_H
#define CGAL_T_SPLINES_IO_INTERNAL_T_MESH_SOUP_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What stands in a T-mesh file, in the order of the file. The halfedges of the faces are numbered one face after the
/// other: halfedge i of a face runs from its vertex i to its vertex i + 1.
struct T_mesh_soup {
  static constexpr std::size_t border = static_cast<std::size_t>(-1);

  std::vector<std::array<double, 4>> points;     ///< per vertex: x, y, z, weight
  std::vector<std::size_t> point_lines;          ///< per vertex: its line
  std::vector<std::size_t> first_halfedge = {0}; ///< per face, and the end
  std::vector<std::size_t> face_lines;           ///< per face: its line
  std::vector<std::size_t> sources;              ///< per halfedge: the vertex where it begins
  std::vector<double> knots;                     ///< per halfedge
  std::vector<char> is_corner;                   ///< per halfedge: whether its face turns where it begins
  std::vector<std::size_t> opposites;            ///< per halfedge: a halfedge, or `border`
  std::vector<char> is_crease;                   ///< per halfedge: whether its edge is said to be one; or empty

  std::size_t number_of_vertices() const { return points.size(); }
  std::size_t number_of_faces() const { return first_halfedge.size() - 1; }
  std::size_t number_of_halfedges() const { return sources.size(); }
};

/// The halfedges of a soup as they are linked.
class T_mesh_links {
public:
  explicit T_mesh_links(const T_mesh_soup& soup) : m_soup(soup), m_face(soup.number_of_halfedges())
  {
    for (std::size_t f = 0; f < soup.number_of_faces(); ++f)
      for (std::size_t h = soup.first_halfedge[f]; h < soup.first_halfedge[f + 1]; ++h)
        m_face[h] = f;
  }

  std::size_t face(const std::size_t h) const { return m_face[h]; }
  std::size_t index_in_face(const std::size_t h) const { return h - m_soup.first_halfedge[m_face[h]]; }
  std::size_t source(const std::size_t h) const { return m_soup.sources[h]; }
  std::size_t target(const std::size_t h) const { return m_soup.sources[next(h)]; }

  std::size_t next(const std::size_t h) const
  {
    const std::size_t f = m_face[h];
    return h + 1 == m_soup.first_halfedge[f + 1] ? m_soup.first_halfedge[f] : h + 1;
  }
  std::size_t prev(const std::size_t h) const
  {
    const std::size_t f = m_face[h];
    return (h == m_soup.first_halfedge[f] ? m_soup.first_halfedge[f + 1] : h) - 1;
  }

  bool is_border_edge(const std::size_t h) const { return m_soup.opposites[h] == T_mesh_soup::border; }

  /// An edge of the border is none, whatever the file says.
  bool is_crease(const std::size_t h) const
  {
    return !m_soup.is_crease.empty() && m_soup.is_crease[h] != 0 && !is_border_edge(h);
  }

  /// The halfedge that leaves the source of `h` clockwise before `h`; `border` at the end of a fan.
  std::size_t clockwise(const std::size_t h) const
  {
    return is_border_edge(h) ? T_mesh_soup::border : next(m_soup.opposites[h]);
  }

  /// The halfedge that leaves the source of `h` counter-clockwise after `h`; `border` at the end of a fan.
  std::size_t counter_clockwise(const std::size_t h) const { return m_soup.opposites[prev(h)]; }

private:
  const T_mesh_soup& m_soup;
  std::vector<std::size_t> m_face;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_T_MESH_SOUP_H
