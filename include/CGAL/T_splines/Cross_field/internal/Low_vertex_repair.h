// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_LOW_VERTEX_REPAIR_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_LOW_VERTEX_REPAIR_H

#include <CGAL/T_splines/Cross_field/internal/Vertex_sectors.h>
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
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Makes the quarter turns around vertices, or in their sectors between features, positive: a seamless map needs at least
/// one.
///
/// At a sharp spike the smoothest cross does not turn at all; around marked edges it may turn backwards. A quarter turn
/// is carried to such a sector from the nearest inner one that has two or more, across the edges of a path: by the theorem
/// of Gauss and Bonnet the mean number of a closed surface exceeds one, so there always is such a vertex; on a surface with
/// border, or between features, there may be none. The crosses
/// around the path are then made smooth, by the least squares of their rotations, in a patch that grows until each
/// rotation is the closest one, less than an eighth of a turn. Crosses that are fixed stay as they are if they leave room
/// for that.
///
/// Where the sectors are those between features, crosses that are fixed stay in any case, and rotations may be larger: they
/// are what decides, not the crosses. No path crosses a feature. Quarter turns come from where there is one too
/// many, if there is such a place: from inner vertices that keep three, or from sectors that keep what is next to their
/// angle.
class Low_vertex_repair {
  static constexpr int null = Triangulation_connectivity::null;

public:
  /// What becomes of crosses that are fixed but leave no room.
  enum class Fixed_crosses { GIVE_WAY, STAY };

  /// \param sectors of the vertices; those with border at both ends give no quarter turns, and get some only where crosses stay
  /// \param border_cross as in `vertex_quarter_turns()`
  /// \param is_face_fixed per face: whether its cross stays as it is
  /// \param angle per face: of its cross; changed by `repair()`
  /// \param progress if it is interrupted, the repair ends soon, and the angles mean nothing
  Low_vertex_repair(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                    const Vertex_sectors& sectors, const std::vector<double>& border_cross,
                    const Fixed_crosses fixed_crosses, const std::vector<char>& is_face_fixed,
                    std::vector<double>& angle, Progress& progress)
    : m_mesh(mesh),
      m_sectors(sectors),
      m_fixed_crosses(fixed_crosses),
      m_is_face_fixed(is_face_fixed),
      m_angle(angle),
      m_progress(progress),
      m_rotation(field_rotations(mesh, angles_to_halfedges(mesh, geometry, angle))),
      m_turns(sectors.size()),
      m_usual_turns(sectors.size(), 4),
      m_angle_in_turns(sectors.size(), 4),
      m_unknown(mesh.number_of_faces(), null),
      m_marked(sectors.size(), 0)
  {
    const std::vector<double> turns = sectors.quarter_turns(geometry.m_corner_angle, m_rotation, border_cross);
    const std::vector<double> angles = sectors.angles(geometry.m_corner_angle);
    for (int s = 0; s < sectors.size(); ++s) {
      m_turns[s] = static_cast<int>(std::lround(turns[s]));
      if (sectors.has_bounds(s))
        m_usual_turns[s] = (std::max)(1, static_cast<int>(std::lround(angles[s] / quarter_turn)));
      m_angle_in_turns[s] = angles[s] / quarter_turn;
    }
  }

  /// repairs the sectors in the order of their indices. \return how many were repaired.
  int repair()
  {
    int number_repaired = 0;
    for (int s = 0; s < m_sectors.size() && m_progress.go_on_after(2); ++s) {
      if ((m_fixed_crosses == Fixed_crosses::GIVE_WAY && m_sectors.is_between_borders(s)) || turns_after_ties(s) >= 1)
        continue;
      std::vector<int> around(1, s);
      m_crossed.clear();
      while (m_turns[s] < 1 && carry_quarter_turn(s, 1, around) && m_progress.go_on_after(100))
        ;
      smooth(around);
      ++number_repaired;
    }
    return number_repaired;
  }

  /// gives sectors between features the quarter turns that go best with their angles: those that are off by more than
  /// `tolerance` of one, as far as their part of the surface has some too many or too few. No new cones arise.
  /// \return how many it changed
  int meet_angles(const double tolerance)
  {
    int number_changed = 0;
    for (int s = 0; s < m_sectors.size() && m_progress.go_on_after(2); ++s) {
      if (!m_sectors.has_bounds(s) || m_sectors.is_between_borders(s))
        continue;
      std::vector<int> around(1, s);
      m_crossed.clear();
      while (std::abs(m_turns[s] - m_angle_in_turns[s]) > tolerance && m_progress.go_on_after(100)) {
        const int change = m_turns[s] < m_angle_in_turns[s] ? 1 : -1;
        const auto has_excess = [&](const int t) { return (m_turns[t] - m_usual_turns[t]) * change > 0; };
        if (m_turns[s] + change < 1 || !carry_quarter_turn(s, change, around, has_excess))
          break;
      }
      if (around.size() > 1) {
        smooth(around);
        ++number_changed;
      }
    }
    return number_changed;
  }

