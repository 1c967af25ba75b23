// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PROJECTED_NEWTON_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PROJECTED_NEWTON_H

#include <CGAL/T_splines/Similarity_map/internal/Alignment_energy.h>
#include <CGAL/T_splines/Similarity_map/internal/Linear_parameters.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>
#include <CGAL/T_splines/Solver/preconditioned_conjugate_gradients.h>
#include <CGAL/T_splines/Solver/support/Interruptible_preconditioner.h>
#include <CGAL/T_splines/Solver/support/factorize.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The Hessian of an alignment energy by the parameters: its pattern is found once.
class Alignment_hessian {
public:
  Alignment_hessian(const Alignment_energy& energy, const Linear_parameters& space) : m_energy(energy), m_space(space)
  {
    std::vector<std::vector<int>> rows(space.number_of_parameters()); // of the columns of the lower triangle
    for (int j = 0; j < space.number_of_parameters(); ++j)
      rows[j].push_back(j);
    for (int f = 0; f < energy.number_of_triangles(); ++f)
      add_pattern(parameters_of(energy.unknowns(f)), rows);
    energy.for_each_penalty(
        [&](const Linear_parameters::Row& row, double) { add_pattern(parameters_of(unknowns_of(row)), rows); });
    for (std::vector<int>& column : rows) {
      std::sort(column.begin(), column.end());
      column.erase(std::unique(column.begin(), column.end()), column.end());
      m_matrix.row.insert(m_matrix.row.end(), column.begin(), column.end());
      m_matrix.column_begin.push_back(static_cast<int>(m_matrix.row.size()));
    }
    m_matrix.value.assign(m_matrix.row.size(), 0.);
  }

  const Symmetric_sparse_matrix<double>& matrix() const { return m_matrix; }

  /// Computes the matrix, and the derivatives by the unknowns, at x.
  void compute(const std::vector<double>& x, std::vector<double>& gradient)
  {
    std::fill(m_matrix.value.begin(), m_matrix.value.end(), 0.);
    gradient.assign(m_space.number_of_unknowns(), 0.);
    std::array<double, 6> first;
    std::array<std::array<double, 6>, 6> second;
    for (int f = 0; f < m_energy.number_of_triangles(); ++f) {
      m_energy.derivatives(f, x, first, second);
      const std::array<int, 6> unknown = m_energy.unknowns(f);
      for (int i = 0; i < 6; ++i) {
        gradient[unknown[i]] += first[i];
        for (int j = 0; j < 6; ++j)
          add(unknown[i], unknown[j], second[i][j]);
      }
    }
    m_energy.for_each_penalty([&](const Linear_parameters::Row& row, const double weight) {
      const double r = Alignment_energy::value(row, x);
      for (const auto& [i, c] : row) {
        gradient[i] += 2 * weight * r * c;
        for (const auto& [j, d] : row)
          add(i, j, 2 * weight * c * d);
      }
    });
    shift_diagonal();
  }

private:
  static std::vector<int> unknowns_of(const Linear_parameters::Row& row)
  {
    std::vector<int> result;
    for (const auto& entry : row)
      result.push_back(entry.first);
    return result;
  }

  template <typename Unknowns>
  std::vector<int> parameters_of(const Unknowns& unknowns) const
  {
    std::vector<int> result;
    for (const int unknown : unknowns)
      m_space.for_each_term(unknown, [&](const Linear_parameters::Term& term) { result.push_back(term.parameter); });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  static void add_pattern(const std::vector<int>& parameters, std::vector<std::vector<int>>& rows)
  {
    for (std::size_t i = 0; i < parameters.size(); ++i)
      rows[parameters[i]].insert(rows[parameters[i]].end(), parameters.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 parameters.end());
  }

  // Adds an entry of the Hessian by unknowns; of a symmetric pair each comes once.
  void add(const int i, const int j, const double value)
  {
    m_space.for_each_term(i, [&](const Linear_parameters::Term& row) {
      m_space.for_each_term(j, [&](const Linear_parameters::Term& column) {
        if (row.parameter >= column.parameter)
          entry(row.parameter, column.parameter) += value * row.coefficient * column.coefficient;
      });
    });
  }

  double& entry(const int row, const int column)
  {
    const auto begin = m_matrix.row.begin() + m_matrix.column_begin[column],
               end = m_matrix.row.begin() + m_matrix.column_begin[column + 1];
    return m_matrix.value[static_cast<std::size_t>(std::lower_bound(begin, end, row) - m_matrix.row.begin())];
  }

  // The map may be moved as a whole, and flat directions are bounded.
  void shift_diagonal()
  {
    constexpr double relative_shift = 1e-10; // far below what matters, far above round-off
    double trace = 0;
    for (int j = 0; j < m_matrix.size(); ++j)
      trace += m_matrix.value[m_matrix.column_begin[j]];
    for (int j = 0; j < m_matrix.size(); ++j)
      m_matrix.value[m_matrix.column_begin[j]] += relative_shift * trace / m_matrix.size();
  }

  const Alignment_energy& m_energy;
  const Linear_parameters& m_space;
  Symmetric_sparse_matrix<double> m_matrix;
};

/// How a minimization ended.
enum class Minimization_end {
  CONVERGED,
  STEP_LIMIT,    ///< after the largest number of steps
  NO_DESCENT,    ///< no step lowers the energy: round-off
  SOLVER_FAILED, ///< or interrupted
};

/// Minimizes an alignment energy by Newton's method with the Hessian's negative part left out, and without turning a
/// triangle over.
/// \tparam SolverTraits a model of `SparseSpdSolverTraits` for `double`
template <typename SolverTraits>
class Projected_newton {
public:
  /// The penalties of `energy` must have their rows already; their factors may change.
  Projected_newton(const Alignment_energy& energy, const Linear_parameters& space, SolverTraits& solver,
                   Progress& progress)
    : m_energy(energy),
      m_space(space),
      m_hessian(energy, space),
      m_solver(solver),
      m_progress(progress),
      m_is_ready(progress.go_on() && solver.analyze_pattern(m_hessian.matrix()))
  {
  }

