// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_BASE64_H
#define CGAL_T_SPLINES_IO_BASE64_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// returns the bytes in base64 (RFC 4648).
inline std::string base64(const std::string_view bytes)
{
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = 256 * group + (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > bytes.size() ? '=' : digits[(group >> (18 - 6 * j)) & 63];
  }
  return text;
}

/// \ingroup PkgTSplinesIO
/// returns the bytes of an array, the lowest of each number first.
template <typename Number>
std::string little_endian_bytes(const std::vector<Number>& numbers)
{
  using Small_bits = std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                                  std::conditional_t<sizeof(Number) == 4, std::uint32_t, Small_bits>>;
  static_assert(sizeof(Bits) == sizeof(Number), "8, 4, 2 or 1 bytes");
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (const Number& number : numbers) {
    Bits bits;
    std::memcpy(&bits, &number, sizeof(Number));
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes += static_cast<char>((bits >> (8 * i)) & 255);
  }
  return bytes;
}

/// \ingroup PkgTSplinesIO
/// returns the bytes of an array in base64: what typed arrays are on every machine with a browser.
template <typename Number>
std::string base64_of_array(const std::vector<Number>& numbers)
{
  return base64(little_endian_bytes(numbers));
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_BASE64_H
