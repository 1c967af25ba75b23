// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/T_spline_closest_point.h>

#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>

#include "Spline/Spline_mesh.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_utils.h>
#include <CGAL/subdivision_method_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace T_spline_closest_point_test {

namespace {

using namespace spline_tests;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = Surface_mesh;
using Face = Mesh::Face_index;
using CGAL::T_splines::compile_T_spline;
using CGAL::T_splines::make_control_point_map;
using CGAL::T_splines::T_spline_closest_point;
using Projection = CGAL::T_splines::Surface_projection<Mesh, Kernel>;
using Place = CGAL::T_splines::T_mesh_place<Mesh, double>;

double distance(const Point_3& a, const Point_3& b)
{
  return std::sqrt(CGAL::squared_distance(a, b));
}

using T_spline = CGAL::T_splines::T_spline<Kernel>;

// A quad mesh with unit knots.
T_spline with_unit_knots(const Mesh& mesh)
{
  T_spline spline;
  CGAL::copy_face_graph(mesh, spline.graph());
  for (const auto h : halfedges(spline.graph())) {
    put(spline.knots(), h, 1);
    put(spline.corners(), h, true);
  }
  return spline;
}

// A smooth surface with two vertices of the valence `sides`, and 2 * sides of valence 3.
T_spline prism(const int sides)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> bottom, top, top_reversed;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * CGAL_PI * i / sides;
    bottom.push_back(mesh.add_vertex(Point_3(std::cos(angle), std::sin(angle), -0.6)));
    top.push_back(mesh.add_vertex(Point_3(1.2 * std::cos(angle), std::sin(angle), 0.6)));
  }
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    mesh.add_face(bottom[i], bottom[j], top[j], top[i]);
  }
  mesh.add_face(top);
  std::reverse(bottom.begin(), bottom.end());
  mesh.add_face(bottom);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  return with_unit_knots(mesh);
}

// An open surface, a hilly square.
T_spline hills()
{
  Mesh mesh;
  CGAL::make_grid(9, 7, mesh, [](const std::size_t i, const std::size_t j) {
    const double x = i / 9., y = j / 7.;
    return Point_3(x + 0.02 * std::sin(5 * y), y, 0.1 * std::sin(4 * x) * std::cos(3 * y));
  });
  return with_unit_knots(mesh);
}

std::vector<std::pair<std::string, T_spline>> smooth_surfaces()
{
  std::vector<std::pair<std::string, T_spline>> result{{"triangular prism", prism(3)},
                                                       {"pentagonal prism", prism(5)},
                                                       {"nonagonal prism", prism(9)},
                                                       {"hills", hills()}};
  CGAL::Random random(1);
  T_spline rational = prism(6);
  for (const auto v : vertices(rational.graph()))
    rational.weights()[v] = random.get_double(0.8, 1.25);
  result.emplace_back("rational hexagonal prism", rational);
  return result;
}

template <typename Surface>
Place random_place(const Surface& surface, CGAL::Random& random)
{
  const auto f =
      *std::next(faces(surface.graph()).begin(), random.get_int(0, static_cast<int>(num_faces(surface.graph()))));
  return {f, random.get_double(0, surface.width(f)), random.get_double(0, surface.height(f))};
}

// The distance to samples, and how much closer the surface may be.
struct Sampled_distance {
  double distance, error;
};

template <typename Surface>
class Samples {
public:
  Samples(const Surface& surface, const int n)
  {
    std::vector<Point_3> cells((n + 1) * (n + 1));
    for (const auto f : faces(surface.graph())) {
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          cells[j * (n + 1) + i] =
              surface.position(f, surface.width(f) * (i / double(n)), surface.height(f) * (j / double(n)));
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          for (const int k : {1, n + 1, n + 2})
            m_error = (std::max)(m_error, distance(cells[j * (n + 1) + i], cells[j * (n + 1) + i + k]));
      m_points.insert(m_points.end(), cells.begin(), cells.end());
    }
  }

