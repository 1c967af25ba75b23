// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_REDUCE_CONES_H
#define CGAL_T_SPLINES_CROSS_FIELD_REDUCE_CONES_H

#include <CGAL/T_splines/Cross_field/Cone_reduction_report.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/internal/Signature_domain.h>
#include <CGAL/T_splines/Cross_field/internal/Cone_paths.h>
#include <CGAL/T_splines/Cross_field/internal/Cone_reduction.h>
#include <CGAL/T_splines/Cross_field/internal/Cone_regions.h>
#include <CGAL/T_splines/Cross_field/internal/Scale_energy.h>
#include <CGAL/T_splines/Cross_field/internal/Moved_field.h>
#include <CGAL/T_splines/Cross_field/internal/split_targets.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/mesh_components.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename NamedParameters>
Cone_reduction_limits cone_reduction_limits(const Mesh_components& components, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const std::optional<int> number_of_cones =
      choose_parameter(get_parameter(np, np_tags::maximum_number_of_cones), std::optional<int>());
  const std::optional<double> energy_change =
      choose_parameter(get_parameter(np, np_tags::maximum_energy_change), std::optional<double>());
  Cone_reduction_limits limits;
  if (number_of_cones)
    limits.number_of_cones = *number_of_cones;
  for (int c = 0; c < components.size(); ++c)
    limits.energy_change.push_back(energy_change     ? *energy_change
                                   : number_of_cones ? -std::numeric_limits<double>::infinity()
                                                     : default_energy_change(components.genus(c)));
  return limits;
}

/// The loops, then the arcs.
template <typename TriangleMesh>
std::vector<std::vector<int>> strips_of(const Mesh_indexing<TriangleMesh>& indexing,
                                        const Holonomy_signature<TriangleMesh>& signature)
{
  std::vector<std::vector<int>> strips;
  const auto add = [&](const auto& loops_or_arcs) {
    for (const auto& loop_or_arc : loops_or_arcs) {
      strips.emplace_back();
      for (const auto h : loop_or_arc.halfedges)
        strips.back().push_back(indexing.halfedge_index(h));
    }
  };
  add(signature.loops());
  add(signature.arcs());
  return strips;
}

/// The angle defects that cones have to make up for: corners stay.
template <typename TriangleMesh>
std::vector<double> defects_without_corners(const Signature_domain<TriangleMesh>& domain,
                                            const Holonomy_signature<TriangleMesh>& signature)
{
  std::vector<double> defects = angle_defects(domain.m_connectivity, domain.m_geometry);
  for (const auto& [v, k] : signature.corners())
    defects[domain.m_indexing.vertex_index(v)] -=
        (Holonomy_signature<TriangleMesh>::regular_on_border - k) * quarter_turn;
  return defects;
}

/// Where quarter turns of cones may go that have fewer than 3 or more than 6.
template <typename TriangleMesh>
std::vector<int> split_targets(const Signature_domain<TriangleMesh>& mesh,
                               const Holonomy_signature<TriangleMesh>& signature, Progress& progress)
{
  std::vector<int> cones;
  for (const auto& [v, k] : signature.cones())
    if (k < fewest_quarter_turns || k > most_quarter_turns)
      cones.push_back(mesh.m_indexing.vertex_index(v));
  if (cones.empty())
    return {};
  std::sort(cones.begin(), cones.end());
  // Each of them costs a solve.
  const std::size_t most = std::clamp<std::size_t>(20'000'000 / mesh.m_connectivity.number_of_vertices(), 16, 400);
  return split_targets(mesh.m_connectivity, mesh.m_geometry, mesh.m_components, cones,
                       disk_radii(mesh.m_geometry, mesh.m_components), most, progress);
}

