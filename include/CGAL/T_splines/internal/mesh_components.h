// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_INTERNAL_MESH_COMPONENTS_H
#define CGAL_T_SPLINES_INTERNAL_MESH_COMPONENTS_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The connected components of a triangulation, numbered in the order of their first faces.
struct Mesh_components {
  std::vector<int> of_face;
  std::vector<int> of_vertex;            ///< `Triangulation_connectivity::null` for isolated vertices
  std::vector<int> first_face;           ///< per component: its face of smallest index
  std::vector<int> euler_characteristic; ///< per component: V - E + F
  std::vector<int> number_of_borders;    ///< per component: closed curves of its border

  int size() const { return static_cast<int>(first_face.size()); }

  /// The genus of component `c`, whose border counts as closed by disks.
  int genus(const int c) const { return (2 - number_of_borders[c] - euler_characteristic[c]) / 2; }

  bool has_border(const int c) const { return number_of_borders[c] > 0; }
};

/// The closed curves of the border, each as the sequence of its halfedges without face, in the order in which `m_next`
/// runs through them. Complexity: linear.
inline std::vector<std::vector<int>> border_curves(const Triangulation_connectivity& mesh)
{
  std::vector<std::vector<int>> result;
  std::vector<char> is_done(mesh.number_of_halfedges(), 0);
  for (int first = 0; first < mesh.number_of_halfedges(); ++first) {
    if (mesh.face(first) != Triangulation_connectivity::null || is_done[first])
      continue;
    result.emplace_back();
    for (int h = first; !is_done[h]; h = mesh.next(h)) {
      is_done[h] = 1;
      result.back().push_back(h);
    }
  }
  return result;
}

/// finds the connected components. Faces are connected across edges. Complexity: linear.
inline Mesh_components mesh_components(const Triangulation_connectivity& mesh)
{
  using Index = Triangulation_connectivity::Index;
  constexpr Index null = Triangulation_connectivity::null;
  Mesh_components result;
  result.of_face.assign(mesh.number_of_faces(), null);
  result.of_vertex.assign(mesh.number_of_vertices(), null);
  std::vector<Index> faces;
  for (Index first = 0; first < mesh.number_of_faces(); ++first) {
    if (result.of_face[first] != null)
      continue;
    const int component = result.size();
    result.first_face.push_back(first);
    result.of_face[first] = component;
    faces.assign(1, first);
    int number_of_vertices = 0, number_of_border_edges = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      Index h = mesh.halfedge_of_face(faces[i]);
      for (int corner = 0; corner < 3; ++corner, h = mesh.next(h)) {
        if (result.of_vertex[mesh.target(h)] == null) {
          result.of_vertex[mesh.target(h)] = component;
          ++number_of_vertices;
        }
        const Index neighbor = mesh.face(opposite(h));
        if (neighbor == null)
          ++number_of_border_edges;
        else if (result.of_face[neighbor] == null) {
          result.of_face[neighbor] = component;
          faces.push_back(neighbor);
        }
      }
    }
    const int number_of_faces = static_cast<int>(faces.size());
    const int number_of_edges = (3 * number_of_faces + number_of_border_edges) / 2;
    result.euler_characteristic.push_back(number_of_vertices - number_of_edges + number_of_faces);
  }
  result.number_of_borders.assign(result.size(), 0);
  for (const std::vector<int>& curve : border_curves(mesh))
    ++result.number_of_borders[result.of_vertex[mesh.target(curve.front())]];
  return result;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_INTERNAL_MESH_COMPONENTS_H
