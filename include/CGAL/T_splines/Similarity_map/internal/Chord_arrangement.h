// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CHORD_ARRANGEMENT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CHORD_ARRANGEMENT_H

#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The arrangement of two families of straight chords in a triangle. The chords of a family do not cross each other.
///
/// It is determined by the cyclic order of the chords' ends on the boundary alone: two chords cross if and only if
/// their ends alternate, and the order of the crossings on a chord is that of the ends of the chords of the other
/// family. So it needs no coordinates, and no round-off can make it inconsistent.
class Chord_arrangement {
public:
  static constexpr int none = -1;

  /// A chord from the boundary position `from` to the position `to`, part of the directed curve `curve`. \pre At least
  /// two apart.
  struct Chord {
    int from, to;
    int curve;
  };

  /// A crossing of `first_chord` of the first family and `second_chord` of the second: the node
  /// `number_of_positions + i` if it is crossing i.
  struct Crossing {
    int first_chord, second_chord;
  };

  /// computes the arrangement. \param number_of_positions on the boundary, numbered counter-clockwise from 0
  void compute(const int number_of_positions, const std::vector<Chord>& first, const std::vector<Chord>& second)
  {
    m_positions = number_of_positions;
    m_half_edges.clear();
    m_crossings.clear();
    for (int i = 0; i < m_positions; ++i) {
      const int next = (i + 1) % m_positions;
      m_half_edges.push_back({i, next, next, none, none, true, true});
      m_half_edges.push_back({next, i, i, none, none, false, false});
    }
    m_number_of_boundary_half_edges = static_cast<int>(m_half_edges.size());
    find_crossings(first, second);
    add_chords(first, second);
    sort_around_nodes();
  }

  const std::vector<Crossing>& crossings() const { return m_crossings; }

  /// calls `visit(cell)` with the half-edges around each cell, counter-clockwise.
  template <typename Visitor>
  void for_each_cell(Visitor&& visit)
  {
    m_is_visited.assign(m_half_edges.size(), 0);
    for (std::size_t start = 0; start < m_half_edges.size(); ++start) {
      if (m_is_visited[start] || is_outer(static_cast<int>(start)))
        continue;
      m_cell.clear();
      int h = static_cast<int>(start);
      do {
        m_is_visited[h] = 1;
        m_cell.push_back(h);
        h = next_around_cell(h);
      } while (h != static_cast<int>(start));
      visit(m_cell);
    }
  }

  int node(const int h) const { return m_half_edges[h].from; }
  bool is_boundary(const int h) const { return h < m_number_of_boundary_half_edges; }

  /// The curve of the first (second) family that the half-edge lies on, or `none`, and whether it is directed as the
  /// curve.
  int first_curve(const int h) const { return m_half_edges[h].first; }
  int second_curve(const int h) const { return m_half_edges[h].second; }
  bool is_along_first(const int h) const { return m_half_edges[h].first_along; }
  bool is_along_second(const int h) const { return m_half_edges[h].second_along; }

  /// The first half-edge that leaves the node of `h` when turning clockwise from `h`, `h` itself included, and lies on
  /// the second family or on the boundary. \pre The node is a boundary position.
  int second_or_boundary_clockwise(const int h) const
  {
    int i = m_rank[h];
    while (m_half_edges[m_around[i]].second == none && !is_boundary(m_around[i]))
      --i;
    return m_around[i];
  }

  /// The two half-edges of an edge.
  static int twin(const int h) { return opposite(h); }
  bool is_outer(const int h) const { return is_boundary(h) && !is_along_edge(h); }

private:
  struct Half_edge {
    int from, to;      // nodes
    int end;           // the boundary position to which the chord leads in this direction: sorts around a node
    int first, second; // curves
    bool first_along, second_along;
  };

  int offset(const int from, const int to) const { return to >= from ? to - from : to - from + m_positions; }

  bool cross(const Chord& a, const Chord& b) const
  {
    const int to = offset(a.from, a.to), x = offset(a.from, b.from), y = offset(a.from, b.to);
    return x != 0 && y != 0 && x != to && y != to && (x < to) != (y < to);
  }

