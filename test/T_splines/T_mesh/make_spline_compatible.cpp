// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>

#include <CGAL/T_splines/IO/read_t_mesh.h>
#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>

#include "Spline/Spline_mesh.h"
#include "T_mesh/Development.h"
#include "Tracing/Traced_map.h"
#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace make_spline_compatible_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using Status = CGAL::T_splines::Spline_compatibility_status;
using CGAL::T_splines::check_admissibility;
using CGAL::T_splines::check_spline_compatibility;
using CGAL::T_splines::make_spline_compatible;
using test_t_meshes::Faces;

struct Numbers {
  std::size_t vertices = 0, faces = 0, edges = 0;
  std::map<int, int> cones; // valence -> how many

  int euler_characteristic() const
  {
    return static_cast<int>(vertices) - static_cast<int>(edges) + static_cast<int>(faces);
  }
};

template <typename TMesh>
Numbers numbers_of(const TMesh& t_mesh)
{
  Numbers result;
  for (const auto v : CGAL::make_range(vertices(t_mesh.graph()))) {
    ++result.vertices;
    if (CGAL::T_splines::is_extraordinary(v, t_mesh))
      ++result.cones[CGAL::T_splines::extended_valence(v, t_mesh)];
  }
  const auto e = edges(t_mesh.graph());
  const auto f = faces(t_mesh.graph());
  result.edges = std::distance(e.begin(), e.end());
  result.faces = std::distance(f.begin(), f.end());
  return result;
}

// Makes a T-mesh spline compatible and checks what must hold then.
template <typename TMesh, typename Observer = CGAL::T_splines::T_mesh_observer>
auto make_and_check(TMesh&& t_mesh, const Observer& observer = Observer())
{
  const auto before = numbers_of(t_mesh);
  const auto report = make_spline_compatible(t_mesh, CGAL::T_splines::parameters::observer(observer));
  const auto after = numbers_of(t_mesh);
  INFO(message(report.status));
  CHECK(report.success());
  CHECK(check_admissibility(t_mesh));
  CHECK(check_spline_compatibility(t_mesh));
  CHECK(after.cones == before.cones);
  CHECK(after.euler_characteristic() == before.euler_characteristic());
  CHECK(report.vertices_before == before.vertices);
  CHECK(report.vertices_after == after.vertices);
  CHECK(report.faces_before == before.faces);
  CHECK(report.faces_after == after.faces);
  CHECK(report.faces_after == report.faces_before + report.splits_for_rings + report.splits_at_border +
                                  report.splits_of_reaching_supports + report.splits_of_endless_supports);
  CHECK_FALSE(report.is_limit_reached);
  // Once more, nothing changes.
  CHECK(make_spline_compatible(t_mesh).faces_after == after.faces);
  return report;
}

template <typename FT>
std::vector<Faces<FT>> catalogue()
{
  const FT half = FT(1) / FT(2);
  return {test_t_meshes::cube<FT>(),
          test_t_meshes::torus<FT>(1, 1),
          test_t_meshes::torus<FT>(3, 2),
          test_t_meshes::genus_two<FT>(),
          test_t_meshes::pinwheel<FT>(FT(3) * half),
          test_t_meshes::pinwheel<FT>(FT(9) / FT(8)),
          test_t_meshes::rectangle<FT>(2, 1),
          test_t_meshes::rectangle<FT>(1, 7),
          test_t_meshes::cylinder<FT>(1, 1),
          test_t_meshes::cylinder<FT>(7, 2),
          test_t_meshes::star<FT>(3, 1),
          test_t_meshes::star<FT>(5, 3),
          test_t_meshes::star<FT>(9, 4),
          test_t_meshes::star_with_t_joint<FT>(3),
          test_t_meshes::star_with_t_joint<FT>(6),
          test_t_meshes::fan<FT>(3, 1),
          test_t_meshes::fan<FT>(4, 3),
          test_t_meshes::fan<FT>(8, 1)};
}

// A T-mesh of squares with samples that know where in the plane they are.
template <typename TMesh>
class Scene {
public:
  using Mesh = test_t_meshes::T_mesh<TMesh, Rational>;
  using Development = test_t_meshes::Development<TMesh, Rational>;
  using Samples = CGAL::T_splines::Carried_samples<TMesh, test_t_meshes::Developed_sample<TMesh, Rational>>;
  using Similarity = CGAL::T_splines::Similarity_2<Rational>;
  using Coordinates = CGAL::T_splines::T_mesh_coordinates<CGAL::T_splines::Const_T_mesh_view_of<Mesh>>;

