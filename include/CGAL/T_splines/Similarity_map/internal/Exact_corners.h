// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_CORNERS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_CORNERS_H

#include <CGAL/T_splines/Similarity_map/internal/Arc_lines.h>
#include <CGAL/T_splines/Similarity_map/internal/Chart_line.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_transitions.h>
#include <CGAL/T_splines/Similarity_map/internal/Free_points.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_arcs.h>
#include <CGAL/T_splines/Similarity_map/internal/Sector_values.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/Similarity_map/internal/uv_orientation.h>
#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The coordinates of the vertices on the cut, on the border and on arcs, computed from exact transitions.
class Exact_corners {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param arcs to be kept alive
  /// \param others vertices that are to be free points, too: halfedges that point to them, and their quarter turns
  Exact_corners(const Cut_map& map, const Isoline_arcs& arcs, const std::vector<std::pair<Index, int>>& others)
    : m_map(map),
      m_arcs(map, arcs)
  {
    for (int i = 0; i < map.sectors.number_of_vertices(); ++i) {
      const bool is_fixed = !map.sectors.is_on_border[i] && map.quarter_turns[i] % 4 != 0;
      m_kept.push_back(is_fixed ? fixed_point : sector_to_keep(i));
      if (!map.sectors.is_on_border[i] && map.quarter_turns[i] % 4 == 0 && map.quarter_turns[i] != 4)
        m_points.add(map, i, m_kept[i]);
    }
    for (std::size_t loop = 0; loop < map.border.loops().size(); ++loop)
      if (map.border.has_corner(loop, map.quarter_turns))
        for (const int i : map.border.loops()[loop])
          if (map.border.is_end(i, map.quarter_turns[i])) {
            m_kept[i] = map.sectors.number_of_sectors(i) - 1;
            m_points.add(map, i, m_kept[i]);
          }
    for (const auto& [corner, quarter_turns] : others) {
      const int i = map.entry_of_vertex(map.mesh.target(corner));
      if (i == Cut_map::none)
        m_points.add_off_cut(map, corner, quarter_turns);
      else
        m_points.add(map, i, m_kept[i]);
    }
    for (int a = 0; a < arcs.number_of_arcs(); ++a)
      for (int i = 0; i + 1 < arcs.length(a); ++i)
        if (map.entry_of_vertex(map.mesh.target(arcs.halfedge(a, i))) == Cut_map::none)
          m_arc_corners_off_cut.push_back(arcs.halfedge(a, i));
    collect_faces();
  }

  const Free_points& points() const { return m_points; }
  const Arc_lines& arcs() const { return m_arcs; }

