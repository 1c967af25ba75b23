// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SIMILARITY_METRIC_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SIMILARITY_METRIC_H

#include <CGAL/T_splines/Similarity_map/Similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/internal/converged_metric.h>

#include <vector>

namespace CGAL {
namespace T_splines {

/// computes the flat metric with cones that is discretely conformal to a closed triangle mesh and has a prescribed
/// holonomy signature, without laying it out: the angle at each vertex is k_v pi/2, the turning of each loop k pi/2.
///
/// The method is Newton's on a convex energy, on an intrinsic triangulation that is flipped as the metric moves ([CZ17]
/// section 7, with the symmetric form of eq. (6), (7) and, by default, ideal Delaunay flips).
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FT a floating-point type into which the computation's numbers are converted
/// \param mesh a closed triangle mesh, of one or more components
/// \param signature an admissible signature of `mesh`
/// \param metric the result; written only if the status is CONVERGED
/// \param np named parameters:
///   `vertex_point_map`; `geom_traits`; `visitor` (see `Progress_visitor`); `sparse_linear_solver` (a model of
///   `SparseSpdSolverTraits`);
///   `number_of_iterations` (default 100);
///   `T_splines::parameters::residual_tolerance(double)`: on the largest deviation, in radians (default 1e-12);
///   `T_splines::parameters::flip_policy`: `Ideal_delaunay_flips` (default) or `Degeneracy_flips`;
///   `T_splines::parameters::number_type(FT())`: the type to compute in (default `double`; wider types follow where
///   `double` comes to a floor above the tolerance or stalls: the status is not CONVERGED before the tolerance is met).
/// \return what was done. Complexity: a sparse factorization of n rows for n vertices, usually 4 to 7 iterations of O(n
///   log n).
template <typename TriangleMesh, typename FT, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Similarity_map_report<TriangleMesh>
compute_similarity_metric(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                          Similarity_metric<TriangleMesh, FT>& metric,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  return internal::converged_metric(
      mesh, signature, false, np, indexing, [&](const internal::Metric_input&, const auto& computation) {
        const auto convert = [](const auto& from) {
          std::vector<FT> to;
          to.reserve(from.size());
          for (const auto& x : from)
            to.push_back(static_cast<FT>(x));
          return to;
        };
        std::vector<FT> log_scale = convert(computation.coefficients);
        log_scale.resize(indexing.number_of_vertices());
        std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
        for (int v = 0; v < indexing.number_of_vertices(); ++v)
          vertices.push_back(indexing.vertex(v));
        metric = Similarity_metric<TriangleMesh, FT>(computation.structure.mesh, std::move(vertices),
                                                     convert(computation.structure.log_length),
                                                     convert(computation.structure.form), std::move(log_scale));
        return true;
      });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SIMILARITY_METRIC_H
