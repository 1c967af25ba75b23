// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_MAP_OBJ_H
#define CGAL_T_SPLINES_IO_WRITE_MAP_OBJ_H

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/IO/internal/Uv_vertex_table.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace T_splines {

namespace internal {

template <typename FaceGraph, typename HalfedgeUVMap, typename VertexPointMap>
void format_map_obj(Text_writer& writer, const FaceGraph& mesh, const HalfedgeUVMap uv_map,
                    const VertexPointMap vertex_point_map)
{
  const Mesh_indexing<FaceGraph> indexing(mesh);
  const Uv_vertex_table table(indexing, uv_map);
  for (int v = 0; v < indexing.number_of_vertices(); ++v) {
    writer << "v ";
    writer.write_coordinates(get(vertex_point_map, indexing.vertex(v))) << "\n";
  }
  for (std::size_t i = 0; i < table.size(); ++i)
    writer << "vt " << table.uv(i)[0] << " " << table.uv(i)[1] << "\n";
  for (int f = 0; f < indexing.number_of_faces(); ++f) {
    writer << "f";
    for (const auto h : CGAL::halfedges_around_face(halfedge(indexing.face(f), mesh), mesh))
      writer << " " << static_cast<std::size_t>(indexing.vertex_index(target(h, mesh))) + 1 << "/"
             << table.of_halfedge(indexing.halfedge_index(h)) + 1;
    writer << "\n";
  }
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// writes a mesh with uv per corner to a stream, in the format of OBJ: `v` in the order in which the mesh
/// lists its vertices, one `vt` per
/// distinct uv of a vertex (shared by the corners of a chart), `f` with `v/vt`.
///
/// Every number is written in the shortest way that reads back as the same double, so `read_map_obj()` gives the same map bit
/// by bit.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap`, halfedge -> `Point_2`: the uv of the halfedge's *target* in
///   the chart of the halfedge's *face*
/// \param out receives the file
/// \param mesh the refined mesh
/// \param uv_map finite coordinates
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<FaceGraph>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear.
template <typename FaceGraph, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_map_obj(std::ostream& out, const FaceGraph& mesh, const HalfedgeUVMap uv_map,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::Text_writer writer(out);
  internal::format_map_obj(writer, mesh, uv_map,
                           choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                            get_const_property_map(CGAL::vertex_point, mesh)));
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes a mesh with uv per corner to an OBJ file, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \param filename where to write; a file that is there is replaced
/// \param mesh, uv_map, np see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear.
template <typename FaceGraph, typename HalfedgeUVMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_map_obj(const std::string& filename, const FaceGraph& mesh, const HalfedgeUVMap uv_map,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(filename, [&](std::ostream& out) { write_map_obj(out, mesh, uv_map, np); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_MAP_OBJ_H
