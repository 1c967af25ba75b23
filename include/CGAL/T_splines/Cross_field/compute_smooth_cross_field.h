// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_COMPUTE_SMOOTH_CROSS_FIELD_H
#define CGAL_T_SPLINES_CROSS_FIELD_COMPUTE_SMOOTH_CROSS_FIELD_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>
#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/check_numbered_vertices.h>
#include <CGAL/T_splines/Cross_field/internal/Smooth_field_computation.h>
#include <CGAL/T_splines/Cross_field/internal/write_cross_field.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesCrossField
/// How the computation of a smooth cross field ended.
enum class Smooth_cross_field_status {
  COMPUTED,        ///< the field was written
  INVALID_MESH,    ///< the mesh is refused: see `mesh`
  INVALID_CORNERS, ///< the corners that are given are refused: see `corners`
  INTERRUPTED      ///< the visitor asked to stop; nothing was written
};

/// \ingroup PkgTSplinesCrossField
/// returns one sentence that explains `status`.
inline const char* message(const Smooth_cross_field_status status)
{
  switch (status) {
  case Smooth_cross_field_status::COMPUTED: return "the cross field was computed";
  case Smooth_cross_field_status::INVALID_MESH: return "the mesh is not a triangle mesh with positive areas";
  case Smooth_cross_field_status::INVALID_CORNERS: return "the corners are not those of a border";
  case Smooth_cross_field_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesCrossField
/// What the computation of a smooth cross field did and how it ended.
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Smooth_cross_field_report {
  Smooth_cross_field_status status = Smooth_cross_field_status::COMPUTED; ///< how it ended
  Triangle_mesh_report<TriangleMesh> mesh;                                ///< the check of the mesh
  Holonomy_signature_report<TriangleMesh> corners; ///< the check of the named parameter `corners`
  int number_of_singularities = 0;                 ///< vertices, not on the border, with other than four quarter turns
  int number_of_repaired_vertices = 0;             ///< where the smoothest cross would not have made a quarter turn
  double energy =
      0; ///< smallest eigenvalue of the connection Laplacian times the area, summed over the components without
         ///< constraints; dimensionless

  /// returns whether `status` tells of success.
  bool success() const { return status == Smooth_cross_field_status::COMPUTED; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesCrossField
/// returns what `report` says; of a mesh that is refused, why. Complexity: linear in the size of the mesh.
template <typename TriangleMesh>
std::string describe(const Smooth_cross_field_report<TriangleMesh>& report, const TriangleMesh& mesh)
{
  switch (report.status) {
  case Smooth_cross_field_status::INVALID_MESH: return describe(report.mesh, mesh);
  case Smooth_cross_field_status::INVALID_CORNERS: return describe(report.corners, mesh);
  default: return message(report.status);
  }
}

namespace internal {

template <typename TriangleMesh, typename NamedParameters>
Smooth_field_options smooth_field_options(const Signature_domain<TriangleMesh>& domain, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  constexpr int default_diffusion_steps = 10;
  const Mesh_indexing<TriangleMesh>& indexing = domain.m_indexing;
  const Triangulation_connectivity& connectivity = domain.m_connectivity;
  Smooth_field_options options;
  options.curvature_alignment = choose_parameter(get_parameter(np, np_tags::curvature_alignment), 0.);
  options.diffusion_steps = static_cast<int>(
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), default_diffusion_steps));
  options.seed = static_cast<unsigned int>(choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), 0));
  options.is_edge_constrained.assign(connectivity.number_of_edges(), 0);
  options.edge_deviation = domain.guide(np).deviations();
  for (int h = 0; h < connectivity.number_of_halfedges(); ++h)
    if (connectivity.face(h) == Triangulation_connectivity::null)
      options.is_edge_constrained[edge_of(h)] = 1;
  const auto is_constrained = get_parameter(np, CGAL::internal_np::edge_is_constrained);
  if constexpr (!std::is_same_v<std::decay_t<decltype(is_constrained)>, CGAL::internal_np::Param_not_found>)
    for (std::size_t e = 0; e < options.is_edge_constrained.size(); ++e)
      if (get(is_constrained,
              edge(indexing.halfedge(internal::halfedge_of_edge(static_cast<int>(e))), indexing.graph())))
        options.is_edge_constrained[e] = 1;
  return options;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// computes a smooth cross field with few singularities: a globally optimal direction field (Knoeppel, Crane, Pinkall,
/// Schroeder, Globally optimal direction fields, 2013).
///
/// The crosses are computed on the vertices of the intrinsic Delaunay triangulation, so that a bad triangulation does not decide
/// where they turn, and carried over to the faces of the mesh. First comes the field of smallest Dirichlet energy for a
/// given mean length: the eigenvector of the smallest eigenvalue of the connection Laplacian. Some steps of
/// diffusion and projection to unit length follow; their result is taken where it has fewer singularities. Where the
/// smoothest cross makes no quarter turn, at sharp spikes for instance, the field is changed such that it makes one.
/// Every connected component is treated by itself. The mesh may have a border, which the field follows: in the direction of its edges
/// but for their noise, see the parameter `corner_angle`.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `WritablePropertyMap` from faces to three-dimensional vectors, which are
///         constructible from three `double`s
/// \param mesh a triangle mesh, as `check_triangle_mesh()` demands, but it may have a border
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
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{the edges that the field follows: the crosses in the two faces of a marked edge get its
///       direction}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%edge_descriptor` ->
///       `bool`}
///     \cgalParamDefault{no edge is marked}
///     \cgalParamExtra{In a face with several marked edges the cross gets the mean of their directions, or that of the
///       longest one if they contradict each other. Around a vertex that would make no quarter turn, such as the middle
///       of a circle, some give way.}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_alignment}
///     \cgalParamDescription{how much the field follows the principal curvature directions (of Cohen-Steiner and
///       Morvan's tensor), a number w >= 0}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: not at all}
///     \cgalParamExtra{Features larger than the square root of area / w are followed; 100 is a good value. It is
///       -lambda, times the area, in section 5 of the paper.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the number of steps of diffusion and projection}
///     \cgalParamType{an integer}
///     \cgalParamDefault{10}
///     \cgalParamExtra{0 gives the paper's field itself. None are made in a guided field.}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{of the start vector; equal seeds give equal fields}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_matching_map}
///     \cgalParamDescription{receives the matchings that `holonomy_signature_of_cross_field()` takes}
///     \cgalParamType{a model of `ReadWritePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       an integer}
///     \cgalParamDefault{none is written}
///     \cgalParamExtra{Those by the closest rotation, which that function makes itself, are the same, but for ties.}
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
/// Complexity: O(n log n) for n faces, memory O(n): the systems are solved by algebraic multigrid, nothing is factorized.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Smooth_cross_field_report<TriangleMesh>
compute_smooth_cross_field(const TriangleMesh& mesh, CrossFieldMap cross_field,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("cross field");
  Smooth_cross_field_report<TriangleMesh> report;
  report.mesh = internal::triangle_mesh_report(mesh, np, progress);
  if (progress.is_interrupted()) {
    report.status = Smooth_cross_field_status::INTERRUPTED;
    return report;
  }
  if (!report.mesh.success()) {
    report.status = Smooth_cross_field_status::INVALID_MESH;
    return report;
  }
  internal::check_given_corners(mesh, np, report.corners);
  if (!report.corners.success()) {
    report.status = Smooth_cross_field_status::INVALID_CORNERS;
    return report;
  }
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  const internal::Smooth_field_options options = internal::smooth_field_options(domain, np);
  progress.go_on();
  internal::Smooth_field_computation computation(domain.m_connectivity, domain.m_geometry, options, progress);
  if (!computation.compute(domain.m_components))
    report.status = Smooth_cross_field_status::INTERRUPTED;
  else {
    report.number_of_singularities = computation.number_of_singularities();
    report.number_of_repaired_vertices = computation.number_of_repaired_vertices();
    report.energy = computation.energy();
    internal::write_cross_field(domain.m_indexing, domain.m_connectivity, domain.m_geometry, computation.angles(),
                                cross_field);
    const auto matchings = CGAL::parameters::get_parameter(np, np_tags::halfedge_matching_map);
    if constexpr (!internal::is_missing<decltype(matchings)>)
      internal::write_matchings(domain.m_indexing, domain.m_connectivity, domain.m_geometry, computation.angles(),
                                computation.rotations(), matchings);
  }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_COMPUTE_SMOOTH_CROSS_FIELD_H
