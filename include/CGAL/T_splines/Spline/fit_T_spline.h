// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_FIT_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_FIT_T_SPLINE_H

#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/Spline/T_spline_fit_report.h>
#include <CGAL/T_splines/Spline/internal/T_spline_fitter.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Closest_rectangle.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/graph_checks.h>
#include <CGAL/T_splines/internal/tolerances.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

// Whether x is in [0, size], up to what round-off explains.
template <typename FT>
bool is_inside(const FT& x, const FT& size)
{
  return excess(x, size) <= FT(summed_round_off);
}

// The samples in indices. Fills the report and returns an empty vector if one is invalid, or none has a weight.
template <typename FT, typename Graph, typename SampleRange>
std::vector<Fitting_sample<FT>> fitting_samples(const Mesh_indexing<Graph>& indexing, const T_mesh_arrays<FT>& t_mesh,
                                                const SampleRange& samples, T_spline_fit_report<Graph>& report)
{
  const std::size_t first_foreign =
      first_foreign_face(indexing.graph(), samples, [](const auto& sample) { return sample.place.face; });
  std::vector<Fitting_sample<FT>> result;
  FT weight(0);
  std::size_t i = 0;
  for (const auto& sample : samples) {
    if (i == first_foreign) {
      report.status = T_spline_fit_status::INVALID_SAMPLE;
      report.sample = i;
      return {};
    }
    const int f = indexing.face_index(sample.place.face);
    Fitting_sample<FT> s{
        f, sample.place.u, sample.place.v, {sample.point.x(), sample.point.y(), sample.point.z()}, sample.weight};
    if (!is_inside(s.u, t_mesh.width(f)) || !is_inside(s.v, t_mesh.height(f)) || !(s.weight >= FT(0)) ||
        !std::isfinite(s.weight) || !std::isfinite(s.point[0]) || !std::isfinite(s.point[1]) ||
        !std::isfinite(s.point[2])) {
      report.status = T_spline_fit_status::INVALID_SAMPLE;
      report.sample = i;
      return {};
    }
    clamp_to_rectangle(s.u, s.v, t_mesh.width(f), t_mesh.height(f));
    weight += s.weight;
    result.push_back(s);
    ++i;
  }
  if (!(weight > FT(0))) {
    report.status = T_spline_fit_status::NO_SAMPLES;
    return {};
  }
  return result;
}

// The weights of the control points: 1 unless given.
template <typename FT, typename Graph, typename NamedParameters>
auto control_point_weights(const Graph&, const NamedParameters& np)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, np_tags::vertex_weight_map),
                                            CGAL::Constant_property_map<vertex_descriptor, FT>(FT(1)));
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// fits a T-spline surface to samples of a surface: finds the control points that minimize E_dist + lambda E_fair
/// ([He06] section 3.3, equation (3)), in the faces at extraordinary vertices as in all others.
///
/// - E_dist = sum of w |S(u) - p|^2 over the samples p with the place u and the weight w.
/// - E_fair = sum of the thin-plate energies of the faces, the integrals of S_xx^2 + 2 S_xy^2 + S_yy^2. In each face, x
///   and y are u and v in the unit in which the face has the area that it has on the surface, the sum of the weights in
///   it: the units of knots, which change from face to face, do not matter. At an extraordinary vertex, x and y are the
///   coordinates of the characteristic map of Catmull-Clark subdivision, likewise.
/// - lambda = fairness d^4, where d^2 is the mean weight of a sample, so that d is the distance between samples:
///   features smaller than fairness^(1/4) d are smoothed away. The fairness has no unit.
///
/// Then the samples are moved to the points of the surface that are closest nearby, and the surface is fitted again, as
/// long as this reduces the root mean square of the distances by 2 percent or more (parameter correction).
/// \tparam TMesh a model of `TMesh`, with a graph as for `T_spline_surface`
/// \tparam SampleRange a range of models of `TMeshSample`, such as `T_mesh_sample<Graph, Kernel>`; `Kernel::FT` is the floating
///         point type of the computation
/// \tparam VertexPointMap a writable map, vertex -> `Kernel::Point_3`
/// \param t_mesh a spline compatible T-mesh
/// \param samples for instance the `samples()` of a `Carried_samples`; their places are moved upon success, if corrections are
///        asked for
/// \param control_points written upon success, to euclidean coordinates
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{fairness}
///     \cgalParamDescription{the weight of the thin-plate energy, without unit}
///     \cgalParamType{a number >= 0}
///     \cgalParamDefault{`default_fairness`}
///     \cgalParamExtra{With 0, the samples alone must determine all control points.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{how often the samples are moved at most}
///     \cgalParamType{`int`}
///     \cgalParamDefault{6}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_weight_map}
///     \cgalParamDescription{the weights of the rational form}
///     \cgalParamType{a model of `ReadablePropertyMap`, vertex of the T-mesh -> positive number}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///     \cgalParamExtra{`Eigen_spd_solver_traits<Eigen::ConjugateGradient<...>>` is the method of [He06].}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{as for `check_admissibility()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_relative_tolerance`, 1e-9; 0 for exact number types}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return whether the surface was fitted, if not, why, and how far it is from the samples
///
/// Complexity: for each fit linear in the number of samples times the squared number of basis functions that act in a
/// face (about 20), and one sparse factorization.
template <typename TMesh, typename SampleRange, typename VertexPointMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_fit_report<T_mesh_graph<TMesh>> fit_T_spline(const TMesh& t_mesh, SampleRange& samples,
                                                      const VertexPointMap control_points,
                                                      const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Point_3 = std::decay_t<decltype(samples.begin()->point)>;
  using Kernel = typename CGAL::Kernel_traits<Point_3>::Kernel;
  using FT = typename Kernel::FT;
  static_assert(std::is_floating_point<FT>::value, "fits are computed in a floating point type");
  const FT fairness = FT(choose_parameter(get_parameter(np, np_tags::fairness), default_fairness));
  const int number_of_corrections =
      static_cast<int>(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 6));
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("fit");
  auto&& solver = internal::sparse_linear_solver(np);

  T_spline_fit_report<T_mesh_graph<TMesh>> report;
  if (!(fairness >= FT(0)) || !std::isfinite(fairness)) {
    report.status = T_spline_fit_status::INVALID_FAIRNESS;
    return report;
  }
  internal::T_spline_fitter<Const_T_mesh_view_of<TMesh>, Kernel> fitter(
      t_mesh, internal::control_point_weights<FT>(t_mesh.graph(), np), np, progress);
  if (!progress.go_on()) {
    report.status = T_spline_fit_status::INTERRUPTED;
    return report;
  }
  report.surface = fitter.fitted().surface().report();
  if (!report.surface.success()) {
    report.status = T_spline_fit_status::INVALID_SURFACE;
    return report;
  }
  const auto& indexing = fitter.fitted().surface().indexing();
  std::vector<internal::Fitting_sample<FT>> fitting_samples =
      internal::fitting_samples(indexing, fitter.fitted().surface().t_mesh_arrays(), samples, report);
  if (!report.success())
    return report;
  fitter.fit(fitting_samples, fairness, number_of_corrections, solver, report);
  if (!report.success())
    return report;
  std::size_t i = 0;
  for (auto& sample : samples) {
    sample.place.face = indexing.face(fitting_samples[i].face);
    sample.place.u = fitting_samples[i].u;
    sample.place.v = fitting_samples[i].v;
    ++i;
  }
  for (const auto v : CGAL::make_range(vertices(t_mesh.graph())))
    put(control_points, v, fitter.fitted().control_point(v));
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_FIT_T_SPLINE_H
