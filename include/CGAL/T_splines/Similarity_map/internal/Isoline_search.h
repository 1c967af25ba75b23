// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_SEARCH_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_SEARCH_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// How far an isoline of a cone may pass another cone that it is taken to run into, by the longest side of the triangle
/// there.
///
/// Isolines that symmetry or alignment brings together are apart by the round-off of the map: measured, up to some
/// 1e-9. Isolines that pass a cone by chance are nearer than x to it in one of 1 / x passages through its triangles;
/// surfaces have some hundred of those.
constexpr double coincidence_tolerance = 1e-5;

/// Two cones, or one twice, on an isoline of a map.
struct Isoline_coincidence {
  using Index = Triangulation_connectivity::Index;

  Index start, end;           ///< halfedges that point to the cones, in the first and in the last face of the isoline
  int axis;                   ///< the coordinate that is constant in the chart of the first face: 0 for u, 1 for v
  std::vector<Index> crossed; ///< the cut edges on the way, as halfedges of the faces that are left
  double gap;                 ///< of the isoline of the first cone and the other cone, by the longest side there
};

/// Follows the isolines of cones in doubles, up to the next cone that they run into but for round-off.
///
/// An isoline enters a triangle through an edge and leaves it on one or the other side of the apex: so it goes on
/// whatever round-off does. Along edges it may pass the vertices on either side.
/// \tparam Transition_of function object: halfedge of a cut edge -> transition from the chart of its face to that of
///   its opposite's, in doubles
template <typename Transition_of>
class Isoline_search {
  using Index = Triangulation_connectivity::Index;

public:
  /// Where isolines start and end.
  struct Cone {
    Index outgoing;    ///< a halfedge that leaves it; on the border the first one, counter-clockwise
    int quarter_turns; ///< its angle
    bool is_on_border;
  };

  /// \param is_wall per edge: they stop isolines, and isolines along them are not followed; empty for none
  /// \param noise of coordinates, relative to the largest one
  Isoline_search(const Triangulation_connectivity& mesh, const Uv_array& uv, const std::vector<char>& is_cut,
                 const std::vector<char>& is_wall, const Transition_of& transition, const std::vector<Cone>& cones,
                 const double noise)
    : m_mesh(mesh),
      m_uv(uv),
      m_is_cut(is_cut),
      m_is_wall(is_wall),
      m_transition(transition),
      m_cones(cones),
      m_noise(noise),
      m_cone_of_vertex(mesh.number_of_vertices(), none),
      m_is_done(cones.size())
  {
    for (std::size_t i = 0; i < cones.size(); ++i) {
      m_cone_of_vertex[mesh.source(cones[i].outgoing)] = static_cast<int>(i);
      m_is_done[i].assign(cones[i].quarter_turns, 0);
    }
  }

  /// \param longest the number of triangles after which an isoline is given up
  /// \param progress if it is interrupted, some lines are not found
  std::vector<Isoline_coincidence> run(const int longest, Progress& progress)
  {
    std::vector<Isoline_coincidence> result;
    for (std::size_t i = 0; i < m_cones.size(); ++i) {
      const Unrolled_cone cone(*this, m_cones[i]);
      if (!m_is_wall.empty())
        skip_rays_at_walls(static_cast<int>(i), cone);
      for (int j = m_cones[i].is_on_border ? 1 : 0; j < m_cones[i].quarter_turns; ++j) {
        Isoline_coincidence found;
        if (!progress.go_on_after(1 + static_cast<std::size_t>(longest)))
          return result;
        if (m_is_done[i][j] == 0 && follow(cone.start(*this, j), longest, found))
          result.push_back(std::move(found));
      }
    }
    return result;
  }

private:
  static constexpr int none = -1;
  static double quarter() { return 2 * std::atan(1.); }

  // Directions in a chart are 0, 1, 2, 3 for +u, +v, -u, -v.
  static int axis_across(const int direction) { return 1 - (direction & 1); }
  static bool is_left(const int direction, const double across)
  {
    return direction == 0 || direction == 3 ? across > 0 : across < 0;
  }

  /// An isoline in a face.
  struct Line {
    Index corner; ///< at its start: the halfedge that points to the cone
    Index exit;   ///< the edge through which it leaves the face
    int direction;
    double value; ///< its constant coordinate
    double noise; ///< of the value

    int axis() const { return axis_across(direction); }
  };

  /// The corners at a cone one after the other, counter-clockwise, and its rays.
  class Unrolled_cone {
  public:
    Unrolled_cone(const Isoline_search& search, const Cone& cone) : m_quarter_turns(cone.quarter_turns)
    {
      double begin = 0;
      for (Index h = cone.outgoing; m_corners.empty() || h != cone.outgoing; h = search.m_mesh.next_around_source(h)) {
        if (search.m_mesh.face(h) == Triangulation_connectivity::null)
          break;
        const std::array<double, 2>&p = search.m_uv[search.m_mesh.previous(h)], &q = search.m_uv[h];
        const double angle = std::atan2(q[1] - p[1], q[0] - p[0]);
        if (m_corners.empty())
          begin = angle;
        m_corners.push_back({h, begin, angle});
        begin += uv_angle(search.m_mesh, search.m_uv, search.m_mesh.previous(h));
      }
      const double first = m_corners.front().begin / quarter();
      m_first_axis = static_cast<int>(cone.is_on_border ? std::round(first) : std::ceil(first));
    }

