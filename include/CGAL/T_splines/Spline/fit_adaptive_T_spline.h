// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H

#include <CGAL/T_splines/Progress_visitor.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/Spline/Adaptive_fit_report.h>
#include <CGAL/T_splines/Spline/fit_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Adaptive_fit.h>
#include <CGAL/T_splines/T_mesh/T_mesh_sample.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

/// The visitor of an adaptive fit that does nothing, and the list of what such a visitor offers: a `Progress_visitor`
/// that also sees the levels.
struct Adaptive_fit_visitor : Progress_visitor {
  /// is called when a level is fitted, with its T-mesh and control points, which do not last.
  template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename VertexPointMap>
  void level_fitted(const T_spline_fit_level& /*level*/, const TMesh& /*t_mesh*/, const HalfedgeKnotMap /*knots*/,
                    const HalfedgeCornerMap /*corners*/, const VertexPointMap /*control_points*/) const
  {
  }
};

namespace internal {

/// Admissible, and with samples: fills the working T-mesh.
template <typename Kernel, typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename SampleRange,
          typename NamedParameters>
bool prepare_adaptive_fit(const TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                          const SampleRange& samples, const NamedParameters& np, Working_t_mesh<Kernel>& working,
                          std::vector<Fitting_sample<typename Kernel::FT>>& fitting_samples_out,
                          Adaptive_fit_report<TMesh>& report)
{
  using FT = typename Kernel::FT;
  if (!is_known_admissible(t_mesh, knots, corners, np, report.fit.surface.compatibility)) {
    report.status = Adaptive_fit_status::INADMISSIBLE;
    return false;
  }
  const Mesh_indexing<TMesh> indexing(t_mesh);
  fitting_samples_out = fitting_samples(indexing, T_mesh_arrays<FT>(indexing, knots, corners), samples, report.fit);
  if (!report.fit.success()) {
    report.status = Adaptive_fit_status::FIT_FAILED;
    return false;
  }
  copy_t_mesh(indexing, knots, corners, working.mesh, working.knots, working.corners);
  return true;
}

} // namespace internal

/// approximates a surface, given by samples, by a T-spline surface within a tolerance ([He06] section 3.3): fits,
/// refines the T-mesh where the surface is too far from the samples, and fits again.
///
/// The T-mesh is made spline compatible first, and graded: no face is more than six times as large as a neighbour,
/// unless too few control points are allowed. In each level `fit_T_spline()` finds the control points, from the places
/// to which the level before moved the samples. A face whose largest error exceeds twice the tolerance is divided into
/// four then, another one beyond the tolerance into two, across its longer side on the surface; the rings around an
/// extraordinary vertex are made half as wide where one of their faces is to be divided. The T-mesh is made spline
/// compatible again.
///
/// A good start is a coarse, regularized T-mesh with faces of even size on the surface: `refine_T_mesh()` with
/// `Surface_face_size`.
/// \tparam TMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; it may be non-simple
/// \tparam HalfedgeKnotMap, HalfedgeCornerMap as for `T_spline_surface`; knots of any number type
/// \tparam SampleRange as for `fit_T_spline()`
/// \tparam OutTMesh a model of `MutableFaceGraph` and of the concepts of `TMesh`
/// \tparam OutKnotMap, OutCornerMap, OutPointMap writable maps of its halfedges and vertices
/// \param t_mesh, knots, corners an admissible T-mesh; not changed
/// \param samples as for `fit_T_spline()`; not changed. `sample_T_mesh()` makes them
/// \param tolerance the largest distance allowed between a sample and the surface, in the units of the samples' points;
///        positive
/// \param out_t_mesh, out_knots, out_corners, out_control_points receive the best level: the T-mesh, its knots in the
///        floating point type of the samples, and the control points, whose weights are 1; written upon success only.
///        \pre `out_t_mesh` is empty
/// \param np optional named parameters:
///   `T_splines::parameters::maximum_number_of_control_points`: a `std::size_t`, at most the number of samples (a
///     quarter of it, or as many as the coarsest spline compatible T-mesh needs);
///   `T_splines::parameters::fairness`, `CGAL::parameters::number_of_iterations`,
///   `CGAL::parameters::sparse_linear_solver`: as for `fit_T_spline()`, for each level;
///   `CGAL::parameters::visitor`: an `Adaptive_fit_visitor`;
///   `T_splines::parameters::relative_tolerance`, as for `is_admissible()`
/// \return why it ended, and the errors of all levels. Complexity: as `fit_T_spline()` and `make_spline_compatible()`
/// for each level.
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename SampleRange, typename OutTMesh,
          typename OutKnotMap, typename OutCornerMap, typename OutPointMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Adaptive_fit_report<TMesh>
fit_adaptive_T_spline(const TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                      const SampleRange& samples, const double tolerance, OutTMesh& out_t_mesh,
                      const OutKnotMap out_knots, const OutCornerMap out_corners, const OutPointMap out_control_points,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Point_3 = std::decay_t<decltype(samples.begin()->point)>;
  using Kernel = typename CGAL::Kernel_traits<Point_3>::Kernel;
  static_assert(std::is_floating_point<typename Kernel::FT>::value, "fits are computed in a floating point type");
  const auto visitor = choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Adaptive_fit_visitor());
  auto&& solver = internal::sparse_linear_solver(np);

  Adaptive_fit_report<TMesh> report;
  internal::Working_t_mesh<Kernel> working;
  std::vector<internal::Fitting_sample<typename Kernel::FT>> fitting_samples;
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    report.status = Adaptive_fit_status::INVALID_TOLERANCE;
    return report;
  }
  if (!internal::prepare_adaptive_fit(t_mesh, knots, corners, samples, np, working, fitting_samples, report))
    return report;
  report.number_of_samples = fitting_samples.size();
  const auto limit = get_parameter(np, np_tags::maximum_number_of_control_points);
  const internal::Adaptive_fit_options options{
      tolerance, choose_parameter(get_parameter(np, np_tags::fairness), default_fairness),
      choose_parameter(limit, fitting_samples.size() / 4), !internal::is_missing<decltype(limit)>,
      static_cast<int>(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 6))};
  if (!(options.fairness >= 0) || !std::isfinite(options.fairness)) {
    report.status = Adaptive_fit_status::FIT_FAILED;
    report.fit.status = T_spline_fit_status::INVALID_FAIRNESS;
    return report;
  }
  if (options.largest_number_of_control_points > fitting_samples.size()) {
    report.status = Adaptive_fit_status::LIMIT_ABOVE_SAMPLES;
    return report;
  }
  internal::Adaptive_fit<Kernel, std::decay_t<decltype(solver)>, std::decay_t<decltype(visitor)>> fit(
      working, fitting_samples, options, solver, visitor);
  fit.run(report);
  if (!report.success())
    return report;
  const internal::Working_t_mesh<Kernel>& best = fit.best();
  internal::copy_t_mesh(internal::Mesh_indexing<typename internal::Working_t_mesh<Kernel>::Mesh>(best.mesh), best.knots,
                        best.corners, out_t_mesh, out_knots, out_corners);
  auto point = best.mesh.points().begin();
  for (const auto v : CGAL::make_range(vertices(out_t_mesh)))
    put(out_control_points, v, *point++);
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_FIT_ADAPTIVE_T_SPLINE_H
