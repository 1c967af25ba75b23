// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// T-spline surfaces that are known otherwise: tensor products, T-splines in the plane, Catmull-Clark limit surfaces.

#include <CGAL/T_splines/Spline/T_spline_surface.h>

#include "Spline/Planar_t_mesh.h"
#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/subdivision_method_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace known_surfaces_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Homogeneous = std::array<double, 4>;

Homogeneous homogeneous(const Mesh::Control_point& p)
{
  return {p.weight() * p.x(), p.weight() * p.y(), p.weight() * p.z(), p.weight()};
}

Point_3 projected(const Homogeneous& h)
{
  return Point_3(h[0] / h[3], h[1] / h[3], h[2] / h[3]);
}

// A cubic B-spline curve by de Boor's algorithm.
// \param knots one more than controls + 3
Homogeneous de_boor(const std::vector<double>& knots, const std::vector<Homogeneous>& controls, const double x)
{
  std::size_t k = 3;
  while (k + 1 < controls.size() && knots[k + 1] <= x)
    ++k;
  std::array<Homogeneous, 4> d;
  for (int j = 0; j < 4; ++j)
    d[j] = controls[k - 3 + j];
  for (int r = 1; r <= 3; ++r)
    for (int j = 3; j >= r; --j) {
      const double a = (x - knots[k - 3 + j]) / (knots[k + 1 + j - r] - knots[k - 3 + j]);
      for (int c = 0; c < 4; ++c)
        d[j][c] = (1 - a) * d[j - 1][c] + a * d[j][c];
    }
  return d[3];
}

// \param control of (i, j)
template <typename Control>
Point_3 tensor_product(const std::vector<double>& u, const std::vector<double>& v, const Control& control,
                       const Position& p)
{
  std::vector<Homogeneous> column;
  for (std::size_t j = 0; j + 4 < v.size(); ++j) {
    std::vector<Homogeneous> row;
    for (std::size_t i = 0; i + 4 < u.size(); ++i)
      row.push_back(control(i, j));
    column.push_back(de_boor(u, row, p[0]));
  }
  return projected(de_boor(v, column, p[1]));
}

// The knots x, continued periodically by three on either side.
std::vector<double> periodic_knots(const std::vector<double>& x)
{
  const int n = static_cast<int>(x.size()) - 1;
  const double period = x.back() - x.front();
  std::vector<double> result;
  for (int i = -3; i <= n + 3; ++i) {
    const int turns = i < 0 ? -1 : i / n;
    result.push_back(x[i - turns * n] + turns * period);
  }
  return result;
}

// t_0 (four times), t_2, ..., t_(m-2), t_m (four times).
std::vector<double> clamped_knots(const std::vector<double>& t)
{
  std::vector<double> result(4, t.front());
  result.insert(result.end(), t.begin() + 2, t.end() - 2);
  result.insert(result.end(), 4, t.back());
  return result;
}

// A T-mesh in the plane with its surface.
class Planar_spline {
public:
  explicit Planar_spline(const Planar_t_mesh& plane) : m_plane(plane), m_mesh(plane.faces<double>())
  {
    for (std::size_t f = 0; f < m_mesh.face_list.size(); ++f) {
      const std::vector<Position> sources = plane.sources(f);
      for (std::size_t i = 0; i < sources.size(); ++i)
        m_vertex.emplace(sources[i], source(m_mesh.halfedge_of(f, static_cast<int>(i)), m_mesh.mesh));
    }
  }

  Mesh& mesh() { return m_mesh; }
  const std::map<Position, Mesh::vertex_descriptor>& vertices() const { return m_vertex; }
  Homogeneous control(const Position& v) const { return homogeneous(m_mesh.control(m_vertex.at(v))); }

  Point_3 position(const Mesh::Surface& surface, const Position& p) const { return jet(surface, p).position; }

  // In the frame of the face.
  Mesh::Surface::Jet jet(const Mesh::Surface& surface, const Position& p) const
  {
    const std::size_t f = m_plane.rectangle_at(p);
    const auto q = inside(surface, m_mesh.face_list[f], m_plane.in_frame(f, p));
    return surface.jet(m_mesh.face_list[f], q.first, q.second);
  }

private:
  Planar_t_mesh m_plane;
  Mesh m_mesh;
  std::map<Position, Mesh::vertex_descriptor> m_vertex;
};

