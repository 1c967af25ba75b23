// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_REPORT_AT_H
#define CGAL_T_SPLINES_IO_INTERNAL_REPORT_AT_H

#include <CGAL/T_splines/IO/Mesh_reading_report.h>
#include <CGAL/T_splines/IO/internal/Text_scanner.h>

#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A report about this line of the text.
inline Mesh_reading_report report_at(const Text_scanner& scanner, const Mesh_reading_status status,
                                     const std::string_view text = {})
{
  Mesh_reading_report report;
  report.status = status;
  report.line = scanner.line();
  report.text = quotable(text);
  return report;
}

/// A report about this line that says what is wrong with it.
inline Mesh_reading_report report_syntax(const Text_scanner& scanner, const char* detail,
                                         const std::string_view text = {})
{
  Mesh_reading_report report = report_at(scanner, Mesh_reading_status::SYNTAX_ERROR, text);
  report.detail = detail;
  return report;
}

/// A report about a line that lacks a token: the last line of a file was cut off, another one is wrong.
inline Mesh_reading_report report_missing_token(const Text_scanner& scanner, const char* detail)
{
  return scanner.is_last_line() ? report_at(scanner, Mesh_reading_status::TRUNCATED) : report_syntax(scanner, detail);
}

/// A whole token as coordinate. \return `SUCCESS`, `SYNTAX_ERROR` or `NON_FINITE_COORDINATE`
inline Mesh_reading_status parse_coordinate(const std::string_view token, double& value)
{
  switch (parse_number(token, value)) {
  case Token_kind::FINITE_NUMBER: return Mesh_reading_status::SUCCESS;
  case Token_kind::NON_FINITE_NUMBER: return Mesh_reading_status::NON_FINITE_COORDINATE;
  case Token_kind::NO_NUMBER: break;
  }
  return Mesh_reading_status::SYNTAX_ERROR;
}

/// What `read_coordinates()` says if there are too few.
constexpr const char* missing_coordinate = "a coordinate is missing";

/// Reads the coordinates `first` ... `last` from the tokens of this line.
template <typename Iterator>
Mesh_reading_report read_coordinates(Text_scanner& scanner, const Iterator first, const Iterator last)
{
  std::string_view token;
  for (Iterator position = first; position != last; ++position) {
    if (!scanner.next_token(token))
      return report_missing_token(scanner, missing_coordinate);
    const Mesh_reading_status status = parse_coordinate(token, *position);
    if (status != Mesh_reading_status::SUCCESS)
      return report_at(scanner, status, token);
  }
  return Mesh_reading_report();
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_REPORT_AT_H
