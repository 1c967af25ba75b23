// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SPLIT_TARGETS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SPLIT_TARGETS_H

#include <CGAL/T_splines/Cross_field/internal/Edge_distances.h>
#include <CGAL/T_splines/Cross_field/internal/Scale_energy.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Vertices to which quarter turns of cones may go, when these are split: those that are nearest to each cone, but a
/// distance apart from one another, and the sharpest corners of the components.
///
/// On coarse meshes, as boxes of twelve triangles, cross fields have too few degrees of freedom: two corners of three
/// quarter turns may come out as one of two and one regular vertex.
/// \param cones those to be split, which are vertices
/// \param spacing per component: the distance
/// \param most how many there are at most, about
/// \param progress if it is interrupted, there are fewer
/// Complexity: a search around each cone and each vertex found.
inline std::vector<int> split_targets(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                                      const Mesh_components& components, const std::vector<int>& cones,
                                      const std::vector<double>& spacing, const std::size_t most, Progress& progress)
{
  constexpr double sharp = CGAL_PI / 8;
  std::vector<char> has_cones(components.size(), 0);
  for (const int cone : cones)
    has_cones[components.of_vertex[cone]] = 1;
  const std::vector<double> defect = angle_defects(mesh, geometry);
  std::vector<char> is_near(mesh.number_of_vertices(), 0); // to a target, or on the border: there are no cones
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) == Triangulation_connectivity::null)
      is_near[mesh.target(h)] = 1;
  std::vector<int> targets;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    if (has_cones[components.of_vertex[v]] && is_near[v] == 0 && std::abs(defect[v]) > sharp)
      targets.push_back(v);
  std::stable_sort(targets.begin(), targets.end(),
                   [&](const int v, const int w) { return std::abs(defect[v]) > std::abs(defect[w]); });
  targets.resize((std::min)(targets.size(), most / 2));

  Edge_distances distances(mesh, geometry.m_edge_length), to_target(mesh, geometry.m_edge_length);
  const std::size_t most_per_cone = (most / 2 + cones.size() - 1) / cones.size();
  for (const int cone : cones) {
    std::size_t number = 0;
    distances.search(cone, [&](const int v, double) {
      if (is_near[v] != 0)
        return progress.go_on_after(10);
      to_target.search(v, [&](const int w, const double distance) {
        const bool is_within = distance < spacing[components.of_vertex[v]];
        if (is_within)
          is_near[w] = 1;
        return progress.go_on_after(10) && is_within;
      });
      targets.push_back(v);
      return ++number < most_per_cone && !progress.is_interrupted();
    });
    if (progress.is_interrupted())
      break;
  }
  return targets;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SPLIT_TARGETS_H
