// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Closest points of a mesh: the package's tree of boxes against CGAL's AABB tree.

#include "measurement.h"

#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/Spline/internal/closest_of_triangle.h>
#include <CGAL/T_splines/internal/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace I = CGAL::T_splines::internal;
using Kernel = I::Triangle_set::Kernel;
using Point_3 = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Aabb_tree = CGAL::AABB_tree<I::AABB_traits_for_3<Kernel, Primitive>>;

const char* const usage =
    "Usage: box_tree_speed\n\n"
    "Prints, for a torus of 100352 triangles with bumps and points near it, in the order of a walk and at random:\n"
    "CPU seconds of the construction of the trees, microseconds per query of the closest point and of whether there\n"
    "is a triangle within a small distance, and their ratios to the first line.\n";

/// A point of a torus with bumps, at a height above it.
Point_3 torus_point(const double u, const double v, const double height)
{
  const double r = 0.4 + 0.02 * std::sin(40 * u) * std::cos(30 * v) + height;
  return Point_3((1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
}

I::Triangle_set torus(const std::size_t n)
{
  const double step = 8 * std::atan(1.) / static_cast<double>(n);
  I::Triangle_set result;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      result.points.push_back(torus_point(static_cast<double>(i) * step, static_cast<double>(j) * step, 0));
      const auto at = [n](const std::size_t a, const std::size_t b) { return n * (a % n) + b % n; };
      result.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      result.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return result;
}

/// `Box_tree::for_each_closer()` as a traversal of CGAL's tree: the closer child first, those that are too far not at all.
struct Closest_traversal {
  using Priority = double;

  const Triangles& triangles;
  double squared_distance = (std::numeric_limits<double>::infinity)();
  std::size_t triangle = 0;

  bool go_further() const { return true; }

  void intersection(const Point_3& p, const Primitive& primitive)
  {
    offer(p, static_cast<std::size_t>(primitive.id() - triangles.begin()));
  }

  void offer(const Point_3& p, const std::size_t i)
  {
    const double d = CGAL::squared_distance(p, I::closest_of_triangle(p, triangles[i]).point);
    if (d < squared_distance) {
      squared_distance = d;
      triangle = i;
    }
  }

  template <typename Node>
  std::pair<bool, Priority> do_intersect_with_priority(const Point_3& p, const Node& node) const
  {
    const CGAL::Bbox_3& box = node.bbox();
    double result = 0;
    for (int k = 0; k < 3; ++k) {
      const double outside = std::max(box.min(k) - p[k], p[k] - box.max(k));
      result += outside > 0 ? outside * outside : 0;
    }
    return {result < squared_distance, -result};
  }

  template <typename Node>
  bool do_intersect(const Point_3& p, const Node& node) const
  {
    return do_intersect_with_priority(p, node).first;
  }
};

class Comparison {
public:
  Comparison(const I::Triangle_set& set, const Triangles& triangles)
    : m_set(set),
      m_triangles(triangles),
      m_tree(set),
      m_aabb_tree(triangles.begin(), triangles.end())
  {
    m_aabb_tree.build();
  }

  void measure_construction() const
  {
    m_baseline = best_cpu_seconds(3, [&] { const I::Triangle_tree tree(m_set); });
    print("Box_tree: construction", m_baseline, 1);
    print("AABB_tree: construction",
          best_cpu_seconds(3,
                           [&] {
                             Aabb_tree tree(m_triangles.begin(), m_triangles.end());
                             tree.build();
                           }),
          1);
  }

  void measure_queries(const std::vector<Point_3>& points, const std::string& order)
  {
    const double n = 1e-6 * static_cast<double>(points.size());
    double sum = 0;
    const auto measured = [&](const auto& distance_at) {
      return best_cpu_seconds(3, [&] {
        sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
          sum += distance_at(points[i]);
      });
    };
    const auto row = [&](const std::string& name, const auto& distance_at) {
      const double seconds = measured(distance_at);
      if (name == "Box_tree")
        m_baseline = seconds;
      print(name + ", " + order, seconds, n, sum);
    };
    std::size_t hint = 0;
    row("Box_tree", [&](const Point_3& p) { return m_tree.foot(p).distance(); });
    row("Box_tree with the last triangle", [&](const Point_3& p) {
      const auto foot = m_tree.foot(p, hint);
      hint = foot.triangle;
      return foot.distance();
    });
    row("AABB_tree, with priority", [&](const Point_3& p) { return traverse(p, nullptr); });
    row("AABB_tree, with priority and the last triangle", [&](const Point_3& p) { return traverse(p, &hint); });
    m_aabb_tree.do_not_accelerate_distance_queries();
    auto last = m_aabb_tree.any_reference_point_and_id();
    row("AABB_tree::closest_point() with the last triangle", [&](const Point_3& p) {
      last = m_aabb_tree.closest_point_and_primitive(p, last);
      return std::sqrt(CGAL::squared_distance(p, last.first));
    });
    m_aabb_tree.accelerate_distance_queries();
    row("AABB_tree::closest_point() with the tree of points",
        [&](const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, m_aabb_tree.closest_point(p))); });
  }

  void measure_overlaps(const std::vector<Point_3>& points, const double radius)
  {
    const double n = 1e-6 * static_cast<double>(points.size());
    double number = 0;
    m_baseline = best_cpu_seconds(3, [&] {
      number = 0;
      for (const Point_3& p : points)
        m_tree.is_true_near(p, radius, [&](std::size_t) { return ++number > 0; });
    });
    print("Box_tree: boxes within a distance", m_baseline, n, number);
    const double seconds = best_cpu_seconds(3, [&] {
      number = 0;
      for (const Point_3& p : points) {
        Near_traversal traversal{p, radius * radius, number};
        m_aabb_tree.traversal(p, traversal);
      }
    });
    print("AABB_tree: boxes within a distance", seconds, n, number);
  }

private:
  struct Near_traversal {
    Point_3 p;
    double squared_radius;
    double& number;

    bool go_further() const { return true; }
    void intersection(const Point_3&, const Primitive& primitive)
    {
      number += is_near(primitive.datum().bbox()) ? 1 : 0;
    }
    template <typename Node>
    bool do_intersect(const Point_3&, const Node& node) const
    {
      return is_near(node.bbox());
    }
    bool is_near(const CGAL::Bbox_3& box) const
    {
      double result = 0;
      for (int k = 0; k < 3; ++k) {
        const double outside = std::max(box.min(k) - p[k], p[k] - box.max(k));
        result += outside > 0 ? outside * outside : 0;
      }
      return result < squared_radius;
    }
  };

  double traverse(const Point_3& p, std::size_t* hint) const
  {
    Closest_traversal traversal{m_triangles};
    if (hint != nullptr)
      traversal.offer(p, *hint);
    m_aabb_tree.traversal_with_priority(p, traversal);
    if (hint != nullptr)
      *hint = traversal.triangle;
    return std::sqrt(traversal.squared_distance);
  }

  void print(const std::string& name, const double seconds, const double unit, const double sum = 0) const
  {
    std::printf("%-62s %10.4f %8.2f   %.9g\n", name.c_str(), seconds / unit, seconds / m_baseline, sum);
  }

  const I::Triangle_set& m_set;
  const Triangles& m_triangles;
  I::Triangle_tree m_tree;
  Aabb_tree m_aabb_tree;
  mutable double m_baseline = 1;
};

} // namespace

