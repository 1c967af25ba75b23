// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_DETECTION_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_DETECTION_H

#include <CGAL/T_splines/Cross_field/support/Feature_arcs.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Per edge, the angle by which the normals of its two faces differ; 0 on the border.
inline std::vector<double> edge_turns(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry)
{
  std::vector<double> result(mesh.number_of_edges(), 0.);
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    const auto [h, g] = halfedges_of_edge(e);
    if (mesh.face(h) == Triangulation_connectivity::null || mesh.face(g) == Triangulation_connectivity::null)
      continue;
    const Triangle_geometry::Vector_3 &a = geometry.m_normal[mesh.face(h)], &b = geometry.m_normal[mesh.face(g)];
    result[e] = std::atan2(CGAL::approximate_sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
  }
  return result;
}

/// Per component, the longest side of its bounding box, in the unit of the geometry.
template <typename FaceGraph, typename VertexPointMap>
std::vector<double> component_sizes(const Mesh_indexing<FaceGraph>& indexing, const Mesh_components& components,
                                    const Triangle_geometry& geometry, const VertexPointMap& points)
{
  struct Box {
    double low[3] = {1, 1, 1}, high[3] = {-1, -1, -1};
  };
  std::vector<Box> box(components.size());
  std::vector<char> has_box(components.size(), 0);
  for (int v = 0; v < indexing.number_of_vertices(); ++v) {
    const int c = components.of_vertex[v];
    if (c == Triangulation_connectivity::null)
      continue;
    const auto& p = get(points, indexing.vertex(v));
    const double at[3] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    for (int k = 0; k < 3; ++k) {
      box[c].low[k] = has_box[c] ? (std::min)(box[c].low[k], at[k]) : at[k];
      box[c].high[k] = has_box[c] ? (std::max)(box[c].high[k], at[k]) : at[k];
    }
    has_box[c] = 1;
  }
  std::vector<double> result;
  for (const Box& b : box)
    result.push_back((std::max)({b.high[0] - b.low[0], b.high[1] - b.low[1], b.high[2] - b.low[2]}) / geometry.m_unit);
  return result;
}

/// Finds the edges where a surface is sharp. See `detect_features()`.
class Feature_detection {
  using Index = Triangulation_connectivity::Index;

public:
  /// A feature turns by at least so many times more than half of the other edges around it. Of 20 mechanical parts,
  /// features have more than eleven, of scans and models of animals two to five in the mean.
  static constexpr double least_prominence = 8;

  /// An arc with a loose end is as long as this, at least, and one with two twice as long; by the longest side of the
  /// bounding box of its component.
  static constexpr double shortest_loose_arc = 0.05;

  /// A closed arc is as long as this, at least; by the same side. Noise makes rings of a few edges.
  static constexpr double shortest_loop = 0.02;

  /// A chain goes on where its direction turns by less than this.
  static constexpr double largest_bend = CGAL_PI / 4;

  /// \param component_size of `component_sizes()`
  Feature_detection(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                    const Mesh_components& components, const std::vector<double>& component_size)
    : m_mesh(mesh),
      m_geometry(geometry),
      m_components(components),
      m_component_size(component_size),
      m_turn(edge_turns(mesh, geometry)),
      m_outgoing(mesh.outgoing_halfedges()),
      m_is_feature(mesh.number_of_edges(), 0)
  {
  }

  /// \param angle of a feature, in radians; \param weak_angle of what continues one
  /// \param progress if it is interrupted, the result means nothing
  /// \return per edge whether it is a feature
  const std::vector<char>& detect(const double angle, const double weak_angle, Progress& progress)
  {
    for (std::size_t e = 0; e < m_turn.size(); ++e)
      m_is_feature[e] = m_turn[e] >= angle;
    progress.progress(0.2);
    prune(false, progress);
    progress.progress(0.5);
    extend(weak_angle, progress);
    progress.progress(0.7);
    prune(true, progress);
    return m_is_feature;
  }

private:
  // Drops arcs that are not prominent, and those that are short and loose, until there is none. What is dropped
  // belongs to what the others are compared with.
  void prune(const bool are_short_ones_dropped, Progress& progress)
  {
    for (bool is_changed = true; is_changed && progress.go_on();) {
      is_changed = false;
      const Feature_arcs graph(m_mesh, m_is_feature);
      std::vector<const Feature_arcs::Arc*> dropped;
      for (const Feature_arcs::Arc& arc : graph.arcs()) {
        if (!progress.go_on_after(20 * arc.halfedges.size()))
          return;
        if (!is_prominent(arc) || is_around_a_face(arc) || (are_short_ones_dropped && is_short(graph, arc)))
          dropped.push_back(&arc);
      }
      for (const Feature_arcs::Arc* const arc : dropped)
        for (const int h : arc->halfedges)
          m_is_feature[edge_of(h)] = 0;
      is_changed = !dropped.empty();
    }
  }

  double length(const Feature_arcs::Arc& arc) const
  {
    double result = 0;
    for (const int h : arc.halfedges)
      result += m_geometry.m_edge_length[edge_of(h)];
    return result;
  }