  Sampled_distance operator()(const Point_3& p) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const Point_3& q : m_points)
      result = (std::min)(result, distance(p, q));
    return {result, m_error};
  }

  CGAL::Bbox_3 box() const { return CGAL::bbox_3(m_points.begin(), m_points.end()); }

private:
  std::vector<Point_3> m_points;
  double m_error = 0;
};

Point_3 random_point(const CGAL::Bbox_3& box, const double factor, CGAL::Random& random)
{
  std::array<double, 3> x;
  for (int k = 0; k < 3; ++k)
    x[k] = (box.min(k) + box.max(k)) / 2 + factor * (box.max(k) - box.min(k)) * random.get_double(-0.5, 0.5);
  return Point_3(x[0], x[1], x[2]);
}

template <typename Surface>
bool is_in_face(const Surface& surface, const Projection& x)
{
  return x.u >= 0 && x.u <= surface.width(x.face) && x.v >= 0 && x.v <= surface.height(x.face);
}

// The length of the part of the difference that a small motion on the surface would reduce. At a border it may not.
template <typename Surface>
double slope(const Surface& surface, const Point_3& p, const Projection& x)
{
  const auto jet = surface.jet(x.face, x.u, x.v);
  const Vector_3 difference = x.point - p;
  const auto along = [&](const Vector_3& d, const double value, const double end) {
    const double length = std::sqrt(d.squared_length()), g = length > 0 ? d * difference / length : 0;
    bool has_border = false;
    for (const auto h : CGAL::halfedges_around_face(halfedge(x.face, surface.graph()), surface.graph()))
      has_border = has_border || CGAL::is_border(opposite(h, surface.graph()), surface.graph());
    return has_border && ((value == 0 && g > 0) || (value == end && g < 0)) ? 0 : std::abs(g);
  };
  return (std::max)(along(jet.du, x.u, surface.width(x.face)), along(jet.dv, x.v, surface.height(x.face)));
}

// A corner of a face that is an extraordinary vertex.
template <typename Surface>
Place extraordinary_corner(const Surface& surface, const Face f)
{
  for (const double u : {0., surface.width(f)})
    for (const double v : {0., surface.height(f)})
      if (surface.jet(f, u, v).du == Vector_3(0, 0, 0))
        return {f, u, v};
  return {};
}

} // namespace

TEST_CASE("points of a surface are their own closest points", "[T_spline_closest_point]")
{
  CGAL::Random random(2);
  for (auto& example : smooth_surfaces()) {
    INFO(example.first);
    const auto surface = example.second.surface();
    REQUIRE(surface.is_valid());
    const T_spline_closest_point<T_spline::Surface> closest(surface);
    for (int i = 0; i < 500; ++i) {
      const Place place = random_place(surface, random);
      const Point_3 p = surface.position(place.face, place.u, place.v);
      const Projection x = closest(p);
      REQUIRE(is_in_face(surface, x));
      REQUIRE(x.distance < 2e-15);
      REQUIRE(distance(x.point, p) < 2e-15);
      REQUIRE(distance(surface.position(x.face, x.u, x.v), x.point) < 2e-15);
    }
  }
}

TEST_CASE("points on a short normal come back to its foot", "[T_spline_closest_point]")
{
  CGAL::Random random(3);
  for (auto& example : smooth_surfaces()) {
    INFO(example.first);
    const auto surface = example.second.surface();
    const T_spline_closest_point<T_spline::Surface> closest(surface);
    for (int i = 0; i < 500; ++i) {
      const Place place = random_place(surface, random);
      const double height = random.get_double(-1, 1) * std::pow(10., -random.get_int(2, 9));
      const Point_3 foot = surface.position(place.face, place.u, place.v);
      const Point_3 p = foot + height * surface.unit_normal(place.face, place.u, place.v);
      const Projection x = closest(p);
      REQUIRE(x.distance == Approx(std::abs(height)).epsilon(1e-13).margin(2e-15));
      REQUIRE(distance(x.point, foot) < 1e-14);
      REQUIRE(slope(surface, p, x) < 1e-14);
    }
  }
}

