// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_SET_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_SET_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/internal/face_is_data.h>
#include <CGAL/T_splines/internal/Axis_parallel_box.h>
#include <CGAL/T_splines/internal/converted_number.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Triangles in doubles, whose corners are numbers of points. The first ones are data, with the first points; the others only
/// close holes.
struct Triangle_set {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point_3 = Kernel::Point_3;
  using Triangle_3 = Kernel::Triangle_3;

  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 2>> border;                      ///< the edges on the border of a mesh
  std::vector<std::array<std::size_t, 2>> creases;                     ///< its constrained edges, but for those
  std::size_t end_of_data = (std::numeric_limits<std::size_t>::max)(); ///< among the triangles

  bool is_data(const std::size_t triangle) const { return triangle < end_of_data; }
  bool has_only_data() const { return end_of_data >= triangles.size(); }
  std::size_t number_of_data() const { return (std::min)(end_of_data, triangles.size()); }
  std::size_t number_of_data_points() const
  {
    std::size_t result = has_only_data() ? points.size() : 0;
    for (std::size_t i = 0; i < end_of_data && result < points.size(); ++i)
      result = (std::max)({result, triangles[i][0] + 1, triangles[i][1] + 1, triangles[i][2] + 1});
    return result;
  }

  Triangle_3 triangle(const std::size_t i) const
  {
    const std::array<std::size_t, 3>& t = triangles[i];
    return Triangle_3(points[t[0]], points[t[1]], points[t[2]]);
  }

  /// The longest side of the bounding box of the data.
  double extent() const
  {
    Axis_parallel_box<double> box;
    for (std::size_t i = 0, end = number_of_data_points(); i < end; ++i)
      box.extend(points[i]);
    return box.extent();
  }
};

inline double area(const Triangle_set::Triangle_3& t)
{
  return 0.5 * std::sqrt(CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length());
}

// Fourth powers of distances must not overflow.
constexpr double largest_measured_coordinate = 1e70;

template <typename Point>
Triangle_set::Point_3 point_in_doubles(const Point& p)
{
  return in_doubles<Triangle_set::Point_3>(p);
}

inline bool is_within_range(const Triangle_set::Point_3& p)
{
  return std::abs(p.x()) <= largest_measured_coordinate && std::abs(p.y()) <= largest_measured_coordinate &&
         std::abs(p.z()) <= largest_measured_coordinate;
}

/// How a mesh was read, with the vertex or face concerned.
template <typename TriangleMesh>
struct Triangle_reading {
  using Traits = boost::graph_traits<TriangleMesh>;

  T_spline_deviation_status status = T_spline_deviation_status::MEASURED;
  typename Traits::vertex_descriptor vertex = Traits::null_vertex();
  typename Traits::face_descriptor face = Traits::null_face();
  std::vector<typename Traits::vertex_descriptor> vertices;  ///< of the points
  std::vector<typename Traits::face_descriptor> faces;       ///< of the triangles
  std::vector<typename Traits::halfedge_descriptor> border;  ///< of the edges on the border
  std::vector<typename Traits::halfedge_descriptor> creases; ///< one of each constrained edge
};

/// Reads a mesh, the faces that are data first. Its points are the vertices of faces, in the order in which faces name them:
/// neighbours follow each other.
/// \param np `face_is_data_map` and `edge_is_constrained_map`
template <typename TriangleMesh, typename VertexPointMap, typename NamedParameters>
Triangle_reading<TriangleMesh> read_triangle_set(const TriangleMesh& mesh, const VertexPointMap point_map,
                                                 const NamedParameters& np, Triangle_set& set)
{
  using None = CGAL::Static_boolean_property_map<typename boost::graph_traits<TriangleMesh>::edge_descriptor, false>;
  const auto is_data = face_is_data_map<TriangleMesh>(np);
  const auto is_crease = CGAL::parameters::choose_parameter<None>(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained));

  using Index_map =
      typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type;
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  Triangle_reading<TriangleMesh> reading;
  const Index_map index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for (const auto v : CGAL::make_range(vertices(mesh)))
    put(index, v, none);
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> others;
  auto& creases = reading.creases;
  for (const auto f : CGAL::make_range(faces(mesh)))
    (get(is_data, f) ? reading.faces : others).push_back(f);
  if (!others.empty())
    set.end_of_data = reading.faces.size();
  if (reading.faces.empty())
    reading.status = T_spline_deviation_status::NO_FACES;
  reading.faces.insert(reading.faces.end(), others.begin(), others.end());
  for (const auto f : reading.faces) {
    auto h = halfedge(f, mesh);
    std::array<std::size_t, 3> triangle;
    for (std::size_t& corner : triangle) {
      const auto v = target(h, mesh);
      if (get(index, v) == none) {
        put(index, v, set.points.size());
        set.points.push_back(point_in_doubles(get(point_map, v)));
        reading.vertices.push_back(v);
        if (!is_within_range(set.points.back())) {
          reading.status = T_spline_deviation_status::VERTEX_NOT_FINITE;
          reading.vertex = v;
          return reading;
        }
      }
      corner = get(index, v);
      h = next(h, mesh);
    }
    if (h != halfedge(f, mesh)) {
      reading.status = T_spline_deviation_status::NOT_TRIANGULATED;
      reading.face = f;
      return reading;
    }
    set.triangles.push_back(triangle);
    for (const auto side : CGAL::halfedges_around_face(h, mesh))
      if (CGAL::is_border(opposite(side, mesh), mesh)) {
        set.border.push_back({get(index, source(side, mesh)), get(index, target(side, mesh))});
        reading.border.push_back(opposite(side, mesh));
      }
      else if (get(is_crease, edge(side, mesh)) && side == halfedge(edge(side, mesh), mesh)) {
        creases.push_back(side);
      }
  }
  for (const auto h : creases)
    set.creases.push_back({get(index, source(h, mesh)), get(index, target(h, mesh))});
  return reading;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_TRIANGLE_SET_H
