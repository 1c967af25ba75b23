// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_MAP_CHECKER_H
#define T_SPLINES_TEST_MAP_CHECKER_H

#include "Plain_map.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <queue>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// What is found out about a map: the worst figures, and what is wrong. Angles are in radians.
struct Map_check {
  std::size_t vertices = 0, added_vertices = 0, faces = 0, seam_edges = 0, branches = 0;
  double surface_distance = 0; ///< of an added vertex to the input surface, by the diagonal of the bounding box
  double area_deviation = 0;   ///< of the refinement of an input face from its area, by the square of its longest side
  double rotation_deviation = 0;   ///< of a branch's transition from quarter turns
  double transition_deviation = 0; ///< of corners from the transition of their branch, by the size of the coordinates
  double transition_by_extent = 0; ///< the same, by the extent of the branch
  double scale_deviation = 0;      ///< of the product of the transitions' scales around a vertex from 1 (logarithm)
  double cone_angle_deviation = 0; ///< of the sum of the uv corner angles around a vertex
  double loop_deviation = 0;       ///< of the turning of a loop
  double largest_log_scale = 0;    ///< of a transition: how far from isometric the map is
  std::size_t number_of_failures = 0;
  std::vector<std::string> failures; ///< the first few

  bool success() const { return number_of_failures == 0; }

  std::string text() const
  {
    std::ostringstream out;
    out << vertices << " vertices (" << added_vertices << " added), " << faces << " faces, " << seam_edges
        << " seam edges, " << branches << " branches\nsurface " << surface_distance << ", area " << area_deviation
        << ", rotation " << rotation_deviation << ", transition " << transition_deviation << " (by extent "
        << transition_by_extent << "), scale " << scale_deviation << ", cone angle " << cone_angle_deviation
        << ", loop " << loop_deviation << ", largest log scale " << largest_log_scale << "\n";
    for (const std::string& failure : failures)
      out << failure << "\n";
    out << number_of_failures << " failures";
    return out.str();
  }
};

/// Judges a seamless similarity map from its points and corner uv alone.
///
/// Nothing of the computation is used: which input face a refined triangle lies in, the seams, their transitions, the cone angles and
/// the turning of the loops are all found again.
///
/// Where coordinates have many digits before an edge's length begins, the edge has few digits left: beyond the fixed tolerances, angles may be off
/// by the round-off of the coordinates of the seam edges that enter them.
class Map_checker {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Real = long double;
  using Complex = std::complex<Real>;
  using Vector = std::array<Real, 3>;
  using Indices = std::vector<int>;
  static constexpr int none = -1;
  static constexpr double angle_tolerance = 1e-9;

public:
  Map_checker(const Plain_mesh& input, const Plain_map& refined, const Plain_signature& signature)
    : m_input(input),
      m_refined(refined),
      m_signature(signature)
  {
  }

  Map_check check()
  {
    m_check.vertices = m_refined.points.size();
    m_check.added_vertices = m_refined.points.size() - std::min(m_refined.points.size(), m_input.points.size());
    m_check.faces = m_refined.triangles.size();
    if (check_vertices() && check_connectivity()) {
      check_uv_orientation();
      locate_vertices();
      find_input_faces();
      check_surface_orientation();
      find_seams();
      check_branches();
      check_vertex_holonomy();
      check_cone_angles();
      for (std::size_t i = 0; i < m_signature.loops.size(); ++i)
        check_loop(i);
    }
    return m_check;
  }

private:
  void fail(const std::string& what, const std::size_t element)
  {
    if (m_check.number_of_failures++ < 20)
      m_check.failures.push_back(what + " " + std::to_string(element));
  }

