// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_TRACING_HAND_MADE_MAPS_H
#define T_SPLINES_TEST_TRACING_HAND_MADE_MAPS_H

#include "Plain_map.h"
#include "Similarity_map/test_meshes.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

/// Seamless maps that are made by gluing pieces of the plane, so that everything about them is known. All coordinates
/// are short dyadic numbers: the maps are exactly seamless in doubles.
namespace hand_made_maps {

using Position = std::array<double, 2>;

inline Position operator+(const Position& a, const Position& b)
{
  return {{a[0] + b[0], a[1] + b[1]}};
}
inline Position operator-(const Position& a, const Position& b)
{
  return {{a[0] - b[0], a[1] - b[1]}};
}
inline Position operator*(const double s, const Position& a)
{
  return {{s * a[0], s * a[1]}};
}
inline double cross(const Position& a, const Position& b)
{
  return a[0] * b[1] - a[1] * b[0];
}
inline Position rotated(const int quarter_turns, const Position& a)
{
  switch ((quarter_turns % 4 + 4) % 4) {
  case 0: return a;
  case 1: return {{-a[1], a[0]}};
  case 2: return {{-a[0], -a[1]}};
  default: return {{a[1], -a[0]}};
  }
}

/// Triangles in the plane, and which edges of their border are glued.
struct Net {
  std::vector<Position> at;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 4>> glue; ///< {a, b, c, d}: the edge from a to b with that from c to d
};

/// Splits each triangle into four.
inline Net subdivided(const Net& net)
{
  Net result;
  result.at = net.at;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](const int a, const int b) {
    const auto inserted = middles.emplace(std::minmax(a, b), static_cast<int>(result.at.size()));
    if (inserted.second)
      result.at.push_back(0.5 * (net.at[a] + net.at[b]));
    return inserted.first->second;
  };
  for (const auto& t : net.triangles) {
    const int a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
    for (const std::array<int, 3>& triangle :
         {std::array<int, 3>{{t[0], c, b}}, {{c, t[1], a}}, {{b, a, t[2]}}, {{a, b, c}}})
      result.triangles.push_back(triangle);
  }
  for (const auto& g : net.glue) {
    const int m = middle(g[0], g[1]), n = middle(g[2], g[3]);
    result.glue.push_back({{g[0], m, g[2], n}});
    result.glue.push_back({{m, g[1], n, g[3]}});
  }
  return result;
}

/// Splits each triangle into three.
inline Net split(const Net& net)
{
  Net result = net;
  result.triangles.clear();
  for (const auto& t : net.triangles) {
    const int middle = static_cast<int>(result.at.size());
    result.at.push_back(0.5 * net.at[t[0]] + 0.25 * (net.at[t[1]] + net.at[t[2]]));
    for (int i = 0; i < 3; ++i)
      result.triangles.push_back({{t[i], t[(i + 1) % 3], middle}});
  }
  return result;
}

/// The surface that a net folds to, with points in space at random: only the map counts.
inline Plain_map folded(const Net& net, const unsigned seed = 1)
{
  std::vector<int> parent(net.at.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& g : net.glue)
    for (int i = 0; i < 2; ++i)
      parent[root(g[i])] = root(g[i + 2]);
  Plain_map result;
  std::map<int, int> vertex;
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random()) / 4294967296.; };
  for (const auto& t : net.triangles) {
    std::array<int, 3> triangle{};
    std::array<Position, 3> uv{};
    for (int i = 0; i < 3; ++i) {
      const auto inserted = vertex.emplace(root(t[i]), static_cast<int>(vertex.size()));
      if (inserted.second) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        result.points.push_back({{x, y, z}});
      }
      triangle[i] = inserted.first->second;
      uv[i] = net.at[t[i]];
    }
    result.triangles.push_back(triangle);
    result.uv.push_back(uv);
  }
  return result;
}

/// How the unit squares of a grid are cut into triangles.
enum class Pattern { DIAGONALS, OTHER_DIAGONALS, MIXED_DIAGONALS, CROSSES };

/// Squares that are glued along their sides: side 4q + i of square q goes from its corner i to its corner i + 1.
struct Squares {
  std::vector<int> glued; ///< per side: the other, or -1 on a border

  explicit Squares(const int number) : glued(4 * number, -1) {}

