// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_METRIC_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_METRIC_H

#include <CGAL/T_splines/Similarity_map/internal/Triangle_angles.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// A flat metric with cones, up to similarity, on an intrinsic triangulation with the vertices of a mesh.
///
/// The triangulation is given in indices and may be non-simple: edges may join a vertex to itself, and several edges
/// the same two vertices. Halfedges `2e` and `2e + 1` belong to edge e. A closed 1-form xi scales the edges: on a
/// simply connected piece, xi = d phi, the edge from i to j has the length exp(log_length + (phi_i + phi_j) / 2)
/// ([CZ17] eq. (8)).
/// \tparam TriangleMesh the mesh whose vertices the triangulation has
/// \tparam FT_ a floating-point type
template <typename TriangleMesh, typename FT_ = double>
class Similarity_metric {
public:
  using FT = FT_;                                                                          ///< number type
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor; ///< a vertex of the mesh

  Similarity_metric() = default;

  /// is made by `compute_similarity_metric()`.
  /// \param connectivity the triangulation
  /// \param vertices the mesh's vertices by index
  /// \param log_length per edge
  /// \param form xi of the halfedge 2e, per edge e
  /// \param log_scale phi per vertex, by index
  Similarity_metric(internal::Triangulation_connectivity connectivity, std::vector<vertex_descriptor> vertices,
                    std::vector<FT> log_length, std::vector<FT> form, std::vector<FT> log_scale)
    : m_mesh(std::move(connectivity)),
      m_vertices(std::move(vertices)),
      m_log_length(std::move(log_length)),
      m_form(std::move(form)),
      m_log_scale(std::move(log_scale))
  {
  }

  /// returns the number of vertices of the mesh.
  int number_of_vertices() const { return m_mesh.number_of_vertices(); }
  /// returns the number of edges of the triangulation.
  int number_of_edges() const { return m_mesh.number_of_edges(); }
  /// returns the number of triangles.
  int number_of_faces() const { return m_mesh.number_of_faces(); }

  int opposite(const int h) const { return internal::opposite(h); } ///< the other halfedge of the edge of `h`
  int next(const int h) const { return m_mesh.next(h); } ///< the next halfedge around the face, counter-clockwise
  int face(const int h) const { return m_mesh.face(h); } ///< the face on the left of `h`
  int halfedge(const int f) const { return m_mesh.halfedge_of_face(f); } ///< a halfedge of face `f`
  vertex_descriptor target(const int h) const
  {
    return m_vertices[m_mesh.target(h)];
  } ///< the vertex of the mesh that `h` points to

  const FT& log_length(const int e) const { return m_log_length[e]; } ///< unscaled, of edge `e`
  FT form(const int h) const
  {
    return internal::is_along_edge(h) ? m_form[internal::edge_of(h)] : FT(-m_form[internal::edge_of(h)]);
  } ///< xi of the halfedge `h`

  /// phi at the vertex with index `i`, the i-th in the order of `vertices(mesh)`; 0 at the first vertex of each
  /// component. On a surface of genus 0 it is the logarithm of the conformal scale factor; otherwise it is continued
  /// over the loops of the signature with jumps.
  const FT& log_scale(const int i) const { return m_log_scale[i]; }

  /// returns the lengths of `halfedge(f)` and its two successors up to a common factor.
  std::array<FT, 3> lengths(const int f) const
  {
    using std::exp;
    const std::array<FT, 3> l = log_lengths(f);
    return {FT(1), exp(FT(l[1] - l[0])), exp(FT(l[2] - l[0]))};
  }

  /// returns the angles of face `f` opposite to `halfedge(f)` and its two successors, in radians.
  std::array<FT, 3> angles(const int f) const { return internal::Triangle_angles<FT>(log_lengths(f)).angle; }

private:
  std::array<FT, 3> log_lengths(const int f) const
  {
    const int h = halfedge(f), j = next(h), k = next(j);
    return {FT(m_log_length[internal::edge_of(h)] + (form(k) - form(j)) / 6),
            FT(m_log_length[internal::edge_of(j)] + (form(h) - form(k)) / 6),
            FT(m_log_length[internal::edge_of(k)] + (form(j) - form(h)) / 6)};
  }

  internal::Triangulation_connectivity m_mesh;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<FT> m_log_length, m_form, m_log_scale;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_SIMILARITY_METRIC_H
