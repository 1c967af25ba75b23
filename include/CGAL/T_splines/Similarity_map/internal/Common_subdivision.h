// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_COMMON_SUBDIVISION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_COMMON_SUBDIVISION_H

#include <CGAL/T_splines/Similarity_map/internal/Chord_arrangement.h>
#include <CGAL/T_splines/Similarity_map/internal/Convex_cell.h>
#include <CGAL/T_splines/Similarity_map/internal/Edge_crossings.h>
#include <CGAL/T_splines/Similarity_map/internal/Flat_layout.h>
#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/Similarity_map/internal/Subdivided_part.h>
#include <CGAL/T_splines/Similarity_map/internal/Subdivision_nodes.h>
#include <CGAL/T_splines/Similarity_map/internal/Subdivision_triangles.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The common subdivision of the input triangulation, its intrinsic Delaunay triangulation (the middle one) and the
/// final triangulation.
///
/// Inside a middle triangle, the edges of both others are straight: an arrangement of chords. Each of its cells is
/// convex on the surface and in the plane of the map; it is triangulated.
/// \tparam FT number type of the construction
template <typename FT>
class Common_subdivision {
  static constexpr int none = -1;
  using Vector = Plane_vector<FT>;

public:
  /// \param points of the input's vertices
  /// \param form xi on the final triangulation, of the halfedge 2e per edge e
  /// \param part what is subdivided
  /// \param most_nodes where there would be more, the subdivision is left unfinished
  /// \param progress if it is interrupted, the same
  Common_subdivision(const Triangulation_connectivity& input, const std::vector<std::array<double, 3>>& points,
                     const Triangulation_connectivity& middle, const Triangulation_connectivity& last,
                     const Input_crossings<FT>& input_crossings, const Final_crossings<FT>& final_crossings,
                     const std::vector<FT>& form, const Flat_layout<FT>& layout, const Subdivided_part& part,
                     const std::int64_t most_nodes, Progress& progress)
    : m_input(input),
      m_middle(middle),
      m_last(last),
      m_on_input(input_crossings),
      m_on_final(final_crossings),
      m_layout(layout),
      m_part(part),
      m_nodes(input, points, middle, last, input_crossings, final_crossings, form, layout)
  {
    progress.progress(0.2);
    if (!progress.go_on())
      return;
    collect_chords();
    // On a closed surface, each added vertex adds two triangles; crossings inside of middle triangles come on top.
    m_triangles.reserve(middle.number_of_faces() + 2 * m_nodes.number_on_edges());
    for (int f = 0; f < middle.number_of_faces(); ++f) {
      if (f % 1024 == 0)
        progress.progress(0.25 + 0.35 * f / middle.number_of_faces());
      // Each chord of one family crosses each of the other at most once.
      const std::int64_t first_chords = m_first_begin[f + 1] - m_first_begin[f],
                         second_chords = m_second_begin[f + 1] - m_second_begin[f];
      if (m_nodes.size() > most_nodes || first_chords * second_chords > 4 * most_nodes)
        return;
      if (!progress.go_on_after(20 + 20 * static_cast<std::size_t>(first_chords + second_chords)))
        return;
      if (meets_part(f))
        subdivide(f);
    }
    if (!progress.go_on())
      return;
    m_is_complete = true;
    m_result.point = std::move(m_nodes.points());
    m_result.place = std::move(m_nodes.places());
    m_first_chords = m_second_chords = {}; // their memory is wanted
    progress.progress(0.7);
    m_triangles.connect(input.number_of_edges(), m_result, progress);
  }

  /// Whether the subdivision was made; else it would have too many nodes.
  bool is_complete() const { return m_is_complete; }

  /// The triangulation. Of a double, the triangles on the first sheet: edges on its border have no face on the side of the
  /// odd halfedge, which has no successor yet, and there are vertices without triangle.
  Refined_triangulation& result() { return m_result; }

private:
  // Slot of the point with the given rank on its edge, on the side h of that edge.
  int slot(const int h, const int rank) const
  {
    const int count = m_nodes.number_on_edge(edge_of(h));
    return is_along_edge(h) ? rank + 1 : count - rank;
  }

