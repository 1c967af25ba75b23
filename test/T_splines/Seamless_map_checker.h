// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SEAMLESS_MAP_CHECKER_H
#define T_SPLINES_TEST_SEAMLESS_MAP_CHECKER_H

#include "Plain_map.h"

#include <CGAL/T_splines/Similarity_map/Seamless_map.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// What the checkers compute in.
using Exact = CGAL::Exact_rational;
using Exact_similarity = CGAL::T_splines::Similarity_2<Exact>;
using Exact_point = std::pair<Exact, Exact>;

inline Exact cross_product(const Exact_point& a, const Exact_point& b)
{
  return a.first * b.second - a.second * b.first;
}

inline Exact_point operator-(const Exact_point& a, const Exact_point& b)
{
  return {a.first - b.first, a.second - b.second};
}

template <typename FT>
Exact_similarity exact_similarity(const CGAL::T_splines::Similarity_2<FT>& s)
{
  return {s.quarter_turns(), Exact(s.scale()), Exact(s.u()), Exact(s.v())};
}

/// A seamless map in arrays of exact numbers. Triangle t has the halfedges 3t, 3t + 1, 3t + 2; uv belongs to targets.
struct Exact_map {
  static constexpr int none = -1;

  std::vector<int> target;     ///< vertex
  std::vector<int> opposite;   ///< halfedge, or `none` on the border
  std::vector<Exact_point> uv; ///< per halfedge
  std::vector<int> transition; ///< per halfedge: in `transitions`, or `none` for the identity
  std::vector<Exact_similarity> transitions;
  std::vector<int> quarter_turns;           ///< per vertex
  std::vector<std::array<double, 3>> point; ///< per vertex; may be empty

  int number_of_triangles() const { return static_cast<int>(target.size()) / 3; }
  int number_of_vertices() const { return static_cast<int>(quarter_turns.size()); }

  static int next(const int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(const int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int source(const int h) const { return target[previous(h)]; }

  /// From the chart of the triangle of h to that of its opposite. \pre not on the border
  Exact_similarity transition_of(const int h) const
  {
    return transition[h] == none ? Exact_similarity() : transitions[transition[h]];
  }

  /// Twice the area of a triangle in its chart.
  Exact doubled_area(const int t) const { return cross_product(uv[3 * t + 1] - uv[3 * t], uv[3 * t + 2] - uv[3 * t]); }
};

/// The halfedges of a triangle mesh in the order of an `Exact_map`: per face its halfedge and the next ones.
template <typename TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> ordered_halfedges(const TriangleMesh& mesh)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  for (const auto f : CGAL::make_range(faces(mesh))) {
    auto h = halfedge(f, mesh);
    for (int i = 0; i < 3; ++i, h = next(h, mesh))
      result.push_back(h);
  }
  return result;
}

/// Reads a map through the public interface of `Seamless_map`.
template <typename TriangleMesh, typename FT>
Exact_map exact_map(const CGAL::T_splines::Seamless_map<TriangleMesh, FT>& map)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const TriangleMesh& mesh = map.mesh();
  const auto number = vertex_numbers(mesh);
  const auto halfedges = ordered_halfedges(mesh);
  std::map<halfedge_descriptor, int> index;
  for (const halfedge_descriptor h : halfedges)
    index.emplace(h, static_cast<int>(index.size()));
  Exact_map result;
  for (const halfedge_descriptor h : halfedges) {
    result.target.push_back(number.at(target(h, mesh)));
    const std::pair<FT, FT> uv = map.uv(h);
    result.uv.emplace_back(Exact(uv.first), Exact(uv.second));
    const auto found = index.find(opposite(h, mesh));
    result.opposite.push_back(found == index.end() ? Exact_map::none : found->second);
    result.transition.push_back(Exact_map::none);
    if (found != index.end() && map.is_cut(edge(h, mesh))) {
      result.transition.back() = static_cast<int>(result.transitions.size());
      result.transitions.push_back(exact_similarity(map.transition(h)));
    }
  }
  for (const auto v : CGAL::make_range(vertices(mesh)))
    result.quarter_turns.push_back(map.quarter_turns(v));
  return result;
}

/// The uv of a halfedge map in doubles, in the order of an `Exact_map`.
template <typename TriangleMesh, typename HalfedgeUVMap>
std::vector<std::array<double, 2>> given_corners(const TriangleMesh& mesh, const HalfedgeUVMap uv_map)
{
  std::vector<std::array<double, 2>> result;
  for (const auto h : ordered_halfedges(mesh))
    result.push_back({{CGAL::to_double(get(uv_map, h).x()), CGAL::to_double(get(uv_map, h).y())}});
  return result;
}

/// What a checker found: the first few failures in words.
struct Check_result {
  std::size_t number_of_failures = 0;
  std::vector<std::string> failures;

