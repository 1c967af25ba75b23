// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVISION_TRIANGLES_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVISION_TRIANGLES_H

#include <CGAL/T_splines/Similarity_map/internal/Refined_triangulation.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The triangles of a common subdivision, which are collected one by one and then connected.
class Subdivision_triangles {
  static constexpr int none = -1;

public:
  struct Triangle {
    std::array<int, 3> node;
    std::array<std::array<double, 2>, 3> uv;           // of the nodes
    std::array<int, 3> input_halfedge, final_halfedge; // of the side from node i to node i + 1
    int input_face;
  };

  void reserve(const std::size_t number) { m_triangles.reserve(number); }
  void add(const Triangle& triangle) { m_triangles.push_back(triangle); }

  /// makes the connectivity of the triangles, and gives up their memory. Two of them share a side, unless it is on the
  /// border: then it has no face on the side of its odd halfedge, which has no successor yet.
  /// \param number_of_input_edges of the input triangulation
  /// \param result its points are those of the nodes
  /// \param progress if it is interrupted, the result may not be used
  void connect(const int number_of_input_edges, Refined_triangulation& result, Progress& progress)
  {
    const std::vector<int> halfedge =
        number_halfedges(number_of_input_edges, static_cast<int>(result.point.size()), progress);
    if (!progress.go_on())
      return;
    const std::size_t halfedges = 2 * ((static_cast<std::size_t>(m_number_of_halfedges) + 1) / 2);
    Triangulation_connectivity& mesh = result.mesh;
    mesh.m_number_of_vertices = static_cast<int>(result.point.size());
    mesh.m_next.resize(halfedges, none);
    mesh.m_target.resize(halfedges);
    mesh.m_face.resize(halfedges, none);
    mesh.m_face_halfedge.resize(m_triangles.size());
    result.uv.resize(halfedges);
    result.input_halfedge.resize(halfedges);
    result.final_halfedge.resize(halfedges);
    result.input_face.resize(m_triangles.size());
    const int number_of_triangles = static_cast<int>(m_triangles.size());
    for (int f = 0; f < number_of_triangles; ++f) {
      const Triangle& triangle = m_triangles[f];
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, h = halfedge[3 * f + i];
        mesh.m_next[h] = halfedge[3 * f + j];
        mesh.m_target[h] = triangle.node[j];
        mesh.m_face[h] = f;
        result.uv[h] = triangle.uv[j];
        result.input_halfedge[h] = triangle.input_halfedge[i];
        result.final_halfedge[h] = triangle.final_halfedge[i];
      }
      mesh.m_face_halfedge[f] = halfedge[3 * f];
      result.input_face[f] = triangle.input_face;
    }
    m_triangles = {};
    for (int h = 0; h < mesh.number_of_halfedges(); h += 2)
      if (mesh.face(opposite(h)) == none)
        complete_border(h, result);
  }

private:
  // A side of a triangle, and what it shares with the triangle on its other side: its nodes, the smaller of which comes
  // with its place in the order, and the input edge or face in which it lies. Its nodes alone do not tell, where two
  // input edges join the same two vertices.
  struct Side {
    int node, place, number;

    bool operator<(const Side& other) const
    {
      return std::tie(node, place, number) < std::tie(other.node, other.place, other.number);
    }
  };

  // The halfedge of each side of a triangle, in the order of sides.
  std::vector<int> number_halfedges(const int number_of_input_edges, const int number_of_nodes, Progress& progress)
  {
    const std::size_t number_of_sides = 3 * m_triangles.size();
    const auto nodes = [this](const std::size_t i) {
      const std::array<int, 3>& node = m_triangles[i / 3].node;
      return std::minmax(node[i % 3], node[(i + 1) % 3]);
    };
    std::vector<int> begin(number_of_nodes + 1, 0);
    for (std::size_t i = 0; i < number_of_sides; ++i)
      ++begin[nodes(i).first + 1];
    for (int node = 0; node < number_of_nodes; ++node)
      begin[node + 1] += begin[node];
    std::vector<Side> sides(number_of_sides);
    std::vector<int> end(begin.begin(), begin.end() - 1), halfedge(number_of_sides);
    if (!progress.go_on())
      return halfedge;
    for (std::size_t i = 0; i < number_of_sides; ++i) {
      const int on_input = m_triangles[i / 3].input_halfedge[i % 3];
      const int place = on_input != none ? edge_of(on_input) : number_of_input_edges + m_triangles[i / 3].input_face;
      sides[end[nodes(i).first]++] = {nodes(i).second, place, static_cast<int>(i)};
    }
    m_number_of_halfedges = 0;
    for (int node = 0; node < number_of_nodes; ++node) {
      if (!progress.go_on_after(20))
        return halfedge;
      std::sort(sides.begin() + begin[node], sides.begin() + begin[node + 1]);
      for (int i = begin[node]; i < begin[node + 1]; ++i) {
        const bool is_second = m_number_of_halfedges % 2 != 0 && i > begin[node] &&
                               sides[i].node == sides[i - 1].node && sides[i].place == sides[i - 1].place;
        if (!is_second)
          m_number_of_halfedges += m_number_of_halfedges % 2;
        halfedge[sides[i].number] = m_number_of_halfedges++;
      }
    }
    return halfedge;
  }

  // Fills in what the side without a face of the border edge of h has.
  static void complete_border(const int h, Refined_triangulation& refined)
  {
    const int g = opposite(h), on_final = refined.final_halfedge[h];
    CGAL_assertion(refined.input_halfedge[h] != none);
    refined.mesh.m_target[g] = refined.mesh.target(refined.mesh.previous(h));
    refined.input_halfedge[g] = opposite(refined.input_halfedge[h]);
    refined.final_halfedge[g] = on_final != none ? opposite(on_final) : none;
  }

  std::vector<Triangle> m_triangles;
  int m_number_of_halfedges = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVISION_TRIANGLES_H
