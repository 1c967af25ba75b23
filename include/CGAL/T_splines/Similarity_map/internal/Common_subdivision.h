// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_COMMON_SUBDIVISION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_COMMON_SUBDIVISION_H

#include <CGAL/T_splines/Similarity_map/internal/Chord_arrangement.h>
#include <CGAL/T_splines/Similarity_map/internal/Edge_crossings.h>
#include <CGAL/T_splines/Similarity_map/internal/Flat_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/Similarity_map/internal/Convex_cell.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The common subdivision of the input triangulation, its intrinsic Delaunay triangulation (the middle one) and the final triangulation.
///
/// Inside a middle triangle, the edges of both others are straight: an arrangement of chords. Each of its cells is convex on the
/// surface and in the plane of the map; it is triangulated.
/// \tparam FT number type of the construction
template <typename FT>
class Common_subdivision {
  static constexpr int none = -1;
  using Vector = Plane_vector<FT>;
  using Kind = Input_place::Kind;

public:
  /// \param points of the input's vertices
  /// \param form xi on the final triangulation, of the halfedge 2e per edge e
  Common_subdivision(const Triangulation_connectivity& input, const std::vector<std::array<double, 3>>& points,
                     const Triangulation_connectivity& middle, const Triangulation_connectivity& last,
                     const Input_crossings<FT>& input_crossings, const Final_crossings<FT>& final_crossings,
                     const std::vector<FT>& form, const Flat_layout<FT>& layout)
    : m_input(input), m_middle(middle), m_last(last), m_on_input(input_crossings), m_on_final(final_crossings), m_form(form), m_layout(layout)
  {
    m_result.point = points;
    m_result.place.resize(points.size());
    for (std::size_t v = 0; v < points.size(); ++v)
      m_result.place[v].index = static_cast<int>(v);
    merge_points();
    place_points();
    collect_chords();
    // On a closed surface, each added vertex adds two triangles; crossings inside of middle triangles come on top.
    m_triangles.reserve(middle.number_of_faces() + 2 * m_points.size());
    for (int f = 0; f < middle.number_of_faces(); ++f)
      subdivide(f);
    release_intermediate_results();
    connect();
  }

  Refined_triangulation& result() { return m_result; }

private:
  // A place on the final triangulation: the sum of weights times the light-like vectors of an edge's or a face's corners.
  // The sum is not normalized: relative to the middle triangle's barycentric coordinates it carries the projective factor.
  struct Final_place {
    Kind kind = Kind::VERTEX;
    int index = 0;              // edge e or face
    std::array<FT, 3> weight{}; // EDGE: source and target of 2e; FACE: targets of the halfedge of the face and its successors
  };

  void release_intermediate_results()
  {
    m_points = {};
    m_final_place = {};
    m_rank_of_input = m_rank_of_final = m_first_begin = m_second_begin = {};
    m_first_chords = m_second_chords = {};
  }

  // A point on a middle edge: a crossing with the input, with the final triangulation, or with both in the same place.
  struct Edge_point {
    FT t;
    int input, last; // numbers of crossings, or none
  };

  struct Triangle {
    std::array<int, 3> node;
    std::array<std::array<double, 2>, 3> uv;  // of the nodes
    std::array<int, 3> input_halfedge, final_halfedge; // of the side from node i to node i + 1
    int input_face;
  };

  int number_of_input_vertices() const { return m_input.number_of_vertices(); }

  // Merges the points of both families on each middle edge by t. A pair closer than round-off can tell apart becomes one point.
  void merge_points()
  {
    m_begin.assign(1, 0);
    m_rank_of_input.resize(m_on_input.begin(m_middle.number_of_edges()));
    m_rank_of_final.resize(m_on_final.begin(m_middle.number_of_edges()));
    for (int e = 0; e < m_middle.number_of_edges(); ++e) {
      const FT same = smallest_distance(e);
      int i = m_on_input.begin(e), j = m_on_final.begin(e);
      const int i_end = m_on_input.begin(e + 1), j_end = m_on_final.begin(e + 1);
      while (i < i_end || j < j_end) {
        const int rank = static_cast<int>(m_points.size()) - m_begin[e];
        const bool has_both = i < i_end && j < j_end;
        const FT difference = has_both ? FT(m_on_input.point(i).t - m_on_final.point(j).t) : FT(i < i_end ? -1 : 1);
        const bool takes_input = i < i_end && (difference <= 0 || (has_both && difference < same));
        const bool takes_final = j < j_end && (difference > 0 || (has_both && -difference < same));
        m_points.push_back({takes_input ? m_on_input.point(i).t : m_on_final.point(j).t, takes_input ? i : none, takes_final ? j : none});
        if (takes_input)
          m_rank_of_input[i++] = rank;
        if (takes_final)
          m_rank_of_final[j++] = rank;
      }
      m_begin.push_back(static_cast<int>(m_points.size()));
    }
  }

