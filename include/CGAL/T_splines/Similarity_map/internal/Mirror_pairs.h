// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MIRROR_PAIRS_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MIRROR_PAIRS_H

#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/internal/halfedge_indices.h>

#include <CGAL/assertions.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Which triangles of a double are images of each other, while its edges are flipped.
///
/// A triangle of the first sheet and its image stay a pair as long as what is flipped on one sheet is flipped on the other
/// as well: what holds for one need not be computed for the other. Two triangles of one pair that are flipped with each
/// other, and those flipped with a triangle that has no image, have none from then on: they may lie on both sheets. So
/// a triangle that has an image lies on one sheet, and its index says on which.
///
/// The image of a halfedge runs the other way, in the image of its face.
class Mirror_pairs {
  using Index = Triangulation_connectivity::Index;
  static constexpr Index null = Triangulation_connectivity::null;

public:
  /// No pairs: of a closed triangulation that is no double.
  Mirror_pairs() = default;

  /// \param image_of_face per face, `null` for those of components without second sheet
  /// \param image_of_edge per edge e, the image of the halfedge 2e
  /// \param first_image number of faces that are on no second sheet: the indices of the others are larger
  Mirror_pairs(std::vector<Index> image_of_face, std::vector<Index> image_of_edge, const Index first_image)
    : m_image_of_face(std::move(image_of_face)),
      m_image_of_edge(std::move(image_of_edge)),
      m_first_image(first_image)
  {
  }

  bool is_empty() const { return m_image_of_face.empty(); }

  bool has_image(const Index f) const { return !is_empty() && m_image_of_face[f] != null; }

  /// Whether the face is the second one of a pair.
  bool is_image(const Index f) const { return f >= m_first_image && m_image_of_face[f] != null; }

  /// Whether both faces of an edge are second ones.
  bool is_image_edge(const Triangulation_connectivity& mesh, const Index e) const
  {
    return !is_empty() && is_image(mesh.face(halfedge_of_edge(e))) &&
           is_image(mesh.face(opposite(halfedge_of_edge(e))));
  }

  /// Whether both faces of an edge have images, and are not the images of each other: then the edge has an image, which
  /// can be flipped with it.
  bool has_image_edge(const Triangulation_connectivity& mesh, const Index e) const
  {
    if (is_empty())
      return false;
    const Index f = mesh.face(halfedge_of_edge(e)), g = mesh.face(opposite(halfedge_of_edge(e)));
    return m_image_of_face[f] != null && m_image_of_face[g] != null && m_image_of_face[f] != g;
  }

  /// \pre `has_image(f)`
  Index image_of_face(const Index f) const { return m_image_of_face[f]; }

  /// \pre the face of `h` has an image.
  Index image(const Index h) const
  {
    const Index g = m_image_of_edge[edge_of(h)];
    return is_along_edge(h) ? g : opposite(g);
  }

  /// notes that the edge of `h` and that of `g`, the image of `h`, have been flipped. What was turned counter-clockwise
  /// on both sheets is turned the other way in the mirror: the two sides of the edge have been exchanged.
  void exchange_sides(const Triangulation_connectivity& flipped, const Index h, const Index g)
  {
    const Index k = opposite(g);
    m_image_of_edge[edge_of(h)] = is_along_edge(h) ? k : opposite(k);
    m_image_of_edge[edge_of(k)] = is_along_edge(k) ? h : opposite(h);
    pair(flipped.face(h), flipped.face(k));
    pair(flipped.face(opposite(h)), flipped.face(opposite(k)));
  }

  /// parts the face `f` and its image. \pre `has_image(f)`
  void part(const Index f)
  {
    CGAL_precondition(has_image(f));
    m_image_of_face[m_image_of_face[f]] = null;
    m_image_of_face[f] = null;
  }

private:
  void pair(const Index f, const Index g)
  {
    m_image_of_face[f] = g;
    m_image_of_face[g] = f;
  }

  std::vector<Index> m_image_of_face; // per face: `null` if it has none
  std::vector<Index> m_image_of_edge; // per edge: the image of the even halfedge
  Index m_first_image = std::numeric_limits<Index>::max();
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_MIRROR_PAIRS_H
