// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_TEXT_WRITER_H
#define CGAL_T_SPLINES_IO_INTERNAL_TEXT_WRITER_H

#include <CGAL/number_utils.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <ios>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Puts a file together and hands it on to a stream in large pieces. Numbers are written in the shortest way that reads back
/// as the same double, whatever the locale and the flags of the stream.
class Text_writer {
public:
  explicit Text_writer(std::ostream& out) : m_out(out) { m_buffer.reserve(capacity + 64); }

  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;

  Text_writer& operator<<(const std::string_view text)
  {
    m_buffer += text;
    if (m_buffer.size() > capacity)
      flush();
    return *this;
  }

  Text_writer& operator<<(const double number) { return write_number(number); }
  Text_writer& operator<<(const std::size_t number) { return write_number(number); }

  /// Writes the coordinates of a point or vector in space, with blanks between them.
  template <typename Point_3>
  Text_writer& write_coordinates(const Point_3& p)
  {
    return *this << CGAL::to_double(p.x()) << " " << CGAL::to_double(p.y()) << " " << CGAL::to_double(p.z());
  }

  /// Hands on what is left. \return `std::io_errc::stream` if the stream has failed
  std::error_code finish()
  {
    flush();
    return m_out.good() ? std::error_code() : std::make_error_code(std::io_errc::stream);
  }

private:
  static constexpr std::size_t capacity = 1 << 16;

  void flush()
  {
    m_out.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_buffer.clear();
  }

  template <typename Number>
  Text_writer& write_number(const Number number)
  {
    std::array<char, 32> digits;
    const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return *this << std::string_view(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
  }

  std::ostream& m_out;
  std::string m_buffer;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_TEXT_WRITER_H
