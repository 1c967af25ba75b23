// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_T_MESH_H
#define CGAL_T_SPLINES_IO_READ_T_MESH_H

#include <CGAL/T_splines/IO/T_mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/T_mesh_soup.h>
#include <CGAL/T_splines/IO/internal/build_t_mesh.h>
#include <CGAL/T_splines/IO/internal/check_t_mesh_knots.h>
#include <CGAL/T_splines/IO/internal/check_t_mesh_soup.h>
#include <CGAL/T_splines/IO/internal/own_weights.h>
#include <CGAL/T_splines/IO/internal/parse_t_mesh_ply.h>
#include <CGAL/T_splines/IO/internal/read_whole_file.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {

namespace internal {

/// What `read_t_mesh()` does with the content of a file.
template <typename TMesh, typename NamedParameters>
T_mesh_reading_report read_t_mesh_text(const std::string_view content, TMesh& t_mesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const T_mesh_view_of<TMesh> view(t_mesh);
  if (!is_output_graph(view.graph())) {
    T_mesh_reading_report report;
    report.status = T_mesh_reading_status::OUTPUT_NOT_EMPTY;
    return report;
  }
  const auto visitor = progress_visitor(np);
  Progress progress(visitor);
  progress.begin_stage("reading");
  progress.go_on();
  T_mesh_soup soup;
  const T_mesh_reading_report parsed = T_mesh_ply_parser(content, soup).parse(progress);
  T_mesh_reading_report interrupted;
  interrupted.status = T_mesh_reading_status::INTERRUPTED;
  progress.progress(0.5);
  if (!progress.go_on())
    return interrupted;
  if (!parsed.success())
    return parsed;
  T_mesh_reading_report report = check_t_mesh_soup(soup);
  if (report.success() && progress.go_on())
    report = check_t_mesh_knots(
        soup, choose_parameter(get_parameter(np, np_tags::relative_tolerance), default_relative_tolerance), progress);
  progress.progress(0.9);
  if (!progress.go_on())
    return interrupted;
  report.number_of_vertices = parsed.number_of_vertices;
  report.number_of_faces = parsed.number_of_faces;
  if (!report.success())
    return report;

  const T_mesh_builder builder(soup, view);
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_property_map(CGAL::vertex_point, view.graph()));
  const auto weight_map = choose_parameter(get_parameter(np, np_tags::vertex_weight_map), own_weights(t_mesh));
  using Point = typename boost::property_traits<decltype(point_map)>::value_type;
  for (std::size_t v = 0; v < soup.number_of_vertices(); ++v) {
    const std::array<double, 4>& p = soup.points[v];
    put(point_map, builder.vertex_of(v), Point(p[0], p[1], p[2]));
    put(weight_map, builder.vertex_of(v), p[3]);
  }
  return report;
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads a T-mesh with halfedge knots from a PLY file with the properties that `write_t_mesh()` describes, and refuses,
/// naming line and element, everything that is not an admissible T-mesh ([CZ17] section 4).
///
/// Files that another program has rewritten are read, too: made of text or binary in either byte order, with the
/// properties in any order and of any type, and with other elements and properties, which are skipped.
///
/// Vertices and faces of `t_mesh` come in the order of the file, and `halfedge(f)` is the first edge of the list of
/// `f`: so the frames of the faces are those of the T-mesh that was written. The surface may have a border, and the
/// T-mesh need not be simple: a face may have a vertex or an edge twice.
///
/// Edges are creases where the file says so; files without the list `crease` have none. On the border the list means
/// nothing, as an edge of the border is no crease. If `t_mesh` has no map of creases, they are lost, and the surface is
/// another one.
///
/// Knot intervals are admissible if the sums on opposite sides of a face and the products of ratios around a vertex
/// agree up to a relative tolerance. Doubles are exact in an exact number type; but T-meshes whose knots were rounded
/// when they were written are not exactly admissible.
///
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph`, `FaceListGraph` and `HalfedgeListGraph`, a
///   `T_spline` for instance; its knots are made from doubles
/// \param in the content of the file; it is read to the end
/// \param t_mesh empty; untouched if the file is refused. Knots and corners are not written on border halfedges
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{receives the control points}
///     \cgalParamType{a model of `WritablePropertyMap`, vertex of the T-mesh -> `%Point_3`}
///     \cgalParamDefault{the map of the graph for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_weight_map}
///     \cgalParamDescription{receives the weights of the control points}
///     \cgalParamType{a model of `WritablePropertyMap`, vertex of the T-mesh -> number}
///     \cgalParamDefault{that of a `T_spline`; of others, the weights are not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{as for `check_admissibility()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_relative_tolerance`, 1e-9}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended. Complexity: linear in the size of the file.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_mesh_reading_report read_t_mesh(std::istream& in, TMesh&& t_mesh,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  std::string content;
  if (internal::read_whole_stream(in, content))
    return internal::read_t_mesh_text(content, t_mesh, np);
  T_mesh_reading_report report;
  report.status = T_mesh_reading_status::CANNOT_OPEN;
  return report;
}

/// \ingroup PkgTSplinesIO
/// reads a T-mesh with halfedge knots from a PLY file.
///
/// \param filename a file; its extension does not matter
/// \param t_mesh, np see the function that reads from a stream
/// \return how it ended. Complexity: linear in the size of the file.
template <typename TMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_mesh_reading_report read_t_mesh(const std::string& filename, TMesh&& t_mesh,
                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  std::string content;
  if (internal::read_whole_file(filename, content))
    return internal::read_t_mesh_text(content, t_mesh, np);
  T_mesh_reading_report report;
  report.status = T_mesh_reading_status::CANNOT_OPEN;
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_T_MESH_H
