// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_MAP_OBJ_H
#define CGAL_T_SPLINES_IO_READ_MAP_OBJ_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/build_triangle_mesh.h>
#include <CGAL/T_splines/IO/internal/read_triangle_soup.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The first corner without texture coordinates.
inline Mesh_reading_report check_uv_of_corners(const Polygon_soup& soup)
{
  Mesh_reading_report report;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    for (std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c)
      if (soup.uv_corners.empty() || soup.uv_corners[c] == Polygon_soup::no_uv) {
        report.status = Mesh_reading_status::MISSING_UV;
        report.line = soup.line_of_polygon(f);
        report.face = f;
        report.vertex = soup.corners[c];
        return report;
      }
  return report;
}

/// Copies the texture coordinates of the corners to the halfedges that point to them. \pre The mesh was built from the triangles alone.
template <typename FaceGraph, typename HalfedgeUVMap>
void put_uv_of_corners(const Polygon_soup& soup, const Triangle_soup& triangles,
                       const Mesh_indexing<FaceGraph>& indexing, const HalfedgeUVMap uv_map)
{
  using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
  const FaceGraph& mesh = indexing.graph();
  for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
    const auto first = halfedge(indexing.face(static_cast<int>(t)), mesh);
    for (const auto h : CGAL::halfedges_around_face(first, mesh)) {
      const std::size_t v = static_cast<std::size_t>(indexing.vertex_index(target(h, mesh)));
      for (std::size_t i = 0; i < 3; ++i)
        if (triangles.triangles[t][i] == v) {
          const std::array<double, 2>& uv = soup.uvs[soup.uv_corners[triangles.corners[t][i]]];
          put(uv_map, h, Point_2(uv[0], uv[1]));
        }
    }
  }
}

/// Whether the two faces of an edge give different uv to one of its ends.
template <typename FaceGraph, typename HalfedgeUVMap>
bool is_seam(const typename boost::graph_traits<FaceGraph>::halfedge_descriptor h, const FaceGraph& mesh,
             const HalfedgeUVMap uv_map)
{
  const auto g = opposite(h, mesh);
  return get(uv_map, h) != get(uv_map, prev(g, mesh)) || get(uv_map, g) != get(uv_map, prev(h, mesh));
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads a triangle mesh with uv per corner from an OBJ file: what `write_map_obj()` writes, or the map of another program.
///
/// It is as strict as `read_triangle_mesh()`, but surfaces with boundary are accepted, and no vertices are merged. Faces with more than three corners are
/// triangulated in space. Nothing is asked of the uv but that every corner has it and that it is finite.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph`
/// \tparam HalfedgeUVMap a model of `ReadWritePropertyMap`, halfedge -> `Point_2`
/// \param filename a file with the extension `.obj`
/// \param mesh receives vertices and faces in the order of the file; it must be empty, which is checked; untouched if the
///   file is refused
/// \param uv_map receives for each halfedge the uv of its *target* on its *face*; not written on border halfedges
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{receives the points of `mesh`}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<MutableFaceGraph>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_cut_map}
///     \cgalParamDescription{receives `true` for the seams, the inner edges whose two faces give different uv to one of
///       their ends, bit by bit, and `false` for all others}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<MutableFaceGraph>::%edge_descriptor` ->
///       `bool`}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return how it ended. Complexity: O(n log n) in the size of the file.
template <typename MutableFaceGraph, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Mesh_reading_report read_map_obj(const std::string& filename, MutableFaceGraph& mesh, const HalfedgeUVMap uv_map,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using edge_descriptor = typename boost::graph_traits<MutableFaceGraph>::edge_descriptor;
  internal::Polygon_soup soup;
  internal::Triangle_soup triangles;
  Mesh_reading_report report;
  if (!internal::is_output_graph(mesh))
    report.status = Mesh_reading_status::OUTPUT_NOT_EMPTY;
  else if (internal::lowercase_extension(filename) != ".obj")
    report.status = Mesh_reading_status::UNKNOWN_FORMAT;
  else {
    internal::Mesh_reading_options options;
    options.is_boundary_admitted = true;
    const auto visitor = internal::progress_visitor(np);
    internal::Progress progress(visitor);
    progress.begin_stage("reading");
    report = internal::read_triangle_soup(filename, options, soup, triangles, progress);
  }
  if (report.success()) {
    const Mesh_reading_report uv_report = internal::check_uv_of_corners(soup);
    if (!uv_report.success())
      return uv_report;
    internal::build_triangle_mesh(soup, triangles, mesh,
                                  choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                   get_property_map(CGAL::vertex_point, mesh)));
    const internal::Mesh_indexing<MutableFaceGraph> indexing(mesh);
    internal::put_uv_of_corners(soup, triangles, indexing, uv_map);
    const auto cut_map = choose_parameter(get_parameter(np, np_tags::edge_is_cut_map),
                                          CGAL::Constant_property_map<edge_descriptor, bool>(false));
    for (const edge_descriptor e : CGAL::make_range(edges(mesh))) {
      const auto h = halfedge(e, mesh);
      const bool is_inner = !is_border(h, mesh) && !is_border(opposite(h, mesh), mesh);
      put(cut_map, e, is_inner && internal::is_seam(h, mesh, uv_map));
    }
  }
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_MAP_OBJ_H
