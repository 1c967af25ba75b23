// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <set>
#include <utility>

namespace T_mesh_coordinates_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using FT = CGAL::Exact_rational;

} // namespace

TEMPLATE_TEST_CASE("frames of faces and the similarities between them", "[T_mesh_coordinates]", Surface_mesh,
                   Polyhedron)
{
  using Mesh = test_t_meshes::T_mesh<TestType, FT>;
  using Coordinates = CGAL::T_splines::T_mesh_coordinates<CGAL::T_splines::Const_T_mesh_view_of<Mesh>>;
  for (const auto& faces_given :
       {test_t_meshes::cube<FT>(), test_t_meshes::torus<FT>(3, 2), test_t_meshes::folded_square<FT>(),
        test_t_meshes::genus_two<FT>(), test_t_meshes::pinwheel<FT>(FT(7) / 3), test_t_meshes::rectangle<FT>(2, 2)}) {
    Mesh t(faces_given);
    const Coordinates coordinates(t);
    for (const auto f : faces(t.mesh)) {
      const FT width = coordinates.width(f), height = coordinates.height(f);
      CHECK(coordinates.side(halfedge(f, t.mesh)) == 0);
      // Around the face, each halfedge goes on where the one before ends, with its side's direction and its own length.
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh)) {
        const std::pair<FT, FT> p = coordinates.source_point(h), q = coordinates.target_point(h);
        CHECK(q == coordinates.source_point(next(h, t.mesh)));
        const FT knot = get(t.knots(), h), u = q.first - p.first, v = q.second - p.second;
        switch (coordinates.side(h)) {
        case 0: CHECK((u == knot && v == 0 && p.second == 0)); break;
        case 1: CHECK((u == 0 && v == knot && p.first == width)); break;
        case 2: CHECK((u == -knot && v == 0 && p.second == height)); break;
        default: CHECK((u == 0 && v == -knot && p.first == 0));
        }
        if (is_border(opposite(h, t.mesh), t.mesh))
          continue;
        const auto transition = coordinates.transition(h);
        const auto o = opposite(h, t.mesh);
        CHECK(transition(p.first, p.second) == coordinates.target_point(o));
        CHECK(transition(q.first, q.second) == coordinates.source_point(o));
        CHECK(compose(coordinates.transition(o), transition).is_identity());
      }
    }
    // Around regular vertices the transitions compose to the identity, around cones to k_v quarter turns about them.
    for (const auto v : vertices(t.mesh)) {
      if (CGAL::T_splines::is_border_vertex(v, t))
        continue;
      CGAL::T_splines::Similarity_2<FT> turn;
      for (const auto h : CGAL::halfedges_around_target(halfedge(v, t.mesh), t.mesh))
        turn = compose(coordinates.transition(next(h, t.mesh)), turn);
      const int k = CGAL::T_splines::extended_valence(v, t);
      CHECK(turn.scale() == 1);
      CHECK((turn.quarter_turns() - k) % 4 == 0);
      const std::pair<FT, FT> p = coordinates.target_point(halfedge(v, t.mesh));
      CHECK(turn(p.first, p.second) == p);
    }
  }
}

TEST_CASE("the frame follows the halfedge of the face", "[T_mesh_coordinates]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, FT>;
  Mesh t(test_t_meshes::pinwheel<FT>(3));
  const CGAL::T_splines::T_mesh_coordinates coordinates(t);
  const auto f = t.face_list[1];
  CHECK(coordinates.width(f) == 4);
  CHECK(coordinates.height(f) == 2);
  const auto h = t.halfedge_of(1, 3); // in the middle of the third side
  CHECK(coordinates.side(h) == 2);
  set_halfedge(f, t.halfedge_of(1, 1), t.mesh);
  CHECK(coordinates.width(f) == 2);
  CHECK(coordinates.height(f) == 4);
  CHECK(coordinates.side(h) == 1);
  set_halfedge(f, h, t.mesh);
  CHECK(coordinates.width(f) == 4);
  CHECK(coordinates.side(h) == 0);
  CHECK(coordinates.source_point(h).first > 0);
}

} // namespace T_mesh_coordinates_test
