// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <catch2/catch.hpp>

#include <type_traits>
#include <utility>

namespace T_mesh_test {

namespace {

namespace T = CGAL::T_splines;
using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;
using Exact_t_mesh = T::T_mesh<Kernel::Point_3, Rational>;

// Rectangles with T-joints, and units that differ.
Exact_t_mesh pinwheel()
{
  const test_t_meshes::T_mesh<Surface_mesh, Rational> given(test_t_meshes::pinwheel<Rational>(Rational(3, 2)));
  Exact_t_mesh result;
  T::copy_T_mesh(given, result);
  return result;
}

// Whether all is the same, element by element.
template <typename OneTMesh, typename OtherTMesh>
bool are_equal(const OneTMesh& one, const OtherTMesh& other)
{
  const T::internal::Mesh_indexing<typename OneTMesh::Graph> a(one.graph());
  const T::internal::Mesh_indexing<typename OtherTMesh::Graph> b(other.graph());
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_halfedges() != b.number_of_halfedges() ||
      a.number_of_faces() != b.number_of_faces())
    return false;
  for (int i = 0; i < a.number_of_halfedges(); ++i) {
    const auto g = a.halfedge(i);
    const auto h = b.halfedge(i);
    const auto f = face(g, one.graph());
    const bool is_border = f == boost::graph_traits<typename OneTMesh::Graph>::null_face();
    if (a.halfedge_index(next(g, one.graph())) != b.halfedge_index(next(h, other.graph())) ||
        a.vertex_index(target(g, one.graph())) != b.vertex_index(target(h, other.graph())) ||
        is_border != (face(h, other.graph()) == boost::graph_traits<typename OtherTMesh::Graph>::null_face()))
      return false;
    if (!is_border && (a.face_index(f) != b.face_index(face(h, other.graph())) ||
                       CGAL::to_double(get(one.knots(), g)) != CGAL::to_double(get(other.knots(), h)) ||
                       bool(get(one.corners(), g)) != bool(get(other.corners(), h))))
      return false;
  }
  for (int f = 0; f < a.number_of_faces(); ++f)
    if (a.halfedge_index(halfedge(a.face(f), one.graph())) != b.halfedge_index(halfedge(b.face(f), other.graph())))
      return false;
  return true;
}

} // namespace

TEST_CASE("copies of a T-mesh have their own graph, knots and corners", "[T_mesh]")
{
  const Exact_t_mesh original = pinwheel();
  REQUIRE(original.graph().number_of_faces() > 0);
  REQUIRE(T::check_admissibility(original));
  Exact_t_mesh copy = original, assigned;
  assigned = original;
  CHECK(are_equal(original, copy));
  CHECK(are_equal(original, assigned));

  const auto f = *copy.graph().faces().begin();
  T::T_mesh_editor editor(copy);
  REQUIRE(editor.split_face(f, 0, Rational(editor.coordinates().width(f) / 2)));
  CHECK_FALSE(are_equal(original, copy));
  CHECK(are_equal(original, assigned));
  CHECK(T::check_admissibility(copy));
  const auto h = *assigned.graph().halfedges().begin();
  put(assigned.knots(), h, Rational(2 * get(assigned.knots(), h)));
  CHECK_FALSE(T::check_admissibility(assigned));
  CHECK(T::check_admissibility(original));

  copy = Exact_t_mesh();
  CHECK(copy.graph().number_of_vertices() == 0);
  const Exact_t_mesh moved = std::move(assigned);
  CHECK_FALSE(T::check_admissibility(moved));
}

TEMPLATE_TEST_CASE("a T-mesh is copied into any graph, and its knots into other numbers", "[T_mesh]", Surface_mesh,
                   Polyhedron, Cell_complex)
{
  using test_t_meshes::T_mesh;
  for (const auto& faces : {test_t_meshes::pinwheel<Rational>(Rational(3, 2)), test_t_meshes::rectangle<Rational>(3, 2),
                            test_t_meshes::genus_two<Rational>()}) {
    const T_mesh<Surface_mesh, Rational> original(faces);
    T_mesh<TestType, double> rounded({});
    T_mesh<TestType, Rational> exact({});
    T::copy_T_mesh(original, rounded);
    T::copy_T_mesh(original, exact);
    CHECK(are_equal(original, rounded));
    CHECK(are_equal(original, exact));
    CHECK(T::check_admissibility(exact));
  }
}

TEST_CASE("what is not empty receives no copy", "[T_mesh]")
{
  const Exact_t_mesh t_mesh = pinwheel();
  Exact_t_mesh copy;
  REQUIRE(T::copy_T_mesh(t_mesh, copy));
  CHECK_FALSE(T::copy_T_mesh(t_mesh, copy));
  CHECK(copy.graph().number_of_faces() == t_mesh.graph().number_of_faces());
  copy.graph().clear_without_removing_property_maps();
  copy.graph().remove_vertex(copy.graph().add_vertex());
  CHECK_FALSE(T::copy_T_mesh(t_mesh, copy)); // a removed vertex would come first again
}

TEST_CASE("copies keep constrained edges; without a map there are none", "[T_mesh]")
{
  Exact_t_mesh t_mesh = pinwheel();
  const auto marked = *t_mesh.graph().edges().begin();
  for (const auto e : t_mesh.graph().edges())
    CHECK_FALSE(get(t_mesh.creases(), e));
  put(t_mesh.creases(), marked, true);
  Exact_t_mesh copy = t_mesh, other;
  REQUIRE(T::copy_T_mesh(t_mesh, other));
  put(t_mesh.creases(), marked, false);
  int number = 0;
  for (const auto e : other.graph().edges())
    number += get(other.creases(), e);
  CHECK(number == 1);
  CHECK(get(copy.creases(), marked));

  const T::T_mesh_view view(copy.graph(), copy.knots(), copy.corners());
  view.set_crease(copy.graph().halfedge(marked), true);
  CHECK_FALSE(view.is_crease(copy.graph().halfedge(marked)));
  CHECK_FALSE(decltype(view)::has_creases);
}

TEST_CASE("a view refers to a T-mesh, and makes one of a graph and maps", "[T_mesh]")
{
  Exact_t_mesh t_mesh = pinwheel();
  const T::T_mesh_view view(t_mesh.graph(), t_mesh.knots(), t_mesh.corners(), t_mesh.creases());
  static_assert(std::is_same<std::decay_t<decltype(view)>, T::T_mesh_view_of<Exact_t_mesh>>::value, "");
  static_assert(std::is_same<decltype(std::declval<T::T_mesh_view_of<const Exact_t_mesh>>().graph()),
                             const Exact_t_mesh::Graph&>::value,
                "");
  static_assert(!std::is_constructible<T::T_mesh_view_of<Exact_t_mesh>, const Exact_t_mesh&>::value, "");
  const T::Const_T_mesh_view_of<Exact_t_mesh> constant(view);
  CHECK(&constant.graph() == &t_mesh.graph());

  const auto f = *t_mesh.graph().faces().begin();
  const auto h = halfedge(f, t_mesh.graph());
  view.set_knot(h, Rational(5, 7));
  CHECK(get(t_mesh.knots(), h) == Rational(5, 7));
  CHECK(constant.knot(h) == Rational(5, 7));
  CHECK(T::T_mesh_coordinates(constant).width(f) == T::T_mesh_coordinates(t_mesh).width(f));
  CHECK_FALSE(T::check_admissibility(view));
  view.set_corner(h, !view.is_corner(h));
  CHECK(constant.is_corner(h) == bool(get(t_mesh.corners(), h)));
}

} // namespace T_mesh_test