  void glue(const int square, const int side, const int other_square, const int other_side)
  {
    glued[4 * square + side] = 4 * other_square + other_side;
    glued[4 * other_square + other_side] = 4 * square + side;
  }
};

/// Each square becomes n x n unit squares in a chart of its own.
inline Net net(const Squares& squares, const int n, const Pattern pattern, const unsigned seed = 1)
{
  Net result;
  std::mt19937 random(seed);
  const int number = static_cast<int>(squares.glued.size()) / 4;
  const auto index = [n](const int q, const int x, const int y) { return (q * (n + 1) + y) * (n + 1) + x; };
  for (int q = 0; q < number; ++q)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
        result.at.push_back({{double(x), double(y)}});
  for (int q = 0; q < number; ++q)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const std::array<int, 4> c = {{index(q, x, y), index(q, x + 1, y), index(q, x + 1, y + 1), index(q, x, y + 1)}};
        if (pattern == Pattern::CROSSES) {
          result.at.push_back({{x + 0.5, y + 0.5}});
          for (int i = 0; i < 4; ++i)
            result.triangles.push_back({{c[i], c[(i + 1) % 4], static_cast<int>(result.at.size()) - 1}});
          continue;
        }
        const int turn = pattern == Pattern::MIXED_DIAGONALS ? random() % 2 : pattern == Pattern::OTHER_DIAGONALS;
        result.triangles.push_back({{c[turn], c[turn + 1], c[turn + 2]}});
        result.triangles.push_back({{c[turn], c[turn + 2], c[(turn + 3) % 4]}});
      }
  const auto on_side = [&](const int side, const int k) {
    const std::array<std::array<int, 2>, 4> p = {{{{k, 0}}, {{n, k}}, {{n - k, n}}, {{0, n - k}}}};
    return index(side / 4, p[side % 4][0], p[side % 4][1]);
  };
  for (int side = 0; side < 4 * number; ++side)
    for (int k = 0; k < n && side <= squares.glued[side]; ++k)
      result.glue.push_back({{on_side(side, k), on_side(side, k + 1), on_side(squares.glued[side], n - k),
                              on_side(squares.glued[side], n - k - 1)}});
  return result;
}

/// Glues the sides of squares whose corners have the same numbers.
inline Squares squares_of_corners(const std::vector<std::array<int, 4>>& corners)
{
  Squares result(static_cast<int>(corners.size()));
  std::map<std::pair<int, int>, int> side;
  for (std::size_t q = 0; q < corners.size(); ++q)
    for (int i = 0; i < 4; ++i)
      side[{corners[q][i], corners[q][(i + 1) % 4]}] = static_cast<int>(4 * q) + i;
  for (const auto& [ends, s] : side) {
    const auto found = side.find({ends.second, ends.first});
    if (found != side.end())
      result.glued[s] = found->second;
  }
  return result;
}

/// Six squares, eight cones with k = 3.
inline Squares cube()
{
  return squares_of_corners(
      {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}});
}

/// The boundary of a union of unit cubes. \pre no two cubes meet in an edge or a vertex alone
inline Squares polycube(const std::set<std::array<int, 3>>& cubes)
{
  std::vector<std::array<int, 4>> corners;
  std::map<std::array<int, 3>, int> number;
  for (const auto& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        std::array<int, 3> neighbor = cube;
        neighbor[axis] += side ? 1 : -1;
        if (cubes.count(neighbor))
          continue;
        const int first = side ? (axis + 1) % 3 : (axis + 2) % 3, second = side ? (axis + 2) % 3 : (axis + 1) % 3;
        std::array<int, 3> p = cube;
        p[axis] += side;
        std::array<std::array<int, 3>, 4> at = {{p, p, p, p}};
        ++at[1][first];
        ++at[2][first];
        ++at[2][second];
        ++at[3][second];
        corners.emplace_back();
        for (int i = 0; i < 4; ++i)
          corners.back()[i] = number.emplace(at[i], static_cast<int>(number.size())).first->second;
      }
  return squares_of_corners(corners);
}

/// Two stars of k squares, glued along their borders: two cones k, and k cones with k = 2.
inline Squares double_star(const int k)
{
  // Square q of the first star has its corner 0 in the center; the second star is the mirror image.
  Squares result(2 * k);
  for (int q = 0; q < k; ++q) {
    result.glue(q, 3, (q + 1) % k, 0);
    result.glue(k + (q + 1) % k, 3, k + q, 0);
    result.glue(q, 1, k + q, 2);
    result.glue(q, 2, k + q, 1);
  }
  return result;
}

