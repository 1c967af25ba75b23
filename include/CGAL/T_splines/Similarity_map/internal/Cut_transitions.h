// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_TRANSITIONS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_TRANSITIONS_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Dual_loops.h>
#include <CGAL/T_splines/Similarity_map/internal/Flat_layout.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The transitions across the cut of a layout, one per branch.
///
/// A branch is a maximal path of cut edges whose inner vertices meet two cut edges and have trivial holonomy. Rotations
/// are exact;
/// scale factors are products of exp(c_j) with integer exponents, so exactly 1 off the loops' classes; the translation
/// is the mean over the branch.
template <typename FT>
class Cut_transitions {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param coefficients c per loop
  Cut_transitions(const Triangulation_connectivity& mesh, const Dual_loops& loops, const Flat_layout<FT>& layout,
                  const std::vector<int>& quarter_turns, const std::vector<FT>& coefficients)
    : m_mesh(mesh),
      m_layout(layout),
      m_branch(mesh.number_of_edges(), -1),
      m_is_along(mesh.number_of_edges(), 1)
  {
    // An inner vertex of a branch knows the halfedge of its other cut edge by that of the first. Edges towards faces that
    // are not laid out end branches, but belong to none.
    std::vector<std::vector<Index>> cut_halfedges(mesh.number_of_vertices());
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (layout.is_cut(edge_of(h)))
        cut_halfedges[mesh.source(h)].push_back(h);
    const auto is_inner = [&](const Index v) { return cut_halfedges[v].size() == 2 && quarter_turns[v] % 4 == 0; };
    const auto follow = [&](Index h) {
      std::vector<Index> path;
      const Index first = h;
      while (true) {
        path.push_back(h);
        const Index v = mesh.target(h);
        if (!is_inner(v))
          break;
        h = cut_halfedges[v][cut_halfedges[v][0] == opposite(h) ? 1 : 0];
        if (h == first)
          break;
      }
      add_branch(path, loops, coefficients);
    };
    for (const bool closed : {false, true})
      for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
        if (layout.is_cut_inside(edge_of(h)) && m_branch[edge_of(h)] == -1 && (closed || !is_inner(mesh.source(h))))
          follow(h);
  }

  int number_of_branches() const { return static_cast<int>(m_transitions.size()); }

  /// The number of the branch of a cut edge.
  int branch(const Index edge) const { return m_branch[edge]; }

  /// The transition from the chart of the face of `h` to that of its opposite; the identity if the edge is not cut.
  Similarity_2<FT> transition(const Index h) const
  {
    const int branch = m_branch[edge_of(h)];
    if (branch == -1)
      return Similarity_2<FT>();
    const bool is_along = (m_is_along[edge_of(h)] != 0) == is_along_edge(h);
    return is_along ? m_transitions[branch] : m_transitions[branch].inverse();
  }

private:
  void add_branch(const std::vector<Index>& path, const Dual_loops& loops, const std::vector<FT>& coefficients)
  {
    using std::exp;
    FT log_scale(0);
    bool has_scale = false;
    const std::vector<int> exponents = m_layout.scale_exponents(loops, path.front());
    for (std::size_t j = 0; j < exponents.size(); ++j)
      if (exponents[j] != 0) {
        has_scale = true;
        log_scale += exponents[j] * coefficients[j];
      }
    const int r = m_layout.quarter_turns(path.front());
    const FT scale = has_scale ? FT(exp(log_scale)) : FT(1);
    Plane_vector<FT> translation{};
    for (const Index h : path) {
      const Index g = opposite(h);
      const Plane_vector<FT> at_source = m_layout.position(g) - m_layout.position(m_mesh.previous(h)).turned(r) * scale;
      const Plane_vector<FT> at_target = m_layout.position(m_mesh.previous(g)) - m_layout.position(h).turned(r) * scale;
      translation = translation + (at_source + at_target) * FT(FT(1) / (2 * static_cast<int>(path.size())));
      m_branch[edge_of(h)] = number_of_branches();
      m_is_along[edge_of(h)] = is_along_edge(h) ? 1 : 0;
    }
    m_transitions.emplace_back(r, scale, translation.u, translation.v);
  }

  const Triangulation_connectivity& m_mesh;
  const Flat_layout<FT>& m_layout;
  std::vector<int> m_branch;    // per edge
  std::vector<char> m_is_along; // per edge: the branch runs along its even halfedge
  std::vector<Similarity_2<FT>> m_transitions;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_TRANSITIONS_H
