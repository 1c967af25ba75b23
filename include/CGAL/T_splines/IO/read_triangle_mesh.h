// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_TRIANGLE_MESH_H
#define CGAL_T_SPLINES_IO_READ_TRIANGLE_MESH_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/build_triangle_mesh.h>
#include <CGAL/T_splines/IO/internal/read_triangle_soup.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <optional>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// reads an oriented triangle mesh from an OFF, OBJ, PLY or STL file and refuses, naming line and element,
/// everything that the algorithms of this package cannot use.
///
/// Vertices and faces of `mesh` come in the order of the file, so that files that refer to them by number (cones, fields) fit.
/// That is why little is changed that was not asked for, and nothing in silence:
/// - Refused: what `Mesh_reading_status` lists. The report says whether `repair(true)` or a larger `merge_distance` would
///   help: both have been tried.
/// - Accepted: borders, but for cracks (see `border_is_allowed`); several components; texture coordinates, normals, colours and other data, which are not read; an inside-out
///   orientation.
/// - Changed, and said by `note()`: faces with more than three corners are triangulated (their triangles follow each other, in place of
///   the face), quadrilaterals by the better diagonal; the corners of STL facets become one vertex where their coordinates are identical;
///   ends of boundary edges are merged, see below.
///
/// **Merging.** Two boundary edges that coincide become one edge, if each is the nearest to the other: this closes what
/// was split along seams of texture coordinates or normals, or by the round-off of the program that wrote the file. Of the
/// vertices that become one, the first keeps its place. Where more than two edges coincide, as where bodies touch, those
/// are merged that follow each other around the edge inside of a body. Nothing is merged where a face would get the same
/// vertex twice, or an edge more than two faces. Vertices that are no ends of boundary edges stay what they are.
///
/// **Repair.** In this order: ends of edges not longer than `merge_distance` become one vertex; faces with less than
/// three different corners, repeated corners and duplicate faces are removed; ends of boundary edges are merged; faces
/// are turned so that neighbours agree with each other and with most of their component, and vertices are split where an
/// edge has more than two faces or the faces around a vertex are several fans
/// (`CGAL::Polygon_mesh_processing::orient_polygon_soup()`); isolated vertices are removed; triangles of area zero are
/// removed by flips and collapses of edges. Holes are not filled. The rest keeps its order.
///
/// Coordinates are read to the nearest double. The readers of CGAL are not used, because they do not say what is wrong with a
/// file and where, and accept files whose counts are wrong.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param filename a file whose extension, in any case, says what it is
/// \param mesh the mesh to which the triangles are appended; untouched if the file is refused
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{receives the points of `mesh`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<MutableFaceGraph>::%vertex_descriptor` ->
///       a point that is constructible from three `double`s}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{merge_distance}
///     \cgalParamDescription{up to which ends of edges coincide, relative to the longest side of the bounding box}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_merge_distance`}
///     \cgalParamExtra{0 merges what coincides exactly, a negative number nothing (in a repair, as 0).}
///   \cgalParamNEnd
///   \cgalParamNBegin{repair}
///     \cgalParamDescription{whether the mesh is repaired, as said above}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{border_is_allowed}
///     \cgalParamDescription{whether the surface may have a border}
///     \cgalParamType{`std::optional<bool>`, or `bool`}
///     \cgalParamDefault{nothing: it may, but not where merging up to 1e-3 would close it altogether}
///     \cgalParamExtra{Such cracks are hardly ever meant: the report says which `merge_distance` closes them.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended; never throws but for lack of memory. Complexity: O(n log n) in the size of the file.
template <typename MutableFaceGraph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Mesh_reading_report read_triangle_mesh(const std::string& filename, MutableFaceGraph& mesh,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  if (!internal::is_output_graph(mesh)) {
    Mesh_reading_report report;
    report.status = Mesh_reading_status::OUTPUT_NOT_EMPTY;
    return report;
  }
  internal::Polygon_soup soup;
  internal::Triangle_soup triangles;
  internal::Mesh_reading_options options;
  options.merge_distance = choose_parameter(get_parameter(np, np_tags::merge_distance), default_merge_distance);
  options.is_repaired = choose_parameter(get_parameter(np, np_tags::repair), false);
  const std::optional<bool> border_is_allowed =
      choose_parameter(get_parameter(np, np_tags::border_is_allowed), std::optional<bool>());
  options.is_boundary_admitted = border_is_allowed.value_or(true);
  options.are_cracks_admitted = border_is_allowed.has_value();
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("reading");
  const Mesh_reading_report report = internal::read_triangle_soup(filename, options, soup, triangles, progress);
  if (report.success())
    internal::build_triangle_mesh(soup, triangles, mesh,
                                  choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                   get_property_map(CGAL::vertex_point, mesh)));
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_TRIANGLE_MESH_H