TEST_CASE("no sample of a smooth surface is closer", "[T_spline_closest_point]")
{
  CGAL::Random random(4);
  for (auto& example : smooth_surfaces()) {
    INFO(example.first);
    const auto surface = example.second.surface();
    const T_spline_closest_point<T_spline::Surface> closest(surface);
    const Samples<T_spline::Surface> samples(surface, 8);
    for (int i = 0; i < 100; ++i) {
      // Around, inside and near the medial axis, and far away.
      const Point_3 p = random_point(samples.box(), std::array<double, 4>{0.02, 1, 3, 100}[i % 4], random);
      const Projection x = closest(p);
      const Sampled_distance d = samples(p);
      REQUIRE(x.distance <= d.distance + 1e-14 * (1 + d.distance));
      REQUIRE(x.distance >= d.distance - d.error);
      REQUIRE(distance(p, x.point) == Approx(x.distance).epsilon(1e-14));
      REQUIRE(is_in_face(surface, x));
      REQUIRE(distance(surface.position(x.face, x.u, x.v), x.point) < 1e-13);
      REQUIRE(slope(surface, p, x) < 1e-13 * (1 + d.distance));
    }
  }
}

TEST_CASE("no sample of a rational surface that intersects itself is closer", "[T_spline_closest_point]")
{
  CGAL::Random random(5);
  for (const auto& faces : closed_surfaces<Rational>()) {
    INFO(faces.first);
    Spline_mesh<Rational> t(faces.second);
    t.make_spline_compatible();
    t.split_randomly(10, random);
    REQUIRE(t.make_spline_compatible());
    t.set_random_controls(random);
    const auto surface = t.surface();
    const T_spline_closest_point<Spline_mesh<Rational>::Surface> closest(surface);
    const Samples<Spline_mesh<Rational>::Surface> samples(surface, 6);
    for (int i = 0; i < 60; ++i) {
      const Point_3 p = random_point(samples.box(), i % 2 == 0 ? 1 : 3, random);
      const Projection x = closest(p);
      const Sampled_distance d = samples(p);
      REQUIRE(x.distance <= d.distance + 1e-14);
      REQUIRE(x.distance >= d.distance - d.error);
      REQUIRE(distance(p, x.point) == Approx(x.distance).epsilon(1e-14).margin(1e-15));
      REQUIRE(is_in_face(surface, x));
    }
  }
}

TEST_CASE("a center of symmetry has the distance of the closest samples", "[T_spline_closest_point]")
{
  // Its closest points are many.
  T_spline cube = prism(4);
  for (const auto v : vertices(cube.graph())) {
    const Point_3 p = cube.graph().point(v);
    const Vector_3 d(p.x(), p.y(), p.z());
    cube.graph().point(v) = CGAL::ORIGIN + d / std::sqrt(d.squared_length());
  }
  const auto surface = cube.surface();
  const T_spline_closest_point<T_spline::Surface> closest(surface);
  const Samples<T_spline::Surface> samples(surface, 16);
  const Sampled_distance d = samples(CGAL::ORIGIN);
  const Projection x = closest(CGAL::ORIGIN);
  CHECK(x.distance <= d.distance);
  CHECK(x.distance >= d.distance - 1e-4);
  CHECK(slope(surface, CGAL::ORIGIN, x) < 1e-13);
}

