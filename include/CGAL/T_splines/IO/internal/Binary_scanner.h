// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_BINARY_SCANNER_H
#define CGAL_T_SPLINES_IO_INTERNAL_BINARY_SCANNER_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace CGAL {
namespace T_splines {
namespace internal {

enum class Byte_order { LITTLE, BIG };

inline Byte_order native_byte_order()
{
  const unsigned short one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1 ? Byte_order::LITTLE : Byte_order::BIG;
}

/// Reads numbers from a block of bytes.
class Binary_scanner {
public:
  Binary_scanner(const std::string_view data, const Byte_order order) : m_rest(data), m_order(order) {}

  std::size_t remaining_bytes() const { return m_rest.size(); }

  /// \pre At least `sizeof(Number)` bytes remain.
  template <typename Number>
  Number read()
  {
    CGAL_precondition(m_rest.size() >= sizeof(Number));
    std::array<char, sizeof(Number)> bytes;
    std::copy(m_rest.begin(), m_rest.begin() + sizeof(Number), bytes.begin());
    if (m_order != native_byte_order())
      std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), sizeof(Number));
    m_rest.remove_prefix(sizeof(Number));
    return number;
  }

private:
  std::string_view m_rest;
  Byte_order m_order;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_BINARY_SCANNER_H
