// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>

#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>

#include "T_mesh/Development.h"
#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace T_mesh_editor_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using Status = CGAL::T_splines::T_mesh_edit_status;

// A T-mesh of the catalogue with everything that watches its changes.
template <typename TMesh, typename FT>
class Scene {
public:
  using Mesh = test_t_meshes::T_mesh<TMesh, FT>;
  using Development = test_t_meshes::Development<TMesh, FT>;
  using Samples = CGAL::T_splines::Carried_samples<TMesh, test_t_meshes::Developed_sample<TMesh, FT>>;
  using Observer = CGAL::T_splines::T_mesh_observer_pair<typename Development::Observer, typename Samples::Observer>;
  using Editor = CGAL::T_splines::T_mesh_editor<CGAL::T_splines::T_mesh_view_of<Mesh>, Observer>;
  using Similarity = CGAL::T_splines::Similarity_2<FT>;

  explicit Scene(const test_t_meshes::Faces<FT>& faces)
    : mesh(faces),
      editor(mesh, Observer(development.observer(), samples.observer()))
  {
  }

  // Square number i has the unit i + 1.
  void develop_squares()
  {
    for (std::size_t i = 0; i < mesh.face_list.size(); ++i)
      development.set(mesh.face_list[i], Similarity(0, FT(1) / FT(static_cast<int>(i) + 1), FT(0), FT(0)));
  }

  void develop_pinwheel(const FT& c)
  {
    for (int i = 0; i < 4; ++i)
      development.set(mesh.face_list[i], compose(Similarity(i, 1, 0, 0), Similarity(0, 1, FT(-c), FT(-c))));
  }

  void add_samples(const int n)
  {
    for (const auto f : faces(mesh.mesh)) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const FT u = editor.coordinates().width(f) * FT(i) / FT(n),
                   v = editor.coordinates().height(f) * FT(j) / FT(n);
          samples.push_back({{f, u, v}, development.of(f)(u, v)});
        }
      }
    }
  }

  template <typename Group>
  bool samples_stay(const Group& group) const
  {
    return test_t_meshes::samples_stay(samples, editor.coordinates(), development, group);
  }

  std::map<int, int> extraordinary_vertices()
  {
    std::map<int, int> result;
    for (const auto v : vertices(mesh.mesh)) {
      if (CGAL::T_splines::is_extraordinary(v, mesh))
        ++result[CGAL::T_splines::extended_valence(v, mesh)];
    }
    return result;
  }

  int euler_characteristic() const
  {
    int v = 0, h = 0, f = 0;
    for (const auto x : vertices(mesh.mesh))
      v += x != boost::graph_traits<TMesh>::null_vertex();
    for (const auto x : halfedges(mesh.mesh))
      h += x != boost::graph_traits<TMesh>::null_halfedge();
    for (const auto x : faces(mesh.mesh))
      f += x != boost::graph_traits<TMesh>::null_face();
    return v - h / 2 + f;
  }

  Mesh mesh;
  Development development;
  Samples samples;
  Editor editor;
};

// A multiple of a power of two, between a and b: numbers stay short so.
Rational number_between(const Rational& a, const Rational& b, CGAL::Random& random)
{
  const int exponent = std::ilogb(CGAL::to_double(Rational(b - a))) - 4;
  const Rational unit =
      exponent < 0 ? Rational(1) / Rational(std::ldexp(1., -exponent)) : Rational(std::ldexp(1., exponent));
  const double first = std::floor(CGAL::to_double(Rational(a / unit)));
  return unit * Rational(first + random.get_int(1, 16));
}

double number_between(const double a, const double b, CGAL::Random& random)
{
  return a + (b - a) * random.get_int(1, 16) / 16;
}

