// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SUPPORT_REGULAR_RINGS_H
#define CGAL_T_SPLINES_T_MESH_SUPPORT_REGULAR_RINGS_H

#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>
#include <CGAL/T_splines/internal/tolerances.h>

#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The three rings of square faces around an extraordinary vertex (condition A of [CZ17] 4.1.3), on the border the part
/// of them that there is.
///
/// Spoke i is the first direction of quarter number i; on the border there is one more, the second direction of the last
/// quarter. Sector i, between the spokes i and i + 1, has 3 x 3 cells without the outermost one (2, 2), which changes no knot of a vertex
/// of the first two rings; cell (x, y) is the x-th one along spoke i and the y-th one along spoke i + 1. For the same
/// reason T-joints may lie on the outer rim of the third ring, and vertices of the second ring may be extraordinary.
template <typename FT>
class Regular_rings {
  using Arrays = T_mesh_arrays<FT>;

public:
  static constexpr int none = -1;

  /// \param quarters of the vertex, three or more on the border
  Regular_rings(const Arrays& t_mesh, const Vertex_quarters<FT>& quarters)
    : m_t_mesh(t_mesh),
      m_is_on_border(t_mesh.is_border_vertex(t_mesh.target(quarters[0].h)))
  {
    for (const Vertex_quarter<FT>& quarter : quarters) {
      m_sectors.emplace_back();
      if (!t_mesh.is_corner(quarter.h))
        m_bad_face = t_mesh.face(quarter.h);
      else
        walk(t_mesh.next(quarter.h), m_sectors.back());
      if (m_bad_face != none)
        return;
    }
    check_spokes();
  }

  /// A face that is missing in the rings, not square, or does not meet its neighbours edge to edge; `none` if the rings
  /// are regular.
  int bad_face() const { return m_bad_face; }
  bool are_regular() const { return m_bad_face == none; }
  int valence() const { return static_cast<int>(m_sectors.size()); } ///< the number of sectors
  bool is_on_border() const { return m_is_on_border; }               ///< whether the extraordinary vertex is there

  /// The face of a cell.
  int face(const int sector, const int x, const int y) const { return m_t_mesh.face(bottom(sector, x, y)); }

  /// The halfedge of a cell that runs in the direction of spoke number `sector`, on the cell's side of that spoke.
  int bottom(const int sector, const int x, const int y) const { return m_sectors[sector][3 * y + x]; }

  /// The vertex at (x, y) in the frame of a sector, 0 <= x, y <= 2.
  int vertex(const int sector, const int x, const int y) const
  {
    if (x < 2)
      return m_t_mesh.source(bottom(sector, x, y));
    return y < 2 ? m_t_mesh.source(bottom(sector, x, y)) : m_t_mesh.target(bottom(sector, 1, 2));
  }

  /// The vertices whose basis functions act in the face at the extraordinary vertex in a sector: 2 n + 8 of them, the
  /// vertex itself; along the first spoke, on the diagonal, along the second spoke and so on around; and of the second
  /// ring those at (2, -1), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (-1, 2) in the frame of the sector.
  /// \pre the extraordinary vertex is not on the border
  std::vector<int> controls(const int sector) const
  {
    const int n = valence();
    std::vector<int> result{vertex(sector, 0, 0)};
    for (int i = 0; i < n; ++i) {
      result.push_back(vertex((sector + i) % n, 1, 0));
      result.push_back(vertex((sector + i) % n, 1, 1));
    }
    result.push_back(vertex((sector + n - 1) % n, 1, 2));
    for (const auto& p : {std::array<int, 2>{2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}})
      result.push_back(vertex(sector, p[0], p[1]));
    result.push_back(vertex((sector + 1) % n, 2, 1));
    return result;
  }

