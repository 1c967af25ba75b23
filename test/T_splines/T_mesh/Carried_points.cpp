// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/T_mesh/Carried_points.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Mesh::Face_index;
using Rational = CGAL::Exact_rational;
template <typename FT>
using Piece = CGAL::T_splines::T_mesh_piece<Mesh, FT>;
template <typename FT>
using Similarity = CGAL::T_splines::Similarity_2<FT>;

const Face a(0), b(1), c(2);

template <typename Points>
std::string names(const Points& points, const Face f)
{
  std::string result;
  for (const auto& p : points.points(f))
    result += p.payload;
  return result;
}

} // namespace

TEST_CASE("points go by the first piece in whose rectangle they are", "[Carried_points]")
{
  using FT = Rational;
  CGAL::T_splines::Carried_points<Mesh, FT, char> points;
  points.add(a, 1, 1, 'x');
  points.add(a, 2, 0, 'y'); // on the cut
  points.add(a, 3, 1, 'z');
  points.add(c, 5, 5, 'w');
  // [0, 4] x [0, 2] is cut at u = 2; the right part turns by a quarter and is half as large.
  points.observer().faces_replaced(
      std::vector<Piece<FT>>{{a, a, Similarity<FT>(), 2, 2}, {a, b, Similarity<FT>(1, FT(1) / 2, 1, -1), 1, 1}});
  CHECK(names(points, a) == "xy");
  CHECK(names(points, b) == "z");
  CHECK(names(points, c) == "w");
  CHECK(points.points(b)[0].u == FT(1) / 2);
  CHECK(points.points(b)[0].v == FT(1) / 2);

  // The two become one again, with the frame of b.
  points.observer().faces_replaced(
      std::vector<Piece<FT>>{{b, b, Similarity<FT>(), 1, 2}, {a, b, Similarity<FT>(1, FT(1) / 2, 1, 1), 1, 2}});
  CHECK(names(points, a).empty());
  CHECK(names(points, b).size() == 3);
}

TEST_CASE("what round-off leaves outside goes to the nearest piece", "[Carried_points]")
{
  CGAL::T_splines::Carried_points<Mesh, double, char> points;
  points.add(a, 4 + 1e-15, 1, 'x');
  points.add(a, -1e-15, 1, 'y');
  points.observer().faces_replaced(
      std::vector<Piece<double>>{{a, a, Similarity<double>(), 2, 2}, {a, b, Similarity<double>(0, 1, -2, 0), 2, 2}});
  CHECK(names(points, a) == "y");
  CHECK(names(points, b) == "x");
}

TEST_CASE("points in doubles follow exact faces", "[Carried_points]")
{
  CGAL::T_splines::Carried_points<Mesh, double, char> points;
  points.add(a, 0.25, 0.5, 'x');
  points.observer().faces_replaced(
      std::vector<Piece<Rational>>{{a, c, Similarity<Rational>(2, Rational(1) / 2, 3, 3), 4, 4}});
  CHECK(names(points, c) == "x");
  CHECK(points.points(c)[0].u == 2.875);
  CHECK(points.points(c)[0].v == 2.75);
  CHECK(points.points(a).empty());
}