  // Square number i has the unit i + 1.
  explicit Scene(const Faces<Rational>& faces) : mesh(faces)
  {
    const Coordinates coordinates(mesh);
    const int n = 7;
    for (std::size_t s = 0; s < mesh.face_list.size(); ++s) {
      const auto f = mesh.face_list[s];
      development.set(f, Similarity(0, Rational(1) / Rational(static_cast<int>(s) + 1), Rational(0), Rational(0)));
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
          const Rational u = coordinates.width(f) * i / n, v = coordinates.height(f) * j / n;
          samples.push_back({{f, u, v}, development.of(f)(u, v)});
        }
    }
  }

  auto observer()
  {
    using Observer = CGAL::T_splines::T_mesh_observer_pair<typename Development::Observer, typename Samples::Observer>;
    return Observer(development.observer(), samples.observer());
  }

  bool samples_stay() const
  {
    const Coordinates coordinates(mesh);
    const test_t_meshes::Lattice_group lattice;
    return test_t_meshes::samples_stay(samples, coordinates, development, lattice) &&
           development.is_consistent(coordinates, lattice);
  }

  Mesh mesh;
  Development development;
  Samples samples;
};

using Read_t_mesh = CGAL::T_splines::T_mesh<Surface_mesh::Point>;

// The T-mesh of a file.
Read_t_mesh read(const std::string& name)
{
  Read_t_mesh t_mesh;
  REQUIRE(CGAL::T_splines::read_t_mesh(std::string(T_SPLINES_TEST_DATA) + "/good_t_meshes/" + name, t_mesh).success());
  return t_mesh;
}

} // namespace

TEMPLATE_TEST_CASE("T-meshes become spline compatible", "[make_spline_compatible]",
                   (std::tuple<Surface_mesh, Rational>), (std::tuple<Surface_mesh, double>),
                   (std::tuple<Polyhedron, double>))
{
  using FT = typename std::tuple_element<1, TestType>::type;
  using Mesh = test_t_meshes::T_mesh<typename std::tuple_element<0, TestType>::type, FT>;
  int i = 0;
  for (const Faces<FT>& faces : catalogue<FT>()) {
    INFO("T-mesh " << i++);
    Mesh t(faces);
    make_and_check(t);
  }
}

TEST_CASE("refined T-meshes become spline compatible", "[make_spline_compatible]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  using Coordinates = CGAL::T_splines::T_mesh_coordinates<CGAL::T_splines::Const_T_mesh_view_of<Mesh>>;
  const std::size_t splits = GENERATE(1, 3, 5, 30, 100, 500);
  int i = 0;
  for (const Faces<double>& faces : catalogue<double>()) {
    INFO("T-mesh " << i++);
    Mesh t(faces);
    const Coordinates coordinates(t);
    const CGAL::T_splines::Parametric_face_size size(coordinates);
    refine_T_mesh(t, size, 0.01, CGAL::parameters::number_of_iterations(splits));
    make_and_check(t);
  }
}

TEMPLATE_TEST_CASE("T-meshes that spiral become spline compatible, by few splits", "[make_spline_compatible]", Rational,
                   double)
{
  using FT = TestType;
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, FT>;
  using Editor = CGAL::T_splines::T_mesh_editor<CGAL::T_splines::T_mesh_view_of<Mesh>>;
  CGAL::Random random(1);
  for (const FT& scale : {FT(FT(3) / FT(2)), FT(FT(9) / FT(8)), FT(4)})
    for (const bool is_turning : {false, true})
      for (const int splits : {0, 1, 2, 5, 12, 40}) {
        INFO("scale " << scale << (is_turning ? ", turning, " : ", ") << splits << " splits");
        Mesh t(is_turning ? spline_tests::turning_pinwheel<FT>(scale) : test_t_meshes::pinwheel<FT>(scale));
        Editor editor(t);
        for (int i = 0; i < splits; ++i) { // anywhere: the faces may be long and narrow
          const auto f = *std::next(faces(t.mesh).begin(), random.get_int(0, static_cast<int>(num_faces(t.mesh))));
          const int axis = random.get_int(0, 2);
          const FT size = axis == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
          editor.split_face(f, axis, FT(size * FT(random.get_int(1, 16)) / FT(16)));
        }
        const auto report = make_and_check(t);
        CHECK(report.splits_for_rings + report.splits_of_reaching_supports == 0);
        CHECK(report.splits_of_endless_supports <= 100); // faces of half their distance from the centre
      }
}