    /// The ray with a number below that of the quarter turns; on the border, ray 0 runs along it.
    Line start(const Isoline_search& search, const int ray) const
    {
      const double angle = (m_first_axis + ray) * quarter();
      std::size_t i = m_corners.size() - 1;
      while (i > 0 && m_corners[i].begin > angle)
        --i;
      const double own_angle = m_corners[i].own_angle + angle - m_corners[i].begin;
      const Index h = m_corners[i].outgoing, corner = search.m_mesh.previous(h);
      Line line;
      line.direction = (static_cast<int>(std::round(own_angle / quarter())) + 8) % 4;
      line.corner = corner;
      line.exit = search.m_mesh.next(h);
      line.value = search.m_uv[corner][line.axis()];
      line.noise = search.m_noise * largest_coordinate(search.m_uv[corner]);
      return line;
    }

    /// The ray that has a direction in the corner of a halfedge that points to the cone.
    int ray(const Isoline_search& search, const Index corner, const int direction) const
    {
      const Index h = search.m_mesh.next(corner);
      std::size_t i = 0;
      while (m_corners[i].outgoing != h)
        ++i;
      double turn = direction * quarter() - m_corners[i].own_angle; // from 0 to pi, up to round-off
      turn -= 4 * quarter() * std::floor((turn + quarter() / 2) / (4 * quarter()));
      const int axis = static_cast<int>(std::round((m_corners[i].begin + turn) / quarter())) - m_first_axis;
      return (axis + m_quarter_turns) % m_quarter_turns;
    }

    /// The rays along walls, ascending.
    std::vector<int> wall_rays(const Isoline_search& search) const
    {
      std::vector<int> result;
      for (const Corner& corner : m_corners)
        if (search.m_is_wall[edge_of(corner.outgoing)] != 0) {
          const int axis = static_cast<int>(std::round(corner.begin / quarter())) - m_first_axis;
          result.push_back((axis + m_quarter_turns) % m_quarter_turns);
        }
      std::sort(result.begin(), result.end());
      return result;
    }

  private:
    struct Corner {
      Index outgoing;
      double begin;     ///< sum of the angles before it, from the chart of the first one
      double own_angle; ///< of the halfedge in its own chart
    };

    int m_quarter_turns;
    int m_first_axis;
    std::vector<Corner> m_corners;
  };

  // Of a cone, the rays along walls are not followed; of another vertex, only those between walls that are more than
  // two quarter turns apart: there the tracer starts, too.
  void skip_rays_at_walls(const int i, const Unrolled_cone& cone)
  {
    const int k = m_cones[i].quarter_turns;
    std::vector<int> walls = cone.wall_rays(*this);
    for (const int ray : walls)
      m_is_done[i][ray] = 1;
    if (walls.empty() || k != (m_cones[i].is_on_border ? 2 : 4))
      return;
    walls.push_back(walls.front() + k);
    for (std::size_t w = 0; w + 1 < walls.size(); ++w)
      if (walls[w + 1] - walls[w] <= 2)
        for (int ray = walls[w]; ray < walls[w + 1]; ++ray)
          m_is_done[i][ray % k] = 1;
  }

  // Whether a line runs into the vertex at the tip of `corner`, ahead in its face.
  bool arrives(const Line& line, const Index corner, Isoline_coincidence& found)
  {
    const int i = m_cone_of_vertex[m_mesh.target(corner)];
    if (i == none)
      return false;
    const Index j = m_mesh.next(corner), k = m_mesh.previous(corner);
    const double side =
        std::max({distance(m_uv[corner], m_uv[j]), distance(m_uv[j], m_uv[k]), distance(m_uv[k], m_uv[corner])});
    const double gap = std::abs(m_uv[corner][line.axis()] - line.value);
    if (!(gap <= std::min(coincidence_tolerance * side + 8 * line.noise, side * largest_rounding)))
      return false;
    found.end = corner;
    found.gap = gap / side;
    m_is_done[i][Unrolled_cone(*this, m_cones[i]).ray(*this, corner, (line.direction + 2) % 4)] = 1;
    return true;
  }

  void cross(Line& line, Isoline_coincidence& found) const
  {
    const Similarity_2<double>& transition = m_transition(line.exit);
    found.crossed.push_back(line.exit);
    const bool is_u = line.axis() == 0;
    const std::pair<double, double> image = transition(is_u ? line.value : 0, is_u ? 0 : line.value);
    line.direction = (line.direction + transition.quarter_turns()) % 4;
    line.value = line.axis() == 0 ? image.first : image.second;
    line.noise = line.noise * transition.scale() + m_noise * largest_coordinate(m_uv[opposite(line.exit)]);
  }

  bool follow(Line line, const int longest, Isoline_coincidence& found)
  {
    found.start = line.corner;
    found.axis = line.axis();
    const int along = 1 - line.axis();
    for (const Index corner : {m_mesh.next(line.corner), line.exit}) {
      const double way = m_uv[corner][along] - m_uv[line.corner][along];
      if ((line.direction < 2 ? way > 0 : way < 0) && arrives(line, corner, found))
        return true;
    }
    for (int n = 0; n < longest; ++n) {
      const Index entry = opposite(line.exit);
      if (m_mesh.face(entry) == Triangulation_connectivity::null || (!m_is_wall.empty() && m_is_wall[edge_of(entry)]))
        return false;
      if (m_is_cut[edge_of(entry)])
        cross(line, found);
      const Index apex = m_mesh.next(entry);
      if (arrives(line, apex, found))
        return true;
      line.exit = is_left(line.direction, m_uv[apex][line.axis()] - line.value) ? apex : m_mesh.next(apex);
    }
    return false;
  }

  const Triangulation_connectivity& m_mesh;
  const Uv_array& m_uv;
  const std::vector<char>&m_is_cut, &m_is_wall;
  const Transition_of& m_transition;
  const std::vector<Cone>& m_cones;
  double m_noise;
  std::vector<int> m_cone_of_vertex;
  std::vector<std::vector<char>> m_is_done; // per cone and ray
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_SEARCH_H
