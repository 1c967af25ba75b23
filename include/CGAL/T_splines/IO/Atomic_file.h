// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_ATOMIC_FILE_H
#define CGAL_T_SPLINES_IO_ATOMIC_FILE_H

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// A file that appears under its name only when it is complete, and until then leaves what stood there alone.
///
/// The content goes through `write()` or `stream()` to a temporary name in the same directory. `finish()` brings it to the disk, `commit()` renames it;
/// several files are published together by finishing all before committing any. An object that is destroyed without `commit()`
/// removes its temporary file.
class Atomic_file {
public:
  /// opens a temporary file beside `path`. What fails is told by `error()`.
  explicit Atomic_file(std::filesystem::path path) : m_path(std::move(path))
  {
    for (int i = 0; m_stream == nullptr && i < 1000; ++i) {
      m_temporary = m_path;
      m_temporary += ".part" + std::to_string(i);
      m_stream = std::fopen(m_temporary.string().c_str(), "wbx"); // never a file that is there
      if (m_stream == nullptr && errno != EEXIST)
        break;
    }
    if (m_stream == nullptr)
      m_error = errno;
  }

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  ~Atomic_file()
  {
    const bool has_temporary = m_stream != nullptr || (m_is_finished && !m_is_committed);
    if (m_stream != nullptr)
      std::fclose(m_stream);
    if (has_temporary) {
      std::error_code ignored;
      std::filesystem::remove(m_temporary, ignored);
    }
  }

  /// appends to the file. What fails is told by `error()`.
  void write(const std::string_view data)
  {
    if (m_error == 0 && std::fwrite(data.data(), 1, data.size(), m_stream) != data.size())
      m_error = errno != 0 ? errno : EIO;
  }

  /// returns a stream that appends to the file, for the functions of this package that write to streams.
  std::ostream& stream() { return m_output; }

  /// flushes everything to the disk. \return whether the file is complete.
  bool finish()
  {
    if (m_stream == nullptr)
      return false;
    record_error(std::fflush(m_stream) == 0);
#if defined(__unix__) || defined(__APPLE__)
    record_error(::fsync(::fileno(m_stream)) == 0 || errno == EINVAL || errno == ENOTSUP);
#endif
    record_error(std::fclose(m_stream) == 0);
    m_stream = nullptr;
    m_is_finished = true;
    return m_error == 0;
  }

  /// gives the finished file its name. \return whether it has it.
  bool commit()
  {
    if (!m_is_finished || m_error != 0)
      return false;
    std::error_code error;
    std::filesystem::rename(m_temporary, m_path, error);
    if (error)
      m_error = error.value();
    else
      m_is_committed = true;
    return m_is_committed;
  }

  /// `errno` of the first failure; 0 if there was none.
  int error() const
  {
    return m_error;
  }

  /// returns the name that the file will have.
  const std::filesystem::path& path() const
  {
    return m_path;
  }

private:
  void record_error(const bool succeeded)
  {
    if (!succeeded && m_error == 0)
      m_error = errno != 0 ? errno : EIO;
  }

  // Hands what the stream gets to `write()`.
  class Buffer : public std::streambuf {
  public:
    explicit Buffer(Atomic_file& file) : m_file(file) {}

  private:
    int_type overflow(const int_type c) override
    {
      if (traits_type::eq_int_type(c, traits_type::eof()))
        return traits_type::not_eof(c);
      const char character = traits_type::to_char_type(c);
      return xsputn(&character, 1) == 1 ? c : traits_type::eof();
    }

    std::streamsize xsputn(const char* const data, const std::streamsize size) override
    {
      m_file.write(std::string_view(data, static_cast<std::size_t>(size)));
      return m_file.error() == 0 ? size : 0;
    }

    Atomic_file& m_file;
  };

  Buffer m_buffer{*this};
  std::ostream m_output{&m_buffer};
  std::filesystem::path m_path, m_temporary;
  std::FILE* m_stream = nullptr;
  bool m_is_finished = false, m_is_committed = false;
  int m_error = 0;
};

namespace internal {

/// What the functions that write to a file have in common: it appears when it is complete, or not at all.
/// \param write is called with a stream
/// \return the error of the operating system
template <typename Write>
std::error_code write_file(const std::string& filename, const Write& write)
{
  Atomic_file file(filename);
  write(file.stream());
  file.finish() && file.commit();
  return std::error_code(file.error(), std::generic_category());
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_ATOMIC_FILE_H