/// m x n squares in a row, a torus; a side is glued with a shift. No cones.
inline Squares square_torus(const int m, const int n, const int shift)
{
  Squares result(m * n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < m; ++x) {
      result.glue(m * y + x, 1, m * y + (x + 1) % m, 3);
      const int above = y + 1 < n ? m * (y + 1) + x : (x + shift) % m;
      result.glue(m * y + x, 2, above, 0);
    }
  return result;
}

/// Three squares in the shape of an L, opposite sides glued: genus 2, one cone with k = 12.
inline Squares translation_surface()
{
  Squares result(3); // 1 right of 0, 2 above 0
  result.glue(0, 1, 1, 3);
  result.glue(1, 1, 0, 3);
  result.glue(0, 2, 2, 0);
  result.glue(2, 2, 0, 0);
  result.glue(1, 2, 1, 0);
  result.glue(2, 1, 2, 3);
  return result;
}

/// The tetrahedron with four equal faces (0, a, b): four cones with k = 2. \pre counter-clockwise
inline Net folded_triangle(const Position& a, const Position& b)
{
  Net result;
  result.at = {{{0, 0}}, a, 2 * a, a + b, 2 * b, b};
  result.triangles = {{{0, 1, 5}}, {{1, 2, 3}}, {{5, 3, 4}}, {{1, 3, 5}}};
  result.glue = {{{0, 1, 2, 1}}, {{2, 3, 4, 3}}, {{4, 5, 0, 5}}};
  return result;
}

/// The convex polygon with the sides v_1, ..., v_n, -v_1, ..., -v_n, opposite ones glued by translations.
inline Net symmetric_polygon(std::vector<Position> sides)
{
  Net result;
  const int n = static_cast<int>(sides.size());
  for (int i = 0; i < n; ++i)
    sides.push_back(-1 * sides[i]);
  Position p = {{0, 0}};
  for (int i = 0; i < n; ++i)
    p = p - 0.5 * sides[i];
  for (const Position& side : sides) {
    result.at.push_back(p);
    p = p + side;
  }
  result.at.push_back({{0, 0}});
  for (int i = 0; i < 2 * n; ++i)
    result.triangles.push_back({{i, (i + 1) % (2 * n), 2 * n}});
  for (int i = 0; i < n; ++i)
    result.glue.push_back({{i, i + 1, (i + n + 1) % (2 * n), i + n}});
  return result;
}

/// The torus of the lattice m a, n b, triangulated by the points i a + j b. No cones.
inline Net lattice_torus(const Position& a, const Position& b, const int m, const int n)
{
  Net result;
  const auto index = [m](const int i, const int j) { return j * (m + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i)
      result.at.push_back(double(i) * a + double(j) * b);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      result.triangles.push_back({{index(i, j), index(i + 1, j), index(i + 1, j + 1)}});
      result.triangles.push_back({{index(i, j), index(i + 1, j + 1), index(i, j + 1)}});
    }
  for (int i = 0; i < m; ++i)
    result.glue.push_back({{index(i, 0), index(i + 1, 0), index(i, n), index(i + 1, n)}});
  for (int j = 0; j < n; ++j)
    result.glue.push_back({{index(0, j), index(0, j + 1), index(m, j), index(m, j + 1)}});
  return result;
}

/// An L of three unit squares with a border, each n x n: a reflex corner and five convex ones.
inline Net bordered_l(const int n, const Pattern pattern)
{
  Squares squares(3);
  squares.glue(0, 1, 1, 3);
  squares.glue(0, 2, 2, 0);
  return net(squares, n, pattern);
}

