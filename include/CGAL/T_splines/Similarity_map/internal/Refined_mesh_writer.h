// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_REFINED_MESH_WRITER_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_REFINED_MESH_WRITER_H

#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/internal/Face_graph_writer.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Makes a face graph of a refined triangulation and fills property maps on it. Linear time; no look-ups by vertices.
/// \tparam RefinedMesh a model of `MutableFaceGraph`
template <typename RefinedMesh>
class Refined_mesh_writer {
  using Traits = boost::graph_traits<RefinedMesh>;

public:
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  /// \pre `mesh` is empty.
  Refined_mesh_writer(const Refined_triangulation& refined, RefinedMesh& mesh)
    : m_refined(refined),
      m_mesh(mesh),
      m_writer(mesh, refined.mesh.number_of_vertices(), refined.mesh.number_of_edges(), refined.mesh.number_of_faces())
  {
    const Triangulation_connectivity& from = refined.mesh;
    for (int h = 0; h < from.number_of_halfedges(); ++h)
      m_writer.join(h, from.next(h), from.target(h), from.face(h));
    for (int f = 0; f < from.number_of_faces(); ++f)
      m_writer.set_halfedge_of_face(f, from.halfedge_of_face(f));
  }

  halfedge_descriptor halfedge_of(const int h) const { return m_writer.halfedge(h); }

  /// writes the points: those of the input's vertices are copied from its own map.
  template <typename TriangleMesh, typename InputPointMap, typename OutputPointMap>
  void put_points(const Mesh_indexing<TriangleMesh>& indexing, const InputPointMap& from, OutputPointMap to) const
  {
    using Point_3 = typename boost::property_traits<OutputPointMap>::value_type;
    for (int v = 0; v < m_refined.mesh.number_of_vertices(); ++v) {
      if (v < indexing.number_of_vertices())
        put(to, m_writer.vertex(v), copy<Point_3>(get(from, indexing.vertex(v))));
      else
        put(to, m_writer.vertex(v), Point_3(m_refined.point[v][0], m_refined.point[v][1], m_refined.point[v][2]));
    }
  }

  template <typename HalfedgeUVMap>
  void put_uv(HalfedgeUVMap map) const
  {
    using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
    for (int h = 0; h < m_refined.mesh.number_of_halfedges(); ++h)
      put(map, m_writer.halfedge(h), Point_2(m_refined.uv[h][0], m_refined.uv[h][1]));
  }

  /// writes each vertex's place on the input as a face and barycentric coordinates (`Face_location` of Polygon Mesh
  /// Processing). \param input closed: of a mesh with border, the double
  template <typename TriangleMesh, typename VertexLocationMap>
  void put_locations(const Mesh_indexing<TriangleMesh>& indexing, const Triangulation_connectivity& input,
                     VertexLocationMap map) const
  {
    using Location = typename boost::property_traits<VertexLocationMap>::value_type;
    std::vector<int> arriving(input.number_of_vertices()); // of a face
    for (int h = 0; h < input.number_of_halfedges(); ++h)
      if (is_inner(input, h, indexing))
        arriving[input.target(h)] = h;
    for (int v = 0; v < m_refined.mesh.number_of_vertices(); ++v) {
      const Input_place& place = m_refined.place[v];
      int f = 0;
      std::array<double, 3>
          weight{}; // of the source, the target, and the target of the successor of the halfedge of the face
      const auto corner = [&](const int h) { // index of the target of h
        const int first = input.halfedge_of_face(f);
        return h == first ? 1 : h == input.next(first) ? 2 : 0;
      };
      switch (place.kind) {
      case Input_place::Kind::VERTEX:
        f = input.face(arriving[place.index]);
        weight[corner(arriving[place.index])] = 1;
        break;
      case Input_place::Kind::EDGE: {
        const auto [along, against] = halfedges_of_edge(place.index);
        const bool is_along = is_inner(input, along, indexing);
        const int h = is_along ? along : against;
        f = input.face(h);
        weight[corner(input.previous(h))] = place.weight[is_along ? 0 : 1];
        weight[corner(h)] = place.weight[is_along ? 1 : 0];
        break;
      }
      case Input_place::Kind::FACE:
        f = place.index;
        weight = {{place.weight[2], place.weight[0], place.weight[1]}};
        break;
      }
      Location location;
      location.first = indexing.face(f);
      location.second = {{weight[0], weight[1], weight[2]}};
      put(map, m_writer.vertex(v), location);
    }
  }

  /// writes whether each edge is cut. \param is_cut by index
  template <typename EdgeIsCutMap>
  void put_cut(const std::vector<char>& is_cut, EdgeIsCutMap map) const
  {
    for (int e = 0; e < m_refined.mesh.number_of_edges(); ++e)
      put(map, edge(m_writer.halfedge(halfedge_of_edge(e)), m_mesh), is_cut[e] != 0);
  }

private:
  // Whether a halfedge of the input, or of its double, has a face of the input.
  template <typename TriangleMesh>
  static bool is_inner(const Triangulation_connectivity& input, const int h,
                       const Mesh_indexing<TriangleMesh>& indexing)
  {
    return input.face(h) < indexing.number_of_faces();
  }

  template <typename To, typename From>
  static To copy(const From& p)
  {
    if constexpr (std::is_convertible<From, To>::value)
      return p;
    else
      return To(p.x(), p.y(), p.z());
  }

  const Refined_triangulation& m_refined;
  RefinedMesh& m_mesh;
  Face_graph_writer<RefinedMesh> m_writer;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_REFINED_MESH_WRITER_H
