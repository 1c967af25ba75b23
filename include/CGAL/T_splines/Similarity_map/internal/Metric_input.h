// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_METRIC_INPUT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_METRIC_INPUT_H

#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Similarity_map/internal/Doubled_triangulation.h>
#include <CGAL/T_splines/Similarity_map/internal/Mirror_pairs.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>
#include <CGAL/T_splines/internal/mesh_components.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What the coefficient of a loop of a double is on symmetric metrics: `sign` times that of the loop `original`, which may
/// be the loop itself. The sign is 0 where the coefficient vanishes.
struct Folded_loop {
  int original, sign;
};

/// What a similarity metric is computed from, in indices: of a mesh with border the double, with the numbers that are
/// symmetric. What is on the first sheet, the mesh itself, comes first.
struct Metric_input {
  Triangulation_connectivity mesh;          ///< closed
  std::vector<std::array<double, 3>> point; ///< per vertex
  std::vector<int> component_of_vertex;
  std::vector<std::vector<int>> loops; ///< of the signature, then its arcs doubled, then what the border adds
  std::vector<int> quarter_turns;      ///< per vertex, then per loop
  std::vector<int> original_vertex;    ///< per vertex, on the first sheet
  Mirror_pairs pairs;                  ///< of the faces; empty if there is no second sheet
  std::vector<Folded_loop> folding;    ///< per loop; empty if there is no second sheet
  int number_of_vertices = 0,          ///< on the first sheet
      number_of_edges = 0,             ///< on the first sheet
      number_of_faces = 0;             ///< on the first sheet
  std::size_t number_of_loops = 0,     ///< of the signature
      number_of_arcs = 0;              ///< of the signature

  template <typename TriangleMesh, typename VertexPointMap>
  Metric_input(const Mesh_indexing<TriangleMesh>& indexing, const Holonomy_signature<TriangleMesh>& signature,
               const VertexPointMap& points)
    : mesh(triangulation_connectivity(indexing)),
      original_vertex(mesh.number_of_vertices()),
      number_of_vertices(mesh.number_of_vertices()),
      number_of_edges(mesh.number_of_edges()),
      number_of_faces(mesh.number_of_faces()),
      number_of_loops(signature.loops().size()),
      number_of_arcs(signature.arcs().size())
  {
    const Mesh_components components = mesh_components(mesh);
    component_of_vertex = components.of_vertex;
    std::iota(original_vertex.begin(), original_vertex.end(), 0);
    for (int v = 0; v < indexing.number_of_vertices(); ++v) {
      const auto& p = get(points, indexing.vertex(v));
      point.push_back({{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}});
    }
    quarter_turns.assign(indexing.number_of_vertices(), Holonomy_signature<TriangleMesh>::regular);
    for (const auto& cone : signature.cones())
      quarter_turns[indexing.vertex_index(cone.first)] = cone.second;
    for (const auto& corner : signature.corners())
      quarter_turns[indexing.vertex_index(corner.first)] = 2 * corner.second;
    std::vector<int> loop_turns;
    for (const auto& loop : signature.loops()) {
      loops.push_back(indices_of(indexing, loop.halfedges));
      loop_turns.push_back(loop.quarter_turns);
    }
    if (std::any_of(components.number_of_borders.begin(), components.number_of_borders.end(),
                    [](const int number) { return number > 0; }))
      make_double(indexing, components, signature, loop_turns);
    quarter_turns.insert(quarter_turns.end(), loop_turns.begin(), loop_turns.end());
  }

  /// Whether there is a second sheet.
  bool is_double() const { return mesh.number_of_faces() > number_of_faces; }

  /// The square of the length of edge e, of the points as they are.
  template <typename FT>
  FT squared_length(const int e) const
  {
    const std::array<double, 3>&p = point[mesh.target(halfedge_of_edge(e))],
                             &q = point[mesh.source(halfedge_of_edge(e))];
    FT sum(0);
    for (int k = 0; k < 3; ++k) {
      const FT d = FT(p[k]) - FT(q[k]);
      sum += d * d;
    }
    return sum;
  }

private:
  template <typename TriangleMesh, typename Halfedges>
  static std::vector<int> indices_of(const Mesh_indexing<TriangleMesh>& indexing, const Halfedges& halfedges)
  {
    std::vector<int> result;
    for (const auto h : halfedges)
      result.push_back(indexing.halfedge_index(h));
    return result;
  }

  void add_loop(std::vector<int> loop, const int original, const int sign)
  {
    loops.push_back(std::move(loop));
    folding.push_back({original, sign});
  }

  // A double of genus 2g + b - 1 has these loops: the 2g of the surface; the arcs doubled; the mirror images of the
  // former; and all curves of the border but one, pushed inside, whose numbers follow from the corners. The latter are
  // homologous to their mirror images: there is no scale factor along what they cross.
  template <typename TriangleMesh>
  void make_double(const Mesh_indexing<TriangleMesh>& indexing, const Mesh_components& components,
                   const Holonomy_signature<TriangleMesh>& signature, std::vector<int>& loop_turns)
  {
    const Doubled_triangulation doubled(mesh, components);
    for (std::size_t i = 0; i < number_of_loops; ++i)
      folding.push_back({static_cast<int>(i), 1});
    for (const auto& arc : signature.arcs()) {
      add_loop(doubled.doubled(indices_of(indexing, arc.halfedges)), static_cast<int>(loops.size()), 1);
      loop_turns.push_back(2 * arc.quarter_turns);
    }
    for (std::size_t i = 0; i < number_of_loops; ++i)
      if (components.has_border(components.of_face[mesh.face(loops[i].front())])) {
        add_loop(doubled.mirrored(loops[i]), static_cast<int>(i), -1);
        loop_turns.push_back(-loop_turns[i]);
      }
    std::vector<char> has_curve(components.size(), 0);
    for (const std::vector<int>& curve : border_curves(mesh)) {
      char& is_not_first = has_curve[components.of_vertex[mesh.target(curve.front())]];
      if (is_not_first) {
        add_loop(strip_along_border(mesh, curve), static_cast<int>(loops.size()), 0);
        int turns = 0;
        for (const int h : curve)
          turns += 2 - quarter_turns[mesh.target(h)] / 2;
        loop_turns.push_back(turns);
      }
      is_not_first = 1;
    }
    for (const int v : doubled.originals()) {
      original_vertex.push_back(v);
      point.push_back(std::array<double, 3>(point[v]));
      component_of_vertex.push_back(component_of_vertex[v]);
      quarter_turns.push_back(quarter_turns[v]);
    }
    pairs = doubled.pairs();
    mesh = doubled.closed();
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_METRIC_INPUT_H
