// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_GRAPH_CHECKS_H
#define CGAL_T_SPLINES_INTERNAL_GRAPH_CHECKS_H

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <unordered_set>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether a graph can be an output: nothing is in it, not even removed elements, among which new ones would be lined up
/// in another order than that of the input.
template <typename Graph>
bool is_output_graph(const Graph& graph)
{
  // These numbers count removed elements, the ranges do not.
  return num_vertices(graph) == 0 && num_halfedges(graph) == 0 && num_faces(graph) == 0;
}

/// Some descriptors of which it is asked whether a graph has them: they may be of another graph, or of elements that
/// were removed, so that nothing but comparing them is safe.
/// \tparam Descriptor hashable and not null
template <typename Descriptor>
class Claimed_descriptors {
public:
  void insert(const Descriptor d) { m_unknown.insert(d); }

  /// strikes out what is in a range of elements. Complexity: linear, nothing if there is nothing to strike out.
  template <typename ElementRange>
  void find_in(const ElementRange& elements)
  {
    if (m_unknown.empty())
      return;
    for (const Descriptor d : elements)
      if (m_unknown.erase(d) > 0 && m_unknown.empty())
        return;
  }

  bool is_foreign(const Descriptor d) const { return !m_unknown.empty() && m_unknown.count(d) > 0; }

private:
  std::unordered_set<Descriptor> m_unknown;
};

/// The first element of a range whose face is null or not a face of the graph, or not any more, counted from 0; the number
/// of elements if there is none.
/// \param face_of element -> face
template <typename Graph, typename Range, typename FaceOf>
std::size_t first_foreign_face(const Graph& graph, const Range& range, const FaceOf& face_of)
{
  using Face = typename boost::graph_traits<Graph>::face_descriptor;
  const Face null = boost::graph_traits<Graph>::null_face();
  Claimed_descriptors<Face> claimed;
  Face last = null; // neighbours in the range often have the same face
  for (const auto& element : range) {
    const Face f = face_of(element);
    if (f != null && f != last)
      claimed.insert(f);
    last = f;
  }
  claimed.find_in(CGAL::make_range(faces(graph)));
  std::size_t i = 0;
  for (const auto& element : range) {
    const Face f = face_of(element);
    if (f == null || claimed.is_foreign(f))
      break;
    ++i;
  }
  return i;
}

/// Whether there is a map, and every face of a T-mesh has an anchor on the mapped mesh.
template <typename Map, typename Graph, typename FaceAnchorMap>
bool are_anchored(const Map& map, const Graph& graph, const FaceAnchorMap& anchors)
{
  const auto range = CGAL::make_range(faces(graph));
  return map.layout().mesh().number_of_faces() > 0 &&
         first_foreign_face(map.mesh(), range, [&](const auto f) { return get(anchors, f).triangle; }) ==
             static_cast<std::size_t>(std::distance(range.begin(), range.end()));
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_GRAPH_CHECKS_H