  // A halfedge of a mesh is 3 t + i: from corner i to corner i + 1 of triangle t, which is on its left.
  static int next(const int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(const int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int source(const int h) const { return m_refined.triangles[h / 3][h % 3]; }
  int target(const int h) const { return source(next(h)); }
  int opposite(const int h) const { return m_opposite[h]; }
  int next_around_source(const int h) const { return opposite(previous(h)); }

  // uv of the source of h in the chart of its face.
  Complex uv(const int h) const { return {m_refined.uv[h / 3][h % 3][0], m_refined.uv[h / 3][h % 3][1]}; }
  bool same_uv(const int h, const int k) const { return m_refined.uv[h / 3][h % 3] == m_refined.uv[k / 3][k % 3]; }
  int quarter_turns(const int v) const { return v < static_cast<int>(m_k.size()) ? m_k[v] : 4; }

  bool check_vertices()
  {
    for (std::size_t v = 0; v < m_input.points.size(); ++v)
      if (v >= m_refined.points.size() ||
          std::memcmp(&m_input.points[v], &m_refined.points[v], sizeof m_input.points[v]) != 0)
        fail("the input is not reproduced at vertex", v);
    for (std::size_t t = 0; t < m_refined.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (!std::isfinite(m_refined.uv[t][i][0]) || !std::isfinite(m_refined.uv[t][i][1]))
          fail("uv is not finite in triangle", t);
    m_k.assign(m_input.points.size(), 4);
    for (const auto& cone : m_signature.cones)
      m_k[cone.first] = cone.second;
    return m_check.success();
  }

  // Opposite halfedges; what has none, or more than one, is a failure.
  Indices opposites(const Plain_mesh& mesh)
  {
    std::vector<std::pair<std::array<int, 2>, int>> by_ends;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        by_ends.push_back({{{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]}}, static_cast<int>(3 * t + i)});
    std::sort(by_ends.begin(), by_ends.end());
    Indices result(by_ends.size(), none);
    for (std::size_t i = 0; i < by_ends.size(); ++i) {
      if (i > 0 && by_ends[i].first == by_ends[i - 1].first)
        fail("an edge has two faces on one side, triangle", by_ends[i].second / 3);
      const std::array<int, 2> ends = {{by_ends[i].first[1], by_ends[i].first[0]}};
      const auto found = std::lower_bound(by_ends.begin(), by_ends.end(), std::make_pair(ends, none));
      if (found == by_ends.end() || found->first != ends)
        fail("an edge has one face only, triangle", by_ends[i].second / 3);
      else
        result[by_ends[i].second] = found->second;
    }
    return result;
  }

  static long euler_characteristic(const Plain_mesh& mesh)
  {
    return static_cast<long>(mesh.points.size()) - static_cast<long>(mesh.triangles.size()) / 2;
  }

  bool check_connectivity()
  {
    m_input_opposite = opposites(m_input);
    m_opposite = opposites(m_refined);
    if (!m_check.success())
      return false;
    if (euler_characteristic(m_input) != euler_characteristic(m_refined))
      fail("the Euler characteristic is not that of the input:", m_refined.triangles.size());
    Indices corners(m_refined.points.size(), 0);
    m_outgoing.assign(m_refined.points.size(), none);
    for (int h = 0; h < static_cast<int>(m_opposite.size()); ++h) {
      ++corners[source(h)];
      m_outgoing[source(h)] = h;
    }
    for (std::size_t v = 0; v < corners.size(); ++v) {
      int h = m_outgoing[v], degree = 0;
      if (h != none)
        do {
          h = next_around_source(h);
          ++degree;
        } while (h != m_outgoing[v]);
      if (degree == 0 || degree != corners[v])
        fail("not manifold or isolated: vertex", v);
    }
    return m_check.success();
  }

  void check_uv_orientation()
  {
    for (std::size_t t = 0; t < m_refined.triangles.size(); ++t) {
      const auto& c = m_refined.uv[t];
      if (orientation(c[0], c[1], c[2]) != CGAL::LEFT_TURN)
        fail("not positively oriented in the plane: triangle", t);
    }
  }

  static CGAL::Orientation orientation(const std::array<double, 2>& p, const std::array<double, 2>& q,
                                       const std::array<double, 2>& r)
  {
    return CGAL::orientation(Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1]), Kernel::Point_2(r[0], r[1]));
  }

  static Vector difference(const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    return {{Real(p[0]) - Real(q[0]), Real(p[1]) - Real(q[1]), Real(p[2]) - Real(q[2])}};
  }
  static Vector minus(const Vector& a, const Vector& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
  static Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b)
  {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  }
  static Real norm(const Vector& a) { return std::sqrt(dot(a, a)); }

