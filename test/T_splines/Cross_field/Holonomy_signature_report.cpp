// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/Holonomy_signature_report.h>

#include <CGAL/T_splines/Cross_field/holonomy_signature_of_cones.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace Holonomy_signature_report_test {

TEST_CASE("a refusal of a signature names the element, counted from 0, and the numbers")
{
  namespace ts = CGAL::T_splines;
  using Mesh = test::Surface_mesh;
  const Mesh mesh = test::to_mesh<Mesh>(test::plate(1));
  const auto refusal = [&mesh](const std::vector<std::pair<Mesh::Vertex_index, int>>& cones, const auto& np) {
    ts::Holonomy_signature<Mesh> signature;
    const auto report = ts::holonomy_signature_of_cones(mesh, cones, signature, np);
    CHECK_FALSE(report);
    return describe(report, mesh);
  };
  const auto none = CGAL::parameters::default_values();
  const Mesh::Vertex_index v(7);
  CHECK(refusal({{v, 3}}, none)
            .find(": the sum over component 0 is 1 instead of 0 (off by 1); raise its numbers k by 1 in all") !=
        std::string::npos);
  CHECK(refusal({{v, 3}, {v, 5}}, none) ==
        "a vertex is given as a cone, or as a corner, twice: vertex 7, counted from 0");
  CHECK(refusal({{v, -2}}, none).find(": vertex 7, counted from 0, has k = -2") != std::string::npos);
  CHECK(refusal({{Mesh::null_vertex(), 3}}, none) == "a cone or corner has no vertex: cone 0, counted from 0");
  CHECK(refusal({}, ts::parameters::loop_turning_numbers(std::vector<int>{1, 2, 3})) ==
        "there are not as many turning numbers as loops: the number of turning numbers is 3 instead of 2");
}

} // namespace Holonomy_signature_report_test
