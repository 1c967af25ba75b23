// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_T_MESHES_H
#define T_SPLINES_TEST_T_MESHES_H

#include "Edge_flags.h"

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <unordered_map>
#include <vector>

// T-meshes made by hand. They are described by the halfedges of their faces, so that they may be non-simple.
namespace test_t_meshes {

template <typename FT>
struct Halfedge {
  int edge; // each number stands for one edge: once on a border, twice elsewhere
  FT knot;
  bool is_corner; // at its end
};

// The faces, counter-clockwise.
template <typename FT>
using Faces = std::vector<std::vector<Halfedge<FT>>>;

// A T-mesh with its two maps, in containers of their own: no model of MutableFaceGraph needs property maps that grow.
template <typename Graph_, typename FT_>
class T_mesh {
public:
  using Graph = Graph_;
  using FT = FT_;
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  template <typename Value>
  using Container = std::unordered_map<halfedge_descriptor, Value, boost::hash<halfedge_descriptor>>;
  using Knot_map = boost::associative_property_map<Container<FT>>;
  using Corner_map = boost::associative_property_map<Container<bool>>;

  using Crease_map = typename Edge_flags<Graph>::Map;

  explicit T_mesh(const Faces<FT>& faces)
  {
    std::map<int, halfedge_descriptor> halfedge_of_edge;
    for (const auto& boundary : faces) {
      std::vector<halfedge_descriptor> loop;
      for (const Halfedge<FT>& h : boundary) {
        const auto found = halfedge_of_edge.find(h.edge);
        const bool is_new = found == halfedge_of_edge.end();
        loop.push_back(is_new ? halfedge(add_edge(mesh), mesh) : opposite(found->second, mesh));
        if (is_new)
          halfedge_of_edge[h.edge] = loop.back();
        else
          halfedge_of_edge.erase(found);
        m_knots[loop.back()] = h.knot;
        m_corners[loop.back()] = h.is_corner;
      }
      const face_descriptor f = add_face(mesh);
      set_halfedge(f, loop.front(), mesh);
      face_list.push_back(f);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        set_face(loop[i], f, mesh);
        set_next(loop[i], loop[(i + 1) % loop.size()], mesh);
      }
    }
    for (const auto& border : halfedge_of_edge)
      set_face(opposite(border.second, mesh), Traits::null_face(), mesh);
    for (const auto& border : halfedge_of_edge)
      close_border(opposite(border.second, mesh));
    add_vertices();
  }

  T_mesh(const T_mesh&) = delete;
  T_mesh& operator=(const T_mesh&) = delete;

  Graph& graph() { return mesh; }
  const Graph& graph() const { return mesh; }
  Knot_map knots() const { return Knot_map(m_knots); }
  Corner_map corners() const { return Corner_map(m_corners); }
  Crease_map creases() const { return m_creases.of(mesh); }

  // Halfedge number i of face number f, as they were given; unless they have changed.
  halfedge_descriptor halfedge_of(const std::size_t f, const int i) const
  {
    halfedge_descriptor h = halfedge(face_list[f], mesh);
    for (int k = 0; k < i; ++k)
      h = next(h, mesh);
    return h;
  }

  Graph mesh;
  std::vector<face_descriptor> face_list; // in the order given

private:
  void close_border(const halfedge_descriptor h)
  {
    // Turns about the target of h, through the faces, to the border halfedge that leaves it.
    halfedge_descriptor n = opposite(h, mesh);
    while (face(n, mesh) != Traits::null_face()) {
      halfedge_descriptor p = n;
      while (next(p, mesh) != n)
        p = next(p, mesh);
      n = opposite(p, mesh);
    }
    set_next(h, n, mesh);
  }

  void add_vertices()
  {
    Container<bool> done;
    for (const auto h : halfedges(mesh)) {
      if (done[h])
        continue;
      const vertex_descriptor v = add_vertex(mesh);
      set_halfedge(v, h, mesh);
      halfedge_descriptor i = h;
      do {
        done[i] = true;
        set_target(i, v, mesh);
        i = opposite(next(i, mesh), mesh);
      } while (i != h);
    }
  }

  mutable Container<FT> m_knots;
  mutable Container<bool> m_corners;
  Edge_flags<Graph> m_creases;
};

// Multiplies all knots of a face: another unit, the same T-mesh.
template <typename FT>
void rescale(std::vector<Halfedge<FT>>& face, const FT& factor)
{
  for (Halfedge<FT>& h : face)
    h.knot *= factor;
}

// A surface glued of unit squares; each is given by its four edges. The square with number i has the unit i + 1.
template <typename FT>
Faces<FT> squares(const std::vector<std::vector<int>>& edges)
{
  Faces<FT> faces;
  for (const auto& square : edges) {
    faces.emplace_back();
    for (const int e : square)
      faces.back().push_back({e, FT(1), true});
    rescale(faces.back(), FT(static_cast<int>(faces.size())));
  }
  return faces;
}

// Makes one vertex of a corner each of the first two faces, which are not connected, and returns it.
template <typename T>
typename T::vertex_descriptor join_corners_of_two_faces(T& t)
{
  const auto into = [&](const std::size_t f) { return opposite(t.halfedge_of(f, 0), t.mesh); };
  const auto a = into(0), b = into(1), after_a = next(a, t.mesh), after_b = next(b, t.mesh);
  const auto v = target(a, t.mesh), w = target(b, t.mesh);
  set_target(b, v, t.mesh);
  set_target(opposite(after_b, t.mesh), v, t.mesh);
  set_next(a, after_b, t.mesh);
  set_next(b, after_a, t.mesh);
  remove_vertex(w, t.mesh);
  return v;
}

