// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SPLINE_PLANAR_T_MESH_H
#define T_SPLINES_TEST_SPLINE_PLANAR_T_MESH_H

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

// T-meshes in the plane, and T-splines on them by the textbook: an independent reference.
namespace spline_tests {

using Position = std::array<double, 2>;

// A cubic B-spline by the recursion of Cox and de Boor; on the right of the last knot the one from the left.
class Reference_b_spline {
public:
  explicit Reference_b_spline(const std::array<double, 5>& knots) : m_knots(knots) {}

  double operator()(const double x) const
  {
    if (x < m_knots[0] || x > m_knots[4])
      return 0;
    return value(0, 3, x);
  }

private:
  double value(const int i, const int degree, const double x) const
  {
    const double a = m_knots[i], b = m_knots[i + degree + 1];
    if (degree == 0)
      return (a <= x && x < b) || (x == m_knots[4] && b == x && a < b) ? 1 : 0;
    double result = 0;
    if (m_knots[i + degree] > a)
      result += (x - a) / (m_knots[i + degree] - a) * value(i, degree - 1, x);
    if (b > m_knots[i + 1])
      result += (b - x) / (b - m_knots[i + 1]) * value(i + 1, degree - 1, x);
    return result;
  }

  std::array<double, 5> m_knots;
};

// A rectangle cut into rectangles. Its opposite sides are glued, or it has a border. Coordinates are short dyadic numbers.
class Planar_t_mesh {
public:
  struct Rectangle {
    std::array<double, 2> low, high;
    int turns = 0;   // the corner number `turns`, counter-clockwise, is the origin of the frame
    double unit = 1; // one in the plane are so many in the frame
  };

  // A grid.
  Planar_t_mesh(const std::vector<double>& x, const std::vector<double>& y, const bool is_periodic)
    : m_low{x.front(), y.front()},
      m_high{x.back(), y.back()},
      m_is_periodic(is_periodic)
  {
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        m_rectangles.push_back({{x[i], y[j]}, {x[i + 1], y[j + 1]}});
    add_corners();
  }

  // Cuts a rectangle at x = position or y = position.
  void split(const std::size_t i, const int axis, const double position)
  {
    m_rectangles.push_back(m_rectangles[i]);
    m_rectangles[i].high[axis] = m_rectangles.back().low[axis] = position;
    add_corners();
  }

  void split_randomly(const int number, CGAL::Random& random)
  {
    for (int k = 0; k < number; ++k) {
      const std::size_t i = random.get_int(0, static_cast<int>(m_rectangles.size()));
      const Rectangle& r = m_rectangles[i];
      const int axis = r.high[0] - r.low[0] > r.high[1] - r.low[1] ? 0 : 1;
      const double t = random.get_int(1, 4) / 4.;
      split(i, axis, r.low[axis] + t * (r.high[axis] - r.low[axis]));
    }
  }

  // Other orders and frames of the same T-mesh.
  void set_random_frames(CGAL::Random& random)
  {
    for (std::size_t i = m_rectangles.size() - 1; i > 0; --i)
      std::swap(m_rectangles[i], m_rectangles[random.get_int(0, static_cast<int>(i) + 1)]);
    for (Rectangle& r : m_rectangles) {
      r.turns = random.get_int(0, 4);
      r.unit = random.get_int(1, 100) / 7.;
    }
  }

  const std::vector<Rectangle>& rectangles() const { return m_rectangles; }
  const std::set<Position>& vertices() const { return m_vertices; }
  double period(const int axis) const { return m_high[axis] - m_low[axis]; }

  template <typename FT>
  test_t_meshes::Faces<FT> faces() const
  {
    std::map<std::pair<Position, int>, int> edges; // of its lower left end and its axis
    test_t_meshes::Faces<FT> result;
    for (const Rectangle& r : m_rectangles) {
      result.emplace_back();
      const std::vector<std::vector<Position>> points = boundary(r);
      for (int k = 0; k < 4; ++k) {
        const std::vector<Position>& side = points[(k + r.turns) % 4];
        for (std::size_t i = 0; i + 1 < side.size(); ++i) {
          const Position first = wrapped((std::min)(side[i], side[i + 1]));
          const int edge =
              edges.emplace(std::make_pair(first, (k + r.turns) % 2), static_cast<int>(edges.size())).first->second;
          const double length =
              (std::max)(side[i], side[i + 1])[(k + r.turns) % 2] - (std::min)(side[i], side[i + 1])[(k + r.turns) % 2];
          result.back().push_back({edge, FT(FT(length) * FT(r.unit)), i + 2 == side.size()});
        }
      }
    }
    return result;
  }

