// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_TOLERANCES_H
#define CGAL_T_SPLINES_INTERNAL_TOLERANCES_H

#include <CGAL/T_splines/defaults.h>
#include <CGAL/T_splines/internal/exactness.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace T_splines {
namespace internal {

// The tolerances that more than one header uses; the page "Tolerances" of the manual has them in a table. One that a
// single header uses stands there, with a name and its reason.

/// Knots on one side whose distance is not larger, by the side, are one: sums of knots are off by some 1e-14, and no
/// operation makes an interval that is so short.
inline constexpr double same_knot = 1e-11;

/// What round-off may come to over many faces, by the interval, side or face concerned. It tells apart what is equal
/// or differs by a large part: uniform intervals from others, an overlap of faces from a contact.
inline constexpr double summed_round_off = 1e-6;

/// Two ways around a surface lead to the same image of a triangle or face, or to one that does not overlap it: they are
/// the same if they differ by no more than this, by their size. Any number between round-off and 1 would do.
inline constexpr double same_image = 1e-3;

/// A difference of uv coordinates that is larger, by the edge or triangle there, is not taken for rounding, however few
/// digits the coordinates have.
inline constexpr double largest_rounding = 1e-3;

/// An angle of a map may be off by what rounding of its coordinates explains, but by no more than this, in radians: next
/// to very short edges rounding would explain everything.
inline constexpr double largest_uncertainty = 0.05;

/// How far a number of quarter turns may be from an integer: files have six digits, and their sums are off by less.
inline constexpr double same_number_of_turns = 1e-6;

/// Numbers of quarter turns that are larger, in a file, are mistakes; sums of others fit into an `int`.
inline constexpr double largest_number_of_turns = 1e6;

/// Two points are one, by the longest side of the triangle that they lie on: some digits above the round-off of a foot.
inline constexpr double same_point = 1e-9;

/// Two tangents are parallel if the square of the sine of their angle is not larger: a step along them would have no
/// correct digits.
inline constexpr double parallel_tangents = 1e-12;

/// The distance on a side of length `size` up to which knots are one.
template <typename FT>
FT knot_tolerance(const FT& size)
{
  if constexpr (is_exact_number_type<FT>)
    return FT(0);
  else
    return size * FT(same_knot);
}

/// The same for knots of another face, which are off by more: they are sums that were scaled.
template <typename FT>
FT knot_tolerance_between_faces(const FT& size)
{
  return knot_tolerance(size) * FT(100);
}

/// Whether the units of a face are the same after a way around the surface.
template <typename FT>
bool is_same_unit(const FT& scale)
{
  if constexpr (is_exact_number_type<FT>)
    return scale == FT(1);
  else
    return CGAL::abs(FT(scale - FT(1))) <= FT(default_relative_tolerance);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_TOLERANCES_H