/// The numbers of cones and strips. \param region per vertex: quarter turns move within it
template <typename TriangleMesh>
Cones_and_strips cones_and_strips(const Signature_domain<TriangleMesh>& mesh,
                                  const Holonomy_signature<TriangleMesh>& signature, const std::vector<int>& vertices,
                                  const std::vector<int>& region)
{
  Cones_and_strips numbers;
  for (const int v : vertices) {
    numbers.component.push_back(region[v]);
    numbers.quarter_turns.push_back(signature.quarter_turns(mesh.m_indexing.vertex(v)));
  }
  for (const auto& loop : signature.loops())
    numbers.strip_quarter_turns.push_back(loop.quarter_turns);
  for (const auto& arc : signature.arcs())
    numbers.strip_quarter_turns.push_back(arc.quarter_turns);
  return numbers;
}

/// reduces with computed energies and writes the signature and the report; the signature stays what it was if `progress`
/// is interrupted.
/// \param moves_strips whether numbers of loops and arcs may change without a path of edges that they cross
template <typename TriangleMesh, typename Reduction>
void reduce_cones(const Signature_domain<TriangleMesh>& mesh, const std::vector<int>& vertices, Reduction& reduction,
                  const Cone_reduction_limits& limits, const bool moves_strips, Progress& progress,
                  Holonomy_signature<TriangleMesh>& signature, Cone_reduction_report<TriangleMesh>& report)
{
  const auto straighten = [&] { return moves_strips ? reduction.straighten_strips() : 0; };
  report.number_of_cones_before = reduction.number_of_cones();
  report.energy_before = reduction.energy();
  report.number_of_loop_turns = straighten();
  report.number_of_splits = reduction.split();
  for (int turns = 1; turns > 0; report.number_of_loop_turns += turns) {
    reduction.reduce(limits);
    turns = straighten();
    if (progress.is_interrupted())
      return;
  }
  report.number_of_cones = reduction.number_of_cones();
  report.number_of_merges = static_cast<int>(reduction.merges().size());
  report.energy = reduction.energy();
  for (const Cone_move& move : reduction.merges())
    report.largest_energy_change = (std::max)(report.largest_energy_change, move.energy_change);
  if (report.number_of_cones > limits.number_of_cones)
    report.status = Cone_reduction_status::LIMIT_UNREACHABLE;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    signature.set_quarter_turns(mesh.m_indexing.vertex(vertices[i]), reduction.signature().quarter_turns[i]);
  const std::vector<int>& turns = reduction.signature().strip_quarter_turns;
  for (std::size_t l = 0; l < signature.loops().size(); ++l)
    signature.set_loop_quarter_turns(l, turns[l]);
  for (std::size_t a = 0; a < signature.arcs().size(); ++a)
    signature.set_arc_quarter_turns(a, turns[signature.loops().size() + a]);
}

/// reduces with computed energies, and with the field that there may be; where there is too little room for a field to turn as
/// the merges want it, cones stay.
/// \return false if the solver fails; then, and if `progress` is interrupted, signature and field stay as they are
template <typename TriangleMesh, typename ScaleEnergy, typename NamedParameters, typename SolverTraits>
bool reduce_cones_and_field(const Signature_domain<TriangleMesh>& domain, const ScaleEnergy& energy,
                            const std::vector<int>& vertices, const std::vector<std::vector<int>>& strips,
                            const NamedParameters& np, SolverTraits& solver, Progress& progress,
                            Holonomy_signature<TriangleMesh>& signature, Cone_reduction_report<TriangleMesh>& report)
{
  constexpr bool has_field = has_cross_field_map<NamedParameters>;
  const Cone_reduction_report<TriangleMesh> before = report;
  Cone_regions regions(domain, np);
  std::optional<Moved_field> field;
  if constexpr (has_field)
    field.emplace(domain, regions, np);
  while (!progress.is_interrupted()) {
    Cone_paths paths(domain.m_connectivity, regions.edge_lengths(), vertices, strips, progress);
    Cone_reduction<ScaleEnergy, Cone_paths> reduction(
        energy, paths, cones_and_strips(domain, signature, vertices, regions.of_vertex()), progress);
    Holonomy_signature<TriangleMesh> reduced = signature;
    report = before;
    reduce_cones(domain, vertices, reduction, regions.limits(cone_reduction_limits(domain.m_components, np)),
                 !has_field && !regions.has_constraints(), progress, reduced, report);
    if (progress.is_interrupted())
      break;
    if constexpr (has_field) {
      if (!field->compute(reduction.moves(), paths, solver, progress))
        return progress.is_interrupted();
      const std::vector<int> overturned = field->overturned_edges();
      if (!overturned.empty() && regions.separate(domain.m_connectivity, overturned, vertices))
        continue;
      field->write(domain, np);
    }
    signature = std::move(reduced);
    break;
  }
  return true;
}

} // namespace internal

