// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_CONTROL_POINT_MAP_H
#define CGAL_T_SPLINES_SPLINE_CONTROL_POINT_MAP_H

#include <CGAL/T_splines/internal/converted_number.h>

#include <CGAL/Kernel_traits.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// The control points of a T-spline surface, of a map of points and one of weights.
///
/// A read/write map, vertex -> `Kernel::Weighted_point_3`: euclidean coordinates, not multiplied by the weight.
///
/// \cgalModels{ControlPointMap}
///
/// \tparam VertexPointMap a map, vertex -> `Kernel::Point_3`
/// \tparam VertexWeightMap a map, vertex -> number
template <typename VertexPointMap, typename VertexWeightMap>
class Control_point_map {
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point_3>::Kernel;

public:
  using key_type = typename boost::property_traits<VertexPointMap>::key_type; ///< a vertex
  using value_type = typename Kernel::Weighted_point_3;                       ///< a control point with its weight
  using reference = value_type;                        ///< the same: control points are made when they are read
  using category = boost::read_write_property_map_tag; ///< it can be read and written

  /// joins a map of points and one of weights.
  Control_point_map(const VertexPointMap points, const VertexWeightMap weights) : m_points(points), m_weights(weights)
  {
  }

  /// returns the control point of `v`.
  friend value_type get(const Control_point_map& map, const key_type v)
  {
    return value_type(get(map.m_points, v), typename Kernel::FT(get(map.m_weights, v)));
  }
  /// sets the control point of `v`.
  friend void put(const Control_point_map& map, const key_type v, const value_type& p)
  {
    put(map.m_points, v, p.point());
    put(map.m_weights, v, p.weight());
  }

private:
  VertexPointMap m_points;
  VertexWeightMap m_weights;
};

/// \ingroup PkgTSplinesSpline
/// returns the map of control points made of a map of points and one of weights.
template <typename VertexPointMap, typename VertexWeightMap>
Control_point_map<VertexPointMap, VertexWeightMap> make_control_point_map(const VertexPointMap points,
                                                                          const VertexWeightMap weights)
{
  return Control_point_map<VertexPointMap, VertexWeightMap>(points, weights);
}

namespace internal {

template <typename ControlPoint, typename = void>
inline constexpr bool has_weight = false;
template <typename ControlPoint>
inline constexpr bool has_weight<ControlPoint, std::void_t<decltype(std::declval<const ControlPoint&>().weight())>> =
    true;

template <typename ControlPoint>
struct Control_point_kernel {
  using type = typename CGAL::Kernel_traits<ControlPoint>::Kernel;
};

// (w x, w y, w z, w)
template <typename FT, typename ControlPoint>
std::array<FT, 4> homogeneous(const ControlPoint& p)
{
  if constexpr (has_weight<ControlPoint>) {
    const FT w = converted_number<FT>(p.weight());
    const auto& q = p.point();
    return {FT(w * converted_number<FT>(q.x())), FT(w * converted_number<FT>(q.y())),
            FT(w * converted_number<FT>(q.z())), w};
  }
  else
    return {converted_number<FT>(p.x()), converted_number<FT>(p.y()), converted_number<FT>(p.z()), FT(1)};
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_CONTROL_POINT_MAP_H
