// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_FIELD_FILE_REPORT_H
#define CGAL_T_SPLINES_IO_FIELD_FILE_REPORT_H

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// How the reading of a file with a cross field or with cones ended.
enum class Field_file_status {
  SUCCESS,               ///< the file was read
  UNREADABLE,            ///< there is no such file, or nothing can be read from it or from the stream
  UNKNOWN_FORMAT,        ///< the file name does not end in one of the known extensions
  INVALID_MESH,          ///< the mesh that the file is for is refused: `check_triangle_mesh()` names the element
  TRUNCATED,             ///< the file ends too early
  SYNTAX_ERROR,          ///< `text` is not what the format asks for in this place
  NON_FINITE_NUMBER,     ///< a number is infinite, not a number, or out of the range of double
  TRAILING_DATA,         ///< something follows after everything that the file announces
  WRONG_SYMMETRY,        ///< the field has `actual` directions per face, or vectors in the file, instead of `expected`
  WRONG_COUNT,           ///< the file is for `actual` elements, the mesh has `expected`
  ZERO_VECTOR,           ///< a vector of face `index` is zero
  NOT_TANGENT,           ///< a vector of face `index` leaves the plane of the face
  NOT_A_CROSS,           ///< the vectors of face `index` do not determine a cross
  INDEX_OUT_OF_RANGE,    ///< `actual` is not the index of one of the `expected` vertices of the mesh
  DUPLICATE_CONE,        ///< vertex `index` is listed twice
  NON_POSITIVE_CONE,     ///< vertex `index` has `actual` < 1 quarter turns
  NOT_A_QUARTER_TURN,    ///< the angle of vertex `index` is not a multiple of pi/2 within 1e-6
  MISSING_SECTION,       ///< the file lacks the section `text`
  WRONG_FACE,            ///< face `index` has other vertices in the file than in the mesh
  INCONSISTENT_MATCHING, ///< the matchings of an edge of face `index` are not opposite to each other
  INTERRUPTED            ///< the visitor asked to stop
};

/// \ingroup PkgTSplinesIO
/// returns one sentence that explains `status`.
inline const char* message(const Field_file_status status)
{
  switch (status) {
  case Field_file_status::SUCCESS: return "the file was read";
  case Field_file_status::UNREADABLE: return "the file cannot be read";
  case Field_file_status::UNKNOWN_FORMAT:
    return "the file format is not known; fields are read from .rawfield, .crossfield, .rosy and .ffield";
  case Field_file_status::INVALID_MESH:
    return "the mesh that the file is for is not a triangle mesh with positive areas";
  case Field_file_status::TRUNCATED:
    return "the file is truncated: it ends before everything that it announces has come";
  case Field_file_status::SYNTAX_ERROR: return "the file does not follow its format here";
  case Field_file_status::NON_FINITE_NUMBER: return "a number is not finite";
  case Field_file_status::TRAILING_DATA: return "the file goes on after everything that it announces";
  case Field_file_status::WRONG_SYMMETRY:
    return "the field is no cross field: it does not have four directions per face";
  case Field_file_status::WRONG_COUNT: return "the file is for a mesh with another number of elements";
  case Field_file_status::ZERO_VECTOR: return "a vector is zero";
  case Field_file_status::NOT_TANGENT: return "a vector is not tangent to its face";
  case Field_file_status::NOT_A_CROSS: return "the vectors of a face do not determine a cross";
  case Field_file_status::INDEX_OUT_OF_RANGE: return "an index is out of range: the mesh has no such vertex";
  case Field_file_status::DUPLICATE_CONE: return "a vertex is listed twice";
  case Field_file_status::NON_POSITIVE_CONE: return "a vertex has fewer than one quarter turn";
  case Field_file_status::NOT_A_QUARTER_TURN: return "the angle of a cone is not a multiple of a quarter turn";
  case Field_file_status::MISSING_SECTION: return "the file lacks a section";
  case Field_file_status::WRONG_FACE: return "a face has other vertices in the file than in the mesh";
  case Field_file_status::INCONSISTENT_MATCHING: return "the two matchings of an edge are not opposite to each other";
  case Field_file_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesIO
/// How the reading of a file with a cross field or with cones ended, and where. Elements are counted from 0 in the order in
/// which the mesh lists them, lines from 1. Members that `status` does not mention have no meaning, but `line`.
struct Field_file_report {
  /// what `line` and `index` are when none is meant.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Field_file_status status = Field_file_status::SUCCESS; ///< how it ended
  std::size_t line = none;                               ///< where reading stopped; `none` if no line is to blame
  std::size_t index = none;                              ///< of the face or vertex
  long long expected = 0;                                ///< what `status` compares with
  long long actual = 0;                                  ///< what was found
  std::string text;                                      ///< what stands there, or the name of a section

  /// returns whether `status` tells of success.
  bool success() const { return status == Field_file_status::SUCCESS; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesIO
/// returns what `report` says, with the line, counted from 1, and the element concerned, counted from 0.
inline std::string describe(const Field_file_report& report)
{
  using Status = Field_file_status;
  std::string text = report.line == Field_file_report::none ? "" : "line " + std::to_string(report.line) + ": ";
  text += message(report.status);
  const auto element = [&report](const char* name) {
    return " (" + (name + std::to_string(report.index)) + ", counted from 0";
  };
  switch (report.status) {
  case Status::SUCCESS:
  case Status::INTERRUPTED:
  case Status::UNREADABLE:
  case Status::UNKNOWN_FORMAT:
  case Status::INVALID_MESH: break;
  case Status::WRONG_SYMMETRY:
  case Status::WRONG_COUNT:
    text += " (" + std::to_string(report.actual) + " instead of " + std::to_string(report.expected) + ")";
    break;
  case Status::INDEX_OUT_OF_RANGE:
    text +=
        " (vertex " + std::to_string(report.actual) + ", counted from 0, of " + std::to_string(report.expected) + ")";
    break;
  case Status::DUPLICATE_CONE: text += element("vertex ") + "); list it once"; break;
  case Status::NOT_A_QUARTER_TURN: text += element("vertex ") + ")"; break;
  case Status::NON_POSITIVE_CONE:
    text +=
        element("vertex ") + ", has k = " + std::to_string(report.actual) + "); give it at least 1, or leave it out";
    break;
  case Status::ZERO_VECTOR:
  case Status::NOT_TANGENT:
  case Status::NOT_A_CROSS:
  case Status::WRONG_FACE:
  case Status::INCONSISTENT_MATCHING: text += element("face ") + ")"; break;
  case Status::TRUNCATED:
  case Status::SYNTAX_ERROR:
  case Status::NON_FINITE_NUMBER:
  case Status::TRAILING_DATA:
  case Status::MISSING_SECTION:
    if (report.index != Field_file_report::none)
      text += element("element ") + ")";
    break;
  }
  return report.text.empty() ? text : text + ": \"" + report.text + "\"";
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_FIELD_FILE_REPORT_H
