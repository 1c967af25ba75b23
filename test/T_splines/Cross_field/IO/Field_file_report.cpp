// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/IO/Field_file_report.h>

#include <catch2/catch.hpp>

#include <cstring>

using Status = CGAL::T_splines::Field_file_status;

TEST_CASE("every status of a field file has a sentence")
{
  for (int i = 0; i <= static_cast<int>(Status::INCONSISTENT_MATCHING); ++i)
    CHECK(std::strlen(message(static_cast<Status>(i))) > 0);
}