  // How close, by t, two points on a middle edge may come: on a small surface far from the origin, the round-off of the coordinates decides.
  double smallest_distance(const int e) const
  {
    constexpr double of_computation = 1e-11, at_most = 1e-7;
    double square = 0, largest = 0;
    const std::array<double, 3>&p = m_result.point[m_middle.source(2 * e)], &q = m_result.point[m_middle.target(2 * e)];
    for (int k = 0; k < 3; ++k) {
      square += (q[k] - p[k]) * (q[k] - p[k]);
      largest = std::max(largest, std::max(std::abs(p[k]), std::abs(q[k])));
    }
    const double of_coordinates = 4 * std::numeric_limits<double>::epsilon() * largest;
    return std::max(of_computation, of_coordinates < at_most * std::sqrt(square) ? of_coordinates / std::sqrt(square) : at_most);
  }

  int node_of_point(const int i) const { return number_of_input_vertices() + i; }

  void add_node(const Input_place& place, const Final_place& final_place)
  {
    m_result.place.push_back(place);
    m_result.point.push_back(point_at(place));
    m_final_place.push_back(final_place);
  }

  std::array<double, 3> point_at(const Input_place& place) const
  {
    std::array<int, 3> corner{};
    int corners = 2;
    if (place.kind == Kind::EDGE)
      corner = {m_input.source(2 * place.index), m_input.target(2 * place.index), 0};
    else {
      const int h = m_input.halfedge_of_face(place.index);
      corner = {m_input.target(h), m_input.target(m_input.next(h)), m_input.source(h)};
      corners = 3;
    }
    std::array<double, 3> result{};
    for (int k = 0; k < 3; ++k) { // relative to a corner: exact if the coordinate does not change
      const double base = m_result.point[corner[0]][k];
      double sum = 0;
      for (int i = 1; i < corners; ++i)
        sum += place.weight[i] * (m_result.point[corner[i]][k] - base);
      result[k] = base + sum;
    }
    return result;
  }

  void place_points()
  {
    m_result.place.reserve(number_of_input_vertices() + m_points.size());
    m_result.point.reserve(number_of_input_vertices() + m_points.size());
    m_final_place.reserve(m_points.size());
    for (int e = 0; e < m_middle.number_of_edges(); ++e)
      for (int i = m_begin[e]; i < m_begin[e + 1]; ++i)
        add_node(input_place(e, i), final_place(e, i));
  }

  static Input_place on_input_edge(const int h, const FT& s)
  {
    const double at_target = static_cast<double>(s), at_source = static_cast<double>(FT(1 - s));
    Input_place place{Kind::EDGE, h >> 1, {{at_source, at_target, 0}}};
    if (h & 1)
      std::swap(place.weight[0], place.weight[1]);
    return place;
  }

