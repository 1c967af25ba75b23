// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Corner_patches.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Corners of the border that turn inwards.
namespace corners_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<Rational>;
using Patches = CGAL::T_splines::internal::Corner_patches<double>;
using Vector_3 = Kernel::Vector_3;

constexpr CGAL::T_splines::internal::Border_turn turn_of(const int quarters)
{
  using CGAL::T_splines::internal::Border_turn;
  return quarters == 3 ? Border_turn::CORNER : Border_turn::SLIT;
}

// Around the corner of the first vertex of a fan there are rings already.
constexpr int ringed = 6;

template <typename T>
typename T::vertex_descriptor corner_of(T& t)
{
  return source(t.halfedge_of(0, 0), t.mesh);
}

// The faces at corners that turn inwards.
template <typename T>
bool is_at_corner(T& t, const typename T::face_descriptor f)
{
  for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh)) {
    const auto v = target(h, t.mesh);
    if (CGAL::T_splines::is_border_vertex(v, t) && CGAL::T_splines::extended_valence(v, t) > 2)
      return true;
  }
  return false;
}

double sine(const Vector_3& a, const Vector_3& b)
{
  return std::sqrt(CGAL::cross_product(a, b).squared_length() / (a.squared_length() * b.squared_length()));
}

} // namespace

TEST_CASE("functions at a corner have the sum 1", "[corners]")
{
  using Exact_patches = CGAL::T_splines::internal::Corner_patches<Rational>;
  for (const int k : {3, 4}) {
    const Exact_patches patches(k, turn_of(k));
    REQUIRE(patches.pieces_per_side() == 1);
    for (int sector = 0; sector < k; ++sector)
      for (int i = 0; i < 16; ++i) {
        Rational sum(0);
        for (int control = 0; control < patches.number_of_controls(); ++control)
          sum += patches.coefficients(sector, 0, 0, control)[i];
        CHECK(sum == Rational(1));
      }
  }
  for (const int k : {5, 6, 9}) {
    const Patches patches(k, turn_of(k));
    for (int sector = 0; sector < k; ++sector)
      for (int i = 0; i < 64; ++i) {
        double sum = 0;
        for (int control = 0; control < patches.number_of_controls(); ++control)
          sum += patches.coefficients(sector, i / 16 % 2, i / 32, control)[i % 16];
        CHECK(std::abs(sum - 1) < 1e-14);
      }
  }
}

TEST_CASE("a plane without a quadrant is reproduced", "[corners]")
{
  // Control points at the places of the vertices: linear functions, exactly.
  using Exact_patches = CGAL::T_splines::internal::Corner_patches<Rational>;
  const int k = GENERATE(3, 4);
  const Exact_patches patches(k, turn_of(k));
  const std::array<std::array<int, 2>, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto place = [&](const int sector, const int a, const int b) {
    const auto &x = directions[sector % 4], &y = directions[(sector + 1) % 4];
    return std::array<int, 2>{a * x[0] + b * y[0], a * x[1] + b * y[1]};
  };
  std::vector<std::array<int, 2>> controls{{0, 0}};
  for (int spoke = 0; spoke <= k; ++spoke)
    for (int x = 1; x <= 2; ++x)
      controls.push_back(place(spoke, x, 0));
  for (int sector = 0; sector < k; ++sector)
    for (const auto& p : {std::array<int, 2>{1, 1}, {2, 1}, {1, 2}, {2, 2}})
      controls.push_back(place(sector, p[0], p[1]));
  for (int sector = 0; sector < k; ++sector)
    for (int i = 0; i < 16; ++i) {
      std::array<Rational, 2> sum{0, 0};
      for (int c = 0; c < patches.number_of_controls(); ++c)
        for (int axis = 0; axis < 2; ++axis)
          sum[axis] += patches.coefficients(sector, 0, 0, c)[i] * Rational(controls[c][axis]);
      const auto expected = place(sector, i % 4, i / 4);
      CHECK(Rational(3) * sum[0] == Rational(expected[0]));
      CHECK(Rational(3) * sum[1] == Rational(expected[1]));
    }
}

