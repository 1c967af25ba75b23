// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_APPROXIMATION_MAPPED_MESH_H
#define CGAL_T_SPLINES_APPROXIMATION_MAPPED_MESH_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/Seamless_map.h>
#include <CGAL/T_splines/internal/converted_similarity.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesApproximation
/// A seamless map with the mesh that it lives on, a refinement of a given mesh, and all that is known of both.
/// `compute_exact_map()` makes one. It can be moved but not copied: the map refers to its mesh.
/// \tparam TriangleMesh the given mesh, a model of `FaceGraph`
/// \tparam FT_ the number type of the exact map
template <typename TriangleMesh, typename FT_ = CGAL::Exact_rational>
class Mapped_mesh {
public:
  /// Number type of the exact map and of the knots.
  using FT = FT_;
  /// Kernel of the points, in doubles.
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  /// The refined mesh.
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  /// The exactly seamless map.
  using Map = Seamless_map<Mesh, FT>;
  /// A location on the given mesh.
  using Location = CGAL::Polygon_mesh_processing::Face_location<TriangleMesh, double>;
  /// Halfedge -> point in the plane.
  using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
  /// Halfedge -> transition.
  using Transition_map = Mesh::Property_map<Mesh::Halfedge_index, Similarity_2<double>>;
  /// Edge -> whether it is on the cut.
  using Cut_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  /// Edge -> whether it is to lie on an isoline.
  using Constrained_edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  /// Vertex -> location.
  using Location_map = Mesh::Property_map<Mesh::Vertex_index, Location>;

  /// is empty.
  Mapped_mesh() : m_parts(std::make_unique<Parts>()) {}

  /// The refined mesh: the vertices of the given one come first and in their order.
  Mesh& mesh() { return m_parts->mesh; }
  /// The refined mesh.
  const Mesh& mesh() const { return m_parts->mesh; }

  /// Halfedge -> coordinates of its target in the chart of its face.
  const UV_map& uv() const { return m_parts->uv; }
  /// Halfedge -> transition from the chart of its face to that of its opposite's face, the identity off the cut.
  const Transition_map& transitions() const { return m_parts->transitions; }
  /// Edge -> whether the charts on both sides differ.
  const Cut_map& cut() const { return m_parts->cut; }
  /// Edge -> whether it is to lie on an isoline of the exact map and to become a part of edges of the T-mesh, as sharp
  /// features are; none, unless somebody says so.
  const Constrained_edge_map& constrained_edges() const { return m_parts->constrained_edges; }
  /// Vertex -> its location on the given mesh.
  const Location_map& locations() const { return m_parts->locations; }

  /// returns the face of the given mesh that a face of the refined one lies in. Complexity: the number of faces around a
  /// vertex of the given mesh.
  /// \param f a face of the refined mesh
  /// \param given the given mesh
  typename boost::graph_traits<TriangleMesh>::face_descriptor origin(const Mesh::Face_index f,
                                                                     const TriangleMesh& given) const
  {
    std::vector<Given_vertex<TriangleMesh>> carriers;
    for (const auto v : CGAL::vertices_around_face(mesh().halfedge(f), mesh()))
      add_carriers(v, given, carriers);
    const auto is_corner = [&](const auto v, const auto face) {
      const auto corners = CGAL::vertices_around_face(halfedge(face, given), given);
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    };
    for (const auto h : CGAL::halfedges_around_target(halfedge(carriers.front(), given), given))
      if (!is_border(h, given) &&
          std::all_of(carriers.begin(), carriers.end(), [&](const auto v) { return is_corner(v, face(h, given)); }))
        return face(h, given);
    return boost::graph_traits<TriangleMesh>::null_face();
  }

  /// returns the halfedge of the given mesh on which a halfedge of the refined one lies, in the direction of its face's
  /// halfedges; null if it lies inside of a face. Complexity: as that of the face.
  /// \param h a halfedge of the refined mesh that is not on the border
  /// \param given the given mesh
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor origin(const Mesh::Halfedge_index h,
                                                                         const TriangleMesh& given) const
  {
    std::vector<Given_vertex<TriangleMesh>> carriers;
    for (const auto v : {mesh().source(h), mesh().target(h)})
      add_carriers(v, given, carriers);
    std::sort(carriers.begin(), carriers.end());
    carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
    if (carriers.size() == 2)
      for (const auto g : CGAL::halfedges_around_face(halfedge(origin(mesh().face(h), given), given), given))
        if (std::minmax(source(g, given), target(g, given)) == std::minmax(carriers[0], carriers[1]))
          return g;
    return boost::graph_traits<TriangleMesh>::null_halfedge();
  }

