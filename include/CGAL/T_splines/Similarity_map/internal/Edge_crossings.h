// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EDGE_CROSSINGS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EDGE_CROSSINGS_H

#include <CGAL/T_splines/Similarity_map/internal/Flat_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Normal_coordinates.h>
#include <CGAL/T_splines/Similarity_map/internal/Subdivided_part.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A part of a curve that runs straight through a triangle. Its ends are slots on the triangle's boundary: slot i of
/// halfedge h is the source of h if i = 0, else the (i-1)-th point on h, counted from the source.
struct Triangle_chord {
  int halfedge_from, slot_from, halfedge_to, slot_to;
  int curve; ///< the halfedge of the other triangulation, directed like the chord
};

/// The halfedges of a triangulation by source and number around it, as `Normal_coordinates` counts them.
class Halfedge_by_number {
public:
  explicit Halfedge_by_number(const Triangulation_connectivity& mesh)
    : m_begin(mesh.number_of_vertices() + 1, 0),
      m_halfedge(mesh.number_of_halfedges())
  {
    const std::vector<int> outgoing = mesh.outgoing_halfedges();
    int count = 0;
    for (int v = 0; v < mesh.number_of_vertices(); ++v) {
      m_begin[v] = count;
      int h = outgoing[v];
      if (h == Triangulation_connectivity::null)
        continue;
      do {
        m_halfedge[count++] = h;
        h = mesh.next_around_source(h);
      } while (h != outgoing[v]);
    }
  }

  int operator()(const int vertex, const int number) const { return m_halfedge[m_begin[vertex] + number]; }

private:
  std::vector<int> m_begin, m_halfedge;
};

/// Where the edges of the input triangulation cross those of its intrinsic Delaunay triangulation, the *middle* one.
/// Both are straight in the same Euclidean triangles.
/// \tparam FT a floating-point type
template <typename FT>
class Input_crossings {
public:
  struct Point {
    FT t;               ///< place on the middle edge e: 0 at the source of halfedge 2e, 1 at the target
    FT s;               ///< place on the input edge: 0 at the source of `input_halfedge`, 1 at its target
    int input_halfedge; ///< whose face the halfedge 2e enters there
  };

  /// A maximal run of an input edge over the middle triangulation, from end to end.
  struct Curve {
    int input_halfedge;
    int first_corner, last_corner; ///< middle halfedges: the curve starts (ends) at their sources
    std::vector<int> exits;        ///< middle halfedges by which it leaves the triangles
    std::vector<int> points;       ///< point numbers
  };

  /// \param coordinates of the input edges on the middle triangulation; empty if the two are the same
  /// \param length of the input's edges
  /// \param part what is looked at: middle edges that are not have no points, input edges no curves
  /// \param progress if it is interrupted, the crossings may not be used
  Input_crossings(const Triangulation_connectivity& input, const Triangulation_connectivity& middle,
                  const Normal_coordinates& coordinates, const std::vector<FT>& length, const Subdivided_part& part,
                  Progress& progress)
    : m_begin(middle.number_of_edges() + 1, 0),
      m_input_of_middle(middle.number_of_halfedges(), Triangulation_connectivity::null)
  {
    if (coordinates.is_empty()) {
      for (int h = 0; h < middle.number_of_halfedges(); ++h)
        m_input_of_middle[h] = h;
      return;
    }
    for (int e = 0; e < middle.number_of_edges(); ++e)
      m_begin[e + 1] =
          m_begin[e] + (part.has_middle_edge(e) ? static_cast<int>(coordinates.number_of_crossings(e)) : 0);
    m_points.resize(m_begin.back());
    trace(input, middle, coordinates, part);
    for (int e = 0; e < middle.number_of_edges(); ++e)
      if (m_begin[e] != m_begin[e + 1] && progress.go_on_after(10 * (m_begin[e + 1] - m_begin[e])))
        locate(input, length, e);
  }

  /// The points on middle edge e, in the order of t: numbers begin(e) to begin(e + 1) - 1.
  int begin(const int e) const { return m_begin[e]; }
  const Point& point(const int i) const { return m_points[i]; }
  const std::vector<Curve>& curves() const { return m_curves; }

