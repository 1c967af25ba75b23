// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_GRAPH_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_GRAPH_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The vertices on the cut of a surface, and the sectors into which the cut and the border divide the faces at them.
///
/// A sector is known by the first of its outgoing halfedges, counter-clockwise: its edge is cut or on the border.
struct Cut_sectors {
  using Index = Triangulation_connectivity::Index;

  std::vector<Index> vertices;    ///< on the cut or on the border
  std::vector<int> first_sector;  ///< per entry of `vertices`, and one behind
  std::vector<Index> halfedge;    ///< per sector, counter-clockwise around each vertex, from the border if it has one
  std::vector<char> is_on_border; ///< per entry of `vertices`

  /// \param is_cut per edge
  Cut_sectors(const Triangulation_connectivity& mesh, const std::vector<char>& is_cut) : first_sector(1, 0)
  {
    std::vector<Index> start(mesh.number_of_vertices(), mesh.null);
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      if (mesh.face(h) == mesh.null)
        continue;
      const bool is_border = mesh.face(opposite(h)) == mesh.null;
      if (is_border || (is_cut[edge_of(h)] && start[mesh.source(h)] == mesh.null))
        start[mesh.source(h)] = h;
    }
    for (Index v = 0; v < mesh.number_of_vertices(); ++v)
      if (start[v] != mesh.null)
        add_vertex(mesh, is_cut, v, start[v]);
  }

  int number_of_vertices() const { return static_cast<int>(vertices.size()); }
  int number_of_sectors(const int i) const { return first_sector[i + 1] - first_sector[i]; }
  int number_of_sectors() const { return static_cast<int>(halfedge.size()); }

  /// The number of cut edges at a vertex.
  int degree(const int i) const { return number_of_sectors(i) - (is_on_border[i] ? 1 : 0); }

  /// Calls `visit(h)` for the halfedges that point to the vertex inside a sector.
  template <typename Visit>
  static void for_each_corner(const Triangulation_connectivity& mesh, const std::vector<char>& is_cut,
                              const Index sector, const Visit& visit)
  {
    Index h = sector;
    do {
      const Index corner = mesh.previous(h);
      visit(corner);
      h = opposite(corner);
    } while (mesh.face(h) != mesh.null && !is_cut[edge_of(h)]);
  }

private:
  void add_vertex(const Triangulation_connectivity& mesh, const std::vector<char>& is_cut, const Index v,
                  const Index start)
  {
    const bool starts_on_border = mesh.face(opposite(start)) == mesh.null;
    Index h = start;
    do {
      if (h == start || is_cut[edge_of(h)])
        halfedge.push_back(h);
      h = mesh.next_around_source(h);
    } while (h != start && mesh.face(h) != mesh.null);
    vertices.push_back(v);
    is_on_border.push_back(starts_on_border);
    first_sector.push_back(static_cast<int>(halfedge.size()));
  }
};

/// The cut of a surface as a graph: its nodes are vertices and loops of the border, its branches paths of cut edges
/// between them.
class Cut_graph {
  using Index = Triangulation_connectivity::Index;

public:
  static constexpr int none = -1;

  /// One end of a branch at a node.
  struct End {
    int branch;
    bool is_outgoing; ///< the branch starts here
  };

  /// \param is_node per entry of `sectors.vertices`: those with a number of cut edges other than two and those on the
  ///   border must be nodes
  /// \param border_loops entries on each loop of the border, with the surface on the right: the first nodes
  Cut_graph(const Triangulation_connectivity& mesh, const Cut_sectors& sectors, const std::vector<char>& is_node,
            const std::vector<std::vector<int>>& border_loops)
    : m_branch(mesh.number_of_edges(), none),
      m_is_along(mesh.number_of_edges(), 1)
  {
    // Per cut vertex that is not a node, its two outgoing cut halfedges; per vertex, its place in the list.
    std::vector<int> place(mesh.number_of_vertices(), none);
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      place[sectors.vertices[i]] = i;
    std::vector<char> node = is_node;
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      if (node[i])
        follow_all(mesh, sectors, node, place, i);
    // What is left are closed branches: each gets a node.
    for (int i = 0; i < sectors.number_of_vertices(); ++i)
      if (!node[i] && m_branch[edge_of(sectors.halfedge[sectors.first_sector[i]])] == none) {
        node[i] = 1;
        follow_all(mesh, sectors, node, place, i);
      }
    collect_ends(mesh, sectors, node, place, border_loops);
  }

