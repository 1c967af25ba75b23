// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_TRACING_TRACED_MAP_H
#define T_SPLINES_TEST_TRACING_TRACED_MAP_H

#include "Edge_flags.h"
#include "Tracing/hand_made_maps.h"
#include "T_mesh_checker.h"

#include <CGAL/T_splines/Similarity_map/make_exactly_seamless.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/Tracing/trace_motorcycle_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// A map made exactly seamless, and its motorcycle graph with everything that the tracer can tell about it.
/// \tparam NT of knots and places
template <typename TriangleMesh, typename Graph, typename NT>
struct Traced_map {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point_2 = Kernel::Point_2;
  using Point_3 = Kernel::Point_3;
  using Surface = boost::graph_traits<TriangleMesh>;
  using Traits = boost::graph_traits<Graph>;
  template <typename Key, typename Value>
  using Map = boost::associative_property_map<std::map<Key, Value>>;

  TriangleMesh mesh;
  std::map<typename Surface::halfedge_descriptor, Point_2> uv;
  std::map<typename Surface::edge_descriptor, bool> is_marked; ///< which edges are to lie on isolines
  CGAL::T_splines::Seamless_map<TriangleMesh, Exact> map;
  CGAL::T_splines::Exact_map_report<TriangleMesh> map_report;
  CGAL::T_splines::Motorcycle_graph_report report;

  Graph graph;
  std::map<typename Traits::halfedge_descriptor, NT> knots;
  std::map<typename Traits::halfedge_descriptor, bool> corners;
  std::map<typename Traits::face_descriptor, CGAL::T_splines::T_mesh_anchor<TriangleMesh, Exact>> anchors;
  std::map<typename Surface::vertex_descriptor, CGAL::T_splines::T_mesh_place<Graph, NT>> places;
  std::map<typename Traits::vertex_descriptor, typename Surface::vertex_descriptor> origins;
  std::map<typename Traits::vertex_descriptor, Point_3> points;
  std::map<typename Traits::edge_descriptor, std::vector<Point_3>> polylines;
  Edge_flags<Graph> creases;

  using View =
      CGAL::T_splines::T_mesh_view<const Graph, Map<typename Traits::halfedge_descriptor, NT>,
                                   Map<typename Traits::halfedge_descriptor, bool>, typename Edge_flags<Graph>::Map>;

  /// The T-mesh.
  View view() const { return {graph, map_of(knots), map_of(corners), creases.of(graph)}; }
  auto view() { return CGAL::T_splines::T_mesh_view(graph, map_of(knots), map_of(corners), creases.of(graph)); }

  /// \param marked edges that are to lie on isolines, by their ends, ascending
  explicit Traced_map(const Plain_map& plain, const std::set<std::pair<int, int>>& marked = {})
    : mesh(test_meshes::face_graph<TriangleMesh>(plain)),
      map(mesh)
  {
    const auto number = vertex_numbers(mesh);
    for (const auto e : CGAL::make_range(edges(mesh)))
      is_marked[e] = marked.count(std::minmax(number.at(source(e, mesh)), number.at(target(e, mesh)))) != 0;
    hand_made_maps::put_corners(plain, mesh, boost::make_assoc_property_map(uv));
    run();
  }

  /// A mesh with uv that is there already.
  template <typename HalfedgeUVMap>
  Traced_map(const TriangleMesh& given, const HalfedgeUVMap given_uv) : mesh(given),
                                                                        map(mesh)
  {
    const auto from = ordered_halfedges(given), to = ordered_halfedges(mesh);
    for (std::size_t i = 0; i < from.size(); ++i)
      uv.emplace(to[i], get(given_uv, from[i]));
    for (const auto e : CGAL::make_range(edges(mesh)))
      is_marked[e] = false;
    run();
  }

  Traced_map(const Traced_map&) = delete;

