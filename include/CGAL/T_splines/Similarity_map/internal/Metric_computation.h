// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_METRIC_COMPUTATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_METRIC_COMPUTATION_H

#include <CGAL/T_splines/Similarity_map/Flip_policy.h>
#include <CGAL/T_splines/Similarity_map/internal/Metric_input.h>
#include <CGAL/T_splines/Similarity_map/internal/Newton_iteration.h>
#include <CGAL/T_splines/Similarity_map/internal/Newton_system.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

inline constexpr bool makes_delaunay(const Ideal_delaunay_flips&)
{
  return true;
}
inline constexpr bool makes_delaunay(const Degeneracy_flips& policy)
{
  return policy.delaunay;
}
inline constexpr bool flips_by_ptolemy(const Ideal_delaunay_flips&)
{
  return true;
}
inline constexpr bool flips_by_ptolemy(const Degeneracy_flips&)
{
  return false;
}

/// The computation of a similarity metric in the number type `FT`: its stages and what they leave.
template <typename FT_>
struct Metric_computation {
  using FT = FT_;
  using Index = Triangulation_connectivity::Index;

  Similarity_structure<FT> structure;
  std::vector<FT> coefficients;       ///< phi per vertex, then c per loop
  Triangulation_connectivity middle;  ///< the triangulation from which the iteration started
  Mirror_pairs middle_pairs;          ///< its faces that were images of each other
  Normal_coordinates input_on_middle; ///< of the input's edges; empty if the two are the same
  std::size_t delaunay_flips = 0;
  Newton_record record;

  Metric_computation() = default;

  /// takes the input's metric. \param tracks_edges whether the common subdivision will be wanted
  Metric_computation(const Metric_input& input, const bool tracks_edges)
    : coefficients(input.quarter_turns.size(), FT(0))
  {
    using std::log;
    structure.mesh = input.mesh;
    structure.pairs = input.pairs;
    structure.form.assign(input.mesh.number_of_edges(), FT(0));
    structure.log_length.reserve(input.mesh.number_of_edges());
    for (Index e = 0; e < input.mesh.number_of_edges(); ++e)
      structure.log_length.push_back(log(input.template squared_length<FT>(e)) / 2);
    structure.loops = Dual_loops(input.mesh.number_of_edges());
    for (const std::vector<int>& loop : input.loops)
      structure.loops.add(loop);
    if (tracks_edges)
      structure.delaunay_edges = Normal_coordinates(input.mesh);
  }

  /// continues the computation `other` in this number type.
  template <typename OtherFT>
  explicit Metric_computation(const Metric_computation<OtherFT>& other)
    : coefficients(other.coefficients.begin(), other.coefficients.end()),
      middle(other.middle),
      middle_pairs(other.middle_pairs),
      input_on_middle(other.input_on_middle),
      delaunay_flips(other.delaunay_flips),
      record(other.record)
  {
    structure.mesh = other.structure.mesh;
    structure.loops = other.structure.loops;
    structure.pairs = other.structure.pairs;
    structure.delaunay_edges = other.structure.delaunay_edges;
    structure.delaunay_tolerance =
        static_cast<FT>(other.structure.delaunay_tolerance); // the lengths are no more accurate than they were
    structure.log_length.assign(other.structure.log_length.begin(), other.structure.log_length.end());
    structure.log_penner.assign(other.structure.log_penner.begin(), other.structure.log_penner.end());
    structure.form.assign(other.structure.form.size(), FT(0));
    structure.set_form(coefficients);
  }

  /// The triangulation from which the iteration starts. \return `false` if the flips do not end, or `progress` is
  /// interrupted.
  template <typename FlipPolicy>
  bool prepare(const FlipPolicy& policy, Progress& progress)
  {
    const bool tracks_edges = !structure.delaunay_edges.is_empty();
    if (makes_delaunay(policy)) {
      const std::size_t most_flips = 1000 + 100 * static_cast<std::size_t>(structure.mesh.number_of_edges());
      delaunay_flips = flip_all_to_delaunay(
          structure, most_flips, [this](const Index h) { structure.flip_euclidean(h); }, progress);
      if (delaunay_flips > most_flips)
        return false;
    }
    if (tracks_edges) {
      if (delaunay_flips > 0)
        input_on_middle = structure.delaunay_edges;
      structure.delaunay_edges = Normal_coordinates(structure.mesh);
      middle = structure.mesh;
      middle_pairs = structure.pairs;
    }
    if (!flips_by_ptolemy(policy))
      structure.log_penner = structure.log_length;
    return progress.go_on();
  }

  /// runs Newton's iteration. The record goes on where an earlier one in another number type ended.
  template <typename FlipPolicy, typename SolverTraits>
  void iterate(Newton_system<FT>& system, const FlipPolicy& policy, SolverTraits& solver, Progress& progress,
               Newton_limits limits)
  {
    limits.number_of_iterations -= record.iterations;
    Newton_iteration<FT, SolverTraits> newton(structure, system, coefficients, solver, record.factorizations_in_use > 0,
                                              progress, limits);
    const Newton_record next = newton.run(policy);
    record.status = next.status;
    if (!record.residual_history.empty())
      record.residual_history.pop_back(); // evaluated anew
    record.residual_history.insert(record.residual_history.end(), next.residual_history.begin(),
                                   next.residual_history.end());
    record.iterations += next.iterations;
    record.halvings += next.halvings;
    record.factorizations += next.factorizations;
    record.factorizations_in_use += next.factorizations_in_use;
    record.linear_iterations += next.linear_iterations;
    record.flips += next.flips;
  }

  /// Penner's coordinates on the final triangulation.
  const std::vector<FT>& log_penner() const
  {
    return structure.log_penner.empty() ? structure.log_length : structure.log_penner;
  }
};

/// fills in what `computation` did; the place of the largest residual is that of `system`.
template <typename TriangleMesh, typename FT, typename Report>
void fill_report(const Metric_computation<FT>& computation, const Newton_system<FT>& system, const Metric_input& input,
                 const Mesh_indexing<TriangleMesh>& indexing, Report& report)
{
  const Newton_record& record = computation.record;
  report.status = record.status;
  report.residual = static_cast<double>(system.residual());
  report.residual_history = record.residual_history;
  report.iterations = record.iterations;
  report.halvings = record.halvings;
  report.factorizations = record.factorizations;
  report.linear_iterations = record.linear_iterations;
  report.delaunay_flips = computation.delaunay_flips;
  report.flips = record.flips;
  report.mantissa_bits = std::numeric_limits<FT>::digits;
  const std::size_t worst = system.worst(), vertices = input.original_vertex.size();
  if (worst < vertices)
    report.vertex = indexing.vertex(input.original_vertex[worst]);
  else if (worst < vertices + input.number_of_loops)
    report.loop = worst - vertices;
  else if (worst < vertices + input.number_of_loops + input.number_of_arcs)
    report.arc = worst - vertices - input.number_of_loops;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_METRIC_COMPUTATION_H