  int number_of_branches() const { return static_cast<int>(m_branch_begin.size()) - 1; }
  int number_of_nodes() const { return static_cast<int>(m_nodes.size()); }
  int number_of_edges() const { return static_cast<int>(m_path.size()); }

  /// The entry of a node in the list of cut vertices; of a loop, the first one.
  int cut_vertex(const int node) const { return m_nodes[node]; }

  int number_of_ends(const int node) const { return m_end_begin[node + 1] - m_end_begin[node]; }
  /// The ends of branches at a node, counter-clockwise; on a loop, from the border at its first vertex.
  const End& end(const int node, const int i) const { return m_ends[m_end_begin[node] + i]; }

  /// The nodes in which a branch starts and ends.
  const std::array<int, 2>& nodes_of_branch(const int branch) const { return m_branch_nodes[branch]; }
  int other_node(const End& end) const { return m_branch_nodes[end.branch][end.is_outgoing ? 1 : 0]; }

  int length(const int branch) const { return m_branch_begin[branch + 1] - m_branch_begin[branch]; }
  /// The halfedges of a branch, from its start to its end.
  Index halfedge(const int branch, const int i) const { return m_path[m_branch_begin[branch] + i]; }

  int branch_of_edge(const Index edge) const { return m_branch[edge]; }
  /// Whether the branch of a cut edge runs along `h`.
  bool is_along(const Index h) const { return (m_is_along[edge_of(h)] != 0) == is_along_edge(h); }

private:
  void follow_all(const Triangulation_connectivity& mesh, const Cut_sectors& sectors, const std::vector<char>& is_node,
                  const std::vector<int>& place, const int i)
  {
    for (int k = sectors.first_sector[i]; k < sectors.first_sector[i + 1]; ++k) {
      const Index h = sectors.halfedge[k];
      const bool is_border = mesh.face(opposite(h)) == mesh.null;
      if (!is_border && m_branch[edge_of(h)] == none)
        follow(mesh, sectors, is_node, place, h);
    }
  }

  void follow(const Triangulation_connectivity& mesh, const Cut_sectors& sectors, const std::vector<char>& is_node,
              const std::vector<int>& place, Index h)
  {
    const int branch = number_of_branches();
    while (true) {
      m_path.push_back(h);
      m_branch[edge_of(h)] = branch;
      m_is_along[edge_of(h)] = is_along_edge(h);
      const int i = place[mesh.target(h)];
      if (is_node[i])
        break;
      const int k = sectors.first_sector[i];
      h = sectors.halfedge[k] == opposite(h) ? sectors.halfedge[k + 1] : sectors.halfedge[k];
    }
    m_branch_begin.push_back(static_cast<int>(m_path.size()));
  }

  void collect_ends(const Triangulation_connectivity& mesh, const Cut_sectors& sectors,
                    const std::vector<char>& is_node, const std::vector<int>& place,
                    const std::vector<std::vector<int>>& border_loops)
  {
    std::vector<int> node_of_place(is_node.size(), none);
    const auto add_ends = [&](const int i) {
      node_of_place[i] = number_of_nodes() - 1;
      for (int k = sectors.first_sector[i]; k < sectors.first_sector[i + 1]; ++k) {
        const Index h = sectors.halfedge[k];
        if (m_branch[edge_of(h)] != none)
          m_ends.push_back({m_branch[edge_of(h)], is_along(h)});
      }
    };
    for (const std::vector<int>& loop : border_loops) {
      m_nodes.push_back(loop.front());
      for (const int i : loop)
        add_ends(i);
      m_end_begin.push_back(static_cast<int>(m_ends.size()));
    }
    for (int i = 0; i < sectors.number_of_vertices(); ++i) {
      if (!is_node[i] || sectors.is_on_border[i])
        continue;
      m_nodes.push_back(i);
      add_ends(i);
      m_end_begin.push_back(static_cast<int>(m_ends.size()));
    }
    for (int b = 0; b < number_of_branches(); ++b)
      m_branch_nodes.push_back({{node_of_place[place[mesh.source(halfedge(b, 0))]],
                                 node_of_place[place[mesh.target(halfedge(b, length(b) - 1))]]}});
  }

  std::vector<Index> m_path;
  std::vector<int> m_branch_begin = {0};
  std::vector<std::array<int, 2>> m_branch_nodes;
  std::vector<int> m_nodes;
  std::vector<End> m_ends;
  std::vector<int> m_end_begin = {0};
  std::vector<int> m_branch;    // per edge
  std::vector<char> m_is_along; // per edge: the branch runs along its even halfedge
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_CUT_GRAPH_H
