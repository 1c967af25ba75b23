// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_INTERNAL_RING_CONTROLS_H
#define CGAL_T_SPLINES_T_MESH_INTERNAL_RING_CONTROLS_H

#include <CGAL/T_splines/T_mesh/support/Regular_rings.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <CGAL/number_type_basic.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Which basis functions may act in the faces at extraordinary vertices, and from where: those of the first two rings,
/// each in its own place. The same vertex seen on another way around the surface is none of them.
/// \tparam FT the number type of the surface
template <typename FT>
class Ring_controls {
  using Arrays = T_mesh_arrays<FT>;

public:
  static constexpr int none = -1;

  /// \param rings regular
  template <typename KnotFT>
  Ring_controls(const Arrays& t_mesh, const std::vector<Regular_rings<KnotFT>>& rings)
    : m_index(t_mesh.number_of_faces(), none)
  {
    for (const Regular_rings<KnotFT>& r : rings)
      for (int sector = 0; sector < r.valence(); ++sector) {
        const int h = t_mesh.prev(r.bottom(sector, 0, 0));
        m_index[t_mesh.face(h)] = static_cast<int>(m_sectors.size());
        const Vertex_quarter<FT> quarter{h, false, FT(FT(1) / t_mesh.width(t_mesh.face(h)))};
        m_sectors.push_back({frame_of_quarter(t_mesh, quarter, 0), vertices_around(r, sector)});
      }
  }

  bool is_cone_face(const int face) const { return m_index[face] != none; }

  /// The similarity from the frame of a face at an extraordinary vertex to one with this vertex as origin, in which the
  /// face is the unit square.
  const Similarity_2<FT>& to_unit_square(const int face) const { return m_sectors[m_index[face]].to_unit_square; }

  /// Where a vertex lies in that frame. \param to_vertex from the frame of the face to that of the vertex
  std::pair<FT, FT> place(const int face, const Similarity_2<FT>& to_vertex) const
  {
    const Similarity_2<FT> to_face = to_vertex.inverse();
    return to_unit_square(face)(to_face.u(), to_face.v());
  }

  /// Whether the vertex may act in the face from where it is seen.
  bool contains(const int face, const int vertex, const Similarity_2<FT>& to_vertex) const
  {
    const std::pair<FT, FT> p = place(face, to_vertex);
    const double x = std::round(CGAL::to_double(p.first)), y = std::round(CGAL::to_double(p.second));
    if (!(x >= -1 && x <= 2 && y >= -1 && y <= 2) || !is_close(p.first, x) || !is_close(p.second, y))
      return false;
    return m_sectors[m_index[face]].vertices[index(static_cast<int>(x), static_cast<int>(y))] == vertex;
  }

private:
  // -1 <= x, y <= 2; none at (-1, -1), which another sector sees at (1, 1), and beyond a border.
  using Vertices = std::array<int, 16>;

  struct Sector {
    Similarity_2<FT> to_unit_square;
    Vertices vertices;
  };

  static std::size_t index(const int x, const int y) { return static_cast<std::size_t>(4 * (y + 1) + x + 1); }

  template <typename KnotFT>
  static Vertices vertices_around(const Regular_rings<KnotFT>& rings, const int sector)
  {
    const int n = rings.valence(), before = (sector + n - 1) % n, after = (sector + 1) % n;
    const bool is_first = rings.is_on_border() && sector == 0, is_last = rings.is_on_border() && after == 0;
    Vertices result;
    result.fill(none);
    for (int i = 0; i <= 2; ++i) {
      for (int k = 0; k <= 2; ++k)
        result[index(i, k)] = rings.vertex(sector, i, k);
      if (!is_first)
        result[index(i, -1)] = rings.vertex(before, 1, i);
      if (!is_last)
        result[index(-1, i)] = rings.vertex(after, i, 1);
    }
    return result;
  }

  static bool is_close(const FT& x, const double integer)
  {
    if constexpr (is_exact_number_type<FT>)
      return x == FT(integer);
    else
      return CGAL::abs(FT(x - FT(integer))) <= FT(summed_round_off);
  }

  std::vector<int> m_index; // per face
  std::vector<Sector> m_sectors;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_INTERNAL_RING_CONTROLS_H
