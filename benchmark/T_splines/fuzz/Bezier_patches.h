// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_FUZZ_BEZIER_PATCHES_H
#define T_SPLINES_BENCHMARK_FUZZ_BEZIER_PATCHES_H

// Reads the Bezier patches of a t_spline.vtu and evaluates them, without any code of the package: what is measured with
// this is what another program sees.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace fuzz {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

/// A point of a patch with the two first derivatives.
struct Patch_point {
  Point point;
  Vector du, dv;
};

/// A rational bicubic patch over the unit square.
struct Patch {
  std::array<std::array<Vector, 4>, 4> points; // times weight
  std::array<std::array<double, 4>, 4> weights;

  Patch_point operator()(const double u, const double v) const
  {
    const auto [bu, du] = bernstein(u);
    const auto [bv, dv] = bernstein(v);
    Vector p(0, 0, 0), p_u = p, p_v = p;
    double w = 0, w_u = 0, w_v = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        p += bu[i] * bv[j] * points[i][j];
        p_u += du[i] * bv[j] * points[i][j];
        p_v += bu[i] * dv[j] * points[i][j];
        w += bu[i] * bv[j] * weights[i][j];
        w_u += du[i] * bv[j] * weights[i][j];
        w_v += bu[i] * dv[j] * weights[i][j];
      }
    const Vector s = p / w;
    return {CGAL::ORIGIN + s, (p_u - w_u * s) / w, (p_v - w_v * s) / w};
  }

private:
  struct Basis {
    std::array<double, 4> values, derivatives;
  };
  static Basis bernstein(const double t)
  {
    const double s = 1 - t;
    return {{s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t},
            {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t}};
  }
};

/// decodes base64 in which VTK writes an array, without the eight bytes of its length.
inline std::vector<char> decode_array(const std::string& text, std::size_t begin, const std::size_t end)
{
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> value{};
  value.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i)
    value[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
  std::vector<char> bytes;
  unsigned bits = 0, number = 0;
  for (; begin != end; ++begin) {
    const int digit = value[static_cast<unsigned char>(text[begin])];
    if (digit < 0)
      continue;
    bits = bits << 6 | static_cast<unsigned>(digit);
    number += 6;
    if (number >= 8) {
      number -= 8;
      bytes.push_back(static_cast<char>(bits >> number & 255));
    }
  }
  bytes.erase(bytes.begin(), bytes.begin() + std::min<std::ptrdiff_t>(8, static_cast<std::ptrdiff_t>(bytes.size())));
  return bytes;
}

template <typename T>
std::vector<T> array_of(const std::vector<char>& bytes)
{
  std::vector<T> result(bytes.size() / sizeof(T));
  std::memcpy(result.data(), bytes.data(), result.size() * sizeof(T));
  return result;
}

/// reads the cells of a file of VTK_BEZIER_QUADRILATERAL cells of degree 3. \return none if it is no such file
inline std::vector<Patch> read_patches(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::stringstream buffer;
  buffer << in.rdbuf();
  const std::string text = buffer.str();
  std::map<std::string, std::vector<char>> arrays; // the points have no name
  for (std::size_t at = 0; (at = text.find("<DataArray", at)) != std::string::npos;) {
    const std::size_t close = text.find('>', at), end = text.find('<', close), name = text.find("Name=\"", at);
    const bool is_named = name < close;
    arrays[is_named ? text.substr(name + 6, text.find('"', name + 6) - name - 6) : ""] = decode_array(text, close, end);
    at = end;
  }
  const auto corners = array_of<std::int64_t>(arrays["connectivity"]);
  const auto points = array_of<double>(arrays[""]), weights = array_of<double>(arrays["RationalWeights"]);
  const std::vector<char>& types = arrays["types"];
  const bool is_bezier = std::all_of(types.begin(), types.end(), [](const char type) { return type == 77; });
  if (!is_bezier || corners.size() != 16 * types.size() || points.size() != 3 * weights.size())
    return {};
  static const std::size_t order[16][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 0}, {2, 0}, {3, 1}, {3, 2},
                                           {1, 3}, {2, 3}, {0, 1}, {0, 2}, {1, 1}, {2, 1}, {1, 2}, {2, 2}};
  std::vector<Patch> patches(types.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (std::size_t k = 0; k < 16; ++k) {
      const auto n = static_cast<std::size_t>(corners[16 * i + k]);
      const double w = weights[n];
      patches[i].weights[order[k][0]][order[k][1]] = w;
      patches[i].points[order[k][0]][order[k][1]] = w * Vector(points[3 * n], points[3 * n + 1], points[3 * n + 2]);
    }
  return patches;
}

} // namespace fuzz

#endif // T_SPLINES_BENCHMARK_FUZZ_BEZIER_PATCHES_H
