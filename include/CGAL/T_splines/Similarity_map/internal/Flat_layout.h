// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FLAT_LAYOUT_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FLAT_LAYOUT_H

#include <CGAL/T_splines/Similarity_map/internal/Plane_vector.h>
#include <CGAL/T_splines/Similarity_map/internal/Similarity_structure.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The flat metric of a similarity structure laid out in the plane over a cut.
///
/// Faces are laid out breadth first. The edges that the dual tree does not cross form the cut; branches that end at a
/// vertex around which the transitions are trivial are sewn up again. Between two of its cut edges, all corners at a
/// vertex share one point. Of a double, faces that are images are not laid out; the edges towards them count as cut.
/// \tparam FT number type of the plane
template <typename FT>
class Flat_layout {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  using Vector = Plane_vector<FT>;

  /// \param coefficients phi per vertex, then c per loop
  /// \param quarter_turns per vertex
  /// \param progress if it is interrupted, the layout may not be used
  template <typename StructureFT>
  Flat_layout(const Similarity_structure<StructureFT>& structure, const std::vector<StructureFT>& coefficients,
              const std::vector<int>& quarter_turns, Progress& progress)
    : m_mesh(structure.mesh),
      m_position(structure.mesh.number_of_halfedges()),
      m_entry(structure.mesh.number_of_faces(), null),
      m_order(structure.mesh.number_of_faces(), -1),
      m_is_cut(structure.mesh.number_of_edges(), 1)
  {
    lay_out(structure, coefficients, progress);
    if (!progress.go_on())
      return;
    for (Index e = 0; e < m_mesh.number_of_edges(); ++e)
      if (structure.pairs.is_image_edge(m_mesh, e))
        m_is_cut[e] = 0;
    sew_up(quarter_turns);
    join_corners();
  }

  /// The point of the target of `h` in the chart of the face of `h`.
  const Vector& position(const Index h) const { return m_position[h]; }

  /// The same, rounded.
  std::array<double, 2> uv(const Index h) const { return to_double(m_position[h]); }

  static std::array<double, 2> to_double(const Vector& p)
  {
    return {{static_cast<double>(p.u), static_cast<double>(p.v)}};
  }

  bool is_cut(const Index edge) const { return m_is_cut[edge] != 0; }

  bool is_laid_out(const Index face) const { return m_order[face] != -1; }

  /// Whether the edge is cut, and both of its faces are laid out: then there is a transition across it.
  bool is_cut_inside(const Index edge) const
  {
    return is_cut(edge) && is_laid_out(m_mesh.face(halfedge_of_edge(edge))) &&
           is_laid_out(m_mesh.face(opposite(halfedge_of_edge(edge))));
  }

  /// Rotation of the transition from the chart of the face of `h` to that of its opposite, in quarter turns, from the
  /// positions.
  int quarter_turns(const Index h) const
  {
    const Index g = opposite(h);
    const Vector here = m_position[h] - m_position[m_mesh.previous(h)];
    const Vector there = m_position[m_mesh.previous(g)] - m_position[g];
    const FT cosine = here.dot(there), sine = here.cross(there);
    if (absolute(cosine) >= absolute(sine))
      return cosine > 0 ? 0 : 2;
    return sine > 0 ? 1 : 3;
  }

  /// Exponents n of the transition's scale factor from the chart of the face of `h` to that of its opposite: it is
  /// exp(sum_j n_j c_j). Complexity: linear in the depth of the dual tree.
  std::vector<int> scale_exponents(const Dual_loops& loops, const Index h) const
  {
    // phi at the source of h, continued to the root on both sides.
    std::vector<int> exponents(loops.number_of_loops(), 0);
    const Index g = opposite(h);
    const Index root_here = walk_to_root(loops, h, 1, exponents);
    const Index root_there = walk_to_root(loops, m_mesh.next(g), -1, exponents);
    // The two walks end at corners of the root face; what is left is the way between these.
    for (Index k = root_here; k != root_there; k = m_mesh.next(k))
      add_passages(loops, k, 1, exponents);
    return exponents;
  }

private:
  static FT absolute(const FT& x) { return x < 0 ? FT(-x) : x; }

