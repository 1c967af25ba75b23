// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_CHOSEN_SPD_SOLVER_TRAITS_H
#define MESH_TO_T_SPLINE_CHOSEN_SPD_SOLVER_TRAITS_H

#include "Options.h"

#include <CGAL/T_splines/Solver/Cholmod_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>
#include <CGAL/T_splines/Solver/Symmetric_sparse_matrix.h>

#include <functional>
#include <variant>
#include <vector>

#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
constexpr bool is_cholmod_available = true;
#else
constexpr bool is_cholmod_available = false;
#endif

/// A model of `SparseSpdSolverTraits` that is chosen at run time.
class Chosen_spd_solver_traits {
public:
  using FT = double;
  using Matrix = CGAL::T_splines::Symmetric_sparse_matrix<FT>;

  /// \pre `choice` is available.
  explicit Chosen_spd_solver_traits([[maybe_unused]] const Solver_choice choice)
  {
#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
    if (choice == Solver_choice::CHOLMOD)
      m_solver.emplace<CGAL::T_splines::Cholmod_spd_solver_traits>();
#endif
  }

  bool analyze_pattern(const Matrix& a)
  {
    return std::visit([&a](auto& solver) { return solver.analyze_pattern(a); }, m_solver);
  }
  /// \param go_on is asked by the solver that can be interrupted
  bool factorize(const Matrix& a, const std::function<bool()>& go_on = nullptr)
  {
#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
    if (auto* const cholmod = std::get_if<CGAL::T_splines::Cholmod_spd_solver_traits>(&m_solver))
      return cholmod->factorize(a);
#endif
    return std::get<CGAL::T_splines::Eigen_spd_solver_traits<>>(m_solver).factorize(a, go_on);
  }
  bool solve(const std::vector<FT>& b, std::vector<FT>& x) const
  {
    return std::visit([&b, &x](const auto& solver) { return solver.solve(b, x); }, m_solver);
  }

private:
#ifdef CGAL_T_SPLINES_WITH_CHOLMOD
  std::variant<CGAL::T_splines::Eigen_spd_solver_traits<>, CGAL::T_splines::Cholmod_spd_solver_traits> m_solver;
#else
  std::variant<CGAL::T_splines::Eigen_spd_solver_traits<>> m_solver;
#endif
};

#endif // MESH_TO_T_SPLINE_CHOSEN_SPD_SOLVER_TRAITS_H
