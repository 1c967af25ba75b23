// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_READ_FFIELD_H
#define CGAL_T_SPLINES_IO_READ_FFIELD_H

#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Field_file_parser.h>
#include <CGAL/T_splines/IO/internal/Field_of_vectors.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// The kind of field, the number of facets, a line with names of columns, and for each facet two numbers and two vectors:
// the frame that the field was to follow, not the field.
inline bool skip_target_frames(Field_file_parser& parser, const int number_of_faces)
{
  std::string_view token;
  if (!parser.read_token(token))
    return false;
  if (token != "target_frame" && token != "shape_operator")
    return parser.fail_with_text(Field_file_status::SYNTAX_ERROR, token);
  long long count = 0;
  if (!parser.read_integer(count))
    return false;
  if (count != number_of_faces)
    return parser.fail(Field_file_status::WRONG_COUNT, Field_file_report::none, number_of_faces, count);
  if (!parser.read_token(token))
    return false;
  parser.skip_rest_of_line();
  constexpr int numbers_per_facet = 8;
  for (int f = 0; f < number_of_faces; ++f) {
    double number = 0;
    for (int i = 0; i < numbers_per_facet; ++i)
      if (!parser.read_number(number))
        return parser.at_index(f);
  }
  return true;
}

// A count and as many indices of elements that were kept fixed.
inline bool skip_fixed_elements(Field_file_parser& parser)
{
  long long count = 0, index = 0;
  if (!parser.read_integer(count))
    return false;
  for (long long i = 0; i < count; ++i)
    if (!parser.read_integer(index))
      return false;
  return true;
}

/// reads the sections between the frames and the matchings.
/// \param name the name of the section with the matchings, whose rows come next
inline bool read_crossfield_angles(Field_file_parser& parser, std::vector<double>& angle, std::string_view& name)
{
  bool has_angles = false;
  while (parser.has_token()) {
    if (!parser.read_token(name))
      return false;
    if (name == "crossfield_angles") {
      for (std::size_t f = 0; f < angle.size(); ++f)
        if (!parser.read_number(angle[f]))
          return parser.at_index(f);
      has_angles = true;
    }
    else if (name == "fixed" || name == "fixed_vertices") {
      if (!skip_fixed_elements(parser))
        return false;
    }
    else if (name == "matchings" || name == "matchings_and_sharp" || name == "MI_matchings" ||
             name == "MI_matchings_and_sharp")
      return has_angles || parser.fail_with_text(Field_file_status::MISSING_SECTION, "crossfield_angles");
    else
      return parser.fail_with_text(Field_file_status::SYNTAX_ERROR, name);
  }
  return parser.fail_with_text(Field_file_status::MISSING_SECTION, has_angles ? "matchings" : "crossfield_angles");
}

// The halfedge of face `f` whose target is the first of three vertices in the order of the face; null if they are others.
inline int halfedge_to_first_vertex(const Triangulation_connectivity& mesh, const int f, const long long (&vertex)[3])
{
  int h = mesh.halfedge_of_face(f);
  for (int corner = 0; corner < 3; ++corner, h = mesh.next(h))
    if (mesh.target(h) == vertex[0] && mesh.target(mesh.next(h)) == vertex[1] && mesh.source(h) == vertex[2])
      return h;
  return Triangulation_connectivity::null;
}

/// reads, per facet, its vertices i, j, k and the matchings of the halfedges that point to them. The angle of the facet is relative
/// to the halfedge that points to i.
template <typename TriangleMesh>
bool parse_ffield(Field_file_parser& parser, Field_of_vectors<TriangleMesh>& field)
{
  const Triangulation_connectivity& mesh = field.connectivity();
  std::vector<double> angle(field.number_of_faces());
  std::vector<int> matching(mesh.number_of_halfedges(), 0);
  std::string_view name;
  if (!skip_target_frames(parser, field.number_of_faces()) || !read_crossfield_angles(parser, angle, name))
    return false;
  const bool has_sharp = name.size() > 6 && name.substr(name.size() - 6) == "_sharp";
  const int sign = name.substr(0, 3) == "MI_" ? 1 : -1;
  for (int f = 0; f < field.number_of_faces(); ++f) {
    long long vertex[3];
    double quarter_turns[3], sharp = 0;
    for (long long& v : vertex)
      if (!parser.read_integer(v))
        return parser.at_index(f);
    for (double& k : quarter_turns) {
      if (!parser.read_number(k))
        return parser.at_index(f);
      if (k != std::floor(k) || std::abs(k) > largest_number_of_turns)
        return parser.fail(Field_file_status::SYNTAX_ERROR, f);
    }
    for (int i = 0; has_sharp && i < 3; ++i)
      if (!parser.read_number(sharp))
        return parser.at_index(f);
    int h = halfedge_to_first_vertex(mesh, f, vertex);
    if (h == Triangulation_connectivity::null)
      return parser.fail(Field_file_status::WRONG_FACE, f);
    field.set_angle(f, angle[f] + field.geometry().direction(mesh, h));
    for (const double k : quarter_turns) {
      matching[h] = sign * static_cast<int>(k);
      h = mesh.next(h);
    }
  }
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face(h) != Triangulation_connectivity::null &&
        mesh.face(internal::opposite(h)) != Triangulation_connectivity::null &&
        (matching[h] + matching[internal::opposite(h)]) % 4 != 0)
      return parser.fail(Field_file_status::INCONSISTENT_MATCHING, mesh.face(h));
  field.set_matchings(std::move(matching));
  return true;
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// reads a cross field with matchings in the format `.ffield` (Myles, Pietroni, Zorin, Robust field-aligned global
/// parametrization, 2014).
///
/// After the frames that the field was to follow come sections: `crossfield_angles`, one angle per facet, relative to the
/// halfedge that points to the facet's first vertex; `fixed` and `fixed_vertices`, which are skipped; and `matchings`,
/// `MI_matchings` or the same with `_and_sharp`: per facet its three vertices and the matchings of the halfedges that
/// point to them. Those of `matchings` have the opposite sign. What follows is not read.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam CrossFieldMap a model of `WritablePropertyMap` from faces to three-dimensional vectors, which are
///         constructible from three `double`s
/// \tparam HalfedgeMatchingMap a model of `WritablePropertyMap` from halfedges to integers
/// \param input the text
/// \param mesh the mesh that the field is for, its faces and vertices in the order of the file; borders are allowed
/// \param cross_field receives *the* direction of each facet, of length 1
/// \param matching receives the matchings, in the sense of the named parameter `halfedge_matching_map` of
///        `holonomy_signature_of_cross_field()`; nothing is written upon failure
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
template <typename TriangleMesh, typename CrossFieldMap, typename HalfedgeMatchingMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Field_file_report read_ffield(std::istream& input, const TriangleMesh& mesh, CrossFieldMap cross_field,
                              HalfedgeMatchingMap matching,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_field(input, internal::parse_ffield<TriangleMesh>, mesh, cross_field, matching, np);
}

/// \ingroup PkgTSplinesIO
/// reads a cross field with matchings from a file of the format `.ffield`.
/// \param filename a file; its extension does not matter
/// \param mesh, cross_field, matching, np see the function that reads from a stream
/// \return what is wrong with the file, and in which line and face.
template <typename TriangleMesh, typename CrossFieldMap, typename HalfedgeMatchingMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Field_file_report read_ffield(const std::string& filename, const TriangleMesh& mesh, CrossFieldMap cross_field,
                              HalfedgeMatchingMap matching,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::read_field(filename, internal::parse_ffield<TriangleMesh>, mesh, cross_field, matching, np);
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_READ_FFIELD_H
