// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/regularize_T_mesh.h>

#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>

#include "Spline/Planar_t_mesh.h"
#include "T_mesh/Development.h"
#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace regularize_T_mesh_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using CGAL::T_splines::check_admissibility;
using test_t_meshes::Faces;
namespace parameters = CGAL::parameters;

template <typename Mesh>
using Coordinates = CGAL::T_splines::T_mesh_coordinates<CGAL::T_splines::Const_T_mesh_view_of<Mesh>>;

template <typename Mesh>
std::vector<double> aspect_ratios(Mesh& t)
{
  const Coordinates<Mesh> coordinates(t);
  std::vector<double> result;
  for (const auto f : faces(t.mesh)) {
    const double a = CGAL::to_double(coordinates.width(f)), b = CGAL::to_double(coordinates.height(f));
    result.push_back((std::max)(a / b, b / a));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Splits random faces at random places: most become narrow.
template <typename Editor>
void split_randomly(Editor& editor, const int splits, const int seed)
{
  using FT = typename Editor::FT;
  CGAL::Random random(seed);
  for (int i = 0; i < splits; ++i) {
    const auto range = faces(editor.coordinates().t_mesh().graph());
    const std::vector<typename Editor::face_descriptor> list(range.begin(), range.end());
    const auto f = list[random.get_int(0, static_cast<int>(list.size()))];
    const int axis = random.get_int(0, 2);
    const FT size = axis == 0 ? editor.coordinates().width(f) : editor.coordinates().height(f);
    REQUIRE(editor.split_face(f, axis, FT(size * FT(random.get_int(1, 64)) / FT(64))));
  }
}

template <typename Mesh>
std::map<int, std::vector<int>> cones(Mesh& t)
{
  std::map<int, std::vector<int>> result; // extended valence -> number of edges
  for (const auto v : vertices(t.mesh)) {
    if (!CGAL::T_splines::is_extraordinary(v, t))
      continue;
    int edges = 0;
    for (const auto h : CGAL::halfedges_around_target(halfedge(v, t.mesh), t.mesh))
      edges += h != boost::graph_traits<typename Mesh::Graph>::null_halfedge();
    result[CGAL::T_splines::extended_valence(v, t)].push_back(edges);
  }
  for (auto& r : result)
    std::sort(r.second.begin(), r.second.end());
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("narrow faces disappear, cones keep their edges", "[regularize_T_mesh]",
                   (std::tuple<Surface_mesh, Rational>), (std::tuple<Surface_mesh, double>),
                   (std::tuple<Polyhedron, Rational>), (std::tuple<Polyhedron, double>))
{
  using TMesh = typename std::tuple_element<0, TestType>::type;
  using FT = typename std::tuple_element<1, TestType>::type;
  using Mesh = test_t_meshes::T_mesh<TMesh, FT>;
  using Editor = CGAL::T_splines::T_mesh_editor<CGAL::T_splines::T_mesh_view_of<Mesh>>;
  int seed = 0;
  for (const Faces<FT>& faces_given :
       {test_t_meshes::cube<FT>(), test_t_meshes::torus<FT>(3, 2), test_t_meshes::torus<FT>(1, 1),
        test_t_meshes::folded_square<FT>(), test_t_meshes::genus_two<FT>(), test_t_meshes::pinwheel<FT>(FT(3) / FT(2)),
        test_t_meshes::rectangle<FT>(3, 2)}) {
    INFO("surface " << seed);
    Mesh t(faces_given);
    Editor editor(t);
    split_randomly(editor, 60, ++seed);
    const auto cones_before = cones(t);
    const std::vector<double> before = aspect_ratios(t);
    const auto report = CGAL::T_splines::regularize_T_mesh(t);
    CHECK(check_admissibility(t));
    CHECK(cones(t) == cones_before);
    const std::vector<double> after = aspect_ratios(t);
    CHECK(report.faces_before == before.size());
    CHECK(report.faces_after == after.size());
    CHECK(report.worst_aspect_before == Approx(before.back()));
    CHECK(report.worst_aspect_after == Approx(after.back()));
    CHECK(report.median_aspect_before == Approx(before[before.size() / 2]));
    CHECK(report.median_aspect_after == Approx(after[after.size() / 2]));
    CHECK(before.back() > 50);
    CHECK(after.back() < 15);
    CHECK(after[after.size() / 2] < 3);
    CHECK(report.removals + report.flips + report.partial_removals > 0);

    // Once more makes no face worse than the worst, or than what closing a gap may cost.
    const auto again = CGAL::T_splines::regularize_T_mesh(t);
    CHECK(again.worst_aspect_after <= (std::max)(report.worst_aspect_after, 5.));
    CHECK(cones(t) == cones_before);
  }
}

TEST_CASE("samples keep their places while a T-mesh is regularized", "[regularize_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  using Development = test_t_meshes::Development<Surface_mesh, Rational>;
  using Sample = test_t_meshes::Developed_sample<Surface_mesh, Rational>;
  using Samples = CGAL::T_splines::Carried_samples<Surface_mesh, Sample>;
  using Observer = CGAL::T_splines::T_mesh_observer_pair<Development::Observer, Samples::Observer>;
  using Editor = CGAL::T_splines::T_mesh_editor<CGAL::T_splines::T_mesh_view_of<Mesh>, Observer>;
  Mesh t(test_t_meshes::cube<Rational>());
  Development development;
  Samples samples;
  for (std::size_t i = 0; i < t.face_list.size(); ++i) {
    const Rational size(static_cast<int>(i) + 1);
    development.set(t.face_list[i], {0, Rational(1) / size, 0, 0});
    for (int k = 0; k < 100; ++k) {
      const Rational u = Rational(k % 10) / 9, v = Rational(k / 10) / 9;
      samples.push_back({{t.face_list[i], u * size, v * size}, {u, v}});
    }
  }
  const Observer observer(development.observer(), samples.observer());
  Editor editor(t, observer);
  split_randomly(editor, 60, 3);
  const auto report = CGAL::T_splines::regularize_T_mesh(t, CGAL::T_splines::parameters::observer(observer));
  CHECK(report.partial_removals > 0);
  CHECK(report.flips > 0);
  const test_t_meshes::Lattice_group lattice;
  CHECK(development.is_consistent(editor.coordinates(), lattice));
  CHECK(development.area(editor.coordinates()) == 6);
  CHECK(samples_stay(samples, editor.coordinates(), development, lattice));
}

TEST_CASE("constrained vertices keep their edges, and no more is done than allowed", "[regularize_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  Mesh t(test_t_meshes::torus<double>(1, 1));
  CGAL::T_splines::T_mesh_editor editor(t);
  for (int i = 1; i < 10; ++i)
    REQUIRE(editor.split_face(t.face_list[0], 0, 1. - 0.1 * i));
  REQUIRE(t.mesh.number_of_faces() == 10);

  SECTION("constrained vertices keep their edges")
  {
    std::map<Surface_mesh::Vertex_index, bool> constrained;
    for (const auto v : vertices(t.mesh))
      constrained[v] = true;
    const std::map<Surface_mesh::Vertex_index, bool> before = constrained;
    CGAL::T_splines::regularize_T_mesh(
        t, parameters::vertex_is_constrained_map(boost::make_assoc_property_map(constrained)));
    for (const auto& v : before) {
      CHECK(t.mesh.is_valid(v.first));
      CHECK(degree(v.first, t.mesh) == 4);
    }
  }
  SECTION("no operation is allowed")
  {
    const auto report = CGAL::T_splines::regularize_T_mesh(t, parameters::number_of_iterations(std::size_t(0)));
    CHECK(report.success());
    CHECK(report.faces_after == 10);
    CHECK(report.worst_aspect_after == Approx(10));
    CHECK(describe(report) == "the T-mesh was regularized: from 10 to 10 faces, the worst aspect ratio from 10 to 10");
  }
  SECTION("without constraints")
  {
    const auto report = CGAL::T_splines::regularize_T_mesh(t);
    CHECK(report.faces_after < 5);
    CHECK(report.worst_aspect_after < 3);
  }
}

TEST_CASE("a T-mesh without faces", "[regularize_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  Mesh t{Faces<double>()};
  CHECK(CGAL::T_splines::regularize_T_mesh(t).faces_after == 0);
}

TEST_CASE("gaps between lines that end at opposite sides of a third one are closed", "[regularize_T_mesh]")
{
  // Two rows of a torus, each of two faces that are nearly squares.
  for (const double x : {4.125, 4 + 1 / 1024., 3.8125}) {
    INFO(x);
    spline_tests::Planar_t_mesh plane({0, 8}, {0, 4, 8}, true);
    plane.split(0, 0, 4);
    plane.split(1, 0, x);
    test_t_meshes::T_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>, CGAL::Exact_rational> t(
        plane.faces<CGAL::Exact_rational>());
    const auto report = CGAL::T_splines::regularize_T_mesh(t);
    CHECK(report.closed_gaps == 2); // in the middle of the torus, and at its end
    CHECK(report.worst_aspect_after < 5);
    CHECK(CGAL::T_splines::check_admissibility(t));
    const CGAL::T_splines::T_mesh_coordinates coordinates(t);
    for (const auto h : halfedges(t.mesh))
      CHECK(get(t.knots(), h) * 16 >= coordinates.side_length(h));
  }
}

TEST_CASE("lines of two vertices that face each other, and miss each other by little, are separated",
          "[regularize_T_mesh]")
{
  using Graph = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  for (const double gap : {1 / 8., 1 / 64., 1 / 4096.}) {
    INFO(gap);
    // From (16, 8) to the line at 32, from (32, 8 + gap) to the line at 16; likewise on their other sides. The line at 0 stays.
    spline_tests::Planar_t_mesh plane({0, 16, 32, 48}, {0, 16}, true);
    plane.split(0, 1, 8);
    plane.split(1, 1, 8);
    plane.split(4, 1, 8 + gap);
    plane.split(2, 1, 8 + gap);
    test_t_meshes::T_mesh<Graph, Rational> t(plane.faces<Rational>());
    std::map<Graph::Vertex_index, bool> constrained;
    for (std::size_t f = 0; f < t.face_list.size(); ++f) {
      const std::vector<spline_tests::Position> sources = plane.sources(f);
      auto h = halfedge(t.face_list[f], t.mesh);
      for (const spline_tests::Position& p : sources) {
        constrained[source(h, t.mesh)] = p[1] == 0 || (p[0] == 16 && p[1] == 8) || (p[0] == 32 && p[1] == 8 + gap);
        h = next(h, t.mesh);
      }
    }
    REQUIRE(std::count_if(constrained.begin(), constrained.end(), [](const auto& c) { return c.second; }) == 5);
    const auto report = CGAL::T_splines::regularize_T_mesh(
        t, parameters::vertex_is_constrained_map(boost::make_assoc_property_map(constrained)));
    CHECK(report.worst_aspect_after < 5);
    CHECK(CGAL::T_splines::check_admissibility(t));
    for (const auto& v : constrained)
      if (v.second)
        CHECK(degree(v.first, t.mesh) == 4);
    const CGAL::T_splines::T_mesh_coordinates coordinates(t);
    for (const auto h : halfedges(t.mesh))
      CHECK(get(t.knots(), h) * 16 >= coordinates.side_length(h));
  }
}

} // namespace regularize_T_mesh_test
