// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVISION_NODES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVISION_NODES_H

#include <CGAL/T_splines/Similarity_map/internal/Edge_crossings.h>
#include <CGAL/T_splines/Similarity_map/internal/Flat_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The nodes of the common subdivision of three triangulations and their places on the input and in the map.
///
/// Nodes are the input's vertices, then the points on edges of the middle triangulation, where these meet edges of the
/// input, of the final triangulation or of both, then those where the two others cross inside of a middle triangle.
/// \tparam FT number type of the construction
template <typename FT>
class Subdivision_nodes {
  static constexpr int none = -1;
  using Vector = Plane_vector<FT>;
  using Kind = Input_place::Kind;

public:
  /// \param points of the input's vertices
  /// \param form xi on the final triangulation, of the halfedge 2e per edge e
  Subdivision_nodes(const Triangulation_connectivity& input, const std::vector<std::array<double, 3>>& points,
                    const Triangulation_connectivity& middle, const Triangulation_connectivity& last,
                    const Input_crossings<FT>& input_crossings, const Final_crossings<FT>& final_crossings,
                    const std::vector<FT>& form, const Flat_layout<FT>& layout)
    : m_input(input),
      m_middle(middle),
      m_last(last),
      m_on_input(input_crossings),
      m_on_final(final_crossings),
      m_form(form),
      m_layout(layout),
      m_point(points),
      m_place(points.size())
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      m_place[v].index = static_cast<int>(v);
    merge_points();
    place_points();
  }

  int size() const { return static_cast<int>(m_point.size()); }
  bool is_vertex(const int node) const { return node < m_input.number_of_vertices(); }
  const std::array<double, 3>& point(const int node) const { return m_point[node]; }

  /// Number of nodes on the middle edge `e`, and the one with the given rank from the source of its even halfedge.
  int number_on_edge(const int e) const { return m_begin[e + 1] - m_begin[e]; }
  int node_on_edge(const int e, const int rank) const { return m_input.number_of_vertices() + m_begin[e] + rank; }
  int number_on_edges() const { return static_cast<int>(m_points.size()); }

  /// Rank on its middle edge of a crossing with the input's (final) edges.
  int rank_of_input(const int crossing) const { return m_rank_of_input[crossing]; }
  int rank_of_final(const int crossing) const { return m_rank_of_final[crossing]; }

  /// Place of a node on a middle edge, from the source of the even halfedge.
  const FT& t(const int node) const { return m_points[node - m_input.number_of_vertices()].t; }

  /// makes the node at `fraction` of the way between two nodes on the input halfedge `on_input`, and at another between
  /// two nodes on the final halfedge `on_final`, which is even.
  void add_crossing(const int on_input, const std::array<int, 2>& input_nodes, const FT& input_fraction,
                    const int on_final, const std::array<int, 2>& final_nodes, const FT& final_fraction)
  {
    const FT s0 = place_on_input_edge(input_nodes[0], on_input, FT(0));
    const FT s1 = place_on_input_edge(input_nodes[1], on_input, FT(1));
    Final_place place{Kind::EDGE, edge_of(on_final), {}};
    add_on_final_edge(final_nodes[0], FT(1 - final_fraction), 0, place.weight);
    add_on_final_edge(final_nodes[1], final_fraction, 1, place.weight);
    add_node(on_input_edge(on_input, FT(s0 + input_fraction * (s1 - s0))), place);
  }

  /// uv of a node that is no vertex, in the chart of the final face that contains it or borders on it.
  std::array<double, 2> uv(const int node, const int face) const
  {
    const Final_place& place = m_final_place[node - m_input.number_of_vertices()];
    if (place.kind == Kind::EDGE)
      return uv_on_edge(place, face);
    CGAL_assertion(place.index == face);
    return uv_in_face(place);
  }

  /// hands over the points and places on the input.
  std::vector<std::array<double, 3>>& points() { return m_point; }
  std::vector<Input_place>& places() { return m_place; }

