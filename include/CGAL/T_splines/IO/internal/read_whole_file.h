// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_READ_WHOLE_FILE_H
#define CGAL_T_SPLINES_IO_INTERNAL_READ_WHOLE_FILE_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The bytes of a file. \return whether they could be read.
inline bool read_whole_file(const std::string& filename, std::string& content)
{
  std::error_code error;
  if (std::filesystem::is_directory(filename, error))
    return false;
  std::ifstream stream(filename, std::ios::binary);
  if (!stream)
    return false;
  content.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  return !stream.bad();
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_READ_WHOLE_FILE_H
