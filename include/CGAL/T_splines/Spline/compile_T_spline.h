// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_COMPILE_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_COMPILE_T_SPLINE_H

#include <CGAL/T_splines/Spline/Compiled_T_spline.h>
#include <CGAL/T_splines/Spline/internal/T_spline_compiler.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <type_traits>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// compiles a T-spline surface into rational bicubic Bezier patches.
/// \tparam Surface a `T_spline_surface`
/// \param surface \pre `surface.is_valid()`
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_rings}
///     \cgalParamDescription{how many rings of patches lie around an extraordinary vertex, outside of the caps; at
///       least 1}
///     \cgalParamType{`int`}
///     \cgalParamDefault{4}
///     \cgalParamExtra{The deviation of the caps falls by a factor of 2.4 (valence 3) to 1.5 (high valences) with each,
///       as the subdominant eigenvalue of the subdivision tells.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the patches; they do not depend on `surface` any more, but on its T-mesh. If the visitor stopped the work, none:
/// `status()` tells.
/// Complexity: linear in the number of pairs of a basis function and a patch where it acts.
template <typename Surface, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Compiled_T_spline<typename Surface::Graph, typename Surface::Kernel>
compile_T_spline(const Surface& surface, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  CGAL_precondition_msg(surface.is_valid(), "the surface is not valid: see report()");
  const int number_of_rings = choose_parameter(get_parameter(np, np_tags::number_of_rings), 4);
  CGAL_precondition_msg(number_of_rings >= 1, "number_of_rings must be positive");
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("compilation");
  return internal::T_spline_compiler<Surface>(surface).compile(number_of_rings, progress);
}

namespace internal {

/// The compiled surface, or the surface itself if it is one: a reference then. Without patches, if `progress` is
/// interrupted.
template <typename Surface>
decltype(auto) as_compiled(const Surface& surface, [[maybe_unused]] Progress& progress)
{
  using Compiled = Compiled_T_spline<typename Surface::Graph, typename Surface::Kernel>;
  if constexpr (std::is_same<Surface, Compiled>::value)
    return (surface);
  else
    return compile_T_spline(surface, CGAL::parameters::visitor(Part_visitor(progress)));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_COMPILE_T_SPLINE_H