TEST_CASE("the closest point may be an extraordinary vertex", "[T_spline_closest_point]")
{
  CGAL::Random random(6);
  for (const int sides : {3, 5, 6, 9, 12}) {
    INFO("valence " << sides);
    T_spline t = prism(sides);
    const auto surface = t.surface();
    const T_spline_closest_point<T_spline::Surface> closest(surface);
    int number = 0;
    for (const auto f : faces(t.graph())) {
      const Place corner = surface.is_at_extraordinary_vertex(f) ? extraordinary_corner(surface, f) : Place();
      if (corner.face == Mesh::null_face() || number++ % sides != 0)
        continue;
      const Point_3 vertex = surface.position(f, corner.u, corner.v);
      REQUIRE(closest(vertex).distance < 2e-15);
      // The surface is convex.
      for (const double height : {1e-9, 1e-3, 1., 100.}) {
        const Point_3 p = vertex + height * surface.unit_normal(f, corner.u, corner.v);
        const Projection x = closest(p);
        REQUIRE(x.distance == Approx(height).epsilon(1e-14).margin(1e-15));
        REQUIRE(distance(x.point, vertex) < 1e-14 * (1 + height));
        REQUIRE(distance(surface.position(x.face, x.u, x.v), vertex) < 1e-8 * (1 + height));
        REQUIRE(closest(p, corner).distance == Approx(x.distance).epsilon(1e-15).margin(1e-15));
      }
      // Very close to it.
      for (int exponent = 4; exponent < 40; exponent += 5) {
        const double size = std::ldexp(random.get_double(0.5, 1), -exponent);
        const double u = std::abs(corner.u - size), v = std::abs(corner.v - size * random.get_double());
        const Point_3 q = surface.position(f, u, v);
        const Point_3 p = q + 0.01 * surface.unit_normal(f, u, v);
        REQUIRE(closest(q).distance < 2e-15);
        REQUIRE(distance(closest(p).point, q) < 1e-13);
        REQUIRE(distance(closest(p, Place{f, u, v}).point, q) < 1e-13);
      }
    }
  }
}

TEST_CASE("beyond a border the closest point is on the border", "[T_spline_closest_point]")
{
  T_spline t = hills();
  const auto surface = t.surface();
  const T_spline_closest_point<T_spline::Surface> closest(surface);
  CGAL::Random random(7);
  int number_of_borders = 0, number_of_corners = 0;
  for (const auto f : faces(t.graph())) {
    auto h = halfedge(f, t.graph());
    for (int side = 0; side < 4; ++side, h = next(h, t.graph())) {
      if (!CGAL::is_border(opposite(h, t.graph()), t.graph()))
        continue;
      ++number_of_borders;
      const double x = random.get_double();
      const std::array<Place, 4> places{Place{f, x, 0}, Place{f, 1, x}, Place{f, x, 1}, Place{f, 0, x}};
      const Place place = places[side];
      const auto jet = surface.jet(f, place.u, place.v);
      const Vector_3 along = side % 2 == 0 ? jet.du : jet.dv;
      const Vector_3 inwards = (side == 1 || side == 2 ? -1. : 1.) * (side % 2 == 0 ? jet.dv : jet.du);
      const Vector_3 outwards = (inwards * along) / along.squared_length() * along - inwards;
      const Point_3 p = jet.position + 0.03 / std::sqrt(outwards.squared_length()) * outwards;
      const Projection found = closest(p);
      REQUIRE(found.distance == Approx(0.03).epsilon(1e-13));
      REQUIRE(distance(found.point, jet.position) < 1e-14);
      REQUIRE(found.face == f);
      REQUIRE((side % 2 == 0 ? found.v == place.v : found.u == place.u));
      // The corner is closest to what is beyond both borders.
      if (!CGAL::is_border(opposite(next(h, t.graph()), t.graph()), t.graph()))
        continue;
      ++number_of_corners;
      const std::array<Place, 4> corners{Place{f, 1, 0}, Place{f, 1, 1}, Place{f, 0, 1}, Place{f, 0, 0}};
      const Place c = corners[side];
      const auto corner = surface.jet(f, c.u, c.v);
      const Projection at_corner =
          closest(corner.position + 0.3 * ((c.u == 0 ? -1. : 1.) * corner.du + (c.v == 0 ? -1. : 1.) * corner.dv));
      REQUIRE(at_corner.face == f);
      REQUIRE(at_corner.u == c.u);
      REQUIRE(at_corner.v == c.v);
      REQUIRE(distance(at_corner.point, corner.position) < 1e-15);
    }
  }
  CHECK(number_of_borders == 32);
  CHECK(number_of_corners == 4);
}

