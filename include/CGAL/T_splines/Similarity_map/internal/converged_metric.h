// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONVERGED_METRIC_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONVERGED_METRIC_H

#include <CGAL/T_splines/Cross_field/check_holonomy_signature.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Loop_reach.h>
#include <CGAL/T_splines/Similarity_map/internal/Metric_computation.h>
#include <CGAL/T_splines/Solver/default_solver.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The number type in which a metric computed in `FT` is laid out: its own, but at least `long double`.
template <typename FT>
using Layout_number_type =
    std::conditional_t<(std::numeric_limits<FT>::digits < std::numeric_limits<long double>::digits), long double, FT>;

/// The number type to go on with where `FT` has reached its floor; `void` if there is none.
template <typename FT>
struct Wider_number_type {
  using type = void;
};
template <>
struct Wider_number_type<double> {
  using type = std::conditional_t<(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits),
                                  long double, boost::multiprecision::cpp_bin_float_quad>;
};
template <>
struct Wider_number_type<long double> {
  using type = boost::multiprecision::cpp_bin_float_quad;
};

/// tells in `report` how close the scale periods of short loops have come to their limit.
template <typename FT, typename TriangleMesh>
void check_reach(const Metric_computation<FT>& computation, Progress& progress,
                 Similarity_map_report<TriangleMesh>& report)
{
  constexpr double close = 0.9; // to the limit, 1: strips that are not looked at may be nearer
  const Loop_reach<FT> reach = largest_loop_reach(computation.structure, progress);
  report.scale_period = reach.period;
  report.hyperbolic_length = reach.length;
  if (reach.ratio() > close)
    report.status = Similarity_map_status::SIGNATURE_OUT_OF_REACH;
}

/// continues a converged computation in the number type of the layout, for one step: closing errors of a layout exceed
/// the residual by orders of magnitude. The cost is two evaluations; the step is not counted as an iteration.
template <typename TriangleMesh, typename FlipPolicy, typename SolverTraits>
Metric_computation<Layout_number_type<double>>
sharpened(const Metric_computation<double>& computation, const Metric_input& input,
          const Mesh_indexing<TriangleMesh>& indexing, const FlipPolicy& policy, SolverTraits& solver,
          Progress& progress, Similarity_map_report<TriangleMesh>& report)
{
  using FT = Layout_number_type<double>;
  Metric_computation<FT> sharp(computation);
  Newton_system<FT> system(input);
  Newton_limits limits;
  limits.tolerance = 1e-17; // two digits above the unit of rounding of long double
  limits.number_of_iterations = computation.record.iterations + 1;
  Similarity_map_report<TriangleMesh> sharp_report = report;
  sharp.iterate(system, policy, solver, progress, limits);
  fill_report(sharp, system, input, indexing, sharp_report);
  if (!(sharp_report.residual <= report.residual))
    return Metric_computation<FT>(computation);
  report.residual = report.residual_history.back() = sharp_report.residual;
  report.mantissa_bits = sharp_report.mantissa_bits;
  report.vertex = sharp_report.vertex;
  report.loop = sharp_report.loop;
  report.arc = sharp_report.arc;
  return sharp;
}

/// Computes a metric in a number type, and in wider ones where it does not suffice.
///
/// Where the residual comes to a floor near the solution, the iteration goes on from there. Where it stalls far from it,
/// or flips do not end, or the map of a converged metric cannot be laid out, lengths and flips may have lost more than
/// the residual tells: the wider type starts from the input.
template <typename TriangleMesh, typename FlipPolicy, typename SolverTraits, typename Consume>
class Widening_computation {
public:
  using Report = Similarity_map_report<TriangleMesh>;

  const Metric_input& input;
  const Mesh_indexing<TriangleMesh>& indexing;
  const FlipPolicy& policy;
  SolverTraits& solver;
  Progress& progress;
  const Newton_limits& limits;
  bool tracks_edges;
  const Consume& consume; ///< called with a converged computation; tells whether it could use it

