// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/IO/read_rawfield.h>
#include <CGAL/T_splines/IO/write_rawfield.h>

#include "Cross_field/test_meshes.h"
#include "IO/Temporary_directory.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <ios>
#include <iterator>
#include <sstream>
#include <string>

namespace write_rawfield_test {

namespace ts = CGAL::T_splines;

TEMPLATE_TEST_CASE("what is written is read back", "", test::Surface_mesh, test::Polyhedron_3,
                   test::Linear_cell_complex)
{
  TestType mesh = test::to_mesh<TestType>(test::torus(12, 9));
  const auto field = test::field_around_axis(mesh);
  std::stringstream stream;
  CHECK_FALSE(ts::write_rawfield(stream, mesh, field));
  auto copy = get(CGAL::dynamic_face_property_t<test::Vector_3>(), mesh);
  REQUIRE(ts::read_rawfield(stream, mesh, copy).success());
  for (const auto f : faces(mesh)) {
    const test::Vector_3 a = get(field, f), b = get(copy, f);
    const double cosine = a * b / std::sqrt(a.squared_length());
    CHECK(cosine * cosine * (1 - cosine * cosine) == Approx(0).margin(1e-13));
  }
}

TEST_CASE("a field that cannot be written is an error, and a file is written whole or not at all")
{
  test::Surface_mesh mesh = test::to_mesh<test::Surface_mesh>(test::torus(12, 9));
  const auto field = test::field_around_axis(mesh);
  std::ostringstream stream, failed;
  failed.setstate(std::ios::badbit);
  CHECK(ts::write_rawfield(failed, mesh, field) == std::io_errc::stream);
  const Temporary_directory directory;
  REQUIRE_FALSE(ts::write_rawfield(stream, mesh, field));
  REQUIRE_FALSE(ts::write_rawfield(directory.file("a.rawfield"), mesh, field));
  std::ifstream file(directory.file("a.rawfield"), std::ios::binary);
  CHECK(std::string(std::istreambuf_iterator<char>(file), {}) == stream.str());
  CHECK(ts::write_rawfield(directory.file("none/a.rawfield"), mesh, field));
}

} // namespace write_rawfield_test