int main(const int argc, char** argv)
{
  if (argc > 1) {
    std::cout << usage;
    return std::string(argv[1]) == "--help" ? EXIT_SUCCESS : 2;
  }
  const I::Triangle_set set = torus(224);
  Triangles triangles;
  for (std::size_t i = 0; i < set.triangles.size(); ++i)
    triangles.push_back(set.triangle(i));
  CGAL::Random random(1);
  std::vector<Point_3> points;
  constexpr int number = 400;
  for (int i = 0; i < number; ++i)
    for (int j = 0; j < number; ++j)
      points.push_back(torus_point(8 * std::atan(1.) * i / number, 8 * std::atan(1.) * j / number,
                                   random.get_double(-0.002, 0.002)));
  std::printf("%-62s %10s %8s   %s\n", "", "seconds", "ratio", "sum");
  Comparison comparison(set, triangles);
  comparison.measure_construction();
  std::printf("%-62s %10s\n", "", "us / query");
  comparison.measure_queries(points, "walk");
  comparison.measure_overlaps(points, 0.005);
  std::vector<Point_3> shuffled = points;
  for (std::size_t i = shuffled.size() - 1; i > 0; --i)
    std::swap(shuffled[i], shuffled[static_cast<std::size_t>(random.get_int(0, static_cast<int>(i) + 1))]);
  comparison.measure_queries(shuffled, "random");
}