/// The plane without the origin, unrolled to `sectors` right angles, modulo z -> scale i^turns z: a torus whose
/// isolines spiral.
/// `n` steps per sector, a power of 2; `rings` rings, a power of 2. \pre turns <= sectors
inline Net scaled_torus(const double scale, const int sectors, const int turns, const int n, const int rings)
{
  Net result;
  const int m = sectors * n;
  const auto index = [m](const int i, const int ring) { return ring * (m + 1) + i; };
  for (int ring = 0; ring <= rings; ++ring)
    for (int i = 0; i <= m; ++i)
      result.at.push_back((1 + (scale - 1) * ring / rings) * rotated(i / n, {{1, -1 + 2. * (i % n) / n}}));
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < m; ++i) {
      result.triangles.push_back({{index(i, ring), index(i, ring + 1), index(i + 1, ring)}});
      result.triangles.push_back({{index(i + 1, ring), index(i, ring + 1), index(i + 1, ring + 1)}});
    }
  for (int i = 0; i < m; ++i) {
    const int j = (i + turns * n) % m;
    result.glue.push_back({{index(i, rings), index(i + 1, rings), index(j, 0), index(j + 1, 0)}});
  }
  for (int ring = 0; ring < rings; ++ring)
    result.glue.push_back({{index(0, ring), index(0, ring + 1), index(m, ring), index(m, ring + 1)}});
  return result;
}

/// Flips edges at random, as often as given, where the two triangles form a strictly convex quadrilateral and no scale
/// lies between them: then isolines no longer run along edges. The vertices and their uv stay.
inline void flip_at_random(Plain_map& map, const int attempts, const unsigned seed)
{
  std::mt19937 random(seed);
  std::map<std::pair<int, int>, int> halfedge; // ends -> 3t + i, from corner i
  const auto insert = [&](const int t) {
    for (int i = 0; i < 3; ++i)
      halfedge[{map.triangles[t][i], map.triangles[t][(i + 1) % 3]}] = 3 * t + i;
  };
  for (std::size_t t = 0; t < map.triangles.size(); ++t)
    insert(static_cast<int>(t));
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const int h = static_cast<int>(random() % (3 * map.triangles.size())), t = h / 3, i = h % 3, j = (i + 1) % 3,
              k = (i + 2) % 3;
    const std::array<int, 3> tv = map.triangles[t];
    const auto found = halfedge.find({tv[j], tv[i]});
    if (found == halfedge.end())
      continue;
    const int s = found->second / 3, b = found->second % 3, a = (b + 1) % 3, d = (b + 2) % 3;
    const std::array<int, 3> sv = map.triangles[s];
    const std::array<Position, 3> tuv = map.uv[t], suv = map.uv[s];
    int r = 0;
    while (r < 4 && rotated(r, suv[b] - suv[a]) != tuv[j] - tuv[i])
      ++r;
    if (r == 4 || tv[k] == sv[d] || halfedge.count({tv[k], sv[d]}) || halfedge.count({sv[d], tv[k]}))
      continue;
    const Position apex = tuv[i] + rotated(r, suv[d] - suv[a]);
    if (cross(apex - tuv[i], tuv[k] - tuv[i]) <= 0 || cross(tuv[k] - tuv[j], apex - tuv[j]) <= 0)
      continue;
    halfedge.erase({tv[i], tv[j]});
    halfedge.erase({tv[j], tv[i]});
    map.triangles[t] = {{tv[i], sv[d], tv[k]}};
    map.uv[t] = {{tuv[i], apex, tuv[k]}};
    map.triangles[s] = {{sv[d], tv[j], tv[k]}};
    map.uv[s] = {{apex, tuv[j], tuv[k]}};
    insert(t);
    insert(s);
  }
}

/// Whether no two edges join the same vertices: what a face graph made of it asks.
inline bool is_simple(const Plain_mesh& mesh)
{
  std::set<std::pair<int, int>> halfedges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] == t[(i + 1) % 3] || !halfedges.emplace(t[i], t[(i + 1) % 3]).second)
        return false;
  return true;
}

/// Copies the corners of a map to a face graph that was made of it by `test_meshes::face_graph()`.
template <typename FaceGraph, typename HalfedgeUVMap>
void put_corners(const Plain_map& plain, const FaceGraph& mesh, const HalfedgeUVMap uv_map)
{
  using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
  const auto number = vertex_numbers(mesh);
  for_each_corner(mesh, [&](const std::size_t t, const std::size_t, const auto h) {
    for (int i = 0; i < 3; ++i)
      if (plain.triangles.at(t)[i] == number.at(target(h, mesh)))
        put(uv_map, h, Point_2(plain.uv[t][i][0], plain.uv[t][i][1]));
  });
}

} // namespace hand_made_maps

#endif // T_SPLINES_TEST_TRACING_HAND_MADE_MAPS_H
