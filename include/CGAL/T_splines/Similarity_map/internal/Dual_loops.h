// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DUAL_LOOPS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DUAL_LOOPS_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Closed strips of triangles on a triangulation whose edges are flipped.
///
/// A loop is a cyclic doubly linked list of passages, each the halfedge by which the loop enters a face. The passages
/// over an edge are linked as well, so that a flip reroutes the loops at the cost of the passages through its two
/// triangles.
class Dual_loops {
  using Index = Triangulation_connectivity::Index;

  struct Passage {
    Index halfedge;
    int loop;
    int next, previous;                 // along the loop
    int next_on_edge, previous_on_edge; // all passages over the same edge
  };

public:
  explicit Dual_loops(const std::size_t number_of_edges = 0) : m_first_on_edge(number_of_edges, null) {}

  int number_of_loops() const { return static_cast<int>(m_first.size()); }

  /// Appends a loop. \pre halfedges is not empty.
  void add(const std::vector<Index>& halfedges)
  {
    const int loop = number_of_loops();
    int last = null;
    for (const Index h : halfedges)
      last = insert(h, loop, last);
    m_first.push_back(m_passages[last].next);
  }

  /// Number of triangles along all loops together.
  std::size_t number_of_passages() const { return m_passages.size() - m_free.size(); }

  bool has_passages(const Index edge) const { return m_first_on_edge[edge] != null; }

  /// calls `visit(loop, sign)` for each passage over `edge`: sign +1 if it enters the face of the halfedge 2 edge.
  template <typename Visitor>
  void for_each_passage(const Index edge, Visitor&& visit) const
  {
    for (int i = m_first_on_edge[edge]; i != null; i = m_passages[i].next_on_edge)
      visit(m_passages[i].loop, is_along_edge(m_passages[i].halfedge) ? 1 : -1);
  }

  /// calls `visit(h, turns_left)` for each triangle of a loop: `h` is the halfedge by which it is entered, and the
  /// corner that the loop passes is the source of `h` if it turns left there, else its target.
  template <typename Visitor>
  void for_each_corner(const Triangulation_connectivity& mesh, const int loop, Visitor&& visit) const
  {
    const int first = m_first[loop];
    int i = first;
    do {
      const Index h = m_passages[i].halfedge;
      i = m_passages[i].next;
      const Index exit = opposite(m_passages[i].halfedge);
      CGAL_assertion(exit == mesh.next(h) || exit == mesh.previous(h));
      visit(h, exit == mesh.previous(h));
    } while (i != first);
  }

  std::vector<Index> halfedges(const int loop) const
  {
    std::vector<Index> result;
    int i = m_first[loop];
    do {
      result.push_back(m_passages[i].halfedge);
      i = m_passages[i].next;
    } while (i != m_first[loop]);
    return result;
  }

  /// flips the edge of `h` in `mesh` and reroutes the loops through its two triangles.
  void flip(Triangulation_connectivity& mesh, const Index h)
  {
    const Index g = opposite(h);
    const std::array<Index, 4> sides = {mesh.next(h), mesh.previous(h), mesh.next(g), mesh.previous(g)};
    m_entries.clear();
    for (const Index side : sides)
      for (int i = m_first_on_edge[edge_of(side)]; i != null; i = m_passages[i].next_on_edge)
        if (m_passages[i].halfedge == side)
          m_entries.push_back(i);
    int& on_edge = m_first_on_edge[edge_of(h)];
    while (on_edge != null)
      erase(on_edge);
    mesh.flip(h);
    for (const int entry : m_entries) {
      const Index entered = m_passages[entry].halfedge;
      const Index exit = opposite(m_passages[m_passages[entry].next].halfedge);
      if (mesh.face(entered) != mesh.face(exit))
        insert(mesh.face(exit) == mesh.face(h) ? h : g, m_passages[entry].loop, entry);
    }
  }

private:
  static constexpr int null = -1;

  // Inserts a passage behind `previous` (null: as the only one of a new loop).
  int insert(const Index h, const int loop, const int previous)
  {
    int i;
    if (m_free.empty()) {
      i = static_cast<int>(m_passages.size());
      m_passages.emplace_back();
    }
    else {
      i = m_free.back();
      m_free.pop_back();
    }
    Passage& p = m_passages[i];
    p.halfedge = h;
    p.loop = loop;
    if (previous == null)
      p.previous = p.next = i;
    else {
      p.previous = previous;
      p.next = m_passages[previous].next;
      m_passages[p.next].previous = i;
      m_passages[previous].next = i;
    }
    int& first = m_first_on_edge[edge_of(h)];
    p.previous_on_edge = null;
    p.next_on_edge = first;
    if (first != null)
      m_passages[first].previous_on_edge = i;
    first = i;
    return i;
  }

  void erase(const int i)
  {
    const Passage& p = m_passages[i];
    CGAL_assertion(p.next != i);
    m_passages[p.previous].next = p.next;
    m_passages[p.next].previous = p.previous;
    if (m_first[p.loop] == i)
      m_first[p.loop] = p.next;
    if (p.previous_on_edge == null)
      m_first_on_edge[edge_of(p.halfedge)] = p.next_on_edge;
    else
      m_passages[p.previous_on_edge].next_on_edge = p.next_on_edge;
    if (p.next_on_edge != null)
      m_passages[p.next_on_edge].previous_on_edge = p.previous_on_edge;
    m_free.push_back(i);
  }

  std::vector<Passage> m_passages;
  std::vector<int> m_free;
  std::vector<int> m_first;         // per loop
  std::vector<int> m_first_on_edge; // per edge
  std::vector<int> m_entries;       // scratch of flip()
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_DUAL_LOOPS_H
