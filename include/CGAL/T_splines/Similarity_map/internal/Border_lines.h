// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BORDER_LINES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BORDER_LINES_H

#include <CGAL/T_splines/Similarity_map/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
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
  /// An isoline of a chart. Points on it have the coordinate `value` along `axis`: 0 for u, 1 for v.
  template <typename FT>
  struct Line {
    int axis;
    FT value;

    Line mapped(const Similarity_2<FT>& transition) const
    {
      const std::pair<FT, FT> image = axis == 0 ? transition(value, FT(0)) : transition(FT(0), value);
      const int image_axis = axis ^ (transition.quarter_turns() & 1);
      return {image_axis, image_axis == 0 ? image.first : image.second};
    }
  };

  Border_lines(const Triangulation_connectivity& mesh, const Uv_array& uv, const Cut_sectors& sectors)
    : m_mesh(mesh),
      m_uv(uv),
      m_sectors(sectors)
  {
    std::vector<int> entry(mesh.number_of_vertices(), -1);
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      if (sectors.is_on_border[i])
        entry[sectors.vertices[i]] = i;
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      if (!sectors.is_on_border[i] || entry[sectors.vertices[i]] == -1)
        continue;
      m_loops.emplace_back();
      for (Index h = first_halfedge(i); entry[mesh.source(h)] != -1; h = mesh.next(h ^ 1) ^ 1) {
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
    constexpr double largest_uncertainty = 0.05;
    for (const std::vector<int>& loop : m_loops)
      for (const int i : loop) {
        const Index h = first_halfedge(i);
        const std::array<double, 2>&p = m_uv[m_mesh.previous(h)], &q = m_uv[h];
        const double du = std::abs(p[0] - q[0]), dv = std::abs(p[1] - q[1]);
        const double angle = std::atan2(std::min(du, dv), std::max(du, dv));
        const double size = std::max(largest_coordinate(p), largest_coordinate(q));
        const double allowed = tolerance * (1 + size / distance(p, q));
        if (!(angle <= std::min(allowed, largest_uncertainty)))
          return {h, angle};
      }
    return {Triangulation_connectivity::null, 0};
  }

  /// Whether a loop has a vertex whose angle is an odd number of right angles.
  bool has_corner(const std::size_t loop, const std::vector<int>& quarter_turns) const
  {
    return std::any_of(m_loops[loop].begin(), m_loops[loop].end(),
                       [&](const int i) { return quarter_turns[i] % 2 != 0; });
  }

  /// The axis along which the first edge of a loop has one coordinate: its border edge behind the first vertex.
  int first_axis(const std::size_t loop) const { return axis(first_halfedge(m_loops[loop].front())); }

  /// Computes coordinates of border vertices that lie exactly on their lines.
  /// \param transition function object: halfedge -> transition from the chart of its face to that of its opposite's
  /// \param quarter_turns, kept per cut vertex: its angle, and the sector whose chart is meant
  /// \param start per cut vertex; written on the border only
  /// \return a loop without corners whose line the transitions around it do not map to itself, or -1
  template <typename FT, typename Transition_of>
  int compute(const Transition_of& transition, const std::vector<int>& quarter_turns, const std::vector<int>& kept,
              std::vector<std::pair<FT, FT>>& start) const
  {
    int open_loop = -1;
    for (const std::vector<int>& loop : m_loops) {
      const auto corner =
          std::find_if(loop.begin(), loop.end(), [&](const int i) { return quarter_turns[i] % 2 != 0; });
      const std::size_t n = loop.size(), first = corner == loop.end() ? 0 : corner - loop.begin();
      std::vector<Line<FT>> line(n, Line<FT>{0, FT(0)}); // per vertex: of the edge behind it, in its first sector
      for (std::size_t begin = 0, end; begin < n; begin = end) {
        for (end = begin + 1; end < n && quarter_turns[loop[(first + end) % n]] % 2 == 0;)
          ++end;
        // The line runs from the vertex `begin` to the vertex `end`.
        Line<FT> current = first_line<FT>(transition, loop, first + begin, end - begin, corner == loop.end());
        for (std::size_t k = begin; k < end; ++k) {
          line[(first + k + 1) % n] = current;
          if (k + 1 < end)
            current = carried(transition, loop[(first + k + 1) % n], current);
        }
      }
      for (std::size_t k = 0; k < n; ++k)
        place(transition, loop[k], quarter_turns[loop[k]], kept[loop[k]], line[k], line[(k + 1) % n], start);
      if (corner == loop.end() && carried(transition, loop[0], line[0]).value != line[1 % n].value)
        open_loop = static_cast<int>(&loop - m_loops.data());
    }
    return open_loop;
  }

private:
  // The border edge, as an inner halfedge, by which one comes to a vertex: it points away from it.
  Index first_halfedge(const int i) const { return m_sectors.halfedge[m_sectors.first_sector[i]]; }

  int axis(const Index h) const
  {
    const std::array<double, 2>&p = m_uv[m_mesh.previous(h)], &q = m_uv[h];
    return std::abs(p[0] - q[0]) < std::abs(p[1] - q[1]) ? 0 : 1;
  }

  // Carries a line from the first sector of a vertex to another one.
  template <typename FT, typename Transition_of>
  Line<FT> carried(const Transition_of& transition, const int i, Line<FT> line, const int to) const
  {
    for (int k = 1; k <= to; ++k)
      line = line.mapped(transition(m_sectors.halfedge[m_sectors.first_sector[i] + k] ^ 1));
    return line;
  }
  template <typename FT, typename Transition_of>
  Line<FT> carried(const Transition_of& transition, const int i, const Line<FT>& line) const
  {
    return carried(transition, i, line, m_sectors.number_of_sectors(i) - 1);
  }

  // The line on the edge from the vertex `begin` of a loop to the next, in the chart of the edge: the mean of its ends
  // up to the first cut; or what the transitions around the loop map to itself.
  template <typename FT, typename Transition_of>
  Line<FT> first_line(const Transition_of& transition, const std::vector<int>& loop, const std::size_t begin,
                      const std::size_t length, const bool is_closed) const
  {
    const std::size_t n = loop.size();
    const Index h = first_halfedge(loop[(begin + 1) % n]);
    const int line_axis = axis(h);
    if (is_closed) {
      Line<FT> zero{line_axis, FT(0)}, one{line_axis, FT(1)};
      for (std::size_t k = 0; k < n; ++k) {
        zero = carried(transition, loop[(begin + k + 1) % n], zero);
        one = carried(transition, loop[(begin + k + 1) % n], one);
      }
      const FT factor(one.value - zero.value);
      if (factor != FT(1))
        return {line_axis, FT(zero.value / (FT(1) - factor))};
    }
    double low = m_uv[h][line_axis], high = low;
    for (std::size_t k = 0; k < length; ++k) {
      const Index edge = first_halfedge(loop[(begin + k + 1) % n]);
      for (const Index corner : {edge, m_mesh.previous(edge)}) {
        low = std::min(low, m_uv[corner][line_axis]);
        high = std::max(high, m_uv[corner][line_axis]);
      }
      if (m_sectors.number_of_sectors(loop[(begin + k + 1) % n]) > 1)
        break;
    }
    return {line_axis, FT(low + (high - low) / 2)};
  }

  // Places a vertex on the line behind it and, at a corner, on the line before it.
  template <typename FT, typename Transition_of>
  void place(const Transition_of& transition, const int i, const int quarter_turns, const int kept,
             const Line<FT>& behind, Line<FT> before, std::vector<std::pair<FT, FT>>& start) const
  {
    const int first = m_sectors.first_sector[i];
    const Index corner = m_mesh.previous(m_sectors.halfedge[first + kept]);
    std::array<FT, 2> point = {{FT(m_uv[corner][0]), FT(m_uv[corner][1])}};
    const Line<FT> here = carried(transition, i, behind, kept);
    point[here.axis] = here.value;
    if (quarter_turns % 2 != 0) {
      for (int k = m_sectors.number_of_sectors(i) - 1; k > kept; --k)
        before = before.mapped(transition(m_sectors.halfedge[first + k]));
      point[before.axis] = before.value;
    }
    start[i] = {point[0], point[1]};
  }

  const Triangulation_connectivity& m_mesh;
  const Uv_array& m_uv;
  const Cut_sectors& m_sectors;
  std::vector<std::vector<int>> m_loops;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BORDER_LINES_H