// Executes one random operation; returns whether it was done.
template <typename Scene>
bool edit_randomly(Scene& scene, const std::size_t large, CGAL::Random& random, std::map<int, int>& done)
{
  using FT = typename Scene::Editor::FT;
  auto& editor = scene.editor;
  const auto& mesh = scene.mesh.mesh;
  const auto range = halfedges(mesh);
  const std::vector<typename Scene::Editor::halfedge_descriptor> list(range.begin(), range.end());
  const auto h = list[random.get_int(0, static_cast<int>(list.size()))];
  const auto f = face(h, mesh);
  if (f == Scene::Mesh::Traits::null_face())
    return false;
  const int operation = random.get_int(0, 7);
  if (list.size() > (operation == 0 ? large : operation == 1 ? 2 * large : list.size()))
    return false;
  const FT zero(0);
  bool result = false;
  switch (operation) {
  case 0: {
    const int axis = random.get_int(0, 2);
    const FT size = axis == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
    result = bool(editor.split_face(f, axis, number_between(zero, size, random)));
    break;
  }
  case 1: result = bool(editor.extend(h)); break;
  case 2: result = bool(editor.remove_edge(h)); break;
  case 3: result = bool(editor.flip_edge(h)); break;
  case 4: {
    if (face(opposite(h, mesh), mesh) == Scene::Mesh::Traits::null_face())
      break;
    const auto overlap = editor.overlap(h);
    const FT length = overlap.end - overlap.begin;
    const FT from = random.get_bool() ? zero : number_between(zero, length, random);
    const FT to = random.get_bool() ? length : number_between(zero, length, random);
    result = bool(editor.remove_partly(h, from, to));
    break;
  }
  case 5: {
    const FT knot = get(scene.mesh.knots(), h);
    result = bool(editor.shift(h, number_between(FT(-knot), knot, random)));
    break;
  }
  default: result = bool(editor.remove_vertex(h));
  }
  done[operation] += result;
  return result;
}

template <typename Scene>
bool is_admissible_where_touched(Scene& scene)
{
  const CGAL::T_splines::internal::Admissibility_check<CGAL::T_splines::T_mesh_view_of<typename Scene::Mesh>> check(
      scene.mesh, 1e-9);
  CGAL::T_splines::Admissibility_report<typename Scene::Mesh::Graph> report;
  for (const auto f : scene.development.touched()) {
    bool result = check.check_face(f, report);
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, scene.mesh.mesh), scene.mesh.mesh))
      result = result && check.check_vertex(target(h, scene.mesh.mesh), report);
    if (!result)
      return false;
  }
  return true;
}

// All that an operation may change.
template <typename Scene>
auto state(Scene& scene)
{
  using FT = typename Scene::Editor::FT;
  using Editor = typename Scene::Editor;
  const auto& mesh = scene.mesh.mesh;
  std::vector<std::tuple<typename Editor::halfedge_descriptor, typename Editor::halfedge_descriptor,
                         typename Editor::vertex_descriptor, typename Editor::face_descriptor, FT, bool>>
      result;
  for (const auto h : halfedges(mesh)) {
    const bool has_face = face(h, mesh) != Scene::Mesh::Traits::null_face();
    result.emplace_back(h, next(h, mesh), target(h, mesh), face(h, mesh), has_face ? get(scene.mesh.knots(), h) : FT(0),
                        has_face && get(scene.mesh.corners(), h));
  }
  return result;
}

// Random operations: whatever happens, the knots stay admissible and the surface the same.
template <typename Scene, typename Group>
void edit_and_check(Scene& scene, const Group& group, const bool has_area, const int operations, const int seed)
{
  scene.add_samples(4);
  const auto cones = scene.extraordinary_vertices();
  const int euler_characteristic = scene.euler_characteristic();
  const auto area = scene.development.area(scene.editor.coordinates());
  REQUIRE(scene.development.is_consistent(scene.editor.coordinates(), group));
  CGAL::Random random(seed);
  std::map<int, int> done;
  for (int i = 1; i <= operations; ++i) {
    const bool compares = i % 50 == 0;
    const auto before = compares ? state(scene) : decltype(state(scene))();
    if (edit_randomly(scene, 160, random, done))
      REQUIRE(is_admissible_where_touched(scene));
    else if (compares)
      REQUIRE(bool(state(scene) == before));
    if (i % 100 != 0)
      continue;
    REQUIRE(CGAL::T_splines::check_admissibility(scene.mesh));
    REQUIRE(scene.extraordinary_vertices() == cones);
    REQUIRE(scene.euler_characteristic() == euler_characteristic);
    REQUIRE(scene.development.is_consistent(scene.editor.coordinates(), group));
    REQUIRE(scene.samples_stay(group));
    if (has_area)
      REQUIRE(scene.development.area(scene.editor.coordinates()) == area);
  }
  for (int operation = 0; operation < 6; ++operation) {
    INFO("operation " << operation);
    CHECK(done[operation] > 0);
  }
}

} // namespace

