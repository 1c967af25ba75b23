// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_FITTED_SURFACE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_FITTED_SURFACE_H

#include <CGAL/T_splines/Spline/T_spline_surface.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A T-spline surface whose control points are being found.
///
/// They are relative to an origin near the surface, so that a model far from zero loses no digits.
/// \tparam TMesh a `T_mesh_view` of a `const` graph
template <typename TMesh, typename Kernel>
class Fitted_surface {
  using Graph = typename TMesh::Graph;
  using Weighted_point_3 = typename Kernel::Weighted_point_3;
  using Control_points =
      typename boost::property_map<Graph, CGAL::dynamic_vertex_property_t<Weighted_point_3>>::const_type;

public:
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Surface = T_spline_surface<TMesh, Control_points, Kernel>;

  /// \param weights vertex -> positive number
  template <typename VertexWeightMap, typename NamedParameters>
  Fitted_surface(const TMesh& t_mesh, const VertexWeightMap weights, const NamedParameters& np)
    : m_control_points(with_weights(t_mesh.graph(), weights)),
      m_surface(t_mesh, m_control_points, np)
  {
  }
  Fitted_surface(const Fitted_surface&) = delete; // the property map is shared
  Fitted_surface& operator=(const Fitted_surface&) = delete;

  /// Its control points are relative to `origin()`.
  const Surface& surface() const { return m_surface; }
  const std::array<FT, 3>& origin() const { return m_origin; }
  void set_origin(const std::array<FT, 3>& origin) { m_origin = origin; }

  /// Of the vertices, by index.
  std::vector<FT> weights() const
  {
    std::vector<FT> result;
    for (const auto& p : m_surface.homogeneous_control_points())
      result.push_back(p[3]);
    return result;
  }

  /// \param points relative to the origin, of the vertices by index
  void set_control_points(const std::vector<std::array<FT, 3>>& points)
  {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto v = m_surface.indexing().vertex(static_cast<int>(i));
      put(m_control_points, v,
          Weighted_point_3(Point_3(points[i][0], points[i][1], points[i][2]), get(m_control_points, v).weight()));
    }
    m_surface.update_control_points();
  }

  /// Makes the control points of the surface absolute.
  void move_back()
  {
    std::vector<std::array<FT, 3>> points;
    for (int i = 0; i < static_cast<int>(m_surface.number_of_control_points()); ++i) {
      const Point_3 p = control_point(m_surface.indexing().vertex(i));
      points.push_back({p.x(), p.y(), p.z()});
    }
    m_origin.fill(FT(0));
    set_control_points(points);
  }

  /// Not relative to the origin.
  Point_3 control_point(const typename Surface::vertex_descriptor v) const
  {
    const auto& p = get(m_control_points, v).point();
    return Point_3(p.x() + m_origin[0], p.y() + m_origin[1], p.z() + m_origin[2]);
  }

private:
  template <typename VertexWeightMap>
  static Control_points with_weights(const Graph& graph, const VertexWeightMap weights)
  {
    Control_points result = get(CGAL::dynamic_vertex_property_t<Weighted_point_3>(), graph);
    for (const auto v : CGAL::make_range(vertices(graph)))
      put(result, v, Weighted_point_3(Point_3(FT(0), FT(0), FT(0)), FT(get(weights, v))));
    return result;
  }

  Control_points m_control_points;
  Surface m_surface;
  std::array<FT, 3> m_origin = {};
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_FITTED_SURFACE_H
