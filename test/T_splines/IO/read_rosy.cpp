// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_rosy.h>

#include "IO/Triangle_with_field.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace read_rosy_test {

namespace ts = CGAL::T_splines;
using Status = ts::Field_file_status;

TEST_CASE("a rosy field has one vector per face")
{
  Triangle_with_field triangle;
  std::istringstream input("1\n4\n-2 -1 0 \n");
  REQUIRE(ts::read_rosy(input, triangle.mesh, triangle.field).success());
  CHECK(triangle.angle() == Approx(std::atan2(1., 2.)));
  const auto status = [&triangle](const std::string& text) {
    std::istringstream bad(text);
    return ts::read_rosy(bad, triangle.mesh, triangle.field).status;
  };
  CHECK(status("1\n2\n1 0 0\n") == Status::WRONG_SYMMETRY);
  CHECK(status("3\n4\n1 0 0\n1 0 0\n1 0 0\n") == Status::WRONG_COUNT); // a field on vertices
  CHECK(status("1\n4\n0 0 0\n") == Status::ZERO_VECTOR);
  CHECK(status("1\n4\n0 0 2\n") == Status::NOT_TANGENT);
  CHECK(status("1\n4\n") == Status::TRUNCATED);
}

} // namespace read_rosy_test