TEST_CASE("hints and threads do not change closest points", "[T_spline_closest_point]")
{
  T_spline t = prism(5);
  const auto surface = t.surface();
  const T_spline_closest_point<T_spline::Surface> closest(surface);
  CGAL::Random random(8);
  std::vector<Point_3> points;
  std::vector<Place> places;
  for (int i = 0; i < 300; ++i) {
    places.push_back(random_place(surface, random));
    points.push_back(surface.position(places.back().face, places.back().u, places.back().v) +
                     random.get_double(-0.1, 0.3) *
                         surface.unit_normal(places.back().face, places.back().u, places.back().v));
  }
  std::vector<Projection> expected;
  for (const Point_3& p : points)
    expected.push_back(closest(p));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const Projection& x :
         {closest(points[i], places[i]), closest(points[i], expected[i]), closest(points[i], places[i / 2])}) {
      REQUIRE(x.distance == Approx(expected[i].distance).epsilon(1e-13).margin(1e-15));
      REQUIRE(distance(x.point, expected[i].point) < 1e-12);
    }
  std::array<std::vector<Projection>, 2> found;
  std::vector<std::thread> threads;
  for (auto& result : found)
    threads.emplace_back([&] {
      for (const Point_3& p : points)
        result.push_back(closest(p));
    });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& result : found)
    for (std::size_t i = 0; i < points.size(); ++i) {
      REQUIRE(result[i].face == expected[i].face);
      REQUIRE(result[i].u == expected[i].u);
      REQUIRE(result[i].v == expected[i].v);
      REQUIRE(result[i].point == expected[i].point);
    }
}

TEST_CASE("closest points of a compiled surface", "[T_spline_closest_point]")
{
  CGAL::Random random(9);
  for (const double largest_weight : {1., 2., 1000.}) {
    INFO("weights up to " << largest_weight);
    T_spline t = prism(7);
    for (const auto v : vertices(t.graph()))
      t.weights()[v] = std::pow(largest_weight, random.get_double(-1, 1));
    const auto surface = t.surface();
    const auto compiled = compile_T_spline(surface, CGAL::T_splines::parameters::number_of_rings(2));
    const T_spline_closest_point<T_spline::Surface> exact(surface);
    const T_spline_closest_point<std::decay_t<decltype(compiled)>> closest(compiled);
    const Samples<std::decay_t<decltype(compiled)>> samples(compiled, 8);
    for (int i = 0; i < 100; ++i) {
      const Point_3 p = random_point(samples.box(), i % 2 == 0 ? 1 : 2, random);
      const Projection x = closest(p);
      const Sampled_distance d = samples(p);
      REQUIRE(x.distance <= d.distance + 1e-14);
      REQUIRE(x.distance >= d.distance - d.error);
      REQUIRE(std::abs(x.distance - exact(p).distance) <= 2 * compiled.cap_deviation());
      REQUIRE(distance(compiled.position(x.face, x.u, x.v), x.point) < 1e-13);
    }
  }
}

TEST_CASE("closest points in long double", "[T_spline_closest_point]")
{
  using Long_kernel = CGAL::Simple_cartesian<long double>;
  CGAL::Random random(10);
  Spline_mesh<Rational, Long_kernel> t(test_t_meshes::cube<Rational>());
  REQUIRE(t.make_spline_compatible());
  t.set_random_controls(random);
  const auto surface = t.surface();
  const T_spline_closest_point<Spline_mesh<Rational, Long_kernel>::Surface> closest(surface);
  for (int i = 0; i < 100; ++i) {
    const Place place = random_place(surface, random);
    CHECK(closest(surface.position(place.face, place.u, place.v)).distance < 1e-18L);
  }
}

} // namespace T_spline_closest_point_test