TEMPLATE_TEST_CASE("random operations in exact arithmetic keep the surface", "[T_mesh_editor]", Surface_mesh,
                   Polyhedron)
{
  using Exact_scene = Scene<TestType, Rational>;
  const test_t_meshes::Lattice_group lattice;
  const int many = std::is_same<TestType, Surface_mesh>::value ? 10000 : 1000, fewer = many / 5;
  const auto check_squares = [&](const test_t_meshes::Faces<Rational>& faces, const int operations, const int seed) {
    Exact_scene scene(faces);
    scene.develop_squares();
    edit_and_check(scene, lattice, true, operations, seed);
  };
  SECTION("on a cube")
  {
    check_squares(test_t_meshes::cube<Rational>(), many, 1);
  }
  SECTION("on a torus")
  {
    check_squares(test_t_meshes::torus<Rational>(3, 2), fewer, 2);
  }
  SECTION("on a torus of one face")
  {
    check_squares(test_t_meshes::torus<Rational>(1, 1), fewer, 3);
  }
  SECTION("on a folded square")
  {
    check_squares(test_t_meshes::folded_square<Rational>(), fewer, 4);
  }
  SECTION("on a pillow")
  {
    check_squares(test_t_meshes::pillow<Rational>(), fewer, 5);
  }
  SECTION("on a surface of genus two")
  {
    check_squares(test_t_meshes::genus_two<Rational>(), fewer, 6);
  }
  SECTION("on a rectangle with a border")
  {
    check_squares(test_t_meshes::rectangle<Rational>(3, 2), fewer, 7);
  }
  SECTION("on a torus with spiralling lines")
  {
    const Rational c = Rational(3) / 2;
    Exact_scene scene(test_t_meshes::pinwheel(c));
    scene.develop_pinwheel(c);
    edit_and_check(scene, test_t_meshes::Scaling_group<Rational>{c}, false, many, 8);
  }
}

TEMPLATE_TEST_CASE("random operations with rounded knots keep them admissible", "[T_mesh_editor]", Surface_mesh,
                   Polyhedron)
{
  const std::vector<test_t_meshes::Faces<double>> surfaces{
      test_t_meshes::cube<double>(), test_t_meshes::genus_two<double>(), test_t_meshes::rectangle<double>(3, 2),
      test_t_meshes::pinwheel<double>(1.3)};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    INFO("surface " << i);
    Scene<TestType, double> scene(surfaces[i]);
    scene.develop_squares(); // not used, but each face needs some frame
    const auto cones = scene.extraordinary_vertices();
    CGAL::Random random(static_cast<int>(i));
    std::map<int, int> done;
    for (int k = 0; k < 2000; ++k) {
      edit_randomly(scene, 160, random, done);
      if (k % 100 == 0)
        REQUIRE(CGAL::T_splines::check_admissibility(scene.mesh));
    }
    CHECK(scene.extraordinary_vertices() == cones);
  }
}

namespace {

template <typename FT>
using Simple_editor =
    CGAL::T_splines::T_mesh_editor<CGAL::T_splines::T_mesh_view_of<test_t_meshes::T_mesh<Surface_mesh, FT>>>;

// One face above two, which meet at x; all of height 1/2.
template <typename FT>
test_t_meshes::Faces<FT> t_joint(const FT& x)
{
  const FT one(1), half = one / FT(2);
  return {{{0, x, false}, {1, FT(one - x), true}, {2, half, true}, {3, one, true}, {4, half, true}},
          {{5, x, true}, {6, half, true}, {0, x, true}, {7, half, true}},
          {{8, FT(one - x), true}, {9, half, true}, {1, FT(one - x), true}, {6, half, true}}};
}

} // namespace

