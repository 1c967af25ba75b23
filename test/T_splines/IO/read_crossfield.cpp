// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_crossfield.h>

#include "IO/Triangle_with_field.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace read_crossfield_test {

namespace ts = CGAL::T_splines;
using Status = ts::Field_file_status;

TEST_CASE("a crossfield has a flag and two axes per face, not ordered")
{
  Triangle_with_field triangle;
  for (const char* text : {"2 1\n1 2 1 0 -1 2 0\n", "2 1\n0 -1 2 0 -2 -1 0", "2 1\r\n0 -1 2 0 2 1 0\r\n"}) {
    std::istringstream input(text);
    REQUIRE(ts::read_crossfield(input, triangle.mesh, triangle.field).success());
    CHECK(triangle.angle() == Approx(std::atan2(1., 2.)));
  }
}

TEST_CASE("bad crossfields are refused")
{
  Triangle_with_field triangle;
  const auto status = [&triangle](const std::string& text) {
    std::istringstream input(text);
    return ts::read_crossfield(input, triangle.mesh, triangle.field).status;
  };
  CHECK(status("4 1\n1 2 1 0 -1 2 0\n") == Status::WRONG_SYMMETRY);
  CHECK(status("2 2\n1 2 1 0 -1 2 0\n") == Status::WRONG_COUNT);
  CHECK(status("2 1\n1 2 1 0 -1 2\n") == Status::TRUNCATED);
  CHECK(status("2 1\n1 2 1 0 -4 -2 0\n") == Status::NOT_A_CROSS);
  CHECK(status("2 1\n1 2 1 0 0 0 0\n") == Status::ZERO_VECTOR);
  CHECK(status("2 1\n1 2 1 0 0 0 1\n") == Status::NOT_TANGENT);
}

} // namespace read_crossfield_test
