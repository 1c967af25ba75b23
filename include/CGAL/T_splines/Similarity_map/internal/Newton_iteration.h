// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NEWTON_ITERATION_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NEWTON_ITERATION_H

#include <CGAL/T_splines/Similarity_map/Flip_policy.h>
#include <CGAL/T_splines/Similarity_map/Similarity_map_report.h>
#include <CGAL/T_splines/Similarity_map/internal/Newton_system.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/Similarity_map/internal/first_degeneracy.h>
#include <CGAL/T_splines/Solver/preconditioned_conjugate_gradients.h>
#include <CGAL/T_splines/Solver/support/Interruptible_preconditioner.h>
#include <CGAL/T_splines/Solver/support/factorize.h>
#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Below this residual, an iteration that gets no further has met the round-off of its number type.
inline constexpr double near_residual = 1e-2;

/// What bounds a Newton iteration.
struct Newton_limits {
  double tolerance = default_residual_tolerance; ///< on the largest residual
  int number_of_iterations = default_number_of_newton_steps;
};

/// What a Newton iteration did.
struct Newton_record {
  Similarity_map_status status = Similarity_map_status::STALLED;
  std::vector<double> residual_history;
  int iterations = 0, halvings = 0, factorizations = 0, linear_iterations = 0;
  int factorizations_in_use = 0; ///< 0 if what the solver has factorized last is of no use
  std::size_t flips = 0;
};

/// Newton's iteration for the scale factors of a similarity structure.
///
/// The linear systems are solved in double by conjugate gradients, each only as accurately as its step deserves. They
/// are preconditioned with the factorization of an earlier one: phi and c keep their meaning across flips, so that it
/// stays a good approximation; it is renewed when conjugate gradients need many iterations.
/// \tparam FT number type of the residual and the unknowns
/// \tparam SolverTraits a model of `SparseSpdSolverTraits` with `FT` double
template <typename FT, typename SolverTraits>
class Newton_iteration {
  using Index = Triangulation_connectivity::Index;
  using Structure = Similarity_structure<FT>;

public:
  /// \param coefficients phi per vertex and c per loop, in and out: those of `structure`
  /// \param is_factorized whether `solver` holds a factorization of an earlier system
  Newton_iteration(Structure& structure, Newton_system<FT>& system, std::vector<FT>& coefficients, SolverTraits& solver,
                   const bool is_factorized, Progress& progress, const Newton_limits& limits)
    : m_structure(structure),
      m_system(system),
      m_coefficients(coefficients),
      m_solver(solver),
      m_is_factorized(is_factorized),
      m_progress(progress),
      m_limits(limits)
  {
  }

  template <typename FlipPolicy>
  Newton_record run(const FlipPolicy& policy)
  {
    m_record.status = iterate(policy);
    if (m_progress.is_interrupted())
      m_record.status = Similarity_map_status::INTERRUPTED;
    return m_record;
  }

private:
  template <typename FlipPolicy>
  Similarity_map_status iterate(const FlipPolicy& policy)
  {
    if (!m_system.evaluate(m_structure, m_progress))
      return Similarity_map_status::STALLED;
    Stall_detector stall;
    while (true) {
      const double residual = static_cast<double>(m_system.residual());
      m_record.residual_history.push_back(residual);
      m_progress.progress(share_of_way());
      if (residual <= m_limits.tolerance)
        return Similarity_map_status::CONVERGED;
      if (stall.is_stalled(residual))
        return Similarity_map_status::STALLED;
      if (m_record.iterations >= m_limits.number_of_iterations)
        return Similarity_map_status::ITERATION_LIMIT;
      if (!m_progress.go_on())
        return Similarity_map_status::INTERRUPTED;
      if (!solve())
        return Similarity_map_status::SOLVER_FAILED;
      if (!m_progress.go_on())
        return Similarity_map_status::INTERRUPTED;
      const Similarity_map_status end = step(policy);
      if (end != Similarity_map_status::CONVERGED)
        return end;
      ++m_record.iterations;
    }
  }