TEST_CASE("an edge that is a full side of two faces is removed", "[T_mesh_editor]")
{
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::rectangle<Rational>(2, 1));
  Simple_editor<Rational> editor(t);
  SECTION("the left face keeps its frame")
  {
    const auto h = t.halfedge_of(0, 1);
    CHECK(editor.can_remove(h) == Status::DONE);
    REQUIRE(editor.remove_edge(h));
    CHECK(editor.coordinates().width(t.face_list[0]) == 2);
    CHECK(editor.coordinates().height(t.face_list[0]) == 1);
  }
  SECTION("the units are those of the face of the halfedge")
  {
    REQUIRE(editor.remove_edge(t.halfedge_of(1, 3)));
    CHECK(editor.coordinates().width(t.face_list[1]) == 4);
    CHECK(editor.coordinates().height(t.face_list[1]) == 2);
  }
  CHECK(t.mesh.number_of_faces() == 1);
  CHECK(t.mesh.number_of_vertices() == 4); // the ends of the edge vanished
}

TEST_CASE("a flip inserts an orthogonal edge", "[T_mesh_editor]")
{
  const Rational x = Rational(2) / 5;
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(t_joint(x));
  Simple_editor<Rational> editor(t);
  const auto h = t.halfedge_of(1, 2);
  CHECK(editor.can_remove(h) == Status::NOT_A_FULL_SIDE);
  CHECK(editor.remove_edge(h).status == Status::NOT_A_FULL_SIDE);
  const auto edit = editor.flip_edge(h);
  REQUIRE(edit);
  const auto f = face(edit.halfedge, t.mesh);
  CHECK(f == t.face_list[1]);
  CHECK(editor.coordinates().width(f) == x);
  CHECK(editor.coordinates().height(f) == 1);
  CHECK(t.mesh.number_of_faces() == 3);
  CHECK(CGAL::T_splines::check_admissibility(t));
}

TEST_CASE("between cones only the middle of an edge can be removed", "[T_mesh_editor]")
{
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::cube<Rational>());
  Simple_editor<Rational> editor(t);
  const auto h = t.halfedge_of(0, 0);
  CHECK(editor.can_remove(h) == Status::FIXED_VERTEX);
  CHECK(editor.flip_edge(h).status == Status::FIXED_VERTEX);
  CHECK(editor.remove_partly(h, 0, Rational(1) / 2).status == Status::FIXED_VERTEX);
  CHECK(editor.remove_partly(h, Rational(1) / 2, 1).status == Status::FIXED_VERTEX);
  CHECK(editor.remove_partly(h, Rational(1) / 2, Rational(1) / 4).status == Status::OUTSIDE);
  CHECK(editor.remove_partly(h, Rational(-1) / 2, Rational(1) / 4).status == Status::OUTSIDE);
  CHECK(editor.remove_partly(h, Rational(1) / 2, 2).status == Status::OUTSIDE);
  CHECK(t.mesh.number_of_faces() == 6);
  const auto edit = editor.remove_partly(h, Rational(1) / 4, Rational(3) / 4);
  REQUIRE(edit);
  CHECK(t.mesh.number_of_faces() == 9); // two faces became three each, two of these one
  CHECK(CGAL::T_splines::check_admissibility(t));
  const auto f = face(edit.halfedge, t.mesh);
  CHECK(editor.coordinates().width(f) == Rational(1) / 2);
  CHECK(editor.coordinates().height(f) == 2);
  int cones = 0;
  for (const auto v : vertices(t.mesh)) {
    if (editor.is_fixed(v)) {
      ++cones;
      CHECK(degree(v, t.mesh) == 3);
    }
  }
  CHECK(cones == 8);
}

