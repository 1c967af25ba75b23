// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_APPROXIMATION_APPROXIMATE_BY_T_SPLINE_H
#define CGAL_T_SPLINES_APPROXIMATION_APPROXIMATE_BY_T_SPLINE_H

#include <CGAL/T_splines/Approximation/T_spline_approximation.h>
#include <CGAL/T_splines/Approximation/T_spline_approximation_report.h>
#include <CGAL/T_splines/Spline/T_spline.h>
#include <CGAL/T_splines/Spline/fit_T_spline.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace T_splines {

namespace internal {

template <typename TriangleMesh, typename NamedParameters>
auto points_of(const TriangleMesh& mesh, const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                            get_const_property_map(CGAL::vertex_point, mesh));
}

template <typename TriangleMesh, typename NamedParameters, typename FT = CGAL::Exact_rational>
using Approximation_of = T_spline_approximation<
    TriangleMesh, decltype(points_of(std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>())), FT>;

/// The first stage, with the named parameters that concern it.
template <typename Approximation, typename NamedParameters>
bool guide(Approximation& approximation, const NamedParameters& np)
{
  namespace P = parameters;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto common = visitor_and_solver(np);
  const double alignment = choose_parameter(get_parameter(np, np_tags::curvature_alignment), 0.);
  const std::optional<double> energy =
      choose_parameter(get_parameter(np, np_tags::maximum_energy_change), std::optional<double>());
  const std::optional<int> cones =
      choose_parameter(get_parameter(np, np_tags::maximum_number_of_cones), std::optional<int>());
  return approximation.compute_cross_field(P::curvature_alignment(alignment, common)) &&
         approximation.reduce_cones(P::maximum_energy_change(energy, P::maximum_number_of_cones(cones, common)));
}

} // namespace internal

/// \ingroup PkgTSplinesApproximation
/// approximates a triangle mesh by a T-spline surface within a tolerance, both ways, without folds and without
/// self-intersections where the mesh has none ([CZ17]; [He06]). `T_spline_approximation` has the stages one by one.
///
/// The result is measured: what the report says of it is what `measure_T_spline_deviation()` and
/// `check_T_spline_self_intersections()` find.
/// \tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \param mesh a triangle mesh, of one or more components, as `check_triangle_mesh()` demands
/// \param spline receives the surface upon success; it stays what it was otherwise
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
///     \cgalParamDescription{which faces the surface is fitted to and measured against: the others only close holes, as those
///       of `fill_holes()` do}
///     \cgalParamType{a model of `ReadablePropertyMap`, `boost::graph_traits<TriangleMesh>::%face_descriptor` -> `bool`}
///     \cgalParamDefault{all}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{the largest distance allowed between mesh and surface, by the longest side of the bounding box
///       of the mesh}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_tolerance`, 0.005}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_control_points}
///     \cgalParamDescription{the most control points, as for `fit_adaptive_T_spline()`}
///     \cgalParamType{`std::optional<std::size_t>`}
///     \cgalParamDefault{as there}
///   \cgalParamNEnd
///   \cgalParamNBegin{fairness}
///     \cgalParamDescription{the weight of the thin-plate energy, as for `fit_adaptive_T_spline()`}
///     \cgalParamType{a number >= 0}
///     \cgalParamDefault{`default_fairness`}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_alignment}
///     \cgalParamDescription{how much the computed field follows the directions of principal curvature, as for
///       `compute_smooth_cross_field()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: not at all}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_energy_change}
///     \cgalParamDescription{how much a merge of cones may raise the energy, as for `reduce_cones()`}
///     \cgalParamType{`std::optional<double>`}
///     \cgalParamDefault{`default_energy_change()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_cones}
///     \cgalParamDescription{how many cones may be left, as for `reduce_cones()`}
///     \cgalParamType{`std::optional<int>`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress, and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done. `success()`: there is a surface; `within_tolerance()`: it is what was asked for; `describe()`
/// says in a sentence how good it is, or why there is none, and where. Complexity: that of the stages; seconds for
/// meshes of 100000 triangles.
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_approximation_report<TriangleMesh>
approximate_by_T_spline(const TriangleMesh& mesh, T_spline<>& spline,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace P = parameters;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const std::optional<std::size_t> control_points =
      choose_parameter(get_parameter(np, np_tags::maximum_number_of_control_points), std::optional<std::size_t>());
  internal::Approximation_of<TriangleMesh, NamedParameters> approximation(mesh, internal::points_of(mesh, np));
  if constexpr (!internal::is_missing<decltype(get_parameter(np, np_tags::face_is_data_map))>)
    approximation.set_data(get_parameter(np, np_tags::face_is_data_map));
  if (internal::guide(approximation, np) && approximation.compute_T_mesh(internal::visitor_and_solver(np)))
    approximation.fit(
        choose_parameter(get_parameter(np, np_tags::tolerance), default_tolerance), spline,
        P::fairness(choose_parameter(get_parameter(np, np_tags::fairness), default_fairness),
                    P::maximum_number_of_control_points(control_points, internal::visitor_and_solver(np))));
  return approximation.report();
}

/// \ingroup PkgTSplinesApproximation
/// computes an exactly seamless map of a refinement of a triangle mesh, guided by a smooth cross field with few
/// cones ([CZ17] sections 4 to 6): the first half of `approximate_by_T_spline()`.
/// \param mesh as for `approximate_by_T_spline()`
/// \param mapped becomes the refined mesh with its map upon success; it stays what it was otherwise
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
///   \cgalParamNBegin{curvature_alignment}
///     \cgalParamDescription{how much the computed field follows the directions of principal curvature, as for
///       `compute_smooth_cross_field()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: not at all}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_energy_change}
///     \cgalParamDescription{how much a merge of cones may raise the energy, as for `reduce_cones()`}
///     \cgalParamType{`std::optional<double>`}
///     \cgalParamDefault{`default_energy_change()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_cones}
///     \cgalParamDescription{how many cones may be left, as for `reduce_cones()`}
///     \cgalParamType{`std::optional<int>`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver for the linear systems}
///     \cgalParamType{a model of `SparseSpdSolverTraits`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_spd_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress, and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done
template <typename TriangleMesh, typename FT, typename NamedParameters = CGAL::parameters::Default_named_parameters>
T_spline_approximation_report<TriangleMesh>
compute_exact_map(const TriangleMesh& mesh, Mapped_mesh<TriangleMesh, FT>& mapped,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Approximation_of<TriangleMesh, NamedParameters, FT> approximation(mesh, internal::points_of(mesh, np));
  if (internal::guide(approximation, np) && approximation.compute_exact_map(internal::visitor_and_solver(np)))
    mapped = approximation.take_mapped_mesh();
  return approximation.report();
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_APPROXIMATION_APPROXIMATE_BY_T_SPLINE_H
