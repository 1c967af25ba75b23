// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CLOSED_MESH_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CLOSED_MESH_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/homology_loops.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/mesh_components.h>
#include <CGAL/T_splines/internal/tolerances.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename TriangleMesh, typename NamedParameters>
Triangle_mesh_report<TriangleMesh> check_closed_mesh(const TriangleMesh& mesh, const NamedParameters& np,
                                                     Progress& progress)
{
  return triangle_mesh_report(mesh, false, np, progress);
}

/// A mesh that `check_closed_mesh()` accepts, in index arrays: what signatures are made from.
template <typename TriangleMesh>
struct Closed_mesh {
  Mesh_indexing<TriangleMesh> m_indexing;
  Triangulation_connectivity m_connectivity;
  Triangle_geometry m_geometry;
  Mesh_components m_components;

  template <typename NamedParameters>
  Closed_mesh(const TriangleMesh& mesh, const NamedParameters& np)
    : m_indexing(mesh),
      m_connectivity(triangulation_connectivity(m_indexing)),
      m_geometry(triangle_geometry(
          m_indexing, m_connectivity,
          CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                             get_const_property_map(CGAL::vertex_point, mesh)))),
      m_components(mesh_components(m_connectivity))
  {
  }

  /// The loops of `homology_loops()`; not all of them if `progress` is interrupted.
  std::vector<std::vector<int>> short_loops(Progress& progress) const
  {
    return homology_loops(m_connectivity, dual_edge_lengths(m_connectivity, m_geometry), m_components, progress);
  }

  std::vector<typename Mesh_indexing<TriangleMesh>::halfedge_descriptor>
  halfedges_of(const std::vector<int>& strip) const
  {
    std::vector<typename Mesh_indexing<TriangleMesh>::halfedge_descriptor> result;
    result.reserve(strip.size());
    for (const int h : strip)
      result.push_back(m_indexing.halfedge(h));
    return result;
  }

  /// names component `c` in a report.
  void name_component(const int c, Holonomy_signature_report<TriangleMesh>& report) const
  {
    report.component = c;
    report.face = m_indexing.face(m_components.first_face[c]);
  }

  /// checks that the numbers of quarter turns of the cones are positive and satisfy the theorem of Gauss and Bonnet in each
  /// component.
  void check_cones(const Holonomy_signature<TriangleMesh>& signature,
                   Holonomy_signature_report<TriangleMesh>& report) const
  {
    std::vector<int> sum(m_components.size(), 0);
    for (std::size_t i = 0; i < signature.cones().size(); ++i) {
      const auto& [vertex, k] = signature.cones()[i];
      if (k < 1) {
        report.status = Holonomy_signature_status::NON_POSITIVE_CONE;
        report.vertex = vertex;
        report.index = i;
        report.actual = k;
        return;
      }
      sum[m_components.of_vertex[m_indexing.vertex_index(vertex)]] += Holonomy_signature<TriangleMesh>::regular - k;
    }
    for (int c = 0; c < m_components.size(); ++c) {
      if (sum[c] == 4 * m_components.euler_characteristic[c])
        continue;
      report.status = Holonomy_signature_status::GAUSS_BONNET_VIOLATED;
      name_component(c, report);
      report.expected = 4 * m_components.euler_characteristic[c];
      report.actual = sum[c];
      return;
    }
  }
};

/// rounds a number of quarter turns and keeps account of the largest deviation.
/// \return whether it is an integer within `same_number_of_turns`.
inline bool round_turns(const double turns, int& rounded, double& largest_deviation)
{
  const double nearest = std::round(turns);
  const double deviation = std::abs(turns - nearest);
  if (!(deviation <= largest_deviation))
    largest_deviation = deviation;
  if (!(deviation <= same_number_of_turns))
    return false;
  rounded = static_cast<int>(nearest);
  return true;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CLOSED_MESH_H
