// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H

#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/fit_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Adaptive_fit.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// The visitor of an adaptive fit that does nothing, and the list of what such a visitor offers: a `Progress_visitor`
/// that also sees the levels.
///
/// \cgalModels{AdaptiveFitVisitor}
struct Adaptive_fit_visitor : Progress_visitor {
  /// is called when a level is fitted, with its T-mesh, a model of `TMesh`, whose points are the control points. It does
  /// not last.
  template <typename TMesh>
  void level_fitted(const T_spline_fit_level& /*level*/, const TMesh& /*t_mesh*/) const
  {
  }
};

namespace internal {

/// The same surface, on the copy of a T-mesh whose elements have the same order. Points and triangles that are near to
/// each other in space are so in memory: most of the time of a fit is spent with going from triangle to triangle.
template <typename Graph, typename ToGraph>
Carried_surface<ToGraph> copied_surface(const Mesh_indexing<Graph>& indexing, const Carried_surface<Graph>& surface,
                                        const ToGraph& to)
{
  const auto& points = surface.points();
  std::vector<std::size_t> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto point_map = CGAL::make_property_map(points);
  CGAL::spatial_sort(
      order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_3<CGAL::Simple_cartesian<double>, decltype(point_map)>(point_map));
  Carried_surface<ToGraph> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    result.add_point(points[order[i]]);
  }

  const auto& triangles = surface.triangles();
  std::vector<std::size_t> triangle_order(triangles.size()), triangle_place(triangles.size());
  std::iota(triangle_order.begin(), triangle_order.end(), 0);
  const auto first_place = [&](const std::size_t t) {
    return (std::min)({place[triangles[t][0]], place[triangles[t][1]], place[triangles[t][2]]});
  };
  std::stable_sort(triangle_order.begin(), triangle_order.end(),
                   [&](const std::size_t s, const std::size_t t) { return first_place(s) < first_place(t); });
  for (std::size_t i = 0; i < triangle_order.size(); ++i) {
    triangle_place[triangle_order[i]] = i;
    const auto& t = triangles[triangle_order[i]];
    result.add_triangle({place[t[0]], place[t[1]], place[t[2]]});
  }
  int i = 0;
  for (const auto f : CGAL::make_range(faces(to)))
    for (const auto& image : surface.images(indexing.face(i++)))
      result.add_image(f, {triangle_place[image.triangle], image.corners});
  return result;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// approximates a mesh by a T-spline surface within a tolerance, both ways and without folds ([He06] section 3.3): fits,
/// refines the T-mesh where the surface is too far from the mesh, and fits again.
///
/// In each level, the T-mesh is made spline compatible, and the control points minimize the squared distances of the
/// surface from the mesh and the thin-plate energy of `fit_T_spline()`. The distances are taken at a grid of places in
/// every Bezier cell and along sharp edges of the mesh. The points of the mesh that these places aim at are those that
/// the T-mesh carries there at first, then the closest ones, as long as this reduces the root mean square by half a
/// percent or more; the iteration is accelerated. A level begins with what the surface of the last one is closest to, if
/// that is near. Where the surface folds, it is made stiffer.
///
/// Where the distance is larger than the tolerance, or where the surface folds, the faces of the given T-mesh are split,
/// into four if the distance is more than twice the tolerance, else into two. Neighbours differ in size by a factor of 6
/// at most. A surface that is within the tolerance at all samples is measured by `measure_T_spline_deviation()` and
/// `check_T_spline_self_intersections()`; what they find is refined, too. So `WITHIN_TOLERANCE` is what these find.
///
/// A good start is the coarsest T-mesh there is: a regularized motorcycle graph.
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; its
///         knots may be of any number type
/// \tparam Kernel the computation is in its number type, a floating point type
/// \param t_mesh admissible
/// \param surface the mesh, on the T-mesh: `carry_surface()` makes it. Its images cover all faces
/// \param tolerance the largest distance allowed between mesh and surface, in the units of the points; positive
/// \param spline becomes the best level, with weights of 1, upon success; it stays what it was otherwise
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_control_points}
///     \cgalParamDescription{the most control points that the surface may have}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{5000, or if that is more, four times as many as the coarsest spline compatible T-mesh has, or
///       half as many as the mesh has vertices}
///   \cgalParamNEnd
///   \cgalParamNBegin{fairness}
///     \cgalParamDescription{the weight of the thin-plate energy, without unit}
///     \cgalParamType{a number >= 0}
///     \cgalParamDefault{`default_fairness`}
///     \cgalParamExtra{As for `fit_T_spline()`, with the mean distance between the samples of a level.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how often the points that are aimed at are moved in a level, at most}
///     \cgalParamType{`int`}
///     \cgalParamDefault{16}
///     \cgalParamExtra{A quarter of that in levels that begin with the surface of the last one.}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///     \cgalParamExtra{As for `fit_T_spline()`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress, sees each level, and may stop the work}
///     \cgalParamType{a model of `AdaptiveFitVisitor`, copied}
///     \cgalParamDefault{`Adaptive_fit_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{as for `is_admissible()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-9, and 0 for exact number types}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return why it ended, and the errors of all levels. Complexity: as `fit_T_spline()` and `make_spline_compatible()`
/// for each level.
template <typename TMesh, typename Kernel, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Adaptive_fit_report<T_mesh_graph<TMesh>>
fit_adaptive_T_spline(const TMesh& t_mesh, const Carried_surface<T_mesh_graph<TMesh>>& surface, const double tolerance,
                      T_spline<Kernel>& spline, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  static_assert(std::is_floating_point<typename Kernel::FT>::value, "fits are computed in a floating point type");
  const auto visitor = choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Adaptive_fit_visitor());
  auto&& solver = internal::sparse_linear_solver(np);

  Adaptive_fit_report<T_mesh_graph<TMesh>> report;
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    report.status = Adaptive_fit_status::INVALID_TOLERANCE;
    return report;
  }
  const internal::Adaptive_fit_options options{
      tolerance, choose_parameter(get_parameter(np, np_tags::fairness), default_fairness),
      choose_parameter(get_parameter(np, np_tags::maximum_number_of_control_points), std::size_t(0)),
      static_cast<int>(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 16))};
  if (!(options.fairness >= 0) || !std::isfinite(options.fairness)) {
    report.status = Adaptive_fit_status::FIT_FAILED;
    report.fit.status = T_spline_fit_status::INVALID_FAIRNESS;
    return report;
  }
  if (surface.triangles().empty()) {
    report.status = Adaptive_fit_status::NO_SURFACE;
    return report;
  }
  if (!internal::is_known_admissible(t_mesh, np, report.fit.surface.compatibility)) {
    report.status = Adaptive_fit_status::INADMISSIBLE;
    return report;
  }
  const internal::Mesh_indexing<T_mesh_graph<TMesh>> indexing(t_mesh.graph());
  T_mesh<typename Kernel::Point_3, typename Kernel::FT> working;
  copy_T_mesh(t_mesh, working);
  internal::Adaptive_fit<Kernel, std::decay_t<decltype(solver)>, std::decay_t<decltype(visitor)>> fit(
      working, internal::copied_surface(indexing, surface, working.graph()), options, solver, visitor);
  fit.run(report);
  if (report.success())
    spline = T_spline<Kernel>(fit.best());
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H
