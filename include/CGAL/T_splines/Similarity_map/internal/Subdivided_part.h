// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVIDED_PART_H
#define CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVIDED_PART_H

#include <CGAL/T_splines/Similarity_map/internal/Mirror_pairs.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>

namespace CGAL {
namespace T_splines {
namespace internal {

/// What of an input triangulation, of its intrinsic Delaunay triangulation, the middle one, and of the final one has to
/// be looked at: everything, or of a double what meets the first sheet. Triangles that are images lie on the second one.
///
/// A middle triangle that is no image is covered by final triangles that are none, as pairs are only ever parted.
class Subdivided_part {
  using Index = Triangulation_connectivity::Index;

public:
  /// \param number_of_edges, number_of_faces of the first sheet, of the input
  /// \param middle_pairs, last_pairs of the triangles of a double, else empty
  Subdivided_part(const Index number_of_edges, const Index number_of_faces, const Triangulation_connectivity& middle,
                  const Mirror_pairs& middle_pairs, const Triangulation_connectivity& last,
                  const Mirror_pairs& last_pairs)
    : m_number_of_edges(number_of_edges),
      m_number_of_faces(number_of_faces),
      m_middle(middle),
      m_last(last),
      m_middle_pairs(middle_pairs),
      m_last_pairs(last_pairs)
  {
  }

  /// Whether an edge of the input is on the first sheet.
  bool has_input_edge(const Index e) const { return e < m_number_of_edges; }
  /// Whether `f` is a face of the input on the first sheet; it may be -1, no face.
  bool has_input_face(const Index f) const { return f != Triangulation_connectivity::null && f < m_number_of_faces; }
  bool has_middle_edge(const Index e) const { return !m_middle_pairs.is_image_edge(m_middle, e); }
  bool has_middle_face(const Index f) const { return !m_middle_pairs.is_image(f); }
  bool has_final_edge(const Index e) const { return !m_last_pairs.is_image_edge(m_last, e); }
  bool has_final_face(const Index f) const { return !m_last_pairs.is_image(f); }

private:
  Index m_number_of_edges, m_number_of_faces;
  const Triangulation_connectivity &m_middle, &m_last;
  const Mirror_pairs &m_middle_pairs, &m_last_pairs;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SIMILARITY_MAP_INTERNAL_SUBDIVIDED_PART_H
