// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_LOWERCASE_EXTENSION_H
#define CGAL_T_SPLINES_IO_INTERNAL_LOWERCASE_EXTENSION_H

#include <cctype>
#include <filesystem>
#include <string>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What says the format of a file, with its dot.
inline std::string lowercase_extension(const std::string& filename)
{
  std::string extension = std::filesystem::path(filename).extension().string();
  for (char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_LOWERCASE_EXTENSION_H
