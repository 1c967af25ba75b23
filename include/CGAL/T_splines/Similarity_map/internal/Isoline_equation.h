// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_EQUATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_EQUATION_H

#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Free_points.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_search.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A real linear function of complex unknowns: the sum of the real parts of weights times unknowns.
///
/// The unknowns are the translations of the branches of a cut, followed by the free points.
template <typename FT>
class Linear_function {
public:
  using Number = Plane_vector<FT>;

  explicit Linear_function(const int number_of_unknowns) : m_weight(number_of_unknowns), m_is_used(number_of_unknowns)
  {
  }

  void add(const int unknown, const Number& weight)
  {
    if (m_is_used[unknown] == 0)
      m_used.push_back(unknown);
    m_is_used[unknown] = 1;
    m_weight[unknown] = m_weight[unknown] + weight;
  }

  const Number& weight(const int unknown) const { return m_weight[unknown]; }
  void set_zero(const int unknown) { m_weight[unknown] = Number(); }

  void clear()
  {
    for (const int unknown : m_used) {
      m_weight[unknown] = Number();
      m_is_used[unknown] = 0;
    }
    m_used.clear();
  }

  /// The unknowns that have had a weight since the last `clear()`.
  const std::vector<int>& used() const { return m_used; }

private:
  std::vector<Number> m_weight; // per unknown
  std::vector<char> m_is_used;
  std::vector<int> m_used;
};

/// Makes equations of coincidences: the coordinate of the isoline of the first cone, carried along the way, less the
/// coordinate of the second cone, by the translations of the branches and the free points.
template <typename FT>
class Isoline_equation {
  using Index = Triangulation_connectivity::Index;
  using Number = Plane_vector<FT>;

public:
  /// \param scale, inverse_scale per branch
  Isoline_equation(const Cut_map& map, const Free_points& points, const std::vector<FT>& scale,
                   const std::vector<FT>& inverse_scale)
    : m_map(map),
      m_points(points),
      m_scale(scale),
      m_inverse_scale(inverse_scale)
  {
  }

  void add_to(const Isoline_coincidence& coincidence, Linear_function<FT>& sum) const
  {
    // The real part of this number times a point is the coordinate of the point.
    Number factor = coincidence.axis == 0 ? Number{FT(1), FT(0)} : Number{FT(0), FT(-1)};
    add_point(coincidence.start, factor, sum);
    for (const Index h : coincidence.crossed) {
      const int b = m_map.graph.branch_of_edge(edge_of(h));
      if (m_map.graph.is_along(h)) {
        factor = factor * inverse_linear_part(b);
        sum.add(b, factor);
      }
      else {
        sum.add(b, -factor);
        factor = factor * linear_part(b);
      }
    }
    add_point(coincidence.end, -factor, sum);
  }

private:
  Number linear_part(const int b) const { return Number{m_scale[b], FT(0)}.turned(m_map.fits[b].quarter_turns()); }
  Number inverse_linear_part(const int b) const
  {
    return Number{m_inverse_scale[b], FT(0)}.turned((4 - m_map.fits[b].quarter_turns()) % 4);
  }

  // Replaces a point in the chart of the opposite of h by the point in the chart of h.
  void pull_back(const Index h, Number& factor, Linear_function<FT>& sum) const
  {
    const int b = m_map.graph.branch_of_edge(edge_of(h));
    if (m_map.graph.is_along(h)) {
      sum.add(b, factor);
      factor = factor * linear_part(b);
    }
    else {
      factor = factor * inverse_linear_part(b);
      sum.add(b, -factor);
    }
  }

  // Adds the real part of a number times the point in the chart of a corner.
  void add_point(const Index corner, Number factor, Linear_function<FT>& sum) const
  {
    const Index v = m_map.mesh.target(corner);
    const int p = m_points.at_vertex(v), i = p == Free_points::none ? m_map.entry_of_vertex(v) : m_points[p].entry;
    if (i == Free_points::none)
      return sum.add(m_map.graph.number_of_branches() + p, factor);
    const Cut_sectors& sectors = m_map.sectors;
    const int first = sectors.first_sector[i], n = sectors.number_of_sectors(i);
    int k = m_map.sector_of_corner(i, corner);
    if (p == Free_points::none) {
      // The fixed point of the transitions around the vertex.
      Number around{FT(1), FT(0)};
      const Number one = around;
      for (int j = 0; j < n; ++j) {
        const Index h = opposite(sectors.halfedge[first + j]);
        const int r = m_map.fits[m_map.graph.branch_of_edge(edge_of(h))].quarter_turns();
        around = around.turned(m_map.graph.is_along(h) ? r : (4 - r) % 4);
      }
      factor = factor * (one - around).inverse();
      for (int j = 0; j < n; ++j, k = (k + n - 1) % n)
        pull_back(opposite(sectors.halfedge[first + k]), factor, sum);
      return;
    }
    if (sectors.is_on_border[i])
      for (; k < m_points[p].sector; ++k)
        pull_back(sectors.halfedge[first + k + 1], factor, sum);
    else
      for (; k != m_points[p].sector; k = (k + n - 1) % n)
        pull_back(opposite(sectors.halfedge[first + k]), factor, sum);
    sum.add(m_map.graph.number_of_branches() + p, factor);
  }

  const Cut_map& m_map;
  const Free_points& m_points;
  const std::vector<FT>&m_scale, &m_inverse_scale; // per branch
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINE_EQUATION_H
