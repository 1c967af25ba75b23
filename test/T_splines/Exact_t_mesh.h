// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_EXACT_T_MESH_H
#define T_SPLINES_TEST_EXACT_T_MESH_H

#include "Seamless_map_checker.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

/// A T-mesh in arrays of exact numbers, and how it lies on the surface of an `Exact_map`. Halfedges 2e and 2e + 1 are
/// opposite.
struct Exact_t_mesh {
  static constexpr int none = -1;

  struct Place {
    int face = none;
    Exact_point at;
  };
  struct Anchor {
    int triangle = none;
    Exact_similarity to_face;
  };

  // Per halfedge. On the border the face is `none`, the knot 0, and nothing is a corner.
  std::vector<int> next, previous, target, face;
  std::vector<Exact> knot;
  std::vector<char> is_corner;
  std::vector<int> halfedge_of_face;
  std::vector<int> halfedge_of_edge; ///< 2e or 2e + 1: where the polyline of the edge runs to
  int number_of_vertices = 0;

  // On the surface; each may be empty.
  std::vector<Anchor> anchor;                               ///< per face; the triangle may be `none`
  bool anchors_may_touch = false;                           ///< whether their triangles may lie outside of the face
  std::vector<Place> place;                                 ///< per vertex of the triangle mesh
  std::vector<int> origin;                                  ///< per vertex: vertex of the triangle mesh or `none`
  std::vector<std::array<double, 3>> point;                 ///< per vertex
  std::vector<std::vector<std::array<double, 3>>> polyline; ///< per edge

  // What `make_frames()` finds. A face is [0, width] x [0, height]; side 0 is the bottom.
  struct Face_frame {
    Exact width, height;
    std::array<std::vector<int>, 4> side; ///< the halfedges of each side
  };
  std::vector<int> side;         ///< per halfedge
  std::vector<Exact> start;      ///< per halfedge: where it begins on its side
  std::vector<Face_frame> frame; ///< per face

  int number_of_halfedges() const { return static_cast<int>(next.size()); }
  int number_of_faces() const { return static_cast<int>(halfedge_of_face.size()); }
  int source(const int h) const { return target[h ^ 1]; }

  /// Sides and positions of all halfedges. \pre four corners per face
  void make_frames()
  {
    side.assign(next.size(), none);
    start.assign(next.size(), Exact(0));
    frame.assign(halfedge_of_face.size(), Face_frame());
    for (int f = 0; f < number_of_faces(); ++f) {
      int h = halfedge_of_face[f];
      while (!is_corner[previous[h]])
        h = previous[h];
      std::array<Exact, 4> length;
      for (int s = 0; s < 4; ++s)
        for (bool is_last = false; !is_last; h = next[h]) {
          side[h] = s;
          start[h] = length[s];
          length[s] += knot[h];
          frame[f].side[s].push_back(h);
          is_last = is_corner[h];
        }
      frame[f].width = length[0];
      frame[f].height = length[1];
    }
  }

  /// The point of a side at the distance x from its begin, in the frame of the face.
  Exact_point point_of_side(const int f, const int s, const Exact& x) const
  {
    switch (s) {
    case 0: return {x, Exact(0)};
    case 1: return {frame[f].width, x};
    case 2: return {frame[f].width - x, frame[f].height};
    default: return {Exact(0), frame[f].height - x};
    }
  }
  Exact_point source_in_frame(const int h) const { return point_of_side(face[h], side[h], start[h]); }
  Exact_point target_in_frame(const int h) const { return point_of_side(face[h], side[h], start[h] + knot[h]); }

  /// From the frame of the face of h to that of its opposite's face.
  Exact_similarity transition(const int h) const
  {
    const int g = h ^ 1;
    const Exact_similarity linear(side[g] + 2 - side[h], knot[g] / knot[h], Exact(0), Exact(0));
    const Exact_point from = source_in_frame(h), to = target_in_frame(g), image = linear(from.first, from.second);
    return {side[g] + 2 - side[h], knot[g] / knot[h], to.first - image.first, to.second - image.second};
  }
};