TEST_CASE("a T-joint is extended, an edge ends at a vertex that is there", "[T_mesh_editor]")
{
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(t_joint(Rational(Rational(1) / 3)));
  Simple_editor<Rational> editor(t);
  CHECK(editor.extend(t.halfedge_of(0, 2)).status == Status::NO_T_JOINT);
  CHECK(editor.extend(opposite(t.halfedge_of(0, 2), t.mesh)).status == Status::NO_FACE);
  const auto vertices_before = t.mesh.number_of_vertices();
  const auto edit = editor.extend(t.halfedge_of(0, 0));
  REQUIRE(edit);
  CHECK(t.mesh.number_of_vertices() == vertices_before + 1);
  CHECK(editor.coordinates().width(face(edit.halfedge, t.mesh)) == Rational(1) / 3);
  // The same line in the lower face would have met the T-joint: the upper face is cut from below now.
  REQUIRE(editor.remove_edge(edit.halfedge));
  CHECK(t.mesh.number_of_vertices() == vertices_before);
  REQUIRE(editor.split_face(t.face_list[0], 0, Rational(1) / 3));
  CHECK(t.mesh.number_of_vertices() == vertices_before + 1);
}

TEST_CASE("lines outside of a face are refused", "[T_mesh_editor]")
{
  test_t_meshes::T_mesh<Surface_mesh, double> t(test_t_meshes::torus<double>(1, 1));
  Simple_editor<double> editor(t);
  for (const double x : {0., 1., -1., 2., 1e-14, 1 - 1e-14, std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity()}) {
    CHECK(editor.split_face(t.face_list[0], 0, x).status == Status::OUTSIDE);
    CHECK(editor.insert_vertex(t.halfedge_of(0, 0), x).status == Status::OUTSIDE);
  }
  CHECK(editor.can_remove(t.halfedge_of(0, 0)) == Status::SAME_FACE);
  CHECK(editor.flip_edge(t.halfedge_of(0, 0)).status == Status::SAME_FACE);
  CHECK(editor.remove_vertex(t.halfedge_of(0, 0)).status == Status::NOT_REMOVABLE);
  CHECK(t.mesh.number_of_halfedges() == 4);
}

TEST_CASE("lines are shifted between their neighbours", "[T_mesh_editor]")
{
  SECTION("closed ones")
  {
    test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::torus<Rational>(3, 1));
    Simple_editor<Rational> editor(t);
    // Behind the row one comes back shifted by a column, so that all vertical edges are one line of length three.
    CHECK(editor.shift(t.halfedge_of(0, 0), 1).status == Status::OUTSIDE);
    REQUIRE(editor.shift(t.halfedge_of(0, 0), Rational(1) / 4));
    CHECK(editor.coordinates().height(t.face_list[0]) == 1); // the line is above and below
    CHECK(CGAL::T_splines::check_admissibility(t));
  }
  SECTION("between T-joints")
  {
    test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::rectangle<Rational>(1, 3));
    Simple_editor<Rational> editor(t);
    const auto cut = editor.split_face(t.face_list[1], 0, 1);
    REQUIRE(cut);
    CHECK(editor.shift(cut.halfedge, 1).status == Status::OUTSIDE);
    CHECK(editor.shift(cut.halfedge, -1).status == Status::OUTSIDE);
    REQUIRE(editor.shift(cut.halfedge, Rational(1) / 2));
    CHECK(editor.coordinates().width(t.face_list[1]) == Rational(3) / 2);
    CHECK(editor.coordinates().width(face(opposite(cut.halfedge, t.mesh), t.mesh)) == Rational(1) / 2);
    CHECK(get(t.knots(), opposite(t.halfedge_of(1, 0), t.mesh)) == Rational(3) / 4); // a unit of 1 instead of 2
    CHECK(CGAL::T_splines::check_admissibility(t));
  }
  SECTION("not those that are held")
  {
    test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::rectangle<Rational>(2, 1));
    Simple_editor<Rational> editor(t);
    CHECK(editor.shift(t.halfedge_of(0, 1), Rational(1) / 4).status == Status::NO_FREE_LINE);
    CHECK(editor.shift(t.halfedge_of(0, 0), Rational(1) / 4).status == Status::NO_FACE);
    test_t_meshes::T_mesh<Surface_mesh, Rational> cube(test_t_meshes::cube<Rational>());
    Simple_editor<Rational> cube_editor(cube);
    CHECK(cube_editor.shift(cube.halfedge_of(0, 0), Rational(1) / 4).status == Status::FIXED_VERTEX);
  }
}