private:
  // A place on the final triangulation: the sum of weights times the light-like vectors of an edge's or a face's
  // corners. The sum is not normalized: relative to the middle triangle's barycentric coordinates it carries the
  // projective factor.
  struct Final_place {
    Kind kind = Kind::VERTEX;
    int index = 0; // edge e or face
    std::array<FT, 3>
        weight{}; // EDGE: source and target of 2e; FACE: targets of the halfedge of the face and its successors
  };

  // A point on a middle edge: a crossing with the input, with the final triangulation, or with both in the same place.
  struct Edge_point {
    FT t;
    int input, last; // numbers of crossings, or none
  };

  // Merges the points of both families on each middle edge by t. A pair closer than round-off can tell apart becomes
  // one point.
  void merge_points()
  {
    m_begin.assign(1, 0);
    m_rank_of_input.resize(m_on_input.begin(m_middle.number_of_edges()));
    m_rank_of_final.resize(m_on_final.begin(m_middle.number_of_edges()));
    for (int e = 0; e < m_middle.number_of_edges(); ++e) {
      int i = m_on_input.begin(e), j = m_on_final.begin(e);
      const int i_end = m_on_input.begin(e + 1), j_end = m_on_final.begin(e + 1);
      const FT same = i < i_end && j < j_end ? FT(smallest_distance(e)) : FT(0);
      while (i < i_end || j < j_end) {
        const int rank = static_cast<int>(m_points.size()) - m_begin[e];
        const bool has_both = i < i_end && j < j_end;
        const FT difference = has_both ? FT(m_on_input.point(i).t - m_on_final.point(j).t) : FT(i < i_end ? -1 : 1);
        const bool takes_input = i < i_end && (difference <= 0 || (has_both && difference < same));
        const bool takes_final = j < j_end && (difference > 0 || (has_both && -difference < same));
        m_points.push_back({takes_input ? m_on_input.point(i).t : m_on_final.point(j).t, takes_input ? i : none,
                            takes_final ? j : none});
        if (takes_input)
          m_rank_of_input[i++] = rank;
        if (takes_final)
          m_rank_of_final[j++] = rank;
      }
      m_begin.push_back(static_cast<int>(m_points.size()));
    }
  }

  // How close, by t, two points on a middle edge may come: on a small surface far from the origin, the round-off of the
  // coordinates decides.
  double smallest_distance(const int e) const
  {
    constexpr double of_computation = 1e-11, at_most = 1e-7; // round-off of crossings; more would move real nodes
    double square = 0, largest = 0;
    const std::array<double, 3>&p = m_point[m_middle.source(halfedge_of_edge(e))],
                             &q = m_point[m_middle.target(halfedge_of_edge(e))];
    for (int k = 0; k < 3; ++k) {
      square += (q[k] - p[k]) * (q[k] - p[k]);
      largest = std::max(largest, std::max(std::abs(p[k]), std::abs(q[k])));
    }
    const double of_coordinates = 4 * std::numeric_limits<double>::epsilon() * largest;
    return std::max(of_computation,
                    of_coordinates < at_most * std::sqrt(square) ? of_coordinates / std::sqrt(square) : at_most);
  }

  void add_node(const Input_place& place, const Final_place& final_place)
  {
    m_place.push_back(place);
    m_point.push_back(point_at(place));
    m_final_place.push_back(final_place);
  }

  std::array<double, 3> point_at(const Input_place& place) const
  {
    std::array<int, 3> corner{};
    int corners = 2;
    if (place.kind == Kind::EDGE)
      corner = {m_input.source(halfedge_of_edge(place.index)), m_input.target(halfedge_of_edge(place.index)), 0};
    else {
      const int h = m_input.halfedge_of_face(place.index);
      corner = {m_input.target(h), m_input.target(m_input.next(h)), m_input.source(h)};
      corners = 3;
    }
    std::array<double, 3> result{};
    for (int k = 0; k < 3; ++k) { // relative to a corner: exact if the coordinate does not change
      const double base = m_point[corner[0]][k];
      double sum = 0;
      for (int i = 1; i < corners; ++i)
        sum += place.weight[i] * (m_point[corner[i]][k] - base);
      result[k] = base + sum;
    }
    return result;
  }

  void place_points()
  {
    m_place.reserve(m_input.number_of_vertices() + m_points.size());
    m_point.reserve(m_input.number_of_vertices() + m_points.size());
    m_final_place.reserve(m_points.size());
    for (int e = 0; e < m_middle.number_of_edges(); ++e)
      for (int i = m_begin[e]; i < m_begin[e + 1]; ++i)
        add_node(input_place(e, i), final_place(e, i));
  }

  static Input_place on_input_edge(const int h, const FT& s)
  {
    const double at_target = static_cast<double>(s), at_source = static_cast<double>(FT(1 - s));
    Input_place place{Kind::EDGE, edge_of(h), {{at_source, at_target, 0}}};
    if (!is_along_edge(h))
      std::swap(place.weight[0], place.weight[1]);
    return place;
  }

  Input_place input_place(const int e, const int i) const
  {
    const Edge_point& point = m_points[i];
    if (point.input != none)
      return on_input_edge(m_on_input.point(point.input).input_halfedge, m_on_input.point(point.input).s);
    const int shared = m_on_input.input_halfedge(halfedge_of_edge(e));
    if (shared != none)
      return on_input_edge(shared, point.t);
    // Inside an input face, between the last input point before it and the first one behind it.
    int before = i - 1, after = i + 1;
    while (before >= m_begin[e] && m_points[before].input == none)
      --before;
    while (after < m_begin[e + 1] && m_points[after].input == none)
      ++after;
    const bool has_before = before >= m_begin[e], has_after = after < m_begin[e + 1];
    CGAL_assertion(has_before || has_after);
    const int face =
        has_before ? m_input.face(input_halfedge_of(before)) : m_input.face(opposite(input_halfedge_of(after)));
    const FT t0 = has_before ? m_points[before].t : FT(0), t1 = has_after ? m_points[after].t : FT(1);
    const FT mu = t1 > t0 ? FT((point.t - t0) / (t1 - t0)) : FT(0.5);
    std::array<FT, 3> weight{};
    if (has_before)
      add_on_side(m_input, face, input_halfedge_of(before), m_on_input.point(m_points[before].input).s, FT(1 - mu),
                  weight);
    else
      add_apex(m_input, face, opposite(input_halfedge_of(after)), FT(1 - mu), weight);
    if (has_after)
      add_on_side(m_input, face, opposite(input_halfedge_of(after)), FT(1 - m_on_input.point(m_points[after].input).s),
                  mu, weight);
    else
      add_apex(m_input, face, input_halfedge_of(before), mu, weight);
    return {Kind::FACE, face, {{double(weight[0]), double(weight[1]), double(weight[2])}}};
  }

  int input_halfedge_of(const int i) const { return m_on_input.point(m_points[i].input).input_halfedge; }

  // Index of the target of side `h` among the targets of the halfedge of the face and its successors.
  static int corner_index(const Triangulation_connectivity& mesh, const int face, const int h)
  {
    const int first = mesh.halfedge_of_face(face);
    return h == first ? 0 : h == mesh.next(first) ? 1 : 2;
  }

  static void add_on_side(const Triangulation_connectivity& mesh, const int face, const int h, const FT& s,
                          const FT& factor, std::array<FT, 3>& weight)
  {
    weight[corner_index(mesh, face, h)] += factor * s;
    weight[corner_index(mesh, face, mesh.previous(h))] += factor * (1 - s);
  }

  static void add_apex(const Triangulation_connectivity& mesh, const int face, const int h, const FT& factor,
                       std::array<FT, 3>& weight)
  {
    weight[corner_index(mesh, face, mesh.next(h))] += factor;
  }

  Final_place final_place(const int e, const int i) const
  {
    const Edge_point& point = m_points[i];
    if (point.last != none) {
      const auto& crossing = m_on_final.point(point.last);
      return {Kind::EDGE, edge_of(crossing.final_halfedge), {crossing.weight_source, crossing.weight_target, FT(0)}};
    }
    const int shared = m_on_final.final_halfedge(halfedge_of_edge(e));
    if (shared != none) {
      Final_place place{Kind::EDGE, edge_of(shared), {FT(1 - point.t), point.t, FT(0)}};
      if (!is_along_edge(shared))
        std::swap(place.weight[0], place.weight[1]);
      return place;
    }
    // Inside a final face, on the straight piece of the middle edge between two points on final edges or a corner.
    int before = i - 1, after = i + 1;
    while (before >= m_begin[e] && m_points[before].last == none)
      --before;
    while (after < m_begin[e + 1] && m_points[after].last == none)
      ++after;
    const bool has_before = before >= m_begin[e], has_after = after < m_begin[e + 1];
    CGAL_assertion(has_before || has_after);
    // The final halfedge crosses the middle one from its right to its left: the middle one leaves the face of it.
    const int exit = has_after ? final_halfedge_of(after) : none,
              entry = has_before ? opposite(final_halfedge_of(before)) : none;
    const int face = has_before ? m_last.face(entry) : m_last.face(exit);
    const FT t0 = has_before ? m_points[before].t : FT(0), t1 = has_after ? m_points[after].t : FT(1);
    const FT mu = t1 > t0 ? FT((point.t - t0) / (t1 - t0)) : FT(0.5);
    Final_place place{Kind::FACE, face, {}};
    if (has_before)
      add_final_point(face, entry, m_points[before].last, FT(1 - mu), place.weight);
    else
      add_apex(m_last, face, exit, FT(1 - mu), place.weight);
    if (has_after)
      add_final_point(face, exit, m_points[after].last, mu, place.weight);
    else
      add_apex(m_last, face, entry, mu, place.weight);
    return place;
  }

  int final_halfedge_of(const int i) const { return m_on_final.point(m_points[i].last).final_halfedge; }

  void add_final_point(const int face, const int h, const int number, const FT& factor, std::array<FT, 3>& weight) const
  {
    const auto& crossing = m_on_final.point(number);
    weight[corner_index(m_last, face, h)] +=
        factor * (is_along_edge(h) ? crossing.weight_target : crossing.weight_source);
    weight[corner_index(m_last, face, m_last.previous(h))] +=
        factor * (is_along_edge(h) ? crossing.weight_source : crossing.weight_target);
  }

  // Place of a node on the input halfedge on which it lies: 0 at the source; `at_vertex` if the node is a vertex.
  FT place_on_input_edge(const int node, const int halfedge, const FT& at_vertex) const
  {
    if (node < m_input.number_of_vertices())
      return at_vertex;
    const auto& point = m_on_input.point(m_points[node - m_input.number_of_vertices()].input);
    return point.input_halfedge == halfedge ? point.s : FT(1 - point.s);
  }

  // Adds a node of a final edge, a vertex being its source (end = 0) or target (end = 1).
  void add_on_final_edge(const int node, const FT& factor, const int end, std::array<FT, 3>& weight) const
  {
    if (node < m_input.number_of_vertices()) {
      weight[end] += factor;
      return;
    }
    const auto& point = m_on_final.point(m_points[node - m_input.number_of_vertices()].last);
    weight[0] += factor * point.weight_source;
    weight[1] += factor * point.weight_target;
  }

  std::array<double, 2> uv_on_edge(const Final_place& place, const int face) const
  {
    using std::exp;
    // The even halfedge, if it lies in the face, or if both sides have the same chart: then all computations are the
    // same on both.
    const int even = halfedge_of_edge(place.index);
    const bool use_even = m_last.face(even) == face || !m_layout.is_cut(place.index);
    const int h = use_even ? even : even + 1;
    const Vector source = m_layout.position(m_last.previous(h)), target = m_layout.position(h);
    const FT at_target = (use_even ? place.weight[1] : place.weight[0]) *
                         exp(FT(use_even ? FT(-m_form[place.index]) : m_form[place.index]));
    const FT at_source = use_even ? place.weight[0] : place.weight[1];
    return Flat_layout<FT>::to_double(source + (target - source) * FT(at_target / (at_source + at_target)));
  }

  std::array<double, 2> uv_in_face(const Final_place& place) const
  {
    using std::exp;
    const int h = m_last.halfedge_of_face(place.index), j = m_last.next(h), k = m_last.next(j);
    const auto form = [&](const int g) { return is_along_edge(g) ? m_form[edge_of(g)] : FT(-m_form[edge_of(g)]); };
    const FT w0 = place.weight[0], w1 = place.weight[1] * exp(FT(-form(j))), w2 = place.weight[2] * exp(FT(form(h)));
    const Vector base = m_layout.position(h);
    const FT sum = w0 + w1 + w2;
    return Flat_layout<FT>::to_double(base + (m_layout.position(j) - base) * FT(w1 / sum) +
                                      (m_layout.position(k) - base) * FT(w2 / sum));
  }

  const Triangulation_connectivity &m_input, &m_middle, &m_last;
  const Input_crossings<FT>& m_on_input;
  const Final_crossings<FT>& m_on_final;
  const std::vector<FT>& m_form;
  const Flat_layout<FT>& m_layout;

  std::vector<std::array<double, 3>> m_point; // per node
  std::vector<Input_place> m_place;           // per node
  std::vector<Final_place> m_final_place;     // per node that is no vertex
  std::vector<int> m_begin;                   // per middle edge, in m_points
  std::vector<Edge_point> m_points;
  std::vector<int> m_rank_of_input, m_rank_of_final; // per crossing: rank on its middle edge
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVISION_NODES_H