  /// gives the vertices on the border the quarter turns that are wanted, all their sectors together, as far as others can
  /// give or take them: those with sectors where that goes best with the angles.
  /// \param wanted per vertex; only those on the border matter
  void meet_corners(const std::vector<int>& wanted)
  {
    for (int first = 0, end = 0; first < m_sectors.size() && m_progress.go_on_after(2); first = end) {
      bool is_on_border = false;
      int missing = wanted[m_sectors.vertex(first)];
      for (end = first; end < m_sectors.size() && m_sectors.vertex(end) == m_sectors.vertex(first); ++end) {
        is_on_border = is_on_border || m_mesh.face(opposite(m_sectors.first(end))) == null;
        missing -= m_turns[end];
      }
      if (!is_on_border)
        continue;
      std::vector<int> around;
      m_crossed.clear();
      for (const int change = missing < 0 ? -1 : 1; missing != 0 && m_progress.go_on_after(100); missing -= change) {
        int best = first;
        for (int s = first + 1; s < end; ++s)
          if ((m_usual_turns[s] - m_turns[s]) * change > (m_usual_turns[best] - m_turns[best]) * change)
            best = s;
        around.push_back(best);
        if (m_turns[best] + change < 1 || !carry_quarter_turn(best, change, around))
          break;
      }
      if (!around.empty())
        smooth(around);
    }
  }

  /// Per edge, the rotation of the cross on entering the face of its even halfedge: the closest one, but for what is said
  /// above.
  const std::vector<double>& rotations() const { return m_rotation; }

  /// Per sector, its quarter turns.
  const std::vector<int>& turns() const { return m_turns; }

private:
  static constexpr double largest_rotation = quarter_turn / 2;
  static constexpr double tie_margin = 1e-6; // a rotation this close to the largest may be rounded the other way

  double rotation(const int h) const { return rotation_into(m_rotation, h); }
  void add_rotation(const int h, const double change) { m_rotation[edge_of(h)] += is_along_edge(h) ? change : -change; }

  // What is left of the turns of sector `s` if every tie in it is broken the wrong way, where crosses decide.
  int turns_after_ties(const int s) const
  {
    int turns = m_turns[s];
    if (m_fixed_crosses == Fixed_crosses::STAY)
      return turns;
    m_sectors.for_each_halfedge(s, [&](const int h) { turns -= rotation(h) < tie_margin - largest_rotation ? 1 : 0; });
    return turns;
  }

  // Carries a quarter turn to `s`, or with a change of -1 away from it. The sectors of the path are added to `around`.
  bool carry_quarter_turn(const int s, const int change, std::vector<int>& around)
  {
    if (m_fixed_crosses == Fixed_crosses::STAY && carry_quarter_turn(s, change, around, [this, change](const int t) {
          const int tolerated = m_sectors.has_bounds(t) ? 0 : 1; // cones of three and five
          return (m_turns[t] - m_usual_turns[t]) * change > -tolerated;
        }))
      return true;
    return carry_quarter_turn(s, change, around, [](int) { return true; });
  }

  // Of the nearest sectors that may give a quarter turn and keep one, that with most does; or that with fewest takes it.
  template <typename IsPartner>
  bool carry_quarter_turn(const int s, const int change, std::vector<int>& around, const IsPartner& is_partner)
  {
    struct Reached {
      int sector, halfedge, parent, distance; // the halfedge to it from its parent, an index into the same list
    };
    std::vector<Reached> reached(1, {s, null, null, 0});
    ++m_mark;
    m_marked[s] = m_mark;
    std::size_t best = 0;
    for (std::size_t i = 0; i < reached.size() && (best == 0 || reached[i].distance < reached[best].distance); ++i) {
      m_sectors.for_each_halfedge(reached[i].sector, [&](const int h) {
        if (!is_free_to_turn(h, change))
          return;
        const int t = m_sectors.sector_across(reached[i].sector, h);
        if (m_marked[t] == m_mark)
          return;
        m_marked[t] = m_mark;
        reached.push_back({t, h, static_cast<int>(i), reached[i].distance + 1});
        if (!m_sectors.is_between_borders(t) && m_turns[t] - change >= 1 && is_partner(t) &&
            (best == 0 || m_turns[t] * change > m_turns[reached[best].sector] * change))
          best = reached.size() - 1;
      });
    }
    if (best == 0)
      return false;
    m_turns[reached[best].sector] -= change;
    m_turns[s] += change;
    for (int i = static_cast<int>(best); i != 0; i = reached[i].parent) {
      around.push_back(reached[i].sector);
      add_rotation(reached[i].halfedge, -change * quarter_turn);
      m_crossed.push_back(reached[i].halfedge);
    }
    return true;
  }

  // Whether the edge of `h` has two faces and no sector ends there, and the rotation across it stays less than half a turn.
  bool is_free_to_turn(const int h, const int change) const
  {
    return !m_sectors.is_bound(h) && std::abs(rotation(h) - change * quarter_turn) < 2 * quarter_turn - tie_margin;
  }