TEST_CASE("T-meshes of files become spline compatible", "[make_spline_compatible]")
{
  for (const char* name : {"torus_of_one_face.ply", "scaled_torus.ply", "cube.ply"}) {
    INFO(name);
    make_and_check(read(name));
  }
}

TEST_CASE("motorcycle graphs become spline compatible", "[make_spline_compatible]")
{
  using namespace hand_made_maps;
  int i = 0;
  using Traced = Traced_map<CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>,
                            Surface_mesh, Rational>;
  for (const Plain_map& map : {folded(net(polycube({{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}}), 2, Pattern::CROSSES)),
                               folded(net(translation_surface(), 3, Pattern::MIXED_DIAGONALS)),
                               folded(folded_triangle({{1, 0.25}}, {{0.375, 1}})),
                               folded(scaled_torus(1.5, 4, 0, 4, 4)), folded(scaled_torus(2, 5, 1, 4, 2))}) {
    INFO("surface " << i++);
    Traced traced(map);
    REQUIRE(traced.success());
    make_and_check(traced.view());
  }
}

TEMPLATE_TEST_CASE("points stay where they are on the surface", "[make_spline_compatible]", Surface_mesh, Polyhedron)
{
  for (const auto& faces : {test_t_meshes::cube<Rational>(), test_t_meshes::torus<Rational>(2, 1),
                            test_t_meshes::genus_two<Rational>(), test_t_meshes::star<Rational>(5, 1)}) {
    Scene<TestType> scene(faces);
    make_and_check(scene.mesh, scene.observer());
    CHECK(scene.samples_stay());
  }
}

TEST_CASE("no more is inserted than needed", "[make_spline_compatible]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  SECTION("nothing, where all is well")
  {
    for (const auto& faces : {test_t_meshes::torus<Rational>(4, 5), test_t_meshes::rectangle<Rational>(3, 4),
                              test_t_meshes::star<Rational>(5, 5)}) {
      Mesh t(faces);
      CHECK(make_and_check(t).faces_after == faces.size());
    }
  }
  SECTION("a rectangle needs three rows and columns")
  {
    Mesh t(test_t_meshes::rectangle<Rational>(1, 1));
    const auto report = make_and_check(t);
    CHECK(report.faces_after == 9);
    CHECK(report.splits_at_border == 8);
  }
  SECTION("on a torus, one face is enough")
  {
    Mesh t(test_t_meshes::torus<Rational>(1, 1));
    const auto report = make_and_check(t);
    CHECK(report.faces_after == 1);
  }
  SECTION("on a cube, rings meet in the middle of edges")
  {
    Mesh t(test_t_meshes::cube<Rational>());
    const auto report = make_and_check(t);
    CHECK(report.faces_after == 6 * 36);
    CHECK(report.vertices_in_rings == report.vertices_after - 6); // but for the middle of each side
    CHECK(report.extraordinary_vertices == 8);
  }
}

TEST_CASE("rings are not much smaller than the edges allow", "[make_spline_compatible]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  // Two sides of a face have the lengths 1 and x, the cone is at the corner between them.
  const double x = GENERATE(1., 1.1, 1.5, 4., 20.);
  Faces<double> faces = test_t_meshes::star<double>(5, 1);
  for (std::size_t s = 0; s < 5; ++s)
    test_t_meshes::rescale(faces[s], 1. / (s + 1.));
  for (const int side : {0, 2}) // spoke 1 is longer
    faces[1][side].knot = x;
  for (const int side : {1, 3})
    faces[0][side].knot = x;
  Mesh t(faces);
  const auto cone = source(t.halfedge_of(0, 0), t.mesh);
  make_and_check(t);
  for (const auto h : CGAL::halfedges_around_target(halfedge(cone, t.mesh), t.mesh)) {
    CHECK(get(t.knots(), h) <= 1 / 3.);
    CHECK(get(t.knots(), h) >= 0.75 / 4.5); // a border is at the ends
  }
}