  /// starts from the input, in the number type `FT`. \param before what narrower types did
  template <typename FT>
  void start(const Newton_record& before, Report& report) const
  {
    Metric_computation<FT> computation(input, tracks_edges);
    computation.record = before;
    if (computation.prepare(policy, progress)) {
      iterate(computation, report);
      return;
    }
    if (progress.is_interrupted())
      return;
    report.status = Similarity_map_status::STALLED;
    report.residual = std::numeric_limits<double>::infinity();
    report.mantissa_bits = std::numeric_limits<FT>::digits;
    start_in_wider_type<FT>(before, report);
  }

private:
  template <typename FT>
  void iterate(Metric_computation<FT>& computation, Report& report) const
  {
    Newton_system<FT> system(input);
    computation.iterate(system, policy, solver, progress, limits);
    fill_report(computation, system, input, indexing, report);
    if (report.success()) {
      const Newton_record record = computation.record;
      if (!is_consumed(computation, report) && !progress.is_interrupted() && flips_by_ptolemy(policy))
        start_in_wider_type<FT>(record, report);
      return;
    }
    const bool is_near = report.residual < near_residual;
    if (!is_near && flips_by_ptolemy(policy) && report.status != Similarity_map_status::INTERRUPTED)
      check_reach(computation, progress, report);
    if (report.status != Similarity_map_status::STALLED)
      return;
    if (!is_near && flips_by_ptolemy(policy))
      start_in_wider_type<FT>(computation.record, report);
    if constexpr (!std::is_void<typename Wider_number_type<FT>::type>::value) {
      if (is_near) {
        Metric_computation<typename Wider_number_type<FT>::type> wide(computation);
        iterate(wide, report);
      }
    }
  }

  template <typename FT>
  void start_in_wider_type([[maybe_unused]] Newton_record before, [[maybe_unused]] Report& report) const
  {
    using Wider = typename Wider_number_type<FT>::type;
    if constexpr (!std::is_void<Wider>::value) {
      before.factorizations_in_use = 0;
      start<Wider>(before, report);
    }
  }

  template <typename FT>
  bool is_consumed(Metric_computation<FT>& computation, [[maybe_unused]] Report& report) const
  {
    if constexpr (std::is_same<FT, double>::value && !std::is_same<Layout_number_type<double>, double>::value) {
      if (tracks_edges) {
        const auto sharp = sharpened(computation, input, indexing, policy, solver, progress, report);
        computation = Metric_computation<FT>(); // its memory is wanted
        return consume(sharp);
      }
    }
    return consume(computation);
  }
};

/// computes the similarity metric of a mesh with a signature and calls `consume(input, computation)` if it converges. If
/// that returns `false` it does so again, with a computation in a wider number type, as long as there is one.
///
/// It is what the public functions share: the checks, the named parameters and the number types.
template <typename TriangleMesh, typename NamedParameters, typename Consume>
Similarity_map_report<TriangleMesh>
converged_metric(const TriangleMesh& mesh, const Holonomy_signature<TriangleMesh>& signature, const bool tracks_edges,
                 const NamedParameters& np, const Mesh_indexing<TriangleMesh>& indexing, Progress& progress,
                 Consume&& consume)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Similarity_map_report<TriangleMesh> report;
  progress.begin_stage("similarity metric");
  {
    const Progress::Part part(progress, 0, 0.1);
    report.signature = holonomy_signature_report(mesh, signature, np, progress);
  }
  if (progress.is_interrupted()) {
    report.status = Similarity_map_status::INTERRUPTED;
    return report;
  }
  if (!report.signature.success()) {
    report.status = report.signature.status == Holonomy_signature_status::INVALID_MESH
                        ? Similarity_map_status::INVALID_MESH
                        : Similarity_map_status::INVALID_SIGNATURE;
    return report;
  }
  const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  const auto policy = choose_parameter(get_parameter(np, np_tags::flip_policy), Ideal_delaunay_flips());
  using FT = std::decay_t<decltype(choose_parameter(get_parameter(np, np_tags::number_type), 0.))>;
  Newton_limits limits;
  limits.tolerance = choose_parameter(get_parameter(np, np_tags::residual_tolerance), limits.tolerance);
  limits.number_of_iterations =
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), limits.number_of_iterations);
  // A solver of our own is given up, with its factorization, before what follows the metric asks for memory.
  using Solver = decltype(sparse_linear_solver(np));
  std::optional<std::decay_t<Solver>> own_solver;
  std::decay_t<Solver>* solver = nullptr;
  if constexpr (std::is_reference<Solver>::value)
    solver = &sparse_linear_solver(np);
  else
    solver = &own_solver.emplace(sparse_linear_solver(np));

  const Metric_input input(indexing, signature, points);
  const auto consume_without_solver = [&](const auto& converged) {
    own_solver.reset();
    if (progress.go_on() && consume(input, converged))
      return true;
    if constexpr (!std::is_reference<Solver>::value)
      solver = &own_solver.emplace(sparse_linear_solver(np));
    return false;
  };
  using Computation = Widening_computation<TriangleMesh, std::decay_t<decltype(policy)>, std::decay_t<Solver>,
                                           decltype(consume_without_solver)>;
  const Computation computation{input,    indexing, policy,       *solver,
                                progress, limits,   tracks_edges, consume_without_solver};
  {
    const Progress::Part part(progress, 0.1, 1);
    computation.template start<FT>(Newton_record(), report);
  }
  if (progress.is_interrupted())
    report.status = Similarity_map_status::INTERRUPTED;
  return report;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CONVERGED_METRIC_H