  /// The input halfedge that the middle halfedge `h` coincides with, or `null`.
  int input_halfedge(const int h) const { return m_input_of_middle[h]; }

private:
  void trace(const Triangulation_connectivity& input, const Triangulation_connectivity& middle,
             const Normal_coordinates& coordinates, const Subdivided_part& part)
  {
    const Halfedge_by_number input_halfedge(input);
    coordinates.for_each_reference_halfedge(
        middle,
        [&](const int v, const int k, const Normal_coordinates::Curve& traced) {
          const int h = input_halfedge(v, k);
          if (!is_along_edge(h))
            return;
          Curve curve{h, traced.first_corner, traced.last_corner, {}, {}};
          for (const Normal_coordinates::Crossing& crossing : traced.crossings) {
            const int exit = crossing.halfedge, e = edge_of(exit);
            if (!part.has_middle_edge(e)) // the input edge is on the second sheet
              continue;
            const int from_source = static_cast<int>(crossing.position);
            const int i = is_along_edge(exit) ? m_begin[e] + from_source : m_begin[e + 1] - 1 - from_source;
            // The curve leaves by `exit` to its right: `exit` crosses the curve from its right to its left, into the
            // face of h.
            m_points[i].input_halfedge = is_along_edge(exit) ? h : opposite(h);
            curve.exits.push_back(exit);
            curve.points.push_back(i);
          }
          if (part.has_input_edge(edge_of(h)))
            m_curves.push_back(std::move(curve));
        },
        [&](const int v, const int k, const int h) { m_input_of_middle[h] = input_halfedge(v, k); });
  }

  // Unfolds the input triangles that middle edge e runs through and intersects.
  void locate(const Triangulation_connectivity& input, const std::vector<FT>& length, const int e)
  {
    using Vector = Plane_vector<FT>;
    const int begin = m_begin[e], end = m_begin[e + 1];
    const auto apex = [&](const int h, const Vector& source, const Vector& target) {
      const FT c = length[edge_of(h)], a = length[edge_of(input.next(h))] / c,
               b = length[edge_of(input.previous(h))] / c;
      const FT along = (1 + (a - b) * (a + b)) / 2;
      const FT product = ((1 + (a + b)) * (1 + (a - b))) * ((a + b) - 1) * (1 - (a - b));
      using std::sqrt;
      const FT across = product > 0 ? FT(sqrt(product) / 2) : FT(0);
      const Vector back = source - target;
      return target + back * along + back.turned(3) * across;
    };
    std::vector<Vector> sources, targets;
    int h = m_points[begin].input_halfedge;
    Vector source{}, target{length[edge_of(h)], FT(0)};
    const Vector a = apex(opposite(h), target, source);
    Vector b;
    for (int i = begin; i < end; ++i) {
      sources.push_back(source);
      targets.push_back(target);
      b = apex(h, source, target);
      if (i + 1 == end)
        break;
      const int following = opposite(m_points[i + 1].input_halfedge); // a side of the face of h
      CGAL_assertion(following == input.next(h) || following == input.previous(h));
      if (following == input.next(h)) // from the target of h to the apex
        source = b;
      else
        target = b;
      h = opposite(following);
    }
    const Vector ab = b - a;
    for (int i = begin; i < end; ++i) {
      const Vector p = sources[i - begin] - a, q = targets[i - begin] - a, pq = q - p;
      const FT at_p = ab.cross(p), at_q = ab.cross(q);
      m_points[i].s = inside(at_p / (at_p - at_q));
      m_points[i].t = inside(p.cross(pq) / ab.cross(pq));
    }
    for (int i = begin + 1; i < end; ++i) // round-off must not exchange points
      m_points[i].t = std::max(m_points[i].t, m_points[i - 1].t);
  }

  // Keeps round-off from leaving [0, 1].
  static FT inside(const FT& x) { return x > 0 ? (x < 1 ? x : FT(1)) : FT(0); }

  std::vector<int> m_begin;
  std::vector<Point> m_points;
  std::vector<Curve> m_curves;
  std::vector<int> m_input_of_middle;
};

