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

// Numbers of elements, in linear time: counted from 0, in the order in which the graph lists them.
template <typename FaceGraph>
std::string vertex_in_words(const typename boost::graph_traits<FaceGraph>::vertex_descriptor v, const FaceGraph& graph)
{
  return "vertex " + std::to_string(number_in_range(v, CGAL::make_range(vertices(graph))));
}

template <typename FaceGraph>
std::string face_in_words(const typename boost::graph_traits<FaceGraph>::face_descriptor f, const FaceGraph& graph)
{
  return "face " + std::to_string(number_in_range(f, CGAL::make_range(faces(graph))));
}

template <typename FaceGraph>
std::string edge_in_words(const typename boost::graph_traits<FaceGraph>::halfedge_descriptor h, const FaceGraph& graph)
{
  return "edge from " + vertex_in_words<FaceGraph>(source(h, graph), graph) + " to " +
         vertex_in_words<FaceGraph>(target(h, graph), graph);
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
