// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_MAKE_SPLINE_COMPATIBLE_H
#define CGAL_T_SPLINES_T_MESH_MAKE_SPLINE_COMPATIBLE_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>
#include <CGAL/T_splines/T_mesh/internal/Counted_splits.h>
#include <CGAL/T_splines/T_mesh/internal/Spline_compatibility_repair.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// What `make_spline_compatible()` did. If it did not succeed, `status` tells what is still wrong; the numbers are
/// always set but for INADMISSIBLE, and `vertices_in_rings` only upon success.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph>
struct Spline_refinement_report : Spline_compatibility_report<Graph> {
  std::size_t vertices_before = 0,             ///< of the T-mesh that was given
      vertices_after = 0;                      ///< of the changed T-mesh
  std::size_t faces_before = 0,                ///< of the T-mesh that was given
      faces_after = 0;                         ///< of the changed T-mesh
  std::size_t extraordinary_vertices = 0;      ///< their number
  std::size_t vertices_in_rings = 0;           ///< afterwards, the extraordinary vertices included
  std::size_t splits_for_rings = 0;            ///< condition A
  std::size_t splits_at_border = 0;            ///< TOO_FEW_BORDER_INTERVALS, BORDER_IN_RINGS
  std::size_t splits_of_reaching_supports = 0; ///< condition B, SUPPORT_REACHES_CONE
  std::size_t splits_of_endless_supports = 0;  ///< condition B, ENDLESS_SUPPORT
  bool is_limit_reached = false;               ///< the allowed number of splits was not enough
};

namespace internal {

// The vertices of all rings, each once.
template <typename FT>
std::size_t number_of_vertices_in_rings(const Spline_structure<FT>& structure)
{
  const auto& arrays = structure.arrays();
  std::vector<char> is_in_rings(arrays.number_of_original_vertices());
  for (const Regular_rings<FT>& rings : structure.rings())
    for (int sector = 0; sector < rings.valence(); ++sector)
      for (int x = 0; x < 3; ++x)
        for (int y = 0; y < (x < 2 ? 3 : 2); ++y)
          for (int side = 0; side < 4; ++side)
            is_in_rings[arrays.original_vertex(arrays.source(arrays.first_of_side(rings.face(sector, x, y), side)))] =
                true;
  return std::count(is_in_rings.begin(), is_in_rings.end(), true);
}

// Fills in the numbers before; false if refinement cannot help.
template <typename TMesh, typename NamedParameters>
bool is_repairable(const TMesh& t_mesh, const NamedParameters& np, Progress& progress,
                   Spline_refinement_report<typename TMesh::Graph>& report)
{
  Spline_compatibility_report<typename TMesh::Graph>& result = report;
  if (!is_known_admissible(t_mesh, np, progress, result))
    return false;
  const Mesh_indexing<typename TMesh::Graph> indexing(t_mesh.graph());
  const Spline_structure<double> structure(indexing, t_mesh, progress);
  set_defect(structure.in_graph(structure.check_vertices()), indexing, result);
  report.extraordinary_vertices = structure.extraordinary_vertices().size();
  report.vertices_before = report.vertices_after = indexing.number_of_vertices();
  report.faces_before = report.faces_after = indexing.number_of_faces();
  return report.success();
}

template <typename TMesh>
void count_elements(const TMesh& t_mesh, Progress& progress, Spline_refinement_report<typename TMesh::Graph>& report)
{
  const Mesh_indexing<typename TMesh::Graph> indexing(t_mesh.graph());
  Spline_structure<double> structure(indexing, t_mesh, progress);
  report.vertices_after = indexing.number_of_vertices();
  report.faces_after = indexing.number_of_faces();
  report.extraordinary_vertices = structure.extraordinary_vertices().size();
  if (report.success() && !progress.is_interrupted() && !structure.check_rings())
    report.vertices_in_rings = number_of_vertices_in_rings(structure);
}

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// splits faces of a T-mesh with halfedge knots until it carries a T-spline surface: until `check_spline_compatibility()`
/// holds ([CZ17] section 8.2).
///
/// - Each extraordinary vertex whose three rings are not regular gets rings, as large as the edges at it and its
///   extraordinary neighbours allow.
/// - Where the border is too close, lines are inserted parallel to it.
/// - Where a support reaches a face at an extraordinary vertex from outside of the second ring, a face that it covers
///   beyond the rings is split, so that it ends there.
/// - Where a support winds around the centre of a spiral, the faces around this point are split until each is smaller
///   than half of its distance from the point.
///
/// Edges are only inserted, by `T_mesh_editor`, each through one face. It ends: why, and what bounds the number of
/// splits, is told in `internal/Spline_compatibility_repair.h`. Lines are inserted at vertices of the faces, where there
/// are any close by, or at short fractions of their sides, so that exact knots stay short. New vertices have no point and
/// no weight: an observer, or `place_T_mesh()` afterwards, gives them one.
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph`, `FaceListGraph` and `HalfedgeListGraph`
/// \param t_mesh the T-mesh that is changed
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{observer}
///     \cgalParamDescription{what follows the changes of the T-mesh}
///     \cgalParamType{a model of `TMeshObserver`, copied}
///     \cgalParamDefault{`T_mesh_observer`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the largest number of splits}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{1000 and 30 per face}
///     \cgalParamExtra{T-meshes need about 10 per face; the limit ends the work on those that spiral so tightly that
///       ever smaller faces would follow.}
///   \cgalParamNEnd
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{as for `check_admissibility()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_relative_tolerance`, 1e-9; 0 for exact number types}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return whether the T-mesh is spline compatible now, and how many splits were made for what. Nothing is changed if
///         the status is INADMISSIBLE or TOUCHING_BORDERS. If it is INTERRUPTED, the T-mesh has
///         the splits so far: it is admissible, and may be given to this function again.
/// Complexity: linear in the number of pairs of a vertex and a face of its support, for a few rounds; most of them look
/// only at a few vertices.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Spline_refinement_report<T_mesh_graph<TMesh>>
make_spline_compatible(TMesh&& t_mesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Graph = T_mesh_graph<TMesh>;
  using View = T_mesh_view_of<TMesh>;
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("spline compatibility");
  const View view(t_mesh);
  Spline_refinement_report<Graph> report;
  Spline_compatibility_report<Graph>& result = report;
  if (!internal::is_repairable(view, np, progress, report))
    return report;
  progress.progress(0.2);
  const std::size_t number_of_splits =
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 1000 + 30 * report.faces_before);
  const auto observer = choose_parameter(get_parameter(np, np_tags::observer), T_mesh_observer());
  using Splits = internal::Counted_splits<View, std::decay_t<decltype(observer)>>;
  Splits splits(view, observer, number_of_splits, progress);
  internal::Spline_compatibility_repair<Splits> repair(splits);
  const bool is_repaired = repair.run();
  progress.progress(0.8);
  if (!is_repaired && progress.go_on()) {
    result = internal::spline_compatibility_report(view, np, progress);
    report.is_limit_reached = !report.success() && splits.is_exhausted();
  }
  report.splits_for_rings = repair.counts().rings;
  report.splits_at_border = repair.counts().border;
  report.splits_of_reaching_supports = repair.counts().reaching_supports;
  report.splits_of_endless_supports = repair.counts().endless_supports;
  internal::count_elements(view, progress, report);
  if (progress.is_interrupted())
    result.status = Spline_compatibility_status::INTERRUPTED;
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_MAKE_SPLINE_COMPATIBLE_H
