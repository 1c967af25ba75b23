// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_CHART_POINTS_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_CHART_POINTS_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Points in space of places in the charts of a map, in doubles.
template <typename FT>
class Chart_points {
public:
  using Point_3 = std::array<double, 3>;
  using Number = Enclosed_number<FT>;

  /// \param points of the vertices of the map's mesh
  Chart_points(const Seamless_layout<FT>& layout, const std::vector<Point_3>& points)
    : m_layout(layout),
      m_mesh(layout.mesh()),
      m_points(points)
  {
  }

  const Point_3& of_vertex(const int v) const { return m_points[v]; }

  /// \param t from 0 at the source of h to 1
  Point_3 on_edge(const int h, const double t) const
  {
    return combination(m_mesh.source(h), 1 - t, m_mesh.target(h), t, 0, 0);
  }

  /// \param u, v of a point of the face
  Point_3 in_face(const int face, const Number& u, const Number& v) const
  {
    const int h = m_mesh.halfedge_of_face(face), g = m_mesh.next(h), k = m_mesh.next(g);
    const std::array<double, 2> x = from_corner(h, u, v), q = from_corner(h, g), r = from_corner(h, k);
    const double area = q[0] * r[1] - q[1] * r[0];
    const double b = std::clamp((x[0] * r[1] - x[1] * r[0]) / area, 0., 1.);
    const double c = std::clamp((q[0] * x[1] - q[1] * x[0]) / area, 0., 1 - b);
    return combination(m_mesh.target(h), 1 - b - c, m_mesh.target(g), b, m_mesh.target(k), c);
  }

  /// Where the line with a direction and a constant coordinate crosses an edge: from 0 at the source of h to 1.
  double parameter_on_edge(const int h, const Number& line, const int direction) const
  {
    const int axis = axis_across(direction);
    const Number source = m_layout.coordinate(m_mesh.previous(h), axis);
    const double length = difference(m_layout.coordinate(h, axis), source);
    return length == 0 ? 0.5 : std::clamp(difference(line, source) / length, 0., 1.);
  }

private:
  /// Where digits cancel, the exact numbers are subtracted: charts may be large against their triangles.
  static double difference(const Number& a, const Number& b)
  {
    constexpr double many_digits = 1. / (1 << 16);
    const double result = a.lower - b.lower;
    if ((a.exact != nullptr || b.exact != nullptr) && std::abs(result) < many_digits * std::abs(b.lower))
      return CGAL::to_double(FT(a.value() - b.value()));
    return result;
  }

  std::array<double, 2> from_corner(const int h, const Number& u, const Number& v) const
  {
    return {{difference(u, m_layout.coordinate(h, 0)), difference(v, m_layout.coordinate(h, 1))}};
  }
  std::array<double, 2> from_corner(const int h, const int g) const
  {
    return from_corner(h, m_layout.coordinate(g, 0), m_layout.coordinate(g, 1));
  }

  Point_3 combination(const int a, const double x, const int b, const double y, const int c, const double z) const
  {
    Point_3 point;
    for (int i = 0; i < 3; ++i)
      point[i] = x * m_points[a][i] + y * m_points[b][i] + z * m_points[c][i];
    return point;
  }

  const Seamless_layout<FT>& m_layout;
  const Triangulation_connectivity& m_mesh;
  const std::vector<Point_3>& m_points;
};

/// The points of the vertices, by index.
template <typename TriangleMesh, typename VertexPointMap>
std::vector<std::array<double, 3>> points_in_doubles(const Mesh_indexing<TriangleMesh>& indexing,
                                                     const VertexPointMap map)
{
  std::vector<std::array<double, 3>> points(indexing.number_of_vertices());
  for (int v = 0; v < indexing.number_of_vertices(); ++v) {
    const auto& p = get(map, indexing.vertex(v));
    points[v] = {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
  }
  return points;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_CHART_POINTS_H
