// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_CARRIED_ANCHORS_H
#define CGAL_T_SPLINES_T_MESH_CARRIED_ANCHORS_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/move_place.h>
#include <CGAL/T_splines/internal/converted_similarity.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <memory>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// What holds a T-mesh to the surface while operations change it: of each component one point of a face, whose place
/// on the surface is known.
///
/// A model of `TMeshObserver`: give it to the operations, and afterwards to `place_T_mesh()`. Copies share their state.
///
/// \cgalModels{TMeshObserver}
///
/// \tparam TriangleMesh the mapped mesh
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeGraph`
/// \tparam FT the number type of the map
template <typename TriangleMesh, typename Graph, typename FT>
class Carried_anchors : public T_mesh_observer {
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

public:
  /// A point of a face, held to the surface.
  struct Root {
    T_mesh_place<Graph, FT> place;          ///< of the point in the T-mesh
    T_mesh_anchor<TriangleMesh, FT> anchor; ///< its triangle's closure contains the place
  };

  /// chooses the points.
  /// \param graph the graph of the T-mesh
  /// \param anchors face -> `T_mesh_anchor<TriangleMesh, FT>`, as `trace_motorcycle_graph()` gives them
  template <typename FaceAnchorMap>
  Carried_anchors(const Graph& graph, const FaceAnchorMap anchors) : m_roots(std::make_shared<std::vector<Root>>())
  {
    std::vector<face_descriptor> stack;
    const auto is_reached = get(CGAL::dynamic_face_property_t<bool>(), graph);
    for (const face_descriptor f : CGAL::make_range(faces(graph)))
      put(is_reached, f, false);
    for (const face_descriptor first : CGAL::make_range(faces(graph))) {
      if (get(is_reached, first))
        continue;
      m_roots->push_back({{first, FT(0), FT(0)}, get(anchors, first)});
      put(is_reached, first, true);
      stack.push_back(first);
      while (!stack.empty()) {
        const face_descriptor f = stack.back();
        stack.pop_back();
        for (const auto h : CGAL::halfedges_around_face(halfedge(f, graph), graph)) {
          const face_descriptor g = face(opposite(h, graph), graph);
          if (g == boost::graph_traits<Graph>::null_face() || get(is_reached, g))
            continue;
          put(is_reached, g, true);
          stack.push_back(g);
        }
      }
    }
  }

  /// returns the points by which the T-mesh is held, one for each component.
  const std::vector<Root>& roots() const { return *m_roots; }

  /// takes the points to the new faces.
  template <typename KnotFT>
  void faces_replaced(const std::vector<T_mesh_piece<Graph, KnotFT>>& pieces) const
  {
    for (Root& root : *m_roots)
      if (const T_mesh_piece<Graph, KnotFT>* piece = move_place(root.place, pieces))
        root.anchor.to_face = compose(internal::converted_similarity<FT>(piece->transition), root.anchor.to_face);
  }

private:
  std::shared_ptr<std::vector<Root>> m_roots;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_CARRIED_ANCHORS_H
