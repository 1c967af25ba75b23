// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINES_OF_CONES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINES_OF_CONES_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/internal/Cut_map.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_corners.h>
#include <CGAL/T_splines/Similarity_map/internal/Exact_transitions.h>
#include <CGAL/T_splines/Similarity_map/internal/Free_points.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_arcs.h>
#include <CGAL/T_splines/Similarity_map/internal/Isoline_search.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Halfedges that point to cones off the cut, to nodes of arcs that are neither cones nor on the border and, on surfaces
/// with neither cones nor border nor arcs, to the vertex that the tracer starts from: their first one. And the quarter
/// turns of these.
/// \param counted the quarter turns of all vertices off the cut
inline std::vector<std::pair<Triangulation_connectivity::Index, int>>
other_free_points(const Cut_map& map, const Isoline_arcs& arcs, const std::vector<int>& counted)
{
  using Index = Triangulation_connectivity::Index;
  const Triangulation_connectivity& mesh = map.mesh;
  std::vector<int> root(mesh.number_of_vertices());
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&root](int v) {
    while (root[v] != v)
      v = root[v] = root[root[v]];
    return v;
  };
  for (Index e = 0; e < mesh.number_of_edges(); ++e) {
    const Index h = halfedge_of_edge(e);
    const int a = root_of(mesh.target(h)), b = root_of(mesh.source(h));
    root[std::max(a, b)] = std::min(a, b);
  }
  const std::vector<Index> outgoing = mesh.outgoing_halfedges();
  std::vector<char> has_start(mesh.number_of_vertices(), 0);
  std::vector<std::pair<Index, int>> result;
  int next_entry = 0;
  for (Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const bool is_cut = next_entry < map.sectors.number_of_vertices() && map.sectors.vertices[next_entry] == v;
    const int i = is_cut ? next_entry++ : Cut_map::none;
    if (i == Cut_map::none ? counted[v] == 4 : !map.sectors.is_on_border[i] && map.quarter_turns[i] == 4)
      continue;
    has_start[root_of(v)] = 1;
    if (i == Cut_map::none)
      result.emplace_back(mesh.previous(outgoing[v]), counted[v]);
  }
  for (const Index corner : arcs.corners_of_nodes()) {
    const int i = map.entry_of_vertex(mesh.target(corner));
    has_start[root_of(mesh.target(corner))] = 1;
    if (i == Cut_map::none ? counted[mesh.target(corner)] == 4
                           : !map.sectors.is_on_border[i] && map.quarter_turns[i] == 4)
      result.emplace_back(corner, 4);
  }
  for (Index v = 0; v < mesh.number_of_vertices(); ++v)
    if (root[v] == v && has_start[v] == 0 && outgoing[v] != mesh.null)
      result.emplace_back(mesh.previous(outgoing[v]), 4);
  return result;
}

/// Isolines that connect cones, or what else motorcycles leave, but for round-off.
/// \param transitions of the map itself
/// \param is_wall per edge: where isolines end; or empty
/// \param noise of coordinates, relative to the largest one
inline std::vector<Isoline_coincidence> nearly_coincident_isolines(const Cut_map& map, const Exact_corners& corners,
                                                                   const Exact_transitions<double>& transitions,
                                                                   const std::vector<char>& is_wall, const double noise,
                                                                   Progress& progress)
{
  using Index = Triangulation_connectivity::Index;
  const Triangulation_connectivity& mesh = map.mesh;
  std::vector<Similarity_2<double>> along, against;
  for (int b = 0; b < map.graph.number_of_branches(); ++b) {
    along.push_back(transitions.transition(b));
    against.push_back(along.back().inverse());
  }
  const auto transition = [&](const Index h) -> const Similarity_2<double>& {
    return (map.graph.is_along(h) ? along : against)[map.graph.branch_of_edge(edge_of(h))];
  };
  using Search = Isoline_search<decltype(transition)>;
  const Free_points& points = corners.points();
  std::vector<typename Search::Cone> cones;
  int number_of_rays = 0;
  const auto add = [&](const Index outgoing, const int k, const bool is_on_border) {
    cones.push_back({outgoing, k, is_on_border});
    number_of_rays += k;
  };
  for (int i = 0; i < map.sectors.number_of_vertices(); ++i)
    if (!map.sectors.is_on_border[i] && map.quarter_turns[i] % 4 != 0)
      add(map.sectors.halfedge[map.sectors.first_sector[i]], map.quarter_turns[i], false);
  for (int p = 0; p < points.size(); ++p) {
    const int i = points[p].entry;
    if (i == Free_points::none)
      add(mesh.next(points[p].corner), points[p].quarter_turns, false);
    else
      add(map.sectors.halfedge[map.sectors.first_sector[i]], map.quarter_turns[i], map.sectors.is_on_border[i] != 0);
  }
  const int longest = 64 + mesh.number_of_faces() / std::max(2 * number_of_rays, 1);
  return Search(mesh, map.uv, map.is_cut, is_wall, transition, cones, noise).run(longest, progress);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_ISOLINES_OF_CONES_H
