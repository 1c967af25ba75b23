// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_TEXT_WRITER_H
#define CGAL_T_SPLINES_IO_INTERNAL_TEXT_WRITER_H

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Puts text together and hands it on in large pieces. Numbers are written in the shortest way that reads back as the same
/// double, whatever the locale.
/// \tparam Sink a function object that takes a `std::string_view`.
template <typename Sink>
class Text_writer {
public:
  explicit Text_writer(Sink& sink) : m_sink(sink) { m_buffer.reserve(capacity + 64); }
  ~Text_writer() { flush(); }

  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;

  Text_writer& operator<<(const std::string_view text)
  {
    m_buffer += text;
    if (m_buffer.size() > capacity)
      flush();
    return *this;
  }

  Text_writer& operator<<(const double number) { return append_number(number); }
  Text_writer& operator<<(const std::size_t number) { return append_number(number); }

  void flush()
  {
    m_sink(std::string_view(m_buffer));
    m_buffer.clear();
  }

private:
  static constexpr std::size_t capacity = 1 << 16;

  template <typename Number>
  Text_writer& append_number(const Number number)
  {
    std::array<char, 32> digits;
    const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return *this << std::string_view(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
  }

  Sink& m_sink;
  std::string m_buffer;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_TEXT_WRITER_H