  /// The smallest height of their faces, in the plane.
  double smallest_height() const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const int f : m_faces) {
      const Index h = m_map.mesh.halfedge_of_face(f), j = m_map.mesh.next(h), k = m_map.mesh.next(j);
      const double longest =
          std::max({squared_distance(m_map.uv[h], m_map.uv[j]), squared_distance(m_map.uv[j], m_map.uv[k]),
                    squared_distance(m_map.uv[k], m_map.uv[h])});
      result = std::min(result, double_area(m_map.uv, h) / std::sqrt(longest));
    }
    return result;
  }

  /// The faces whose corners may change.
  const std::vector<int>& faces() const { return m_faces; }

  /// Whether, as far as doubles tell, no triangle changes its area by more than a factor 2, and no corner moves by more
  /// than an eighth of the longest side of its triangle.
  bool is_harmless(const Exact_transitions<double>& transitions)
  {
    std::vector<Similarity_2<double>> along, against;
    for (int b = 0; b < m_map.graph.number_of_branches(); ++b) {
      along.push_back(transitions.transition(b));
      against.push_back(along.back().inverse());
    }
    if (m_trial.empty())
      m_trial = m_map.uv;
    compute<double>(
        transitions,
        [&](const Index h) -> const Similarity_2<double>& {
          return (m_map.graph.is_along(h) ? along : against)[m_map.graph.branch_of_edge(edge_of(h))];
        },
        [&](const std::pair<double, double>& value, const auto& for_each_corner) {
          for_each_corner([&](const Index h) { m_trial[h] = {{value.first, value.second}}; });
        });
    return is_harmless(m_trial);
  }

  /// The same for coordinates. \param uv per halfedge
  bool is_harmless(const Uv_array& uv) const
  {
    constexpr double largest_displacement = 0.125; // by the longest side: what moves farther is not rounding
    return std::all_of(m_faces.begin(), m_faces.end(), [&](const int f) {
      const Index h = m_map.mesh.halfedge_of_face(f);
      const double before = double_area(m_map.uv, h), after = double_area(uv, h);
      return after >= before / 2 && after <= before * 2 && displacement(f, uv) <= largest_displacement;
    });
  }

  /// Writes branches and corners to a layout that has the coordinates in doubles.
  /// \return a vertex of a line that the transitions do not close exactly, or -1; always -1 if `FT` is not exact
  template <typename FT>
  Index write(const Exact_transitions<FT>& transitions, Seamless_layout<FT>& layout) const
  {
    layout.clear_branches_and_determined();
    for (int b = 0; b < m_map.graph.number_of_branches(); ++b) {
      layout.add_branch(transitions.transition(b));
      for (int i = 0; i < m_map.graph.length(b); ++i)
        layout.set_branch(m_map.graph.halfedge(b, i), b);
    }
    const Index vertex_of_open_line = compute<FT>(
        transitions, [&layout](const Index h) -> const Similarity_2<FT>& { return layout.transition(h); },
        [&](const std::pair<FT, FT>& value, const auto& for_each_corner) {
          const Corner<FT> corner(value, layout);
          for_each_corner([&](const Index h) { corner.write(h, layout); });
        });
    return CGAL::Algebraic_structure_traits<FT>::Is_exact::value ? vertex_of_open_line : -1;
  }

  /// The faces that are not positively oriented in a layout.
  template <typename FT>
  std::vector<int> lost_faces(const Seamless_layout<FT>& layout) const
  {
    std::vector<int> result;
    for (const int f : m_faces)
      if (uv_orientation(layout, m_map.mesh.halfedge_of_face(f)) != CGAL::POSITIVE)
        result.push_back(f);
    return result;
  }

  /// How far the corners of a face move, by its longest side. \param uv where to, per halfedge
  double displacement(const int f, const Uv_array& uv) const
  {
    Index h = m_map.mesh.halfedge_of_face(f);
    double moved = 0, side = 0;
    for (int k = 0; k < 3; ++k, h = m_map.mesh.next(h)) {
      moved = std::max(moved, squared_distance(m_map.uv[h], uv[h]));
      side = std::max(side, squared_distance(m_map.uv[h], m_map.uv[m_map.mesh.next(h)]));
    }
    return std::sqrt(moved / side);
  }

