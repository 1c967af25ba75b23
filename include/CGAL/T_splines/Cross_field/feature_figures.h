// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_FEATURE_FIGURES_H
#define CGAL_T_SPLINES_CROSS_FIELD_FEATURE_FIGURES_H

#include <CGAL/T_splines/Cross_field/support/Feature_arcs.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// What the features of a mesh are as a graph. Edges on the border do not count: the border is followed by itself.
struct Feature_figures {
  int number_of_edges = 0; ///< marked edges
  /// chains of marked edges between vertices with other than two of them or on the border, and closed ones.
  int number_of_arcs = 0;
  int number_of_loops = 0;          ///< those of the arcs that are closed and meet no other
  int number_of_corners = 0;        ///< vertices inside with three marked edges or more
  int number_of_darts = 0;          ///< vertices inside where a single marked edge ends
  int number_of_ends_on_border = 0; ///< vertices on the border with a marked edge
  double relative_length = 0;       ///< of all marked edges, by the square root of the area of the mesh

  /// returns whether the features are the edges of a part with sides, rather than ridges of something rounded: they are
  /// long, and hardly any of them ends inside.
  ///
  /// The bounds: on 60 meshes of mechanical parts at most 9 percent of the arcs end inside, and the relative length is 2.5
  /// to 38 (a rod with ten times the length of its width has 1.1); on 25 of statues, animals and scans either less than
  /// 0.8, or more than 20 percent end inside.
  bool divide_surface() const
  {
    constexpr double least_length = 1, largest_share = 0.1;
    return relative_length >= least_length && number_of_darts <= largest_share * number_of_arcs;
  }
};

/// \ingroup PkgTSplinesCrossField
/// returns figures in one line.
inline std::string describe(const Feature_figures& figures)
{
  return std::to_string(figures.number_of_edges) + " feature edges in " + std::to_string(figures.number_of_arcs) +
         " arcs, " + std::to_string(figures.number_of_loops) + " of them closed; " +
         std::to_string(figures.number_of_corners) + " corners, " + std::to_string(figures.number_of_darts) +
         " ends inside, " + std::to_string(figures.number_of_ends_on_border) + " on the border";
}

namespace internal {

inline Feature_figures figures_of_features(const Triangulation_connectivity& mesh, const Triangle_geometry& geometry,
                                           const std::vector<char>& is_feature)
{
  const Feature_arcs graph(mesh, is_feature);
  Feature_figures figures;
  double length = 0;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    length += is_feature[e] != 0 ? geometry.m_edge_length[e] : 0;
  const double area = std::accumulate(geometry.m_area.begin(), geometry.m_area.end(), 0.);
  figures.relative_length = area > 0 ? length / std::sqrt(area) : 0;
  for (const Feature_arcs::Arc& arc : graph.arcs()) {
    figures.number_of_edges += static_cast<int>(arc.halfedges.size());
    ++figures.number_of_arcs;
    figures.number_of_loops += arc.is_closed ? 1 : 0;
  }
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    if (graph.is_on_border(v))
      figures.number_of_ends_on_border += graph.degree(v) > 0 ? 1 : 0;
    else {
      figures.number_of_corners += graph.degree(v) > 2 ? 1 : 0;
      figures.number_of_darts += graph.degree(v) == 1 ? 1 : 0;
    }
  return figures;
}

/// Per edge whether it is marked and not on the border.
template <typename TriangleMesh, typename EdgeIsFeatureMap>
std::vector<char> inner_features(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& mesh,
                                 const EdgeIsFeatureMap& edge_is_feature)
{
  std::vector<char> result(mesh.number_of_edges(), 0);
  for (int e = 0; e < mesh.number_of_edges(); ++e) {
    const auto [h, g] = halfedges_of_edge(e);
    result[e] = mesh.face(h) != Triangulation_connectivity::null && mesh.face(g) != Triangulation_connectivity::null &&
                get(edge_is_feature, edge(indexing.halfedge(h), indexing.graph()));
  }
  return result;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// counts the features of a mesh, their arcs, corners and ends.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadablePropertyMap` from edges to `bool`
/// \param mesh a triangle mesh, with or without border
/// \param edge_is_feature the edges that are features
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the size of the mesh.
template <typename TriangleMesh, typename EdgeIsFeatureMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Feature_figures feature_figures(const TriangleMesh& mesh, const EdgeIsFeatureMap& edge_is_feature,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  const internal::Triangulation_connectivity connectivity = internal::triangulation_connectivity(indexing);
  const auto point_map =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_const_property_map(CGAL::vertex_point, mesh));
  return internal::figures_of_features(connectivity, internal::triangle_geometry(indexing, connectivity, point_map),
                                       internal::inner_features(indexing, connectivity, edge_is_feature));
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_FEATURE_FIGURES_H
