// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SECTOR_VALUES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SECTOR_VALUES_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_graph.h>
#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/Similarity_map/internal/Uv_seams.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Instead of the number of a sector: the coordinates of a cone are the fixed point of the transitions around it.
constexpr int fixed_point = -1;

/// Computes the coordinates of one cut vertex in all its sectors.
/// \param transition function object: halfedge -> the transition from the chart of its face to that of its opposite's
/// \param kept the sector, counted from the first of the vertex, whose coordinates are given; or `fixed_point`
/// \param start coordinates in the sector that is kept
/// \param values receives them, per sector of the vertex
/// \return whether the transitions lead back to the value that one started with
template <typename FT, typename Transition_of>
bool compute_sector_values(const Cut_sectors& sectors, const int i, const Transition_of& transition, const int kept,
                           const std::pair<FT, FT>& start, std::vector<std::pair<FT, FT>>& values)
{
  const int first = sectors.first_sector[i], n = sectors.number_of_sectors(i);
  const auto into = [&](const int k) -> decltype(auto) { return transition(opposite(sectors.halfedge[first + k])); };
  values.resize(n);
  if (sectors.is_on_border[i]) {
    values[kept] = start;
    for (int k = kept + 1; k < n; ++k)
      values[k] = into(k)(values[k - 1].first, values[k - 1].second);
    for (int k = kept; k > 0; --k)
      values[k - 1] = transition(sectors.halfedge[first + k])(values[k].first, values[k].second);
    return true;
  }
  const int begin = kept == fixed_point ? 0 : kept;
  if (kept == fixed_point) {
    Similarity_2<FT> around;
    for (int k = 1; k <= n; ++k)
      around = compose(into(k % n), around);
    // Not the identity: 1 - i^r is a divisor of 2.
    const Plane_vector<FT> one{FT(1), FT(0)}, factor = (one - one.turned(around.quarter_turns())).inverse();
    const Plane_vector<FT> z = factor * Plane_vector<FT>{around.u(), around.v()};
    values[0] = {z.u, z.v};
  }
  else
    values[kept] = start;
  for (int k = 1; k < n; ++k) {
    const std::pair<FT, FT>& z = values[(begin + k - 1) % n];
    values[(begin + k) % n] = into((begin + k) % n)(z.first, z.second);
  }
  if (n == 2 && kept != fixed_point) // there and back across the same branch, or two branches made so
    return true;
  const std::pair<FT, FT>& last = values[(begin + n - 1) % n];
  return into(begin)(last.first, last.second) == values[begin];
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SECTOR_VALUES_H
