// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_PLAIN_MAP_H
#define T_SPLINES_TEST_PLAIN_MAP_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

/// A triangle mesh in arrays.
struct Plain_mesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles; ///< counter-clockwise
};

/// A triangle mesh with uv per corner.
struct Plain_map : Plain_mesh {
  std::vector<std::array<std::array<double, 2>, 3>> uv;
};

/// A holonomy signature by vertex numbers.
struct Plain_signature {
  struct Loop {
    std::vector<std::array<int, 2>> halfedges; ///< source and target: the halfedges by which the strip enters its faces
    int quarter_turns = 0;
  };
  std::vector<std::pair<int, int>> cones;
  std::vector<Loop> loops;
};

template <typename FaceGraph>
std::map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int> vertex_numbers(const FaceGraph& mesh)
{
  std::map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, int> number;
  for (const auto v : CGAL::make_range(vertices(mesh)))
    number.emplace(v, static_cast<int>(number.size()));
  return number;
}

/// Calls `visit(triangle, corner, halfedge)`, where the halfedge points to the corner.
template <typename FaceGraph, typename Visitor>
void for_each_corner(const FaceGraph& mesh, Visitor&& visit)
{
  std::size_t t = 0;
  for (const auto f : CGAL::make_range(faces(mesh))) {
    std::size_t i = 0;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      visit(t, i++, h);
    ++t;
  }
}

template <typename FaceGraph, typename VertexPointMap>
Plain_mesh plain_mesh(const FaceGraph& mesh, const VertexPointMap points)
{
  const auto number = vertex_numbers(mesh);
  Plain_mesh result;
  for (const auto v : CGAL::make_range(vertices(mesh))) {
    const auto& p = get(points, v);
    result.points.push_back({{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}});
  }
  result.triangles.resize(num_faces(mesh));
  for_each_corner(mesh, [&](const std::size_t t, const std::size_t i, const auto h) {
    result.triangles.at(t).at(i) = number.at(target(h, mesh));
  });
  return result;
}

template <typename FaceGraph>
Plain_mesh plain_mesh(const FaceGraph& mesh)
{
  return plain_mesh(mesh, get(CGAL::vertex_point, mesh));
}

template <typename FaceGraph, typename HalfedgeUVMap>
Plain_map plain_map(const FaceGraph& mesh, const HalfedgeUVMap uv_map)
{
  Plain_map result;
  static_cast<Plain_mesh&>(result) = plain_mesh(mesh);
  result.uv.resize(result.triangles.size());
  for_each_corner(mesh, [&](const std::size_t t, const std::size_t i, const auto h) {
    const auto& uv = get(uv_map, h);
    result.uv.at(t).at(i) = {{CGAL::to_double(uv.x()), CGAL::to_double(uv.y())}};
  });
  return result;
}

template <typename FaceGraph>
Plain_signature plain_signature(const FaceGraph& mesh, const CGAL::T_splines::Holonomy_signature<FaceGraph>& signature)
{
  const auto number = vertex_numbers(mesh);
  Plain_signature result;
  for (const auto& cone : signature.cones())
    result.cones.emplace_back(number.at(cone.first), cone.second);
  for (const auto& loop : signature.loops()) {
    result.loops.emplace_back();
    result.loops.back().quarter_turns = loop.quarter_turns;
    for (const auto h : loop.halfedges)
      result.loops.back().halfedges.push_back({{number.at(source(h, mesh)), number.at(target(h, mesh))}});
  }
  return result;
}

#endif // T_SPLINES_TEST_PLAIN_MAP_H