TEST_CASE("rings near a border are made once, and supports that it makes longer are shortened",
          "[make_spline_compatible]")
{
  // A triangle with one cone of three quarter turns, close to one of its sides, and three corners.
  using Exact_mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  Exact_mesh triangle(
      {{{8, 73, true}, {7, 44, true}, {4, 73, true}, {17, 44, true}},
       {{12, 1584, true}, {13, 704, false}, {11, 174, true}, {3, 1584, true}, {2, 878, true}},
       {{0, 239, true}, {9, 704, true}, {14, 44, false}, {16, 73, false}, {18, 122, true}, {13, 704, true}},
       {{18, 122, true}, {19, 130, false}, {17, 44, true}, {10, 122, true}, {11, 174, true}},
       {{14, 44, true}, {6, 130, true}, {7, 44, true}, {1, 130, true}},
       {{1, 130, true}, {8, 73, true}, {19, 130, true}, {16, 73, true}}});
  REQUIRE(check_admissibility(triangle));
  const auto refinement = make_spline_compatible(triangle);
  REQUIRE(refinement);
  CHECK(refinement.extraordinary_vertices == 1);
  CHECK(refinement.splits_for_rings <= 36);
  CHECK(refinement.splits_of_reaching_supports > 0);
  CHECK(check_spline_compatibility(triangle));

  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  const int sectors = GENERATE(3, 5);
  for (const double x : {1., 0.3, 7.}) {
    Faces<double> faces = test_t_meshes::star<double>(sectors, 1);
    for (std::size_t s = 0; s < faces.size(); ++s)
      test_t_meshes::rescale(faces[s], 1. / (s + 1.));
    for (const int side : {0, 2}) // spoke 1 is longer or shorter
      faces[1][side].knot = x;
    for (const int side : {1, 3})
      faces[0][side].knot = x;
    Mesh t(faces);
    const auto report = make_spline_compatible(t);
    REQUIRE(report);
    CHECK(report.splits_for_rings <= static_cast<std::size_t>(12 * sectors)); // nine cells and the rest of each sector
    CHECK(check_spline_compatibility(t));
  }
}

TEST_CASE("cones of one or two quarter turns get rings", "[make_spline_compatible]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  for (const auto& faces : {test_t_meshes::pillow<double>(), test_t_meshes::folded_square<double>()}) {
    Mesh t(faces);
    make_and_check(t);
  }
}

TEST_CASE("what cannot be helped is left as it is", "[make_spline_compatible]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  const auto refused = [](Mesh& t) {
    const auto before = numbers_of(t);
    const auto report = make_spline_compatible(t);
    const auto expected = check_spline_compatibility(t);
    CHECK(report.status == expected.status);
    CHECK(report.vertex == expected.vertex);
    CHECK(report.face == expected.face);
    const auto after = numbers_of(t);
    CHECK(before.vertices == after.vertices);
    CHECK(before.faces == after.faces);
    return report.status;
  };
  Mesh touching(test_t_meshes::squares<double>({{0, 1, 2, 3}, {4, 5, 6, 7}}));
  test_t_meshes::join_corners_of_two_faces(touching);
  CHECK(refused(touching) == Status::TOUCHING_BORDERS);
  Mesh cube(test_t_meshes::cube<double>());
  put(cube.knots(), cube.halfedge_of(0, 0), std::numeric_limits<double>::quiet_NaN());
  CHECK(refused(cube) == Status::INADMISSIBLE);
}

TEST_CASE("the number of splits is bounded on demand", "[make_spline_compatible]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  Mesh full(test_t_meshes::cube<Rational>());
  const std::size_t needed = make_spline_compatible(full).faces_after - 6;
  for (const std::size_t limit : {std::size_t(0), std::size_t(5), needed - 1, needed}) {
    Mesh t(test_t_meshes::cube<Rational>());
    const auto report = make_spline_compatible(t, CGAL::parameters::number_of_iterations(limit));
    CHECK(report.faces_after == 6 + limit);
    CHECK(report.success() == (limit == needed));
    CHECK(report.is_limit_reached == (limit < needed));
    CHECK(check_admissibility(t));
  }
}

} // namespace make_spline_compatible_test
