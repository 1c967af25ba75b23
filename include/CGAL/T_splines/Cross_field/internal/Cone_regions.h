// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_REGIONS_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_REGIONS_H

#include <CGAL/T_splines/Cross_field/internal/Cone_reduction.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The parts of a mesh within which quarter turns may move: those into which constrained edges divide it. A vertex on such
/// an edge is a part of its own.
class Cone_regions {
public:
  template <typename TriangleMesh, typename NamedParameters>
  Cone_regions(const Signature_domain<TriangleMesh>& domain, const NamedParameters& np)
    : m_is_constrained(domain.m_connectivity.number_of_edges(), 0)
  {
    const auto constrained = CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained);
    if constexpr (!is_missing<decltype(constrained)>)
      for (int e = 0; e < domain.m_connectivity.number_of_edges(); ++e)
        if (get(constrained, edge(domain.m_indexing.halfedge(halfedge_of_edge(e)), domain.m_indexing.graph()))) {
          m_is_constrained[e] = 1;
          m_has_constraints = true;
        }
    if (m_has_constraints)
      divide(domain.m_connectivity, domain.m_geometry.m_edge_length, domain.m_components);
    else {
      m_edge_length = domain.m_geometry.m_edge_length;
      m_of_vertex = domain.m_components.of_vertex;
      m_component_of_region.resize(domain.m_components.size());
      std::iota(m_component_of_region.begin(), m_component_of_region.end(), 0);
    }
  }

  bool has_constraints() const { return m_has_constraints; }
  bool is_constrained(const int edge) const { return m_is_constrained[edge] != 0; }

  /// Per vertex.
  const std::vector<int>& of_vertex() const { return m_of_vertex; }

  /// Per edge: infinite where one of its ends lies on a constrained edge.
  const std::vector<double>& edge_lengths() const { return m_edge_length; }

  /// From limits per component those per region.
  Cone_reduction_limits limits(Cone_reduction_limits limits) const
  {
    std::vector<double> result;
    for (const int component : m_component_of_region)
      result.push_back(limits.energy_change[component]);
    limits.energy_change = std::move(result);
    return limits;
  }

  /// Makes each of some vertices a part of its own, if it belongs to a region to which also an end of one of the edges does.
  /// \return whether there were any that were not
  bool separate(const Triangulation_connectivity& mesh, const std::vector<int>& edges, const std::vector<int>& vertices)
  {
    std::vector<char> is_concerned(m_component_of_region.size(), 0);
    for (const int e : edges)
      for (const int h : halfedges_of_edge(e))
        for (const int v : {mesh.target(h), mesh.target(mesh.next(h))})
          is_concerned[m_of_vertex[v]] = 1;
    std::vector<int> number_of_vertices(m_component_of_region.size(), 0);
    for (const int v : vertices)
      ++number_of_vertices[m_of_vertex[v]];
    bool has_separated = false;
    for (const int v : vertices)
      if (is_concerned[m_of_vertex[v]] != 0 && number_of_vertices[m_of_vertex[v]] > 1) {
        m_component_of_region.push_back(m_component_of_region[m_of_vertex[v]]);
        m_of_vertex[v] = static_cast<int>(m_component_of_region.size()) - 1;
        is_concerned.push_back(0);
        number_of_vertices.push_back(1);
        has_separated = true;
      }
    return has_separated;
  }

private:
  void divide(const Triangulation_connectivity& mesh, const std::vector<double>& length,
              const Mesh_components& components)
  {
    std::vector<char> is_on_edge(mesh.number_of_vertices(), 0);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (is_constrained(edge_of(h)))
        is_on_edge[mesh.target(h)] = 1;
    m_edge_length = length;
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      if (is_on_edge[mesh.target(halfedge_of_edge(e))] != 0 || is_on_edge[mesh.source(halfedge_of_edge(e))] != 0)
        m_edge_length[e] = std::numeric_limits<double>::infinity();
    const std::vector<int> outgoing = mesh.outgoing_halfedges();
    m_of_vertex.assign(mesh.number_of_vertices(), mesh.null);
    for (int first = 0; first < mesh.number_of_vertices(); ++first) {
      if (m_of_vertex[first] != mesh.null || outgoing[first] == mesh.null)
        continue;
      const int region = static_cast<int>(m_component_of_region.size());
      m_component_of_region.push_back(components.of_vertex[first]);
      m_of_vertex[first] = region;
      std::vector<int> queue{first};
      while (!queue.empty() && is_on_edge[first] == 0) {
        const int v = queue.back();
        queue.pop_back();
        mesh.for_each_around_source(outgoing[v], [&](const int h) {
          const int w = mesh.target(h);
          if (is_on_edge[w] != 0 || m_of_vertex[w] != mesh.null)
            return;
          m_of_vertex[w] = region;
          queue.push_back(w);
        });
      }
    }
  }

  std::vector<char> m_is_constrained; // per edge
  std::vector<double> m_edge_length;  // per edge
  std::vector<int> m_of_vertex;       // per vertex
  std::vector<int> m_component_of_region;
  bool m_has_constraints = false;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_REGIONS_H