  bool is_short(const Feature_arcs& graph, const Feature_arcs::Arc& arc) const
  {
    const double size = m_component_size[m_components.of_vertex[m_mesh.target(arc.halfedges.front())]];
    const double least = arc.is_closed ? shortest_loop : graph.number_of_loose_ends(arc) * shortest_loose_arc;
    return length(arc) < least * size;
  }

  // A single triangle that is folded out of a smooth surface is an error of the mesh.
  bool is_around_a_face(const Feature_arcs::Arc& arc) const
  {
    if (!arc.is_closed || arc.halfedges.size() != 3)
      return false;
    const int h = arc.halfedges[0], g = opposite(h), second = arc.halfedges[1];
    return m_mesh.next(h) == second || opposite(m_mesh.previous(g)) == second;
  }

  bool is_prominent(const Feature_arcs::Arc& arc)
  {
    double turn = 0;
    m_around.clear();
    add_around(m_mesh.source(arc.halfedges.front()));
    for (const int h : arc.halfedges) {
      turn += m_turn[edge_of(h)] * m_geometry.m_edge_length[edge_of(h)];
      add_around(m_mesh.target(h));
    }
    return turn >= least_prominence * median_around() * length(arc);
  }

  // Edges around the arc that are not marked: their turns and lengths.
  void add_around(const Index v)
  {
    m_mesh.for_each_around_source(m_outgoing[v], [this](const int h) {
      const bool is_inside = m_mesh.face(h) != Triangulation_connectivity::null &&
                             m_mesh.face(opposite(h)) != Triangulation_connectivity::null;
      if (is_inside && !m_is_feature[edge_of(h)])
        m_around.emplace_back(m_turn[edge_of(h)], m_geometry.m_edge_length[edge_of(h)]);
    });
  }

  // Half of the edges around, by their lengths, turn by no more than this.
  double median_around()
  {
    std::sort(m_around.begin(), m_around.end());
    double total = 0, sum = 0;
    for (const auto& [turn, length] : m_around)
      total += length;
    for (const auto& [turn, length] : m_around)
      if ((sum += length) >= 0.5 * total)
        return turn;
    return 0;
  }

  // Lets chains grow from their loose ends along weaker edges, those that close a gap and then those that turn most first,
  // until these are not prominent any more or meet a feature or the border. An edge that closes a gap need not be
  // prominent by itself.
  void extend(const double weak_angle, Progress& progress)
  {
    const Feature_arcs graph(m_mesh, m_is_feature);
    std::vector<char> is_reached(m_mesh.number_of_vertices(), 0);
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      is_reached[v] = graph.degree(v) > 0 || graph.is_on_border(v);
    for (const Feature_arcs::Arc& arc : graph.arcs())
      for (int end : {arc.halfedges.back(), opposite(arc.halfedges.front())}) {
        if (!graph.is_loose_end(m_mesh.target(end)))
          continue;
        while (progress.go_on_after(10)) {
          end = continuation(end, weak_angle, is_reached);
          if (end == Triangulation_connectivity::null || (!is_reached[m_mesh.target(end)] && !is_prominent(end)))
            break;
          m_is_feature[edge_of(end)] = 1;
          if (is_reached[m_mesh.target(end)])
            break;
          is_reached[m_mesh.target(end)] = 1;
        }
      }
  }

  // The halfedge, of an edge that turns by the weak angle at least, where a chain that arrives by `h` goes on; or null.
  int continuation(const int h, const double weak_angle, const std::vector<char>& is_reached) const
  {
    int result = Triangulation_connectivity::null;
    m_mesh.for_each_around_source(m_outgoing[m_mesh.target(h)], [&](const int g) {
      if (m_is_feature[edge_of(g)] || m_turn[edge_of(g)] < weak_angle)
        return;
      const double cosine = m_geometry.vector(h) * m_geometry.vector(g) /
                            (m_geometry.m_edge_length[edge_of(h)] * m_geometry.m_edge_length[edge_of(g)]);
      const auto rank = [&](const int k) {
        return std::make_pair(is_reached[m_mesh.target(k)] != 0, m_turn[edge_of(k)]);
      };
      if (cosine >= std::cos(largest_bend) && (result == Triangulation_connectivity::null || rank(g) > rank(result)))
        result = g;
    });
    return result;
  }

  // Whether an edge that is not marked would be prominent as an arc of its own.
  bool is_prominent(const int h)
  {
    m_is_feature[edge_of(h)] = 1;
    Feature_arcs::Arc arc;
    arc.halfedges.push_back(h);
    const bool result = is_prominent(arc);
    m_is_feature[edge_of(h)] = 0;
    return result;
  }

  const Triangulation_connectivity& m_mesh;
  const Triangle_geometry& m_geometry;
  const Mesh_components& m_components;
  const std::vector<double>& m_component_size;
  std::vector<double> m_turn; // per edge
  std::vector<Index> m_outgoing;
  std::vector<char> m_is_feature;                  // per edge
  std::vector<std::pair<double, double>> m_around; // turns and lengths
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_FEATURE_DETECTION_H
