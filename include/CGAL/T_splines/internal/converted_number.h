// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_CONVERTED_NUMBER_H
#define CGAL_T_SPLINES_INTERNAL_CONVERTED_NUMBER_H

#include <CGAL/number_type_basic.h>

#include <type_traits>

namespace CGAL {
namespace T_splines {
namespace internal {

// A number of another type; exact ones are rounded where they must be.
template <typename To, typename From>
To converted_number(const From& x)
{
  if constexpr (std::is_same<To, From>::value)
    return x;
  else if constexpr (std::is_convertible<From, To>::value)
    return To(x);
  else
    return To(CGAL::to_double(x));
}

// A point or vector of any kernel, with double coordinates.
template <typename To, typename From>
To in_doubles(const From& p)
{
  return To(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_CONVERTED_NUMBER_H