TEST_CASE("constrained edges stay where they are, and their parts are constrained", "[T_mesh_editor]")
{
  using T_mesh = CGAL::T_splines::T_mesh<Kernel::Point_3, Rational>;
  const test_t_meshes::T_mesh<Surface_mesh, Rational> given(test_t_meshes::rectangle<Rational>(3, 3));
  T_mesh t;
  REQUIRE(CGAL::T_splines::copy_T_mesh(given, t));
  T_mesh::Graph& graph = t.graph();
  CGAL::T_splines::T_mesh_editor editor(t);
  const auto side = [&](const int f, const int i) {
    return editor.coordinates().first_of_side(T_mesh::face_descriptor(static_cast<unsigned>(f)), i);
  };
  const auto number_of_creases = [&] {
    int number = 0;
    for (const auto e : graph.edges())
      number += get(t.creases(), e);
    return number;
  };
  // From a vertex inside to the border: the lower sides of the last two squares of the middle row.
  for (const int f : {4, 5})
    put(t.creases(), graph.edge(side(f, 0)), true);
  CHECK(editor.is_fixed(graph.source(side(4, 0))));
  CHECK_FALSE(editor.is_fixed(graph.target(side(4, 0))));
  for (const int f : {4, 5}) {
    CHECK(editor.can_remove(side(f, 0)) == Status::CREASE);
    CHECK(editor.remove_edge(side(f, 0)).status == Status::CREASE);
    CHECK(editor.flip_edge(side(f, 0)).status == Status::CREASE);
    CHECK(editor.shift(side(f, 0), Rational(1) / 4).status == Status::CREASE);
  }
  CHECK(editor.remove_edge(side(4, 3)).status == Status::FIXED_VERTEX); // it meets the end of the line
  SECTION("a vertex in one of them")
  {
    const auto h = side(5, 0);
    const auto edit = editor.insert_vertex(h, Rational(1));
    REQUIRE(edit);
    CHECK(number_of_creases() == 3);
    CHECK(get(t.creases(), graph.edge(edit.halfedge)));
    CHECK(get(t.creases(), graph.edge(h)));
    REQUIRE(editor.remove_vertex(edit.halfedge));
    CHECK(number_of_creases() == 2);
  }
  SECTION("lines that end on them are removed, and they are joined")
  {
    REQUIRE(editor.remove_edge(side(4, 1)));
    CHECK(number_of_creases() == 2);
    REQUIRE(editor.remove_edge(side(1, 1)));
    CHECK(number_of_creases() == 1);
    CHECK(CGAL::T_splines::check_admissibility(t));
  }
  SECTION("new edges are not constrained")
  {
    REQUIRE(editor.split_face(T_mesh::face_descriptor(4), 0, Rational(1)));
    CHECK(number_of_creases() == 3); // one is cut in two
    REQUIRE(editor.split_face(T_mesh::face_descriptor(4), 1, Rational(1)));
    CHECK(number_of_creases() == 3);
  }
}

TEST_CASE("a vertex is inserted into an edge and removed again", "[T_mesh_editor]")
{
  test_t_meshes::T_mesh<Surface_mesh, Rational> t(test_t_meshes::cube<Rational>());
  Simple_editor<Rational> editor(t);
  const auto h = t.halfedge_of(1, 2);
  const auto edit = editor.insert_vertex(h, Rational(1) / 2);
  REQUIRE(edit);
  CHECK(next(edit.halfedge, t.mesh) == h);
  CHECK(get(t.knots(), edit.halfedge) == Rational(1) / 2);
  CHECK(get(t.knots(), h) == Rational(3) / 2);
  CHECK(CGAL::T_splines::check_admissibility(t));
  CHECK(editor.remove_vertex(h).status == Status::FIXED_VERTEX);
  REQUIRE(editor.remove_vertex(edit.halfedge));
  CHECK(get(t.knots(), edit.halfedge) == 2);
  CHECK(t.mesh.number_of_halfedges() == 24);
}

} // namespace T_mesh_editor_test
