// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_T_MESH_CHECKER_H
#define T_SPLINES_TEST_T_MESH_CHECKER_H

#include "Exact_t_mesh.h"
#include "T_mesh_development.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

struct T_mesh_check : Check_result {
  int vertices = 0, edges = 0, faces = 0, components = 0;
  int t_joints = 0;          ///< face corners that are straight on at a vertex where an edge ends
  int straight_vertices = 0; ///< with two edges only
  int extraordinary_vertices = 0;
  int unequal_knots = 0;                              ///< edges
  std::size_t pieces = 0;                             ///< (triangle, place) that the development of the faces visits
  double point_deviation = 0, polyline_deviation = 0; ///< by the diagonal of the bounding box
  double largest_aspect_ratio = 0;

  std::string text() const
  {
    std::ostringstream out;
    out << vertices << " vertices, " << edges << " edges, " << faces << " faces, " << t_joints << " T-joints, "
        << extraordinary_vertices << " extraordinary, " << straight_vertices << " of valence two, " << unequal_knots
        << " edges with unequal knots, " << pieces << " pieces, points " << point_deviation << ", polylines "
        << polyline_deviation << ", aspect ratio " << largest_aspect_ratio << "\n"
        << failure_text();
    return out.str();
  }
};

/// Judges a T-mesh with halfedge knots by the definitions of [CZ17] section 4, and its place on the surface by
/// developing each face over the triangles of an exact seamless map.
class T_mesh_checker {
public:
  /// \param tolerance relative, of sums and products of knots: 0 for exact knots
  T_mesh_checker(const Exact_map& map, const Exact_t_mesh& t_mesh, const double tolerance = 0)
    : m_map(map),
      m_t_mesh(t_mesh),
      m_tolerance(tolerance)
  {
  }

  T_mesh_check check()
  {
    m_check.vertices = m_t_mesh.number_of_vertices;
    m_check.edges = m_t_mesh.number_of_halfedges() / 2;
    m_check.faces = m_t_mesh.number_of_faces();
    if (!check_connectivity() || !check_corners())
      return m_check;
    m_t_mesh.make_frames();
    check_sums();
    for (int v = 0; v < m_t_mesh.number_of_vertices; ++v)
      check_vertex(v);
    check_cones();
    check_characteristic();
    if (m_check.success() && m_tolerance == 0 && !m_t_mesh.anchor.empty())
      check_development();
    return m_check;
  }

private:
  bool are_equal(const Exact& a, const Exact& b) const
  {
    if (m_tolerance == 0)
      return a == b;
    return std::abs(CGAL::to_double(Exact(a - b))) <= m_tolerance * CGAL::to_double(a);
  }