private:
  // The sector of the flattest triangle: it suffers most from a displacement.
  int sector_to_keep(const int i) const
  {
    double scale = 1, smallest = 0; // of the sector's chart, and a height in the chart of the first sector
    int best = 0;
    for (int k = 0; k < m_map.sectors.number_of_sectors(i); ++k) {
      const Index h = m_map.sectors.halfedge[m_map.sectors.first_sector[i] + k];
      if (k > 0) {
        const double factor = m_map.fits[m_map.graph.branch_of_edge(edge_of(h))].scale();
        scale *= m_map.graph.is_along(opposite(h)) ? factor : 1 / factor;
      }
      m_map.for_each_corner(i, k, [&](const Index corner) {
        const double height = height_over_opposite_side(corner) / scale;
        if (height < smallest || smallest == 0) {
          smallest = height;
          best = k;
        }
      });
    }
    return best;
  }

  void collect_faces()
  {
    std::vector<char> is_listed(m_map.mesh.number_of_faces(), 0);
    for (int i = 0; i < m_map.sectors.number_of_vertices(); ++i)
      for (int k = 0; k < m_map.sectors.number_of_sectors(i); ++k)
        m_map.for_each_corner(i, k, [&](const Index h) {
          const Index f = m_map.mesh.face(h);
          if (!is_listed[f])
            m_faces.push_back(f);
          is_listed[f] = 1;
        });
    const auto add = [&](const Index h) {
      if (is_listed[m_map.mesh.face(h)] == 0)
        m_faces.push_back(m_map.mesh.face(h));
      is_listed[m_map.mesh.face(h)] = 1;
    };
    for (int p = 0; p < m_points.size(); ++p)
      if (m_points[p].entry == Free_points::none)
        for_each_corner_around(m_points[p].corner, add);
    for (const Index corner : m_arc_corners_off_cut)
      for_each_corner_around(corner, add);
    std::sort(m_faces.begin(), m_faces.end());
  }

  double double_area(const Uv_array& uv, const Index h) const
  {
    const std::array<double, 2>&p = uv[h], &q = uv[m_map.mesh.next(h)], &r = uv[m_map.mesh.previous(h)];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  double height_over_opposite_side(const Index corner) const
  {
    return double_area(m_map.uv, corner) /
           distance(m_map.uv[m_map.mesh.next(corner)], m_map.uv[m_map.mesh.previous(corner)]);
  }

  // Calls `visit(h)` for the halfedges that point to an inner vertex, as one of them does.
  template <typename Visit>
  void for_each_corner_around(const Index corner, const Visit& visit) const
  {
    Index h = corner;
    do {
      visit(h);
      h = opposite(m_map.mesh.next(h));
    } while (h != corner);
  }

  // Calls `write(value, for_each_corner)` for the sectors of all cut vertices, and for the others that may move;
  // `for_each_corner(visit)` calls `visit(h)` for the halfedges to which the value belongs.
  // \return a vertex of a line that the transitions do not close, or -1
  template <typename FT, typename Transition_of, typename Write>
  Index compute(const Exact_transitions<FT>& transitions, const Transition_of& transition, const Write& write) const
  {
    const Cut_sectors& sectors = m_map.sectors;
    const auto coordinate = [&](const Index h, const int axis) { return transitions.on_grid(m_map.uv[h][axis]); };
    std::vector<std::pair<FT, FT>> start(sectors.number_of_vertices()); // in the sector that is kept
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      const Index h = kept_corner(i);
      start[i] = {FT(coordinate(h, 0)), FT(coordinate(h, 1))};
    }
    for (int i = 0; i < m_points.size(); ++i)
      if (m_points[i].entry != Free_points::none)
        start[m_points[i].entry] = transitions.point(i);
    const int open_loop = m_map.border.compute(transition, coordinate, m_map.quarter_turns, m_kept, start);
    Index open = open_loop == -1 ? -1 : sectors.vertices[m_map.border.loops()[open_loop].front()];
    const Index open_arc = compute_arcs<FT>(transitions, transition, coordinate, start, write);
    if (open == -1)
      open = open_arc;
    std::vector<std::pair<FT, FT>> values;
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      const bool is_closed = compute_sector_values(sectors, i, transition, m_kept[i], start[i], values);
      CGAL_assertion(is_closed || !CGAL::Algebraic_structure_traits<FT>::Is_exact::value);
      CGAL_USE(is_closed);
      for (int k = 0; k < sectors.number_of_sectors(i); ++k)
        write(values[k], [&](const auto& visit) { m_map.for_each_corner(i, k, visit); });
    }
    for (int p = 0; p < m_points.size(); ++p)
      if (m_points[p].entry == Free_points::none)
        write(transitions.point(p), [&](const auto& visit) { for_each_corner_around(m_points[p].corner, visit); });
    return open;
  }

  Index kept_corner(const int i) const
  {
    return m_map.mesh.previous(m_map.sectors.halfedge[m_map.sectors.first_sector[i] + std::max(m_kept[i], 0)]);
  }

  // Puts the vertices within arcs on the lines of their nodes: those off the cut are written, the others are placed.
  // \return a vertex of an arc whose ends are not on one line, or -1
  template <typename FT, typename Transition_of, typename Coordinate, typename Write>
  Index compute_arcs(const Exact_transitions<FT>& transitions, const Transition_of& transition,
                     const Coordinate& coordinate, std::vector<std::pair<FT, FT>>& start, const Write& write) const
  {
    std::vector<std::pair<FT, FT>> values;
    const auto node_coordinate = [&](const Index corner, const int axis) -> FT {
      const int i = m_map.entry_of_vertex(m_map.mesh.target(corner));
      if (i != Cut_map::none)
        compute_sector_values(m_map.sectors, i, transition, m_kept[i], start[i], values);
      const std::pair<FT, FT> point = i != Cut_map::none
                                          ? values[m_map.sector_of_corner(i, corner)]
                                          : transitions.point(m_points.at_vertex(m_map.mesh.target(corner)));
      return axis == 0 ? point.first : point.second;
    };
    const auto place = [&](const Index corner, Chart_line<FT> line) {
      const int i = m_map.entry_of_vertex(m_map.mesh.target(corner));
      if (i != Cut_map::none)
        line = carried_to_kept(transition, i, m_map.sector_of_corner(i, corner), line);
      const Index h = i == Cut_map::none ? corner : kept_corner(i);
      std::pair<FT, FT> point(FT(coordinate(h, 0)), FT(coordinate(h, 1)));
      (line.axis == 0 ? point.first : point.second) = line.value;
      if (i != Cut_map::none)
        start[i] = point;
      else
        write(point, [&](const auto& visit) { for_each_corner_around(corner, visit); });
    };
    const int open = m_arcs.follow<FT>(transition, node_coordinate, place);
    return open == -1 ? -1 : m_map.mesh.source(m_arcs.first_halfedge(open));
  }

  // Carries a line from one sector of an inner cut vertex to the one that is kept.
  template <typename FT, typename Transition_of>
  Chart_line<FT> carried_to_kept(const Transition_of& transition, const int i, int k, Chart_line<FT> line) const
  {
    const int n = m_map.sectors.number_of_sectors(i);
    while (k != m_kept[i]) {
      k = (k + 1) % n;
      line = line.mapped(transition(opposite(m_map.sectors.halfedge[m_map.sectors.first_sector[i] + k])));
    }
    return line;
  }

  // The coordinates of corners; if they are doubles, they are stored as such.
  template <typename FT>
  class Corner {
  public:
    Corner(const std::pair<FT, FT>& value, Seamless_layout<FT>& layout)
      : m_rounded{{CGAL::to_double(value.first), CGAL::to_double(value.second)}}
    {
      if (FT(m_rounded[0]) != value.first || FT(m_rounded[1]) != value.second)
        m_determined = layout.add_determined(value.first, value.second);
    }

    void write(const Index h, Seamless_layout<FT>& layout) const
    {
      if (m_determined == -1)
        layout.set_uv(h, m_rounded);
      else
        layout.set_determined(h, m_determined);
    }

  private:
    std::array<double, 2> m_rounded;
    int m_determined = -1;
  };

  const Cut_map& m_map;
  Arc_lines m_arcs;
  Free_points m_points;
  std::vector<int> m_kept;                  // per cut vertex, a sector or `fixed_point`
  std::vector<Index> m_arc_corners_off_cut; // halfedges that point to vertices within arcs
  std::vector<int> m_faces;                 // sorted
  Uv_array m_trial;                         // per halfedge
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EXACT_CORNERS_H