/// Reads graph, knots and corners of a T-mesh, and the maps that tell how it lies on the surface.
template <typename TMesh>
class Exact_t_mesh_reader {
  using Graph = typename TMesh::Graph;
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

public:
  explicit Exact_t_mesh_reader(const TMesh& t_mesh) : m_graph(t_mesh.graph())
  {
    const Graph& graph = m_graph;
    for (const auto v : CGAL::make_range(vertices(graph)))
      m_vertex.emplace(v, m_result.number_of_vertices++);
    for (const auto f : CGAL::make_range(faces(graph)))
      m_face.emplace(f, static_cast<int>(m_face.size()));
    for (const auto e : CGAL::make_range(edges(graph))) {
      m_halfedges.push_back(halfedge(e, graph));
      m_halfedges.push_back(opposite(halfedge(e, graph), graph));
      m_result.halfedge_of_edge.push_back(static_cast<int>(m_halfedges.size()) - 2);
    }
    for (std::size_t i = 0; i < m_halfedges.size(); ++i)
      m_halfedge.emplace(m_halfedges[i], static_cast<int>(i));
    for (const halfedge_descriptor h : m_halfedges) {
      const bool is_border = face(h, graph) == Traits::null_face();
      m_result.next.push_back(m_halfedge.at(next(h, graph)));
      m_result.previous.push_back(m_halfedge.at(prev(h, graph)));
      m_result.target.push_back(m_vertex.at(target(h, graph)));
      m_result.face.push_back(is_border ? Exact_t_mesh::none : m_face.at(face(h, graph)));
      m_result.knot.push_back(is_border ? Exact(0) : Exact(get(t_mesh.knots(), h)));
      m_result.is_corner.push_back(!is_border && get(t_mesh.corners(), h));
    }
    for (const auto f : CGAL::make_range(faces(graph)))
      m_result.halfedge_of_face.push_back(m_halfedge.at(halfedge(f, graph)));
  }

  template <typename TriangleMesh, typename FaceAnchorMap>
  void read_anchors(const TriangleMesh& mesh, const FaceAnchorMap anchors)
  {
    std::map<typename boost::graph_traits<TriangleMesh>::face_descriptor, int> triangle;
    for (const auto t : CGAL::make_range(faces(mesh)))
      triangle.emplace(t, static_cast<int>(triangle.size()));
    for (const auto f : CGAL::make_range(faces(m_graph))) {
      const auto anchor = get(anchors, f);
      m_result.anchor.push_back({triangle.at(anchor.triangle), exact_similarity(anchor.to_face)});
    }
  }

  template <typename TriangleMesh, typename VertexPlaceMap>
  void read_places(const TriangleMesh& mesh, const VertexPlaceMap places)
  {
    for (const auto v : CGAL::make_range(vertices(mesh))) {
      const auto place = get(places, v);
      m_result.place.push_back({m_face.at(place.face), {Exact(place.u), Exact(place.v)}});
    }
  }

  template <typename TriangleMesh, typename VertexOriginMap>
  void read_origins(const TriangleMesh& mesh, const VertexOriginMap origins)
  {
    const auto number = vertex_numbers(mesh);
    for (const auto v : CGAL::make_range(vertices(m_graph))) {
      const auto origin = get(origins, v);
      const bool is_none = origin == boost::graph_traits<TriangleMesh>::null_vertex();
      m_result.origin.push_back(is_none ? Exact_t_mesh::none : number.at(origin));
    }
  }

  template <typename VertexPointMap>
  void read_points(const VertexPointMap points)
  {
    for (const auto v : CGAL::make_range(vertices(m_graph)))
      m_result.point.push_back(coordinates(get(points, v)));
  }

  template <typename EdgePolylineMap>
  void read_polylines(const EdgePolylineMap polylines)
  {
    for (const auto e : CGAL::make_range(edges(m_graph))) {
      m_result.polyline.emplace_back();
      for (const auto& p : get(polylines, e))
        m_result.polyline.back().push_back(coordinates(p));
    }
  }

  const Exact_t_mesh& result() const { return m_result; }

private:
  template <typename Point_3>
  static std::array<double, 3> coordinates(const Point_3& p)
  {
    return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
  }

  const Graph& m_graph;
  std::map<vertex_descriptor, int> m_vertex;
  std::map<halfedge_descriptor, int> m_halfedge;
  std::map<face_descriptor, int> m_face;
  std::vector<halfedge_descriptor> m_halfedges;
  Exact_t_mesh m_result;
};

#endif // T_SPLINES_TEST_EXACT_T_MESH_H
