// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <cstring>

TEST_CASE("every status of a signature has a sentence")
{
  using Status = CGAL::T_splines::Holonomy_signature_status;
  for (int i = 0; i <= static_cast<int>(Status::LOOP_NOT_INTEGER); ++i)
    CHECK(std::strlen(message(static_cast<Status>(i))) > 0);
  CHECK(CGAL::T_splines::Holonomy_signature_report<test::Surface_mesh>().success());
}
