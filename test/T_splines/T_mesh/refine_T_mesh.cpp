// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/refine_T_mesh.h>

#include <CGAL/T_splines/T_mesh/Carried_samples.h>
#include <CGAL/T_splines/T_mesh/Surface_face_size.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>
#include <CGAL/T_splines/T_mesh/check_admissibility.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace refine_T_mesh_test {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Rational = CGAL::Exact_rational;
using Status = CGAL::T_splines::T_mesh_refinement_status;
using CGAL::T_splines::check_admissibility;
using CGAL::T_splines::refine_T_mesh;
using test_t_meshes::Faces;

template <typename Mesh>
using Coordinates = CGAL::T_splines::T_mesh_coordinates<CGAL::T_splines::Const_T_mesh_view_of<Mesh>>;
template <typename Mesh>
using Parametric_size = CGAL::T_splines::Parametric_face_size<CGAL::T_splines::Const_T_mesh_view_of<Mesh>>;

} // namespace

TEMPLATE_TEST_CASE("faces become smaller than the target, not much smaller", "[refine_T_mesh]",
                   (std::tuple<Surface_mesh, Rational>), (std::tuple<Surface_mesh, double>),
                   (std::tuple<Polyhedron, Rational>), (std::tuple<Polyhedron, double>))
{
  using FT = typename std::tuple_element<1, TestType>::type;
  using Mesh = test_t_meshes::T_mesh<typename std::tuple_element<0, TestType>::type, FT>;
  for (const Faces<FT>& faces_given :
       {test_t_meshes::cube<FT>(), test_t_meshes::torus<FT>(1, 1), test_t_meshes::folded_square<FT>(),
        test_t_meshes::genus_two<FT>(), test_t_meshes::pinwheel<FT>(FT(3) / FT(2)),
        test_t_meshes::rectangle<FT>(3, 2)}) {
    Mesh t(faces_given);
    const std::size_t faces_before = t.face_list.size();
    const Coordinates<Mesh> coordinates(t);
    const auto report = refine_T_mesh(t, Parametric_size<Mesh>(coordinates), 0.3);
    CHECK(report.success());
    CHECK(check_admissibility(t));
    std::size_t count = 0;
    for (const auto f : faces(t.mesh)) {
      ++count;
      const double a = CGAL::to_double(coordinates.width(f)), b = CGAL::to_double(coordinates.height(f));
      CHECK((std::max)(a, b) <= 0.3);
      CHECK((std::min)(a, b) >= 0.3 / 3); // a third is what a split leaves at least
    }
    CHECK(count == faces_before + report.splits);
  }
}

TEST_CASE("a square splits evenly: no T-joints", "[refine_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  Mesh t(test_t_meshes::torus<Rational>(1, 1));
  const Coordinates<Mesh> coordinates(t);
  CHECK(refine_T_mesh(t, Parametric_size<Mesh>(coordinates), 0.125).splits == 63);
  for (const auto f : faces(t.mesh)) {
    CHECK(coordinates.width(f) == Rational(1) / 8);
    CHECK(coordinates.height(f) == Rational(1) / 8);
    CHECK(degree(f, t.mesh) == 4);
  }
}

TEST_CASE("vertices in the middle third are used, others are kept away from", "[refine_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  // One face above two, which meet at x.
  const auto split_at = [](const double x) {
    Mesh t({{{0, x, false}, {1, 1 - x, true}, {2, 0.5, true}, {3, 1., true}, {4, 0.5, true}},
            {{5, x, true}, {6, 0.5, true}, {0, x, true}, {7, 0.5, true}},
            {{8, 1 - x, true}, {9, 0.5, true}, {1, 1 - x, true}, {6, 0.5, true}}});
    const Coordinates<Mesh> coordinates(t);
    REQUIRE(check_admissibility(t));
    const auto size = [&](const Surface_mesh::Face_index f) {
      return std::make_pair(f == t.face_list[0] ? coordinates.width(f) : 0., 0.);
    };
    CHECK(refine_T_mesh(t, size, 0.9).splits == 1);
    return coordinates.width(t.face_list[0]);
  };
  CHECK(split_at(0.4) == Approx(0.4));
  CHECK(split_at(0.6) == Approx(0.6));
  CHECK(split_at(0.3) == Approx(0.5));
  CHECK(split_at(0.9) == Approx(0.5));
}

