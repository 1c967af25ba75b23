// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_COMPUTE_FEATURE_ALIGNED_CROSS_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_COMPUTE_FEATURE_ALIGNED_CROSS_FIELD_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/compute_smooth_cross_field.h>
#include <CGAL/T_splines/Cross_field/feature_figures.h>
#include <CGAL/T_splines/Cross_field/internal/Feature_aligned_field.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
#include <CGAL/T_splines/Cross_field/internal/sector_turns.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/element_numbers.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// How the computation of a cross field that follows features ended.
enum class Feature_aligned_field_status {
  COMPUTED,        ///< the field was written; it follows all features but those in `soft_edges`
  INVALID_MESH,    ///< the mesh is refused: see `mesh`
  INVALID_CORNERS, ///< the corners that are given are refused: see `corners`
  INVALID_ANGLE,   ///< the smallest sector angle is not a number between 0 and 360
  NOT_REFINED,     ///< `face` has two edges that are features or on the border
  INTERRUPTED      ///< the visitor asked to stop; nothing was written
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Feature_aligned_field_status status)
{
  switch (status) {
  case Feature_aligned_field_status::COMPUTED: return "the cross field follows the features";
  case Feature_aligned_field_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Feature_aligned_field_status::INVALID_CORNERS: return "the corners are not those of a border";
  case Feature_aligned_field_status::INVALID_ANGLE: return "the smallest sector angle is not between 0 and 360 degrees";
  case Feature_aligned_field_status::NOT_REFINED:
    return "a face has two edges that are features or on the border; refine the mesh at its features first";
  case Feature_aligned_field_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// What the computation of a cross field that follows features did and how it ended.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Feature_aligned_field_report {
  using Traits = boost::graph_traits<TriangleMesh>;

  /// A feature that the field does not follow.
  struct Soft_edge {
    typename Traits::halfedge_descriptor halfedge; ///< of the edge
    typename Traits::vertex_descriptor vertex;     ///< where a sector beside it would have had no quarter turn
  };

  Feature_aligned_field_status status = Feature_aligned_field_status::COMPUTED; ///< how it ended
  Triangle_mesh_report<TriangleMesh> mesh;                                      ///< the check of the mesh
  Holonomy_signature_report<TriangleMesh> corners;             ///< the check of the named parameter `corners`
  typename Traits::face_descriptor face = Traits::null_face(); ///< of NOT_REFINED
  std::vector<Soft_edge> soft_edges;                           ///< in the order in which they went soft
  Feature_figures features;                                    ///< those that the field follows
  int number_of_rounds = 0;           ///< how often the field was computed: once, if nothing went soft
  int number_of_repaired_sectors = 0; ///< sectors and vertices that got quarter turns from elsewhere
  int number_of_singularities = 0;    ///< vertices, not on the border, with other than four quarter turns
  double energy = 0;                  ///< as in `Smooth_cross_field_report`

  /// returns whether `status` tells of success.
  bool success() const { return status == Feature_aligned_field_status::COMPUTED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
  /// returns whether the field follows all features that were given.
  bool follows_all_features() const { return success() && soft_edges.empty(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says: which features went soft, and where, or what was wrong, elements counted from 0. Complexity:
/// linear in the size of the mesh, times the number of features that went soft.
template <typename TriangleMesh>
std::string describe(const Feature_aligned_field_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  std::string text = message(report.status);
  switch (report.status) {
  case Feature_aligned_field_status::INVALID_MESH: return describe(report.mesh, mesh);
  case Feature_aligned_field_status::INVALID_CORNERS: return describe(report.corners, mesh);
  case Feature_aligned_field_status::NOT_REFINED:
    return text + ": " + internal::face_in_words(report.face, mesh) + ", counted from 0";
  case Feature_aligned_field_status::COMPUTED: break;
  case Feature_aligned_field_status::INVALID_ANGLE:
  case Feature_aligned_field_status::INTERRUPTED: return text;
  }
  if (report.soft_edges.empty())
    return text;
  text += " but for " + std::to_string(report.soft_edges.size()) + ", counted from 0: ";
  for (std::size_t i = 0; i < report.soft_edges.size(); ++i)
    text += (i > 0 ? ", " : "") + internal::edge_in_words(report.soft_edges[i].halfedge, mesh) + " at " +
            internal::vertex_in_words(report.soft_edges[i].vertex, mesh);
  return text;
}

namespace internal {

// The first face with two edges that are features or on the border, or null.
inline int first_face_with_two_bounds(const Triangulation_connectivity& mesh, const std::vector<char>& is_feature)
{
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    int number = 0, h = mesh.halfedge_of_face(f);
    for (int corner = 0; corner < 3; ++corner, h = mesh.next(h))
      number += is_feature[edge_of(h)] || mesh.face(opposite(h)) == Triangulation_connectivity::null ? 1 : 0;
    if (number > 1)
      return f;
  }
  return Triangulation_connectivity::null;
}

// What is written of a field that follows features, beside its crosses.
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename NamedParameters>
void write_feature_alignment(const Signature_domain<TriangleMesh>& domain, const Feature_aligned_field& field,
                             EdgeIsFeatureMap edge_is_feature, const NamedParameters& np,
                             Feature_aligned_field_report<TriangleMesh>& report)
{
  const Triangulation_connectivity& mesh = domain.m_connectivity;
  for (const Feature_aligned_field::Soft_edge& soft : field.soft_edges()) {
    const auto h = domain.m_indexing.halfedge(halfedge_of_edge(soft.edge));
    report.soft_edges.push_back({h, domain.m_indexing.vertex(soft.vertex)});
    put(edge_is_feature, edge(h, domain.m_indexing.graph()), false);
  }
  const Vertex_sectors sectors(mesh, field.is_feature());
  const std::vector<int> turns = field.sector_turns();
  std::vector<int> turns_of_vertex(mesh.number_of_vertices(), 0);
  std::vector<char> is_on_border(mesh.number_of_vertices(), 0);
  for (int s = 0; s < sectors.size(); ++s)
    turns_of_vertex[sectors.vertex(s)] += turns[s];
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) == Triangulation_connectivity::null)
      is_on_border[mesh.target(h)] = 1;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    report.number_of_singularities += !is_on_border[v] && turns_of_vertex[v] != 4 ? 1 : 0;
  const auto matchings = CGAL::parameters::get_parameter(np, np_tags::halfedge_matching_map);
  if constexpr (!is_missing<decltype(matchings)>)
    write_matchings(domain.m_indexing, mesh, domain.m_geometry, field.angles(), field.rotations(), matchings);
  const auto sector_turns = CGAL::parameters::get_parameter(np, np_tags::halfedge_sector_turns_map);
  if constexpr (!is_missing<decltype(sector_turns)>)
    put_sector_turns(domain.m_indexing, mesh, sectors, turns, sector_turns);
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// computes a smooth cross field that follows the features of a mesh, and in which each *sector*, between two features
/// that are neighbors around a vertex, makes at least one quarter turn.
///
/// It is the field of `compute_smooth_cross_field()` with the features, and the border, as constraints, but for this: in the two
/// faces of a feature the crosses have its direction, always. A sector of less than an eighth of a turn would have no
/// quarter turn, and a feature-aligned map would have an angle of zero there. Such a sector gets a quarter turn from a
/// vertex nearby, inside of the same patch between features: then the rotation between two neighboring crosses may be more than an
/// eighth of a turn, and the field is to be taken together with its matchings, which `halfedge_matching_map` receives.
/// They also decide ties, crosses exactly an eighth of a turn apart. A sector that is narrower than the smallest sector
/// angle, or one in a patch that has no quarter turn to give, makes one of the two features soft, that which is weaker: the angle of its faces times its length. The
/// field is computed anew then.
///
/// Hand the matchings to `holonomy_signature_of_cross_field()`: the signature has the sums of the sectors around vertices. Cones on features are needed;
/// `reduce_cones()` keeps them if it gets the features as `edge_is_constrained_map`.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadWritePropertyMap` from edges to `bool`
/// \tparam CrossFieldMap a model of `WritablePropertyMap` from faces to three-dimensional vectors, which are
///         constructible from three `double`s
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands, in which no face has two edges that are features or
///        on the border: see `refine_at_features()`
/// \param edge_is_feature the features; those that went soft are unmarked. Marks on the border do not matter: it is
///        followed as `compute_smooth_cross_field()` does
/// \param cross_field receives one of the four directions of the cross in each face, of length 1
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
///   \cgalParamNBegin{halfedge_matching_map}
///     \cgalParamDescription{receives the matchings that `holonomy_signature_of_cross_field()` takes}
///     \cgalParamType{a model of `ReadWritePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       an integer}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_sector_turns_map}
///     \cgalParamDescription{receives, for each halfedge with a face whose edge is a feature or on the border, the number of quarter turns
///       of the sector at its source that begins with it and goes counter-clockwise to the next such edge; 0 for others}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       an integer}
///     \cgalParamDefault{none is written}
///     \cgalParamExtra{At a vertex with features they add up to its quarter turns.}
///   \cgalParamNEnd
///   \cgalParamNBegin{smallest_sector_angle}
///     \cgalParamDescription{the angle between two features, in degrees, below which a sector that makes no quarter turn makes
///       one of them soft; with 0 only where there is no other way, with 360 wherever there is no quarter turn}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_smallest_sector_angle`, 10}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_alignment}
///     \cgalParamDescription{see `compute_smooth_cross_field()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: not at all}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the number of steps of diffusion and projection}
///     \cgalParamType{an integer}
///     \cgalParamDefault{10}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{of the start vector, on components without features; equal seeds give equal fields}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{0}
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
/// \return the status, and which features went soft. Equal input gives equal results.
/// Complexity: O(n log n) for n faces, for each of the rounds: one, and mostly no more than one for each chain of features that
/// goes soft.
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Feature_aligned_field_report<TriangleMesh>
compute_feature_aligned_cross_field(const TriangleMesh& mesh, EdgeIsFeatureMap edge_is_feature,
                                    CrossFieldMap cross_field,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Status = Feature_aligned_field_status;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("cross field along features");
  Feature_aligned_field_report<TriangleMesh> report;
  const auto fail = [&report](const Status status) {
    report.status = status;
    return report;
  };
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (!report.mesh.success())
    return fail(progress.is_interrupted() ? Status::INTERRUPTED : Status::INVALID_MESH);
  internal::check_given_corners(mesh, np, report.corners);
  if (!report.corners.success())
    return fail(Status::INVALID_CORNERS);
  const double smallest_angle =
      choose_parameter(get_parameter(np, np_tags::smallest_sector_angle), default_smallest_sector_angle);
  if (!(smallest_angle >= 0 && smallest_angle <= 360))
    return fail(Status::INVALID_ANGLE);
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  const std::vector<char> is_feature =
      internal::inner_features(domain.m_indexing, domain.m_connectivity, edge_is_feature);
  const int face = internal::first_face_with_two_bounds(domain.m_connectivity, is_feature);
  if (face != internal::Triangulation_connectivity::null) {
    report.face = domain.m_indexing.face(face);
    return fail(Status::NOT_REFINED);
  }
  internal::Smooth_field_options options = internal::smooth_field_options(domain, np);
  const internal::Border_guide guide = domain.guide(np);
  internal::Feature_aligned_field field(domain.m_connectivity, domain.m_geometry, domain.m_components, guide,
                                        internal::given_corners<TriangleMesh>(np).has_value(), options, is_feature,
                                        smallest_angle * (CGAL_PI / 180), progress);
  if (!progress.go_on() || !field.compute())
    return fail(Status::INTERRUPTED);
  report.number_of_rounds = field.number_of_rounds();
  report.number_of_repaired_sectors = field.number_of_repaired_sectors();
  report.energy = field.energy();
  report.features = internal::figures_of_features(domain.m_connectivity, domain.m_geometry, field.is_feature());
  internal::write_cross_field(domain.m_indexing, domain.m_connectivity, domain.m_geometry, field.angles(), cross_field);
  internal::write_feature_alignment(domain, field, edge_is_feature, np, report);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_COMPUTE_FEATURE_ALIGNED_CROSS_FIELD_H