  int number_of_steps() const { return m_number_of_steps; }

  /// says that the energy has changed so much that a factorization of before does not help.
  void forget_factorization() { m_is_factorized = false; }

  /// \param x unknowns in the space, without a triangle that is turned over; receives the minimum
  /// \param tolerance of the decrease that the next step promises, by the energy
  Minimization_end minimize(std::vector<double>& x, const double tolerance, const int most_steps)
  {
    std::vector<double> gradient, z, y;
    double energy = m_energy.value(x);
    for (int step = 0; step < most_steps; ++step) {
      if (!m_is_ready || !m_progress.go_on())
        return Minimization_end::SOLVER_FAILED;
      m_hessian.compute(x, gradient);
      std::vector<double> right = m_space.derivatives(gradient);
      for (double& r : right)
        r = -r;
      if (!solve(right, z))
        return Minimization_end::SOLVER_FAILED;
      ++m_number_of_steps;
      double slope = 0;
      for (std::size_t i = 0; i < z.size(); ++i)
        slope -= right[i] * z[i];
      if (-slope <= tolerance * energy)
        return Minimization_end::CONVERGED;
      if (!move(x, m_space.unknowns(z), slope, energy, y))
        return Minimization_end::NO_DESCENT;
    }
    return Minimization_end::STEP_LIMIT;
  }

  /// Replaces x by the point of the space that is nearest to it in the metric of the Hessian there: an orthogonal projection
  /// turns thin triangles over.
  bool project(std::vector<double>& x)
  {
    if (!m_is_ready)
      return false;
    std::vector<double> gradient, z, difference(x.size()), product;
    const std::vector<double> start = m_space.unknowns(m_space.parameters(x));
    m_hessian.compute(x, gradient);
    for (std::size_t i = 0; i < x.size(); ++i)
      difference[i] = x[i] - start[i];
    multiply(x, difference, product);
    if (!solve_exactly(m_space.derivatives(product), z))
      return false;
    x = m_space.unknowns(z);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += start[i];
    return true;
  }

private:
  bool solve_exactly(const std::vector<double>& right, std::vector<double>& z)
  {
    m_is_factorized = factorize(m_solver, m_hessian.matrix(), m_progress);
    return m_is_factorized && m_solver.solve(right, z);
  }

  // Solves for the step: by conjugate gradients with the last factorization, as long as that is near enough.
  bool solve(const std::vector<double>& right, std::vector<double>& z)
  {
    constexpr int most_iterations = 20; // together they take less time than a factorization
    constexpr double enough = 1e-4;     // of the right-hand side: penalties are stiff
    if (m_is_factorized) {
      const int iterations = preconditioned_conjugate_gradients(
          m_hessian.matrix(), Interruptible_preconditioner<SolverTraits>(m_solver, m_progress), right, z, enough,
          most_iterations + 1, m_workspace);
      if (iterations <= most_iterations)
        return !m_progress.is_interrupted();
    }
    return solve_exactly(right, z);
  }

  // Makes the longest step that keeps nine tenths of the way to the first degenerate triangle, and lowers the energy.
  bool move(std::vector<double>& x, const std::vector<double>& d, const double slope, double& energy,
            std::vector<double>& y)
  {
    constexpr double part_of_way = 0.9, enough = 1e-4;
    constexpr int most_halvings = 40;
    double t = (std::min)(1., part_of_way * m_energy.first_degeneracy(x, d));
    y.resize(x.size());
    for (int i = 0; i < most_halvings; ++i, t /= 2) {
      for (std::size_t j = 0; j < x.size(); ++j)
        y[j] = x[j] + t * d[j];
      const double there = m_energy.value(y);
      if (there <= energy + enough * t * slope) {
        std::swap(x, y);
        energy = there;
        return true;
      }
    }
    return false;
  }

  // The product of the Hessian by unknowns, without penalties, and a vector.
  void multiply(const std::vector<double>& x, const std::vector<double>& v, std::vector<double>& product) const
  {
    std::array<double, 6> first;
    std::array<std::array<double, 6>, 6> second;
    product.assign(v.size(), 0.);
    for (int f = 0; f < m_energy.number_of_triangles(); ++f) {
      m_energy.derivatives(f, x, first, second);
      const std::array<int, 6> unknown = m_energy.unknowns(f);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          product[unknown[i]] += second[i][j] * v[unknown[j]];
    }
  }

  const Alignment_energy& m_energy;
  const Linear_parameters& m_space;
  Alignment_hessian m_hessian;
  SolverTraits& m_solver;
  Progress& m_progress;
  bool m_is_ready, m_is_factorized = false;
  Conjugate_gradients_workspace<double> m_workspace;
  int m_number_of_steps = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_PROJECTED_NEWTON_H