  bool success() const { return number_of_failures == 0; }

  void fail(const std::string& what, const long element)
  {
    if (number_of_failures++ < 20)
      failures.push_back(what + " " + std::to_string(element));
  }

  std::string failure_text() const
  {
    std::string result;
    for (const std::string& failure : failures)
      result += failure + "\n";
    return result + std::to_string(number_of_failures) + " failures";
  }
};

struct Seamless_map_check : Check_result {
  int triangles = 0, vertices = 0, components = 0, euler_characteristic = 0;
  int cut_edges = 0, scaled_edges = 0, cones = 0;
  double largest_deviation = 0; ///< of a corner from the given uv, by the longest side of its triangle in the chart

  std::string text() const
  {
    std::ostringstream out;
    out << triangles << " triangles, " << components << " components, chi " << euler_characteristic << ", " << cones
        << " cones, " << cut_edges << " cut edges, " << scaled_edges << " of them scaled, deviation "
        << largest_deviation << "\n"
        << failure_text();
    return out.str();
  }
};

/// Judges an exactly seamless map by the definitions of [CZ17] sections 2.1 and 5, in exact arithmetic.
class Seamless_map_checker {
public:
  explicit Seamless_map_checker(const Exact_map& map) : m_map(map) {}

  Seamless_map_check check()
  {
    m_check.triangles = m_map.number_of_triangles();
    m_check.vertices = m_map.number_of_vertices();
    for (int t = 0; t < m_check.triangles; ++t)
      if (m_map.doubled_area(t) <= 0)
        m_check.fail("not positively oriented: triangle", t);
    for (std::size_t h = 0; h < m_map.target.size(); ++h)
      check_edge(static_cast<int>(h));
    m_leaving.assign(m_map.number_of_vertices(), Exact_map::none);
    for (std::size_t h = 0; h < m_map.target.size(); ++h) // on the border: the first of the fan
      if (m_leaving[m_map.source(h)] == Exact_map::none || m_map.opposite[h] == Exact_map::none)
        m_leaving[m_map.source(h)] = static_cast<int>(h);
    m_border_vertices.assign(m_map.number_of_vertices(), 0);
    for (int v = 0; v < m_map.number_of_vertices(); ++v)
      check_vertex(v);
    check_components();
    return m_check;
  }

  /// Whether the cones are the given ones (vertex and k), and no others.
  Seamless_map_check check_cones(const std::vector<std::pair<int, int>>& cones)
  {
    std::vector<int> expected(m_map.number_of_vertices(), 4);
    for (const auto& [v, k] : cones)
      expected.at(v) = k;
    for (int v = 0; v < m_map.number_of_vertices(); ++v)
      if (!m_border_vertices[v] && expected[v] != m_map.quarter_turns[v])
        m_check.fail("k is not as prescribed at vertex", v);
    return m_check;
  }

  /// How far the corners are from given ones. \param tolerance of `largest_deviation`
  Seamless_map_check check_deviation(const std::vector<std::array<double, 2>>& given, const double tolerance)
  {
    for (int t = 0; t < m_map.number_of_triangles(); ++t) {
      double side = 0, deviation = 0;
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const Exact_point e = m_map.uv[h] - m_map.uv[Exact_map::previous(h)];
        const Exact_point d = m_map.uv[h] - Exact_point(given[h][0], given[h][1]);
        side = std::max(side, std::hypot(CGAL::to_double(e.first), CGAL::to_double(e.second)));
        deviation = std::max(deviation, std::hypot(CGAL::to_double(d.first), CGAL::to_double(d.second)));
      }
      m_check.largest_deviation = std::max(m_check.largest_deviation, deviation / side);
      if (!(deviation <= tolerance * side))
        m_check.fail("too far from the given corners: triangle", t);
    }
    return m_check;
  }

