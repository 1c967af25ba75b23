// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_FEATURE_FILE_REPORT_H
#define CGAL_T_SPLINES_IO_FEATURE_FILE_REPORT_H

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// The formats of files with features; see `read_features()`.
enum class Feature_file_format {
  VERTEX_PAIRS, ///< two vertices per line
  SHARP,        ///< `.sharp` of quadwild: a kind, a face and one of its edges per line
  OBJ_LINES     ///< the statements `l` of an OBJ file
};

/// \ingroup PkgTSplinesIO
/// How the reading of a file with features ended.
enum class Feature_file_status {
  SUCCESS,                 ///< the file was read
  UNREADABLE,              ///< there is no such file, or nothing can be read from it or from the stream
  TRUNCATED,               ///< the file ends before all features that it announces: `actual` instead of `expected`
  SYNTAX_ERROR,            ///< `text` is not an index
  WRONG_NUMBER_OF_COLUMNS, ///< a line has `actual` numbers instead of `expected`, or of at least as many
  VERTEX_OUT_OF_RANGE,     ///< `text` is none of the `expected` vertices of the mesh
  FACE_OUT_OF_RANGE,       ///< `text` is none of the `expected` faces of the mesh
  EDGE_OUT_OF_RANGE,       ///< `text` is none of the three edges of a face
  NOT_AN_EDGE,             ///< the mesh has no edge from `first_vertex` to `second_vertex`
  TRAILING_DATA            ///< something follows after all features that the file announces
};

/// \ingroup PkgTSplinesIO
/// returns one sentence that explains `status`.
inline const char* message(const Feature_file_status status)
{
  switch (status) {
  case Feature_file_status::SUCCESS: return "the file was read";
  case Feature_file_status::UNREADABLE: return "the file cannot be read";
  case Feature_file_status::TRUNCATED:
    return "the file is truncated: it ends before all features that it announces have come";
  case Feature_file_status::SYNTAX_ERROR: return "an integer is expected here";
  case Feature_file_status::WRONG_NUMBER_OF_COLUMNS: return "a line has the wrong number of columns";
  case Feature_file_status::VERTEX_OUT_OF_RANGE: return "an index is out of range: the mesh has no such vertex";
  case Feature_file_status::FACE_OUT_OF_RANGE: return "an index is out of range: the mesh has no such face";
  case Feature_file_status::EDGE_OUT_OF_RANGE: return "an index is out of range: a face has the edges 0, 1 and 2";
  case Feature_file_status::NOT_AN_EDGE: return "a feature is no edge of the mesh";
  case Feature_file_status::TRAILING_DATA: return "the file goes on after everything that it announces";
  }
  return "";
}

/// \ingroup PkgTSplinesIO
/// How the reading of a file with features ended, and where. Lines are counted from 1. Members that `status` does not mention
/// have no meaning, but `line`.
struct Feature_file_report {
  /// what `line` is when none is to blame.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Feature_file_status status = Feature_file_status::SUCCESS; ///< how it ended
  std::size_t line = none;                                   ///< where reading stopped
  std::size_t expected = 0;                                  ///< what `status` compares with
  std::size_t actual = 0;                                    ///< what was found
  std::size_t first_vertex = 0;                              ///< counted from 0
  std::size_t second_vertex = 0;                             ///< counted from 0
  std::string text;                                          ///< what stands there
  std::size_t number_of_edges = 0;                           ///< that were marked, of SUCCESS
  std::size_t number_of_repetitions = 0;                     ///< how often one was named again, of SUCCESS

  /// returns whether `status` tells of success.
  bool success() const { return status == Feature_file_status::SUCCESS; }
  /// converts to `true` upon success.
  explicit operator bool() const { return success(); }
};

/// \ingroup PkgTSplinesIO
/// returns what `report` says, with the line, counted from 1, and the elements concerned, counted from 0.
inline std::string describe(const Feature_file_report& report)
{
  using Status = Feature_file_status;
  std::string text = report.line == Feature_file_report::none ? "" : "line " + std::to_string(report.line) + ": ";
  text += message(report.status);
  switch (report.status) {
  case Status::SUCCESS: return text + ": " + std::to_string(report.number_of_edges) + " feature edges";
  case Status::TRUNCATED:
  case Status::WRONG_NUMBER_OF_COLUMNS:
    text += " (" + std::to_string(report.actual) + " instead of " + std::to_string(report.expected) + ")";
    break;
  case Status::VERTEX_OUT_OF_RANGE: text += " (of " + std::to_string(report.expected) + " vertices)"; break;
  case Status::FACE_OUT_OF_RANGE: text += " (of " + std::to_string(report.expected) + " faces)"; break;
  case Status::NOT_AN_EDGE:
    text += " (from vertex " + std::to_string(report.first_vertex) + " to vertex " +
            std::to_string(report.second_vertex) + ", counted from 0)";
    break;
  case Status::UNREADABLE:
  case Status::SYNTAX_ERROR:
  case Status::EDGE_OUT_OF_RANGE:
  case Status::TRAILING_DATA: break;
  }
  return report.text.empty() ? text : text + ": \"" + report.text + "\"";
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_FEATURE_FILE_REPORT_H
