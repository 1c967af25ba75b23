// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_RAWFIELD_H
#define CGAL_T_SPLINES_IO_READ_RAWFIELD_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Field_file_parser.h>
#include <CGAL/T_splines/IO/internal/Field_of_vectors.h>

#include <CGAL/Named_function_parameters.h>

#include <istream>
#include <string>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

template <typename TriangleMesh>
bool parse_rawfield(Field_file_parser& parser, Field_of_vectors<TriangleMesh>& field)
{
  if (!read_field_header(parser, 4, field.number_of_faces(), true))
    return false;
  std::vector<Triangle_geometry::Vector_3> vectors(4);
  for (int f = 0; f < field.number_of_faces(); ++f) {
    for (Triangle_geometry::Vector_3& vector : vectors)
      if (!read_vector(parser, vector))
        return parser.at_index(f);
    if (!field.set_cross(f, vectors, false, parser))
      return false;
  }
  return parser.read_end();
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads a cross field in Directional's format `.rawfield`: the numbers 4 and F, then four vectors for each of F faces.
///
/// The vectors of a face may come in either rotational order, and have any length. If they are not orthogonal, the cross is the
/// one that lies symmetrically to them. Fields with another number of directions are refused.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `WritablePropertyMap` from faces to three-dimensional vectors, which are
///         constructible from three `double`s
/// \param input the text; it is read to its end
/// \param mesh the mesh that the field is for, its faces in the order of the file; borders are allowed
/// \param cross_field receives one direction of each cross, of length 1; nothing is written upon failure
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
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what is wrong with the file, and in which line and face.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Field_file_report read_rawfield(std::istream& input, const TriangleMesh& mesh, CrossFieldMap cross_field,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_field(input, internal::parse_rawfield<TriangleMesh>, mesh, cross_field, np);
}

/// \ingroup PkgTSplinesIO
/// reads a cross field from a file of the format `.rawfield`.
/// \param filename a file; its extension does not matter
/// \param mesh, cross_field, np see the function that reads from a stream
/// \return what is wrong with the file, and in which line and face.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Field_file_report read_rawfield(const std::string& filename, const TriangleMesh& mesh, CrossFieldMap cross_field,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_field(filename, internal::parse_rawfield<TriangleMesh>, mesh, cross_field, np);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_RAWFIELD_H
