// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_LOOP_REACH_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_LOOP_REACH_H

#include <CGAL/T_splines/Cross_field/support/homology_loops.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The scale period of a closed strip of triangles, and its length in the hyperbolic metric of Penner's coordinates.
///
/// An ideal Delaunay triangulation of the scaled metric exists only while the first is smaller than the second for
/// every closed curve. Both depend on the homotopy class of the strip alone and do not change under Ptolemy flips.
template <typename FT>
struct Loop_reach {
  double period = 0; ///< logarithm of the scale factor along the strip
  double length = 0; ///< hyperbolic; 0 if the strip surrounds a vertex or nothing

  /// \param strip the halfedges by which it enters its triangles
  Loop_reach(const Similarity_structure<FT>& structure, const std::vector<int>& strip)
  {
    using Index = Triangulation_connectivity::Index;
    const Triangulation_connectivity& mesh = structure.mesh;
    const std::vector<FT>& lambda = structure.log_penner.empty() ? structure.log_length : structure.log_penner;
    // The holonomy in SL(2, R), times exp(log_scale): products of positive matrices, one per turn and one per shear.
    std::array<double, 4> m = {1, 0, 0, 1};
    double log_scale = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
      const Index h = strip[i], exit = opposite(strip[i + 1 == strip.size() ? 0 : i + 1]);
      const bool turns_left = exit == mesh.previous(h);
      if (turns_left) {
        period += static_cast<double>(structure.form_of(mesh.next(h)));
        m[1] += m[0];
        m[3] += m[2];
      }
      else {
        m[0] += m[1];
        m[2] += m[3];
      }
      const Index g = opposite(exit);
      const double shear =
          static_cast<double>(FT(lambda[edge_of(mesh.next(exit))] + lambda[edge_of(mesh.next(g))] -
                                 lambda[edge_of(mesh.previous(exit))] - lambda[edge_of(mesh.previous(g))]));
      // diag(exp(shear / 2), exp(-shear / 2)) with its larger entry taken out
      const double smaller = std::exp(-std::abs(shear)), first = shear > 0 ? 1. : smaller,
                   second = shear > 0 ? smaller : 1.;
      m = {m[0] * first, m[1] * second, m[2] * first, m[3] * second};
      log_scale += std::abs(shear) / 2;
      const double size = m[0] + m[1] + m[2] + m[3];
      for (double& x : m)
        x /= size;
      log_scale += std::log(size);
    }
    const double log_half_trace = std::log(m[0] + m[3]) + log_scale - std::log(2.);
    length = log_half_trace > 300 ? 2 * (log_half_trace + std::log(2.))
                                  : 2 * std::acosh(std::max(1., std::exp(log_half_trace)));
  }

  double ratio() const
  {
    constexpr double round_off = 1e-9; // of a length that is 0
    return length > round_off ? std::abs(period) / length : 0;
  }
};

/// scans short closed strips of the current triangulation and returns the one with the largest ratio of period to
/// length: how close the structure has come to the limit of what its mesh can carry. A scan, not a proof.
/// \param progress if it is interrupted, fewer are scanned
template <typename FT>
Loop_reach<FT> largest_loop_reach(const Similarity_structure<FT>& structure, Progress& progress)
{
  const Triangulation_connectivity& mesh = structure.mesh;
  Loop_reach<FT> result(structure, {});
  const auto consider = [&](const std::vector<int>& strip) {
    const Loop_reach<FT> reach(structure, strip);
    if (reach.ratio() > result.ratio())
      result = reach;
  };
  for (int i = 0; i < structure.loops.number_of_loops(); ++i)
    consider(structure.loops.halfedges(i));
  // Strips across few edges, and strips across edges that scale little.
  std::vector<double> unit(mesh.number_of_edges(), 1.), scale(mesh.number_of_edges());
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    scale[e] = 1 + std::abs(static_cast<double>(structure.form[e]));
  const Mesh_components components = mesh_components(mesh);
  for (const std::vector<double>* weight : {&unit, &scale})
    for (const std::vector<int>& strip : homology_loops(mesh, *weight, components, progress, 16))
      consider(strip);
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_LOOP_REACH_H
