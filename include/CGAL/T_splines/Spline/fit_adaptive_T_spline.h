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
#include <CGAL/T_splines/Spline/internal/Reference_mesh.h>
#include <CGAL/T_splines/T_mesh/Carried_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/face_is_data.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// The same surface, on the copy of a T-mesh whose elements have the same order. Points and triangles that are near to
/// each other in space are so in memory: most of the time of a fit is spent with going from triangle to triangle.
/// \param progress if it is interrupted, the surface is not complete
template <typename Graph, typename ToGraph>
Carried_surface<ToGraph> copied_surface(const Mesh_indexing<Graph>& indexing, const Carried_surface<Graph>& surface,
                                        const ToGraph& to, Progress& progress)
{
  const auto& points = surface.points();
  std::vector<std::size_t> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto point_map = CGAL::make_property_map(points);
  CGAL::spatial_sort(
      order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_3<CGAL::Simple_cartesian<double>, decltype(point_map)>(point_map));
  Carried_surface<ToGraph> result;
  for (std::size_t i = 0; i < order.size() && progress.go_on_after(1); ++i) {
    place[order[i]] = i;
    result.add_point(points[order[i]]);
  }

  const auto& triangles = surface.triangles();
  std::vector<std::size_t> triangle_order(triangles.size()), triangle_place(triangles.size());
  std::iota(triangle_order.begin(), triangle_order.end(), 0);
  const auto first_place = [&](const std::size_t t) {
    return (std::min)({place[triangles[t][0]], place[triangles[t][1]], place[triangles[t][2]]});
  };
  if (!progress.go_on())
    return result;
  std::stable_sort(triangle_order.begin(), triangle_order.end(),
                   [&](const std::size_t s, const std::size_t t) { return first_place(s) < first_place(t); });
  for (std::size_t i = 0; i < triangle_order.size() && progress.go_on_after(1); ++i) {
    triangle_place[triangle_order[i]] = i;
    const auto& t = triangles[triangle_order[i]];
    result.add_triangle({place[t[0]], place[t[1]], place[t[2]]}, surface.is_data(triangle_order[i]));
  }
  int i = 0;
  for (const auto f : CGAL::make_range(faces(to)))
    for (const auto& image : surface.images(indexing.face(i++)))
      if (progress.go_on_after(2))
        result.add_image(f, {triangle_place[image.triangle], image.corners});
  return result;
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// approximates a mesh, and its border if it has one, by a T-spline surface within a tolerance, both ways and without
/// folds ([He06] section 3.3): fits, refines the T-mesh where the surface is too far from the mesh, and fits again.
///
/// In each level, the T-mesh is made spline compatible, and the control points minimize the squared distances of the
/// surface from the mesh and the thin-plate energy of `fit_T_spline()`. The distances are taken at a grid of places in
/// every Bezier cell, along sharp edges of the mesh and along the border, which aims at that of the mesh. The points of
/// the mesh that these places aim at are those that the T-mesh carries there at first, then the closest ones, as long
/// as this reduces the root mean square by half a percent or more; the iteration is accelerated. A level begins with
/// what the surface of the last one is closest to, if that is near. Where the surface folds, it is made stiffer.
///
/// Where the distance is larger than the tolerance, or where the surface folds, the faces of the given T-mesh are split,
/// into four if the distance is more than twice the tolerance, else into two. Neighbours differ in size by a factor of 6
/// at most. A surface that is within the tolerance at all samples is measured by `measure_T_spline_deviation()` and
/// `check_T_spline_self_intersections()`; what they find is refined, too. The surface that is handed out is always
/// measured so: the report has what was found, and `WITHIN_TOLERANCE` means that.
///
/// A good start is the coarsest T-mesh there is: a regularized motorcycle graph.
/// \tparam TMesh a model of `TMesh` whose graph is one of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; its
///         knots may be of any number type
/// \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
/// \tparam Kernel the computation is in its number type, a floating point type
/// \param t_mesh admissible
/// \param surface the mesh, on the T-mesh: `carry_surface()` makes it. Its images cover all faces
/// \param mesh what the surface is measured against: the mesh from which `surface` was carried, before it was refined
/// \param tolerance the largest distance allowed between mesh and surface, by the longest side of the bounding box of the
///        mesh: 0.01 is one percent of it; positive
/// \param spline becomes the best level, with weights of 1, upon success; it stays what it was otherwise
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map with the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%vertex_descriptor` ->
///       `%Point_3`}
///     \cgalParamDefault{the map of `mesh` for `CGAL::vertex_point`}
///     \cgalParamExtra{Points of any kernel, rounded to doubles.}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_is_data_map}
///     \cgalParamDescription{which faces of `mesh` the surface is measured against, as for `measure_T_spline_deviation()`}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` -> `bool`}
///     \cgalParamDefault{all}
///     \cgalParamExtra{What the surface is fitted to, the triangles of `surface` say themselves: where they are no data,
///       the thin-plate energy alone determines it.}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{which edges of `mesh` the creases of the T-mesh stand for, as for
///       `measure_T_spline_deviation()`: the tolerance holds between them, too}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%edge_descriptor` -> `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_control_points}
///     \cgalParamDescription{the most control points that the surface may have}
///     \cgalParamType{`std::optional<std::size_t>`}
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
///     \cgalParamDescription{what hears of the progress, and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{level_observer}
///     \cgalParamDescription{what is told each level when it is fitted: a function object that takes a
///       `T_spline_fit_level` and its T-mesh, a `T_mesh<Kernel::Point_3, Kernel::FT>` whose points are the control points
///       and which does not last}
///     \cgalParamType{a model of `CopyConstructible`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{as for `check_admissibility()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_relative_tolerance`, 1e-9; 0 for exact number types}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return why it ended, how good the surface is, and the errors of all levels. Complexity: as `fit_T_spline()` and
/// `make_spline_compatible()` for each level.
template <typename TMesh, typename TriangleMesh, typename Kernel,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Adaptive_fit_report<T_mesh_graph<TMesh>, typename T_spline<Kernel>::Graph, TriangleMesh>
fit_adaptive_T_spline(const TMesh& t_mesh, const Carried_surface<T_mesh_graph<TMesh>>& surface,
                      const TriangleMesh& mesh, const double tolerance, T_spline<Kernel>& spline,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Status = Adaptive_fit_status;
  static_assert(std::is_floating_point<typename Kernel::FT>::value, "fits are computed in a floating point type");
  const auto visitor = internal::progress_visitor(np);
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  auto&& solver = internal::sparse_linear_solver(np);
  internal::Progress progress(visitor);
  progress.begin_stage("fit");
  const internal::Adaptive_fit_options options{
      tolerance, choose_parameter(get_parameter(np, np_tags::fairness), default_fairness),
      choose_parameter(get_parameter(np, np_tags::maximum_number_of_control_points), std::optional<std::size_t>()),
      static_cast<int>(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 16))};

  Adaptive_fit_report<T_mesh_graph<TMesh>, typename T_spline<Kernel>::Graph, TriangleMesh> report;
  const auto refused = [&report](const Status status) {
    report.status = status;
    return report;
  };
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    return refused(Status::INVALID_TOLERANCE);
  if (!(options.fairness >= 0) || !std::isfinite(options.fairness)) {
    report.fit.status = T_spline_fit_status::INVALID_FAIRNESS;
    return refused(Status::FIT_FAILED);
  }
  if (surface.triangles().empty())
    return refused(Status::NO_SURFACE);
  if (!internal::is_known_admissible(t_mesh, np, progress, report.fit.surface.compatibility))
    return refused(progress.is_interrupted() ? Status::INTERRUPTED : Status::INADMISSIBLE);
  internal::Reference_mesh reference(mesh, point_map, np, progress);
  if (!reference.is_valid()) {
    report.deviation.status = reference.reading().status;
    report.deviation.vertex = reference.reading().vertex;
    report.deviation.face = reference.reading().face;
    return refused(Status::NOT_MEASURABLE);
  }

  const internal::Mesh_indexing<T_mesh_graph<TMesh>> indexing(t_mesh.graph());
  T_mesh<typename Kernel::Point_3, typename Kernel::FT> working;
  internal::copy_elements(indexing, Const_T_mesh_view_of<TMesh>(t_mesh), T_mesh_view_of<decltype(working)&>(working));
  using Fit = internal::Adaptive_fit<Kernel, std::decay_t<decltype(solver)>, decltype(reference)>;
  const typename Fit::Level_observer observer =
      choose_parameter(get_parameter(np, np_tags::level_observer), typename Fit::Level_observer());
  Fit fit(working, internal::copied_surface(indexing, surface, working.graph(), progress), reference, options, solver,
          observer, progress);
  fit.run(report);
  if (report.success())
    spline = T_spline<Kernel>(fit.best());
  return report;
}

/// \ingroup PkgTSplinesSpline
/// does the same for a mesh that is not at hand: the surface is measured against the triangles of `surface` that are data; the
/// report names the faces of `surface.mesh()`.
template <typename TMesh, typename Kernel, typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto fit_adaptive_T_spline(const TMesh& t_mesh, const Carried_surface<T_mesh_graph<TMesh>>& surface,
                           const double tolerance, T_spline<Kernel>& spline,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  using Face = typename decltype(surface.mesh())::Face_index;
  const auto is_data = boost::make_function_property_map<Face>([&surface](const Face f) { return surface.is_data(f); });
  return fit_adaptive_T_spline(t_mesh, surface, surface.mesh(), tolerance, spline,
                               parameters::face_is_data_map(is_data, np));
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H
