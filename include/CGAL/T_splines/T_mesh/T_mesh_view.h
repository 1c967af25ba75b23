// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_T_MESH_VIEW_H
#define CGAL_T_SPLINES_T_MESH_T_MESH_VIEW_H

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace T_splines {
namespace internal {

template <typename T, typename = void>
constexpr bool is_t_mesh = false;

template <typename T>
constexpr bool is_t_mesh<T, std::void_t<typename T::Graph, typename T::Knot_map, typename T::Corner_map>> = true;

// The map of the creases of a model of `TMesh`; one that is always false if it has none.
template <typename T, typename = void>
struct Crease_map {
  using Edge = typename boost::graph_traits<typename T::Graph>::edge_descriptor;
  using type = CGAL::Static_boolean_property_map<Edge, false>;
  static type of(const T&) { return {}; }
};

template <typename T>
struct Crease_map<T, std::void_t<typename T::Crease_map>> {
  using type = typename T::Crease_map;
  static type of(const T& t_mesh) { return t_mesh.creases(); }
};

// What `graph()` returns of T, T& or const T&.
template <typename T>
using Graph_reference = decltype(std::declval<std::remove_reference_t<T>&>().graph());

} // namespace internal

/// \ingroup PkgTSplinesTMesh
/// A T-mesh with halfedge knots whose parts lie elsewhere: a graph, the property map of its knots, that of its corners
/// and, if there is one, that of its creases. A model of `TMesh` that refers to all of them; a copy refers to
/// the same ones.
///
/// \cgalModels{TMesh}
///
/// \tparam Graph_ a model of `HalfedgeGraph` and `FaceGraph`, `const` if it is not to be changed; it may be non-simple
/// \tparam KnotMap a readable map, halfedge -> the knot interval of the halfedge in the units of its face; it is not
///         read at border halfedges. To change the T-mesh it must be writable, also at halfedges that the graph has just
///         added
/// \tparam CornerMap the same with `bool`: whether the face of the halfedge turns, by a right angle, at its target
/// \tparam CreaseMap a map, edge -> whether it is a crease of the surface; readable, and writable as the others are
template <typename Graph_, typename KnotMap, typename CornerMap,
          typename CreaseMap = CGAL::Static_boolean_property_map<
              typename boost::graph_traits<std::remove_const_t<Graph_>>::edge_descriptor, false>>
class T_mesh_view {
public:
  using Graph = std::remove_const_t<Graph_>;                       ///< the T-mesh's graph
  using Knot_map = KnotMap;                                        ///< halfedge -> knot interval
  using Corner_map = CornerMap;                                    ///< halfedge -> whether the face turns at its target
  using Crease_map = CreaseMap;                                    ///< edge -> whether it is a crease
  using FT = typename boost::property_traits<KnotMap>::value_type; ///< of the knots
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;     ///< a vertex of the graph
  using halfedge_descriptor = typename boost::graph_traits<Graph>::halfedge_descriptor; ///< a halfedge of the graph
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;         ///< a face of the graph

  /// refers to a graph and its maps.
  T_mesh_view(Graph_& graph, const KnotMap knots, const CornerMap corners, const CreaseMap creases = CreaseMap())
    : m_graph(&graph),
      m_knots(knots),
      m_corners(corners),
      m_creases(creases)
  {
  }

  /// of another model of `TMesh` with the same types.
  template <typename TMesh,
            typename = std::enable_if_t<internal::is_t_mesh<std::decay_t<TMesh>> &&
                                        !std::is_same<std::decay_t<TMesh>, T_mesh_view>::value &&
                                        std::is_convertible<internal::Graph_reference<TMesh>, Graph_&>::value>>
  T_mesh_view(TMesh&& t_mesh)
    : T_mesh_view(t_mesh.graph(), t_mesh.knots(), t_mesh.corners(),
                  internal::Crease_map<std::decay_t<TMesh>>::of(t_mesh))
  {
  }

  /// returns the graph of the T-mesh.
  Graph_& graph() const { return *m_graph; }
  /// returns the knot intervals.
  const KnotMap& knots() const { return m_knots; }
  /// returns where the faces have their corners.
  const CornerMap& corners() const { return m_corners; }
  /// returns which edges are creases.
  const CreaseMap& creases() const { return m_creases; }

  /// returns the knot interval of `h`.
  decltype(auto) knot(const halfedge_descriptor h) const { return get(m_knots, h); }
  /// returns whether the face of `h` turns at the target of `h`.
  bool is_corner(const halfedge_descriptor h) const { return get(m_corners, h); }
  /// sets the knot interval of `h`.
  void set_knot(const halfedge_descriptor h, const FT& knot) const { put(m_knots, h, knot); }
  /// sets whether the face of `h` turns at the target of `h`.
  void set_corner(const halfedge_descriptor h, const bool is_corner) const { put(m_corners, h, is_corner); }

  /// whether the T-mesh has a map of creases.
  static constexpr bool has_creases = !std::is_same<
      CreaseMap, CGAL::Static_boolean_property_map<typename boost::graph_traits<Graph>::edge_descriptor, false>>::value;

  /// returns whether the edge of `h` is a crease.
  bool is_crease(const halfedge_descriptor h) const
  {
    if constexpr (has_creases)
      return get(m_creases, edge(h, *m_graph));
    else
      return false;
  }
  /// sets whether the edge of `h` is a crease, if there is a map of them.
  void set_crease(const halfedge_descriptor h, const bool is_crease) const
  {
    if constexpr (has_creases)
      put(m_creases, edge(h, *m_graph), is_crease);
  }

private:
  static_assert(std::is_same<typename boost::property_traits<KnotMap>::key_type, halfedge_descriptor>::value &&
                    std::is_same<typename boost::property_traits<CornerMap>::key_type, halfedge_descriptor>::value,
                "knots and corners are property maps of the halfedges of the graph");
  static_assert(std::is_same<typename boost::property_traits<CornerMap>::value_type, bool>::value &&
                    !std::is_same<FT, bool>::value,
                "the map of the knots comes first, then that of the corners, whose values are bool");

  Graph_* m_graph;
  KnotMap m_knots;
  CornerMap m_corners;
  CreaseMap m_creases;
};

/// \ingroup PkgTSplinesTMesh
/// The graph of a model of `TMesh`, or of a reference to one.
template <typename TMesh>
using T_mesh_graph = typename std::decay_t<TMesh>::Graph;

/// \ingroup PkgTSplinesTMesh
/// The view of a model of `TMesh`, or of a reference to one, by which its graph can be changed if it is not `const`.
template <typename TMesh>
using T_mesh_view_of =
    T_mesh_view<std::remove_reference_t<internal::Graph_reference<TMesh>>, typename std::decay_t<TMesh>::Knot_map,
                typename std::decay_t<TMesh>::Corner_map, typename internal::Crease_map<std::decay_t<TMesh>>::type>;

/// \ingroup PkgTSplinesTMesh
/// The view of a model of `TMesh` by which its graph cannot be changed.
template <typename TMesh>
using Const_T_mesh_view_of =
    T_mesh_view<const T_mesh_graph<TMesh>, typename std::decay_t<TMesh>::Knot_map,
                typename std::decay_t<TMesh>::Corner_map, typename internal::Crease_map<std::decay_t<TMesh>>::type>;

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_T_MESH_VIEW_H
