// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_SEAMLESS_MAP_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_SEAMLESS_MAP_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/Exact_rational.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSimilarityMap
/// A seamless similarity map of a triangle mesh with exact transitions ([CZ17] sections 2.1 and 5).
///
/// Across each edge the corners of the two faces are related by a similarity, to the last bit if `FT` is exact; around
/// each vertex the similarities compose to the identity, or around a cone to a rotation about its image; and all
/// triangles are positively oriented. `make_exactly_seamless()` makes such maps. Corners are stored in doubles wherever
/// doubles are exact.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`; it must outlive the map, unchanged
/// \tparam FT_ a model of `FieldNumberType` and `RealEmbeddable`: exact, or `double` for robustness studies
template <typename TriangleMesh, typename FT_ = CGAL::Exact_rational>
class Seamless_map {
  using Traits = boost::graph_traits<TriangleMesh>;

public:
  using FT = FT_;                                                   ///< number type of the coordinates
  using vertex_descriptor = typename Traits::vertex_descriptor;     ///< a vertex of the mesh
  using halfedge_descriptor = typename Traits::halfedge_descriptor; ///< a halfedge of the mesh
  using edge_descriptor = typename Traits::edge_descriptor;         ///< an edge of the mesh

  /// The layout is empty: to be filled by `make_exactly_seamless()`.
  explicit Seamless_map(const TriangleMesh& mesh) : m_indexing(mesh) {}

  /// returns the mesh that is mapped.
  const TriangleMesh& mesh() const { return m_indexing.graph(); }

  /// returns the coordinates of the target of `h` in the chart of its face. \pre `h` is not a border halfedge
  std::pair<FT, FT> uv(const halfedge_descriptor h) const
  {
    const int i = m_indexing.halfedge_index(h);
    return {m_layout.coordinate(i, 0).value(), m_layout.coordinate(i, 1).value()};
  }

  /// returns whether `uv(h)` is stored as a pair of doubles: no transition determines it.
  bool is_double(const halfedge_descriptor h) const { return m_layout.is_double(m_indexing.halfedge_index(h)); }

  /// returns whether the charts of the two faces of `e` differ.
  bool is_cut(const edge_descriptor e) const
  {
    return m_layout.is_cut(internal::edge_of(m_indexing.halfedge_index(halfedge(e, mesh()))));
  }

  /// returns the transition from the chart of the face of `h` to that of its opposite's face; the identity off the cut.
  Similarity_2<FT> transition(const halfedge_descriptor h) const
  {
    const int i = m_indexing.halfedge_index(h);
    return m_layout.is_cut(internal::edge_of(i)) ? m_layout.transition(i) : Similarity_2<FT>();
  }

  /// returns the cone angle of `v` divided by a right angle: k_v of the signature, 4 at a regular vertex; on the
  /// border the angle of the corner, 2 at a regular vertex.
  int quarter_turns(const vertex_descriptor v) const { return m_layout.quarter_turns(m_indexing.vertex_index(v)); }

  /// returns whether `e` is an inner edge that was to lie on an isoline (`edge_is_constrained_map` of
  /// `make_exactly_seamless()`): at its two ends u is the same, or v, exactly.
  bool is_constrained(const edge_descriptor e) const
  {
    return m_layout.is_constrained(internal::edge_of(m_indexing.halfedge_index(halfedge(e, mesh()))));
  }

  /// \cond INTERNAL
  // For the algorithms of this package.
  const internal::Mesh_indexing<TriangleMesh>& indexing() const { return m_indexing; }
  const internal::Seamless_layout<FT>& layout() const { return m_layout; }
  void set_layout(internal::Seamless_layout<FT> layout) { m_layout = std::move(layout); }
  /// \endcond

private:
  internal::Mesh_indexing<TriangleMesh> m_indexing;
  internal::Seamless_layout<FT> m_layout;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_SEAMLESS_MAP_H
