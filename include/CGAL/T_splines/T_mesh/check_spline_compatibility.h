// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_CHECK_SPLINE_COMPATIBILITY_H
#define CGAL_T_SPLINES_T_MESH_CHECK_SPLINE_COMPATIBILITY_H

#include <CGAL/T_splines/T_mesh/Spline_compatibility_report.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/T_mesh/support/Spline_structure.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL {
namespace T_splines {
namespace internal {

// Writes what a defect says into a report; the numbers that it has stay.
template <typename Graph>
void set_defect(const Spline_defect& defect, const Mesh_indexing<Graph>& indexing,
                Spline_compatibility_report<Graph>& report)
{
  report.status = defect.status;
  if (defect.vertex >= 0)
    report.vertex = indexing.vertex(defect.vertex);
  if (defect.extraordinary_vertex >= 0)
    report.extraordinary_vertex = indexing.vertex(defect.extraordinary_vertex);
  if (defect.face >= 0)
    report.face = indexing.face(defect.face);
}

// The first defect but for those of supports.
template <typename KnotFT, typename FT>
Spline_defect defect_before_supports(Spline_structure<KnotFT, FT>& structure)
{
  Spline_defect defect = structure.check_vertices();
  if (!defect)
    defect = structure.check_rings();
  if (!defect)
    defect = structure.find_knots();
  return defect;
}

// Checks admissibility; writes what is wrong.
template <typename TMesh, typename NamedParameters>
bool is_known_admissible(const TMesh& t_mesh, const NamedParameters& np, Progress& progress,
                         Spline_compatibility_report<T_mesh_graph<TMesh>>& report)
{
  report.admissibility = admissibility_report(t_mesh, np, progress);
  if (report.admissibility)
    return true;
  report.status =
      progress.is_interrupted() ? Spline_compatibility_status::INTERRUPTED : Spline_compatibility_status::INADMISSIBLE;
  report.vertex = report.admissibility.vertex;
  report.face = report.admissibility.face;
  return false;
}

// What `check_spline_compatibility()` does; no stage is begun.
template <typename TMesh, typename NamedParameters>
Spline_compatibility_report<T_mesh_graph<TMesh>>
spline_compatibility_report(const TMesh& t_mesh, const NamedParameters& np, Progress& progress)
{
  using FT = typename TMesh::FT;
  Spline_compatibility_report<T_mesh_graph<TMesh>> report;
  if (!is_known_admissible(t_mesh, np, progress, report))
    return report;
  const Mesh_indexing<T_mesh_graph<TMesh>> indexing(t_mesh.graph());
  Spline_structure<FT> structure(indexing, Const_T_mesh_view_of<TMesh>(t_mesh), progress);
  Spline_defect defect = defect_before_supports(structure);
  progress.progress(0.5);
  if (!defect)
    defect = structure.find_supports(
        [&](int, const Basis_support<FT>& support) { report.self_overlapping_supports += support.overlaps_itself(); });
  set_defect(structure.in_graph(defect), indexing, report);
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// checks whether a T-mesh with halfedge knots carries a T-spline surface ([CZ17] section 4.1.3).
///
/// Beyond admissibility these are the conditions:
/// - A: each extraordinary vertex, one on the border of extended valence 3 or more among them, is surrounded by three rings of square faces of one size (in a common unit) that meet
///   edge to edge. T-joints may lie on the outer rim of the third ring, where they change nothing inside;
/// - B: the support of a vertex reaches a face at an extraordinary vertex only if it belongs to the vertex's first two
///   rings, or is that vertex, and only from there; and it has finitely many pieces: it does not contain the centre of
///   a spiral, around which faces become smaller and smaller.
///
/// Condition C of the paper, that no support overlaps itself, is not needed: a support is an immersed rectangle, and a
/// face that it covers on two ways around the surface is two pieces of it, each with its own transition to the frame of
/// the vertex. How many supports do so is told.
///
/// Extraordinary vertices may have any extended valence, and the border may turn outwards or inwards by any number of
/// quarters. Between two borders there must be at least three intervals in each row.
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`, with
///         or without border
/// \param t_mesh the T-mesh
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
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
/// \return the first defect: the status, which names the condition, and the elements. The report converts to `true` if
///         there is none. With exact knots all decisions are exact.
///
/// Complexity: linear in the number of pairs of a vertex and a piece of its support, but for a logarithm.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Spline_compatibility_report<T_mesh_graph<TMesh>>
check_spline_compatibility(const TMesh& t_mesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("spline compatibility");
  return internal::spline_compatibility_report(t_mesh, np, progress);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_CHECK_SPLINE_COMPATIBILITY_H