/// \ingroup PkgTSplinesCrossField
/// merges cones of a holonomy signature, so that few are left: each extraordinary vertex costs a T-spline rings of
/// control points.
///
/// A cone a is merged into a cone b of the same component by moving k_a - 4 quarter turns along a shortest path of
/// edges: a becomes regular, k_b becomes k_b + k_a - 4, and the numbers of the loops and arcs that cross the path change
/// as often. Corners on the border stay what they are. The signature stays admissible: it is that of a cross field which turns by as many quarter turns more across
/// the path. No field is needed.
///
/// The merge that raises the energy least, or lowers it most, is always next. The energy is one half of the integral of
/// |xi|^2, where xi is the differential of the logarithm of the scale of the similarity map with this signature, in the
/// linear approximation of conformal maps and with cones spread over small disks: how much the sizes of the map's
/// elements differ. It is that of the rotation of the smoothest cross field with this signature, too (Crane, Desbrun,
/// Schroeder, Trivial connections on discrete surfaces, 2010). All its changes come from Green's functions of the cones
/// and one harmonic form for each loop and arc, which are computed once.
///
/// Before, what a field on a coarse mesh has got wrong is put right where that lowers the energy: numbers of loops and
/// arcs change by quarter turns, and cones of fewer than three or more than six quarter turns get some from other vertices, or give
/// some away. A box of twelve triangles has its cones at its corners, then. Loops and arcs are tried again after merges.
///
/// Merges leave numbers of three to six quarter turns. Only if the demanded number of cones cannot be reached so,
/// others from two upwards are made, and if need be from one upwards.
///
/// Where edges are constrained, because a field follows them, cones on them stay what they are, and so do the numbers of
/// loops and arcs but for what paths that avoid these edges do to them. With a cross field that has the signature, the
/// field is changed to one that has the new signature: along the paths its crosses turn by as many quarter turns more,
/// and are then relaxed, but in the faces of constrained and of border edges. Where crosses of neighboring faces would have to
/// differ by more than a quarter turn, the part between constrained edges keeps its cones.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh a triangle mesh, of one or more components, with or without border
/// \param signature an admissible signature of `mesh`; it is changed if the status is REDUCED or LIMIT_UNREACHABLE, and
///        stays what it was otherwise
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
///   \cgalParamNBegin{maximum_energy_change}
///     \cgalParamDescription{merges go on as long as the next one raises the energy by at most this much}
///     \cgalParamType{`std::optional<double>`}
///     \cgalParamDefault{6 for components of genus 0, 3 for genus 1, 4 for others; minus infinity if
///       `maximum_number_of_cones` is given}
///     \cgalParamExtra{It depends neither on the size nor, much, on the resolution of the mesh. With 0 only those cones
///       are merged that do more harm than good.}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_cones}
///     \cgalParamDescription{merges go on until at most so many cones are left in the whole mesh, whatever they cost}
///     \cgalParamType{`std::optional<int>`}
///     \cgalParamDefault{no limit}
///     \cgalParamExtra{With `maximum_energy_change` they go on beyond that as long as they are cheap. A closed component
///       of genus 0 needs three cones, one of genus 1 none, others one; one with a border needs none if its corners
///       satisfy the theorem of Gauss and Bonnet, else one.}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{the edges that a cross field follows: no quarter turn moves onto them or across them}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%edge_descriptor` ->
///       `bool`}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{cross_field_map}
///     \cgalParamDescription{one of the four directions of a cross field with the signature, in each face; receives those of
///       one with the new signature. It is as smooth as can be, see `curvature_alignment`}
///     \cgalParamType{a model of `ReadWritePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` ->
///       a three-dimensional vector, constructible from three `double`s}
///     \cgalParamDefault{none: no field is needed}
///     \cgalParamExtra{Numbers of loops and arcs are then not changed but by merges.}
///   \cgalParamNEnd
///   \cgalParamNBegin{halfedge_matching_map}
///     \cgalParamDescription{the matchings of the cross field, as `compute_smooth_cross_field()` writes them; receives
///       those of the new one}
///     \cgalParamType{a model of `ReadWritePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` ->
///       an integer}
///     \cgalParamDefault{the closest rotation decides}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_alignment}
///     \cgalParamDescription{how near the new cross field stays to the one that is given, a number w >= 0: in parts of the surface
///       larger than the square root of area / w}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: it is the smoothest field with the new signature that follows the constrained edges}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits` with `FT = double`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done. Equal input gives equal results.
///
/// Complexity: with m cones, and if some are to be split up to 400 vertices more, a sparse factorization of one row per
/// vertex and m + 2g + b solves with b closed curves of the border, O(m^2) numbers of memory, O(m^2) per merge, and if g > 0 at most two searches of
/// shortest paths per cone. Where m^2 g exceeds some millions only the nearest cones are merged with each other, from at
/// least eight per cone to all when few are left.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Cone_reduction_report<TriangleMesh> reduce_cones(const TriangleMesh& mesh, Holonomy_signature<TriangleMesh>& signature,
                                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("cone reduction");
  Cone_reduction_report<TriangleMesh> report;
  {
    const internal::Progress::Part part(progress, 0, 0.1);
    report.signature = internal::holonomy_signature_report(mesh, signature, np, progress);
  }
  if (progress.is_interrupted()) {
    report.status = Cone_reduction_status::INTERRUPTED;
    return report;
  }
  if (!report.signature.success()) {
    report.status = report.signature.mesh.success() ? Cone_reduction_status::INVALID_SIGNATURE
                                                    : Cone_reduction_status::INVALID_MESH;
    return report;
  }
  const internal::Signature_domain<TriangleMesh> domain(mesh, np);
  std::vector<int> vertices;
  for (const auto& cone : signature.cones())
    vertices.push_back(domain.m_indexing.vertex_index(cone.first));
  for (const int v : internal::split_targets(domain, signature, progress))
    vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end()); // the order in which cones were set must not matter
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const std::vector<std::vector<int>> strips = internal::strips_of(domain.m_indexing, signature);
  auto&& solver = internal::sparse_linear_solver(np);
  internal::Scale_energy<std::remove_reference_t<decltype(solver)>> energy(
      domain.m_connectivity, domain.m_geometry, domain.m_components,
      internal::defects_without_corners(domain, signature), strips, solver, progress);
  bool is_computed = false;
  {
    const internal::Progress::Part part(progress, 0.1, 0.5);
    is_computed = energy.compute(vertices, progress);
  }
  if (is_computed) {
    const internal::Progress::Part part(progress, 0.5, 1);
    is_computed =
        internal::reduce_cones_and_field(domain, energy, vertices, strips, np, solver, progress, signature, report);
  }
  if (progress.is_interrupted())
    report.status = Cone_reduction_status::INTERRUPTED;
  else if (!is_computed)
    report.status = Cone_reduction_status::SOLVER_FAILED;
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_REDUCE_CONES_H
