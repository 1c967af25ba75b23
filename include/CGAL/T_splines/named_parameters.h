// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_NAMED_PARAMETERS_H
#define CGAL_T_SPLINES_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace T_splines {

/// Tags of the named parameters that this package adds to CGAL's list.
namespace np_tags {

#define CGAL_T_SPLINES_NAMED_PARAMETER(NAME) enum NAME##_t{NAME};
#include <CGAL/T_splines/internal/named_parameters_list.h>
#undef CGAL_T_SPLINES_NAMED_PARAMETER

} // namespace np_tags

/// The named parameters that this package adds to CGAL's list. Each function has two forms: `f(value)` starts a
/// sequence, `f(value, np)` puts the parameter in front of the sequence `np`, as in
/// `parameters::residual_tolerance(1e-10, CGAL::parameters::vertex_point_map(vpm))`.
namespace parameters {

#define CGAL_T_SPLINES_NAMED_PARAMETER(NAME)                                                                           \
  template <typename K>                                                                                                \
  CGAL::Named_function_parameters<K, np_tags::NAME##_t> NAME(const K& value)                                           \
  {                                                                                                                    \
    return CGAL::Named_function_parameters<K, np_tags::NAME##_t>(value);                                               \
  }                                                                                                                    \
  template <typename K, typename T, typename Tag, typename Base>                                                       \
  CGAL::Named_function_parameters<K, np_tags::NAME##_t, CGAL::Named_function_parameters<T, Tag, Base>> NAME(           \
      const K& value, const CGAL::Named_function_parameters<T, Tag, Base>& np)                                         \
  {                                                                                                                    \
    return CGAL::Named_function_parameters<K, np_tags::NAME##_t, CGAL::Named_function_parameters<T, Tag, Base>>(value, \
                                                                                                                np);   \
  }
#include <CGAL/T_splines/internal/named_parameters_list.h>
#undef CGAL_T_SPLINES_NAMED_PARAMETER

} // namespace parameters

namespace internal {

/// Whether the type of `get_parameter(np, tag)` tells that the parameter was not given.
template <typename Parameter>
inline constexpr bool is_missing =
    std::is_same<std::remove_cv_t<std::remove_reference_t<Parameter>>, CGAL::internal_np::Param_not_found>::value;

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_NAMED_PARAMETERS_H