  // The sources of the halfedges of face number f, in their order, in the plane.
  std::vector<Position> sources(const std::size_t f) const
  {
    const Rectangle& r = m_rectangles[f];
    const std::vector<std::vector<Position>> points = boundary(r);
    std::vector<Position> result;
    for (int k = 0; k < 4; ++k) {
      const std::vector<Position>& side = points[(k + r.turns) % 4];
      for (std::size_t i = 0; i + 1 < side.size(); ++i)
        result.push_back(wrapped(side[i]));
    }
    return result;
  }

  // A point of the plane in the frame of face number f.
  std::pair<double, double> in_frame(const std::size_t f, const Position& p) const
  {
    const Rectangle& r = m_rectangles[f];
    const double left = (p[0] - r.low[0]) * r.unit, right = (r.high[0] - p[0]) * r.unit,
                 below = (p[1] - r.low[1]) * r.unit, above = (r.high[1] - p[1]) * r.unit;
    switch (r.turns) {
    case 0: return {left, below};
    case 1: return {below, right};
    case 2: return {right, above};
    default: return {above, left};
    }
  }

  std::size_t rectangle_at(const Position& p) const
  {
    std::size_t i = 0;
    while (p[0] < m_rectangles[i].low[0] || p[0] > m_rectangles[i].high[0] || p[1] < m_rectangles[i].low[1] ||
           p[1] > m_rectangles[i].high[1])
      ++i;
    return i;
  }

  // The knots of a vertex along an axis, relative to it: the first two intersections with vertices and orthogonal edges on
  // either side (Sederberg et al. 2003). \pre periodic
  std::array<double, 5> knots(const Position& v, const int axis) const
  {
    std::set<double> distances;
    const double period = this->period(axis), other_period = this->period(1 - axis);
    const auto add = [&](const double x) {
      for (int k = -2; k <= 2; ++k)
        distances.insert(x - v[axis] + k * period);
    };
    for (const Position& w : m_vertices)
      if (w[1 - axis] == v[1 - axis])
        add(w[axis]);
    for (const Rectangle& r : m_rectangles)
      for (int k = -1; k <= 1; ++k) {
        const double y = v[1 - axis] + k * other_period;
        if (r.low[1 - axis] < y && y < r.high[1 - axis]) {
          add(r.low[axis]);
          add(r.high[axis]);
        }
      }
    const auto center = distances.find(0);
    return {*std::prev(center, 2), *std::prev(center), 0, *std::next(center), *std::next(center, 2)};
  }

  // The values of the blending functions of all vertices, those that do not vanish. \pre periodic
  std::map<Position, double> blending_functions(const Position& p) const
  {
    std::map<Position, double> result;
    for (const Position& v : m_vertices) {
      const Reference_b_spline a(knots(v, 0)), b(knots(v, 1));
      double x = 0, y = 0;
      for (int k = -3; k <= 3; ++k) { // two periods on either side, and one between p and v
        x += a(p[0] - v[0] + k * period(0));
        y += b(p[1] - v[1] + k * period(1));
      }
      if (x * y != 0)
        result[v] = x * y;
    }
    return result;
  }

private:
  Position wrapped(Position p) const
  {
    for (int axis = 0; axis < 2 && m_is_periodic; ++axis)
      if (p[axis] >= m_high[axis])
        p[axis] -= period(axis);
    return p;
  }

  void add_corners()
  {
    for (const Rectangle& r : m_rectangles)
      for (const double x : {r.low[0], r.high[0]})
        for (const double y : {r.low[1], r.high[1]})
          m_vertices.insert(wrapped({x, y}));
  }

  // Per side, counter-clockwise from the bottom: the vertices on it, both corners included.
  std::vector<std::vector<Position>> boundary(const Rectangle& r) const
  {
    std::vector<std::vector<Position>> result(4);
    for (int side = 0; side < 4; ++side) {
      const int axis = side % 2, normal = 1 - axis;
      const double level = side == 0 || side == 3 ? r.low[normal] : r.high[normal];
      std::set<double> along;
      for (const Position& v : m_vertices)
        for (int i = 0; i <= (m_is_periodic ? 1 : 0); ++i)
          for (int j = 0; j <= (m_is_periodic ? 1 : 0); ++j) {
            const double x = v[axis] + i * period(axis), y = v[normal] + j * period(normal);
            if (y == level && r.low[axis] <= x && x <= r.high[axis])
              along.insert(x);
          }
      for (const double x : along) {
        Position p;
        p[axis] = x;
        p[normal] = level;
        result[side].push_back(p);
      }
      if (side >= 2)
        std::reverse(result[side].begin(), result[side].end());
    }
    return result;
  }

  Position m_low, m_high;
  bool m_is_periodic;
  std::vector<Rectangle> m_rectangles;
  std::set<Position> m_vertices;
};

} // namespace spline_tests

#endif // T_SPLINES_TEST_SPLINE_PLANAR_T_MESH_H