/// Where the edges of the final triangulation cross those of the middle one: both are geodesics of the ideal hyperbolic
/// metric that Penner's coordinates define, straight in each other's triangles in the Klein model whose horizon is the
/// circumcircle.
///
/// With a light-like vector for each corner, of products -l^2/2 with each other, an edge's points are the positive
/// combinations of its ends. If a-b crosses c-d, the point has on c-d the weights l_ad l_bd : l_ac l_bc, and on a-b
/// l_bc l_bd : l_ac l_ad. The lengths from a and b to the vertices along the strip follow by Ptolemy's formula, by sums
/// and products of positive numbers only: each crossing has nearly full relative accuracy. Everything is kept in
/// logarithms.
/// \tparam FT a floating-point type
template <typename FT>
class Final_crossings {
public:
  static constexpr int none = -1;

  struct Point {
    FT t; ///< place on the middle edge e, in the Euclidean metric: 0 at the source of halfedge 2e, 1 at the target
    int final_halfedge;              ///< it crosses the halfedge 2e from its right to its left
    FT weight_source, weight_target; ///< of the ends of the final edge, for the point with 1 - t, t on the middle edge
  };

  /// \param coordinates of the middle edges on the final triangulation
  /// \param log_length Penner's coordinates on the final triangulation
  /// \param part what is looked at: other middle and final edges have no points
  /// \param progress if it is interrupted, the crossings may not be used
  Final_crossings(const Triangulation_connectivity& middle, const Triangulation_connectivity& last,
                  const Normal_coordinates& coordinates, const std::vector<FT>& log_length, const Subdivided_part& part,
                  Progress& progress)
    : m_begin(middle.number_of_edges() + 1, 0),
      m_begin_on_final(last.number_of_edges() + 1, 0),
      m_final_of_middle(middle.number_of_halfedges(), Triangulation_connectivity::null),
      m_corner(middle.number_of_halfedges(), Triangulation_connectivity::null)
  {
    for (int e = 0; e < last.number_of_edges(); ++e)
      m_begin_on_final[e + 1] =
          m_begin_on_final[e] + (part.has_final_edge(e) ? static_cast<int>(coordinates.number_of_crossings(e)) : 0);
    m_point_on_final.resize(m_begin_on_final.back(), none);
    const Halfedge_by_number middle_halfedge(middle);
    std::vector<int> number_of_points(middle.number_of_edges(), 0);
    const auto shared = [&](const int v, const int k, const int h) {
      m_final_of_middle[middle_halfedge(v, k)] = h;
      m_corner[middle_halfedge(v, k)] = h;
    };
    const auto is_wanted = [&](const int h) { return part.has_final_face(last.face(h)); };
    coordinates.for_each_reference_halfedge(
        last,
        [&](const int v, const int k, const Normal_coordinates::Curve& curve) {
          const int h = middle_halfedge(v, k);
          m_corner[h] = curve.first_corner;
          if (part.has_middle_edge(edge_of(h)))
            number_of_points[edge_of(h)] = static_cast<int>(curve.crossings.size());
        },
        shared, is_wanted);
    for (int e = 0; e < middle.number_of_edges(); ++e)
      m_begin[e + 1] = m_begin[e] + number_of_points[e];
    m_points.resize(m_begin.back());
    m_middle_edge.resize(m_points.size());
    coordinates.for_each_reference_halfedge(
        last,
        [&](const int v, const int k, const Normal_coordinates::Curve& curve) {
          const int h = middle_halfedge(v, k);
          if (is_along_edge(h) && part.has_middle_edge(edge_of(h)) && progress.go_on_after(20 * curve.crossings.size()))
            locate(last, log_length, edge_of(h), curve);
        },
        [](int, int, int) {}, is_wanted);
  }

  /// The points on middle edge e, in the order of t: numbers begin(e) to begin(e + 1) - 1.
  int begin(const int e) const { return m_begin[e]; }
  const Point& point(const int i) const { return m_points[i]; }
  int middle_edge(const int i) const { return m_middle_edge[i]; }

  /// The points on the final edge e, from the source of 2e: numbers `point_on_final(i)`, i from begin_on_final(e) to
  /// begin_on_final(e + 1) - 1; `none` where it crosses a middle edge that is not looked at.
  int begin_on_final(const int e) const { return m_begin_on_final[e]; }
  int point_on_final(const int i) const { return m_point_on_final[i]; }

  /// The final halfedge that the middle halfedge `h` coincides with, or `null`.
  int final_halfedge(const int h) const { return m_final_of_middle[h]; }