  void find_crossings(const std::vector<Chord>& first, const std::vector<Chord>& second)
  {
    m_on_first.assign(first.size(), {});
    m_on_second.assign(second.size(), {});
    for (std::size_t i = 0; i < first.size(); ++i)
      for (std::size_t j = 0; j < second.size(); ++j)
        if (cross(first[i], second[j])) {
          m_on_first[i].push_back(static_cast<int>(m_crossings.size()));
          m_on_second[j].push_back(static_cast<int>(m_crossings.size()));
          m_crossings.push_back({static_cast<int>(i), static_cast<int>(j)});
        }
    for (std::size_t i = 0; i < first.size(); ++i)
      sort_along(first[i], m_on_first[i],
                 [&](const int c) -> const Chord& { return second[m_crossings[c].second_chord]; });
    for (std::size_t j = 0; j < second.size(); ++j)
      sort_along(second[j], m_on_second[j],
                 [&](const int c) -> const Chord& { return first[m_crossings[c].first_chord]; });
  }

  // Chords that cross `chord` and not each other meet it in the order of their ends on its right; those with one end in
  // common, in the order of their ends on its left.
  template <typename Other>
  void sort_along(const Chord& chord, std::vector<int>& crossings, Other&& other) const
  {
    const auto key = [&](const int c) {
      const Chord& o = other(c);
      const int x = offset(chord.from, o.from), y = offset(chord.from, o.to);
      return std::make_pair(std::min(x, y), -std::max(x, y));
    };
    std::sort(crossings.begin(), crossings.end(), [&](const int c, const int d) { return key(c) < key(d); });
  }

  void add_chords(const std::vector<Chord>& first, const std::vector<Chord>& second)
  {
    std::vector<char> is_merged(first.size(), 0);
    for (std::size_t j = 0; j < second.size(); ++j) {
      const Chord& chord = second[j];
      int same = none;
      bool along = true;
      for (std::size_t i = 0; i < first.size(); ++i)
        if ((first[i].from == chord.from && first[i].to == chord.to) ||
            (first[i].from == chord.to && first[i].to == chord.from)) {
          is_merged[i] = 1;
          same = first[i].curve;
          along = first[i].from == chord.from;
        }
      add_chord(chord, m_on_second[j], same, chord.curve, along);
    }
    for (std::size_t i = 0; i < first.size(); ++i)
      if (!is_merged[i])
        add_chord(first[i], m_on_first[i], first[i].curve, none, true);
  }

  void add_chord(const Chord& chord, const std::vector<int>& crossings, const int first, const int second,
                 const bool first_along)
  {
    int from = chord.from;
    const auto add = [&](const int to) {
      m_half_edges.push_back({from, to, chord.to, first, second, first_along, true});
      m_half_edges.push_back({to, from, chord.from, first, second, !first_along, false});
      from = to;
    };
    for (const int c : crossings)
      add(m_positions + c);
    add(chord.to);
  }

  // m_around: the half-edges sorted by their node, counter-clockwise around it; at a boundary position from the next
  // boundary edge to the last one.
  void sort_around_nodes()
  {
    m_around.resize(m_half_edges.size());
    for (std::size_t h = 0; h < m_half_edges.size(); ++h)
      m_around[h] = static_cast<int>(h);
    const auto angle = [this](const Half_edge& h) { return h.from < m_positions ? offset(h.from, h.end) : h.end; };
    std::sort(m_around.begin(), m_around.end(), [&](const int a, const int b) {
      const Half_edge &x = m_half_edges[a], &y = m_half_edges[b];
      return x.from != y.from ? x.from < y.from : angle(x) < angle(y);
    });
    m_rank.resize(m_half_edges.size());
    m_node_begin.assign(m_positions + m_crossings.size() + 1, 0);
    for (std::size_t i = 0; i < m_around.size(); ++i) {
      m_rank[m_around[i]] = static_cast<int>(i);
      ++m_node_begin[m_half_edges[m_around[i]].from + 1];
    }
    for (std::size_t i = 1; i < m_node_begin.size(); ++i)
      m_node_begin[i] += m_node_begin[i - 1];
  }

  // Around a cell with the cell on the left: at the end of h, the next half-edge clockwise from the twin of h.
  int next_around_cell(const int h) const
  {
    const int back = twin(h), v = m_half_edges[back].from;
    const int rank = m_rank[back];
    return m_around[rank == m_node_begin[v] ? m_node_begin[v + 1] - 1 : rank - 1];
  }

  int m_positions = 0, m_number_of_boundary_half_edges = 0;
  std::vector<Half_edge> m_half_edges;
  std::vector<Crossing> m_crossings;
  std::vector<std::vector<int>> m_on_first, m_on_second; // crossings per chord, sorted
  std::vector<int> m_around, m_rank, m_node_begin, m_cell;
  std::vector<char> m_is_visited;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CHORD_ARRANGEMENT_H