  void collect_chords()
  {
    std::vector<std::pair<int, Triangle_chord>> first, second;
    for (const auto& curve : m_on_input.curves()) {
      int from = curve.first_corner, from_slot = 0;
      for (std::size_t i = 0; i < curve.exits.size(); ++i) {
        const int exit = curve.exits[i], rank = m_nodes.rank_of_input(curve.points[i]);
        first.push_back({m_middle.face(exit), {from, from_slot, exit, slot(exit, rank), curve.input_halfedge}});
        from = opposite(exit);
        from_slot = slot(from, rank);
      }
      first.push_back(
          {m_middle.face(curve.last_corner), {from, from_slot, curve.last_corner, 0, curve.input_halfedge}});
    }
    for (int e = 0; e < m_last.number_of_edges(); ++e)
      collect_final_chords(e, second);
    sort_by_face(first, m_first_begin, m_first_chords);
    sort_by_face(second, m_second_begin, m_second_chords);
  }

  // Whether part of the middle face is on the first sheet: an input edge of that sheet runs through it or, if it is an
  // input face, is a side.
  bool meets_part(const int f) const
  {
    if (!m_part.has_middle_face(f))
      return false;
    if (m_first_begin[f] != m_first_begin[f + 1])
      return true;
    const int on_input = m_on_input.input_halfedge(m_middle.halfedge_of_face(f));
    return on_input != none && m_part.has_input_face(m_input.face(on_input));
  }

  // A final edge crosses the sides of a middle face that is looked at in known points.
  void collect_final_chords(const int e, std::vector<std::pair<int, Triangle_chord>>& chords) const
  {
    const int begin = m_on_final.begin_on_final(e), end = m_on_final.begin_on_final(e + 1);
    int from = none, from_slot = 0;
    for (int i = begin; i < end; ++i) {
      const int number = m_on_final.point_on_final(i);
      if (number == none) {
        from = none;
        continue;
      }
      const int middle_edge = m_on_final.middle_edge(number), rank = m_nodes.rank_of_final(number);
      // Followed from the source of 2e, the final edge enters the face of this middle halfedge:
      const int entered = halfedges_of_edge(middle_edge)[side_of_edge(m_on_final.point(number).final_halfedge)];
      const int exit = opposite(entered);
      if (i == begin)
        from = m_middle.previous(exit); // the corner opposite to the side by which the first triangle is left
      if (m_part.has_middle_face(m_middle.face(exit)))
        chords.push_back({m_middle.face(exit), {from, from_slot, exit, slot(exit, rank), halfedge_of_edge(e)}});
      from = entered;
      from_slot = slot(entered, rank);
    }
    if (from != none && m_part.has_middle_face(m_middle.face(from)))
      chords.push_back({m_middle.face(from), {from, from_slot, m_middle.previous(from), 0, halfedge_of_edge(e)}});
  }