  /// The corner of the final triangulation, as the halfedge that leaves it, in which the sector to the left of the
  /// middle halfedge `h` starts.
  int corner(const int h) const { return m_corner[h]; }

private:
  static FT log_of_sum(const FT& x, const FT& y)
  {
    using std::exp;
    using std::log1p;
    return x > y ? FT(x + log1p(exp(FT(y - x)))) : FT(y + log1p(exp(FT(x - y))));
  }

  // Fills m_log_source and m_log_target: log-lengths from the end of the curve to the ends of the edges it crosses.
  void lengths_from_end(const Triangulation_connectivity& last, const std::vector<FT>& lambda,
                        const std::vector<int>& exits, std::vector<FT>& log_source, std::vector<FT>& log_target) const
  {
    log_source.resize(exits.size());
    log_target.resize(exits.size());
    FT to_source = lambda[edge_of(last.previous(exits[0]))], to_target = lambda[edge_of(last.next(exits[0]))];
    for (std::size_t i = 0;; ++i) {
      log_source[i] = to_source;
      log_target[i] = to_target;
      if (i + 1 == exits.size())
        return;
      const int entry = opposite(exits[i]);
      // from the source of `exits[i]` to the apex: next(entry); from there to its target: previous(entry)
      const FT to_apex = log_of_sum(FT(lambda[edge_of(last.previous(entry))] + to_source),
                                    FT(lambda[edge_of(last.next(entry))] + to_target)) -
                         lambda[edge_of(entry)];
      if (exits[i + 1] == last.next(entry))
        to_target = to_apex;
      else
        to_source = to_apex;
    }
  }

  void locate(const Triangulation_connectivity& last, const std::vector<FT>& lambda, const int e,
              const Normal_coordinates::Curve& curve)
  {
    using std::exp;
    const std::size_t n = curve.crossings.size();
    m_exits.clear();
    m_reverse_exits.clear();
    for (const Normal_coordinates::Crossing& crossing : curve.crossings)
      m_exits.push_back(crossing.halfedge);
    for (std::size_t i = n; i-- > 0;)
      m_reverse_exits.push_back(opposite(m_exits[i]));
    lengths_from_end(last, lambda, m_exits, m_a_source, m_a_target);
    lengths_from_end(last, lambda, m_reverse_exits, m_b_target, m_b_source);
    // a to b: over the first edge crossed, to the vertex b behind the last one
    const FT a_b = log_of_sum(FT(m_a_source[0] + m_b_target[n - 1]), FT(m_a_target[0] + m_b_source[n - 1])) -
                   lambda[edge_of(m_exits[0])];
    for (std::size_t i = 0; i < n; ++i) {
      const int exit = m_exits[i], edge = edge_of(exit);
      const FT a_c = m_a_source[i], a_d = m_a_target[i], b_c = m_b_source[n - 1 - i], b_d = m_b_target[n - 1 - i];
      const FT weight_a = b_c + b_d, weight_b = a_c + a_d; // logarithms, up to a common summand
      const FT sum = log_of_sum(weight_a, weight_b);
      const FT unit = a_b - sum - lambda[edge];
      const FT weight_c = exp(FT(unit + a_d + b_d)), weight_d = exp(FT(unit + a_c + b_c));
      const int number = m_begin[e] + static_cast<int>(i);
      Point& point = m_points[number];
      point.t = exp(FT(weight_b - sum));
      point.final_halfedge = exit;
      point.weight_source = is_along_edge(exit) ? weight_c : weight_d;
      point.weight_target = is_along_edge(exit) ? weight_d : weight_c;
      m_middle_edge[number] = e;
      const int from_source = static_cast<int>(curve.crossings[i].position);
      m_point_on_final[is_along_edge(exit) ? m_begin_on_final[edge] + from_source
                                           : m_begin_on_final[edge + 1] - 1 - from_source] = number;
    }
    for (int i = m_begin[e] + 1; i < m_begin[e + 1]; ++i)
      m_points[i].t = std::max(m_points[i].t, m_points[i - 1].t);
  }

  std::vector<int> m_begin, m_begin_on_final;
  std::vector<Point> m_points;
  std::vector<int> m_point_on_final, m_middle_edge;
  std::vector<int> m_final_of_middle, m_corner;
  std::vector<int> m_exits, m_reverse_exits;
  std::vector<FT> m_a_source, m_a_target, m_b_source, m_b_target;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_EDGE_CROSSINGS_H
