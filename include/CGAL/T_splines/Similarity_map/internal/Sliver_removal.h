// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SLIVER_REMOVAL_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SLIVER_REMOVAL_H

#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Makes every triangle of a refined triangulation positively oriented on the surface and in the plane, decided
/// exactly, and takes out what is smaller than double coordinates resolve.
///
/// Cells of the common subdivision can be as thin as the rounding of coordinates. Where a triangle is turned over or so
/// thin, the refinement is made coarser: edges that lie on no input edge and not on the cut are flipped, and added
/// vertices are moved along an edge into a neighbor, along the input edge or the cut on which they lie. An operation is
/// done if all triangles that it changes are good afterwards. Where many vertices nearly coincide, no single collapse does
/// that; then one will do that leaves fewer bad triangles, and none worse than before. Thin triangles that are positive
/// may stay, such as those of the input; others are a failure. A border stays where it is: its vertices are moved along it.
class Sliver_removal {
  using Index = Triangulation_connectivity::Index;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  static constexpr int none = -1;

public:
  /// \param input_mesh, input_point the input triangulation
  /// \param is_cut per edge of `refined`
  /// \param progress if it is interrupted, the triangulation may not be used
  Sliver_removal(const Triangulation_connectivity& input_mesh, const std::vector<std::array<double, 3>>& input_point,
                 Refined_triangulation& refined, std::vector<char>& is_cut, Progress& progress)
    : m_input(input_mesh),
      m_input_point(input_point),
      m_refined(refined),
      m_mesh(refined.mesh),
      m_is_cut(is_cut)
  {
    choose_projections();
    std::vector<Index> bad;
    for (Index f = 0; f < m_mesh.number_of_faces() && progress.go_on_after(4); ++f)
      if (!is_good(f))
        bad.push_back(f);
    if (bad.empty())
      return;
    m_is_removed.assign(m_mesh.number_of_faces(), 0);
    m_outgoing = m_mesh.outgoing_halfedges();
    const auto first_negative = [&] {
      return std::find_if(bad.begin(), bad.end(), [this](const Index f) { return !is_positive(f); });
    };
    while (!bad.empty() && progress.go_on()) {
      const std::size_t before = bad.size();
      for (const Index f : bad)
        if (!m_is_removed[f] && !is_good(f) && progress.go_on_after(50))
          repair(f);
      bad.erase(std::remove_if(bad.begin(), bad.end(), [this](const Index f) { return m_is_removed[f] || is_good(f); }),
                bad.end());
      if (bad.size() < before)
        m_may_leave_bad = false;
      else if (!m_may_leave_bad && first_negative() != bad.end())
        m_may_leave_bad = true;
      else
        break;
    }
    for (const Index f : bad)
      if (!is_positive(f) && (m_first_bad_input_face == none || m_refined.input_face[f] < m_first_bad_input_face))
        m_first_bad_input_face = m_refined.input_face[f];
    compress();
  }

  /// The first input face with a triangle that could not be repaired, or -1.
  int first_bad_input_face() const { return m_first_bad_input_face; }

private:
  // On each input face, the coordinate plane in which it is seen at the largest, and from which side.
  struct Projection {
    char first, second; // coordinates that orient the input face counter-clockwise
  };

