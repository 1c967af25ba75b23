// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_LOW_VERTEX_REPAIR_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_LOW_VERTEX_REPAIR_H

#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Solver/support/Hermitian_rows.h>
#include <CGAL/T_splines/Solver/support/Multigrid.h>
#include <CGAL/T_splines/Solver/support/multigrid_iterations.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Makes the quarter turns around vertices positive: a seamless map needs at least one.
///
/// At a sharp spike the smoothest cross does not turn at all; around marked edges it may turn backwards. A quarter turn
/// is carried to such a vertex from the nearest inner one that has two or more, across the edges of a path: by the theorem
/// of Gauss and Bonnet the mean number of a closed surface exceeds one, so there always is such a vertex; on a surface with
/// border there may be none. The crosses
/// around the path are then made smooth, by the least squares of their rotations, in a patch that grows until each
/// rotation is the closest one, less than an eighth of a turn. Crosses that are fixed stay as they are if they leave room
/// for that.
class Low_vertex_repair {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// \param is_face_fixed per face: whether its cross stays as it is
  /// \param angle per face: of its cross; changed by `repair()`
  /// \param progress if it is interrupted, the repair ends soon, and the angles mean nothing
  Low_vertex_repair(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                    const std::vector<char>& is_face_fixed, std::vector<double>& angle, Progress& progress)
    : m_mesh(mesh),
      m_is_face_fixed(is_face_fixed),
      m_angle(angle),
      m_progress(progress),
      m_outgoing(mesh.outgoing_halfedges()),
      m_rotation(field_rotations(mesh, angles_to_halfedges(mesh, geometry, angle))),
      m_turns(mesh.number_of_vertices(), on_border),
      m_unknown(mesh.number_of_faces(), null),
      m_marked(mesh.number_of_vertices(), 0)
  {
    const std::vector<double> of_no_matter(mesh.number_of_edges(), 0.); // what the border adds at its vertices
    const std::vector<double> turns = vertex_quarter_turns(mesh, geometry.m_corner_angle, m_rotation, of_no_matter);
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      m_turns[v] = static_cast<int>(std::lround(turns[v]));
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face(h) == null)
        m_turns[mesh.source(h)] = m_turns[mesh.target(h)] = on_border;
  }

  /// repairs the vertices in the order of their indices. \return how many were repaired.
  int repair()
  {
    int number_repaired = 0;
    for (int v = 0; v < m_mesh.number_of_vertices() && m_progress.go_on_after(2); ++v) {
      if (m_outgoing[v] == null || turns_after_ties(v) >= 1)
        continue;
      std::vector<int> around(1, v);
      m_crossed.clear();
      while (m_turns[v] < 1 && carry_quarter_turn(v, around) && m_progress.go_on_after(100))
        ;
      smooth(around);
      ++number_repaired;
    }
    return number_repaired;
  }

  /// Per edge, the rotation of the cross on entering the face of its even halfedge: the closest one, but for what is said
  /// above.
  const std::vector<double>& rotations() const { return m_rotation; }

