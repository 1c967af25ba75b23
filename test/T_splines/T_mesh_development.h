// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_T_MESH_DEVELOPMENT_H
#define T_SPLINES_TEST_T_MESH_DEVELOPMENT_H

#include "Exact_t_mesh.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

/// The rectangle [0, width] x [0, height], and triangles cut off by it, exactly.
struct Exact_rectangle {
  using Polygon = std::vector<Exact_point>;
  Exact width, height;

  bool contains(const Exact_point& p) const
  {
    return p.first >= 0 && p.first <= width && p.second >= 0 && p.second <= height;
  }
  bool contains_inside(const Exact_point& p) const
  {
    return p.first > 0 && p.first < width && p.second > 0 && p.second < height;
  }
  bool is_corner(const Exact_point& p) const
  {
    return (p.first == 0 || p.first == width) && (p.second == 0 || p.second == height);
  }

  /// How far p is inside of the line of a side.
  Exact distance(const Exact_point& p, const int side) const
  {
    switch (side) {
    case 0: return p.second;
    case 1: return width - p.first;
    case 2: return height - p.second;
    default: return p.first;
    }
  }
  /// The position of p along a side.
  Exact along(const Exact_point& p, const int side) const { return distance(p, (side + 3) % 4); }

  Polygon clip(Polygon polygon) const
  {
    for (int side = 0; side < 4 && !polygon.empty(); ++side) {
      Polygon result;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Exact_point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const Exact a = distance(p, side), b = distance(q, side);
        if (a >= 0)
          result.push_back(p);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
          const Exact t = a / (a - b);
          result.emplace_back(p.first + t * (q.first - p.first), p.second + t * (q.second - p.second));
        }
      }
      polygon.swap(result);
    }
    return polygon;
  }

  static Exact doubled_area(const Polygon& polygon)
  {
    Exact result(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
      result += cross_product(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return result;
  }

  /// Whether a segment meets the inside.
  bool is_entered_by(const Exact_point& p, const Exact_point& q) const
  {
    Exact first(0), last(1);
    for (int side = 0; side < 4; ++side) {
      const Exact a = distance(p, side), b = distance(q, side);
      if (a <= 0 && b <= 0)
        return false;
      if (a < 0)
        first = std::max(first, Exact(a / (a - b)));
      if (b < 0)
        last = std::min(last, Exact(a / (a - b)));
    }
    if (first >= last)
      return false;
    const Exact t = (first + last) / 2;
    return contains_inside({p.first + t * (q.first - p.first), p.second + t * (q.second - p.second)});
  }
};

/// Develops the faces of a T-mesh over the triangles of the surface: breadth first from the anchor of a face, by exact
/// transitions, through every edge that meets the inside of the face's rectangle. A face without an anchor gets one from
/// a neighbor.
///
/// The pieces of triangles must fill each rectangle, and each triangle, to the last bit; across each edge of the T-mesh
/// the developments must fit together by the transition of the knots.
class T_mesh_development {
public:
  T_mesh_development(const Exact_map& map, const Exact_t_mesh& t_mesh, Check_result& result)
    : m_map(map),
      m_t_mesh(t_mesh),
      m_result(result),
      m_visits(map.number_of_triangles()),
      m_sheets(t_mesh.number_of_faces()),
      m_whole(map.number_of_triangles(), 0),
      m_parts(map.number_of_triangles(), Exact(0)),
      m_crossing(t_mesh.number_of_halfedges()),
      m_runs(t_mesh.number_of_halfedges())
  {
    for (int t = 0; t < map.number_of_triangles(); ++t)
      m_area.push_back(map.doubled_area(t));
    for (const Exact_point& p : map.uv)
      m_interval.push_back({{CGAL::to_interval(p.first), CGAL::to_interval(p.second)}});
  }

  void check()
  {
    develop_all();
    for (int t = 0; t < m_map.number_of_triangles(); ++t)
      if (m_whole[t] * m_area[t] + m_parts[t] != m_area[t])
        fail("not covered once by the faces: triangle", t);
    if (!m_result.success())
      return;
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h)
      check_crossing(h);
    check_vertices();
    check_points();
    check_polylines();
  }

  std::size_t number_of_pieces() const { return m_number_of_pieces; }
  double point_deviation() const { return m_point_deviation; }       ///< by the diagonal of the bounding box
  double polyline_deviation() const { return m_polyline_deviation; } ///< by the diagonal of the bounding box

private:
  using Polygon = Exact_rectangle::Polygon;
  using Vector_3 = std::array<double, 3>;
  static constexpr int none = Exact_map::none;
  static constexpr std::size_t most_pieces_of_face = 2000000;
  static constexpr double tolerance = 1e-9; // of points in space, which are doubles

  // Triangles that are developed with the same similarity from their charts to a face.
  struct Sheet {
    Exact_similarity to_face;
    std::array<double, 4> inside; // a box in the chart, u and v from to, that surely lies in the open rectangle
    Exact whole_area;             // doubled, of the triangles that lie in the rectangle as a whole
  };
  struct Visit {
    int face, sheet;
  };
  // A part of a halfedge of the T-mesh inside one triangle.
  struct Crossing {
    int triangle = none, sheet = none;
    int along = none; // halfedge of the triangle, if the T-mesh edge runs along it
  };
  struct Run {
    Exact begin;
    Vector_3 from, to;
  };

  void fail(const std::string& what, const long element) { m_result.fail(what, element); }

  Exact_rectangle rectangle(const int f) const { return {m_t_mesh.frame[f].width, m_t_mesh.frame[f].height}; }

  static std::size_t key(const Exact_similarity& s)
  {
    const std::hash<double> hash;
    return hash(CGAL::to_double(s.u())) * 31 + hash(CGAL::to_double(s.v())) * 7 + s.quarter_turns();
  }

  // The sheet with this similarity, or `none`.
  int find_sheet(const int f, const Exact_similarity& to_face) const
  {
    const auto& sheets = m_sheets[f];
    for (std::size_t i = 0; i < sheets.size(); ++i)
      if (sheets[i].to_face == to_face)
        return static_cast<int>(i);
    return none;
  }

  int sheet(const int f, const Exact_similarity& to_face)
  {
    const auto range = m_sheet_of_key.equal_range(key(to_face));
    for (auto i = range.first; i != range.second; ++i)
      if (m_sheets[f][i->second].to_face == to_face)
        return i->second;
    const Exact_rectangle r = rectangle(f);
    const Exact_similarity to_chart = to_face.inverse();
    const Exact_point p = to_chart(Exact(0), Exact(0)), q = to_chart(r.width, r.height);
    const auto box = [](const Exact& a, const Exact& b) {
      return std::make_pair(CGAL::to_interval(std::min(a, b)).second, CGAL::to_interval(std::max(a, b)).first);
    };
    const auto u = box(p.first, q.first), v = box(p.second, q.second);
    const int result = static_cast<int>(m_sheets[f].size());
    m_sheet_of_key.emplace(key(to_face), result);
    m_sheets[f].push_back({to_face, {{u.first, u.second, v.first, v.second}}, Exact(0)});
    return result;
  }

  bool is_visited(const int t, const int f, const int s) const
  {
    for (auto i = m_visits[t].rbegin(); i != m_visits[t].rend() && i->face == f; ++i)
      if (i->sheet == s)
        return true;
    return false;
  }

  void visit(const int t, const int f, const int s)
  {
    if (is_visited(t, f, s))
      return;
    m_visits[t].push_back({f, s});
    m_queue.emplace_back(t, s);
  }

  void cross(const int h, const int f, const int s)
  {
    const int g = m_map.opposite[h];
    if (g == none)
      fail("the border of the surface runs through face", f);
    else if (m_map.transition[g] == none)
      visit(g / 3, f, s);
    else
      visit(g / 3, f, sheet(f, compose(m_sheets[f][s].to_face, m_map.transition_of(g))));
  }

  void develop_all()
  {
    m_anchor = m_t_mesh.anchor;
    std::vector<char> is_done(m_t_mesh.number_of_faces(), 0);
    for (int first = 0; first < m_t_mesh.number_of_faces(); ++first) {
      if (is_done[first] || m_t_mesh.anchor[first].triangle == none)
        continue;
      std::vector<int> stack = {first};
      is_done[first] = 1;
      while (!stack.empty()) {
        const int f = stack.back();
        stack.pop_back();
        if (m_t_mesh.anchors_may_touch)
          move_anchor_inside(f);
        develop(f);
        for (const auto& side : m_t_mesh.frame[f].side)
          for (const int h : side) {
            const int other = m_t_mesh.face[h ^ 1];
            if (other == none || is_done[other] ||
                (m_t_mesh.anchor[other].triangle == none && !continue_across(h, m_anchor[other])))
              continue;
            is_done[other] = 1;
            stack.push_back(other);
          }
      }
    }
    for (int f = 0; f < m_t_mesh.number_of_faces(); ++f)
      if (!is_done[f])
        fail("no way from an anchor to face", f);
  }

  // To a triangle whose inside meets that of the rectangle, through edges that touch the rectangle.
  void move_anchor_inside(const int f)
  {
    const Exact_rectangle r = rectangle(f);
    std::vector<Exact_t_mesh::Anchor> queue = {m_anchor[f]};
    for (std::size_t i = 0; i < queue.size() && i < 1000; ++i) {
      const Exact_t_mesh::Anchor anchor = queue[i];
      Polygon corner;
      for (int h = 3 * anchor.triangle; h < 3 * anchor.triangle + 3; ++h)
        corner.push_back(anchor.to_face(m_map.uv[h].first, m_map.uv[h].second));
      const Polygon piece = r.clip(corner);
      if (Exact_rectangle::doubled_area(piece) > 0) {
        m_anchor[f] = anchor;
        return;
      }
      for (int k = 0; k < 3; ++k) {
        const int g = m_map.opposite[3 * anchor.triangle + k];
        if (g == none || r.clip({corner[(k + 2) % 3], corner[k]}).empty())
          continue;
        const Exact_t_mesh::Anchor next = {g / 3, compose(anchor.to_face, m_map.transition_of(g))};
        if (std::none_of(queue.begin(), queue.end(), [&](const Exact_t_mesh::Anchor& a) {
              return a.triangle == next.triangle && a.to_face == next.to_face;
            }))
          queue.push_back(next);
      }
    }
  }

  void develop(const int f)
  {
    m_sheet_of_key.clear();
    m_queue.clear();
    visit(m_anchor[f].triangle, f, sheet(f, m_anchor[f].to_face));
    Exact area(0);
    std::size_t i = 0;
    for (; i < m_queue.size() && i < most_pieces_of_face; ++i) {
      const auto [t, s] = m_queue[i];
      if (is_surely_inside(t, m_sheets[f][s]))
        take_whole(t, f, s);
      else
        area += take_part(t, f, s);
    }
    m_number_of_pieces += m_queue.size();
    for (const Sheet& sheet : m_sheets[f])
      area += sheet.whole_area * sheet.to_face.scale() * sheet.to_face.scale();
    if (i < m_queue.size())
      fail("the development does not end: face", f);
    else if (area != 2 * rectangle(f).width * rectangle(f).height)
      fail("the areas of the pieces do not add up to width times height: face", f);
  }

  bool is_surely_inside(const int t, const Sheet& sheet) const
  {
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      for (int axis = 0; axis < 2; ++axis)
        if (!(m_interval[h][axis].first > sheet.inside[2 * axis] &&
              m_interval[h][axis].second < sheet.inside[2 * axis + 1]))
          return false;
    return true;
  }

  void take_whole(const int t, const int f, const int s)
  {
    ++m_whole[t];
    m_sheets[f][s].whole_area += m_area[t];
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      cross(h, f, s);
  }

  // Returns the doubled area of the piece in the frame of the face.
  Exact take_part(const int t, const int f, const int s)
  {
    const Exact_rectangle r = rectangle(f);
    const Exact_similarity to_face = m_sheets[f][s].to_face; // sheets may be added below
    Polygon corner;
    for (int h = 3 * t; h < 3 * t + 3; ++h)
      corner.push_back(to_face(m_map.uv[h].first, m_map.uv[h].second));
    const Polygon piece = r.clip(corner);
    const Exact area = Exact_rectangle::doubled_area(piece);
    if (area <= 0)
      fail("the anchor does not overlap face", f);
    m_parts[t] += area / (to_face.scale() * to_face.scale());
    for (int i = 0; i < 3; ++i)
      if (r.is_entered_by(corner[(i + 2) % 3], corner[i]))
        cross(3 * t + i, f, s);
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (int side = 0; side < 4; ++side)
        if (r.distance(piece[i], side) == 0 && r.distance(piece[(i + 1) % piece.size()], side) == 0 &&
            piece[i] != piece[(i + 1) % piece.size()])
          run_along_side(t, f, s, side, r.along(piece[i], side), r.along(piece[(i + 1) % piece.size()], side), corner);
    return area;
  }

  // The piece of the triangle touches a side from x to y.
  void run_along_side(const int t, const int f, const int s, const int side, const Exact& x, const Exact& y,
                      const Polygon& corner)
  {
    int along = none;
    for (int i = 0; i < 3; ++i)
      if (rectangle(f).distance(corner[i], side) == 0 && rectangle(f).distance(corner[(i + 2) % 3], side) == 0)
        along = 3 * t + i;
    const auto& halfedges = m_t_mesh.frame[f].side[side];
    auto h = std::partition_point(halfedges.begin(), halfedges.end(),
                                  [&](const int g) { return m_t_mesh.start[g] + m_t_mesh.knot[g] <= x; });
    for (; h != halfedges.end() && m_t_mesh.start[*h] < y; ++h) {
      if (m_crossing[*h].triangle == none)
        m_crossing[*h] = {t, s, along};
      const Exact from = std::max(x, m_t_mesh.start[*h]),
                  to = std::min(y, Exact(m_t_mesh.start[*h] + m_t_mesh.knot[*h]));
      if (!m_map.point.empty())
        m_runs[*h].push_back({from, point_in_space(t, f, s, m_t_mesh.point_of_side(f, side, from)),
                              point_in_space(t, f, s, m_t_mesh.point_of_side(f, side, to))});
    }
  }

  // The point of a triangle with these coordinates in the frame of a face.
  Vector_3 point_in_space(const int t, const int f, const int s, const Exact_point& p) const
  {
    const Exact_point q = m_sheets[f][s].to_face.inverse()(p.first, p.second);
    Vector_3 result{};
    for (int i = 0; i < 3; ++i) {
      const Exact_point a = m_map.uv[3 * t + (i + 1) % 3] - q, b = m_map.uv[3 * t + (i + 2) % 3] - q;
      const double weight = CGAL::to_double(Exact(cross_product(a, b) / m_area[t]));
      for (int axis = 0; axis < 3; ++axis)
        result[axis] += weight * m_map.point[m_map.target[3 * t + i]][axis];
    }
    return result;
  }

  // The triangle beyond h that the development of the face of h leads to, in the frame of the opposite face.
  bool continue_across(const int h, Exact_t_mesh::Anchor& beyond) const
  {
    const Crossing& crossing = m_crossing[h];
    if (crossing.triangle == none || (crossing.along != none && m_map.opposite[crossing.along] == none))
      return false;
    const Exact_similarity to_face =
        compose(m_t_mesh.transition(h), m_sheets[m_t_mesh.face[h]][crossing.sheet].to_face);
    if (crossing.along == none) {
      beyond = {crossing.triangle, to_face};
      return true;
    }
    const int g = m_map.opposite[crossing.along];
    beyond = {g / 3, compose(to_face, m_map.transition_of(g))};
    return true;
  }

  // The development of the face of h, continued across h by the transition of the knots, is that of the opposite face.
  void check_crossing(const int h)
  {
    const int f = m_t_mesh.face[h], other = m_t_mesh.face[h ^ 1];
    if (f == none)
      return;
    const Crossing& crossing = m_crossing[h];
    if (crossing.triangle == none) {
      fail("no triangle at halfedge of the T-mesh", h);
      return;
    }
    const bool is_at_border = crossing.along != none && m_map.opposite[crossing.along] == none;
    if (is_at_border != (other == none))
      fail("the borders do not agree at halfedge of the T-mesh", h);
    Exact_t_mesh::Anchor beyond;
    if (is_at_border || other == none || !continue_across(h, beyond))
      return;
    const int t = beyond.triangle;
    const int s = find_sheet(other, beyond.to_face);
    if (s == none || std::none_of(m_visits[t].begin(), m_visits[t].end(),
                                  [&](const Visit& visit) { return visit.face == other && visit.sheet == s; }))
      fail("the developments do not fit across halfedge of the T-mesh", h);
  }

  // The vertices of the surface: their places, and that no cone lies inside a face or a side.
  void check_vertices()
  {
    std::vector<char> is_found(m_map.number_of_vertices(), m_t_mesh.place.empty());
    std::vector<char> is_border(m_map.number_of_vertices(), 0);
    for (std::size_t h = 0; h < m_map.target.size(); ++h)
      if (m_map.opposite[h] == none)
        is_border[m_map.target[h]] = is_border[m_map.source(static_cast<int>(h))] = 1;
    for (std::size_t h = 0; h < m_map.target.size(); ++h) {
      const int v = m_map.target[h];
      for (const Visit& visit : m_visits[h / 3]) {
        const Exact_rectangle r = rectangle(visit.face);
        const Exact_point p = m_sheets[visit.face][visit.sheet].to_face(m_map.uv[h].first, m_map.uv[h].second);
        if (!r.contains(p))
          continue;
        if (m_map.quarter_turns[v] != (is_border[v] ? 2 : 4) && !r.is_corner(p))
          fail("a cone lies inside a face or a side: vertex of the surface", v);
        if (m_t_mesh.place.empty())
          continue;
        const Exact_t_mesh::Place& place = m_t_mesh.place[v];
        const bool is_place = place.face == visit.face && is_near(place.at, p, r);
        is_found[v] |= is_place;
        if (!is_place && r.contains_inside(p))
          fail("inside a face that is not its place: vertex of the surface", v);
      }
    }
    for (int v = 0; v < m_map.number_of_vertices(); ++v)
      if (!is_found[v])
        fail("the place is wrong: vertex of the surface", v);
    for (int v = 0; v < m_t_mesh.number_of_vertices && !m_t_mesh.place.empty() && !m_t_mesh.origin.empty(); ++v)
      if (m_t_mesh.origin[v] != none && !is_at_vertex(m_t_mesh.place[m_t_mesh.origin[v]], v))
        fail("its origin has its place elsewhere: vertex of the T-mesh", v);
  }

  // Exactly, or up to the round-off of places in doubles.
  static bool is_near(const Exact_point& a, const Exact_point& b, const Exact_rectangle& r)
  {
    if (a == b)
      return true;
    const double size = std::max(CGAL::to_double(r.width), CGAL::to_double(r.height));
    return std::abs(CGAL::to_double(Exact(a.first - b.first))) <= tolerance * size &&
           std::abs(CGAL::to_double(Exact(a.second - b.second))) <= tolerance * size;
  }

  bool is_at_vertex(const Exact_t_mesh::Place& place, const int v) const
  {
    for (const auto& side : m_t_mesh.frame[place.face].side)
      for (const int h : side)
        if (m_t_mesh.target[h] == v && is_near(place.at, m_t_mesh.target_in_frame(h), rectangle(place.face)))
          return true;
    return false;
  }

  double diagonal() const
  {
    Vector_3 low = m_map.point[0], high = low;
    for (const Vector_3& p : m_map.point)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    return distance(low, high);
  }

  static double distance(const Vector_3& p, const Vector_3& q)
  {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  // The surface point of each vertex is where each incident face develops it.
  void check_points()
  {
    if (m_map.point.empty() || m_t_mesh.point.empty())
      return;
    const double size = diagonal();
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h) {
      if (m_runs[h].empty())
        continue;
      std::sort(m_runs[h].begin(), m_runs[h].end(), [](const Run& a, const Run& b) { return a.begin < b.begin; });
      const double deviation = std::max(distance(m_runs[h].front().from, m_t_mesh.point[m_t_mesh.source(h)]),
                                        distance(m_runs[h].back().to, m_t_mesh.point[m_t_mesh.target[h]])) /
                               size;
      m_point_deviation = std::max(m_point_deviation, deviation);
      if (!(deviation <= tolerance))
        fail("surface points of the ends are elsewhere: halfedge of the T-mesh", h);
    }
  }

  // The polyline of an edge goes through the triangles that the edge crosses, one after the other.
  void check_polylines()
  {
    if (m_map.point.empty() || m_t_mesh.polyline.empty())
      return;
    const double size = diagonal();
    for (std::size_t e = 0; e < m_t_mesh.polyline.size(); ++e) {
      const int along = m_t_mesh.halfedge_of_edge[e], h = m_t_mesh.face[along] == none ? along ^ 1 : along;
      std::vector<Vector_3> expected;
      for (const Run& run : m_runs[h])
        for (const Vector_3& p : {run.from, run.to})
          if (expected.empty() || distance(expected.back(), p) > tolerance * size)
            expected.push_back(p);
      if (h != along)
        std::reverse(expected.begin(), expected.end());
      std::vector<Vector_3> given;
      for (const Vector_3& p : m_t_mesh.polyline[e])
        if (given.empty() || distance(given.back(), p) > tolerance * size)
          given.push_back(p);
      if (given.size() != expected.size()) {
        fail("the polyline has " + std::to_string(given.size()) + " points, the edge crosses triangles at " +
                 std::to_string(expected.size()) + ": edge of the T-mesh",
             static_cast<long>(e));
        continue;
      }
      for (std::size_t i = 0; i < given.size(); ++i) {
        m_polyline_deviation = std::max(m_polyline_deviation, distance(given[i], expected[i]) / size);
        if (!(distance(given[i], expected[i]) <= tolerance * size))
          fail("the polyline leaves the edge: edge of the T-mesh", static_cast<long>(e));
      }
    }
  }

  const Exact_map& m_map;
  const Exact_t_mesh& m_t_mesh;
  Check_result& m_result;
  std::vector<Exact_t_mesh::Anchor> m_anchor;                       // per face
  std::vector<Exact> m_area;                                        // per triangle, doubled
  std::vector<std::array<std::pair<double, double>, 2>> m_interval; // per corner
  std::vector<std::vector<Visit>> m_visits;                         // per triangle; those of a face are consecutive
  std::vector<std::vector<Sheet>> m_sheets;                         // per face
  std::vector<int> m_whole;                                         // per triangle: how often inside a face as a whole
  std::vector<Exact> m_parts;                                       // per triangle: doubled area of the other pieces
  std::vector<Crossing> m_crossing;                                 // per halfedge of the T-mesh
  std::vector<std::vector<Run>> m_runs;                             // per halfedge of the T-mesh
  std::unordered_multimap<std::size_t, int> m_sheet_of_key;         // of the current face
  std::vector<std::pair<int, int>> m_queue;                         // of the current face: triangle, sheet
  std::size_t m_number_of_pieces = 0;
  double m_point_deviation = 0, m_polyline_deviation = 0;
};

#endif // T_SPLINES_TEST_T_MESH_DEVELOPMENT_H
