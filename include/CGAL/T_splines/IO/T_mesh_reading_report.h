// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_T_MESH_READING_REPORT_H
#define CGAL_T_SPLINES_IO_T_MESH_READING_REPORT_H

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// How the reading of a T-mesh file ended.
enum class T_mesh_reading_status {
  SUCCESS,                 ///< the T-mesh was read
  OUTPUT_NOT_EMPTY,        ///< the T-mesh to write has elements, or removed ones; nothing was read
  CANNOT_OPEN,             ///< there is no such file, or it may not be read
  UNSUPPORTED_VARIANT,     ///< a PLY file of a format or version that is not known
  EMPTY,                   ///< the file has no faces, or nothing at all
  TRUNCATED,               ///< the file ends before everything that it announces has come
  SYNTAX_ERROR,            ///< `text` is not what the format asks for at its place
  NON_FINITE_NUMBER,       ///< a number is NaN, infinite, or beyond the range of double
  INDEX_OUT_OF_RANGE,      ///< a face refers to a vertex or a halfedge that the file does not have
  LIST_LENGTHS_DIFFER,     ///< a list of a face has not as many entries as the face has vertices
  NON_POSITIVE_WEIGHT,     ///< the weight of a vertex is zero or negative
  NON_POSITIVE_KNOT,       ///< a knot interval is zero or negative
  WRONG_NUMBER_OF_CORNERS, ///< a face turns by a right angle at more or less than four of its vertices
  OPPOSITE_NOT_MUTUAL,     ///< the opposite of a halfedge is the halfedge itself, or has another opposite
  OPPOSITE_ENDS_DIFFER,    ///< a halfedge and its opposite do not run between the same vertices in opposite directions
  CREASE_NOT_MUTUAL,       ///< an edge is a crease in one of its two faces only
  ISOLATED_VERTEX,         ///< a vertex belongs to no face
  NON_MANIFOLD_VERTEX,     ///< the faces at a vertex form more than one fan
  UNEQUAL_SIDES,           ///< the knot intervals on opposite sides of a face have different sums
  CYCLE_CONDITION,         ///< the ratios of the knot intervals around a vertex do not multiply to one
  INTERRUPTED              ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesIO
/// returns one sentence that explains `status`.
inline const char* message(const T_mesh_reading_status status)
{
  using Status = T_mesh_reading_status;
  switch (status) {
  case Status::SUCCESS: return "the T-mesh was read";
  case Status::OUTPUT_NOT_EMPTY: return "the T-mesh that receives the content of the file is not empty; give a new one";
  case Status::CANNOT_OPEN: return "the file cannot be opened for reading";
  case Status::UNSUPPORTED_VARIANT: return "this variant of PLY is not supported";
  case Status::EMPTY: return "the file has no faces";
  case Status::TRUNCATED: return "the file is truncated: it ends before everything that it announces has come";
  case Status::SYNTAX_ERROR: return "the file does not follow its format here";
  case Status::NON_FINITE_NUMBER: return "a number is not finite";
  case Status::INDEX_OUT_OF_RANGE: return "an index is out of range: the file has no such element";
  case Status::LIST_LENGTHS_DIFFER: return "the lists of a face have different lengths";
  case Status::NON_POSITIVE_WEIGHT: return "a weight is not positive";
  case Status::NON_POSITIVE_KNOT: return "a knot interval is not positive";
  case Status::WRONG_NUMBER_OF_CORNERS: return "a face has not exactly four corners";
  case Status::OPPOSITE_NOT_MUTUAL: return "a halfedge and its opposite do not name each other";
  case Status::OPPOSITE_ENDS_DIFFER:
    return "a halfedge and its opposite do not run between the same vertices in opposite directions";
  case Status::CREASE_NOT_MUTUAL: return "an edge is a crease in one of its two faces, and none in the other";
  case Status::ISOLATED_VERTEX: return "a vertex is isolated: it belongs to no face";
  case Status::NON_MANIFOLD_VERTEX: return "a vertex is not manifold: its faces form more than one fan";
  case Status::UNEQUAL_SIDES:
    return "the knot intervals are not admissible: opposite sides of a face have different sums";
  case Status::CYCLE_CONDITION:
    return "the knot intervals are not admissible: their ratios around a vertex do not multiply to one";
  case Status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesIO
/// How the reading of a T-mesh file ended, and which element of the file it is about.
///
/// All elements are counted from 0 in the order of the file, only lines from 1.
struct T_mesh_reading_report {
  /// what an element is when it is not meant.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  T_mesh_reading_status status = T_mesh_reading_status::SUCCESS; ///< how it ended
  std::size_t line = none;                                       ///< of the file, counted from 1
  std::size_t vertex = none;                                     ///< of the file
  std::size_t face = none;                                       ///< of the file
  std::size_t index = none;                                      ///< a position in the lists of `face`
  double defect = 0;  ///< of knots that are not admissible: the relative difference, or the deviation from one
  std::string text;   ///< what stands in the file at this place
  std::string detail; ///< what is wrong, or asked for, where that is not clear from the status

  std::size_t number_of_vertices = 0; ///< of the file
  std::size_t number_of_faces = 0;    ///< of the file

  /// returns whether `status` tells of success.
  bool success() const { return status == T_mesh_reading_status::SUCCESS; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesIO
/// returns a sentence that says how the reading ended and names the line and the elements it is about.
inline std::string describe(const T_mesh_reading_report& report)
{
  constexpr std::size_t none = T_mesh_reading_report::none;
  std::string sentence = report.line == none ? "" : "line " + std::to_string(report.line) + ": ";
  sentence += message(report.status);
  std::string elements;
  const auto append = [&elements](const char* name, const std::size_t number) {
    if (number != none)
      elements += (elements.empty() ? "" : ", ") + (name + std::to_string(number));
  };
  append("vertex ", report.vertex);
  append("face ", report.face);
  append("entry ", report.index);
  if (!elements.empty())
    sentence += " (" + elements + ", counted from 0)";
  if (report.defect != 0) {
    std::array<char, 32> digits;
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), report.defect);
    sentence += ": off by " + std::string(digits.data(), end.ptr);
  }
  if (!report.detail.empty())
    sentence += ": " + report.detail;
  if (!report.text.empty())
    sentence += (report.detail.empty() ? ": found \"" : ", found \"") + report.text + "\"";
  return sentence;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_T_MESH_READING_REPORT_H