private:
  static constexpr int on_border = (std::numeric_limits<int>::max)();
  static constexpr double largest_rotation = quarter_turn / 2;
  static constexpr double tie_margin = 1e-6; // a rotation this close to the largest may be rounded the other way

  double rotation(const int h) const { return rotation_into(m_rotation, h); }
  void add_rotation(const int h, const double change) { m_rotation[edge_of(h)] += is_along_edge(h) ? change : -change; }

  // What is left of the turns of `v` if every tie around it is broken the wrong way.
  int turns_after_ties(const int v) const
  {
    if (m_turns[v] == on_border)
      return on_border;
    int turns = m_turns[v];
    m_mesh.for_each_around_source(m_outgoing[v],
                                  [&](const int h) { turns -= rotation(h) < tie_margin - largest_rotation ? 1 : 0; });
    return turns;
  }

  // Of the nearest vertices with more than one quarter turn, the one with most gives one to `v`. The vertices of the path
  // are added to `around`.
  bool carry_quarter_turn(const int v, std::vector<int>& around)
  {
    struct Reached {
      int vertex, halfedge, parent, distance; // the halfedge to it from its parent, an index into the same list
    };
    std::vector<Reached> reached(1, {v, null, null, 0});
    ++m_mark;
    m_marked[v] = m_mark;
    std::size_t best = 0;
    for (std::size_t i = 0; i < reached.size() && (best == 0 || reached[i].distance < reached[best].distance); ++i) {
      m_mesh.for_each_around_source(m_outgoing[reached[i].vertex], [&](const int h) {
        const int w = m_mesh.target(h);
        if (m_marked[w] == m_mark || !is_free_to_turn(h))
          return;
        m_marked[w] = m_mark;
        reached.push_back({w, h, static_cast<int>(i), reached[i].distance + 1});
        if (m_turns[w] != on_border && m_turns[w] > 1 && (best == 0 || m_turns[w] > m_turns[reached[best].vertex]))
          best = reached.size() - 1;
      });
    }
    if (best == 0)
      return false;
    --m_turns[reached[best].vertex];
    ++m_turns[v];
    for (int i = static_cast<int>(best); i != 0; i = reached[i].parent) {
      around.push_back(reached[i].vertex);
      add_rotation(reached[i].halfedge, -quarter_turn);
      m_crossed.push_back(reached[i].halfedge);
    }
    return true;
  }

  // Whether the edge of `h` has two faces, and the rotation across it stays less than half a turn.
  bool is_free_to_turn(const int h) const
  {
    return m_mesh.face(h) != null && m_mesh.face(opposite(h)) != null &&
           std::abs(rotation(h) - quarter_turn) < 2 * quarter_turn - tie_margin;
  }

  // Changes crosses around vertices such that all rotations there are closest ones, in a patch as small as possible. If
  // crosses that are fixed leave no room for that, those in the middle of the patch are given up.
  bool smooth(std::vector<int> vertices)
  {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    ++m_mark;
    for (const int v : vertices)
      m_marked[v] = m_mark;
    std::size_t number_of_released = vertices.size(), first_of_layer = 0;
    for (bool is_complete = false; m_progress.go_on_after(vertices.size());) {
      std::vector<int> faces = free_faces_around(vertices, 0);
      if (relax(faces))
        return true;
      const std::size_t number_of_free = faces.size();
      faces = free_faces_around(vertices, number_of_released);
      if (faces.size() > number_of_free && relax(faces))
        return true;
      if (is_complete)
        return false;
      number_of_released = vertices.size();
      // As many layers more as make the patch about twice as large.
      while (first_of_layer < vertices.size() && vertices.size() < 2 * number_of_released) {
        const std::size_t end_of_layer = vertices.size();
        for (; first_of_layer < end_of_layer; ++first_of_layer)
          m_mesh.for_each_around_source(m_outgoing[vertices[first_of_layer]], [&](const int h) {
            if (m_marked[m_mesh.target(h)] == m_mark)
              return;
            m_marked[m_mesh.target(h)] = m_mark;
            vertices.push_back(m_mesh.target(h));
          });
      }
      is_complete = vertices.size() == number_of_released;
    }
    return false;
  }

  // The faces with a corner among `vertices` whose crosses are not fixed, or which have a corner among the first
  // `number_of_released` vertices.
  std::vector<int> free_faces_around(const std::vector<int>& vertices, const std::size_t number_of_released) const
  {
    std::vector<int> faces;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      m_mesh.for_each_around_source(m_outgoing[vertices[i]], [&](const int h) {
        const int f = m_mesh.face(h);
        if (f != null && (!m_is_face_fixed[f] || i < number_of_released))
          faces.push_back(f);
      });
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  template <typename Function>
  void for_each_side(const std::vector<int>& faces, const Function& function) const
  {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      int h = m_mesh.halfedge_of_face(faces[i]);
      for (int corner = 0; corner < 3; ++corner, h = m_mesh.next(h))
        if (m_mesh.face(opposite(h)) != null)
          function(static_cast<int>(i), h);
    }
  }

  // Turns the crosses of `faces` such that the rotations of their edges become small. Weights of edges whose rotations
  // are too large grow from round to round. Takes the result if all rotations are closest ones.
  bool relax(const std::vector<int>& faces)
  {
    constexpr int number_of_rounds = 10;
    if (faces.empty())
      return false;
    for (std::size_t i = 0; i < faces.size(); ++i)
      m_unknown[faces[i]] = static_cast<int>(i);
    std::vector<double> weight(3 * faces.size(), 1.), turn(faces.size(), 0.);
    bool is_closest = false;
    for (int round = 0; round < number_of_rounds && !is_closest; ++round) {
      solve_turns(faces, weight, turn);
      // Across an edge with crosses that are fixed on both sides a quarter turn cannot be carried.
      is_closest = std::all_of(m_crossed.begin(), m_crossed.end(), [this](const int h) {
        return m_unknown[m_mesh.face(h)] != null || m_unknown[m_mesh.face(opposite(h))] != null;
      });
      if (!is_closest)
        break;
      std::size_t side = 0;
      for_each_side(faces, [&](const int i, const int h) {
        const double size = std::abs(turned_rotation(i, h, turn)) / (largest_rotation - tie_margin);
        is_closest = is_closest && size < 1;
        weight[side++] *= 1 + size * size * size * size;
      });
    }
    if (is_closest) {
      for_each_side(faces, [&](const int i, const int h) {
        if (is_along_edge(h) || m_unknown[m_mesh.face(opposite(h))] == null)
          add_rotation(h, turned_rotation(i, h, turn) - rotation(h));
      });
      for (std::size_t i = 0; i < faces.size(); ++i)
        m_angle[faces[i]] += turn[i];
    }
    for (const int f : faces)
      m_unknown[f] = null;
    return is_closest;
  }

  // The rotation into face number `i` across its halfedge `h`.
  double turned_rotation(const int i, const int h, const std::vector<double>& turn) const
  {
    const int j = m_unknown[m_mesh.face(opposite(h))];
    return rotation(h) + turn[i] - (j == null ? 0. : turn[j]);
  }

  void solve_turns(const std::vector<int>& faces, const std::vector<double>& weight, std::vector<double>& turn) const
  {
    constexpr double shift = 1e-9;     // where no cross around the patch is given, one may be chosen
    constexpr double residual = 1e-10; // well below the tie margin, as turns are rounded after this
    constexpr int most_iterations = 200;
    std::vector<double> diagonal(faces.size(), shift), right_hand_side(faces.size(), 0.);
    std::vector<Hermitian_rows<double>::Lower_entry> entries;
    std::size_t side = 0;
    for_each_side(faces, [&](const int i, const int h) {
      const int j = m_unknown[m_mesh.face(opposite(h))];
      const double w = weight[side++];
      diagonal[i] += w;
      right_hand_side[i] -= w * rotation(h);
      if (j != null && j < i)
        entries.push_back({i, j, -w});
    });
    Multigrid<double> multigrid(Hermitian_rows<double>::from_lower_triangle(diagonal, entries), m_progress);
    solve_with_multigrid(multigrid, 1., std::vector<double>(faces.size(), 0.), right_hand_side, turn, residual,
                         most_iterations, m_progress);
  }

  const Triangulation_connectivity& m_mesh;
  const std::vector<char>& m_is_face_fixed;
  std::vector<double>& m_angle;
  Progress& m_progress;
  std::vector<int> m_outgoing;
  std::vector<double> m_rotation; // per edge
  std::vector<int> m_turns;       // per vertex: quarter turns, or `on_border`
  std::vector<int> m_unknown;     // per face: its number in the patch that is relaxed, or null
  std::vector<int> m_crossed;     // the halfedges that the quarter turns of the last vertex were carried across
  std::vector<int> m_marked;      // per vertex: the last search that reached it
  int m_mark = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_LOW_VERTEX_REPAIR_H