  // Notices that the residual has come down to its floor: near the solution, where convergence ought to be quadratic,
  // it has ended.
  class Stall_detector {
  public:
    bool is_stalled(const double residual)
    {
      if (residual < clear_gain * m_best) {
        m_best = residual;
        m_unsuccessful = 0;
        return false;
      }
      ++m_unsuccessful;
      return (m_best < very_near_residual && m_unsuccessful > 3) || (m_best < near_residual && m_unsuccessful > 10);
    }

  private:
    static constexpr double clear_gain = 0.9;          // a step that converges takes away more than a tenth
    static constexpr double very_near_residual = 1e-6; // convergence is quadratic here, if there is any
    double m_best = std::numeric_limits<double>::infinity();
    int m_unsuccessful = 0;
  };

  // From the first residual to the tolerance, in orders of magnitude.
  double share_of_way() const
  {
    const std::vector<double>& history = m_record.residual_history;
    const double first = std::log(history.front()), goal = std::log(m_limits.tolerance);
    const double best = std::log(*std::min_element(history.begin(), history.end()));
    return first > goal ? std::min(1., std::max(0., (first - best) / (first - goal))) : 1.;
  }

  // The Newton direction, in m_direction.
  bool solve()
  {
    m_system.set_hessian(m_structure);
    const std::vector<double> right_hand_side = m_system.right_hand_side();
    if ((!m_is_factorized || m_last_inner_iterations > 20) && !factorize())
      return false;
    double norm = 0;
    for (const double b : right_hand_side)
      norm += b * b;
    norm = std::sqrt(norm);
    // Forcing term: a relative error as small as the residual keeps the convergence quadratic; more than the goal asks
    // for is wasted.
    constexpr double smallest = 1e-10, largest = 0.1; // what conjugate gradients reach in doubles, and what still helps
    const double tolerance =
        std::max(smallest, std::min(largest, std::max(0.3 * norm, 0.1 * m_limits.tolerance / norm)));
    m_last_inner_iterations =
        preconditioned_conjugate_gradients(m_system, Interruptible_preconditioner<SolverTraits>(m_solver, m_progress),
                                           right_hand_side, m_solution, tolerance, 500, m_workspace);
    m_record.linear_iterations += m_last_inner_iterations;
    m_direction = m_system.direction(m_solution);
    return true;
  }

  bool factorize()
  {
    const Symmetric_sparse_matrix<double> matrix = m_system.matrix();
    ++m_record.factorizations;
    ++m_record.factorizations_in_use;
    m_is_factorized = true;
    return analyze_and_factorize(m_solver, matrix, m_progress);
  }

