// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_RAWFIELD_H
#define CGAL_T_SPLINES_IO_WRITE_RAWFIELD_H

#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <charconv>
#include <ostream>
#include <string>

namespace CGAL {
namespace T_splines {
namespace internal {

// 17 significant digits read back as the same double; they do not depend on the locale or on the flags of a stream.
inline void append_number(std::string& text, const double value)
{
  constexpr int digits = 17;
  char buffer[64];
  const std::to_chars_result result =
      std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, digits);
  text.append(buffer, result.ptr);
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// writes a cross field in Directional's format `.rawfield`: the numbers 4 and F, then for each of the F faces, in the order
/// of the mesh, the four vectors of its cross in counter-clockwise order.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `ReadablePropertyMap` from faces to three-dimensional vectors
/// \param output is written to with 17 digits; its state tells whether this succeeded
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
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void write_rawfield(std::ostream& output, const TriangleMesh& mesh, const CrossFieldMap& cross_field,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  using Vector_3 = internal::Triangle_geometry::Vector_3;
  const internal::Mesh_indexing<TriangleMesh> indexing(mesh);
  const internal::Triangulation_connectivity connectivity = internal::triangulation_connectivity(indexing);
  const internal::Triangle_geometry geometry = internal::triangle_geometry(
      indexing, connectivity,
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_const_property_map(CGAL::vertex_point, mesh)));
  output << "4 " << std::to_string(connectivity.number_of_faces()) << '\n';
  std::string line;
  for (int f = 0; f < connectivity.number_of_faces(); ++f) {
    const auto& direction = get(cross_field, indexing.face(f));
    const Vector_3 v(CGAL::to_double(direction.x()), CGAL::to_double(direction.y()), CGAL::to_double(direction.z()));
    const Vector_3 w = CGAL::cross_product(geometry.m_normal[f], v);
    line.clear();
    for (const Vector_3& vector : {v, w, -v, -w}) {
      for (const double coordinate : {vector.x(), vector.y(), vector.z()}) {
        if (!line.empty())
          line += ' ';
        internal::append_number(line, coordinate);
      }
    }
    output << line << '\n';
  }
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_RAWFIELD_H
