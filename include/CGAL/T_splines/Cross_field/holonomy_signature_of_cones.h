// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CONES_H
#define CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CONES_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/internal/Closed_mesh.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename TriangleMesh, typename ConeRange>
void set_cones(const ConeRange& cones, const TriangleMesh& mesh, Holonomy_signature<TriangleMesh>& signature,
               Holonomy_signature_report<TriangleMesh>& report)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  Claimed_descriptors<vertex_descriptor> claimed;
  for (const auto& cone : cones)
    if (cone.first != boost::graph_traits<TriangleMesh>::null_vertex())
      claimed.insert(cone.first);
  claimed.find_in(CGAL::make_range(vertices(mesh)));
  std::unordered_set<vertex_descriptor> known;
  report.index = 0;
  for (const auto& [vertex, k] : cones) {
    report.vertex = vertex;
    report.actual = k;
    if (vertex == boost::graph_traits<TriangleMesh>::null_vertex())
      report.status = Holonomy_signature_status::NULL_VERTEX;
    else if (claimed.is_foreign(vertex))
      report.status = Holonomy_signature_status::FOREIGN_VERTEX;
    else if (!known.insert(vertex).second)
      report.status = Holonomy_signature_status::DUPLICATE_CONE;
    else if (k < 1)
      report.status = Holonomy_signature_status::NON_POSITIVE_CONE;
    if (!report.success())
      return;
    signature.set_quarter_turns(vertex, k);
    ++report.index;
  }
}

template <typename TriangleMesh, typename NamedParameters>
void add_loops(const Closed_mesh<TriangleMesh>& mesh, const NamedParameters& np, Progress& progress,
               Holonomy_signature<TriangleMesh>& signature, Holonomy_signature_report<TriangleMesh>& report)
{
  const auto turning_numbers = CGAL::parameters::get_parameter(np, np_tags::loop_turning_numbers);
  const std::vector<std::vector<int>> loops = mesh.short_loops(progress);
  if (progress.is_interrupted())
    return;
  for (const std::vector<int>& strip : loops) {
    const double turning = strip_turning(mesh.m_connectivity, strip, mesh.m_geometry.m_corner_angle);
    signature.add_loop(mesh.halfedges_of(strip), static_cast<int>(std::round(turning / quarter_turn)));
  }
  if constexpr (!std::is_same_v<std::decay_t<decltype(turning_numbers)>, CGAL::internal_np::Param_not_found>) {
    std::size_t i = 0;
    for (const int k : turning_numbers) {
      if (i < loops.size())
        signature.set_loop_quarter_turns(i, k);
      ++i;
    }
    if (i != loops.size()) {
      report.status = Holonomy_signature_status::WRONG_NUMBER_OF_TURNS;
      report.expected = static_cast<int>(loops.size());
      report.actual = static_cast<int>(i);
    }
  }
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// computes a holonomy signature with given cones.
///
/// The numbers of the loops are those nearest to the turning of the loops in the metric of the mesh, unless they are given.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConeRange a range of pairs of a vertex and its number k >= 1 of quarter turns; vertices that are not mentioned
///         are regular
/// \param mesh a closed triangle mesh, as `check_triangle_mesh()` demands
/// \param cones the cones; for each connected component, 4 - k sums up to four times its Euler characteristic
/// \param signature is cleared and filled with the cones and 2g short loops per component; its contents are meaningful
///        upon success, its loops also with the status WRONG_NUMBER_OF_TURNS. It stays what it was if the status is
///        INTERRUPTED
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
///   \cgalParamNBegin{loop_turning_numbers}
///     \cgalParamDescription{the numbers of the loops}
///     \cgalParamType{a range of integers, one for each loop}
///     \cgalParamDefault{those nearest to the turning of the loops in the metric of the mesh}
///     \cgalParamExtra{The loops of a mesh are always the same, and in the same order.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status INVALID_MESH, NULL_VERTEX, DUPLICATE_CONE, NON_POSITIVE_CONE, GAUSS_BONNET_VIOLATED,
///         WRONG_NUMBER_OF_TURNS, INTERRUPTED or VALID.
/// Complexity: O(n log n) in the number of faces.
template <typename TriangleMesh, typename ConeRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Holonomy_signature_report<TriangleMesh>
holonomy_signature_of_cones(const TriangleMesh& mesh, const ConeRange& cones,
                            Holonomy_signature<TriangleMesh>& signature,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("holonomy signature");
  Holonomy_signature_report<TriangleMesh> report;
  Holonomy_signature<TriangleMesh> result;
  report.mesh = internal::check_closed_mesh(mesh, np, progress);
  if (!report.mesh.success())
    report.status = Holonomy_signature_status::INVALID_MESH;
  else
    internal::set_cones(cones, mesh, result, report);
  if (report.success() && progress.go_on()) {
    const internal::Closed_mesh<TriangleMesh> closed_mesh(mesh, np);
    closed_mesh.check_cones(result, report);
    if (report.success() && progress.go_on())
      internal::add_loops(closed_mesh, np, progress, result, report);
  }
  if (progress.is_interrupted())
    report.status = Holonomy_signature_status::INTERRUPTED;
  else
    signature = std::move(result);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CONES_H
