// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SOLVER_DEFAULT_SOLVER_H
#define CGAL_T_SPLINES_SOLVER_DEFAULT_SOLVER_H

#include <CGAL/T_splines/Solver/Eigen_spd_solver_traits.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSolver
/// The model of `SparseSpdSolverTraits` that is used when none is given: Eigen's `SimplicialLDLT`. Without Eigen, that
/// is without `CGAL_EIGEN3_ENABLED`, an incomplete type.
#ifdef CGAL_EIGEN3_ENABLED
using Default_spd_solver_traits = Eigen_spd_solver_traits<>;
#else
struct Default_spd_solver_traits;
#endif

namespace internal {

/// returns the solver of the named parameter `sparse_linear_solver`, to be received by `auto&&`: a reference to the
/// caller's own solver if that was passed by `std::ref()`, otherwise a copy of what was passed; without the parameter, a
/// new `Default_spd_solver_traits`.
template <typename NamedParameters>
decltype(auto) sparse_linear_solver(const NamedParameters& np)
{
  using Parameter = decltype(CGAL::parameters::get_parameter_reference(np, internal_np::sparse_linear_solver));
  using Solver_traits = std::remove_cv_t<std::remove_reference_t<Parameter>>;
  if constexpr (std::is_same<Solver_traits, internal_np::Param_not_found>::value) {
#ifdef CGAL_EIGEN3_ENABLED
    return Default_spd_solver_traits();
#else
    static_assert(!std::is_same<Solver_traits, internal_np::Param_not_found>::value,
                  "pass the named parameter sparse_linear_solver, or define CGAL_EIGEN3_ENABLED");
#endif
  }
  else if constexpr (std::is_same<Parameter, Solver_traits&>::value)
    return CGAL::parameters::get_parameter_reference(np, internal_np::sparse_linear_solver);
  else {
    static_assert(std::is_copy_constructible<Solver_traits>::value,
                  "pass a solver that cannot be copied by std::ref()");
    return Solver_traits(CGAL::parameters::get_parameter_reference(np, internal_np::sparse_linear_solver));
  }
}

} // namespace internal

/// \ingroup PkgTSplinesSolver
/// The model of `SparseSpdSolverTraits` that the named parameters contain, or `Default_spd_solver_traits`.
template <typename NamedParameters>
using Solver_traits_from =
    std::remove_reference_t<decltype(internal::sparse_linear_solver(std::declval<const NamedParameters&>()))>;

/// \ingroup PkgTSplinesSolver
/// The model of `SparseSpdSolverTraits` that the template argument `SolverTraits` of a class stands for: itself, or
/// `Default_spd_solver_traits` for `CGAL::Default`.
template <typename SolverTraits>
using Solver_traits_or_default = typename Default::Get<SolverTraits, Default_spd_solver_traits>::type;

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SOLVER_DEFAULT_SOLVER_H