  // Distance of the origin to the segment a-b.
  static Real distance_to_segment(const Vector& a, const Vector& b)
  {
    const Vector d = minus(b, a);
    if (dot(a, d) >= 0)
      return norm(a);
    if (dot(b, d) <= 0)
      return norm(b);
    return norm(cross(a, b)) / norm(d);
  }

  // The corners of an input face as seen from a point.
  std::array<Vector, 3> seen_from(const std::array<double, 3>& p, const int face) const
  {
    const auto& t = m_input.triangles[face];
    return {{difference(m_input.points[t[0]], p), difference(m_input.points[t[1]], p),
             difference(m_input.points[t[2]], p)}};
  }

  static Real distance_to_triangle(const std::array<Vector, 3>& t)
  {
    const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    bool is_above = true;
    Real result = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < 3; ++i) {
      const Vector &a = t[i], &b = t[(i + 1) % 3];
      is_above = is_above && dot(cross(a, b), normal) >= 0;
      result = std::min(result, distance_to_segment(a, b));
    }
    return is_above ? std::min(result, std::abs(dot(t[0], cross(t[1], t[2]))) / norm(normal)) : result;
  }

  // An input edge is named by the smaller of its halfedges.
  int input_edge(const int h) const { return std::min(h, m_input_opposite[h]); }

  // The two families of boxes meet where a vertex is close to a face.
  void locate_vertices()
  {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
    double low[3], high[3], largest = 0;
    for (int k = 0; k < 3; ++k) {
      low[k] = high[k] = m_input.points[0][k];
      for (const auto& p : m_input.points) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
        largest = std::max(largest, std::abs(p[k]));
      }
    }
    const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const double round_off = largest * std::numeric_limits<double>::epsilon();
    const double search = 1e-7 * diagonal + 4 * round_off;
    const int inputs = static_cast<int>(m_input.points.size()), all = static_cast<int>(m_refined.points.size());
    std::vector<Box> face_boxes, vertex_boxes;
    for (int f = 0; f < static_cast<int>(m_input.triangles.size()); ++f) {
      CGAL::Bbox_3 box;
      for (const int v : m_input.triangles[f])
        box += Kernel::Point_3(m_input.points[v][0], m_input.points[v][1], m_input.points[v][2]).bbox();
      face_boxes.emplace_back(box, f);
    }
    for (int v = inputs; v < all; ++v) {
      const auto& p = m_refined.points[v];
      vertex_boxes.emplace_back(
          CGAL::Bbox_3(p[0] - search, p[1] - search, p[2] - search, p[0] + search, p[1] + search, p[2] + search), v);
    }
    std::vector<Real> distance(all, search);
    std::vector<std::pair<int, int>> neighbors;
    CGAL::box_intersection_d(vertex_boxes.begin(), vertex_boxes.end(), face_boxes.begin(), face_boxes.end(),
                             [&](const Box& a, const Box& b) {
                               const int v = a.info(), f = b.info();
                               distance[v] =
                                   std::min(distance[v], distance_to_triangle(seen_from(m_refined.points[v], f)));
                               neighbors.emplace_back(v, f);
                             });
    for (int v = inputs; v < all; ++v) {
      m_check.surface_distance = std::max(m_check.surface_distance, static_cast<double>(distance[v]) / diagonal);
      if (distance[v] > 1e-12 * diagonal + round_off)
        fail("not on the input surface: vertex", v);
    }
    collect_places(neighbors, 4 * round_off + diagonal * std::min(4 * m_check.surface_distance, 1e-12));
  }

  // On which input faces and edges each vertex lies; an added one, if it is as close as `close`.
  void collect_places(const std::vector<std::pair<int, int>>& neighbors, const Real close)
  {
    m_faces_at.assign(m_refined.points.size(), {});
    m_edges_at.assign(m_refined.points.size(), {});
    for (int h = 0; h < static_cast<int>(3 * m_input.triangles.size()); ++h) {
      const int v = m_input.triangles[h / 3][h % 3];
      m_faces_at[v].push_back(h / 3);
      m_edges_at[v].push_back(input_edge(h));
    }
    for (const auto& [v, f] : neighbors) {
      const std::array<Vector, 3> corners = seen_from(m_refined.points[v], f);
      if (distance_to_triangle(corners) > close)
        continue;
      m_faces_at[v].push_back(f);
      for (int i = 0; i < 3; ++i)
        if (distance_to_segment(corners[i], corners[(i + 1) % 3]) <= close)
          m_edges_at[v].push_back(input_edge(3 * f + i));
    }
    for (std::size_t v = 0; v < m_refined.points.size(); ++v) {
      sort_unique(m_faces_at[v]);
      sort_unique(m_edges_at[v]);
    }
  }

  static void sort_unique(Indices& list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  static Indices intersection(const Indices& a, const Indices& b)
  {
    Indices result;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  // The input face of each triangle. Triangles whose common edge lies on no input edge are in one face; where, within round-off, that
  // leaves a choice, the face is taken on which they are positive.
  void find_input_faces()
  {
    const int triangles = static_cast<int>(m_refined.triangles.size());
    Indices representative(triangles);
    std::iota(representative.begin(), representative.end(), 0);
    const auto find = [&](int t) {
      while (representative[t] != t)
        t = representative[t] = representative[representative[t]];
      return t;
    };
    for (int h = 0; h < 3 * triangles; ++h)
      if (h < opposite(h) && intersection(m_edges_at[source(h)], m_edges_at[target(h)]).empty())
        representative[find(h / 3)] = find(opposite(h) / 3);
    std::vector<Indices> candidates(triangles), members(triangles);
    for (int t = 0; t < triangles; ++t) {
      const int group = find(t);
      for (int i = 0; i < 3; ++i) {
        const Indices& faces = m_faces_at[m_refined.triangles[t][i]];
        candidates[group] = members[group].empty() && i == 0 ? faces : intersection(candidates[group], faces);
      }
      members[group].push_back(t);
    }
    m_input_face.assign(triangles, none);
    for (int group = 0; group < triangles; ++group) {
      if (members[group].empty())
        continue;
      if (candidates[group].empty()) {
        fail("in no input face: triangle", members[group].front());
        continue;
      }
      int face = candidates[group].front();
      for (std::size_t i = candidates[group].size(); candidates[group].size() > 1 && i-- > 0;)
        if (std::all_of(members[group].begin(), members[group].end(),
                        [&](const int t) { return is_positive(t, candidates[group][i]); }))
          face = candidates[group][i];
      for (const int t : members[group])
        m_input_face[t] = face;
    }
  }

  // Whether a triangle has the orientation of the input face, seen along the axis along which the face is largest.
  bool is_positive(const int triangle, const int face) const
  {
    const auto& f = m_input.triangles[face];
    const auto& t = m_refined.triangles[triangle];
    const Vector normal = cross(difference(m_input.points[f[1]], m_input.points[f[0]]),
                                difference(m_input.points[f[2]], m_input.points[f[0]]));
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(normal[k]) > std::abs(normal[axis]))
        axis = k;
    const auto seen = [axis](const std::array<double, 3>& p) {
      return std::array<double, 2>{{p[(axis + 1) % 3], p[(axis + 2) % 3]}};
    };
    const CGAL::Orientation of_face =
        orientation(seen(m_input.points[f[0]]), seen(m_input.points[f[1]]), seen(m_input.points[f[2]]));
    const CGAL::Orientation of_triangle =
        orientation(seen(m_refined.points[t[0]]), seen(m_refined.points[t[1]]), seen(m_refined.points[t[2]]));
    return of_face != CGAL::COLLINEAR && of_face == of_triangle;
  }

  static Real area(const Plain_mesh& mesh, const int t)
  {
    const auto& c = mesh.triangles[t];
    return norm(cross(difference(mesh.points[c[1]], mesh.points[c[0]]),
                      difference(mesh.points[c[2]], mesh.points[c[0]]))) /
           2;
  }

  void check_surface_orientation()
  {
    std::vector<Real> covered(m_input.triangles.size(), 0);
    for (int t = 0; t < static_cast<int>(m_refined.triangles.size()); ++t) {
      if (m_input_face[t] == none)
        continue;
      covered[m_input_face[t]] += area(m_refined, t);
      if (!is_positive(t, m_input_face[t]))
        fail("not positive on the surface: triangle", t);
    }
    for (int f = 0; f < static_cast<int>(covered.size()); ++f) {
      const auto& c = m_input.triangles[f];
      Real longest = 0, largest = 0;
      for (int i = 0; i < 3; ++i) {
        longest = std::max(longest, norm(difference(m_input.points[c[i]], m_input.points[c[(i + 1) % 3]])));
        for (const double x : m_input.points[c[i]])
          largest = std::max(largest, std::abs(Real(x)));
      }
      const Real deviation = std::abs(covered[f] - area(m_input, f)) / (longest * longest);
      m_check.area_deviation = std::max(m_check.area_deviation, static_cast<double>(deviation));
      if (deviation > 1e-9 + 1e-14 * largest / longest)
        fail("not covered by its refinement: input face", f);
    }
  }

  void find_seams()
  {
    m_is_seam.assign(m_opposite.size(), 0);
    m_seams_at.assign(m_refined.points.size(), {});
    for (int h = 0; h < static_cast<int>(m_opposite.size()); ++h)
      if (!same_uv(h, next(opposite(h))) || !same_uv(next(h), opposite(h))) {
        m_is_seam[h] = 1;
        m_seams_at[source(h)].push_back(h);
        m_check.seam_edges += h < opposite(h) ? 1 : 0;
      }
  }

  // The relative round-off of the vector of a seam edge, both sides together; 0 if the edge is no seam.
  Real noise(const int h) const
  {
    if (!m_is_seam[h])
      return 0;
    const auto one_side = [this](const int k) {
      return std::max(std::abs(uv(k)), std::abs(uv(next(k)))) / std::abs(uv(next(k)) - uv(k));
    };
    return 4 * std::numeric_limits<double>::epsilon() * (one_side(h) + one_side(opposite(h)));
  }

  void check_branches()
  {
    m_branch_quarter_turns.assign(m_opposite.size(), 0);
    m_branch_log_scale.assign(m_opposite.size(), 0);
    const auto is_inner = [this](const int v) { return m_seams_at[v].size() == 2 && quarter_turns(v) == 4; };
    std::vector<char> is_done(m_opposite.size(), 0);
    for (const bool closed : {false, true})
      for (int first = 0; first < static_cast<int>(m_opposite.size()); ++first) {
        if (!m_is_seam[first] || is_done[first] || (!closed && is_inner(source(first))))
          continue;
        Indices branch;
        int h = first;
        do {
          branch.push_back(h);
          is_done[h] = is_done[opposite(h)] = 1;
          const int v = target(h);
          if (!is_inner(v))
            break;
          h = m_seams_at[v][m_seams_at[v][0] == opposite(h) ? 1 : 0];
        } while (h != first);
        check_branch(branch);
      }
  }

  // Fits the transition from the chart on the left of the branch to that on its right: q = a p + b.
  void check_branch(const Indices& branch)
  {
    ++m_check.branches;
    std::vector<Complex> p, q;
    for (const int h : branch) {
      p.insert(p.end(), {uv(h), uv(next(h))});
      q.insert(q.end(), {uv(next(opposite(h))), uv(opposite(h))});
    }
    const Real count = static_cast<Real>(p.size());
    const Complex p_mean = std::accumulate(p.begin(), p.end(), Complex()) / count,
                  q_mean = std::accumulate(q.begin(), q.end(), Complex()) / count;
    Complex product;
    Real square = 0, extent = 0, size = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      product += (q[i] - q_mean) * std::conj(p[i] - p_mean);
      square += std::norm(p[i] - p_mean);
      extent = std::max(extent, std::abs(q[i] - q_mean));
      size = std::max(size, std::abs(q[i]));
    }
    const Complex fitted = product / square;
    const Real quarter = std::atan2(Real(1), Real(0));
    const int r = static_cast<int>(std::lround(std::arg(fitted) / quarter));
    const Complex a = std::polar(std::abs(fitted), r * quarter), b = q_mean - a * p_mean;
    size = std::max(size, std::max(std::abs(b), std::abs(a * p_mean)));
    Real deviation = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      deviation = std::max(deviation, std::abs(a * p[i] + b - q[i]));
    const Real round_off = 8 * std::numeric_limits<double>::epsilon() * size / extent;
    const Real rotation = std::abs(std::arg(fitted) - r * quarter);
    m_check.rotation_deviation = std::max(m_check.rotation_deviation, static_cast<double>(rotation));
    m_check.transition_deviation = std::max(m_check.transition_deviation, static_cast<double>(deviation / size));
    m_check.transition_by_extent = std::max(m_check.transition_by_extent, static_cast<double>(deviation / extent));
    m_check.largest_log_scale =
        std::max(m_check.largest_log_scale, static_cast<double>(std::abs(std::log(std::abs(a)))));
    if (rotation > angle_tolerance + round_off)
      fail("no rotation by quarter turns: the branch of triangle", branch.front() / 3);
    if (deviation > 1e-9 * size)
      fail("not one transition: the branch of triangle", branch.front() / 3);
    for (const int h : branch) {
      const Complex at_edge = (uv(opposite(h)) - uv(next(opposite(h)))) / (uv(next(h)) - uv(h));
      if (std::abs(at_edge - a) > std::abs(a) * (angle_tolerance + noise(h)))
        fail("not the transition of its branch: the seam edge of triangle", h / 3);
      m_branch_quarter_turns[h] = r;
      m_branch_quarter_turns[opposite(h)] = -r;
      m_branch_log_scale[h] = std::log(std::abs(a));
      m_branch_log_scale[opposite(h)] = -m_branch_log_scale[h];
    }
    m_check_noise = std::max(m_check_noise, round_off);
  }

  // The linear parts of the transitions around a vertex compose to the rotation by its cone angle.
  void check_vertex_holonomy()
  {
    for (std::size_t v = 0; v < m_seams_at.size(); ++v) {
      int turns = 0;
      Real log_scale = 0;
      for (const int h : m_seams_at[v]) {
        turns += m_branch_quarter_turns[h];
        log_scale += m_branch_log_scale[h];
      }
      if ((turns - quarter_turns(static_cast<int>(v))) % 4 != 0)
        fail("the rotations do not compose to the cone angle: vertex", v);
      m_check.scale_deviation = std::max(m_check.scale_deviation, static_cast<double>(std::abs(log_scale)));
      if (std::abs(log_scale) > angle_tolerance + static_cast<Real>(m_seams_at[v].size()) * m_check_noise)
        fail("the scales do not compose to 1: vertex", v);
    }
  }

  // The uv angle at the source of h in its face.
  Real angle(const int h) const
  {
    const Complex quotient = (uv(previous(h)) - uv(h)) * std::conj(uv(next(h)) - uv(h));
    return std::atan2(quotient.imag(), quotient.real());
  }

  void check_cone_angles()
  {
    const Real quarter = std::atan2(Real(1), Real(0));
    for (int v = 0; v < static_cast<int>(m_outgoing.size()); ++v) {
      Real sum = 0, round_off = 0;
      int h = m_outgoing[v];
      do {
        sum += angle(h);
        round_off += noise(h);
        h = next_around_source(h);
      } while (h != m_outgoing[v]);
      const Real deviation = std::abs(sum - quarter_turns(v) * quarter);
      m_check.cone_angle_deviation = std::max(m_check.cone_angle_deviation, static_cast<double>(deviation));
      if (deviation > angle_tolerance + round_off)
        fail("not the cone angle: vertex", v);
    }
  }

  int input_halfedge(const std::array<int, 2>& ends) const
  {
    for (const int f : m_faces_at[ends[0]])
      for (int i = 0; i < 3; ++i)
        if (m_input.triangles[f][i] == ends[0] && m_input.triangles[f][(i + 1) % 3] == ends[1])
          return 3 * f + i;
    return none;
  }

  // Whether the refined halfedge h enters the face of the input halfedge across it.
  bool enters(const int h, const int input) const
  {
    const int e = input_edge(input);
    return m_input_face[h / 3] == input / 3 && m_input_face[opposite(h) / 3] == m_input_opposite[input] / 3 &&
           std::binary_search(m_edges_at[source(h)].begin(), m_edges_at[source(h)].end(), e) &&
           std::binary_search(m_edges_at[target(h)].begin(), m_edges_at[target(h)].end(), e);
  }

  // A closed strip of refined triangles inside the input strip. In each input face it runs straight on between two sides, embedded, so that
  // it turns by what the input strip turns: added vertices are regular.
  void check_loop(const std::size_t loop)
  {
    Indices strip;
    for (const auto& ends : m_signature.loops[loop].halfedges)
      strip.push_back(input_halfedge(ends));
    int first = none;
    Real longest = 0;
    for (int h = 0; h < static_cast<int>(m_opposite.size()); ++h)
      if (enters(h, strip.front())) {
        const Real length = norm(difference(m_refined.points[source(h)], m_refined.points[target(h)]));
        if (length > longest) {
          longest = length;
          first = h;
        }
      }
    Real turning = 0, round_off = 0;
    int h = first;
    for (std::size_t i = 0; i < strip.size() && h != none; ++i) {
      const bool is_last = i + 1 == strip.size();
      h = cross_input_face(h, strip[is_last ? 0 : i + 1], is_last ? first : none, turning, round_off);
    }
    if (h == none) {
      fail("no strip of triangles along loop", loop);
      return;
    }
    const Real deviation = std::abs(turning - m_signature.loops[loop].quarter_turns * std::atan2(Real(1), Real(0)));
    m_check.loop_deviation = std::max(m_check.loop_deviation, static_cast<double>(deviation));
    if (deviation > angle_tolerance + round_off)
      fail("not the turning number: loop", loop);
  }

  // Goes from the triangle of `start` through triangles of its input face to a halfedge that enters the next face by `input`, `goal` if that is
  // given, and adds up left angles minus right angles. \return the halfedge by which the next face is entered.
  int cross_input_face(const int start, const int input, const int goal, Real& turning, Real& round_off) const
  {
    std::vector<std::pair<int, int>> visited(1, {start, none}); // halfedge of entry, index of the predecessor
    Indices seen(1, start / 3);
    for (std::size_t i = 0; i < visited.size(); ++i) {
      int out = visited[i].first;
      for (int k = 0; k < 2; ++k) {
        out = next(out);
        const int in = opposite(out);
        if (goal == none ? enters(in, input) : in == goal) {
          add_turning(visited, static_cast<int>(i), in, turning, round_off);
          return in;
        }
        if (m_input_face[in / 3] == m_input_face[start / 3] &&
            std::find(seen.begin(), seen.end(), in / 3) == seen.end()) {
          seen.push_back(in / 3);
          visited.emplace_back(in, static_cast<int>(i));
        }
      }
    }
    return none;
  }

  void add_turning(const std::vector<std::pair<int, int>>& visited, int i, int left_by, Real& turning,
                   Real& round_off) const
  {
    for (; i != none; i = visited[i].second) {
      const int in = visited[i].first, out = opposite(left_by);
      if (out == next(in))
        turning -= angle(out); // around the target of in, on the right
      else
        turning += angle(in);
      round_off += noise(in);
      left_by = in;
    }
  }

  const Plain_mesh& m_input;
  const Plain_map& m_refined;
  const Plain_signature& m_signature;
  Map_check m_check;
  Indices m_k;                                 // per input vertex
  Indices m_input_opposite, m_opposite;        // per halfedge
  Indices m_outgoing;                          // per vertex
  std::vector<Indices> m_faces_at, m_edges_at; // per vertex: input faces and edges on which it lies
  Indices m_input_face;                        // per triangle
  std::vector<char> m_is_seam;                 // per halfedge
  std::vector<Indices> m_seams_at;             // per vertex: seam halfedges that leave it
  Indices m_branch_quarter_turns;              // per halfedge: of the transition from its left to its right
  std::vector<Real> m_branch_log_scale;
  Real m_check_noise = 0;
};

/// Judges a map: see `Map_checker`.
inline Map_check check_map(const Plain_mesh& input, const Plain_map& refined, const Plain_signature& signature)
{
  return Map_checker(input, refined, signature).check();
}

#endif // T_SPLINES_TEST_MAP_CHECKER_H
