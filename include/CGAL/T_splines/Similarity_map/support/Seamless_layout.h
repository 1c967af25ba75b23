// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_SUPPORT_SEAMLESS_LAYOUT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_SUPPORT_SEAMLESS_LAYOUT_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/internal/Enclosed_number.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/number_type_basic.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A seamless map in index arrays: corners in charts, and the transitions between the charts.
///
/// The corner of a halfedge is its target in the chart of its face. A corner is a pair of doubles, unless a transition
/// determines it: then it is a pair of numbers of the type `FT`, shared by all corners of its vertex in its chart.
/// \tparam FT the number type of the transitions; exact, or double for a map that is seamless up to round-off
template <typename FT>
class Seamless_layout {
public:
  using Index = Triangulation_connectivity::Index;
  using Transition = Similarity_2<FT>;
  static constexpr int none = -1;

  /// A corner that is not a pair of doubles.
  struct Determined_corner {
    std::array<FT, 2> value;
    std::array<std::pair<double, double>, 2> interval;
  };

  /// All corners are doubles, and there is no cut.
  Seamless_layout(Triangulation_connectivity mesh, std::vector<std::array<double, 2>> uv)
    : m_mesh(std::move(mesh)),
      m_uv(std::move(uv)),
      m_determined_index(m_mesh.number_of_halfedges(), none),
      m_branch(m_mesh.number_of_edges(), none),
      m_is_along(m_mesh.number_of_edges(), 1),
      m_quarter_turns(m_mesh.number_of_vertices(), 4)
  {
  }
  Seamless_layout() = default;

  const Triangulation_connectivity& mesh() const { return m_mesh; }

  /// The corner of `h` in doubles: exactly, or else within an ulp or two.
  const std::array<double, 2>& uv(const Index h) const { return m_uv[h]; }

  /// The same, per halfedge.
  const std::vector<std::array<double, 2>>& coordinates() const { return m_uv; }

  bool is_double(const Index h) const { return m_determined_index[h] == none; }

  /// The coordinate of the corner of `h`. \param axis 0 for u, 1 for v
  Enclosed_number<FT> coordinate(const Index h, const int axis) const
  {
    const int i = m_determined_index[h];
    if (i == none)
      return {m_uv[h][axis], m_uv[h][axis], nullptr};
    const Determined_corner& corner = m_determined[i];
    return {corner.interval[axis].first, corner.interval[axis].second, &corner.value[axis]};
  }

  int number_of_determined_corners() const { return static_cast<int>(m_determined.size()); }
  int number_of_branches() const { return static_cast<int>(m_transitions.size()); }

  /// Whether an inner edge was to lie on an isoline, and does.
  bool is_constrained(const Index edge) const { return !m_is_constrained.empty() && m_is_constrained[edge] != 0; }
  bool has_constrained_edges() const { return !m_is_constrained.empty(); }
  /// The same, per edge, or empty.
  const std::vector<char>& constrained_edges() const { return m_is_constrained; }

  bool is_cut(const Index edge) const { return m_branch[edge] != none; }
  int branch(const Index edge) const { return m_branch[edge]; }

  /// Whether the transition of `h` is that of the branch of its edge; else it is the inverse. \pre the edge is cut
  bool is_along_branch(const Index h) const { return (m_is_along[edge_of(h)] != 0) == is_along_edge(h); }

  /// The transition of a branch.
  const Transition& transition_of_branch(const int branch) const { return m_transitions[branch]; }

  /// The transition from the chart of the face of `h` to that of its opposite's face. \pre the edge of `h` is cut
  const Transition& transition(const Index h) const
  {
    const Index edge = edge_of(h);
    CGAL_precondition(is_cut(edge));
    return (is_along_branch(h) ? m_transitions : m_inverse_transitions)[m_branch[edge]];
  }

  /// The rotation of the transition of any inner halfedge, in quarter turns.
  int rotation(const Index h) const { return is_cut(edge_of(h)) ? transition(h).quarter_turns() : 0; }

  /// The cone angle of a vertex in quarter turns: 4 if it is regular; on the border the angle, 2 if it is regular.
  int quarter_turns(const Index vertex) const { return m_quarter_turns[vertex]; }

  // What the construction sets.
  void clear_branches_and_determined()
  {
    m_determined.clear();
    m_transitions.clear();
    m_inverse_transitions.clear();
  }
  void set_uv(const Index h, const std::array<double, 2>& uv)
  {
    m_uv[h] = uv;
    m_determined_index[h] = none;
  }
  void set_determined(const Index h, const int corner)
  {
    m_determined_index[h] = corner;
    for (int axis = 0; axis < 2; ++axis) {
      const std::pair<double, double>& interval = m_determined[corner].interval[axis];
      m_uv[h][axis] = interval.first + (interval.second - interval.first) / 2;
    }
  }
  int add_determined(FT u, FT v)
  {
    const std::array<std::pair<double, double>, 2> interval = {{CGAL::to_interval(u), CGAL::to_interval(v)}};
    m_determined.push_back({{{std::move(u), std::move(v)}}, interval});
    return number_of_determined_corners() - 1;
  }
  int add_branch(const Transition& transition)
  {
    m_transitions.push_back(transition);
    m_inverse_transitions.push_back(transition.inverse());
    return number_of_branches() - 1;
  }
  /// The branch's transition becomes that of `h`.
  void set_branch(const Index h, const int branch)
  {
    m_branch[edge_of(h)] = branch;
    m_is_along[edge_of(h)] = is_along_edge(h);
  }
  void set_constrained_edges(std::vector<char> is_constrained) { m_is_constrained = std::move(is_constrained); }
  void set_quarter_turns(const Index vertex, const int k) { m_quarter_turns[vertex] = k; }

private:
  Triangulation_connectivity m_mesh;
  std::vector<std::array<double, 2>> m_uv; // per halfedge
  std::vector<int> m_determined_index;     // per halfedge
  std::vector<Determined_corner> m_determined;
  std::vector<int> m_branch;                                    // per edge
  std::vector<char> m_is_along;                                 // per edge
  std::vector<Transition> m_transitions, m_inverse_transitions; // per branch
  std::vector<int> m_quarter_turns;                             // per vertex
  std::vector<char> m_is_constrained;                           // per edge, or empty
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_SUPPORT_SEAMLESS_LAYOUT_H
