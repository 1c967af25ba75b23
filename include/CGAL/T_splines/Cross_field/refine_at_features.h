// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_REFINE_AT_FEATURES_H
#define CGAL_T_SPLINES_CROSS_FIELD_REFINE_AT_FEATURES_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/feature_figures.h>
#include <CGAL/T_splines/Cross_field/internal/Feature_refinement.h>
#include <CGAL/T_splines/internal/Face_graph_writer.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// How the refinement of a mesh at its features ended.
enum class Feature_refinement_status {
  REFINED,          ///< the mesh was copied, and split where it had to be
  INVALID_MESH,     ///< the mesh is refused: see `mesh`
  OUTPUT_NOT_EMPTY, ///< the graph for the output has elements, or removed ones
  INTERRUPTED       ///< the visitor asked to stop; nothing was written
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Feature_refinement_status status)
{
  switch (status) {
  case Feature_refinement_status::REFINED: return "the mesh was refined at its features";
  case Feature_refinement_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Feature_refinement_status::OUTPUT_NOT_EMPTY: return "the graph for the refined mesh is not empty";
  case Feature_refinement_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// What was split, or why nothing was.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Feature_refinement_report {
  Feature_refinement_status status = Feature_refinement_status::REFINED; ///< how it ended
  Triangle_mesh_report<TriangleMesh> mesh;                               ///< the check of the mesh
  int number_of_split_edges = 0; ///< edges between features, split in their middles
  int number_of_split_faces = 0; ///< triangles with three features, split at their centres

  /// returns whether `status` tells of success.
  bool success() const { return status == Feature_refinement_status::REFINED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says; of a mesh that is refused, why. Complexity: linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Feature_refinement_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  switch (report.status) {
  case Feature_refinement_status::REFINED:
    return std::string(message(report.status)) + ": " + std::to_string(report.number_of_split_edges) + " edges and " +
           std::to_string(report.number_of_split_faces) + " triangles were split";
  case Feature_refinement_status::INVALID_MESH: return describe(report.mesh, mesh);
  default: return message(report.status);
  }
}

namespace internal {

// Makes the refined mesh as a graph, and fills its maps.
template <typename TriangleMesh, typename RefinedMesh>
class Feature_refinement_writer {
public:
  Feature_refinement_writer(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& input,
                            const Feature_refinement& refinement, RefinedMesh& refined)
    : m_indexing(indexing),
      m_input(input),
      m_refinement(refinement),
      m_refined(refined),
      m_writer(refined, refinement.mesh().number_of_vertices(), refinement.mesh().number_of_edges(),
               refinement.mesh().number_of_faces())
  {
    const Triangulation_connectivity& from = refinement.mesh();
    for (int h = 0; h < from.number_of_halfedges(); ++h)
      m_writer.join(h, from.next(h), from.target(h), from.face(h));
    for (int h = 0; h < from.number_of_halfedges(); ++h) // of a vertex on the border, as Surface_mesh wants it
      if (from.face(h) == Triangulation_connectivity::null)
        m_writer.join(h, from.next(h), from.target(h), from.face(h));
    for (int f = 0; f < from.number_of_faces(); ++f)
      m_writer.set_halfedge_of_face(f, from.halfedge_of_face(f));
  }

  template <typename EdgeIsFeatureMap>
  void put_features(EdgeIsFeatureMap map) const
  {
    for (int e = 0; e < m_refinement.mesh().number_of_edges(); ++e)
      put(map, edge(m_writer.halfedge(halfedge_of_edge(e)), m_refined), m_refinement.is_feature()[e] != 0);
  }

  template <typename InputPointMap, typename OutputPointMap>
  void put_points(const InputPointMap& from, OutputPointMap to) const
  {
    using Point_3 = typename boost::property_traits<OutputPointMap>::value_type;
    for (int v = 0; v < m_refinement.mesh().number_of_vertices(); ++v) {
      const auto [corners, weight] = place(v);
      const auto& p = get(from, m_indexing.vertex(corners[0]));
      const auto& q = get(from, m_indexing.vertex(corners[1]));
      const auto& r = get(from, m_indexing.vertex(corners[2]));
      if (weight[0] == 1)
        put(to, m_writer.vertex(v), Point_3(p.x(), p.y(), p.z()));
      else if (weight[2] == 0)
        put(to, m_writer.vertex(v), Point_3(p.x() / 2 + q.x() / 2, p.y() / 2 + q.y() / 2, p.z() / 2 + q.z() / 2));
      else
        put(to, m_writer.vertex(v),
            Point_3(p.x() + ((q.x() - p.x()) + (r.x() - p.x())) / 3, p.y() + ((q.y() - p.y()) + (r.y() - p.y())) / 3,
                    p.z() + ((q.z() - p.z()) + (r.z() - p.z())) / 3));
    }
  }

  template <typename VertexLocationMap>
  void put_locations(VertexLocationMap map) const
  {
    using Location = typename boost::property_traits<VertexLocationMap>::value_type;
    std::vector<int> arriving(m_input.number_of_vertices(), 0); // of a face
    for (int h = 0; h < m_input.number_of_halfedges(); ++h)
      if (m_input.face(h) != Triangulation_connectivity::null)
        arriving[m_input.target(h)] = h;
    const int number_of_middles = static_cast<int>(m_refinement.split_halfedges().size());
    for (int v = 0; v < m_refinement.mesh().number_of_vertices(); ++v) {
      const int number = v - m_input.number_of_vertices();
      const int f = number < 0 ? m_input.face(arriving[v])
                    : number < number_of_middles
                        ? m_input.face(m_refinement.split_halfedges()[number])
                        : m_refinement.split_faces()[static_cast<std::size_t>(number - number_of_middles)];
      const auto [corners, weight] = place(v);
      Location location;
      location.first = m_indexing.face(f);
      location.second = {{0, 0, 0}};
      int h = m_input.previous(m_input.halfedge_of_face(f));
      for (int i = 0; i < 3; ++i, h = m_input.next(h)) // the source of the halfedge of the face is first
        for (int k = 0; k < 3; ++k)
          if (weight[k] != 0 && corners[k] == m_input.target(h))
            location.second[i] = weight[k];
      put(map, m_writer.vertex(v), location);
    }
  }

private:
  struct Place {
    std::array<int, 3> corners; // vertices of the input
    std::array<double, 3> weight;
  };

  Place place(const int v) const
  {
    const int number = v - m_input.number_of_vertices();
    const int number_of_middles = static_cast<int>(m_refinement.split_halfedges().size());
    if (number < 0)
      return {{{v, v, v}}, {{1, 0, 0}}};
    if (number < number_of_middles) {
      const int h = m_refinement.split_halfedges()[number];
      return {{{m_input.source(h), m_input.target(h), m_input.target(h)}}, {{0.5, 0.5, 0}}};
    }
    const int h =
        m_input.halfedge_of_face(m_refinement.split_faces()[static_cast<std::size_t>(number - number_of_middles)]);
    return {{{m_input.source(h), m_input.target(h), m_input.target(m_input.next(h))}}, {{1. / 3, 1. / 3, 1. / 3}}};
  }

  const Mesh_indexing<TriangleMesh>& m_indexing;
  const Triangulation_connectivity& m_input;
  const Feature_refinement& m_refinement;
  RefinedMesh& m_refined;
  Face_graph_writer<RefinedMesh> m_writer;
};

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// copies a mesh, and splits what stands in the way of a field that follows its features: afterwards no triangle has two edges
/// that are features or on the border, and no other edge joins two vertices of such edges.
///
/// A triangle with two features would have a cross that follows one of them, and an edge across a narrow place, from
/// feature to feature, no room for the field to turn. Such edges are split in the middle, and triangles with three features
/// into three. Dense meshes grow by less than one percent; models of few long triangles two or three times.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadablePropertyMap` from edges of `TriangleMesh` to `bool`
/// \tparam RefinedMesh a model of `MutableFaceGraph`
/// \tparam RefinedEdgeIsFeatureMap a model of `WritablePropertyMap` from edges of `RefinedMesh` to `bool`
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands; it may have a border
/// \param edge_is_feature the edges that are features; edges on the border count as such in any case
/// \param refined receives the mesh; it must be empty. Its vertices are those of `mesh`, in their order, and then those that are new
/// \param refined_edge_is_feature receives for each edge of `refined` whether it is a feature: the same edges as before, as
///        features are not split
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
///   \cgalParamNBegin{output_vertex_point_map}
///     \cgalParamDescription{receives the points of `refined`: of `mesh`, of middles of edges and centres of triangles,
///       rounded where the number type rounds}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<RefinedMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `refined` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_location_map}
///     \cgalParamDescription{receives where each vertex of `refined` lies on `mesh`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<RefinedMesh>::%vertex_descriptor` ->
///       `Polygon_mesh_processing::Face_location<TriangleMesh, double>`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the status, and how much was split. Complexity: linear in the size of the mesh.
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename RefinedMesh, typename RefinedEdgeIsFeatureMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Feature_refinement_report<TriangleMesh>
refine_at_features(const TriangleMesh& mesh, const EdgeIsFeatureMap& edge_is_feature, RefinedMesh& refined,
                   RefinedEdgeIsFeatureMap refined_edge_is_feature,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("refinement at features");
  Feature_refinement_report<TriangleMesh> report;
  if (!internal::is_output_graph(refined)) {
    report.status = Feature_refinement_status::OUTPUT_NOT_EMPTY;
    return report;
  }
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success()) {
    report.status =
        progress.is_interrupted() ? Feature_refinement_status::INTERRUPTED : Feature_refinement_status::INVALID_MESH;
    return report;
  }
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  const internal::Triangulation_connectivity connectivity = internal::triangulation_connectivity(indexing);
  const internal::Feature_refinement refinement(connectivity,
                                                internal::inner_features(indexing, connectivity, edge_is_feature));
  if (!progress.go_on()) {
    report.status = Feature_refinement_status::INTERRUPTED;
    return report;
  }
  report.number_of_split_edges = static_cast<int>(refinement.split_halfedges().size());
  report.number_of_split_faces = static_cast<int>(refinement.split_faces().size());
  const internal::Feature_refinement_writer<TriangleMesh, RefinedMesh> writer(indexing, connectivity, refinement,
                                                                              refined);
  writer.put_points(choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                     get_const_property_map(CGAL::vertex_point, mesh)),
                    choose_parameter(get_parameter(np, np_tags::output_vertex_point_map),
                                     get_property_map(CGAL::vertex_point, refined)));
  writer.put_features(refined_edge_is_feature);
  const auto locations = get_parameter(np, np_tags::vertex_location_map);
  if constexpr (!internal::is_missing<decltype(locations)>)
    writer.put_locations(locations);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_REFINE_AT_FEATURES_H
