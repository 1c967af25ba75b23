// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_READING_ADVICE_H
#define MESH_TO_T_SPLINE_READING_ADVICE_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>

#include <sstream>
#include <string>

/// What to do about a file that was refused and that no option helps to read.
inline std::string advice_without_options(const CGAL::T_splines::Mesh_reading_status status)
{
  using Status = CGAL::T_splines::Mesh_reading_status;
  switch (status) {
  case Status::SUCCESS:
  case Status::OUTPUT_NOT_EMPTY:
  case Status::INTERRUPTED: return "";
  case Status::CANNOT_OPEN: return "check the name of the file, and whether it may be read";
  case Status::UNKNOWN_FORMAT: return "convert the file, or give it the extension of its format";
  case Status::UNSUPPORTED_VARIANT: return "save the mesh in another of the formats, binary PLY for instance";
  case Status::EMPTY: return "export the mesh again, with its faces";
  case Status::TRUNCATED: return "copy or export the file again";
  case Status::SYNTAX_ERROR:
  case Status::NON_FINITE_COORDINATE:
  case Status::INDEX_OUT_OF_RANGE: return "correct the file there, or export the mesh again";
  case Status::TOO_MANY_CORNERS: return "triangulate the mesh first";
  case Status::TOO_FEW_CORNERS:
  case Status::REPEATED_VERTEX:
  case Status::DUPLICATE_FACE:
  case Status::NON_MANIFOLD_EDGE:
  case Status::INCONSISTENT_ORIENTATION:
  case Status::NON_MANIFOLD_VERTEX:
  case Status::ISOLATED_VERTEX:
  case Status::ZERO_LENGTH_EDGE:
  case Status::ZERO_AREA_TRIANGLE: return "correct the mesh there in a mesh editor";
  case Status::NON_ORIENTABLE: return "a surface with one side only cannot be used; thicken it to a body first";
  case Status::BOUNDARY: return "fill the holes first, in a mesh editor for instance";
  case Status::MISSING_UV: return "export the map with uv (vt) at every corner";
  }
  return "";
}

/// What to do about a file that was refused, in the words of the program's options.
inline std::string advice(const CGAL::T_splines::Mesh_reading_report& report)
{
  std::ostringstream text;
  text.precision(2);
  if (report.closing_distance)
    text << "--merge " << *report.closing_distance << " closes it";
  if (report.closing_distance && report.is_repairable)
    text << ", and so does --repair";
  else if (report.is_repairable)
    text << "--repair mends it";
  return text.str().empty() ? advice_without_options(report.status) : text.str();
}

#endif // MESH_TO_T_SPLINE_READING_ADVICE_H
