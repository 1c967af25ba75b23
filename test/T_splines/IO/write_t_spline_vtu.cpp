// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/write_t_spline_vtu.h>

#include <CGAL/T_splines/Spline/compile_T_spline.h>

#include "IO/Temporary_directory.h"
#include "random_torus.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace write_t_spline_vtu_test {

namespace {

using Kernel = Random_torus::Kernel;
namespace T = CGAL::T_splines;

/// The numbers of the array whose tag contains `name`.
template <typename Number>
std::vector<Number> array_of(const std::string& file, const std::string& name)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::size_t i = file.find('\n', file.find(name)) + 1;
  std::string bytes;
  std::uint32_t group = 0;
  for (int bits = 0; file[i] != '\n' && file[i] != '='; ++i) {
    group = 64 * group + static_cast<std::uint32_t>(digits.find(file[i]));
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes += static_cast<char>(group >> bits & 255);
    }
  }
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), 8);
  REQUIRE(bytes.size() == size + 8);
  std::vector<Number> numbers(size / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data() + 8, size);
  return numbers;
}

} // namespace

TEST_CASE("a VTK file has the control points and weights of all patches, bit by bit", "[write_t_spline_vtu]")
{
  const Random_torus torus = random_torus(5);
  const auto surface = T::compile_T_spline(torus.surface());
  std::ostringstream out;
  REQUIRE_FALSE(T::write_t_spline_vtu(out, surface));
  const std::string file = out.str();
  CHECK(file.find("<PointData RationalWeights=\"RationalWeights\">") != std::string::npos);
  const auto points = array_of<double>(file, "NumberOfComponents");
  const auto weights = array_of<double>(file, "Name=\"RationalWeights\"");
  const auto connectivity = array_of<std::int64_t>(file, "Name=\"connectivity\"");
  const auto offsets = array_of<std::int64_t>(file, "Name=\"offsets\"");
  const auto types = array_of<std::uint8_t>(file, "Name=\"types\"");
  const auto caps = array_of<std::uint8_t>(file, "Name=\"is_cap\"");
  const std::size_t n = surface.number_of_patches();
  REQUIRE(n == 25);
  REQUIRE(points.size() == 48 * n);
  REQUIRE(connectivity.size() == 16 * n);
  REQUIRE(offsets.size() == n);
  // The order of VTK: corners, then the inner points of bottom, right, top and left, then the inside.
  const std::array<std::array<int, 2>, 16> order{{{0, 0},
                                                  {3, 0},
                                                  {3, 3},
                                                  {0, 3},
                                                  {1, 0},
                                                  {2, 0},
                                                  {3, 1},
                                                  {3, 2},
                                                  {1, 3},
                                                  {2, 3},
                                                  {0, 1},
                                                  {0, 2},
                                                  {1, 1},
                                                  {2, 1},
                                                  {1, 2},
                                                  {2, 2}}};
  for (std::size_t i = 0; i < n; ++i) {
    CHECK(types[i] == 77);
    CHECK(caps[i] == 0);
    CHECK(offsets[i] == static_cast<std::int64_t>(16 * (i + 1)));
    for (std::size_t k = 0; k < 16; ++k) {
      const auto j = static_cast<std::size_t>(connectivity[16 * i + k]);
      const Kernel::Point_3 p(points[3 * j], points[3 * j + 1], points[3 * j + 2]);
      CHECK(p == surface.patch(i).control_point(order[k][0], order[k][1]));
      CHECK(weights[j] == surface.patch(i).weight(order[k][0], order[k][1]));
    }
  }
}

TEST_CASE("a VTK file is written whole or not at all", "[write_t_spline_vtu]")
{
  const Temporary_directory directory;
  const Random_torus torus = random_torus(5);
  const auto surface = T::compile_T_spline(torus.surface());
  CHECK_FALSE(T::write_t_spline_vtu(directory.file("torus.vtu"), surface));
  CHECK(std::filesystem::exists(directory.file("torus.vtu")));
  CHECK(T::write_t_spline_vtu(directory.file("no/torus.vtu"), surface));
  std::ostringstream broken;
  broken.setstate(std::ios::badbit);
  CHECK(T::write_t_spline_vtu(broken, surface));
}

} // namespace write_t_spline_vtu_test