  bool success() const { return map_report.success() && report.success(); }
  std::string message_text() const
  {
    return std::string(message(map_report.status)) + "; " +
           (map_report.success() ? message(report.status) : "not traced");
  }

  Exact_map exact_map() const
  {
    Exact_map result = ::exact_map(map);
    result.point = plain_mesh(mesh).points;
    return result;
  }

  Exact_t_mesh exact_t_mesh() const
  {
    Exact_t_mesh_reader<View> reader(view());
    reader.read_anchors(mesh, map_of(anchors));
    reader.read_places(mesh, map_of(places));
    reader.read_origins(mesh, map_of(origins));
    reader.read_points(map_of(points));
    reader.read_polylines(map_of(polylines));
    return reader.result();
  }

private:
  template <typename Key, typename Value>
  static Map<Key, Value> map_of(const std::map<Key, Value>& map)
  {
    return Map<Key, Value>(const_cast<std::map<Key, Value>&>(map)); // it is only read
  }

  void run()
  {
    using namespace CGAL::T_splines::parameters;
    map_report =
        make_exactly_seamless(mesh, map_of(uv), map, CGAL::parameters::edge_is_constrained_map(map_of(is_marked)));
    if (map_report.success())
      report = trace_motorcycle_graph(
          map, view(),
          face_anchor_map(
              map_of(anchors),
              vertex_place_map(
                  map_of(places),
                  vertex_origin_map(map_of(origins),
                                    edge_polyline_map(map_of(polylines), output_vertex_point_map(map_of(points)))))));
  }
};

/// Everything about a T-mesh, to the last digit.
inline std::string dump(const Exact_t_mesh& t_mesh)
{
  std::ostringstream out;
  out.precision(17);
  for (int h = 0; h < t_mesh.number_of_halfedges(); ++h)
    out << t_mesh.next[h] << ' ' << t_mesh.target[h] << ' ' << t_mesh.face[h] << ' ' << t_mesh.knot[h] << ' '
        << int(t_mesh.is_corner[h]) << '\n';
  const auto write = [&](const Exact_similarity& s) {
    out << s.quarter_turns() << ' ' << s.scale() << ' ' << s.u() << ' ' << s.v() << '\n';
  };
  for (int f = 0; f < t_mesh.number_of_faces(); ++f) {
    out << t_mesh.halfedge_of_face[f] << ' ' << t_mesh.anchor[f].triangle << ' ';
    write(t_mesh.anchor[f].to_face);
  }
  for (const auto& place : t_mesh.place)
    out << place.face << ' ' << place.at.first << ' ' << place.at.second << '\n';
  for (const int v : t_mesh.origin)
    out << v << '\n';
  for (const auto& p : t_mesh.point)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& polyline : t_mesh.polyline)
    for (const auto& p : polyline)
      out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  return out.str();
}

/// What both checkers say.
struct Whole_check {
  Seamless_map_check map;
  T_mesh_check t_mesh;

  bool success() const { return map.success() && t_mesh.success(); }
  std::string text() const { return map.text() + "\n" + t_mesh.text(); }
};

/// \param deviation how far corners may be from the given ones, by the size of their triangle
template <typename Traced>
Whole_check check_all(const Traced& traced, const double deviation = 0.01)
{
  Whole_check result;
  const Exact_map map = traced.exact_map();
  Seamless_map_checker map_checker(map);
  map_checker.check();
  auto& mutable_uv = const_cast<decltype(traced.uv)&>(traced.uv); // it is only read
  result.map =
      map_checker.check_deviation(given_corners(traced.mesh, boost::make_assoc_property_map(mutable_uv)), deviation);
  result.t_mesh = T_mesh_checker(map, traced.exact_t_mesh()).check();
  if (result.t_mesh.components != result.map.components)
    result.t_mesh.fail("components of the T-mesh, not as many as the surface has:", result.t_mesh.components);
  return result;
}

#endif // T_SPLINES_TEST_TRACING_TRACED_MAP_H
