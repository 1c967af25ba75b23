// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H
#define CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/internal/Closed_mesh.h>
#include <CGAL/T_splines/Cross_field/internal/homology_classes.h>
#include <CGAL/T_splines/Cross_field/internal/strip_turning.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

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
                 Holonomy_signature_report<TriangleMesh>& report)
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
    else if (!generate_homology(mesh.m_connectivity, dual_length, faces[c], strips[c]))
      report.status = Holonomy_signature_status::DEPENDENT_LOOPS;
    if (!report.success()) {
      report.expected = expected;
      report.actual = actual;
      mesh.name_component(c, report);
      return;
    }
  }
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// checks whether a holonomy signature is admissible on a mesh: the mesh is valid, every vertex has at least one quarter
/// turn, the theorem of Gauss and Bonnet holds in each connected component, and each component has 2g loops that are
/// closed strips and generate its homology over the integers.
///
/// How large the numbers may be for a given triangulation is another question: the computation of the map answers it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh
/// \param signature vertices and halfedges of it are of `mesh`, or null
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
/// \cgalNamedParamsEnd
///
/// \return the status INVALID_MESH, NULL_VERTEX, NON_POSITIVE_CONE, GAUSS_BONNET_VIOLATED, INVALID_LOOP,
///         WRONG_NUMBER_OF_LOOPS, DEPENDENT_LOOPS or VALID.
///
/// Complexity: O(n log n) in the number of faces, and O(g^3) per component.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Holonomy_signature_report<TriangleMesh>
check_holonomy_signature(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  Holonomy_signature_report<TriangleMesh> report;
  report.mesh = internal::check_closed_mesh(mesh, np);
  if (!report.mesh.success()) {
    report.status = Holonomy_signature_status::INVALID_MESH;
    return report;
  }
  // Not by quarter_turns(): handles of some graphs must not be hashed if they are null.
  const auto& cones = signature.cones();
  const auto null_cone = std::find_if(cones.begin(), cones.end(), [](const auto& cone) {
    return cone.first == boost::graph_traits<TriangleMesh>::null_vertex();
  });
  if (null_cone != cones.end()) {
    report.status = Holonomy_signature_status::NULL_VERTEX;
    report.index = static_cast<std::size_t>(null_cone - cones.begin());
    return report;
  }
  const internal::Closed_mesh<TriangleMesh> closed_mesh(mesh, np);
  closed_mesh.check_cones(signature, report);
  if (report.success())
    internal::check_loops(closed_mesh, signature, report);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_CHECK_HOLONOMY_SIGNATURE_H
