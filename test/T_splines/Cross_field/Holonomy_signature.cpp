// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>

#include "test_meshes.h"

#include <catch2/catch.hpp>

namespace Holonomy_signature_test {

using Mesh = test::Surface_mesh;
using Signature = CGAL::T_splines::Holonomy_signature<Mesh>;
using Vertex = Mesh::Vertex_index;

TEST_CASE("only cones are stored")
{
  Signature signature;
  CHECK(signature.quarter_turns(Vertex(5)) == Signature::regular);
  signature.set_quarter_turns(Vertex(5), 3);
  signature.set_quarter_turns(Vertex(7), 5);
  signature.set_quarter_turns(Vertex(9), 6);
  signature.set_quarter_turns(Vertex(7), 2);
  CHECK(signature.cones().size() == 3);
  CHECK(signature.quarter_turns(Vertex(7)) == 2);
  signature.set_quarter_turns(Vertex(5), 4);
  REQUIRE(signature.cones().size() == 2);
  CHECK(signature.cones()[0] == Signature::Cone(Vertex(7), 2));
  CHECK(signature.cones()[1] == Signature::Cone(Vertex(9), 6));
  CHECK(signature.quarter_turns(Vertex(9)) == 6);
  signature.clear();
  CHECK(signature.cones().empty());
  CHECK(signature.quarter_turns(Vertex(9)) == Signature::regular);
}

TEST_CASE("loops keep their order")
{
  Signature signature;
  signature.add_loop({Mesh::Halfedge_index(1)}, 2);
  signature.add_loop({Mesh::Halfedge_index(3), Mesh::Halfedge_index(4)}, -1);
  signature.set_loop_quarter_turns(0, 7);
  REQUIRE(signature.loops().size() == 2);
  CHECK(signature.loops()[0].quarter_turns == 7);
  CHECK(signature.loops()[1].quarter_turns == -1);
  CHECK(signature.loops()[1].halfedges.size() == 2);
}

} // namespace Holonomy_signature_test
