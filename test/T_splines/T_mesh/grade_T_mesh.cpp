// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/grade_T_mesh.h>

#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace grade_T_mesh_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using CGAL::T_splines::grade_T_mesh;
using test_t_meshes::Faces;

// The largest quotient of the longer sides of two faces with a common edge, in the units of the edge.
template <typename Mesh>
double largest_ratio(Mesh& t)
{
  const CGAL::T_splines::T_mesh_coordinates coordinates(t);
  const auto size = [&](const auto f) {
    return std::max(CGAL::to_double(coordinates.width(f)), CGAL::to_double(coordinates.height(f)));
  };
  double result = 1;
  for (const auto h : halfedges(t.mesh)) {
    const auto o = opposite(h, t.mesh);
    if (is_border(h, t.mesh) || is_border(o, t.mesh))
      continue;
    const double unit = CGAL::to_double(get(t.knots(), h)) / CGAL::to_double(get(t.knots(), o));
    result = std::max(result, size(face(h, t.mesh)) / (size(face(o, t.mesh)) * unit));
  }
  return result;
}

// Divides the first face again and again at its origin.
template <typename Mesh>
void make_uneven(Mesh& t, const int times)
{
  CGAL::T_splines::T_mesh_editor editor(t);
  using FT = typename Mesh::FT;
  const auto f = t.face_list.front();
  for (int i = 0; i < times; ++i) {
    editor.split_face(f, 0, FT(editor.coordinates().width(f) / FT(2)));
    editor.split_face(f, 1, FT(editor.coordinates().height(f) / FT(2)));
  }
}

} // namespace

TEMPLATE_TEST_CASE("sizes change gradually after grading", "[grade_T_mesh]", (std::tuple<Surface_mesh, Rational>),
                   (std::tuple<Surface_mesh, double>), (std::tuple<Polyhedron, Rational>))
{
  using FT = typename std::tuple_element<1, TestType>::type;
  using Mesh = test_t_meshes::T_mesh<typename std::tuple_element<0, TestType>::type, FT>;
  for (const Faces<FT>& faces_given :
       {test_t_meshes::cube<FT>(), test_t_meshes::torus<FT>(2, 2), test_t_meshes::genus_two<FT>(),
        test_t_meshes::pinwheel<FT>(FT(3) / FT(2)), test_t_meshes::cylinder<FT>(3, 2)}) {
    for (const double ratio : {3., 6.}) {
      Mesh t(faces_given);
      make_uneven(t, 8);
      const std::size_t before = num_faces(t.mesh);
      REQUIRE(largest_ratio(t) > 50);
      const std::size_t splits = grade_T_mesh(t, ratio).splits;
      CHECK(num_faces(t.mesh) == before + splits);
      CHECK(largest_ratio(t) <= ratio * (1 + 1e-9));
      CHECK(CGAL::T_splines::check_admissibility(t));
      CHECK(splits < 200); // some faces for each of the eight sizes
      CHECK(grade_T_mesh(t, ratio).splits == 0);
    }
  }
}

TEST_CASE("a graded T-mesh is not changed", "[grade_T_mesh]")
{
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::torus<Rational>(4, 3));
  const auto report = grade_T_mesh(t, 3);
  CHECK(report.success());
  CHECK(report.splits == 0);
  CHECK(describe(report) == "the sizes of the faces change gradually (0 splits)");
}

TEST_CASE("a T-mesh that was graded can be made spline compatible again", "[grade_T_mesh]")
{
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::cube<Rational>());
  make_uneven(t, 6);
  REQUIRE(CGAL::T_splines::make_spline_compatible(t));
  REQUIRE(CGAL::T_splines::check_spline_compatibility(t));
  REQUIRE(grade_T_mesh(t, 4).splits > 0);
  CHECK(CGAL::T_splines::make_spline_compatible(t));
  CHECK(CGAL::T_splines::check_spline_compatibility(t));
}

} // namespace grade_T_mesh_test
