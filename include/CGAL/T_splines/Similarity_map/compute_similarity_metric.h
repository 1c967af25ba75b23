// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SIMILARITY_METRIC_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_COMPUTE_SIMILARITY_METRIC_H

#include <CGAL/T_splines/Similarity_map/Similarity_metric.h>
#include <CGAL/T_splines/Similarity_map/internal/converged_metric.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// computes the flat metric with cones that is discretely conformal to a triangle mesh and has a prescribed
/// holonomy signature, without laying it out: the angle at each vertex is k_v pi/2, the turning of each loop k pi/2.
///
/// The method is Newton's on a convex energy, on an intrinsic triangulation that is flipped as the metric moves ([CZ17]
/// section 7, with the symmetric form of eq. (6), (7) and, by default, ideal Delaunay flips).
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FT a floating-point type into which the computation's numbers are converted
/// \param mesh a triangle mesh, of one or more components. Of a mesh with border, the metric is that of its double: two
///        copies of `mesh`, sewn together along the border
/// \param signature an admissible signature of `mesh`
/// \param metric the result; written only if the status is CONVERGED
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a geometric traits class}
///     \cgalParamType{a model of `Kernel`}
///     \cgalParamDefault{the kernel of the points, a new object}
///   \cgalParamNEnd
///   \cgalParamNBegin{residual_tolerance}
///     \cgalParamDescription{the largest deviation from the signature that is allowed, in radians, over all vertices
///       and loops}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-12}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the largest number of steps of Newton's method}
///     \cgalParamType{`int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{flip_policy}
///     \cgalParamDescription{how the triangulation follows the metric}
///     \cgalParamType{a model of `FlipPolicy`: `Ideal_delaunay_flips` or `Degeneracy_flips`}
///     \cgalParamDefault{`Ideal_delaunay_flips()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_type}
///     \cgalParamDescription{the number type to compute in; the value does not matter}
///     \cgalParamType{a floating-point type, built in or of Boost.Multiprecision}
///     \cgalParamDefault{`double`}
///     \cgalParamExtra{Wider types follow where `double` comes to a floor above the tolerance or stalls: the status is
///       not CONVERGED before the tolerance is met.}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits` with `FT = double`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done. Complexity: a sparse factorization of n rows for n vertices, usually 4 to 7 iterations of O(n
///   log n).
template <typename TriangleMesh, typename FT, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Similarity_map_report<TriangleMesh>
compute_similarity_metric(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                          Similarity_metric<TriangleMesh, FT>& metric,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  return internal::converged_metric(
      mesh, signature, false, np, indexing, progress, [&](const internal::Metric_input&, const auto& computation) {
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
