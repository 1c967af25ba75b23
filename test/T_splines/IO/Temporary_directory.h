// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_IO_TEMPORARY_DIRECTORY_H
#define T_SPLINES_TEST_IO_TEMPORARY_DIRECTORY_H

#include <filesystem>
#include <random>
#include <string>

/// A new empty directory that lives as long as the object: tests run side by side.
class Temporary_directory {
public:
  Temporary_directory()
  {
    std::random_device random;
    do
      m_path = std::filesystem::temp_directory_path() / ("t_splines_test_" + std::to_string(random()));
    while (!std::filesystem::create_directory(m_path));
  }
  ~Temporary_directory() { std::filesystem::remove_all(m_path); }

  Temporary_directory(const Temporary_directory&) = delete;
  Temporary_directory& operator=(const Temporary_directory&) = delete;

  const std::filesystem::path& path() const { return m_path; }
  std::string file(const std::string& name) const { return (m_path / name).string(); }

private:
  std::filesystem::path m_path;
};

#endif // T_SPLINES_TEST_IO_TEMPORARY_DIRECTORY_H
