// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_ELEMENT_NUMBERS_H
#define CGAL_T_SPLINES_INTERNAL_ELEMENT_NUMBERS_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename Descriptor, typename Range>
std::size_t number_in_range(const Descriptor d, const Range& range)
{
  std::size_t number = 0;
  for (const auto e : range) {
    if (e == d)
      break;
    ++number;
  }
  return number;
}

// For messages: ": vertex 5, face 7, counted from 0", of those elements that are not null. Linear time.
template <typename FaceGraph>
std::string numbered_elements(const FaceGraph& graph,
                              const typename boost::graph_traits<FaceGraph>::vertex_descriptor v,
                              const typename boost::graph_traits<FaceGraph>::face_descriptor f)
{
  std::string text;
  if (v != boost::graph_traits<FaceGraph>::null_vertex())
    text += "vertex " + std::to_string(number_in_range(v, CGAL::make_range(vertices(graph)))) + ", ";
  if (f != boost::graph_traits<FaceGraph>::null_face())
    text += "face " + std::to_string(number_in_range(f, CGAL::make_range(faces(graph)))) + ", ";
  return text.empty() ? text : ": " + text + "counted from 0";
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_ELEMENT_NUMBERS_H