Position random_position(const std::vector<double>& x, const std::vector<double>& y, CGAL::Random& random)
{
  return {random.get_double(x.front(), x.back()), random.get_double(y.front(), y.back())};
}

const std::vector<double> some_x{0, 1, 1.25, 4, 4.5, 7, 7.125, 9}, some_y{-1, 0, 2, 2.5, 3, 7, 8};

} // namespace

TEST_CASE("on a torus without T-joints the surface is the periodic tensor product", "[T_spline_surface]")
{
  CGAL::Random random(1);
  Planar_t_mesh plane(some_x, some_y, true);
  plane.set_random_frames(random);
  Planar_spline t(plane);
  t.mesh().set_random_controls(random);
  const auto surface = t.mesh().surface();
  REQUIRE(surface.is_valid());
  const std::size_t n = some_x.size() - 1, m = some_y.size() - 1;
  // The B-spline number i has the knots number i to i + 4, the middle one of which is number i - 1 of the period.
  const auto control = [&](const std::size_t i, const std::size_t j) {
    return t.control({some_x[(i + n - 1) % n], some_y[(j + m - 1) % m]});
  };
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    const Position p = random_position(some_x, some_y, random);
    worst = (std::max)(worst, length(t.position(surface, p) -
                                     tensor_product(periodic_knots(some_x), periodic_knots(some_y), control, p)));
  }
  CHECK(worst < 1e-13);
}

TEST_CASE("on a torus of few faces, which wrap around, the surface is the periodic tensor product",
          "[T_spline_surface]")
{
  CGAL::Random random(11);
  for (const std::vector<double>& x : {std::vector<double>{0, 3}, {0, 1, 3}, {-1, 1, 1.5, 7}, some_x})
    for (const std::vector<double>& y : {std::vector<double>{0, 5}, {2, 3, 4.5}, {0, 1, 2, 5}}) {
      INFO(x.size() - 1 << " x " << y.size() - 1 << " faces");
      Planar_t_mesh plane(x, y, true);
      plane.set_random_frames(random);
      Planar_spline t(plane);
      t.mesh().set_random_controls(random);
      const auto surface = t.mesh().surface();
      REQUIRE(surface.is_valid());
      // Periods enough that the basis functions on one of them do not overlap themselves.
      const auto repeated = [](const std::vector<double>& knots) {
        std::vector<double> result;
        for (int k = -4; k < 5; ++k)
          for (std::size_t i = 0; i + 1 < knots.size(); ++i)
            result.push_back(knots[i] + k * (knots.back() - knots.front()));
        return result;
      };
      const std::vector<double> u = repeated(x), v = repeated(y);
      const std::size_t n = x.size() - 1, m = y.size() - 1;
      const auto control = [&](const std::size_t i, const std::size_t j) {
        return t.control({x[(i + 2) % n], y[(j + 2) % m]});
      };
      double worst = 0;
      for (int k = 0; k < 500; ++k) {
        const Position p = random_position(x, y, random);
        worst = (std::max)(worst, length(t.position(surface, p) - tensor_product(u, v, control, p)));
      }
      CHECK(worst < 1e-13);
    }
}