TEST_CASE("sizes on a surface, by the samples that the T-mesh carries", "[refine_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, Rational>;
  using Sample = CGAL::T_splines::T_mesh_sample<Surface_mesh, Kernel>;
  using Samples = CGAL::T_splines::Carried_samples<Surface_mesh, Sample>;
  using Size = CGAL::T_splines::Surface_face_size<CGAL::T_splines::Const_T_mesh_view_of<Mesh>, Samples>;
  // A round tube, 6 around and 10 long, glued to a torus in the parameter domain only.
  Mesh t(test_t_meshes::torus<Rational>(1, 1));
  const Coordinates<Mesh> coordinates(t);
  const int n = GENERATE(200, 40);
  Samples samples;
  const double pi = std::acos(-1.), radius = 6 / (2 * pi);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      samples.push_back({{t.face_list[0], u, v},
                         Kernel::Point_3(radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), 10 * v),
                         1});
    }
  }
  Size size(coordinates, samples);
  CHECK(size(t.face_list[0]).first == Approx(6).epsilon(0.01));
  CHECK(size(t.face_list[0]).second == Approx(10).epsilon(0.01));
  const auto report = refine_T_mesh(t, size, 0.5, CGAL::T_splines::parameters::observer(size.observer()));
  CHECK(report.success());
  for (const auto f : faces(t.mesh)) {
    CHECK(6 * CGAL::to_double(coordinates.width(f)) == Approx(0.375).epsilon(0.01));
    CHECK(10 * CGAL::to_double(coordinates.height(f)) == Approx(0.3125).epsilon(0.01));
  }

  SECTION("where the samples get sparse, the old faces tell the size")
  {
    const auto fine = refine_T_mesh(t, size, 0.05, CGAL::T_splines::parameters::observer(size.observer()));
    CHECK(fine.success());
    for (const auto f : faces(t.mesh)) {
      CHECK(6 * CGAL::to_double(coordinates.width(f)) == Approx(0.046875).epsilon(0.01));
      CHECK(10 * CGAL::to_double(coordinates.height(f)) == Approx(0.0390625).epsilon(0.01));
    }
  }
}

TEST_CASE("what cannot be refined is named", "[refine_T_mesh]")
{
  using Mesh = test_t_meshes::T_mesh<Surface_mesh, double>;
  Mesh t(test_t_meshes::cube<double>());
  const Coordinates<Mesh> coordinates(t);
  const Parametric_size<Mesh> size(coordinates);
  const auto invalid = [&](const double target) {
    return refine_T_mesh(t, size, target).status == Status::INVALID_TARGET && t.mesh.number_of_faces() == 6;
  };
  CHECK(invalid(0));
  CHECK(invalid(-1));
  CHECK(invalid(std::numeric_limits<double>::quiet_NaN()));

  const auto limited = refine_T_mesh(t, size, 0.1, CGAL::parameters::number_of_iterations(std::size_t(7)));
  CHECK(limited.status == Status::ITERATION_LIMIT);
  CHECK(limited.splits == 7);
  CHECK(t.mesh.number_of_faces() == 13);

  const auto bad = t.face_list[3];
  const auto bad_size = [&](const Surface_mesh::Face_index f) {
    return f == bad ? std::make_pair(1., std::numeric_limits<double>::quiet_NaN()) : size(f);
  };
  const auto not_finite = refine_T_mesh(t, bad_size, 0.5);
  CHECK(not_finite.status == Status::SIZE_NOT_FINITE);
  CHECK(not_finite.face == bad);
}

} // namespace refine_T_mesh_test
