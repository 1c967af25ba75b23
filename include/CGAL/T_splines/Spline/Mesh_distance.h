// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_MESH_DISTANCE_H
#define CGAL_T_SPLINES_SPLINE_MESH_DISTANCE_H

#include <CGAL/T_splines/Spline/T_spline_deviation_report.h>
#include <CGAL/T_splines/Spline/internal/Triangle_set.h>
#include <CGAL/T_splines/Spline/internal/Triangle_tree.h>
#include <CGAL/T_splines/internal/face_is_data.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// The distances of points from a triangle mesh, in doubles: a function object that is built once and asked often.
///
/// It copies the mesh; a copy of it shares the data. Queries may run in any number of threads.
class Mesh_distance {
public:
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3; ///< a point in space

  /// prepares the mesh, if it has faces, all of them triangles, and finite points. Complexity: n log n for n faces.
  /// \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`; faces may be degenerate
  /// \param mesh the mesh
  /// \param np an optional sequence of named parameters among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
  ///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
  ///       `%Point_3`}
  ///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{face_is_data_map}
  ///     \cgalParamDescription{which faces distances are taken from}
  ///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` -> `bool`}
  ///     \cgalParamDefault{all}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Mesh_distance(const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                            get_const_property_map(CGAL::vertex_point, mesh));
    internal::Triangle_set set;
    m_status = internal::read_triangle_set(mesh, point_map, np, set).status;
    set.triangles.resize(set.number_of_data());
    if (is_valid())
      m_tree = std::make_shared<const internal::Triangle_tree>(set);
  }

  /// returns whether distances can be asked for, and if not, why.
  T_spline_deviation_status status() const { return m_status; }
  /// returns whether distances can be asked for.
  bool is_valid() const { return m_status == T_spline_deviation_status::MEASURED; }

  /// returns the point of the mesh that is closest to p. \pre `is_valid()`; the coordinates of p are finite
  /// \tparam Point a point with `x()`, `y()`, `z()`
  ///
  /// Complexity: as a rule logarithmic.
  template <typename Point>
  Point_3 closest_point(const Point& p) const
  {
    CGAL_precondition_msg(is_valid(), "the mesh is not valid: see status()");
    return m_tree->closest_point(internal::point_in_doubles(p));
  }

  /// returns the distance of p from the mesh. \pre as for `closest_point()`
  template <typename Point>
  double operator()(const Point& p) const
  {
    CGAL_precondition_msg(is_valid(), "the mesh is not valid: see status()");
    return m_tree->distance(internal::point_in_doubles(p));
  }

  /// writes the distances (`double`) of a range of points, such as those where `tessellate_parameter_domain()` leads;
  /// faster than one by one, if each is near the one before.
  /// \pre as for `closest_point()`
  template <typename PointRange, typename OutputIterator>
  OutputIterator distances(const PointRange& points, OutputIterator out) const
  {
    CGAL_precondition_msg(is_valid(), "the mesh is not valid: see status()");
    std::size_t hint = 0; // as a rule, the next point is near
    for (const auto& p : points) {
      const internal::Triangle_tree::Foot foot = m_tree->foot(internal::point_in_doubles(p), hint);
      hint = foot.triangle;
      *out++ = foot.distance();
    }
    return out;
  }

private:
  T_spline_deviation_status m_status;
  std::shared_ptr<const internal::Triangle_tree> m_tree;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_MESH_DISTANCE_H
