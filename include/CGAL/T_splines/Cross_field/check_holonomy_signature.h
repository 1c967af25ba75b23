// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H
#define CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/internal/Closed_mesh.h>
#include <CGAL/T_splines/Cross_field/internal/homology_classes.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// Looks for cones and loops that are not of the mesh. Handles of some graphs must not be hashed if they are null.
template <typename TriangleMesh>
void check_descriptors(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                       Holonomy_signature_report<TriangleMesh>& report)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  Claimed_descriptors<typename Traits::vertex_descriptor> claimed_vertices;
  for (const auto& cone : signature.cones())
    if (cone.first != Traits::null_vertex())
      claimed_vertices.insert(cone.first);
  claimed_vertices.find_in(CGAL::make_range(vertices(mesh)));
  for (std::size_t i = 0; i < signature.cones().size(); ++i) {
    report.index = i;
    if (signature.cones()[i].first == Traits::null_vertex())
      report.status = Holonomy_signature_status::NULL_VERTEX;
    else if (claimed_vertices.is_foreign(signature.cones()[i].first))
      report.status = Holonomy_signature_status::FOREIGN_VERTEX;
    if (!report.success())
      return;
  }
  Claimed_descriptors<typename Traits::halfedge_descriptor> claimed_halfedges;
  for (const auto& loop : signature.loops())
    for (const auto h : loop.halfedges)
      if (h != Traits::null_halfedge())
        claimed_halfedges.insert(h);
  claimed_halfedges.find_in(CGAL::make_range(halfedges(mesh)));
  for (std::size_t i = 0; i < signature.loops().size(); ++i)
    for (const auto h : signature.loops()[i].halfedges)
      if (h != Traits::null_halfedge() && claimed_halfedges.is_foreign(h)) {
        report.status = Holonomy_signature_status::FOREIGN_LOOP;
        report.index = i;
        return;
      }
}

// Sorts the loops by components, as strips of indices.
template <typename TriangleMesh>
std::vector<std::vector<std::vector<int>>> checked_strips(const Closed_mesh<TriangleMesh>& mesh,
                                                          const Holonomy_signature<TriangleMesh>& signature,
                                                          Holonomy_signature_report<TriangleMesh>& report)
{
  std::vector<std::vector<std::vector<int>>> strips(mesh.m_components.size());
  for (std::size_t i = 0; i < signature.loops().size(); ++i) {
    std::vector<int> strip;
    bool is_valid = true;
    for (const auto h : signature.loops()[i].halfedges) {
      is_valid = is_valid && h != boost::graph_traits<TriangleMesh>::null_halfedge();
      if (is_valid)
        strip.push_back(mesh.m_indexing.halfedge_index(h));
    }
    if (!is_valid || !is_closed_strip(mesh.m_connectivity, strip)) {
      report.status = Holonomy_signature_status::INVALID_LOOP;
      report.index = i;
      return strips;
    }
    strips[mesh.m_components.of_face[mesh.m_connectivity.face(strip.front())]].push_back(std::move(strip));
  }
  return strips;
}

template <typename TriangleMesh>
void check_loops(const Closed_mesh<TriangleMesh>& mesh, const Holonomy_signature<TriangleMesh>& signature,
                 Progress& progress, Holonomy_signature_report<TriangleMesh>& report)
{
  const std::vector<std::vector<std::vector<int>>> strips = checked_strips(mesh, signature, report);
  if (!report.success())
    return;
  const std::vector<double> dual_length = dual_edge_lengths(mesh.m_connectivity, mesh.m_geometry);
  std::vector<std::vector<int>> faces(mesh.m_components.size());
  for (int f = 0; f < mesh.m_connectivity.number_of_faces(); ++f)
    faces[mesh.m_components.of_face[f]].push_back(f);
  for (int c = 0; c < mesh.m_components.size(); ++c) {
    const int expected = 2 * mesh.m_components.genus(c), actual = static_cast<int>(strips[c].size());
    if (actual != expected)
      report.status = Holonomy_signature_status::WRONG_NUMBER_OF_LOOPS;
    else if (!generate_homology(mesh.m_connectivity, dual_length, faces[c], strips[c], progress))
      report.status = Holonomy_signature_status::DEPENDENT_LOOPS;
    if (!report.success()) {
      report.expected = expected;
      report.actual = actual;
      mesh.name_component(c, report);
      return;
    }
    progress.progress(static_cast<double>(c + 1) / mesh.m_components.size());
  }
}

// What `check_holonomy_signature()` does; no stage is begun.
template <typename TriangleMesh, typename NamedParameters>
Holonomy_signature_report<TriangleMesh> holonomy_signature_report(const TriangleMesh& mesh,
                                                                  const Holonomy_signature<TriangleMesh>& signature,
                                                                  const NamedParameters& np, Progress& progress)
{
  Holonomy_signature_report<TriangleMesh> report;
  report.mesh = check_closed_mesh(mesh, np, progress);
  if (!report.mesh.success()) {
    report.status = Holonomy_signature_status::INVALID_MESH;
    return report;
  }
  internal::check_descriptors(mesh, signature, report);
  if (!report.success())
    return report;
  const Closed_mesh<TriangleMesh> closed_mesh(mesh, np);
  progress.go_on();
  closed_mesh.check_cones(signature, report);
  if (report.success())
    check_loops(closed_mesh, signature, progress, report);
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// checks whether a holonomy signature is admissible on a mesh: the mesh is valid and has the signature's elements, every vertex has at least one quarter
/// turn, the theorem of Gauss and Bonnet holds in each connected component, and each component has 2g loops that are
/// closed strips and generate its homology over the integers.
///
/// How large the numbers may be for a given triangulation is another question: the computation of the map answers it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh
/// \param signature may name elements that `mesh` does not have, or does not have any more
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
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status INVALID_MESH, NULL_VERTEX, FOREIGN_VERTEX, FOREIGN_LOOP, NON_POSITIVE_CONE, GAUSS_BONNET_VIOLATED,
///         INVALID_LOOP, WRONG_NUMBER_OF_LOOPS, DEPENDENT_LOOPS, INTERRUPTED or VALID.
/// Complexity: O(n log n) in the number of faces, and O(g^3) per component.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Holonomy_signature_report<TriangleMesh>
check_holonomy_signature(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("signature check");
  Holonomy_signature_report<TriangleMesh> report = internal::holonomy_signature_report(mesh, signature, np, progress);
  if (progress.is_interrupted())
    report.status = Holonomy_signature_status::INTERRUPTED;
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H
