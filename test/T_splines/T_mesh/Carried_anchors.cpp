// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/Carried_anchors.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <catch2/catch.hpp>

#include <map>
#include <vector>

namespace Carried_anchors_test {

namespace {

namespace T = CGAL::T_splines;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Surface_mesh::Face_index;
using Rational = CGAL::Exact_rational;
using Pieces = std::vector<T::T_mesh_piece<Surface_mesh, Rational>>;
using Similarity = T::Similarity_2<Rational>;
template <typename FT>
using Mesh = test_t_meshes::T_mesh<Surface_mesh, FT>;

// Each face is a triangle of the surface, in a frame of its own.
template <typename FT>
T::Carried_anchors<Surface_mesh, Surface_mesh, FT> anchored(const Surface_mesh& graph)
{
  std::map<Face, T::T_mesh_anchor<Surface_mesh, FT>> anchors;
  for (const Face f : graph.faces())
    anchors[f] = {f, T::Similarity_2<FT>(1, FT(2), FT(3), FT(-1))};
  return {graph, boost::make_assoc_property_map(anchors)};
}

} // namespace

TEST_CASE("Each component has one root", "[Carried_anchors]")
{
  const Mesh<Rational> cube(test_t_meshes::cube<Rational>());
  CHECK(anchored<Rational>(cube.mesh).roots().size() == 1);
  test_t_meshes::Faces<Rational> two = test_t_meshes::torus<Rational>(1, 1);
  for (auto face : test_t_meshes::torus<Rational>(1, 1)) {
    for (auto& h : face)
      h.edge += 100;
    two.push_back(face);
  }
  const Mesh<Rational> tori(two);
  CHECK(anchored<Rational>(tori.mesh).roots().size() == 2);
}

TEMPLATE_TEST_CASE(
    "A root is the same point of its triangle's chart wherever the faces go, at a corner and after round-off",
    "[Carried_anchors]", Rational, double)
{
  using FT = TestType;
  const Mesh<Rational> torus(test_t_meshes::torus<Rational>(1, 1));
  const auto roots = anchored<FT>(torus.mesh);
  const auto chart_point = [&] {
    const auto& root = roots.roots().front();
    return root.anchor.to_face.inverse()(root.place.u, root.place.v);
  };
  const auto given = chart_point();
  const Face a = torus.face_list[0], b(1);
  // Seven tenths, times 3, are less than 2.1 in doubles: the corner misses the face.
  const Rational u = Rational(7) / 10;
  roots.faces_replaced(Pieces{{a, b, Similarity(0, 1, u, u), 2, 2}});
  CHECK(roots.roots().front().place.face == b);
  roots.faces_replaced(Pieces{{b, a, Similarity(0, 3, Rational(-3 * u), Rational(-3 * u)), 3, 3}});
  const auto& place = roots.roots().front().place;
  CHECK(place.face == a);
  CHECK(place.u == FT(0));
  CHECK(place.v == FT(0));
  CHECK(CGAL::to_double(FT(chart_point().first - given.first)) == Approx(0).margin(1e-14));
  CHECK(CGAL::to_double(FT(chart_point().second - given.second)) == Approx(0).margin(1e-14));
}

} // namespace Carried_anchors_test
