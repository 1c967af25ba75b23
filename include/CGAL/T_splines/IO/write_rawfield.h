// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_RAWFIELD_H
#define CGAL_T_SPLINES_IO_WRITE_RAWFIELD_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace T_splines {
/// \ingroup PkgTSplinesIO
/// writes a cross field in Directional's format `.rawfield`: the numbers 4 and F, then for each of the F faces, in the order
/// of the mesh, the four vectors of its cross in counter-clockwise order.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `ReadablePropertyMap` from faces to three-dimensional vectors
/// \param output receives the file, each number in the shortest way that reads back as the same double
/// \param mesh a triangle mesh
/// \param cross_field one of the four directions of the cross in each face, tangent to it; its length is kept
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_rawfield(std::ostream& output, const TriangleMesh& mesh, const CrossFieldMap& cross_field,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  using Vector_3 = internal::Triangle_geometry::Vector_3;
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  const internal::Triangulation_connectivity connectivity = internal::triangulation_connectivity(indexing);
  const internal::Triangle_geometry geometry = internal::triangle_geometry(
      indexing, connectivity,
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_const_property_map(CGAL::vertex_point, mesh)));
  internal::Text_writer writer(output);
  writer << "4 " << static_cast<std::size_t>(connectivity.number_of_faces()) << "\n";
  for (int f = 0; f < connectivity.number_of_faces(); ++f) {
    const auto& direction = get(cross_field, indexing.face(f));
    const Vector_3 v(CGAL::to_double(direction.x()), CGAL::to_double(direction.y()), CGAL::to_double(direction.z()));
    const Vector_3 w = CGAL::cross_product(geometry.m_normal[f], v);
    writer.write_coordinates(v);
    for (const Vector_3& vector : {w, -v, -w}) {
      writer << " ";
      writer.write_coordinates(vector);
    }
    writer << "\n";
  }
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes a cross field to a file of the format `.rawfield`, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \param filename where to write; a file that is there is replaced
/// \param mesh, cross_field, np see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::error_code write_rawfield(const std::string& filename, const TriangleMesh& mesh, const CrossFieldMap& cross_field,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::write_file(filename, [&](std::ostream& output) { write_rawfield(output, mesh, cross_field, np); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_RAWFIELD_H
