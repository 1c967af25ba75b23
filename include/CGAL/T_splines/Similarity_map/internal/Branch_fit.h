// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BRANCH_FIT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BRANCH_FIT_H

#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The similarity with a rotation by quarter turns that fits the two sides of a branch of the cut best, in doubles.
class Branch_fit {
  using Index = Triangulation_connectivity::Index;
  using Number = Plane_vector<double>;

public:
  /// \pre no edge of the branch has length zero
  Branch_fit(const Triangulation_connectivity& mesh, const Uv_array& uv, const Cut_graph& graph, const int branch)
    : m_mesh(&mesh),
      m_uv(&uv),
      m_graph(&graph),
      m_branch(branch)
  {
    fit_linear_part();
    const Number t = translation(m_scale);
    std::tie(m_deviation, m_worst_halfedge) = deviation_from(m_scale, t);
  }

  int quarter_turns() const { return m_quarter_turns; }
  double scale() const { return m_scale; }

  /// The largest deviation of a corner from the similarity, relative to the largest coordinate.
  double deviation() const { return m_deviation; }
  /// The edge, as a halfedge of the branch, that has it.
  Index worst_halfedge() const { return m_worst_halfedge; }

  /// How uncertain the scale factor is if coordinates are off by `noise`, relative to the largest coordinate.
  double scale_uncertainty(const double noise) const { return noise * m_size_by_extent; }

  /// The length of the shortest edge on the side on which the transition ends.
  double shortest_edge() const { return m_shortest_edge; }

  /// The rotation across a halfedge in radians less the nearest number of quarter turns, and that number.
  std::pair<double, int> rotation_of_edge(const Index h) const
  {
    const Number z = edge_there(h) * edge_here(h).conjugate();
    const double angle = std::atan2(z.v, z.u), quarter = 2 * std::atan(1.), turns = std::round(angle / quarter);
    return {angle - turns * quarter, (static_cast<int>(turns) + 4) % 4};
  }

  /// How far a rotation may be read off wrongly if coordinates are off by `noise`, relative to the largest coordinate.
  double rotation_uncertainty(const Index h, const double noise) const
  {
    const double here = std::sqrt(edge_here(h).squared_norm()), there = std::sqrt(edge_there(h).squared_norm());
    return noise * (1 + m_size_here / here + m_size_there / there);
  }

  /// The translation that goes best with another scale factor: shorter edges have more weight.
  Number translation(const double scale) const
  {
    const Number origin_here = here_at_source(0), origin_there = there_at_source(0);
    Number sum;
    double weights = 0;
    for_each_point([&](const Number& here, const Number& there, const Index h) {
      const double weight = 1 / edge_here(h).squared_norm();
      sum = sum + ((there - origin_there) - (here - origin_here).turned(m_quarter_turns) * scale) * weight;
      weights += weight;
    });
    return sum * (1 / weights) + origin_there - origin_here.turned(m_quarter_turns) * scale;
  }

  /// The largest deviation of a corner from the similarity with another scale factor and translation, relative to the
  /// largest coordinate, and the edge that has it.
  std::pair<double, Index> deviation_from(const double scale, const Number& translation) const
  {
    std::pair<double, Index> worst(0, m_graph->halfedge(m_branch, 0));
    for_each_point([&](const Number& here, const Number& there, const Index h) {
      const Number d = there - (here.turned(m_quarter_turns) * scale + translation);
      const double deviation = std::sqrt(d.squared_norm()) / std::max(m_size_there, m_scale * m_size_here);
      if (!(deviation <= worst.first) && !std::isnan(worst.first)) // what is not a number is worst
        worst = {deviation, h};
    });
    return worst;
  }

private:
  static Number number(const std::array<double, 2>& p) { return {p[0], p[1]}; }
  Number corner(const Index h) const { return number((*m_uv)[h]); }
  Number edge_here(const Index h) const { return corner(h) - corner(m_mesh->previous(h)); }
  Number edge_there(const Index h) const { return corner(m_mesh->previous(opposite(h))) - corner(opposite(h)); }
  Number here_at_source(const int i) const { return corner(m_mesh->previous(m_graph->halfedge(m_branch, i))); }
  Number there_at_source(const int i) const { return corner(opposite(m_graph->halfedge(m_branch, i))); }

  // The two ends of each edge, on both sides.
  template <typename Visit>
  void for_each_point(const Visit& visit) const
  {
    for (int i = 0; i < m_graph->length(m_branch); ++i) {
      const Index h = m_graph->halfedge(m_branch, i);
      visit(here_at_source(i), there_at_source(i), h);
      visit(corner(h), corner(m_mesh->previous(opposite(h))), h);
    }
  }

  void fit_linear_part()
  {
    const Number origin_here = here_at_source(0), origin_there = there_at_source(0);
    Number mean_here, mean_there;
    double n = 0, extent_here = 0, extent_there = 0;
    for_each_point([&](const Number& here, const Number& there, const Index h) {
      const Number a = here - origin_here, b = there - origin_there;
      mean_here = mean_here + a;
      mean_there = mean_there + b;
      extent_here = std::max(extent_here, a.squared_norm());
      extent_there = std::max(extent_there, b.squared_norm());
      m_size_here = std::max({m_size_here, std::abs(here.u), std::abs(here.v)});
      m_size_there = std::max({m_size_there, std::abs(there.u), std::abs(there.v)});
      m_shortest_edge = std::min(m_shortest_edge, std::sqrt(edge_there(h).squared_norm()));
      ++n;
    });
    mean_here = mean_here * (1 / n);
    mean_there = mean_there * (1 / n);
    Number moment;
    double norm = 0;
    for_each_point([&](const Number& here, const Number& there, Index) {
      const Number a = here - origin_here - mean_here, b = there - origin_there - mean_there;
      moment = moment + b * a.conjugate();
      norm += a.squared_norm();
    });
    m_size_by_extent = m_size_here / std::sqrt(extent_here) + m_size_there / std::sqrt(extent_there);
    const double quarter = 2 * std::atan(1.);
    m_quarter_turns = (static_cast<int>(std::round(std::atan2(moment.v, moment.u) / quarter)) + 4) % 4;
    m_scale = moment.turned((4 - m_quarter_turns) % 4).u / norm;
  }

  const Triangulation_connectivity* m_mesh;
  const Uv_array* m_uv;
  const Cut_graph* m_graph;
  int m_branch;
  int m_quarter_turns = 0;
  double m_scale = 1;
  double m_size_here = 0, m_size_there = 0; // largest coordinates
  double m_size_by_extent = 0;
  double m_shortest_edge = std::numeric_limits<double>::infinity();
  double m_deviation = 0;
  Index m_worst_halfedge = Triangulation_connectivity::null;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_BRANCH_FIT_H
