// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_TRIANGLE_MESH_H
#define CGAL_T_SPLINES_IO_READ_TRIANGLE_MESH_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/read_triangle_soup.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <string>

namespace CGAL {
namespace T_splines {

/// reads a closed oriented triangle mesh from an OFF, OBJ, PLY or STL file and refuses, naming line and element,
/// everything that the algorithms of this package cannot use.
///
/// Vertices and faces of `mesh` come in the order of the file, so that files that refer to them by number (cones, fields) fit.
/// That is why nothing is repaired in silence:
/// - Refused: what `Mesh_reading_status` lists. Isolated vertices, because they have no place in a map; faces of inconsistent
///   orientation, even if flipping some of them would help, because which side is outside is for the file to say.
/// - Accepted: several components; texture coordinates, normals, colours and other data, which are not read; an inside-out
///   orientation.
/// - Changed, and said by `note()`: faces with more than three corners are triangulated (their triangles follow each other, in place of
///   the face), quadrilaterals by the better diagonal; the corners of STL facets become one vertex where their coordinates are identical.
///
/// Coordinates are read to the nearest double. The readers of CGAL are not used, because they do not say what is wrong with a
/// file and where, and accept files whose counts are wrong.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param filename a file whose extension, in any case, says what it is
/// \param mesh the mesh to which the triangles are appended; untouched if the file is refused
/// \param np optional: `vertex_point_map`, writable, values constructible from three doubles
/// \return how it ended; never throws but for lack of memory. Complexity: O(n log n) in the size of the file.
template <typename MutableFaceGraph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Mesh_reading_report read_triangle_mesh(const std::string& filename, MutableFaceGraph& mesh,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  internal::Polygon_soup soup;
  internal::Triangle_soup triangles;
  const Mesh_reading_report report = internal::read_triangle_soup(filename, false, soup, triangles);
  if (report.success())
    internal::build_triangle_mesh(soup, triangles, mesh,
                                  choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                   get_property_map(CGAL::vertex_point, mesh)));
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_TRIANGLE_MESH_H