  template <typename StructureFT>
  void lay_out(const Similarity_structure<StructureFT>& structure, const std::vector<StructureFT>& coefficients,
               Progress& progress)
  {
    std::vector<Index> faces;
    int order = 0;
    for (Index root = 0; root < m_mesh.number_of_faces(); ++root) {
      if (is_laid_out(root) || structure.pairs.is_image(root))
        continue;
      place_root(structure, coefficients, root);
      m_order[root] = order++;
      faces.assign(1, root);
      for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!progress.go_on_after(8 * work_of_function<FT>))
          return;
        Index h = m_mesh.halfedge_of_face(faces[i]);
        for (int k = 0; k < 3; ++k, h = m_mesh.next(h)) {
          const Index g = opposite(h), f = m_mesh.face(g);
          if (is_laid_out(f) || structure.pairs.is_image(f))
            continue;
          m_order[f] = order++;
          m_entry[f] = g;
          m_is_cut[edge_of(h)] = 0;
          m_position[g] = m_position[m_mesh.previous(h)];
          m_position[m_mesh.previous(g)] = m_position[h];
          place_apex(structure, g);
          faces.push_back(f);
        }
      }
    }
  }

  template <typename StructureFT>
  void place_root(const Similarity_structure<StructureFT>& structure, const std::vector<StructureFT>& coefficients,
                  const Index f)
  {
    using std::exp;
    const Index h = m_mesh.halfedge_of_face(f);
    const FT log_scale = FT(coefficients[m_mesh.source(h)]) + FT(structure.form_of(h)) / 2;
    m_position[m_mesh.previous(h)] = Vector{};
    m_position[h] = Vector{exp(FT(FT(structure.log_length[edge_of(h)]) + log_scale)), FT(0)};
    place_apex(structure, h);
  }

  // Places the third corner of the face of `h`, by its side lengths relative to that of h.
  template <typename StructureFT>
  void place_apex(const Similarity_structure<StructureFT>& structure, const Index h)
  {
    using std::exp;
    using std::sqrt;
    const Index j = m_mesh.next(h), k = m_mesh.next(j);
    const FT xi_h(structure.form_of(h)), xi_j(structure.form_of(j)), xi_k(structure.form_of(k));
    const FT log_h = FT(structure.log_length[edge_of(h)]) + (xi_k - xi_j) / 6;
    const FT log_j = FT(structure.log_length[edge_of(j)]) + (xi_h - xi_k) / 6;
    const FT log_k = FT(structure.log_length[edge_of(k)]) + (xi_j - xi_h) / 6;
    const FT a = exp(FT(log_j - log_h)),
             b = exp(FT(log_k - log_h)); // sides at the target and at the source of h; h is 1
    const FT along = (1 + (a - b) * (a + b)) / 2;
    const FT product = ((1 + (a + b)) * (1 + (a - b))) * ((a + b) - 1) * (1 - (a - b));
    const FT across = product > 0 ? FT(sqrt(product) / 2) : FT(0);
    const Vector back = m_position[k] - m_position[h];
    m_position[j] = m_position[h] + back * along + back.turned(3) * across;
  }

  // Sews up the branches of the cut that end at a vertex whose quarter turns are a multiple of four.
  void sew_up(const std::vector<int>& quarter_turns)
  {
    std::vector<int> degree(m_mesh.number_of_vertices(), 0), incident(m_mesh.number_of_vertices(), 0);
    for (Index e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_is_cut[e])
        for (const Index h : halfedges_of_edge(e)) {
          ++degree[m_mesh.target(h)];
          incident[m_mesh.target(h)] ^= e;
        }
    for (Index first = 0; first < m_mesh.number_of_vertices(); ++first)
      for (Index v = first; degree[v] == 1 && quarter_turns[v] % 4 == 0;) {
        const Index e = incident[v];
        m_is_cut[e] = 0;
        degree[v] = 0;
        const Index h = halfedge_of_edge(e);
        v = m_mesh.target(h) == v ? m_mesh.source(h) : m_mesh.target(h);
        --degree[v];
        incident[v] ^= e;
      }
  }

  // Gives all corners at a vertex between two cut edges the point of the corner whose face was laid out first.
  void join_corners()
  {
    std::vector<char> is_done(m_mesh.number_of_halfedges(), 0);
    std::vector<Index> corners;
    for (Index start = 0; start < m_mesh.number_of_halfedges(); ++start) {
      if (is_done[start] || !is_laid_out(m_mesh.face(start)))
        continue;
      Index h = start; // to the clockwise end of the sector of the corner at the target of start
      while (!m_is_cut[edge_of(h)]) {
        h = m_mesh.previous(opposite(h));
        if (h == start)
          break;
      }
      corners.clear();
      Index first = h;
      const Index end = h;
      do {
        corners.push_back(h);
        is_done[h] = 1;
        if (m_order[m_mesh.face(h)] < m_order[m_mesh.face(first)])
          first = h;
        h = m_mesh.next(h);
        if (m_is_cut[edge_of(h)])
          break;
        h = opposite(h);
      } while (h != end);
      const Vector point = m_position[first];
      for (const Index corner : corners)
        m_position[corner] = point;
    }
  }

  void add_passages(const Dual_loops& loops, const Index h, const int factor, std::vector<int>& exponents) const
  {
    loops.for_each_passage(edge_of(h), [&](const int loop, const int sign) {
      exponents[loop] += factor * (is_along_edge(h) ? sign : -sign);
    });
  }

  // Moves the corner at the source of `h`, in the face of h, along edges to a corner of the root face and adds the
  // passages of the loops over these edges. \return the halfedge of the root face whose source is the corner reached.
  Index walk_to_root(const Dual_loops& loops, Index h, const int factor, std::vector<int>& exponents) const
  {
    while (true) {
      const Index entry = m_entry[m_mesh.face(h)];
      if (entry == null)
        return h;
      if (h == m_mesh.previous(entry)) { // the apex is not on the edge of entry: move to the source of entry
        add_passages(loops, h, factor, exponents);
        h = entry;
      }
      // The same vertex in the parent face.
      h = h == entry ? m_mesh.next(opposite(entry)) : opposite(entry);
    }
  }

  const Triangulation_connectivity& m_mesh;
  std::vector<Vector> m_position; // per halfedge: of its target
  std::vector<Index> m_entry;     // per face: its halfedge towards its parent in the dual tree
  std::vector<int> m_order;       // per face
  std::vector<char> m_is_cut;     // per edge
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_FLAT_LAYOUT_H