// Genus 0, eight cones of three quarter turns.
template <typename FT>
Faces<FT> cube()
{
  return squares<FT>({{0, 1, 2, 3}, {4, 5, 6, 7}, {2, 8, 4, 9}, {6, 10, 0, 11}, {1, 10, 5, 8}, {3, 9, 7, 11}});
}

// A torus with no cones. Column i + 1 is right of column i; behind the last row one comes back shifted by one column.
template <typename FT>
Faces<FT> torus(const int columns, const int rows)
{
  const auto horizontal = [&](const int i, const int j) {
    const int turns = j / rows;
    return 2 * ((i + turns + columns) % columns + columns * (j % rows));
  };
  const auto vertical = [&](const int i, const int j) { return 2 * (i % columns + columns * j) + 1; };
  std::vector<std::vector<int>> edges;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      edges.push_back({horizontal(i, j), vertical(i + 1, j), horizontal(i, j + 1), vertical(i, j)});
  }
  return squares<FT>(edges);
}

// Genus 0: one square, two pairs of adjacent sides of which are glued; cones of one, one and two quarter turns.
template <typename FT>
Faces<FT> folded_square()
{
  return squares<FT>({{0, 0, 1, 1}});
}

// Genus 0: two squares, glued along their boundaries; four cones of two quarter turns.
template <typename FT>
Faces<FT> pillow()
{
  return squares<FT>({{0, 1, 2, 3}, {0, 3, 2, 1}});
}

// Genus 2: three squares in the shape of an L, opposite sides glued; one cone of twelve quarter turns.
template <typename FT>
Faces<FT> genus_two()
{
  // Square 1 is right of square 0, square 2 above it.
  return squares<FT>({{0, 1, 2, 3}, {4, 3, 4, 1}, {2, 5, 0, 5}});
}

// A torus without cones whose lines spiral: the plane without the origin, modulo the multiplication by c. Four
// rectangles lie like the wings of a pinwheel between the square of side 2 and the square of side 2 c, c > 1, around
// the origin.
template <typename FT>
Faces<FT> pinwheel(const FT& c)
{
  Faces<FT> faces(4);
  const FT one(1);
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    const int outer = i, wing = 4 + i, next_wing = 4 + j, rest = 8 + i, next_rest = 8 + j;
    faces[i] = {{outer, c + one, true},        {next_wing, c - one, true}, {next_rest, (c - one) / c, false},
                {outer, (c + one) / c, false}, {wing, c - one, true},      {rest, c - one, true}};
  }
  return faces;
}

// A rectangle of squares with a border; no cones.
template <typename FT>
Faces<FT> rectangle(const int columns, const int rows)
{
  std::vector<std::vector<int>> edges;
  const auto horizontal = [&](const int i, const int j) { return 2 * (i + (columns + 1) * j); };
  const auto vertical = [&](const int i, const int j) { return 2 * (i + (columns + 1) * j) + 1; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      edges.push_back({horizontal(i, j), vertical(i + 1, j), horizontal(i, j + 1), vertical(i, j)});
  }
  return squares<FT>(edges);
}

// A band of squares between two borders, closed after `columns` columns.
template <typename FT>
Faces<FT> cylinder(const int columns, const int rows)
{
  std::vector<std::vector<int>> edges;
  const auto horizontal = [&](const int i, const int j) { return 2 * (i + columns * j); };
  const auto vertical = [&](const int i, const int j) { return 2 * (i % columns + columns * j) + 1; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      edges.push_back({horizontal(i, j), vertical(i + 1, j), horizontal(i, j + 1), vertical(i, j)});
  return squares<FT>(edges);
}

// Of a star, or of a fan: the first spoke is not the last one.
template <typename FT>
Faces<FT> sectors_of_squares(const int sectors, const int spokes, const int n)
{
  const auto horizontal = [&](const int s, const int x, const int y) {
    return 2 * ((s % spokes * (n + 1) + y) * n + x);
  };
  const auto vertical = [&](const int s, const int x, const int y) {
    return x == 0 ? horizontal(s + 1, y, 0) : 2 * ((s * (n + 1) + x) * n + y) + 1;
  };
  std::vector<std::vector<int>> edges;
  for (int s = 0; s < sectors; ++s)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        edges.push_back({horizontal(s, x, y), vertical(s, x + 1, y), horizontal(s, x, y + 1), vertical(s, x, y)});
  return squares<FT>(edges);
}

// A disk around a cone: `sectors` large squares, each of n x n squares. Square number n n s + n y + x is the one at (x, y)
// in sector s, the cone at (0, 0); its halfedge 0 runs along x, away from the cone.
template <typename FT>
Faces<FT> star(const int sectors, const int n)
{
  return sectors_of_squares<FT>(sectors, sectors, n);
}

// The same around a corner of the border.
template <typename FT>
Faces<FT> fan(const int sectors, const int n)
{
  return sectors_of_squares<FT>(sectors, sectors + 1, n);
}

// The star of single squares, of which the first two are one rectangle: the cone is a T-joint of it.
template <typename FT>
Faces<FT> star_with_t_joint(const int sectors)
{
  Faces<FT> faces = star<FT>(sectors, 1);
  auto &first = faces[0], second = faces[1];
  rescale(second, FT(FT(1) / FT(2)));
  second[3].is_corner = first[2].is_corner = false;
  first.pop_back();
  first.insert(first.end(), second.begin() + 1, second.end());
  faces.erase(faces.begin() + 1);
  return faces;
}

} // namespace test_t_meshes

#endif // T_SPLINES_TEST_T_MESHES_H