TEST_CASE("the surface around corners that turn inwards is smooth", "[corners]")
{
  CGAL::Random random(1);
  for (const int k : {3, 4, 5, 6, 8})
    for (const int splits : {0, 12}) {
      INFO(k << " quarters, " << splits << " splits");
      Mesh t(test_t_meshes::fan<Rational>(k, splits == 0 ? ringed : 2));
      if (splits > 0) {
        REQUIRE(t.make_spline_compatible());
        t.split_randomly(splits, random);
      }
      const auto report = t.make_spline_compatible();
      INFO(message(report.status));
      REQUIRE(report);
      t.set_random_controls(random);
      const Mesh::Surface surface = t.surface();
      REQUIRE(surface.is_valid());
      const auto compiled = CGAL::T_splines::compile_T_spline(surface);
      Jet_difference outside, at_corners, compilation;
      double angle = 0;
      int samples_at_corners = 0;
      for (const auto& piece : edge_pieces<double>(t))
        for (const double s : {0., 1e-6, 0.01, 0.3, 0.5, 0.6, 0.99, 1.}) {
          const auto p = inside(surface, piece.face, piece.at(s));
          const auto q = inside(surface, piece.opposite_face, piece.transition(p.first, p.second));
          const auto a = surface.jet(piece.face, p.first, p.second);
          const auto b = pulled_back(surface.jet(piece.opposite_face, q.first, q.second), piece.transition);
          const double size = (std::min)(surface.width(piece.face), surface.height(piece.face));
          Jet_difference d = difference(a, b, size);
          compilation.add(difference(a, compiled.jet(piece.face, p.first, p.second), size));
          if (!is_at_corner(t, piece.face) && !is_at_corner(t, piece.opposite_face)) {
            outside.add(d);
            continue;
          }
          ++samples_at_corners;
          angle = (std::max)(angle, sine(CGAL::cross_product(a.du, a.dv), CGAL::cross_product(b.du, b.dv)));
          d.second = 0;
          // The spokes of more than four quarters have a tangent plane, but not equal derivatives.
          if (k > 4 && is_at_corner(t, piece.face) && is_at_corner(t, piece.opposite_face))
            d.first = 0;
          at_corners.add(d);
        }
      CHECK(samples_at_corners > 0);
      CHECK(outside.largest() < 1e-9);
      CHECK(at_corners.largest() < 1e-9);
      CHECK(angle < 1e-7);
      CHECK(compilation.position < 1e-12);
    }
}

TEST_CASE("the border around a corner depends on control points of the border only", "[corners]")
{
  CGAL::Random random(2);
  for (const int k : {3, 4, 5, 7}) {
    INFO(k << " quarters");
    Mesh t(test_t_meshes::fan<Rational>(k, 2));
    REQUIRE(t.make_spline_compatible());
    t.split_randomly(10, random);
    REQUIRE(t.make_spline_compatible());
    t.set_random_controls(random);
    Mesh::Surface surface = t.surface();
    const CGAL::T_splines::T_mesh_coordinates coordinates(t);
    const auto points_of_border = [&] {
      std::vector<Kernel::Point_3> result;
      for (const auto h : halfedges(t.mesh)) {
        if (is_border(h, t.mesh) || !is_border(opposite(h, t.mesh), t.mesh))
          continue;
        const auto p = converted<double>(coordinates.source_point(h)),
                   q = converted<double>(coordinates.target_point(h));
        for (const double s : {0., 0.1, 0.7, 1.}) {
          const std::pair<double, double> r(p.first + s * (q.first - p.first), p.second + s * (q.second - p.second));
          const auto at = inside(surface, face(h, t.mesh), r);
          result.push_back(surface.position(face(h, t.mesh), at.first, at.second));
        }
      }
      return result;
    };
    const auto before = points_of_border();
    for (const auto v : vertices(t.mesh))
      if (!CGAL::T_splines::is_border_vertex(v, t)) {
        const auto c = t.control(v);
        t.set_control(v, c.point() + Vector_3(1, 2, 3), c.weight());
      }
    REQUIRE(surface.update_control_points());
    const auto after = points_of_border();
    double largest = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      largest = (std::max)(largest, (before[i] - after[i]).squared_length());
    CHECK(std::sqrt(largest) < 1e-12);
    for (const auto v : vertices(t.mesh))
      if (CGAL::T_splines::is_border_vertex(v, t) && CGAL::T_splines::extended_valence(v, t) != 2)
        for (const auto h : CGAL::halfedges_around_target(halfedge(v, t.mesh), t.mesh))
          if (!is_border(h, t.mesh)) {
            const auto at = inside(surface, face(h, t.mesh), converted<double>(coordinates.target_point(h)));
            const auto p = surface.position(face(h, t.mesh), at.first, at.second);
            CHECK(std::sqrt((p - t.control(v).point()).squared_length()) < 1e-12);
          }
  }
}

} // namespace corners_test