TEST_CASE("on a torus of one face, split at random, the surface is the T-spline of the textbook", "[T_spline_surface]")
{
  CGAL::Random random(12);
  for (const int splits : {0, 1, 2, 3, 5, 8}) {
    INFO(splits << " splits");
    Planar_t_mesh plane({0, 8}, {0, 4}, true);
    plane.split_randomly(splits, random);
    plane.set_random_frames(random);
    Planar_spline t(plane);
    t.mesh().set_random_controls(random);
    const auto surface = t.mesh().surface();
    REQUIRE(surface.is_valid());
    double worst = 0;
    for (int k = 0; k < 400; ++k) {
      const Position p = random_position({0, 8}, {0, 4}, random);
      Homogeneous h{};
      for (const auto& f : plane.blending_functions(p))
        for (int c = 0; c < 4; ++c)
          h[c] += f.second * t.control(f.first)[c];
      worst = (std::max)(worst, length(t.position(surface, p) - projected(h)));
    }
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("on an open grid the surface is the clamped tensor product", "[T_spline_surface]")
{
  CGAL::Random random(2);
  for (const std::size_t columns : {7, 6, 5, 4, 3})
    for (const std::size_t rows : {6, 3}) {
      INFO(columns << " x " << rows);
      const std::vector<double> x(some_x.begin(), some_x.begin() + columns + 1),
          y(some_y.begin(), some_y.begin() + rows + 1);
      Planar_t_mesh plane(x, y, false);
      plane.set_random_frames(random);
      Planar_spline t(plane);
      t.mesh().set_random_controls(random);
      const auto surface = t.mesh().surface();
      REQUIRE(surface.is_valid());
      const auto control = [&](const std::size_t i, const std::size_t j) { return t.control({x[i], y[j]}); };
      double worst = 0;
      for (int k = 0; k < 500; ++k) {
        Position p = random_position(x, y, random);
        if (k % 5 == 0)
          p[0] = k % 2 == 0 ? x.front() : x.back();
        if (k % 7 == 0)
          p[1] = k % 2 == 0 ? y.front() : y.back();
        worst = (std::max)(
            worst, length(t.position(surface, p) - tensor_product(clamped_knots(x), clamped_knots(y), control, p)));
      }
      CHECK(worst < 1e-13);
    }
}

TEST_CASE("border curves depend on border vertices alone, and corners are interpolated", "[T_spline_surface]")
{
  CGAL::Random random(3);
  Planar_t_mesh plane(some_x, some_y, false);
  plane.split_randomly(15, random);
  plane.set_random_frames(random);
  Planar_spline t(plane);
  t.mesh().set_random_controls(random);
  auto surface = t.mesh().surface();
  REQUIRE(surface.is_valid());
  std::vector<Position> border;
  for (int k = 0; k <= 200; ++k)
    for (const int axis : {0, 1})
      for (const bool is_low : {true, false}) {
        const std::vector<double>&along = axis == 0 ? some_x : some_y, &normal = axis == 0 ? some_y : some_x;
        Position p;
        p[axis] = along.front() + (along.back() - along.front()) * k / 200.;
        p[1 - axis] = is_low ? normal.front() : normal.back();
        border.push_back(p);
      }
  std::vector<Point_3> before;
  for (const Position& p : border)
    before.push_back(t.position(surface, p));
  for (const double x : {some_x.front(), some_x.back()})
    for (const double y : {some_y.front(), some_y.back()})
      CHECK(length(t.position(surface, {x, y}) - t.mesh().control(t.vertices().at({x, y})).point()) < 1e-14);
  for (const auto& v : t.vertices())
    if (v.first[0] != some_x.front() && v.first[0] != some_x.back() && v.first[1] != some_y.front() &&
        v.first[1] != some_y.back())
      t.mesh().set_control(v.second, Point_3(5, 6, 7), 8);
  REQUIRE(surface.update_control_points());
  double worst = 0;
  for (std::size_t i = 0; i < border.size(); ++i)
    worst = (std::max)(worst, length(t.position(surface, border[i]) - before[i]));
  CHECK(worst < 1e-12);
}

TEST_CASE("with T-joints and equal halfedge knots the surface is the T-spline of the textbook", "[T_spline_surface]")
{
  CGAL::Random random(4);
  for (const int splits : {5, 20, 60}) {
    INFO(splits << " splits");
    Planar_t_mesh plane({0, 1, 2, 3.5, 4, 6, 7, 8, 9}, {0, 1, 1.5, 3, 4, 5, 7, 8}, true);
    plane.split_randomly(splits, random);
    plane.set_random_frames(random); // in the plane, nothing changes
    Planar_spline t(plane);
    t.mesh().set_random_controls(random);
    const auto surface = t.mesh().surface();
    INFO(message(surface.report().compatibility.status));
    REQUIRE(surface.is_valid());
    double worst = 0, smallest_sum = 1;
    for (int k = 0; k < 400; ++k) {
      const Position p = random_position({0, 9}, {0, 8}, random);
      const std::map<Position, double> functions = plane.blending_functions(p);
      Homogeneous h{};
      double sum = 0;
      for (const auto& f : functions) {
        sum += f.second;
        for (int c = 0; c < 4; ++c)
          h[c] += f.second * t.control(f.first)[c];
      }
      smallest_sum = (std::min)(smallest_sum, 1 - std::abs(sum - 1));
      worst = (std::max)(worst, length(t.position(surface, p) - projected(h)));

      // The same functions act.
      const std::size_t f = plane.rectangle_at(p);
      const auto q = inside(surface, t.mesh().face_list[f], plane.in_frame(f, p));
      std::vector<CGAL::T_splines::Basis_function_jet<Surface_mesh, double>> jets;
      surface.basis_functions(t.mesh().face_list[f], q.first, q.second, std::back_inserter(jets));
      double difference = 0;
      std::map<Mesh::vertex_descriptor, double> values;
      for (const auto& jet : jets)
        values[jet.vertex] = jet.value;
      for (const auto& v : t.vertices()) {
        const auto found = functions.find(v.first);
        difference =
            (std::max)(difference, std::abs(values[v.second] - (found == functions.end() ? 0 : found->second)));
      }
      CHECK(difference < 1e-13);
    }
    CHECK(worst < 1e-12);
    CHECK(smallest_sum < 0.999); // the T-mesh is not standard: the functions alone do not sum to one
  }
}

TEST_CASE("where the T-mesh is a grid, linear and cubic polynomials are reproduced", "[T_spline_surface]")
{
  CGAL::Random random(5);
  const bool is_open = GENERATE(true, false);
  // The T-joints in a corner are seen from few faces.
  Planar_t_mesh plane({0, 1, 3, 4, 6, 7, 8, 10, 11, 12}, {0, 2, 3, 4, 5, 7, 8, 9, 10}, !is_open);
  if (!is_open)
    plane.split(0, 0, 0.5);
  plane.set_random_frames(random);
  Planar_spline t(plane);
  // A polynomial in x is, as a sum of B-splines, its polar form at the three knots in the middle (Ramshaw 1987).
  const std::vector<double> x{0, 1, 3, 4, 6, 7, 8, 10, 11, 12}, y{0, 2, 3, 4, 5, 7, 8, 9, 10};
  const auto middle_knots = [&](const std::vector<double>& t, const double at) {
    const auto i = std::find(t.begin(), t.end(), at) - t.begin();
    const std::vector<double> knots = is_open ? clamped_knots(t) : periodic_knots(t);
    const auto first = knots.begin() + (is_open ? i : i + 1) + 1;
    return std::array<double, 3>{first[0], first[1], first[2]};
  };
  const auto cubic = [](const std::array<double, 3>& a) { return a[0] * a[1] * a[2]; };
  const auto linear = [](const std::array<double, 3>& a) { return (a[0] + a[1] + a[2]) / 3; };
  for (const auto& v : t.vertices()) {
    if (!is_open && (std::find(x.begin(), x.end(), v.first[0]) == x.end())) {
      t.mesh().set_control(v.second, Point_3(0, 0, 0), 1);
      continue;
    }
    const auto a = middle_knots(x, v.first[0]), b = middle_knots(y, v.first[1]);
    t.mesh().set_control(v.second,
                         Point_3(linear(a), linear(b), (cubic(a) * cubic(b) - 7 * cubic(a) * linear(b)) / 1e6), 1);
  }
  const auto surface = t.mesh().surface();
  REQUIRE(surface.is_valid());
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    // Away from the T-joints and the seam, or everywhere.
    const Position p = is_open ? random_position(x, y, random) : random_position({4, 8}, {4, 7}, random);
    const double c = p[0] * p[0] * p[0], d = p[1] * p[1] * p[1];
    worst = (std::max)(worst, length(t.position(surface, p) - Point_3(p[0], p[1], (c * d - 7 * c * p[1]) / 1e6)));
  }
  CHECK(worst < 1e-13);
}

TEST_CASE("a knot is inserted into a cubic curve as in The NURBS Book", "[T_spline_surface]")
{
  // Piegl and Tiller, The NURBS Book, Ex5.1: p = 3, U = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5}, u = 5/2 is inserted:
  // Q_3 = 5/6 P_3 + 1/6 P_2, Q_4 = 1/2 P_4 + 1/2 P_3, Q_5 = 1/6 P_5 + 5/6 P_4.
  CGAL::Random random(6);
  const std::vector<double> y{0, 1, 2, 3}, t{0, 0.5, 1, 2, 3, 4, 4.5, 5}, t_new{0, 0.5, 1, 2, 2.5, 3, 4, 4.5, 5};
  Planar_spline before(Planar_t_mesh(t, y, false)), after(Planar_t_mesh(t_new, y, false));
  before.mesh().set_random_controls(random);
  for (std::size_t i = 0; i < t_new.size(); ++i)
    for (const double row : y) {
      const double share = i < 3 ? 1 : i == 3 ? 5. / 6 : i == 4 ? 1. / 2 : i == 5 ? 1. / 6 : 0; // of P_i
      Homogeneous q{};
      for (int c = 0; c < 4; ++c) {
        if (share > 0)
          q[c] += share * before.control({t[i], row})[c];
        if (share < 1)
          q[c] += (1 - share) * before.control({t[i - 1], row})[c];
      }
      after.mesh().set_control(after.vertices().at({t_new[i], row}), projected(q), q[3]);
    }
  const auto a = before.mesh().surface(), b = after.mesh().surface();
  REQUIRE((a.is_valid() && b.is_valid()));
  for (int k = 0; k < 500; ++k) {
    const Position p = random_position(t, y, random);
    CHECK(length(before.position(a, p) - after.position(b, p)) < 1e-14);
  }
}

TEST_CASE("half a sphere is one patch", "[T_spline_surface]")
{
  // The half circle as a cubic (Piegl and Tiller, The NURBS Book, section 7.5): (1, 0), (1, 2), (-1, 2), (-1, 0) with the
  // weights 1, 1/3, 1/3, 1. It is rotated by a half turn about its diameter, by the same formula.
  const std::vector<double> knots{0, 1, 2, 3};
  const std::array<Position, 4> circle{{{1, 0}, {1, 2}, {-1, 2}, {-1, 0}}};
  const std::array<double, 4> weights{1, 1. / 3, 1. / 3, 1};
  Planar_spline t(Planar_t_mesh(knots, knots, false));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double radius = circle[j][1];
      t.mesh().set_control(t.vertices().at({double(i), double(j)}),
                           Point_3(radius * circle[i][0], radius * circle[i][1], -circle[j][0]),
                           weights[i] * weights[j]);
    }
  const auto surface = t.mesh().surface();
  REQUIRE(surface.is_valid());
  CGAL::Random random(7);
  for (int k = 0; k < 500; ++k) {
    const Position p = random_position({0.01, 2.99}, {0.01, 2.99}, random);
    const auto jet = t.jet(surface, p);
    const Vector_3 radius = jet.position - CGAL::ORIGIN;
    CHECK(std::abs(length(radius) - 1) < 1e-14);
    CHECK(length(jet.unit_normal() - radius) < 1e-11);
    const auto curvatures = jet.curvatures();
    CHECK(curvatures.gaussian == Approx(1).epsilon(1e-9));
    CHECK(curvatures.mean == Approx(-1).epsilon(1e-9));
    CHECK(curvatures.minimal == Approx(-1).epsilon(1e-6));
    CHECK(std::abs(curvatures.minimal_direction * radius) < 1e-9);
  }
}