  void sort_by_face(const std::vector<std::pair<int, Triangle_chord>>& chords, std::vector<int>& begin,
                    std::vector<Triangle_chord>& sorted) const
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
      const int e = edge_of(h), count = m_nodes.number_on_edge(e);
      m_side[k] = {h, static_cast<int>(m_boundary.size())};
      m_boundary.push_back(m_middle.source(h));
      for (int i = 0; i < count; ++i)
        m_boundary.push_back(m_nodes.node_on_edge(e, is_along_edge(h) ? i : count - 1 - i));
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
      result.push_back({position(chords[i].halfedge_from, chords[i].slot_from),
                        position(chords[i].halfedge_to, chords[i].slot_to), chords[i].curve});
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
    Subdivision_triangles::Triangle triangle;
    int h = m_middle.halfedge_of_face(f);
    for (int i = 0; i < 3; ++i, h = m_middle.next(h)) {
      const int on_final = m_on_final.final_halfedge(h);
      triangle.node[i] = m_middle.source(h);
      triangle.uv[i] = m_layout.uv(m_last.previous(on_final));
      triangle.input_halfedge[i] = m_on_input.input_halfedge(h);
      triangle.final_halfedge[i] = on_final;
    }
    triangle.input_face = m_input.face(triangle.input_halfedge[0]);
    m_triangles.add(triangle);
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
      t = m_nodes.t(m_boundary[position]);
      if (!is_along_edge(h))
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
    m_first_crossing_node = m_nodes.size();
    for (const Chord_arrangement::Crossing& crossing : m_arrangement.crossings()) {
      const Chord_arrangement::Chord &a = m_first[crossing.first_chord], &b = m_second[crossing.second_chord];
      const Vector a0 = barycentric(a.from), da = barycentric(a.to) - a0, b0 = barycentric(b.from),
                   db = barycentric(b.to) - b0;
      const FT determinant = da.cross(db);
      const FT on_a = between((b0 - a0).cross(db), determinant), on_b = between((b0 - a0).cross(da), determinant);
      m_nodes.add_crossing(a.curve, {m_boundary[a.from], m_boundary[a.to]}, on_a, b.curve,
                           {m_boundary[b.from], m_boundary[b.to]}, on_b);
    }
  }

  static FT between(const FT& numerator, const FT& denominator)
  {
    const FT x = denominator != 0 ? FT(numerator / denominator) : FT(0.5);
    return x > 0 ? (x < 1 ? x : FT(1)) : FT(0);
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
    return curve == none || m_arrangement.is_along_first(side) ? curve : opposite(curve);
  }
  int final_halfedge(const int side) const
  {
    if (m_arrangement.is_boundary(side))
      return m_on_final.final_halfedge(m_boundary_halfedge[m_arrangement.node(side)]);
    const int curve = m_arrangement.second_curve(side);
    return curve == none || m_arrangement.is_along_second(side) ? curve : opposite(curve);
  }

  int global_node(const int node) const
  {
    const int positions = static_cast<int>(m_boundary.size());
    return node < positions ? m_boundary[node] : m_first_crossing_node + (node - positions);
  }

  void triangulate(const std::size_t c)
  {
    if (!m_part.has_input_face(m_cell_input_face[c]))
      return;
    const int begin = m_cell_begin[c], end = m_cell_begin[c + 1];
    m_cell.clear();
    for (int i = begin; i < end; ++i) {
      const int side = m_cell_sides[i], node = global_node(m_arrangement.node(side));
      Convex_cell::Corner corner;
      corner.node = node;
      corner.point = m_nodes.point(node);
      corner.uv = uv(side, node, m_cell_final_face[c]);
      corner.input_halfedge = input_halfedge(side);
      corner.final_halfedge = final_halfedge(side);
      m_cell.add(corner);
    }
    const int h = m_input.halfedge_of_face(m_cell_input_face[c]);
    m_cell.set_plane(m_nodes.point(m_input.source(h)), m_nodes.point(m_input.target(h)),
                     m_nodes.point(m_input.target(m_input.next(h))));
    m_cell.triangulate([&](const Convex_cell::Corner& p, const Convex_cell::Corner& q, const Convex_cell::Corner& r) {
      m_triangles.add({{p.node, q.node, r.node},
                       {p.uv, q.uv, r.uv},
                       {p.input_halfedge, q.input_halfedge, r.input_halfedge},
                       {p.final_halfedge, q.final_halfedge, r.final_halfedge},
                       m_cell_input_face[c]});
    });
  }

  // uv of the node at which the side starts, in the chart of a final face.
  std::array<double, 2> uv(const int side, const int node, const int face) const
  {
    return m_nodes.is_vertex(node) ? m_layout.uv(m_last.previous(final_corner(side))) : m_nodes.uv(node, face);
  }

  // The final halfedge at whose source the cell that starts with `side` at a vertex lies, in its face.
  int final_corner(const int side) const
  {
    const int clockwise = m_arrangement.second_or_boundary_clockwise(side);
    if (m_arrangement.is_boundary(clockwise))
      return m_on_final.corner(m_boundary_halfedge[m_arrangement.node(clockwise)]);
    return final_halfedge(clockwise);
  }

  const Triangulation_connectivity &m_input, &m_middle, &m_last;
  const Input_crossings<FT>& m_on_input;
  const Final_crossings<FT>& m_on_final;
  const Flat_layout<FT>& m_layout;
  const Subdivided_part& m_part;
  bool m_is_complete = false;
  Refined_triangulation m_result;

  Subdivision_nodes<FT> m_nodes;
  std::vector<int> m_first_begin, m_second_begin; // per middle face
  std::vector<Triangle_chord> m_first_chords, m_second_chords;
  Subdivision_triangles m_triangles;

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