  bool check_connectivity()
  {
    std::vector<int> found(m_check.faces, 0);
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h) {
      if (m_t_mesh.previous[m_t_mesh.next[h]] != h || m_t_mesh.next[m_t_mesh.previous[h]] != h)
        m_check.fail("next and previous are not inverse at halfedge", h);
      if (m_t_mesh.source(m_t_mesh.next[h]) != m_t_mesh.target[h])
        m_check.fail("the next halfedge begins elsewhere: halfedge", h);
      if (m_t_mesh.face[m_t_mesh.next[h]] != m_t_mesh.face[h])
        m_check.fail("the next halfedge has another face: halfedge", h);
      if (m_t_mesh.face[h] != Exact_t_mesh::none)
        ++found[m_t_mesh.face[h]];
    }
    if (!m_check.success())
      return false;
    for (int f = 0; f < m_check.faces; ++f) {
      int length = 0, h = m_t_mesh.halfedge_of_face[f];
      do {
        ++length;
        h = m_t_mesh.next[h];
      } while (h != m_t_mesh.halfedge_of_face[f]);
      if (m_t_mesh.face[h] != f || length != found[f])
        m_check.fail("more than one cycle of halfedges around face", f);
    }
    make_umbrellas();
    return m_check.success();
  }

  // All halfedges that point to a vertex, in one cycle around it.
  void make_umbrellas()
  {
    m_umbrella.assign(m_check.vertices, {});
    std::vector<int> count(m_check.vertices, 0);
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h) {
      const int v = m_t_mesh.target[h];
      ++count[v];
      if (!m_umbrella[v].empty())
        continue;
      int g = h;
      do {
        m_umbrella[v].push_back(g);
        g = m_t_mesh.next[g] ^ 1;
      } while (g != h);
    }
    for (int v = 0; v < m_check.vertices; ++v)
      if (m_umbrella[v].empty() || static_cast<int>(m_umbrella[v].size()) != count[v])
        m_check.fail("no edge, or more than one fan of faces, at vertex", v);
  }

  bool check_corners()
  {
    std::vector<int> corners(m_check.faces, 0);
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h) {
      const int f = m_t_mesh.face[h];
      if (f == Exact_t_mesh::none)
        continue;
      corners[f] += m_t_mesh.is_corner[h];
      if (m_t_mesh.knot[h] <= 0)
        m_check.fail("the knot interval is not positive at halfedge", h);
    }
    for (int f = 0; f < m_check.faces; ++f)
      if (corners[f] != 4)
        m_check.fail(std::to_string(corners[f]) + " corners: face", f);
    return m_check.success();
  }

  void check_sums()
  {
    for (int f = 0; f < m_check.faces; ++f) {
      std::array<Exact, 4> length;
      for (int s = 0; s < 4; ++s)
        for (const int h : m_t_mesh.frame[f].side[s])
          length[s] += m_t_mesh.knot[h];
      if (!are_equal(length[0], length[2]) || !are_equal(length[1], length[3]))
        m_check.fail("opposite sums differ: face", f);
      const double ratio = CGAL::to_double(Exact(length[0] / length[1]));
      m_check.largest_aspect_ratio = std::max({m_check.largest_aspect_ratio, ratio, 1 / ratio});
    }
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); h += 2)
      if (m_t_mesh.face[h] != Exact_t_mesh::none && m_t_mesh.face[h ^ 1] != Exact_t_mesh::none &&
          !are_equal(m_t_mesh.knot[h], m_t_mesh.knot[h ^ 1]))
        ++m_check.unequal_knots;
    const auto is_one = [](const Exact_similarity& s) { return s.scale() == 1; };
    if (m_check.unequal_knots > 0 && std::all_of(m_map.transitions.begin(), m_map.transitions.end(), is_one))
      m_check.fail("no transition scales, but the knots of edges differ: number of edges", m_check.unequal_knots);
  }

  bool is_border_vertex(const int v) const
  {
    return std::any_of(m_umbrella[v].begin(), m_umbrella[v].end(),
                       [&](const int h) { return m_t_mesh.face[h] == Exact_t_mesh::none; });
  }

  int extended_valence(const int v) const
  {
    int result = 0;
    for (const int h : m_umbrella[v])
      if (m_t_mesh.face[h] != Exact_t_mesh::none)
        result += m_t_mesh.is_corner[h] ? 1 : 2;
    return result;
  }

  void check_vertex(const int v)
  {
    Exact product(1);
    int straight = 0;
    for (const int h : m_umbrella[v]) {
      straight += m_t_mesh.face[h] != Exact_t_mesh::none && !m_t_mesh.is_corner[h];
      if (!is_border_vertex(v))
        product *= m_t_mesh.knot[h] / m_t_mesh.knot[h ^ 1];
    }
    if (!are_equal(product, Exact(1)))
      m_check.fail("the cycle condition does not hold at vertex", v);
    if (m_umbrella[v].size() == 2 && straight > 0)
      ++m_check.straight_vertices;
    else
      m_check.t_joints += straight;
    m_check.extraordinary_vertices += extended_valence(v) != (is_border_vertex(v) ? 2 : 4);
  }

  // Each cone is a vertex of the T-mesh with the extended valence k; all others are regular.
  void check_cones()
  {
    std::vector<int> vertex_of(m_map.number_of_vertices(), Exact_t_mesh::none);
    for (int v = 0; v < m_check.vertices && !m_t_mesh.origin.empty(); ++v) {
      const int origin = m_t_mesh.origin[v];
      int expected = is_border_vertex(v) ? 2 : 4;
      if (origin != Exact_t_mesh::none) {
        if (vertex_of[origin] != Exact_t_mesh::none)
          m_check.fail("origin of two vertices: vertex of the surface", origin);
        vertex_of[origin] = v;
        expected = m_map.quarter_turns[origin];
      }
      if (extended_valence(v) != expected)
        m_check.fail("the extended valence is " + std::to_string(extended_valence(v)) + ", not " +
                         std::to_string(expected) + ", at vertex",
                     v);
    }
    std::vector<char> is_border(m_map.number_of_vertices(), 0);
    for (std::size_t h = 0; h < m_map.target.size(); ++h)
      if (m_map.opposite[h] == Exact_map::none)
        is_border[m_map.target[h]] = 1;
    for (int v = 0; v < m_map.number_of_vertices() && !m_t_mesh.origin.empty(); ++v)
      if (m_map.quarter_turns[v] != (is_border[v] ? 2 : 4) && vertex_of[v] == Exact_t_mesh::none)
        m_check.fail("no vertex of the T-mesh lies at cone", v);
  }

  void check_characteristic()
  {
    int surface = m_map.number_of_vertices() + m_map.number_of_triangles();
    int doubled_edges = 0;
    for (std::size_t h = 0; h < m_map.target.size(); ++h)
      doubled_edges += m_map.opposite[h] == Exact_map::none ? 2 : 1;
    surface -= doubled_edges / 2;
    const int of_t_mesh = m_check.vertices - m_check.edges + m_check.faces;
    if (of_t_mesh != surface)
      m_check.fail("the Euler characteristic is " + std::to_string(of_t_mesh) + ", that of the surface", surface);
    std::vector<char> is_found(m_check.faces, 0);
    std::vector<int> stack;
    for (int f = 0; f < m_check.faces; ++f) {
      if (is_found[f])
        continue;
      ++m_check.components;
      is_found[f] = 1;
      stack.push_back(f);
      while (!stack.empty()) {
        const int g = stack.back();
        stack.pop_back();
        for (const auto& side : m_t_mesh.frame[g].side)
          for (const int h : side) {
            const int neighbor = m_t_mesh.face[h ^ 1];
            if (neighbor != Exact_t_mesh::none && !is_found[neighbor]) {
              is_found[neighbor] = 1;
              stack.push_back(neighbor);
            }
          }
      }
    }
  }

  void check_development()
  {
    T_mesh_development development(m_map, m_t_mesh, m_check);
    development.check();
    m_check.pieces = development.number_of_pieces();
    m_check.point_deviation = development.point_deviation();
    m_check.polyline_deviation = development.polyline_deviation();
  }

  const Exact_map& m_map;
  Exact_t_mesh m_t_mesh;
  double m_tolerance;
  T_mesh_check m_check;
  std::vector<std::vector<int>> m_umbrella; // per vertex: the halfedges that point to it
};

#endif // T_SPLINES_TEST_T_MESH_CHECKER_H
