// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CONES_H
#define CGAL_T_SPLINES_CROSS_FIELD_HOLONOMY_SIGNATURE_OF_CONES_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// Where the border has corners, as the guide sees them.
template <typename TriangleMesh>
void set_corners(const Signature_domain<TriangleMesh>& mesh, const Border_guide& guide,
                 Holonomy_signature<TriangleMesh>& signature)
{
  for (int v = 0; v < mesh.m_connectivity.number_of_vertices(); ++v)
    if (guide.quarter_turns()[v] != Border_guide::regular)
      signature.set_corner_quarter_turns(mesh.m_indexing.vertex(v), guide.quarter_turns()[v]);
}

// Arcs turn as those of the mesh do, up to the next quarter turns.
template <typename TriangleMesh>
void add_arcs(const Signature_domain<TriangleMesh>& mesh, const Border_guide& guide, Progress& progress,
              Holonomy_signature<TriangleMesh>& signature)
{
  const std::vector<double> no_rotation(mesh.m_connectivity.number_of_edges(), 0.);
  for (const std::vector<int>& strip : mesh.short_arcs(progress))
    signature.add_arc(
        mesh.halfedges_of(strip),
        static_cast<int>(std::round(strip_quarter_turns(mesh.m_connectivity, strip, mesh.m_geometry.m_corner_angle,
                                                        no_rotation, guide.deviations()))));
}

template <typename TriangleMesh, typename NamedParameters>
void add_loops(const Signature_domain<TriangleMesh>& mesh, const NamedParameters& np, Progress& progress,
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
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands; it may have a border
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
///   \cgalParamNBegin{corners}
///     \cgalParamDescription{the vertices on the border with other than two quarter turns, and their numbers}
///     \cgalParamType{`std::optional<std::vector<Holonomy_signature<TriangleMesh>::Corner>>`}
///     \cgalParamDefault{`std::nullopt`: where the border turns by more than the corner angle}
///   \cgalParamNEnd
///   \cgalParamNBegin{corner_angle}
///     \cgalParamDescription{by how much the border turns at a corner, in degrees: within the surface, over one part in 64
///       of its length to either side}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_corner_angle`, 50}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status INVALID_MESH, NULL_VERTEX, FOREIGN_VERTEX, DUPLICATE_CONE, NON_POSITIVE_CONE, CONE_ON_BORDER,
///         CORNER_INSIDE, SINGLE_TRIANGLE, GAUSS_BONNET_VIOLATED, WRONG_NUMBER_OF_TURNS, INTERRUPTED or VALID.
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
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success())
    report.status = Holonomy_signature_status::INVALID_MESH;
  if (report.success())
    internal::check_numbered_vertices(mesh, cones, false, report);
  if (report.success())
    internal::check_given_corners(mesh, np, report);
  if (report.success() && progress.go_on()) {
    for (const auto& [vertex, k] : cones)
      result.set_quarter_turns(vertex, k);
    const internal::Signature_domain<TriangleMesh> domain(mesh, np);
    const internal::Border_guide guide = domain.guide(np);
    internal::set_corners(domain, guide, result);
    domain.check_cones(result, report);
    if (report.success() && progress.go_on())
      internal::add_loops(domain, np, progress, result, report);
    if (report.success() && progress.go_on())
      internal::add_arcs(domain, guide, progress, result);
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
