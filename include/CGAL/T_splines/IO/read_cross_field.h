// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_CROSS_FIELD_H
#define CGAL_T_SPLINES_IO_READ_CROSS_FIELD_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Field_of_vectors.h>
#include <CGAL/T_splines/IO/internal/lowercase_extension.h>
#include <CGAL/T_splines/IO/read_crossfield.h>
#include <CGAL/T_splines/IO/read_ffield.h>
#include <CGAL/T_splines/IO/read_rawfield.h>
#include <CGAL/T_splines/IO/read_rosy.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <string>

namespace CGAL {
namespace T_splines {

namespace internal {

/// \return null if the extension is of no known format
template <typename TriangleMesh>
Field_format<TriangleMesh> field_format(const std::string& extension)
{
  return extension == ".rawfield"     ? parse_rawfield<TriangleMesh>
         : extension == ".crossfield" ? parse_crossfield<TriangleMesh>
         : extension == ".rosy"       ? parse_rosy<TriangleMesh>
         : extension == ".ffield"     ? parse_ffield<TriangleMesh>
                                      : Field_format<TriangleMesh>(nullptr);
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads a cross field from a file whose extension, in any case, says its format: `.rawfield`, `.crossfield`, `.rosy` or
/// `.ffield`.
///
/// See `read_rawfield()`, `read_crossfield()`, `read_rosy()` and `read_ffield()` about the formats.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `WritablePropertyMap` from faces to three-dimensional vectors, which are
///         constructible from three `double`s
/// \param filename a file
/// \param mesh the mesh that the field is for, its faces in the order of the file; borders are allowed
/// \param cross_field receives one direction of each cross, of length 1; nothing is written upon failure
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{halfedge_matching_map}
///     \cgalParamDescription{receives the matchings that `holonomy_signature_of_cross_field()` takes: those of a file
///       `.ffield`, else those by the closest rotation}
///     \cgalParamType{a model of `WritablePropertyMap`, `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` -> an
///       integer}
///     \cgalParamDefault{none is written}
///   \cgalParamNEnd
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
/// \return what is wrong with the file, and in which line and face; `UNKNOWN_FORMAT` if its extension is none of these.
template <typename TriangleMesh, typename CrossFieldMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Field_file_report read_cross_field(const std::string& filename, const TriangleMesh& mesh, CrossFieldMap cross_field,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto format = internal::field_format<TriangleMesh>(internal::lowercase_extension(filename));
  if (format == nullptr) {
    Field_file_report report;
    report.status = Field_file_status::UNKNOWN_FORMAT;
    return report;
  }
  return internal::read_field(filename, format, mesh, cross_field,
                              CGAL::parameters::get_parameter(np, np_tags::halfedge_matching_map), np);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_CROSS_FIELD_H