  /// returns which edges of the given mesh are constrained in the map, at least in part: edge -> `bool`. Complexity: linear
  /// but for the degrees of vertices. \pre `has_map()`
  /// \param given the given mesh
  auto constrained_origins(const TriangleMesh& given) const
  {
    const auto result = get(CGAL::dynamic_edge_property_t<bool>(), given);
    for (const auto e : CGAL::make_range(edges(given)))
      put(result, e, false);
    for (const auto h : mesh().halfedges())
      if (!mesh().is_border(h) && map().is_constrained(mesh().edge(h)))
        if (const auto from = origin(h, given); from != boost::graph_traits<TriangleMesh>::null_halfedge())
          put(result, edge(from, given), true);
    return result;
  }

  /// takes a mesh as it is, with a map of it.
  /// \param given the given mesh; this one must be empty
  /// \param points vertex of the given mesh -> its point, in doubles
  /// \param uv_map halfedge of the given mesh -> coordinates of its target in the chart of its face
  /// \param is_constrained edge of the given mesh -> whether it is to lie on an isoline; or something else, if none is
  template <typename VertexPointMap, typename HalfedgeUVMap, typename EdgeIsConstrainedMap>
  void copy(const TriangleMesh& given, const VertexPointMap& points, const HalfedgeUVMap uv_map,
            const EdgeIsConstrainedMap& is_constrained)
  {
    using Source = boost::graph_traits<TriangleMesh>;
    std::vector<std::pair<typename Source::halfedge_descriptor, Mesh::Halfedge_index>> halfedges;
    CGAL::copy_face_graph(
        given, mesh(),
        CGAL::parameters::vertex_point_map(points).halfedge_to_halfedge_output_iterator(std::back_inserter(halfedges)));
    if constexpr (!internal::is_missing<EdgeIsConstrainedMap>)
      for (const auto& [from, to] : halfedges)
        put(constrained_edges(), mesh().edge(to), get(is_constrained, edge(from, given)));
    for (const auto& [from, to] : halfedges)
      if (!is_border(from, given)) {
        const auto& p = get(uv_map, from);
        put(uv(), to, Kernel::Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y())));
        Location location(face(from, given), {{0, 0, 0}});
        const auto first = halfedge(location.first, given);
        location.second[from == first ? 1 : from == next(first, given) ? 2 : 0] = 1;
        put(locations(), target(to, mesh()), location);
      }
  }

  /// sets the cut and the transitions to those of the exact map. \pre `has_map()`
  void take_transitions()
  {
    for (const auto e : mesh().edges()) {
      put(cut(), e, map().is_cut(e));
      for (const auto h : {mesh().halfedge(e), mesh().opposite(mesh().halfedge(e))})
        put(transitions(), h, internal::converted_similarity<double>(map().transition(h)));
    }
  }

  /// returns whether there is an exactly seamless map.
  bool has_map() const { return m_parts->map.has_value(); }

  /// \pre `has_map()`
  const Map& map() const { return *m_parts->map; }

  /// replaces the exact map by an empty one of the present mesh, which must not change any more, and returns it.
  Map& reset_map() { return m_parts->map.emplace(m_parts->mesh); }
  /// removes the exact map.
  void remove_map() { m_parts->map.reset(); }

private:
  template <typename Graph>
  using Given_vertex = typename boost::graph_traits<Graph>::vertex_descriptor;

  // The vertices of the face or edge of the given mesh on which a vertex lies, or this vertex itself.
  void add_carriers(const Mesh::Vertex_index v, const TriangleMesh& given,
                    std::vector<Given_vertex<TriangleMesh>>& carriers) const
  {
    const Location& location = get(locations(), v);
    std::size_t i = 0;
    for (const auto corner : CGAL::vertices_around_face(prev(halfedge(location.first, given), given), given))
      if (location.second[i++] != 0)
        carriers.push_back(corner);
  }

  struct Parts {
    Mesh mesh;
    UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    Transition_map transitions =
        mesh.add_property_map<Mesh::Halfedge_index, Similarity_2<double>>("h:transition").first;
    Cut_map cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
    Constrained_edge_map constrained_edges =
        mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
    Location_map locations = mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
    std::optional<Map> map;
  };
  std::unique_ptr<Parts> m_parts; // their addresses last
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_APPROXIMATION_MAPPED_MESH_H
