// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_FACE_IS_DATA_H
#define CGAL_T_SPLINES_INTERNAL_FACE_IS_DATA_H

#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The named parameter that says which faces of a mesh are data, and do not only close holes: all, unless it is given.
template <typename FaceGraph, typename NamedParameters>
auto face_is_data_map(const NamedParameters& np)
{
  using All = CGAL::Static_boolean_property_map<typename boost::graph_traits<FaceGraph>::face_descriptor, true>;
  return CGAL::parameters::choose_parameter<All>(CGAL::parameters::get_parameter(np, np_tags::face_is_data_map));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_FACE_IS_DATA_H