  Input_place input_place(const int e, const int i) const
  {
    const Edge_point& point = m_points[i];
    if (point.input != none)
      return on_input_edge(m_on_input.point(point.input).input_halfedge, m_on_input.point(point.input).s);
    const int shared = m_on_input.input_halfedge(2 * e);
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
    const int face = has_before ? m_input.face(input_halfedge_of(before)) : m_input.face(input_halfedge_of(after) ^ 1);
    const FT t0 = has_before ? m_points[before].t : FT(0), t1 = has_after ? m_points[after].t : FT(1);
    const FT mu = t1 > t0 ? FT((point.t - t0) / (t1 - t0)) : FT(0.5);
    std::array<FT, 3> weight{};
    if (has_before)
      add_on_side(m_input, face, input_halfedge_of(before), m_on_input.point(m_points[before].input).s, FT(1 - mu), weight);
    else
      add_apex(m_input, face, input_halfedge_of(after) ^ 1, FT(1 - mu), weight);
    if (has_after)
      add_on_side(m_input, face, input_halfedge_of(after) ^ 1, FT(1 - m_on_input.point(m_points[after].input).s), mu, weight);
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

  static void add_on_side(const Triangulation_connectivity& mesh, const int face, const int h, const FT& s, const FT& factor, std::array<FT, 3>& weight)
  {
    weight[corner_index(mesh, face, h)] += factor * s;
    weight[corner_index(mesh, face, mesh.previous(h))] += factor * (1 - s);
  }

  static void add_apex(const Triangulation_connectivity& mesh, const int face, const int h, const FT& factor, std::array<FT, 3>& weight)
  {
    weight[corner_index(mesh, face, mesh.next(h))] += factor;
  }

  Final_place final_place(const int e, const int i) const
  {
    const Edge_point& point = m_points[i];
    if (point.last != none) {
      const auto& crossing = m_on_final.point(point.last);
      return {Kind::EDGE, crossing.final_halfedge >> 1, {crossing.weight_source, crossing.weight_target, FT(0)}};
    }
    const int shared = m_on_final.final_halfedge(2 * e);
    if (shared != none) {
      Final_place place{Kind::EDGE, shared >> 1, {FT(1 - point.t), point.t, FT(0)}};
      if (shared & 1)
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
    const int exit = has_after ? final_halfedge_of(after) : none, entry = has_before ? final_halfedge_of(before) ^ 1 : none;
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
    weight[corner_index(m_last, face, h)] += factor * ((h & 1) ? crossing.weight_source : crossing.weight_target);
    weight[corner_index(m_last, face, m_last.previous(h))] += factor * ((h & 1) ? crossing.weight_target : crossing.weight_source);
  }

  // Slot of the point with the given rank on its edge, on the side h of that edge.
  int slot(const int h, const int rank) const
  {
    const int e = h >> 1, count = m_begin[e + 1] - m_begin[e];
    return (h & 1) ? count - rank : rank + 1;
  }

  void collect_chords()
  {
    std::vector<std::pair<int, Triangle_chord>> first, second;
    for (const auto& curve : m_on_input.curves()) {
      int from = curve.first_corner, from_slot = 0;
      for (std::size_t i = 0; i < curve.exits.size(); ++i) {
        const int exit = curve.exits[i], rank = m_rank_of_input[curve.points[i]];
        first.push_back({m_middle.face(exit), {from, from_slot, exit, slot(exit, rank), curve.input_halfedge}});
        from = exit ^ 1;
        from_slot = slot(from, rank);
      }
      first.push_back({m_middle.face(curve.last_corner), {from, from_slot, curve.last_corner, 0, curve.input_halfedge}});
    }
    for (int e = 0; e < m_last.number_of_edges(); ++e)
      collect_final_chords(e, second);
    sort_by_face(first, m_first_begin, m_first_chords);
    sort_by_face(second, m_second_begin, m_second_chords);
  }

  void collect_final_chords(const int e, std::vector<std::pair<int, Triangle_chord>>& chords) const
  {
    const int begin = m_on_final.begin_on_final(e), end = m_on_final.begin_on_final(e + 1);
    int from = none, from_slot = 0;
    for (int i = begin; i < end; ++i) {
      const int number = m_on_final.point_on_final(i), middle_edge = m_on_final.middle_edge(number), rank = m_rank_of_final[number];
      // Followed from the source of 2e, the final edge enters the face of this middle halfedge:
      const int entered = 2 * middle_edge + (m_on_final.point(number).final_halfedge & 1);
      const int exit = entered ^ 1;
      if (i == begin)
        from = m_middle.previous(exit); // the corner opposite to the side by which the first triangle is left
      chords.push_back({m_middle.face(exit), {from, from_slot, exit, slot(exit, rank), 2 * e}});
      from = entered;
      from_slot = slot(entered, rank);
    }
    if (begin != end)
      chords.push_back({m_middle.face(from), {from, from_slot, m_middle.previous(from), 0, 2 * e}});
  }

  void sort_by_face(const std::vector<std::pair<int, Triangle_chord>>& chords, std::vector<int>& begin, std::vector<Triangle_chord>& sorted) const
  {
    begin.assign(m_middle.number_of_faces() + 1, 0);
    for (const auto& chord : chords)
      ++begin[chord.first + 1];
    for (int f = 0; f < m_middle.number_of_faces(); ++f)
      begin[f + 1] += begin[f];
    sorted.resize(chords.size());
    std::vector<int> end(begin.begin(), begin.end() - 1);
    for (const auto& chord : chords)
      sorted[end[chord.first]++] = chord.second;
  }

  // The boundary of the middle face, as positions: where each of its halfedges begins, and the nodes.
  void lay_boundary(const int f)
  {
    int h = m_middle.halfedge_of_face(f);
    m_boundary.clear();
    m_boundary_halfedge.clear();
    for (int k = 0; k < 3; ++k, h = m_middle.next(h)) {
      const int e = h >> 1, count = m_begin[e + 1] - m_begin[e];
      m_side[k] = {h, static_cast<int>(m_boundary.size())};
      m_boundary.push_back(m_middle.source(h));
      for (int i = 0; i < count; ++i)
        m_boundary.push_back(node_of_point((h & 1) ? m_begin[e + 1] - 1 - i : m_begin[e] + i));
      m_boundary_halfedge.resize(m_boundary.size(), h);
    }
  }

  int position(const int h, const int slot) const
  {
    for (const auto& side : m_side)
      if (side.first == h)
        return side.second + slot;
    CGAL_assertion(false);
    return 0;
  }

  void to_positions(const std::vector<int>& begin, const std::vector<Triangle_chord>& chords, const int f,
                    std::vector<Chord_arrangement::Chord>& result) const
  {
    result.clear();
    for (int i = begin[f]; i < begin[f + 1]; ++i)
      result.push_back({position(chords[i].halfedge_from, chords[i].slot_from), position(chords[i].halfedge_to, chords[i].slot_to), chords[i].curve});
  }

  void subdivide(const int f)
  {
    if (m_first_begin[f] == m_first_begin[f + 1] && m_second_begin[f] == m_second_begin[f + 1]) {
      copy_triangle(f);
      return;
    }
    lay_boundary(f);
    to_positions(m_first_begin, m_first_chords, f, m_first);
    to_positions(m_second_begin, m_second_chords, f, m_second);
    m_arrangement.compute(static_cast<int>(m_boundary.size()), m_first, m_second);
    place_crossings();
    find_cells();
    for (std::size_t c = 0; c + 1 < m_cell_begin.size(); ++c)
      triangulate(c);
  }

  // A middle triangle without chords is a triangle of the input and of the final triangulation.
  void copy_triangle(const int f)
  {
    Triangle triangle;
    int h = m_middle.halfedge_of_face(f);
    for (int i = 0; i < 3; ++i, h = m_middle.next(h)) {
      const int on_final = m_on_final.final_halfedge(h);
      triangle.node[i] = m_middle.source(h);
      triangle.uv[i] = to_double(m_layout.position(m_last.previous(on_final)));
      triangle.input_halfedge[i] = m_on_input.input_halfedge(h);
      triangle.final_halfedge[i] = on_final;
    }
    triangle.input_face = m_input.face(triangle.input_halfedge[0]);
    m_triangles.push_back(triangle);
  }

  // Barycentric coordinates, in the middle triangle, of a boundary position: of the sources of side 1 and side 2.
  Vector barycentric(const int position) const
  {
    int k = 2;
    while (m_side[k].second > position)
      --k;
    const int h = m_side[k].first;
    FT t(0);
    if (position != m_side[k].second) {
      t = m_points[m_boundary[position] - number_of_input_vertices()].t;
      if (h & 1)
        t = 1 - t;
    }
    switch (k) {
    case 0: return {t, FT(0)};
    case 1: return {FT(1 - t), t};
    default: return {FT(0), FT(1 - t)};
    }
  }

  // Makes the nodes where an input edge and a final edge cross inside the middle triangle.
  void place_crossings()
  {
    m_first_crossing_node = static_cast<int>(m_result.point.size());
    for (const Chord_arrangement::Crossing& crossing : m_arrangement.crossings()) {
      const Chord_arrangement::Chord &a = m_first[crossing.first_chord], &b = m_second[crossing.second_chord];
      const Vector a0 = barycentric(a.from), da = barycentric(a.to) - a0, b0 = barycentric(b.from), db = barycentric(b.to) - b0;
      const FT determinant = da.cross(db);
      const FT on_a = between((b0 - a0).cross(db), determinant), on_b = between((b0 - a0).cross(da), determinant);
      const FT s0 = place_on_input_edge(m_boundary[a.from], a.curve, FT(0)), s1 = place_on_input_edge(m_boundary[a.to], a.curve, FT(1));
      Final_place place{Kind::EDGE, b.curve >> 1, {}};
      add_on_final_edge(m_boundary[b.from], FT(1 - on_b), 0, place.weight);
      add_on_final_edge(m_boundary[b.to], on_b, 1, place.weight);
      add_node(on_input_edge(a.curve, FT(s0 + on_a * (s1 - s0))), place);
    }
  }

  static FT between(const FT& numerator, const FT& denominator)
  {
    const FT x = denominator != 0 ? FT(numerator / denominator) : FT(0.5);
    return x > 0 ? (x < 1 ? x : FT(1)) : FT(0);
  }

  // Place of a node on the input halfedge on which it lies: 0 at the source; `at_vertex` if the node is a vertex.
  FT place_on_input_edge(const int node, const int halfedge, const FT& at_vertex) const
  {
    if (node < number_of_input_vertices())
      return at_vertex;
    const auto& point = m_on_input.point(m_points[node - number_of_input_vertices()].input);
    return point.input_halfedge == halfedge ? point.s : FT(1 - point.s);
  }

  // Adds a node of a final edge, a vertex being its source (end = 0) or target (end = 1).
  void add_on_final_edge(const int node, const FT& factor, const int end, std::array<FT, 3>& weight) const
  {
    if (node < number_of_input_vertices()) {
      weight[end] += factor;
      return;
    }
    const auto& point = m_on_final.point(m_points[node - number_of_input_vertices()].last);
    weight[0] += factor * point.weight_source;
    weight[1] += factor * point.weight_target;
  }

  // Collects the cells of the arrangement, and the input face and the final face that contain each.
  void find_cells()
  {
    m_cell_begin.assign(1, 0);
    m_cell_sides.clear();
    m_arrangement.for_each_cell([&](const std::vector<int>& sides) {
      m_cell_sides.insert(m_cell_sides.end(), sides.begin(), sides.end());
      m_cell_begin.push_back(static_cast<int>(m_cell_sides.size()));
    });
    const std::size_t cells = m_cell_begin.size() - 1;
    m_cell_input_face.assign(cells, none);
    m_cell_final_face.assign(cells, none);
    for (std::size_t c = 0; c < cells; ++c)
      for (int i = m_cell_begin[c]; i < m_cell_begin[c + 1]; ++i) {
        const int on_input = input_halfedge(m_cell_sides[i]), on_final = final_halfedge(m_cell_sides[i]);
        if (on_input != none)
          m_cell_input_face[c] = m_input.face(on_input);
        if (on_final != none)
          m_cell_final_face[c] = m_last.face(on_final);
      }
    spread_faces(m_cell_input_face, [&](const int side) { return input_halfedge(side) == none; });
    spread_faces(m_cell_final_face, [&](const int side) { return final_halfedge(side) == none; });
  }

  // Cells on both sides of a side that is not part of the other family lie in the same face.
  template <typename IsOpen>
  void spread_faces(std::vector<int>& face, const IsOpen& is_open)
  {
    if (std::find(face.begin(), face.end(), none) == face.end())
      return;
    m_cell_of_side.clear();
    for (std::size_t c = 0; c < face.size(); ++c)
      for (int i = m_cell_begin[c]; i < m_cell_begin[c + 1]; ++i) {
        m_cell_of_side.resize(std::max<std::size_t>(m_cell_of_side.size(), (m_cell_sides[i] | 1) + 1), none);
        m_cell_of_side[m_cell_sides[i]] = static_cast<int>(c);
      }
    std::vector<int> stack;
    for (std::size_t c = 0; c < face.size(); ++c)
      if (face[c] != none)
        stack.push_back(static_cast<int>(c));
    while (!stack.empty()) {
      const int c = stack.back();
      stack.pop_back();
      for (int i = m_cell_begin[c]; i < m_cell_begin[c + 1]; ++i) {
        const int side = m_cell_sides[i];
        if (m_arrangement.is_boundary(side) || !is_open(side))
          continue;
        const int neighbor = m_cell_of_side[Chord_arrangement::twin(side)];
        if (face[neighbor] == none) {
          face[neighbor] = face[c];
          stack.push_back(neighbor);
        }
      }
    }
  }

  // The input (final) halfedge that a side of a cell lies on, in its direction, or none.
  int input_halfedge(const int side) const
  {
    if (m_arrangement.is_boundary(side))
      return m_on_input.input_halfedge(m_boundary_halfedge[m_arrangement.node(side)]);
    const int curve = m_arrangement.first_curve(side);
    return curve == none || m_arrangement.is_along_first(side) ? curve : curve ^ 1;
  }
  int final_halfedge(const int side) const
  {
    if (m_arrangement.is_boundary(side))
      return m_on_final.final_halfedge(m_boundary_halfedge[m_arrangement.node(side)]);
    const int curve = m_arrangement.second_curve(side);
    return curve == none || m_arrangement.is_along_second(side) ? curve : curve ^ 1;
  }

  int global_node(const int node) const
  {
    const int positions = static_cast<int>(m_boundary.size());
    return node < positions ? m_boundary[node] : m_first_crossing_node + (node - positions);
  }

  void triangulate(const std::size_t c)
  {
    const int begin = m_cell_begin[c], end = m_cell_begin[c + 1];
    m_cell.clear();
    for (int i = begin; i < end; ++i) {
      const int side = m_cell_sides[i], node = global_node(m_arrangement.node(side));
      Convex_cell::Corner corner;
      corner.node = node;
      corner.point = m_result.point[node];
      corner.uv = uv(side, node, m_cell_final_face[c]);
      corner.input_halfedge = input_halfedge(side);
      corner.final_halfedge = final_halfedge(side);
      m_cell.add(corner);
    }
    const int h = m_input.halfedge_of_face(m_cell_input_face[c]);
    m_cell.set_plane(m_result.point[m_input.source(h)], m_result.point[m_input.target(h)], m_result.point[m_input.target(m_input.next(h))]);
    m_cell.triangulate([&](const Convex_cell::Corner& p, const Convex_cell::Corner& q, const Convex_cell::Corner& r) {
      m_triangles.push_back({{p.node, q.node, r.node}, {p.uv, q.uv, r.uv}, {p.input_halfedge, q.input_halfedge, r.input_halfedge},
                             {p.final_halfedge, q.final_halfedge, r.final_halfedge}, m_cell_input_face[c]});
    });
  }

  // uv of the node at which the side starts, in the chart of a final face.
  std::array<double, 2> uv(const int side, const int node, const int face) const
  {
    if (node < number_of_input_vertices())
      return to_double(m_layout.position(m_last.previous(final_corner(side))));
    const Final_place& place = m_final_place[node - number_of_input_vertices()];
    if (place.kind == Kind::FACE) {
      CGAL_assertion(place.index == face);
      return uv_in_face(place);
    }
    return uv_on_edge(place, face);
  }

  static std::array<double, 2> to_double(const Vector& p) { return {{static_cast<double>(p.u), static_cast<double>(p.v)}}; }

  // The final halfedge at whose source the cell that starts with `side` at a vertex lies, in its face.
  int final_corner(const int side) const
  {
    const int clockwise = m_arrangement.second_or_boundary_clockwise(side);
    if (m_arrangement.is_boundary(clockwise))
      return m_on_final.corner(m_boundary_halfedge[m_arrangement.node(clockwise)]);
    return final_halfedge(clockwise);
  }

  std::array<double, 2> uv_on_edge(const Final_place& place, const int face) const
  {
    using std::exp;
    // The even halfedge, if it lies in the face, or if both sides have the same chart: then all computations are the same on both.
    const int even = 2 * place.index;
    const bool use_even = m_last.face(even) == face || !m_layout.is_cut(place.index);
    const int h = use_even ? even : even + 1;
    const Vector source = m_layout.position(m_last.previous(h)), target = m_layout.position(h);
    const FT at_target = (use_even ? place.weight[1] : place.weight[0]) * exp(FT(use_even ? FT(-m_form[place.index]) : m_form[place.index]));
    const FT at_source = use_even ? place.weight[0] : place.weight[1];
    return to_double(source + (target - source) * FT(at_target / (at_source + at_target)));
  }

  std::array<double, 2> uv_in_face(const Final_place& place) const
  {
    using std::exp;
    const int h = m_last.halfedge_of_face(place.index), j = m_last.next(h), k = m_last.next(j);
    const auto form = [&](const int g) { return (g & 1) ? FT(-m_form[g >> 1]) : m_form[g >> 1]; };
    const FT w0 = place.weight[0], w1 = place.weight[1] * exp(FT(-form(j))), w2 = place.weight[2] * exp(FT(form(h)));
    const Vector base = m_layout.position(h);
    const FT sum = w0 + w1 + w2;
    return to_double(base + (m_layout.position(j) - base) * FT(w1 / sum) + (m_layout.position(k) - base) * FT(w2 / sum));
  }

  // Makes the connectivity of the triangles. The refined mesh is simple: its edges are straight in the input's faces.
  void connect()
  {
    const int number_of_triangles = static_cast<int>(m_triangles.size());
    std::vector<std::pair<std::uint64_t, int>> keys(3 * m_triangles.size());
    for (int i = 0; i < 3 * number_of_triangles; ++i) {
      const std::uint64_t a = m_triangles[i / 3].node[i % 3], b = m_triangles[i / 3].node[(i + 1) % 3];
      keys[i] = {(std::min(a, b) << 32) | std::max(a, b), i};
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> halfedge(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      CGAL_assertion(keys[i].first == keys[i ^ 1].first);
      halfedge[keys[i].second] = static_cast<int>(i);
    }
    keys = {};
    Triangulation_connectivity& mesh = m_result.mesh;
    mesh.m_number_of_vertices = static_cast<int>(m_result.point.size());
    mesh.m_next.resize(halfedge.size());
    mesh.m_target.resize(halfedge.size());
    mesh.m_face.resize(halfedge.size());
    mesh.m_face_halfedge.resize(m_triangles.size());
    m_result.uv.resize(halfedge.size());
    m_result.input_halfedge.resize(halfedge.size());
    m_result.final_halfedge.resize(halfedge.size());
    m_result.input_face.resize(m_triangles.size());
    for (int f = 0; f < number_of_triangles; ++f) {
      const Triangle& triangle = m_triangles[f];
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, h = halfedge[3 * f + i];
        mesh.m_next[h] = halfedge[3 * f + j];
        mesh.m_target[h] = triangle.node[j];
        mesh.m_face[h] = f;
        m_result.uv[h] = triangle.uv[j];
        m_result.input_halfedge[h] = triangle.input_halfedge[i];
        m_result.final_halfedge[h] = triangle.final_halfedge[i];
      }
      mesh.m_face_halfedge[f] = halfedge[3 * f];
      m_result.input_face[f] = triangle.input_face;
    }
    m_triangles = {};
  }

  const Triangulation_connectivity &m_input, &m_middle, &m_last;
  const Input_crossings<FT>& m_on_input;
  const Final_crossings<FT>& m_on_final;
  const std::vector<FT>& m_form;
  const Flat_layout<FT>& m_layout;
  Refined_triangulation m_result;

  std::vector<int> m_begin;                          // per middle edge, in m_points
  std::vector<Edge_point> m_points;
  std::vector<int> m_rank_of_input, m_rank_of_final; // per crossing: rank on its middle edge
  std::vector<Final_place> m_final_place;            // per node that is no vertex
  std::vector<int> m_first_begin, m_second_begin;    // per middle face
  std::vector<Triangle_chord> m_first_chords, m_second_chords;
  std::vector<Triangle> m_triangles;

  // of one middle face
  Chord_arrangement m_arrangement;
  std::array<std::pair<int, int>, 3> m_side; // halfedge, first position
  std::vector<int> m_boundary, m_boundary_halfedge;
  std::vector<Chord_arrangement::Chord> m_first, m_second;
  int m_first_crossing_node = 0;
  std::vector<int> m_cell_begin, m_cell_sides, m_cell_of_side, m_cell_input_face, m_cell_final_face;
  Convex_cell m_cell;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_COMMON_SUBDIVISION_H