  void choose_projections()
  {
    // Of a double, the faces of the second sheet come last.
    const auto last = std::max_element(m_refined.input_face.begin(), m_refined.input_face.end());
    m_projection.resize(last != m_refined.input_face.end() ? *last + 1 : 0);
    for (Index f = 0; f < static_cast<Index>(m_projection.size()); ++f) {
      const Index h = m_input.halfedge_of_face(f);
      const std::array<double, 3>&p = m_input_point[m_input.source(h)], &q = m_input_point[m_input.target(h)],
                               &r = m_input_point[m_input.target(m_input.next(h))];
      std::array<double, 3> normal;
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        normal[k] = std::abs((q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]));
      }
      const int k = static_cast<int>(std::max_element(normal.begin(), normal.end()) - normal.begin());
      Projection projection{static_cast<char>((k + 1) % 3), static_cast<char>((k + 2) % 3)};
      if (orientation(projected(p, projection), projected(q, projection), projected(r, projection)) == CGAL::RIGHT_TURN)
        std::swap(projection.first, projection.second);
      m_projection[f] = projection;
    }
  }

  static std::array<double, 2> projected(const std::array<double, 3>& p, const Projection& projection)
  {
    return {{p[projection.first], p[projection.second]}};
  }

  static CGAL::Orientation orientation(const std::array<double, 2>& p, const std::array<double, 2>& q,
                                       const std::array<double, 2>& r)
  {
    return CGAL::orientation(Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1]), Kernel::Point_2(r[0], r[1]));
  }

  struct Corner {
    Index vertex;
    std::array<double, 2> uv;
  };

  bool is_positive(const Corner& p, const Corner& q, const Corner& r, const Index input_face) const
  {
    const Projection& projection = m_projection[input_face];
    const auto point = [&](const Corner& c) { return projected(m_refined.point[c.vertex], projection); };
    return orientation(p.uv, q.uv, r.uv) == CGAL::LEFT_TURN &&
           orientation(point(p), point(q), point(r)) == CGAL::LEFT_TURN;
  }

  // Whether the triangle is positive and its least height, relative to its longest side and in the plane also relative
  // to its coordinates, is well above the unit of rounding.
  bool is_good(const Corner& p, const Corner& q, const Corner& r, const Index input_face) const
  {
    const double height = least_height(p.uv, q.uv, r.uv);
    double coordinate = 0;
    for (const double x : {p.uv[0], p.uv[1], q.uv[0], q.uv[1], r.uv[0], r.uv[1]})
      coordinate = std::max(coordinate, std::abs(x));
    const double longest = std::sqrt(longest_square(p.uv, q.uv, r.uv));
    if (!(height > thin * longest && height > unresolved * coordinate))
      return false;
    const Projection& projection = m_projection[input_face];
    const auto point = [&](const Corner& c) { return projected(m_refined.point[c.vertex], projection); };
    const std::array<double, 2> a = point(p), b = point(q), c = point(r);
    return least_height(a, b, c) > thin * std::sqrt(longest_square(a, b, c)) && is_positive(p, q, r, input_face);
  }

  bool is_good(const Index f) const
  {
    const Index h = m_mesh.halfedge_of_face(f);
    return is_good(corner(h), corner(m_mesh.next(h)), corner(m_mesh.previous(h)), m_refined.input_face[f]);
  }

  // The smallest heights, by the longest side: about the square root of the unit of rounding; and by the coordinates, so
  // that a height has six digits.
  static constexpr double thin = 1e-8, unresolved = 1e-10;

  static double longest_square(const std::array<double, 2>& p, const std::array<double, 2>& q,
                               const std::array<double, 2>& r)
  {
    const auto square = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
      return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    };
    return std::max(square(p, q), std::max(square(q, r), square(r, p)));
  }

  static double least_height(const std::array<double, 2>& p, const std::array<double, 2>& q,
                             const std::array<double, 2>& r)
  {
    const double area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]), square = longest_square(p, q, r);
    return square > 0 ? area / std::sqrt(square) : 0;
  }

  Corner corner(const Index h) const { return {m_mesh.target(h), m_refined.uv[h]}; }

  bool is_positive(const Index f) const
  {
    const Index h = m_mesh.halfedge_of_face(f);
    return is_positive(corner(h), corner(m_mesh.next(h)), corner(m_mesh.previous(h)), m_refined.input_face[f]);
  }

  void repair(const Index f)
  {
    const std::array<Index, 3> sides = {m_mesh.halfedge_of_face(f), m_mesh.next(m_mesh.halfedge_of_face(f)),
                                        m_mesh.previous(m_mesh.halfedge_of_face(f))};
    for (const Index h : sides)
      if (can_flip(h)) {
        flip(h);
        return;
      }
    for (const Index side : sides)
      for (const Index h : around_source(m_mesh.next(side))) // leave the target of side
        if (can_collapse(h)) {
          collapse(h);
          return;
        }
  }

  // The halfedges that leave the source of h: h, and the others counter-clockwise, across a border too.
  std::vector<Index> around_source(const Index h) const
  {
    std::vector<Index> result;
    Index k = h;
    do {
      result.push_back(k);
      k = next_around_source(k);
    } while (k != h);
    return result;
  }

  Index next_around_source(const Index h) const
  {
    if (m_mesh.face(h) != none)
      return m_mesh.next_around_source(h);
    Index k = h; // the border: to its other end, clockwise
    while (m_mesh.face(opposite(k)) != none)
      k = m_mesh.next(opposite(k));
    return k;
  }

  bool are_adjacent(const Index v, const Index w) const
  {
    const Index start = m_outgoing[v];
    Index h = start;
    do {
      if (m_mesh.target(h) == w)
        return true;
      h = next_around_source(h);
    } while (h != start);
    return false;
  }

  bool is_on_border(const Index h) const { return m_mesh.face(h) == none || m_mesh.face(opposite(h)) == none; }

  bool can_flip(const Index h) const
  {
    const Index g = opposite(h);
    if (m_is_cut[edge_of(h)] || m_refined.input_halfedge[h] != none) // so it is not on a border
      return false;
    const Corner i = corner(g), j = corner(h), k = corner(m_mesh.next(h)), l = corner(m_mesh.next(g));
    const Index input_face = m_refined.input_face[m_mesh.face(h)];
    return k.vertex != l.vertex && is_good(l, k, i, input_face) && is_good(k, l, j, input_face) &&
           !are_adjacent(k.vertex, l.vertex);
  }

  void flip(const Index h)
  {
    const Index g = opposite(h);
    m_refined.uv[h] = m_refined.uv[m_mesh.next(h)];
    m_refined.uv[g] = m_refined.uv[m_mesh.next(g)];
    m_refined.final_halfedge[h] = m_refined.final_halfedge[g] = none;
    for (const Index k : {h, g})
      m_outgoing[m_mesh.source(k)] = m_mesh.next(opposite(k));
    m_mesh.flip(h);
  }

  // Whether the source of h, an added vertex, may be moved into the target.
  bool can_collapse(const Index h) const
  {
    const Index u = m_mesh.source(h), w = m_mesh.target(h), g = opposite(h);
    if (m_refined.place[u].kind == Input_place::Kind::VERTEX)
      return false;
    if (m_refined.place[u].kind == Input_place::Kind::EDGE && m_refined.input_halfedge[h] == none)
      return false;
    int cut_edges = 0, common_neighbors = 0;
    Index k = h;
    do {
      cut_edges += m_is_cut[edge_of(k)] ? 1 : 0;
      if (k != h && m_mesh.target(k) == w)
        return false;
      if (k != h && are_adjacent(m_mesh.target(k), w))
        ++common_neighbors;
      k = next_around_source(k);
    } while (k != h);
    if (is_on_border(h) && m_mesh.face(opposite(m_mesh.face(h) != none ? m_mesh.previous(h) : m_mesh.next(g))) == none)
      return false; // u has one triangle
    if (common_neighbors != (is_on_border(h) ? 1 : 2) || (cut_edges != 0 && (cut_edges != 2 || !m_is_cut[edge_of(h)])))
      return false;
    int bad = 0;
    bool is_right_of_cut = false; // once the second cut edge at u is passed
    for (k = next_around_source(h); k != h; k = next_around_source(k)) {
      is_right_of_cut = is_right_of_cut || m_is_cut[edge_of(k)];
      const Index f = m_mesh.face(k);
      if (f == none || f == m_mesh.face(g))
        continue;
      const Corner moved = {w, uv_at_target(h, is_right_of_cut)}, p = corner(k), q = corner(m_mesh.next(k));
      if (is_good(moved, p, q, m_refined.input_face[f]))
        continue;
      if (!m_may_leave_bad || is_good(f) || (is_positive(f) && !is_positive(moved, p, q, m_refined.input_face[f])))
        return false;
      ++bad;
    }
    const auto is_bad = [this](const Index face) { return face != none && !is_good(face); };
    return bad == 0 || is_bad(m_mesh.face(h)) || is_bad(m_mesh.face(g));
  }

  // uv of the target of h in the chart on its left, or on its right; on the border, where there is one.
  const std::array<double, 2>& uv_at_target(const Index h, const bool on_the_right) const
  {
    const bool is_right = is_on_border(h) ? m_mesh.face(h) == none : on_the_right;
    return is_right ? m_refined.uv[m_mesh.previous(opposite(h))] : m_refined.uv[h];
  }

  void collapse(const Index h)
  {
    const Index g = opposite(h), u = m_mesh.source(h), w = m_mesh.target(h);
    const std::array<double, 2> uv_left = uv_at_target(h, false), uv_right = uv_at_target(h, true);
    bool is_right_of_cut = false;
    std::vector<Index> incoming;
    for (Index k = next_around_source(h); k != h; k = next_around_source(k)) {
      is_right_of_cut = is_right_of_cut || m_is_cut[edge_of(k)];
      if (m_mesh.face(k) != none)
        m_refined.uv[m_mesh.previous(k)] = is_right_of_cut ? uv_right : uv_left; // the halfedge to u in the face of k
      incoming.push_back(opposite(k));
    }
    for (const Index n : {h, g})
      if (m_mesh.face(n) == none) // the border goes on without it
        m_mesh.m_next[opposite(next_around_source(n))] = m_mesh.next(n);
    // Each of the triangles of the edge vanishes; its two other edges become one.
    const bool has_left = m_mesh.face(h) != none, has_right = m_mesh.face(g) != none;
    const Index from_w = m_mesh.next(h),
                from_u = has_left ? opposite(m_mesh.previous(h)) : none; // both to the left apex
    const Index to_w = has_right ? m_mesh.previous(g) : none,
                to_u = opposite(m_mesh.next(g)); // both from the right apex
    for (const Index k : incoming)
      m_mesh.m_target[k] = w;
    if (has_left) {
      m_is_removed[m_mesh.face(h)] = 1;
      replace(from_u, from_w);
      m_outgoing[w] = from_w;
      m_outgoing[m_mesh.target(from_w)] = opposite(from_w);
    }
    if (has_right) {
      m_is_removed[m_mesh.face(g)] = 1;
      replace(to_u, to_w);
      m_outgoing[w] = opposite(to_w);
      m_outgoing[m_mesh.source(to_w)] = to_w;
    }
    m_outgoing[u] = none;
  }

  // Puts the halfedge `by` of a vanishing triangle in the place of `h`, whose edge vanishes.
  void replace(const Index h, const Index by)
  {
    const Index f = m_mesh.face(h), previous = m_mesh.previous(h);
    m_mesh.m_next[previous] = by;
    m_mesh.m_next[by] = m_mesh.next(h);
    m_mesh.m_face[by] = f;
    m_mesh.m_face_halfedge[f] = by;
    m_refined.uv[by] = m_refined.uv[h];
    const Index h_opposite = opposite(h), by_opposite = opposite(by);
    for (std::vector<int>* on_curve : {&m_refined.input_halfedge, &m_refined.final_halfedge})
      if ((*on_curve)[by] == none) {
        (*on_curve)[by] = (*on_curve)[h];
        (*on_curve)[by_opposite] = (*on_curve)[h_opposite];
      }
    m_is_cut[edge_of(by)] = m_is_cut[edge_of(by)] || m_is_cut[edge_of(h)];
    m_mesh.m_face[h] = none;
  }

  // Renumbers what is left.
  void compress()
  {
    std::vector<Index> new_vertex(m_mesh.number_of_vertices(), none), new_halfedge(m_mesh.number_of_halfedges(), none),
        new_face(m_mesh.number_of_faces(), none);
    Refined_triangulation result;
    std::vector<char> is_cut;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f) {
      if (m_is_removed[f])
        continue;
      new_face[f] = result.mesh.number_of_faces();
      result.mesh.m_face_halfedge.push_back(m_mesh.halfedge_of_face(f));
      result.input_face.push_back(m_refined.input_face[f]);
      Index h = m_mesh.halfedge_of_face(f);
      for (int i = 0; i < 3; ++i, h = m_mesh.next(h))
        new_vertex[m_mesh.target(h)] = new_halfedge[h] = new_halfedge[opposite(h)] = 0; // in use
    }
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (new_vertex[v] != none) {
        new_vertex[v] = static_cast<Index>(result.point.size());
        result.point.push_back(m_refined.point[v]);
        result.place.push_back(m_refined.place[v]);
      }
    result.mesh.m_number_of_vertices = static_cast<Index>(result.point.size());
    Index count = 0;
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (new_halfedge[h] != none)
        new_halfedge[h] = count++;
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      if (new_halfedge[h] == none)
        continue;
      result.mesh.m_next.push_back(new_halfedge[m_mesh.next(h)]);
      result.mesh.m_target.push_back(new_vertex[m_mesh.target(h)]);
      result.mesh.m_face.push_back(m_mesh.face(h) != none ? new_face[m_mesh.face(h)] : none);
      result.uv.push_back(m_refined.uv[h]);
      result.input_halfedge.push_back(m_refined.input_halfedge[h]);
      result.final_halfedge.push_back(m_refined.final_halfedge[h]);
      if (is_along_edge(h))
        is_cut.push_back(m_is_cut[edge_of(h)]);
    }
    for (Index& h : result.mesh.m_face_halfedge)
      h = new_halfedge[h];
    m_refined = std::move(result);
    m_is_cut = std::move(is_cut);
  }

  const Triangulation_connectivity& m_input;
  const std::vector<std::array<double, 3>>& m_input_point;
  Refined_triangulation& m_refined;
  Triangulation_connectivity& m_mesh;
  std::vector<char>& m_is_cut;
  std::vector<Projection> m_projection; // per input face
  std::vector<char> m_is_removed;       // per face
  std::vector<Index> m_outgoing;        // per vertex
  bool m_may_leave_bad = false;         // whether a collapse may
  int m_first_bad_input_face = none;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SLIVER_REMOVAL_H