private:
  void check_edge(const int h)
  {
    const int g = m_map.opposite[h];
    if (g == Exact_map::none)
      return;
    if (m_map.opposite[g] != h || m_map.target[g] != m_map.source(h)) {
      m_check.fail("opposite is not mutual at halfedge", h);
      return;
    }
    const bool is_cut = m_map.transition[h] != Exact_map::none;
    m_check.cut_edges += is_cut && h < g;
    if (is_cut != (m_map.transition[g] != Exact_map::none))
      m_check.fail("cut on one side only: halfedge", h);
    if (!is_cut) {
      if (m_map.uv[h] != m_map.uv[Exact_map::previous(g)])
        m_check.fail("uv differs, but not cut: halfedge", h);
      return;
    }
    const Exact_similarity s = m_map.transition_of(h);
    m_check.scaled_edges += s.scale() != 1 && h < g;
    if (!compose(s, m_map.transition_of(g)).is_identity())
      m_check.fail("transitions are not inverse at halfedge", h);
    for (const auto& [from, to] :
         {std::make_pair(h, Exact_map::previous(g)), std::make_pair(Exact_map::previous(h), g)})
      if (s(m_map.uv[from].first, m_map.uv[from].second) != m_map.uv[to])
        m_check.fail("the transition misses a corner of halfedge", h);
  }

  // The number of the directions +u, +v, -u, -v in the sector from a to b, counter-clockwise; with a, without b.
  static int directions_in_sector(const Exact_point& a, const Exact_point& b)
  {
    int count = 0;
    for (const auto& [x, y] :
         {std::make_pair(1, 0), std::make_pair(0, 1), std::make_pair(-1, 0), std::make_pair(0, -1)}) {
      const Exact_point d(x, y);
      const CGAL::Sign from_a = CGAL::sign(cross_product(a, d)), to_b = CGAL::sign(cross_product(d, b));
      const bool is_on_a = from_a == CGAL::ZERO && CGAL::sign(a.first * x + a.second * y) == CGAL::POSITIVE;
      count += (from_a == CGAL::POSITIVE || is_on_a) && to_b == CGAL::POSITIVE;
    }
    return count;
  }

  // Counter-clockwise around v by the halfedges that leave it.
  void check_vertex(const int v)
  {
    const int first = m_leaving[v];
    if (first == Exact_map::none) {
      m_check.fail("isolated vertex", v);
      return;
    }
    Exact_similarity around;
    int k = 0, h = first, steps = 0;
    do {
      const int incoming = Exact_map::previous(h);
      const Exact_point& p = m_map.uv[incoming];
      k += directions_in_sector(m_map.uv[h] - p, m_map.uv[Exact_map::next(h)] - p);
      h = m_map.opposite[incoming];
      if (h != Exact_map::none && m_map.transition[incoming] != Exact_map::none)
        around = compose(m_map.transition_of(incoming), around);
    } while (h != Exact_map::none && h != first && ++steps < 3 * m_map.number_of_triangles());
    if (k != m_map.quarter_turns[v])
      m_check.fail(
          "k is " + std::to_string(k) + ", said to be " + std::to_string(m_map.quarter_turns[v]) + ", at vertex", v);
    m_border_vertices[v] = h == Exact_map::none;
    if (m_border_vertices[v])
      return;
    m_check.cones += k != 4;
    const Exact_point& p = m_map.uv[Exact_map::previous(first)];
    if (around.quarter_turns() != (4 - k % 4) % 4 || around.scale() != 1 || around(p.first, p.second) != p)
      m_check.fail("the transitions do not compose to a rotation by k quarter turns about the image of vertex", v);
  }

  void check_components()
  {
    std::vector<int> component(m_map.number_of_triangles(), Exact_map::none), stack;
    std::vector<int> component_of_vertex(m_map.number_of_vertices(), 0);
    for (int t = 0; t < m_map.number_of_triangles(); ++t) {
      if (component[t] != Exact_map::none)
        continue;
      component[t] = m_check.components++;
      stack.push_back(t);
      while (!stack.empty()) {
        const int s = stack.back();
        stack.pop_back();
        for (int h = 3 * s; h < 3 * s + 3; ++h) {
          component_of_vertex[m_map.target[h]] = component[s];
          const int g = m_map.opposite[h];
          if (g != Exact_map::none && component[g / 3] == Exact_map::none) {
            component[g / 3] = component[s];
            stack.push_back(g / 3);
          }
        }
      }
    }
    std::vector<int> doubled_characteristic(m_check.components, 0), defect(m_check.components, 0);
    for (int v = 0; v < m_map.number_of_vertices(); ++v) {
      doubled_characteristic[component_of_vertex[v]] += 2;
      defect[component_of_vertex[v]] += (m_border_vertices[v] ? 2 : 4) - m_map.quarter_turns[v];
    }
    for (std::size_t h = 0; h < m_map.target.size(); ++h)
      doubled_characteristic[component[h / 3]] -= m_map.opposite[h] == Exact_map::none ? 2 : 1;
    for (int t = 0; t < m_map.number_of_triangles(); ++t)
      doubled_characteristic[component[t]] += 2;
    for (int c = 0; c < m_check.components; ++c) {
      m_check.euler_characteristic += doubled_characteristic[c] / 2;
      if (defect[c] != 2 * doubled_characteristic[c])
        m_check.fail("Gauss-Bonnet does not hold in component", c);
    }
  }

  const Exact_map& m_map;
  Seamless_map_check m_check;
  std::vector<int> m_leaving;          // per vertex: a halfedge
  std::vector<char> m_border_vertices; // per vertex
};

#endif // T_SPLINES_TEST_SEAMLESS_MAP_CHECKER_H
