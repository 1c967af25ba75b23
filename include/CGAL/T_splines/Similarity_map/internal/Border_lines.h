// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BORDER_LINES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BORDER_LINES_H

#include <CGAL/T_splines/Similarity_map/internal/Chart_line.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_arcs.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_search.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The isolines on which the border of a map lies.
///
/// Each loop of the border is gone around with the surface on the right, so that one passes the sectors of a vertex
/// counter-clockwise. Between two vertices whose angle is an odd number of right angles the border lies on one line,
/// the value of which changes by the transitions of the cut edges that end on it.
class Border_lines {
  using Index = Triangulation_connectivity::Index;

public:
  template <typename FT>
  using Line = Chart_line<FT>;

  /// \param arcs where they end on the border, it is not taken to be one line
  Border_lines(const Triangulation_connectivity& mesh, const Uv_array& uv, const Cut_sectors& sectors,
               const Isoline_arcs& arcs)
    : m_mesh(mesh),
      m_uv(uv),
      m_sectors(sectors),
      m_is_met(sectors.number_of_vertices(), 0)
  {
    std::vector<int> entry(mesh.number_of_vertices(), -1);
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      if (sectors.is_on_border[i])
        entry[sectors.vertices[i]] = i;
    for (const Index corner : arcs.corners_of_nodes())
      if (entry[mesh.target(corner)] != -1)
        m_is_met[entry[mesh.target(corner)]] = 1;
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      if (!sectors.is_on_border[i] || entry[sectors.vertices[i]] == -1)
        continue;
      m_loops.emplace_back();
      for (Index h = first_halfedge(i); entry[mesh.source(h)] != -1; h = opposite(mesh.next(opposite(h)))) {
        m_loops.back().push_back(entry[mesh.source(h)]);
        entry[mesh.source(h)] = -1;
      }
    }
  }

  /// The border vertices of each loop, as entries of the list of cut vertices.
  const std::vector<std::vector<int>>& loops() const { return m_loops; }

  /// The first border edge, as an inner halfedge, that is off the axes by more than `tolerance` radians and what an
  /// error of `tolerance`, relative to the coordinates, makes of it; and by how much.
  std::pair<Index, double> first_oblique_edge(const double tolerance) const
  {
    for (const std::vector<int>& loop : m_loops)
      for (const int i : loop) {
        const Index h = first_halfedge(i);
        const auto [angle, is_oblique] = obliqueness(m_mesh, m_uv, h, tolerance);
        if (is_oblique)
          return {h, angle};
      }
    return {Triangulation_connectivity::null, 0};
  }

  /// Whether a loop has a vertex whose angle is an odd number of right angles, or at which an arc ends.
  bool has_corner(const std::size_t loop, const std::vector<int>& quarter_turns) const
  {
    return std::any_of(m_loops[loop].begin(), m_loops[loop].end(),
                       [&](const int i) { return quarter_turns[i] % 2 != 0 || m_is_met[i] != 0; });
  }

  /// Whether, on a loop with a corner, the line of the border ends at a vertex: of its entry, and its angle.
  bool is_end(const int i, const int quarter_turns) const { return quarter_turns != 2 || m_is_met[i] != 0; }

  /// The axis along which the first edge of a loop has one coordinate: its border edge behind the first vertex.
  int first_axis(const std::size_t loop) const { return axis(first_halfedge(m_loops[loop].front())); }

  /// The lines between corners, as coincidences: two ends, one after the other, of a loop with a corner lie on one line.
  std::vector<Isoline_coincidence> sides(const std::vector<int>& quarter_turns) const
  {
    std::vector<Isoline_coincidence> result;
    for (std::size_t l = 0; l < m_loops.size(); ++l) {
      if (!has_corner(l, quarter_turns))
        continue;
      const std::vector<int>& loop = m_loops[l];
      for (std::size_t begin = 0; begin < loop.size(); ++begin) {
        if (!is_end(loop[begin], quarter_turns[loop[begin]]))
          continue;
        const int i = loop[begin], last = m_sectors.first_sector[i] + m_sectors.number_of_sectors(i) - 1;
        Isoline_coincidence side{m_mesh.previous(m_sectors.halfedge[last]), Triangulation_connectivity::null, 0, {}, 0};
        std::size_t k = (begin + 1) % loop.size();
        side.axis = axis(first_halfedge(loop[k]));
        for (; !is_end(loop[k], quarter_turns[loop[k]]); k = (k + 1) % loop.size())
          for (int j = 1; j < m_sectors.number_of_sectors(loop[k]); ++j)
            side.crossed.push_back(opposite(m_sectors.halfedge[m_sectors.first_sector[loop[k]] + j]));
        side.end = m_mesh.previous(first_halfedge(loop[k]));
        result.push_back(std::move(side));
      }
    }
    return result;
  }

  /// Computes coordinates of border vertices that lie exactly on their lines.
  /// \param transition function object: halfedge -> transition from the chart of its face to that of its opposite's
  /// \param coordinate function object: corner, axis -> coordinate, a double
  /// \param quarter_turns, kept per cut vertex: its angle, and the sector whose chart is meant
  /// \param start per cut vertex. Given are the ends on loops with corners, in their last sectors;
  ///   the others on the border are written
  /// \return a loop without corners whose line the transitions around it do not map to itself, or -1
  template <typename FT, typename Transition_of, typename Coordinate>
  int compute(const Transition_of& transition, const Coordinate& coordinate, const std::vector<int>& quarter_turns,
              const std::vector<int>& kept, std::vector<std::pair<FT, FT>>& start) const
  {
    int open_loop = -1;
    for (std::size_t l = 0; l < m_loops.size(); ++l) {
      const std::vector<int>& loop = m_loops[l];
      const bool is_closed = !has_corner(l, quarter_turns);
      std::size_t first = 0;
      while (!is_closed && !is_end(loop[first], quarter_turns[loop[first]]))
        ++first;
      Line<FT> line = is_closed ? closed_line<FT>(transition, coordinate, loop) : Line<FT>{0, FT(0)};
      const Line<FT> first_line = line;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const int i = loop[(first + k + (is_closed ? 1 : 0)) % loop.size()];
        if (!is_closed && is_end(i, quarter_turns[i])) {
          line.axis = axis(first_halfedge(loop[(first + k + 1) % loop.size()]));
          line.value = line.axis == 0 ? start[i].first : start[i].second;
          continue;
        }
        place(transition, coordinate, i, kept[i], line, start);
        line = carried(transition, i, line);
      }
      if (is_closed && line.value != first_line.value)
        open_loop = static_cast<int>(l);
    }
    return open_loop;
  }

