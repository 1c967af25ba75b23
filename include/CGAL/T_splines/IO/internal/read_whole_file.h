// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_READ_WHOLE_FILE_H
#define CGAL_T_SPLINES_IO_INTERNAL_READ_WHOLE_FILE_H

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ios>
#include <istream>
#include <string>
#include <system_error>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The bytes of a stream from its position to its end. \return whether they could be read.
inline bool read_whole_stream(std::istream& stream, std::string& content)
{
  content.clear();
  if (!stream.good() || stream.rdbuf() == nullptr)
    return false;
  constexpr std::streamsize size_of_block = 1 << 16;
  std::streamsize number_read = size_of_block;
  while (number_read == size_of_block) {
    const std::size_t size = content.size();
    content.resize(size + size_of_block);
    try { // the buffer itself: the stream would throw at its end, if its user has asked for that
      number_read = stream.rdbuf()->sgetn(&content[size], size_of_block);
    }
    catch (const std::ios_base::failure&) {
      return false;
    }
    content.resize(size + static_cast<std::size_t>(number_read));
  }
  return true;
}

/// The bytes of a file. \return whether they could be read.
inline bool read_whole_file(const std::string& filename, std::string& content)
{
  std::error_code error;
  if (std::filesystem::is_directory(filename, error))
    return false;
  std::ifstream stream(filename, std::ios::binary);
  return read_whole_stream(stream, content);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_READ_WHOLE_FILE_H