namespace {

// Two pyramids on one base of k edges: vertices of valence k and 4.
Surface_mesh double_pyramid(const int k)
{
  Surface_mesh result;
  std::vector<Surface_mesh::Vertex_index> base;
  for (int i = 0; i < k; ++i)
    base.push_back(result.add_vertex(Point_3(std::cos(2 * i), std::sin(3 * i), 0.1 * i)));
  const auto top = result.add_vertex(Point_3(0, 0.25, 1)), bottom = result.add_vertex(Point_3(0.5, 0, -1));
  for (int i = 0; i < k; ++i) {
    result.add_face(base[i], base[(i + 1) % k], top);
    result.add_face(base[(i + 1) % k], base[i], bottom);
  }
  return result;
}

// A torus of 4 x 3 quads, one of them cut by a diagonal, two others joined: afterwards there are valences 3, 5 and 6.
Surface_mesh polygonal_torus()
{
  Surface_mesh result;
  constexpr int n = 4, m = 3;
  std::vector<Surface_mesh::Vertex_index> v;
  CGAL::Random random(8);
  for (int i = 0; i < n * m; ++i)
    v.push_back(result.add_vertex(Point_3(random.get_double(), random.get_double(), random.get_double())));
  const auto at = [&](const int i, const int j) { return v[i % n + n * (j % m)]; };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
      result.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  const auto cut = result.halfedge(at(0, 0), at(1, 0));
  CGAL::Euler::split_face(cut, result.next(result.next(cut)), result);
  CGAL::Euler::join_face(result.halfedge(at(2, 1), at(2, 2)), result);
  return result;
}

// Where the vertices of a quad mesh go in the limit (Halstead, Kass, DeRose 1993).
std::vector<Point_3> limit_points(const Surface_mesh& mesh)
{
  std::vector<Point_3> result;
  for (const auto v : mesh.vertices()) {
    double n = 0;
    Vector_3 edges(0, 0, 0), faces(0, 0, 0);
    for (const auto h : CGAL::halfedges_around_target(v, mesh)) {
      ++n;
      edges = edges + (mesh.point(mesh.source(h)) - CGAL::ORIGIN);
      faces = faces + (mesh.point(mesh.target(mesh.next(mesh.next(h)))) - CGAL::ORIGIN);
    }
    result.push_back(CGAL::ORIGIN + (n * n * (mesh.point(v) - CGAL::ORIGIN) + 4 * edges + faces) / (n * (n + 5)));
  }
  return result;
}

} // namespace