private:
  // The border edge, as an inner halfedge, by which one comes to a vertex: it points away from it.
  Index first_halfedge(const int i) const { return m_sectors.halfedge[m_sectors.first_sector[i]]; }

  int axis(const Index h) const { return constant_axis(m_mesh, m_uv, h); }

  // Carries a line from the first sector of a vertex to another one.
  template <typename FT, typename Transition_of>
  Line<FT> carried(const Transition_of& transition, const int i, Line<FT> line, const int to) const
  {
    for (int k = 1; k <= to; ++k)
      line = line.mapped(transition(opposite(m_sectors.halfedge[m_sectors.first_sector[i] + k])));
    return line;
  }
  template <typename FT, typename Transition_of>
  Line<FT> carried(const Transition_of& transition, const int i, const Line<FT>& line) const
  {
    return carried(transition, i, line, m_sectors.number_of_sectors(i) - 1);
  }

  // The line on the edge from the first vertex of a loop without corners to the next, in the chart of the edge: the mean
  // of its ends up to the first cut; or what the transitions around the loop map to itself.
  template <typename FT, typename Transition_of, typename Coordinate>
  Line<FT> closed_line(const Transition_of& transition, const Coordinate& coordinate,
                       const std::vector<int>& loop) const
  {
    const std::size_t n = loop.size();
    const int line_axis = axis(first_halfedge(loop[1 % n]));
    Line<FT> zero{line_axis, FT(0)}, one{line_axis, FT(1)};
    for (std::size_t k = 0; k < n; ++k) {
      zero = carried(transition, loop[(k + 1) % n], zero);
      one = carried(transition, loop[(k + 1) % n], one);
    }
    const FT factor(one.value - zero.value);
    if (factor != FT(1))
      return {line_axis, FT(zero.value / (FT(1) - factor))};
    double low = coordinate(first_halfedge(loop[1 % n]), line_axis), high = low;
    for (std::size_t k = 0; k < n; ++k) {
      const Index edge = first_halfedge(loop[(k + 1) % n]);
      for (const Index corner : {edge, m_mesh.previous(edge)}) {
        low = std::min(low, coordinate(corner, line_axis));
        high = std::max(high, coordinate(corner, line_axis));
      }
      if (m_sectors.number_of_sectors(loop[(k + 1) % n]) > 1)
        break;
    }
    return {line_axis, FT(low + (high - low) / 2)};
  }

  // Places a vertex on the line behind it.
  template <typename FT, typename Transition_of, typename Coordinate>
  void place(const Transition_of& transition, const Coordinate& coordinate, const int i, const int kept,
             const Line<FT>& behind, std::vector<std::pair<FT, FT>>& start) const
  {
    const Index corner = m_mesh.previous(m_sectors.halfedge[m_sectors.first_sector[i] + kept]);
    std::array<FT, 2> point = {{FT(coordinate(corner, 0)), FT(coordinate(corner, 1))}};
    const Line<FT> here = carried(transition, i, behind, kept);
    point[here.axis] = here.value;
    start[i] = {point[0], point[1]};
  }

  const Triangulation_connectivity& m_mesh;
  const Uv_array& m_uv;
  const Cut_sectors& m_sectors;
  std::vector<std::vector<int>> m_loops;
  std::vector<char> m_is_met; // by an arc, per cut vertex
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BORDER_LINES_H
