// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_rawfield.h>
#include <CGAL/T_splines/IO/write_rawfield.h>

#include "Cross_field/test_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace ts = CGAL::T_splines;

TEMPLATE_TEST_CASE("what is written is read back", "", test::Surface_mesh, test::Polyhedron_3,
                   test::Linear_cell_complex)
{
  TestType mesh = test::to_mesh<TestType>(test::torus(12, 9));
  const auto field = test::field_around_axis(mesh);
  std::stringstream stream;
  ts::write_rawfield(stream, mesh, field);
  auto copy = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::read_rawfield(stream, mesh, copy).success());
  for (const auto f : faces(mesh)) {
    const test::Vector_3 a = get(field, f), b = get(copy, f);
    const double cosine = a * b / std::sqrt(a.squared_length());
    CHECK(cosine * cosine * (1 - cosine * cosine) == Approx(0).margin(1e-13));
  }
}