TEST_CASE("on a subdivided quad mesh with unit knots the surface is the Catmull-Clark limit surface",
          "[T_spline_surface]")
{
  std::vector<Surface_mesh> meshes{polygonal_torus()};
  for (int k = 3; k <= 12; ++k)
    meshes.push_back(double_pyramid(k));
  for (Surface_mesh& mesh : meshes) {
    using namespace CGAL::Subdivision_method_3;
    CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(1)); // to quads
    CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
    Faces<double> faces_given;
    std::vector<Point_3> sources;
    for (const auto f : mesh.faces()) {
      faces_given.emplace_back();
      for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        faces_given.back().push_back({static_cast<int>(mesh.edge(h)), 1, true});
        sources.push_back(mesh.point(mesh.source(h)));
      }
    }
    Mesh t(faces_given);
    for (std::size_t f = 0; f < t.face_list.size(); ++f)
      for (int i = 0; i < 4; ++i)
        t.set_control(source(t.halfedge_of(f, i), t.mesh), sources[4 * f + i], 1);
    const auto surface = t.surface();
    INFO(mesh.number_of_faces() << " faces: " << message(surface.report().compatibility.status));
    REQUIRE(surface.is_valid());

    constexpr int levels = 2, n = 1 << levels;
    CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(levels));
    std::vector<Point_3> limit = limit_points(mesh);
    std::sort(limit.begin(), limit.end());
    double worst = 0;
    std::vector<char> is_met(limit.size());
    for (const auto f : t.face_list)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
          const Point_3 p = surface.position(f, double(i) / n, double(j) / n);
          auto q = std::lower_bound(limit.begin(), limit.end(), p - Vector_3(1e-9, 0, 0));
          double nearest = 1;
          for (; q != limit.end() && q->x() < p.x() + 1e-9; ++q) {
            const double distance = length(p - *q);
            if (distance < 1e-9)
              is_met[q - limit.begin()] = true;
            nearest = (std::min)(nearest, distance);
          }
          worst = (std::max)(worst, nearest);
        }
    CHECK(worst < 1e-12);
    CHECK(std::count(is_met.begin(), is_met.end(), true) == static_cast<std::ptrdiff_t>(limit.size()));
  }
}

} // namespace known_surfaces_test
