// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H
#define CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
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

// Looks for the vertices of cones or corners that are not of the mesh. Handles of some graphs must not be hashed if they
// are null.
template <typename TriangleMesh, typename Numbers>
void check_vertices(const TriangleMesh& mesh, const Numbers& numbers, const bool are_corners,
                    Holonomy_signature_report<TriangleMesh>& report)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  const auto claimed = claimed_vertices(mesh, numbers);
  for (std::size_t i = 0; i < numbers.size() && report.success(); ++i) {
    report.index = i;
    report.is_corner = are_corners;
    if (numbers[i].first == Traits::null_vertex())
      report.status = Holonomy_signature_status::NULL_VERTEX;
    else if (claimed.is_foreign(numbers[i].first))
      report.status = Holonomy_signature_status::FOREIGN_VERTEX;
  }
}

// Looks for the halfedges of loops or arcs that are not of the mesh.
template <typename TriangleMesh, typename Strips>
void check_halfedges(const TriangleMesh& mesh, const Strips& strips, const Holonomy_signature_status foreign,
                     Holonomy_signature_report<TriangleMesh>& report)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  Claimed_descriptors<typename Traits::halfedge_descriptor> claimed;
  for (const auto& strip : strips)
    for (const auto h : strip.halfedges)
      if (h != Traits::null_halfedge())
        claimed.insert(h);
  claimed.find_in(CGAL::make_range(halfedges(mesh)));
  for (std::size_t i = 0; i < strips.size(); ++i)
    for (const auto h : strips[i].halfedges)
      if (report.success() && h != Traits::null_halfedge() && claimed.is_foreign(h)) {
        report.status = foreign;
        report.index = i;
      }
}

template <typename TriangleMesh>
void check_descriptors(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                       Holonomy_signature_report<TriangleMesh>& report)
{
  check_vertices(mesh, signature.cones(), false, report);
  if (report.success())
    check_vertices(mesh, signature.corners(), true, report);
  if (report.success())
    check_halfedges(mesh, signature.loops(), Holonomy_signature_status::FOREIGN_LOOP, report);
  if (report.success())
    check_halfedges(mesh, signature.arcs(), Holonomy_signature_status::FOREIGN_ARC, report);
}

// The halfedges of a loop or arc in indices; empty if one is null.
template <typename TriangleMesh, typename Strip>
std::vector<int> strip_in_indices(const Signature_domain<TriangleMesh>& mesh, const Strip& strip)
{
  std::vector<int> result;
  for (const auto h : strip.halfedges) {
    if (h == boost::graph_traits<TriangleMesh>::null_halfedge())
      return {};
    result.push_back(mesh.m_indexing.halfedge_index(h));
  }
  return result;
}

// Sorts the loops by components, as strips of indices.
template <typename TriangleMesh>
std::vector<std::vector<std::vector<int>>> checked_strips(const Signature_domain<TriangleMesh>& mesh,
                                                          const Holonomy_signature<TriangleMesh>& signature,
                                                          Holonomy_signature_report<TriangleMesh>& report)
{
  std::vector<std::vector<std::vector<int>>> strips(mesh.m_components.size());
  for (std::size_t i = 0; i < signature.loops().size(); ++i) {
    std::vector<int> strip = strip_in_indices(mesh, signature.loops()[i]);
    if (!is_closed_strip(mesh.m_connectivity, strip)) {
      report.status = Holonomy_signature_status::INVALID_LOOP;
      report.index = i;
      return strips;
    }
    strips[mesh.m_components.of_face[mesh.m_connectivity.face(strip.front())]].push_back(std::move(strip));
  }
  return strips;
}

template <typename TriangleMesh>
void check_loops(const Signature_domain<TriangleMesh>& mesh, const Holonomy_signature<TriangleMesh>& signature,
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

// Arcs must join the curves of the border of a component to one tree.
template <typename TriangleMesh>
void check_arcs(const Signature_domain<TriangleMesh>& mesh, const Holonomy_signature<TriangleMesh>& signature,
                Holonomy_signature_report<TriangleMesh>& report)
{
  const std::vector<std::vector<int>> curves = border_curves(mesh.m_connectivity);
  const std::vector<int> curve = curves_of_vertices(mesh.m_connectivity, curves);
  Disjoint_sets sets(curves.size());
  std::vector<int> actual(mesh.m_components.size(), 0), joined(mesh.m_components.size(), 0);
  for (std::size_t i = 0; i < signature.arcs().size(); ++i) {
    const std::vector<int> strip = strip_in_indices(mesh, signature.arcs()[i]);
    if (!is_strip_across(mesh.m_connectivity, strip)) {
      report.status = Holonomy_signature_status::INVALID_ARC;
      report.index = i;
      return;
    }
    const int first = mesh.m_connectivity.target(strip.front()), last = mesh.m_connectivity.target(strip.back());
    ++actual[mesh.m_components.of_vertex[first]];
    joined[mesh.m_components.of_vertex[first]] += sets.join(curve[first], curve[last]) ? 1 : 0;
  }
  for (int c = 0; c < mesh.m_components.size(); ++c) {
    const int expected = (std::max)(0, mesh.m_components.number_of_borders[c] - 1);
    if (joined[c] == expected && actual[c] == expected)
      continue;
    report.status = actual[c] != expected ? Holonomy_signature_status::WRONG_NUMBER_OF_ARCS
                                          : Holonomy_signature_status::DEPENDENT_ARCS;
    report.expected = expected;
    report.actual = actual[c];
    mesh.name_component(c, report);
    return;
  }
}

// What `check_holonomy_signature()` does; no stage is begun.
template <typename TriangleMesh, typename NamedParameters>
Holonomy_signature_report<TriangleMesh> holonomy_signature_report(const TriangleMesh& mesh,
                                                                  const Holonomy_signature<TriangleMesh>& signature,
                                                                  const NamedParameters& np, Progress& progress)
{
  Holonomy_signature_report<TriangleMesh> report;
  report.mesh = triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success()) {
    report.status = Holonomy_signature_status::INVALID_MESH;
    return report;
  }
  internal::check_descriptors(mesh, signature, report);
  if (!report.success())
    return report;
  const Signature_domain<TriangleMesh> domain(mesh, np);
  progress.go_on();
  domain.check_cones(signature, report);
  if (report.success())
    check_arcs(domain, signature, report);
  if (report.success())
    check_loops(domain, signature, progress, report);
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// checks whether a holonomy signature is admissible on a mesh: the mesh is valid and has the signature's elements, every vertex has at least one quarter
/// turn, the theorem of Gauss and Bonnet holds in each connected component, each component has 2g loops that are closed
/// strips and generate its homology over the integers, and arcs that join the closed curves of its border to one tree.
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
/// \return the status INVALID_MESH, NULL_VERTEX, FOREIGN_VERTEX, FOREIGN_LOOP, FOREIGN_ARC, CONE_ON_BORDER, CORNER_INSIDE,
///         NON_POSITIVE_CONE, SINGLE_TRIANGLE, GAUSS_BONNET_VIOLATED, INVALID_ARC, WRONG_NUMBER_OF_ARCS, DEPENDENT_ARCS, INVALID_LOOP,
///         WRONG_NUMBER_OF_LOOPS, DEPENDENT_LOOPS, INTERRUPTED or VALID.
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
