// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_BUILD_T_MESH_H
#define CGAL_T_SPLINES_IO_INTERNAL_BUILD_T_MESH_H

#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>
#include <CGAL/T_splines/internal/Face_graph_writer.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Builds the T-mesh of a soup: vertices and faces in the order of the file, and `halfedge(f)` is the first halfedge of
/// the face's list.
///
/// A T-mesh may have two edges between the same vertices, or an edge that its face has on both sides: nothing is
/// looked up by its vertices.
/// \tparam TMesh a `T_mesh_view`
/// \pre `check_t_mesh_soup()` found nothing; the T-mesh is empty.
template <typename TMesh>
class T_mesh_builder {
  using Writer = Face_graph_writer<typename TMesh::Graph>;
  using halfedge_descriptor = typename Writer::halfedge_descriptor;

public:
  using vertex_descriptor = typename Writer::vertex_descriptor;

  T_mesh_builder(const T_mesh_soup& soup, const TMesh& t_mesh)
    : m_links(soup),
      m_number(paired_numbers(soup)),
      m_writer(t_mesh.graph(), static_cast<int>(soup.number_of_vertices()), number_of_edges(soup),
               static_cast<int>(soup.number_of_faces()))
  {
    for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h)
      m_writer.join(m_number[h], m_number[m_links.next(h)], static_cast<int>(m_links.target(h)),
                    static_cast<int>(m_links.face(h)));
    for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h)
      if (m_links.is_border_edge(h))
        join_border(h);
    for (std::size_t f = 0; f < soup.number_of_faces(); ++f)
      m_writer.set_halfedge_of_face(static_cast<int>(f), m_number[soup.first_halfedge[f]]);
    for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h) {
      t_mesh.set_knot(halfedge_of(h), typename TMesh::FT(soup.knots[h]));
      t_mesh.set_corner(halfedge_before(h), soup.is_corner[h] != 0);
      if (is_first_of_edge(soup, h))
        t_mesh.set_crease(halfedge_of(h), m_links.is_crease(h));
    }
  }

  vertex_descriptor vertex_of(const std::size_t v) const { return m_writer.vertex(static_cast<int>(v)); }

private:
  halfedge_descriptor halfedge_of(const std::size_t h) const { return m_writer.halfedge(m_number[h]); }

  // The halfedge before `h` (number) on its face: corners of the file stand at sources, those of the map at targets.
  halfedge_descriptor halfedge_before(const std::size_t h) const { return halfedge_of(m_links.prev(h)); }

  static bool is_first_of_edge(const T_mesh_soup& soup, const std::size_t h)
  {
    return soup.opposites[h] == T_mesh_soup::border || h < soup.opposites[h];
  }

  static int number_of_edges(const T_mesh_soup& soup)
  {
    int result = 0;
    for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h)
      result += is_first_of_edge(soup, h) ? 1 : 0;
    return result;
  }

  // Numbers 2e and 2e + 1 for the halfedges of an edge, edges in the order of the file; 2e + 1 may be at the border.
  static std::vector<int> paired_numbers(const T_mesh_soup& soup)
  {
    std::vector<int> result(soup.number_of_halfedges());
    int number = 0;
    for (std::size_t h = 0; h < soup.number_of_halfedges(); ++h)
      if (is_first_of_edge(soup, h)) {
        result[h] = number;
        if (soup.opposites[h] != T_mesh_soup::border)
          result[soup.opposites[h]] = number + 1;
        number += 2;
      }
    return result;
  }

  /// Joins the border halfedge opposite to `h` with the next one, at the other end of the fan at the source of `h`.
  void join_border(const std::size_t h)
  {
    std::size_t last = h;
    while (!m_links.is_border_edge(m_links.prev(last)))
      last = m_links.counter_clockwise(last);
    m_writer.join(m_number[h] + 1, m_number[m_links.prev(last)] + 1, static_cast<int>(m_links.source(h)), -1);
  }

  const T_mesh_links m_links;
  const std::vector<int> m_number; // per halfedge of the soup
  Writer m_writer;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_BUILD_T_MESH_H
