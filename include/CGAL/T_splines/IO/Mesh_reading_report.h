// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_MESH_READING_REPORT_H
#define CGAL_T_SPLINES_IO_MESH_READING_REPORT_H

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// How the reading of a mesh file ended.
enum class Mesh_reading_status {
  SUCCESS,                  ///< the mesh was read
  OUTPUT_NOT_EMPTY,         ///< the mesh to write has elements, or removed ones; nothing was read
  CANNOT_OPEN,              ///< there is no such file, or it may not be read
  UNKNOWN_FORMAT,           ///< the file name does not end in one of the known extensions
  UNSUPPORTED_VARIANT,      ///< the format has variants that this reader does not read, and this is one
  EMPTY,                    ///< the file has no faces
  TRUNCATED,                ///< the file ends before everything that it announces has come
  SYNTAX_ERROR,             ///< `text` is not what the format asks for at its place
  NON_FINITE_COORDINATE,    ///< a coordinate is NaN, infinite, or beyond the range of double
  INDEX_OUT_OF_RANGE,       ///< a face refers to a vertex that the file does not have
  TOO_FEW_CORNERS,          ///< a face has less than three corners
  TOO_MANY_CORNERS,         ///< a face has more corners than the triangulation of polygons admits
  REPEATED_VERTEX,          ///< a face has the same vertex twice
  DUPLICATE_FACE,           ///< two faces have the same vertices
  NON_MANIFOLD_EDGE,        ///< an edge belongs to more than two faces
  INCONSISTENT_ORIENTATION, ///< two neighbouring faces run through their edge in the same direction
  NON_ORIENTABLE,           ///< the same, and no choice of orientations mends it
  NON_MANIFOLD_VERTEX,      ///< the faces at a vertex form more than one fan
  ISOLATED_VERTEX,          ///< a vertex belongs to no face
  BOUNDARY,                 ///< an edge belongs to one face only, and must not or is part of a crack
  ZERO_LENGTH_EDGE,         ///< the two ends of an edge are the same point
  ZERO_AREA_TRIANGLE,       ///< the corners of a triangle are exactly collinear
  MISSING_UV,               ///< a corner of a face has no texture coordinates (maps only)
  INTERRUPTED               ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesIO
/// returns one sentence that explains `status`.
inline const char* message(const Mesh_reading_status status)
{
  switch (status) {
  case Mesh_reading_status::SUCCESS: return "the mesh was read";
  case Mesh_reading_status::OUTPUT_NOT_EMPTY:
    return "the mesh that receives the content of the file is not empty; give a new one";
  case Mesh_reading_status::CANNOT_OPEN: return "the file cannot be opened for reading";
  case Mesh_reading_status::UNKNOWN_FORMAT:
    return "the file format is not known; meshes are read from .off, .obj, .ply and .stl";
  case Mesh_reading_status::UNSUPPORTED_VARIANT: return "this variant of the file format is not supported";
  case Mesh_reading_status::EMPTY: return "the file has no faces";
  case Mesh_reading_status::TRUNCATED:
    return "the file is truncated: it ends before everything that it announces has come";
  case Mesh_reading_status::SYNTAX_ERROR: return "the file does not follow its format here";
  case Mesh_reading_status::NON_FINITE_COORDINATE: return "a coordinate is not a finite number";
  case Mesh_reading_status::INDEX_OUT_OF_RANGE: return "an index is out of range: the file has no such element";
  case Mesh_reading_status::TOO_FEW_CORNERS: return "a face has less than three corners";
  case Mesh_reading_status::TOO_MANY_CORNERS: return "a face has too many corners to be triangulated";
  case Mesh_reading_status::REPEATED_VERTEX: return "a face has the same vertex twice";
  case Mesh_reading_status::DUPLICATE_FACE: return "two faces have the same vertices";
  case Mesh_reading_status::NON_MANIFOLD_EDGE: return "an edge is not manifold: it belongs to more than two faces";
  case Mesh_reading_status::INCONSISTENT_ORIENTATION:
    return "the faces are oriented inconsistently: two neighbours run through their common edge in the same direction";
  case Mesh_reading_status::NON_ORIENTABLE: return "the surface is not orientable";
  case Mesh_reading_status::NON_MANIFOLD_VERTEX: return "a vertex is not manifold: its faces form more than one fan";
  case Mesh_reading_status::ISOLATED_VERTEX: return "a vertex is isolated: it belongs to no face";
  case Mesh_reading_status::BOUNDARY: return "the surface is not closed";
  case Mesh_reading_status::ZERO_LENGTH_EDGE: return "an edge has length zero";
  case Mesh_reading_status::ZERO_AREA_TRIANGLE: return "a triangle has area zero: its corners are exactly collinear";
  case Mesh_reading_status::MISSING_UV: return "a corner has no texture coordinates";
  case Mesh_reading_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesIO
/// What a repair changed.
struct Mesh_repairs {
  std::size_t degenerate_faces = 0;  ///< with less than three different corners: removed
  std::size_t shortened_faces = 0;   ///< others with repeated corners, which were removed
  std::size_t duplicate_faces = 0;   ///< removed
  std::size_t reversed_faces = 0;    ///< turned around
  std::size_t split_vertices = 0;    ///< new vertices, where several sheets met
  std::size_t isolated_vertices = 0; ///< removed
  std::size_t flat_triangles = 0;    ///< of area exactly zero: removed by flips and collapses of edges
};

/// \ingroup PkgTSplinesIO
/// How the reading of a mesh file ended, and which element of the file it is about.
///
/// All elements are counted from 0 in the order of the file (those of an OBJ file too), only lines from 1.
struct Mesh_reading_report {
  /// what an element is when it is not meant.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Mesh_reading_status status = Mesh_reading_status::SUCCESS; ///< how it ended
  std::size_t line = none;                                   ///< in files made of text
  std::size_t vertex = none;                                 ///< a vertex, or the source of an edge
  std::size_t other_vertex = none;                           ///< the target of an edge
  std::size_t face = none;                                   ///< a face of the file
  std::size_t other_face = none;                             ///< another face of the file
  std::string text;                                          ///< what stands in the file at this place
  std::string detail; ///< what the format asks for at this place, where that is not clear from the status

  std::size_t number_of_vertices = 0;           ///< of the file (STL: after merging)
  std::size_t number_of_faces = 0;              ///< of the file
  std::size_t number_of_triangulated_faces = 0; ///< faces with more than three corners
  std::size_t first_triangulated_face = none;   ///< the first of them
  std::size_t number_of_merged_points = 0;      ///< STL: corners whose point had occurred before
  std::size_t number_of_merged_vertices = 0;    ///< that differed by no more than a `merge_distance` from others
  double merged_distance =
      0;                ///< between a vertex and the one it was merged into, at most; by the longest side of the box
  Mesh_repairs repairs; ///< what a repair changed
  std::size_t number_of_trailing_bytes = 0; ///< binary STL: bytes behind the last facet, which were not read

  std::size_t number_of_boundary_edges = 0, ///< with one face only, with the status SUCCESS or BOUNDARY
      number_of_boundary_loops = 0;         ///< closed curves that these form

  // What the reader found out about a mesh that it refused.
  std::optional<double> closing_distance; ///< a `merge_distance` with which the mesh would have been accepted
  bool is_repairable = false;             ///< it would have been accepted with `repair(true)`

  /// returns whether `status` tells of success.
  bool success() const { return status == Mesh_reading_status::SUCCESS; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

namespace internal {

inline std::string elements_of(const Mesh_reading_report& report)
{
  constexpr std::size_t none = Mesh_reading_report::none;
  std::string list;
  const auto append = [&list](const std::string& item) { list += (list.empty() ? "" : ", ") + item; };
  if (report.vertex != none && report.other_vertex != none)
    append("edge from vertex " + std::to_string(report.vertex) + " to vertex " + std::to_string(report.other_vertex));
  else if (report.vertex != none)
    append("vertex " + std::to_string(report.vertex));
  if (report.face != none && report.other_face != none)
    append("faces " + std::to_string(report.face) + " and " + std::to_string(report.other_face));
  else if (report.face != none)
    append("face " + std::to_string(report.face));
  return list.empty() ? list : list + ", counted from 0";
}

/// A length relative to the longest side of the bounding box, in words.
inline std::string relative_length(const double length)
{
  std::ostringstream text;
  text.precision(2);
  text << length << " of the longest side";
  return text.str();
}

/// A number of things, in words.
inline std::string counted(const std::size_t number, const char* one, const char* many)
{
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

/// What is known of a boundary.
inline std::string boundary_of(const Mesh_reading_report& report)
{
  std::string sentence = counted(report.number_of_boundary_edges, "boundary edge", "boundary edges") + " in " +
                         counted(report.number_of_boundary_loops, "loop", "loops");
  if (report.closing_distance && *report.closing_distance > 0)
    sentence += ", whose ends lie within " + relative_length(*report.closing_distance) + " of another boundary edge";
  else if (report.closing_distance)
    sentence += ", whose ends coincide with those of another boundary edge";
  return sentence;
}

/// What merging changed.
inline std::string merging_of(const Mesh_reading_report& report)
{
  if (report.number_of_merged_vertices == 0)
    return "";
  const std::string subject = counted(report.number_of_merged_vertices, "vertex was merged into another one",
                                      "vertices were merged into others");
  return subject + (report.merged_distance > 0 ? ", at most " + relative_length(report.merged_distance) + " apart"
                                               : " at the same place");
}

/// What a repair changed, in words; empty if nothing.
inline std::string repairs_of(const Mesh_repairs& repairs)
{
  std::string list;
  const auto append = [&list](const std::size_t number, const char* one, const char* many) {
    if (number > 0)
      list += (list.empty() ? "repaired: " : ", ") + counted(number, one, many);
  };
  append(repairs.degenerate_faces, "degenerate face removed", "degenerate faces removed");
  append(repairs.shortened_faces, "face freed of repeated corners", "faces freed of repeated corners");
  append(repairs.duplicate_faces, "duplicate face removed", "duplicate faces removed");
  append(repairs.reversed_faces, "face turned around", "faces turned around");
  append(repairs.split_vertices, "vertex split off", "vertices split off");
  append(repairs.isolated_vertices, "isolated vertex removed", "isolated vertices removed");
  append(repairs.flat_triangles, "flat triangle removed", "flat triangles removed");
  return list;
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// returns a sentence that says how the reading ended and names the line and the elements it is about.
inline std::string describe(const Mesh_reading_report& report)
{
  std::string sentence;
  if (report.line != Mesh_reading_report::none)
    sentence += "line " + std::to_string(report.line) + ": ";
  sentence += message(report.status);
  const std::string elements = internal::elements_of(report);
  if (!elements.empty())
    sentence += " (" + elements + ")";
  if (!report.detail.empty())
    sentence += ": " + report.detail;
  if (!report.text.empty())
    sentence += (report.detail.empty() ? ": found \"" : ", found \"") + report.text + "\"";
  if (!report.success() && report.number_of_boundary_edges > 0)
    sentence += ": " + internal::boundary_of(report);
  return sentence;
}

/// \ingroup PkgTSplinesIO
/// returns what the reader changed in a mesh that it accepted, and that it is open, as one sentence, or nothing if the mesh
/// is closed and as in the file.
inline std::string note(const Mesh_reading_report& report)
{
  std::string sentence;
  const auto append = [&sentence](const std::string& text) {
    if (!text.empty())
      sentence += (sentence.empty() ? "" : "; ") + text;
  };
  if (report.number_of_triangulated_faces > 0)
    append(std::to_string(report.number_of_triangulated_faces) + " of " + std::to_string(report.number_of_faces) +
           " faces are not triangles and were triangulated (the first is face " +
           std::to_string(report.first_triangulated_face) + ", counted from 0)");
  if (report.number_of_merged_points > 0)
    append(std::to_string(report.number_of_merged_points) + " corners with identical coordinates were merged into " +
           std::to_string(report.number_of_vertices) + " vertices");
  append(internal::merging_of(report));
  append(internal::repairs_of(report.repairs));
  if (report.number_of_trailing_bytes > 0)
    append(std::to_string(report.number_of_trailing_bytes) + " bytes behind the last facet were not read");
  if (report.number_of_boundary_edges > 0)
    append("the surface is open, with " + internal::boundary_of(report));
  return sentence;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_MESH_READING_REPORT_H
