// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SIGNATURE_DOMAIN_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SIGNATURE_DOMAIN_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/internal/Border_guide.h>
#include <CGAL/T_splines/Cross_field/internal/border_arcs.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/Cross_field/support/homology_loops.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
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

/// A mesh that `check_triangle_mesh()` accepts, in index arrays: what signatures are made for.
template <typename TriangleMesh>
struct Signature_domain {
  Mesh_indexing<TriangleMesh> m_indexing;
  Triangulation_connectivity m_connectivity;
  Triangle_geometry m_geometry;
  Mesh_components m_components;

  template <typename NamedParameters>
  Signature_domain(const TriangleMesh& mesh, const NamedParameters& np)
    : m_indexing(mesh),
      m_connectivity(triangulation_connectivity(m_indexing)),
      m_geometry(triangle_geometry(
          m_indexing, m_connectivity,
          CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                             get_const_property_map(CGAL::vertex_point, mesh)))),
      m_components(mesh_components(m_connectivity))
  {
  }

  /// The arcs of `Border_arcs`; not all of them if `progress` is interrupted.
  std::vector<std::vector<int>> short_arcs(Progress& progress) const
  {
    return Border_arcs(m_connectivity, dual_edge_lengths(m_connectivity, m_geometry)).compute(progress);
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

  /// How the border guides a field; see the function with this name.
  template <typename NamedParameters>
  Border_guide guide(const NamedParameters& np) const
  {
    return border_guide(m_indexing, m_connectivity, m_geometry, np);
  }

  /// names component `c` in a report.
  void name_component(const int c, Holonomy_signature_report<TriangleMesh>& report) const
  {
    report.component = c;
    report.face = m_indexing.face(m_components.first_face[c]);
  }

  /// looks for a component that is a single triangle.
  void check_components(Holonomy_signature_report<TriangleMesh>& report) const
  {
    const auto is_on_border = [this](const int h) {
      return m_connectivity.face(opposite(h)) == Triangulation_connectivity::null;
    };
    for (int c = 0; c < m_components.size() && report.success(); ++c) {
      const int h = m_connectivity.halfedge_of_face(m_components.first_face[c]);
      if (!is_on_border(h) || !is_on_border(m_connectivity.next(h)) || !is_on_border(m_connectivity.previous(h)))
        continue;
      report.status = Holonomy_signature_status::SINGLE_TRIANGLE;
      name_component(c, report);
    }
  }

  /// checks that no component is a single triangle, that cones are inner vertices and corners on the border, that their
  /// numbers of quarter turns are positive, and that these satisfy the theorem of Gauss and Bonnet in each component.
  void check_cones(const Holonomy_signature<TriangleMesh>& signature,
                   Holonomy_signature_report<TriangleMesh>& report) const
  {
    using Signature = Holonomy_signature<TriangleMesh>;
    const std::vector<int> curve = curves_of_vertices(m_connectivity, border_curves(m_connectivity));
    std::vector<int> sum(m_components.size(), 0);
    check_components(report);
    const auto add = [&](const auto& numbers, const int regular, const bool is_corner) {
      for (std::size_t i = 0; i < numbers.size() && report.success(); ++i) {
        const auto& [vertex, k] = numbers[i];
        const int v = m_indexing.vertex_index(vertex);
        if ((curve[v] != Triangulation_connectivity::null) != is_corner)
          report.status =
              is_corner ? Holonomy_signature_status::CORNER_INSIDE : Holonomy_signature_status::CONE_ON_BORDER;
        else if (k < 1)
          report.status = Holonomy_signature_status::NON_POSITIVE_CONE;
        if (!report.success()) {
          report.vertex = vertex;
          report.index = i;
          report.is_corner = is_corner;
          report.actual = k;
        }
        sum[m_components.of_vertex[v]] += regular - k;
      }
    };
    add(signature.cones(), Signature::regular, false);
    add(signature.corners(), Signature::regular_on_border, true);
    for (int c = 0; c < m_components.size() && report.success(); ++c) {
      if (sum[c] == 4 * m_components.euler_characteristic[c])
        continue;
      report.status = Holonomy_signature_status::GAUSS_BONNET_VIOLATED;
      name_component(c, report);
      report.expected = 4 * m_components.euler_characteristic[c];
      report.actual = sum[c];
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

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_SIGNATURE_DOMAIN_H