  double slope() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_direction.size(); ++i)
      sum += static_cast<double>(m_system.gradient()[i]) * m_direction[i];
    return sum;
  }

  void set_trial(const double length)
  {
    for (std::size_t i = 0; i < m_coefficients.size(); ++i)
      m_coefficients[i] = m_accepted_coefficients[i] + FT(length) * FT(m_direction[i]);
    m_structure.set_form(m_coefficients);
  }

  // A damped Newton step on the convex energy: it is halved while the energy still falls backwards at its end, and, far
  // from the solution, while it increases the gradient. Each trial starts from the triangulation of before the step.
  Similarity_map_status step(const Ideal_delaunay_flips&)
  {
    m_accepted_coefficients = m_coefficients;
    const Structure accepted = m_structure;
    const double slope_before = slope(), norm_before = m_system.gradient_norm();
    const double residual_before = static_cast<double>(m_system.residual());
    const std::size_t most_flips = 1000 + 4 * static_cast<std::size_t>(m_structure.mesh.number_of_edges());
    constexpr double flat = 1e-3; // a slope, by the one before, that is too small to tell that a step went too far
    double length = std::min(1., 2 * m_step_length);
    for (; length > shortest_step; length /= 2, ++m_record.halvings) {
      set_trial(length);
      const std::size_t flips = flip_and_measure(most_flips);
      if (flips <= most_flips && m_system.has_triangles_only()) {
        m_system.evaluate_gradient(m_structure);
        const double residual = static_cast<double>(m_system.residual());
        const double slope_after = slope();
        const bool overshoots = slope_after > flat * std::abs(slope_before) && !(residual <= residual_before / 2);
        const bool grows = norm_before > 1 && m_system.gradient_norm() > norm_before;
        if (residual <= m_limits.tolerance || (std::isfinite(residual) && !overshoots && !grows)) {
          m_step_length = length;
          m_record.flips += flips;
          return Similarity_map_status::CONVERGED;
        }
      }
      m_structure = accepted;
      if (!m_progress.go_on())
        return Similarity_map_status::INTERRUPTED;
    }
    m_coefficients = m_accepted_coefficients;
    m_system.evaluate(m_structure, m_progress);
    return Similarity_map_status::STALLED;
  }

  // Makes the trial Delaunay. The angles that tell which edges need a flip serve for the gradient too; only those of
  // flipped triangles are measured again.
  std::size_t flip_and_measure(const std::size_t most_flips)
  {
    // A trial beyond the limit of what the mesh can carry winds the loops up without end.
    const std::size_t most_passages = 1000 + 10 * m_structure.loops.number_of_passages();
    m_flipped.clear();
    if (!m_system.measure(m_structure, m_progress))
      return most_flips + 1;
    const std::size_t flips = flip_to_delaunay(
        m_structure, most_flips, [this](const Index e) { return m_system.is_clearly_delaunay(m_structure, e); },
        [this, most_passages](const Index h) {
          m_structure.flip_ptolemy(h);
          m_flipped.push_back(h);
          return m_structure.loops.number_of_passages() <= most_passages && m_progress.go_on_after(10);
        });
    if (flips <= most_flips)
      for (const Index h : m_flipped) {
        m_system.measure(m_structure, m_structure.mesh.face(h));
        m_system.measure(m_structure, m_structure.mesh.face(opposite(h)));
      }
    return flips;
  }

  // [CZ17] section 7.3: a step to the first degeneracy, and flips there.
  Similarity_map_status step(const Degeneracy_flips& policy)
  {
    m_accepted_coefficients = m_coefficients;
    const std::vector<FT> form = m_structure.form;
    set_trial(1.);
    std::vector<double> change(form.size());
    for (std::size_t e = 0; e < form.size(); ++e)
      change[e] = static_cast<double>(FT(m_structure.form[e] - form[e]));
    m_structure.form = form;
    const First_degeneracy<FT> degeneracy(m_structure, change);
    set_trial(degeneracy.time);
    m_flipped.clear();
    for (const Index h : degeneracy.triangles)
      if (m_structure.mesh.face(h) != m_structure.mesh.face(opposite(h)) && !flipped_already(h)) {
        m_structure.part(h);
        m_structure.flip_euclidean(h);
        ++m_record.flips;
      }
    if (policy.delaunay) {
      const std::size_t most_flips = 1000 + 20 * static_cast<std::size_t>(m_structure.mesh.number_of_edges());
      const std::size_t flips = flip_all_to_delaunay(
          m_structure, most_flips, [&](const Index h) { m_structure.flip_euclidean(h); }, m_progress);
      m_record.flips += flips;
      if (flips > most_flips)
        return Similarity_map_status::STALLED;
    }
    m_blocked_steps = degeneracy.time < shortest_step ? m_blocked_steps + 1 : 0;
    m_system.evaluate(m_structure, m_progress);
    return m_blocked_steps > 20 ? Similarity_map_status::STALLED : Similarity_map_status::CONVERGED;
  }

  // Two degenerate triangles may share their longest edge.
  bool flipped_already(const Index h)
  {
    const auto is_same_edge = [h](const Index g) { return edge_of(g) == edge_of(h); };
    if (std::find_if(m_flipped.begin(), m_flipped.end(), is_same_edge) != m_flipped.end())
      return true;
    m_flipped.push_back(h);
    return false;
  }

  Structure& m_structure;
  Newton_system<FT>& m_system;
  std::vector<FT>& m_coefficients;
  SolverTraits& m_solver;
  bool m_is_factorized;
  Progress& m_progress;
  Newton_limits m_limits;
  Newton_record m_record;

  static constexpr double shortest_step = 1e-12; // a shorter one is lost in the round-off of the coefficients

  std::vector<double> m_solution;  // by rows
  std::vector<double> m_direction; // by unknowns
  std::vector<FT> m_accepted_coefficients;
  double m_step_length = 1;
  int m_last_inner_iterations = 0;
  int m_blocked_steps = 0;
  std::vector<Index> m_flipped; // halfedges
  Conjugate_gradients_workspace<double> m_workspace;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_NEWTON_ITERATION_H