  // Changes crosses around sectors such that all rotations there are closest ones, in a patch as small as possible. If
  // crosses that are fixed leave no room for that, those in the middle of the patch are given up, or, where they stay, the
  // rotations are made as small as they can be.
  bool smooth(std::vector<int> sectors)
  {
    const bool may_give_way = m_fixed_crosses == Fixed_crosses::GIVE_WAY;
    std::sort(sectors.begin(), sectors.end());
    sectors.erase(std::unique(sectors.begin(), sectors.end()), sectors.end());
    ++m_mark;
    for (const int s : sectors)
      m_marked[s] = m_mark;
    std::size_t number_of_released = sectors.size(), first_of_layer = 0;
    for (bool is_complete = false; m_progress.go_on_after(sectors.size());) {
      std::vector<int> faces = free_faces_around(sectors, 0);
      const bool is_last = !may_give_way && (is_complete || sectors.size() > largest_patch);
      if (relax(faces, is_last))
        return true;
      if (may_give_way) {
        const std::size_t number_of_free = faces.size();
        faces = free_faces_around(sectors, number_of_released);
        if (faces.size() > number_of_free && relax(faces, false))
          return true;
      }
      if (is_complete || is_last)
        return false;
      number_of_released = sectors.size();
      // As many layers more as make the patch about twice as large.
      while (first_of_layer < sectors.size() && sectors.size() < 2 * number_of_released) {
        const std::size_t end_of_layer = sectors.size();
        for (; first_of_layer < end_of_layer; ++first_of_layer)
          m_sectors.for_each_halfedge(sectors[first_of_layer], [&](const int h) {
            const int t = m_sectors.sector_across(sectors[first_of_layer], h);
            if (m_marked[t] == m_mark)
              return;
            m_marked[t] = m_mark;
            sectors.push_back(t);
          });
      }
      is_complete = sectors.size() == number_of_released;
    }
    return false;
  }

  // The faces with a corner in one of `sectors` whose crosses are not fixed, or which have a corner in one of the first
  // `number_of_released` sectors.
  std::vector<int> free_faces_around(const std::vector<int>& sectors, const std::size_t number_of_released) const
  {
    std::vector<int> faces;
    for (std::size_t i = 0; i < sectors.size(); ++i)
      m_sectors.for_each_halfedge(sectors[i], [&](const int h) {
        const int f = m_mesh.face(h);
        if (f != null && m_sectors.sector(h) == sectors[i] && (!m_is_face_fixed[f] || i < number_of_released))
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
  // are too large grow from round to round. Takes the result if all rotations are closest ones, or if it is the last resort and all
  // are less than half a turn.
  bool relax(const std::vector<int>& faces, const bool is_last_resort)
  {
    constexpr int number_of_rounds = 10;
    if (faces.empty())
      return false;
    for (std::size_t i = 0; i < faces.size(); ++i)
      m_unknown[faces[i]] = static_cast<int>(i);
    std::vector<double> weight(3 * faces.size(), 1.), turn(faces.size(), 0.);
    // Across an edge with crosses that are fixed on both sides a quarter turn cannot be carried, where crosses decide.
    const bool has_room = std::all_of(m_crossed.begin(), m_crossed.end(), [this](const int h) {
      return m_unknown[m_mesh.face(h)] != null || m_unknown[m_mesh.face(opposite(h))] != null;
    });
    bool is_closest = false, is_possible = false;
    for (int round = 0; round < number_of_rounds && !is_closest; ++round) {
      if (!has_room && m_fixed_crosses == Fixed_crosses::GIVE_WAY)
        break;
      solve_turns(faces, weight, turn);
      is_closest = is_possible = true;
      std::size_t side = 0;
      for_each_side(faces, [&](const int i, const int h) {
        const double size = std::abs(turned_rotation(i, h, turn)) / (largest_rotation - tie_margin);
        is_closest = is_closest && size < 1;
        is_possible = is_possible && size < 4;
        weight[side++] *= 1 + size * size * size * size;
      });
    }
    if (is_last_resort)
      is_closest = is_possible;
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

  // Where fixed crosses leave no room, larger patches help no more.
  static constexpr std::size_t largest_patch = 1000;

  const Triangulation_connectivity& m_mesh;
  const Vertex_sectors& m_sectors;
  const Fixed_crosses m_fixed_crosses;
  const std::vector<char>& m_is_face_fixed;
  std::vector<double>& m_angle;
  Progress& m_progress;
  std::vector<double> m_rotation;       // per edge
  std::vector<int> m_turns;             // per sector: quarter turns
  std::vector<int> m_usual_turns;       // per sector: what it keeps if it can, 4 where it has no bounds
  std::vector<double> m_angle_in_turns; // per sector
  std::vector<int> m_unknown;           // per face: its number in the patch that is relaxed, or null
  std::vector<int> m_crossed;           // the halfedges that the quarter turns of the last sector were carried across
  std::vector<int> m_marked;            // per sector: the last search that reached it
  int m_mark = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_LOW_VERTEX_REPAIR_H