  /// Those vertices of the second ring that the other sectors do not have.
  std::vector<int> second_ring(const int sector) const
  {
    std::vector<int> result{vertex(sector, 2, 0), vertex(sector, 2, 1), vertex(sector, 2, 2), vertex(sector, 1, 2)};
    if (m_is_on_border && sector + 1 == valence())
      result.push_back(vertex(sector, 0, 2));
    return result;
  }

  /// All vertices of the first two rings, 6 n + 3 of them, as `Corner_patches` orders them: the extraordinary vertex;
  /// the first and the second one along each spoke; then of each sector (1, 1), (2, 1), (1, 2), (2, 2).
  /// \pre the extraordinary vertex is on the border
  std::vector<int> corner_controls() const
  {
    const int n = valence();
    std::vector<int> result{vertex(0, 0, 0)};
    for (int i = 0; i <= n; ++i)
      for (int x = 1; x <= 2; ++x)
        result.push_back(i < n ? vertex(i, x, 0) : vertex(n - 1, 0, x));
    for (int i = 0; i < n; ++i)
      for (const auto& p : {std::array<int, 2>{1, 1}, {2, 1}, {1, 2}, {2, 2}})
        result.push_back(vertex(i, p[0], p[1]));
    return result;
  }

private:
  using Sector = std::array<int, 9>; // bottoms

  void walk(int first, Sector& sector)
  {
    for (int y = 0; y < 3; ++y) {
      int b = first;
      for (int x = 0; x < (y < 2 ? 3 : 2); ++x) {
        sector[3 * y + x] = b;
        if (!is_regular(b, x, y) || (y > 0 && b != above(sector[3 * (y - 1) + x]))) {
          m_bad_face = m_t_mesh.face(b);
          return;
        }
        if (x < (y < 2 ? 2 : 1) && !go(b, m_t_mesh.next(b), b))
          return;
      }
      if (y == 2)
        return;
      const int up = above(first);
      if (m_t_mesh.is_border(up)) {
        m_bad_face = m_t_mesh.face(first);
        return;
      }
      first = up;
    }
  }

  // Sectors meet along the spoke between them, unless the first vertex on it is extraordinary. (The second one may be.)
  void check_spokes()
  {
    for (int i = m_is_on_border ? 1 : 0; i < valence(); ++i)
      for (int x = 0; x < 2; ++x) {
        const int b = bottom(i, x, 0), before = bottom((i + valence() - 1) % valence(), 0, x);
        if (Arrays::opposite(b) != m_t_mesh.prev(before))
          m_bad_face = m_t_mesh.face(b);
      }
  }

  // The bottom of the next cell upwards, if it is regular.
  int above(const int b) const
  {
    return Arrays::opposite(m_t_mesh.first_of_side(m_t_mesh.face(b), (m_t_mesh.side(b) + 2) % 4));
  }

  // From the cell with the bottom b over its right side to the next cell's bottom.
  bool go(const int b, const int right, int& result)
  {
    const int o = Arrays::opposite(right);
    if (m_t_mesh.is_border(o)) {
      m_bad_face = m_t_mesh.face(b);
      return false;
    }
    result = m_t_mesh.next(o);
    return true;
  }

  bool is_regular(const int b, const int x, const int y) const
  {
    const int f = m_t_mesh.face(b), side = m_t_mesh.side(b);
    const auto is_whole = [&](const int s) { return m_t_mesh.is_corner(m_t_mesh.first_of_side(f, (side + s) % 4)); };
    const FT width = m_t_mesh.width(f), height = m_t_mesh.height(f), difference = width - height;
    const FT eps = knot_tolerance_between_faces(width);
    return m_t_mesh.first_of_side(f, side) == b && is_whole(0) && is_whole(3) && (x == 2 || is_whole(1)) &&
           (y == 2 || is_whole(2)) && difference <= eps && -difference <= eps;
  }

  const Arrays& m_t_mesh;
  bool m_is_on_border;
  std::vector<Sector> m_sectors;
  int m_bad_face = none;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SUPPORT_REGULAR_RINGS_H
